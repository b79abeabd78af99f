// Phrases that verdicts, rows and findings share.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "case/fitted.h"
#include "inference/fit.h"

namespace flexslip {

// The number of force drops in the evaluated loading.
std::size_t drops_of(const FittedTest& test);

// True if the friction holds only under the condition that no stiffness was lost. Cracks make
// drops, and cracks too small to detect make the force uneven, as varying friction does. A smooth
// force without drops excludes them.
bool may_have_lost_stiffness(const FittedTest& test);

// "0.47 ± 0.06", or "at most 0.28".
std::string mean_friction(const FrictionFit& fit);

// The share of the stiffness that was lost: "9.1 ± 0.8 %", or the upper limit (95 %) "at most 1.1
// %" if the loss is smaller than its error.
std::string loss_in_words(const PassesFit& passes);

// "12.3 mN": unload to this force so that a reload can measure the loss of stiffness. The specimen
// then slides outwards over half of its sliding length. Empty without a fit, and if the nose lifts
// off before the specimen slides.
std::string unloading_force(const FittedTest& test);

// "cracks only: 2 %", and the probability of slips only if it is reliable. Empty if no drops are
// judged.
std::string causes_in_words(const FittedTest& test);

// "8 to 14 %": the share of the stiffness that the drops took if they are cracks. The lower limit
// excludes what recovers between drops.
std::string loss_by_drops_in_words(const FittedTest& test);

// "rollers of 5 mm": the standard rollers on which the test was fitted in addition.
std::string usual_rollers(const FittedTest& test);

// "0.21 ± 0.05 on rollers of 5 mm", if the supports are not stated and the friction on rollers
// differs from that on knife edges by more than either error, or cannot be determined. Empty
// otherwise.
std::optional<std::string> friction_on_rollers(const FittedTest& test);

}  // namespace flexslip
