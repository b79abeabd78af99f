// What the drops of a test and a reload say of its specimen, all weighed together.
#pragma once

#include <algorithm>
#include <vector>

#include "inference/analysis.h"
#include "numerics/elementary.h"

namespace flexslip {

// The mean friction told if a share of the stiffness was lost by the middle of the record: of what is only a limit, that limit.
struct FrictionIfLost {
  double loss, friction;  // [1]
};

// [1] Probabilities of what made the drops. Without a reload, slips cannot be told from slips and cracks, and `slips` and `both` are NaN.
struct Causes {
  double slips = not_a_number, cracks = not_a_number, both = not_a_number;
};

// What a reload shows of the drops of a loading before it.
struct DropsAndLoss {
  double log_loss, error;  // of the stiffness, as -ln of what is left
  double log_needed;       // likewise by the drops, if they were cracks only
  double cracks_alone;     // [1] probability of that by one loading alone; NaN where it tells nothing
};

// Slips, cracks and both being as likely beforehand.
// Domain:     error >= 0, log_needed > 0.
// Method:     multinomial logistic regression on simulated records (bench/reload; docs/theory.md, "A reload").
Causes causes_of(const DropsAndLoss& features);

// [1] How often a reload finds the true cause of drops: that nothing was lost if they were slips only, and the loss that they need if they were
// cracks only.
struct CauseChances {
  double slips, cracks;

  double least() const { return std::min(slips, cracks); }
};

// Domain:     as causes_of; cracks_alone is what one loading of slips tells, and that of cracks is taken to tell nothing.
// Max error:  0.002.
// Method:     the loss told is normally distributed; what the drops need is uncertain besides.
CauseChances chances_of_causes(double log_needed, double error, double cracks_alone);

// Of the loss of a reload, as -ln of what is left: besides its own error, passes of sound specimens differ by 2 %.
double log_loss_error(const PassesFit& passes);

// What may have become of the specimen.
enum class Damage {
  not_told,  // nothing shows it; a reload may show that it is small
  lost,      // stiffness was lost
  settled,   // the specimen or a support gave way for good, and no stiffness was lost
};

struct Judgement {
  CrackVerdict drops;  // by the rises, and by the reload where there is one
  Causes causes;
  Damage damage = Damage::not_told;
  bool drops_are_cracks = false;       // there are some, and they are, and no reload tells more
  bool friction_undetermined = false;  // stiffness was lost, and the friction fitted does not allow for it
  std::size_t impossible = 0;          // drops that cannot be slips
  bool friction_falls =
      false;  // along all that is seen, surely, by a third of its mean or more: as the force of a specimen that cracks would
  // For losses of a tenth and a fifth; none where a reload tells the loss, or of a specimen that lost stiffness.
  std::vector<FrictionIfLost> if_lost{};

  double cracks_alone() const { return causes.cracks; }
};

// Does a loading after the evaluated one tell what was lost?
bool is_reloaded(const TestAnalysis& analysis);

// Does the friction told allow for all that was lost?
bool allows_for_losses(const TestAnalysis& analysis);

// Is the loss beyond its errors, or, negative, the gain? It allows for passes that differ by 2 % for other reasons.
bool is_lost(const PassesFit& passes);
bool is_gained(const PassesFit& passes);
bool is_settled(const PassesFit& passes);

// Does the record contradict the bending stiffness stated, which the verdict on the rises takes for granted (checks.h, stiffness_errors)? A load train
// stated too stiff makes it do that.
bool stiffness_is_off(const TestAnalysis& analysis);

// Of three drops or more half or more that cannot be slips: the load train is not as stated, before anything else.
bool most_are_impossible(std::size_t impossible, std::size_t drops);

// By a reload, causes_of. Without one, where half of three drops or more cannot be slips, or the bending stiffness is off (stiffness_is_off), there is no
// probability, unless it is one of cracks. Drops are not asked about where there are none.
// Domain:     analysis.status is ok; std::invalid_argument otherwise.
Judgement judge(const TestAnalysis& analysis);

}  // namespace flexslip
