// Clauses that findings, verdict and rows have in common, worded once.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "case/fitted.h"
#include "inference/fit.h"

namespace flexslip {

std::size_t drops_of(const FittedTest& test);

// Does its friction hold only if no stiffness was lost? Cracks make drops, and those too small to be seen make a force as rough as friction that varies; a
// force that is smooth hides none.
bool may_have_lost_stiffness(const FittedTest& test);

// "0.47 ± 0.06", or "at most 0.28".
std::string mean_friction(const FrictionFit& fit);

// "9.1 ± 0.8 %", the share of the stiffness that was lost; "at most 1.1 %" (95 %) if it is smaller than its error, "0 %" if it is surely a gain. Of a
// test that was loaded again.
std::string loss_in_words(const PassesFit& passes);

// "12.3 mN", the force to which to unload so that a reload tells what was lost: the specimen slides outwards over half of its way. Empty where it does not
// slide before the nose leaves it, and of a test without an answer.
std::string unloading_force(const FittedTest& test);

// "cracks only: 2 %", and of slips where it can be relied on; empty where no drops are judged.
std::string causes_in_words(const FittedTest& test);

// "8 to 14 %", of the stiffness, what the drops would need if they were cracks: what a hinge gives back as the specimen slides on was not lost.
std::string loss_by_drops_in_words(const FittedTest& test);

// "rollers of 5 mm", as the case could state them; of a test that was fitted on rollers, too.
std::string usual_rollers(const FittedTest& test);

// "0.21 ± 0.05 on rollers of 5 mm", where the supports are not stated and friction there differs from that on edges by more than the error of
// either, or cannot be told there; none where friction does not depend on the supports.
std::optional<std::string> friction_on_rollers(const FittedTest& test);

}  // namespace flexslip
