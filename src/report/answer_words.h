// The answer: what a fitted test comes to, in a few sentences, and what stands against it.
#pragma once

#include <string>

#include "case/fitted.h"

namespace flexslip {

// The answer in a sentence or two.
std::string answer_of(const FittedTest& test);

// "0.36 ± 0.02", or "at most 0.22".
std::string mean_friction(const FrictionFit& fit);

// What is to be said before the friction and the energies of a specimen that lost stiffness; else nothing.
std::string caution_of(const FittedTest& test);

}  // namespace flexslip
