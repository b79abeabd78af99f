// The conclusion about the specimen of a test, from its drops and a reload.
#pragma once

#include <vector>

#include "inference/analysis.h"
#include "inference/causes.h"
#include "numerics/elementary.h"

namespace flexslip {

// The mean friction, or its limit, if this share of the stiffness was lost by the middle of the
// record.
struct FrictionIfLost {
  double loss, friction;  // [1]
};

// The conclusion about the specimen.
enum class Conclusion {
  no_drops,          // no force drop, and no measured loss of stiffness
  slips,             // it slipped; without a reload, it may also have lost stiffness
  cracks,            // it lost stiffness; some of the drops may be slips
  slips_and_damage,  // it slipped and lost stiffness, by a reload
  settled,           // it or a support moved permanently and lost no stiffness, by a reload
  undecided,
};

struct Judgement {
  Conclusion conclusion = Conclusion::undecided;
  Causes causes{};                   // of the judged drops; NaN without any
  bool determines_friction = false;  // there is a fit, and it accounts for all losses of stiffness
  bool friction_falls = false;       // certainly, by a third of its mean or more, as if the specimen cracked
  // For losses of 10 % and 20 %; empty if a reload measures the loss, and without friction.
  std::vector<FrictionIfLost> if_lost{};
};

// The error of the loss of a reload, as -ln of the remaining stiffness. It includes the 2 % by
// which passes of sound specimens differ.
double log_loss_error(const PassesFit& passes);

// True if stiffness was lost before the evaluated loading and no reload measures the loss during
// it.
bool lost_before(const TestAnalysis& analysis);

// True if the force decreases by a tenth without drops at a deflection too small for sliding.
bool sinks(const TestAnalysis& analysis);

// True if a later loading measures the loss of stiffness.
bool is_reloaded(const TestAnalysis& analysis);

// True if the friction accounts for all losses of stiffness.
bool allows_for_losses(const TestAnalysis& analysis);

// True if the record determines how friction varies along the specimen.
inline bool determines_variation(const FrictionFit& fit) { return !fit.mu0_is_bound || fit.wave_claimed; }

// True if the loss, or the gain, exceeds its error, which includes the 2 % by which passes of sound
// specimens differ.
bool is_lost(const PassesFit& passes);
bool is_gained(const PassesFit& passes);
bool is_settled(const PassesFit& passes);

// Domain:     an analysis of any status.
Judgement judge(const TestAnalysis& analysis);

}  // namespace flexslip
