// The numbers of the bending standards and the way from the file to the record, as `fit` and `modulus` tell them.
#pragma once

#include <optional>
#include <string_view>

#include "case/fitted.h"
#include "case/studies.h"
#include "result/fields.h"

namespace flexslip {

// What is known of a test where only these numbers are asked for.
struct StandardTest {
  const Measurement& measurement;
  const BeamGeometry& geometry;
  const SmallDeflection& numbers;
  SupportsGain supports;
  bool reduced;
};

// The modulus that a standard would publish, less what the supports add. None where they add nothing, and without a section.
std::optional<Estimate> modulus_less_supports(const StandardTest& test);

// Did the specimen break at the last point of the record?
bool is_broken(const StandardTest& test);

// "ok", "no_straight_part", "uncertain", "too_stiff".
std::string_view name_of(SmallDeflectionStatus status);

StandardTest standard_test(const FittedTest& test);
StandardTest standard_test(const ModulusStudy& study);

// The bending stiffness of the straight part over that of the fit.
struct BesideFit {
  double ratio;    // [1]
  bool disagrees;  // the 95 % intervals of the two do not meet
};

// Nothing where one of the two is not known.
std::optional<BesideFit> small_deflection_beside_fit(const FittedTest& test);

Fields<PreparationStep> preparation_fields();

// Of `modulus --json`.
Fields<StandardTest> modulus_fields();
Frame frame_of(const StandardTest& test);

}  // namespace flexslip
