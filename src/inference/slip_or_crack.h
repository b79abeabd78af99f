// Can the drops of a sawtooth be cracks alone?
//
// A drop by slip and a drop by a loss of stiffness both run along the load line, and both move the deflection. What differs is how the force
// rises between drops: a cracked fibre goes on as the same fibre, less stiff; one that slips goes on where friction lets it. So the rows of
// each rise are explained both ways, with errors of the force that are AR(1), and bending stiffness known to 5 %:
//   cracks   F = e_j Ψ_F(w; μ(S)), e_j never rising from rise to rise; or with μ constant; or with e falling within a rise as well
//   slip     F = e Ψ_F(w; a_j + b_j (S - S̄_j)), b_j about one b; or with e less at each drop
// judged by BIC; friction of cracks varies slowly. And the apparent stiffness F/Ψ_F(w; μ) falls at each drop: a specimen that slips gives it back
// in the rises, one that cracks does not. Rises of slips are steep, which cracks alone explain by much friction. From all three together follows
// how probably cracks alone made the drops. What no single loading tells is slip alone from slip with some loss of stiffness: for that, unload and
// load again.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "bending_test/rig.h"
#include "data/drops.h"
#include "data/record.h"
#include "numerics/elementary.h"

namespace flexslip {

enum class CrackVerdict {
  not_by_cracks_alone,  // the probability that cracks alone made the drops is below 5 %
  cracks,               // it is above 95 %
  cannot_be_told,       // neither, or there is none
};

std::string_view name_of(CrackVerdict verdict);

// Of a probability that cracks alone made the drops; NaN: cannot be told.
CrackVerdict verdict_of(double cracks_alone);

// A way to explain the rows of all rises.
struct RiseExplanation {
  double bic;   // Bayes' information criterion
  double left;  // [1] of the bending stiffness after the last drop, over that before the first
};

// What tells slips from cracks.
struct RiseFeatures {
  std::size_t rises;  // that are judged
  double
      given_back;  // [1] of what the drops take off the logarithm of the apparent stiffness, the rises give back so much; -1 to 2
  double friction_needed;  // [1] by cracks alone, if constant; 0 to 1.3
  double margin;           // D*: BIC of the best of the cracks less that of the best of the slips
  double loss_margin;      // BIC of slips less that of slips with a loss at each drop
};

// That cracks alone made the drops, slips and cracks being as likely beforehand.
// Domain:     finite features. The higher given_back, friction_needed and margin, the less probable; the higher loss_margin, the more; the more rises, the surer.
// Method:     logistic regression on simulated tests (tools/calibrate-verdict; docs/theory.md, "Slip or crack").
double cracks_alone(const RiseFeatures& features);

struct SlipOrCrack {
  bool judged;  // three rises of three rows or more after drops: nothing below is valid otherwise
  CrackVerdict verdict = CrackVerdict::cannot_be_told;
  double cracks_alone = not_a_number;  // [1] probability; NaN outside of what it was calibrated for
  RiseFeatures features;
  RiseExplanation cracks_constant, cracks, cracks_running;  // F0, F, G
  RiseExplanation slip, slip_and_cracks;                    // S, B
};

// Domain:     a faultless record of one loading; drops = those found in it, in order; rig.stiffness > 0.
// Method:     Nelder and Mead (NLopt) over two to eight numbers; levels in closed form, those of the cracks by pooling adjacent violators.
//             Rows with a deflection between 0.06 and 0.43, of the first and the last rise at most 15.
// Cost:       13 ms for 200 rows.
SlipOrCrack slip_or_crack(const ReducedRecord& record, const Rig& rig, std::span<const Drop> drops);

}  // namespace flexslip
