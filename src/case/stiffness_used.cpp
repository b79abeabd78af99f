#include "case/stiffness_used.h"

#include <optional>
#include <variant>

#include <fmt/format.h>

#include "data/names.h"
#include "inference/analysis.h"

namespace flexslip {
namespace {

// What the case says of the bending stiffness, if it says something.
std::optional<BendingStiffnessUsed> stated_stiffness(const Case& input) {
  if (!input.specimen) return std::nullopt;
  const auto& rigidity = input.specimen->rigidity;
  const auto* modulus = std::get_if<Modulus>(&rigidity);
  const StatedStiffness& estimate = modulus ? modulus->estimate : std::get<BendingStiffness>(rigidity).estimate;
  const auto* known = std::get_if<Known>(&estimate);
  if (!known) return std::nullopt;
  const bool has_error = known->uncertainty > 0;
  constexpr double most_error = 0.3;  // beyond it the fit would be that of another specimen
  if (known->uncertainty > most_error * known->value)
    throw wrong_value(input, modulus ? "specimen.modulus" : "specimen.bending_stiffness",
                      "an uncertainty of at most 30 % of the value",
                      fmt::format("{:.0f} %", 100 * known->uncertainty / known->value),
                      "write \"fit\" to find it from the initial slope");
  BendingStiffnessUsed used{known->value, has_error ? known->uncertainty / known->value : usual_stiffness_error,
                            has_error ? StiffnessSource::stated : StiffnessSource::assumed_error};
  if (!modulus) return used;
  if (!input.specimen->section) throw missing(input, "specimen.diameter");
  used.value *= second_moment(*input.specimen->section);
  return used;
}

}  // namespace

std::string_view name_of(StiffnessSource source) {
  return name_in_order<StiffnessSource::mirror>(
      source, {"stated", "stated_without_uncertainty", "initial_slope", "mirror_symmetry"});
}

double span_of(const Case& input) {
  if (!input.rig) throw missing(input, "rig");
  if (!input.rig->span) throw missing(input, "rig.span");
  return *input.rig->span;
}

double load_train_stiffness_of(const Case& input) {
  if (!input.rig) throw missing(input, "rig");
  if (!input.rig->stiffness) throw missing(input, "rig.stiffness");
  return *input.rig->stiffness;
}

double support_compliance_of(const Case& input) {
  return input.rig && input.rig->support_stiffness ? 0.5 / *input.rig->support_stiffness : 0;
}

double rig_stiffness_of(const Case& input) {
  return with_supports(load_train_stiffness_of(input), support_compliance_of(input));
}

bool states_stiffness(const Case& input) { return stated_stiffness(input).has_value(); }

BendingStiffnessUsed bending_stiffness_of(const Case& input) {
  if (const auto stated = stated_stiffness(input)) return *stated;
  if (!input.specimen) throw missing(input, "specimen");
  throw missing(input, std::holds_alternative<Modulus>(input.specimen->rigidity) ? "specimen.modulus"
                                                                                 : "specimen.bending_stiffness");
}

BendingStiffnessUsed bending_stiffness_of(const Case& input, const Measurement& measurement) {
  if (const auto stated = stated_stiffness(input)) return *stated;
  const double span = span_of(input);
  const auto slope = stiffness_from_slope(measurement.record, span);
  if (!slope.found)
    throw InputError({.file = measurement.file,
                      .expected = "a force that rises from contact over at least 5 rows, to find the bending stiffness",
                      .found = "none",
                      .remedy = "write the modulus or bending_stiffness into [specimen]"});
  return {slope.value, slope.relative_error, StiffnessSource::initial_slope};
}

}  // namespace flexslip
