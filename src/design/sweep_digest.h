// Which sweep it is: parts of different ones are not joined.
#pragma once

#include <string>

#include "design/sweep_plan.h"

namespace flexslip {

// Of all that the numbers of a sweep follow from, as 64 hexadecimal digits: the case with the content of its files, the axes,
// the version of the program; and of some of the numbers, which tell programs of one version apart that compute others.
// Comments, layout and file names are not in it.
// Fails:      InputError if a file of the case cannot be read.
// Cost:       that of a few designs.
std::string digest_of_sweep(const SweepPlan& plan);

// The same for outcomes that are computed so.
std::string digest_of_sweep(const SweepPlan& plan, const RowFunction& outcomes_of);

}  // namespace flexslip
