#include "design/design_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "fibre/elastica.h"
#include "io/input_error.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// What it is, and its limits, are those of its key. The travel is the last position of the programme.
DesignParameterName of_key(DesignParameter parameter, std::string_view section, std::string_view name,
                           std::string_view description, std::string_view symbol) {
  const CaseKey* key = case_key(section, name);
  return {parameter, key, key->name, *key->kind, description, symbol, key->range, key->max};
}

std::array<DesignParameterName, 14> parameters_of_designs() {
  using enum DesignParameter;
  std::array all{
      of_key(mu0, "friction", "mu0", "mean friction coefficient", "*μ*_0"),
      of_key(amplitude, "friction", "amplitude", "relative amplitude of friction", "*A*"),
      of_key(wavelength, "friction", "wavelength", "wavelength of friction", "*λ*"),
      of_key(phase, "friction", "phase", "phase of friction", "*φ*"),
      of_key(span, "rig", "span", "support span", "*L*"),
      of_key(diameter, "specimen", "diameter", "diameter of the specimen", "*D*"),
      of_key(modulus, "specimen", "modulus", "flexural modulus", "*E*"),
      of_key(stiffness, "rig", "stiffness", "load-train stiffness", "*k*"),
      of_key(travel, "stage", "program", "stage travel", "*w*_s"),
      of_key(step, "stage", "step", "step of the stage", "*w*_s"),
      of_key(height, "specimen", "height", "height of the specimen", "*h*"),
      of_key(width, "specimen", "width", "width of the specimen", "*b*"),
      of_key(reference, "friction", "reference", "length at which the mean friction holds", "*S*_0"),
      of_key(pin_friction, "rig", "pin_friction", "friction between roller and pin", "*μ*_{pin}"),
  };
  all[static_cast<std::size_t>(mu0)].most = largest_q;  // on the fibre that allows most
  all[static_cast<std::size_t>(travel)].name = "travel";
  all[static_cast<std::size_t>(travel)].range = Range::positive;
  all[static_cast<std::size_t>(step)].range = Range::non_negative;  // 0: all of the curve
  return all;
}

// Does the number decide anything of such a test?
bool counts(const Test& test, DesignParameter parameter) {
  using enum DesignParameter;
  const SpecimenInput& specimen = *test.specimen;
  const bool has_modulus = !test.reduced && !specimen.bending_stiffness;
  switch (parameter) {
    case span:
      return !test.reduced;
    case diameter:
      return has_modulus && !specimen.inner_diameter && !specimen.wall;
    case modulus:
    case height:
    case width:
      return has_modulus;
    case mu0:
      return !test.friction->points && test.friction->model != FrictionModel::rough;
    default:
      return true;
  }
}

// Where it stands in a test; null if there is none.
double* number_in(Test& test, DesignParameter parameter) {
  if (!counts(test, parameter)) return nullptr;
  return number_of(test, *described(parameter).key);
}

std::string words_of_range(const DesignParameterName& parameter) {
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

std::span<const DesignParameterName> design_parameters() {
  static const auto parameters = parameters_of_designs();
  return parameters;
}

const DesignParameterName& described(DesignParameter parameter) {
  return design_parameters()[static_cast<std::size_t>(parameter)];
}

bool is_within(const DesignParameterName& parameter, double value) {
  const double least = parameter.range == Range::any ? -infinity : 0;
  const bool may_be_least = parameter.range == Range::non_negative;
  const bool may_be_infinite = parameter.range == Range::positive_or_infinite;
  return (value > least || (may_be_least && value == least)) && value <= parameter.most &&
         (std::isfinite(value) || may_be_infinite);
}

std::optional<double> value_of(const Test& test, DesignParameter parameter) {
  const double* number = number_in(const_cast<Test&>(test), parameter);  // NOLINT: it is only read
  return number ? std::optional(*number) : std::nullopt;
}

void set(Test& test, DesignParameter parameter, double value) {
  const DesignParameterName& known = described(parameter);
  double* number = number_in(test, parameter);
  if (!number)
    throw InputError({.file = test.source,
                      .field = std::string(known.name),
                      .expected = "a number that the case has and that can be varied",
                      .found = "none"});
  if (!is_within(known, value))
    throw InputError({.field = std::string(known.name),
                      .expected = words_of_range(known),
                      .found = readable(value, kind_in(test, known.kind))});
  *number = value;
}

double value_at(const AxisRange& range, double t) {
  constexpr int halvings = 26;  // of the logarithm of the ratio, to 1e-8 of it: what is left is linear to rounding
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
  return std::clamp((1 - t) * from + t * to, least, most);  // rounding must not carry it beyond its end
}

std::uint64_t points_of(const DesignAxis& axis) {
  const auto* range = std::get_if<AxisRange>(&axis.values);
  return range ? range->points : std::get<AxisValues>(axis.values).size();
}

std::vector<double> values_of(const DesignAxis& axis) {
  std::vector<double> values(points_of(axis));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = grid_value(axis, i);
  return values;
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

}  // namespace flexslip
