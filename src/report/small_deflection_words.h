// The numbers of the bending standards, in print.
#pragma once

#include <string>
#include <vector>

#include "cases/fitted_test.h"
#include "report/printed.h"

namespace flexslip {

// What is known of a test where only these numbers are asked for.
struct StandardTest {
  const Measurement& measurement;
  const BeamGeometry& geometry;
  const SmallDeflection& numbers;
  bool reduced;
};

StandardTest standard_test(const FittedTest& test);

// Modulus and stress to three significant digits, as ISO 178 wants them. No rows where the record has no straight part.
PrintedTable small_deflection_table(const StandardTest& test);

// Where the numbers come from, what they assume, and where that does not hold.
std::vector<std::string> small_deflection_in_words(const StandardTest& test);

// The bending stiffness of the straight part over that of the fit.
struct BesideFit {
  double ratio;    // [1]
  bool disagrees;  // the 95 % intervals of the two do not meet
};

// Nothing where one of the two is not known.
std::optional<BesideFit> small_deflection_beside_fit(const FittedTest& test);

// That in a sentence.
std::string small_deflection_and_fit(const FittedTest& test);

}  // namespace flexslip
