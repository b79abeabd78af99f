#include "report/small_deflection_json.h"

#include <optional>

namespace flexslip {
namespace {

Json number(const std::optional<double>& value, const char* unit, bool reduced) {
  if (!value) return nullptr;
  return {{"value", *value}, {"unit", reduced ? "1" : unit}};
}

Json estimate(const std::optional<double>& value, double relative_error, const char* unit, bool reduced) {
  if (!value) return nullptr;
  return {{"value", *value}, {"standard_error", *value * relative_error}, {"unit", reduced ? "1" : unit}};
}

}  // namespace

Json small_deflection_json(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  const bool reduced = test.reduced;
  if (numbers.status != SmallDeflectionStatus::ok) return {{"status", "no_straight_part"}};
  const double relative = numbers.stiffness.error / numbers.stiffness.value;
  Json chord = nullptr;
  if (numbers.chord) {
    const Chord& found = *numbers.chord;
    const double error = found.stiffness.error / found.stiffness.value;
    chord = {{"strain", {0.0005, 0.0025}},
             {"deflection", {found.deflection_from, found.deflection_to}},
             {"stiffness", estimate(found.stiffness.value, error, "N/m", reduced)},
             {"modulus", estimate(found.modulus, error, "Pa", reduced)}};
  }
  return {{"status", "ok"},
          {"stiffness", estimate(numbers.stiffness.value, relative, "N/m", reduced)},
          {"bending_stiffness", estimate(numbers.bending_stiffness, relative, "N m^2", reduced)},
          {"modulus", estimate(numbers.modulus, relative, "Pa", reduced)},
          {"chord", chord},
          {"window",
           {{"from", numbers.window.from},
            {"up_to", numbers.window.up_to},
            {"of_force", numbers.window_force},
            {"rows", {file_row(test.measurement, numbers.first), last_file_row(test.measurement, numbers.last - 1)}}}},
          {"origin", number(numbers.origin, "m", reduced)},
          {"greatest_force", number(numbers.greatest_force, "N", reduced)},
          {"deflection", number(numbers.deflection, "m", reduced)},
          {"stress", number(numbers.stress, "Pa", reduced)},
          {"strain", number(numbers.strain, "1", reduced)},
          {"deflection_large", numbers.deflection_large},
          {"shear_share", numbers.shear_share ? Json(*numbers.shear_share) : Json()}};
}

Json small_deflection_json(const FittedTest& test) {
  Json out = small_deflection_json(standard_test(test));
  const auto beside = small_deflection_beside_fit(test);
  out["over_fit"] = beside ? Json(beside->ratio) : Json();
  out["disagrees_with_fit"] = beside ? Json(beside->disagrees) : Json();
  return out;
}

}  // namespace flexslip
