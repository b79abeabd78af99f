// The numbers of the bending standards, in print.
#pragma once

#include <string>
#include <vector>

#include "answers/standard_fields.h"
#include "finding/printed.h"

namespace flexslip {

// Modulus and stress to three significant digits, as ISO 178 wants them. No rows where the record has no straight part.
PrintedTable small_deflection_table(const StandardTest& test);

// Where the numbers come from, what they assume, and where that does not hold.
std::vector<std::string> small_deflection_in_words(const StandardTest& test);

// How the bending stiffness of the straight part compares with that of the fit.
std::string small_deflection_and_fit(const FittedTest& test);

}  // namespace flexslip
