// The numbers of the bending standards and the preparation of the record, as in `fit` and
// `modulus`.
#pragma once

#include <optional>
#include <string_view>

#include "case/fitted.h"
#include "case/studies.h"
#include "result/fields.h"

namespace flexslip {

// The part of a test that these numbers need.
struct StandardTest {
  const Measurement& measurement;
  const BeamGeometry& geometry;
  const SmallDeflection& numbers;
  SupportsGain supports;
  bool reduced;
};

// The modulus of the standards without the effect of the supports. Empty if the supports have no
// effect or the section is unknown.
std::optional<Estimate> modulus_less_supports(const StandardTest& test);

// True if the specimen broke at the last point of the record.
bool is_broken(const StandardTest& test);

// "ok", "no_straight_part", "uncertain", "too_stiff".
std::string_view name_of(SmallDeflectionStatus status);

StandardTest standard_test(const FittedTest& test);
StandardTest standard_test(const ModulusStudy& study);

// The bending stiffness of the linear region compared with the fitted one.
struct StiffnessComparison {
  double ratio;    // [1] linear region / fit
  bool disagrees;  // their 95 % intervals do not overlap
};

// Empty if either is unknown.
std::optional<StiffnessComparison> compare_stiffness(const FittedTest& test);

Fields<PreparationStep> preparation_fields();

// The fields of `modulus --json`.
Fields<StandardTest> modulus_fields();
Frame frame_of(const StandardTest& test);

}  // namespace flexslip
