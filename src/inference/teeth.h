// Stick or slide between the drops of a sawtooth: on each rise, the slope of the force between that of a fibre stuck on its
// supports and that of one sliding over them.
//
// While the stage moves by d(stage), w_S dS + w_q dq + (F_S dS + F_q dq)/k = G_S dS + G_q dq. The slope of the force is so the mean
//     dF/d(stage) = (1 - p) F_S/G_S + p F_q/G_q,   1 - p = G_S dS/d(stage),
// of that at constant friction and that at constant S. The position p is 1 where the fibre sticks, 0 where it slides with friction
// constant, between them where it slides while friction rises, below 0 where friction falls; 1 - p is the share of the stage's
// motion that draws fibre in. Static-kinetic stick-slip says p = 1 on every rise; sliding over rough ground says p < 1.
// A stuck fibre on supports that give way by C times the tangential force, dS = C d(q Pn), has p < 1 as well, but with one C for all teeth.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "bending_test/rig.h"
#include "data/drops.h"
#include "data/record.h"
#include "inference/profile.h"
#include "numerics/statistics.h"

namespace flexslip {

struct ToothOptions {
  // [1] a fibre counts as stuck if less of the stage's motion than this draws fibre in. Empirical: on the first six rows after a
  // reversal, where a fibre must stick, the authors' cyclic tests show 0.08 to 0.35 (supports and load train give way); on rigid
  // supports 0.1 is safe.
  double min_share = 0.35;
};

inline constexpr double tooth_confidence = 0.95;  // [1] of each verdict, one-sided

enum class ToothVerdict {
  sliding,      // that it is stuck, 1 - p <= min_share, is rejected
  as_if_stuck,  // that it draws in min_share or more is rejected: stuck, or sliding where friction rises steeply
  undecided,    // neither
};

std::string_view name_of(ToothVerdict verdict);

struct Tooth {
  std::size_t first, last;     // rows [first, last) of the record: from the end of a drop to the begin of the next
  double S_begin, S_end;       // [L] at rows first and last - 1; NaN where no friction explains the row
  Estimate slope;              // [EI/L^3] dF/d(stage), mean of the rise
  Estimate position;           // [1] p, its error from scatter
  double position_systematic;  // [1] from EI, contact and load train together: common to all teeth of a test
  ToothVerdict verdict = ToothVerdict::undecided;
  double compliant_position = not_a_number;  // [1] p of a stuck fibre on supports of the compliance fitted; NaN without
};

// NaN of fewer than two teeth, and where no positive compliance describes any.
struct SupportCompliance {
  // [L^3/EI] C, both supports together, from scatter; in um/mN: times L^3/EI in [m/N], times 1000
  Estimate estimate = normal_estimate(not_a_number, not_a_number);
  double p_value = not_a_number;  // [1] of slopes that scatter so much about it, if the fibre were stuck on each tooth

  bool is_found() const { return std::isfinite(estimate.value); }
};

struct Teeth {
  std::vector<Tooth> teeth;   // the rises whose middle a friction explains
  std::size_t too_short = 0;  // rises of fewer than four rows
  SupportCompliance compliance;
};

// Domain:  a faultless record of one loading; drops = those found in it, in order; rig.stiffness > 0 and finite (without a load train
//          no snap is seen); 0 < min_share < 1, errors >= 0; std::invalid_argument otherwise.
// Max error: on rigid supports wrong verdicts are no more frequent than 1 - tooth_confidence where the force errs by Gaussian noise,
//          white or AR(1) up to 0.5 (tests/inference/teeth_test.cpp, min_share = 0.1). Supports that give way by more than
//          min_share, and slips within a rise too small to be found as drops, look like sliding: compare the compliance with
//          that of a reversal on the same rig.
// Method:  force regressed on the stage, which is imposed and free of noise; the standard error is that of the rise's own residuals,
//          allowing for AR(1), and not below that of errors.force; Student's t. A curved rise errs on the side of undecided. Systematic
//          errors by shifting EI, contact and load train (0.3 % of its stiffness) by one standard deviation each.
//          One compliance by weighted least squares.
// Cost:    40 µs a tooth.
Teeth judge_teeth(const ReducedRecord& record, const Rig& rig, const MeasurementErrors& errors,
                  std::span<const Drop> drops, const ToothOptions& options = {});

}  // namespace flexslip
