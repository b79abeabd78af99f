#include "design/design_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "fibre/elastica.h"
#include "io/input_error.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::string_view mu0 = "mu0", travel = "travel", step = "step";

// travel is the last position of the programme. mu0 is limited by the largest friction that any
// Fibre accepts. A step of 0 gives the continuous curve.
DesignParameter of_key(std::string_view section, std::string_view name, std::string_view description,
                       std::string_view symbol) {
  const CaseKey* key = case_key(section, name);
  if (name == mu0) return {name, key, description, symbol, key->range, largest_q};
  if (name == step) return {name, key, description, symbol, Range::non_negative, key->max};
  if (name == "program") return {travel, key, description, symbol, Range::positive, key->max};
  return {name, key, description, symbol, key->range, key->max};
}

// True if the parameter has an effect on such a test.
bool counts(const Test& test, std::string_view name) {
  const SpecimenInput& specimen = *test.specimen;
  if (name == "span") return !test.reduced;
  if (name == mu0) return !test.friction->points && test.friction->model != FrictionModel::rough;
  if (design_parameter(name).key->section != "specimen") return true;
  const bool is_solid = !specimen.inner_diameter && !specimen.wall;
  return !test.reduced && !specimen.bending_stiffness && (name != "diameter" || is_solid);
}

// The place of the parameter in the test; null if it has none.
double* number_in(Test& test, std::string_view name) {
  return counts(test, name) ? number_of(test, *design_parameter(name).key) : nullptr;
}

std::string words_of_range(const DesignParameter& parameter) {
  if (parameter.range == Range::any) return "a finite number";
  return fmt::format("a number {} 0{}", parameter.range == Range::non_negative ? "of at least" : "above",
                     std::isfinite(parameter.most) ? fmt::format(" and at most {:g}", parameter.most) : "");
}

double grid_value(const DesignAxis& axis, std::uint64_t point) {
  if (const auto* values = std::get_if<AxisValues>(&axis.values)) return (*values)[point];
  const auto& range = std::get<AxisRange>(axis.values);
  return value_at(range, static_cast<double>(point) / static_cast<double>(range.points - 1));
}

}  // namespace

std::span<const DesignParameter> design_parameters() {
  static const std::array parameters{
      of_key("friction", mu0, "mean friction coefficient", "*μ*_0"),
      of_key("friction", "amplitude", "relative amplitude of friction", "*A*"),
      of_key("friction", "wavelength", "wavelength of friction", "*λ*"),
      of_key("friction", "phase", "phase of friction", "*φ*"),
      of_key("rig", "span", "support span", "*L*"),
      of_key("specimen", "diameter", "diameter of the specimen", "*D*"),
      of_key("specimen", "modulus", "flexural modulus", "*E*"),
      of_key("rig", "stiffness", "load-train stiffness", "*k*"),
      of_key("stage", "program", "stage travel", "*w*_s"),
      of_key("stage", step, "step of the stage", "*w*_s"),
      of_key("specimen", "height", "height of the specimen", "*h*"),
      of_key("specimen", "width", "width of the specimen", "*b*"),
      of_key("friction", "reference", "length at which the mean friction holds", "*S*_0"),
      of_key("rig", "pin_friction", "friction between roller and pin", "*μ*_{pin}"),
  };
  return parameters;
}

const DesignParameter& design_parameter(std::string_view name) {
  const auto all = design_parameters();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const DesignParameter& each) { return each.name == name; });
  if (found == all.end()) throw std::invalid_argument(fmt::format("'{}' is no number of a design", name));
  return *found;
}

bool is_within(const DesignParameter& parameter, double value) {
  const double least = parameter.range == Range::any ? -infinity : 0;
  const bool may_be_least = parameter.range == Range::non_negative;
  const bool may_be_infinite = parameter.range == Range::positive_or_infinite;
  return (value > least || (may_be_least && value == least)) && value <= parameter.most &&
         (std::isfinite(value) || may_be_infinite);
}

std::optional<double> value_of(const Test& test, std::string_view name) {
  const double* number = number_in(const_cast<Test&>(test), name);  // NOLINT: only read
  return number ? std::optional(*number) : std::nullopt;
}

void set(Test& test, std::string_view name, double value) {
  double* number = number_in(test, name);
  if (!number)
    throw InputError(
        {.file = test.source, .field = std::string(name), .problem = "The case has no such number that can be varied"});
  if (const DesignParameter& known = design_parameter(name); !is_within(known, value))
    throw InputError(
        {.field = std::string(name),
         .problem = fmt::format("{} is not {}", readable(value, kind_in(test, known.kind())), words_of_range(known))});
  *number = value;
}

double value_at(const AxisRange& range, double t) {
  constexpr int halvings = 26;  // reduces the logarithm of the ratio to 1e-8, linear to rounding
  double from = range.from;
  double to = range.to;
  if (range.spacing == Spacing::logarithmic && t > 0 && t < 1)
    for (int i = 0; i < halvings; ++i) {
      const double middle = std::sqrt(from) * std::sqrt(to);
      t *= 2;
      (t < 1 ? to : from) = middle;
      if (t >= 1) t -= 1;
    }
  const auto [least, most] = std::minmax(range.from, range.to);
  return std::clamp((1 - t) * from + t * to, least, most);  // limits rounding to the ends
}

std::uint64_t points_of(const DesignAxis& axis) {
  const auto* range = std::get_if<AxisRange>(&axis.values);
  return range ? range->points : std::get<AxisValues>(axis.values).size();
}

std::vector<double> grid_inputs(const std::vector<DesignAxis>& axes, std::uint64_t row) {
  std::vector<double> inputs(axes.size());
  for (std::size_t i = inputs.size(); i-- > 0;) {
    const std::uint64_t points = points_of(axes[i]);
    inputs[i] = grid_value(axes[i], row % points);
    row /= points;
  }
  return inputs;
}

Test with_values(Test test, const std::vector<DesignAxis>& axes, const std::vector<double>& values) {
  for (std::size_t i = 0; i < axes.size(); ++i) set(test, axes[i].parameter.name, values.at(i));
  return test;
}

}  // namespace flexslip
