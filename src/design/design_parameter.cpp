#include "design/design_parameter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "case/case_keys.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// A number of a case that has a key of its own: what it is, and its limits, are those of the key.
DesignParameterName of_key(DesignParameter parameter, std::string_view section, std::string_view name,
                           std::string_view description, std::string_view symbol) {
  const CaseKey& key = *case_key(section, name);
  return {parameter, key.name, *key.kind, description, symbol, key.range, key.most};
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
      DesignParameterName{travel, "travel", kind::length, "stage travel", "*w*_s", Range::positive, infinity},
      of_key(step, "stage", "step", "step of the stage", "*w*_s"),
      of_key(height, "specimen", "height", "height of the specimen", "*h*"),
      of_key(width, "specimen", "width", "width of the specimen", "*b*"),
      of_key(reference, "friction", "reference", "length at which the mean friction holds", "*S*_0"),
      of_key(pin_friction, "rig", "pin_friction", "friction between roller and pin", "*μ*_{pin}"),
  };
  all[static_cast<std::size_t>(mu0)].most = largest_q;              // on the fibre that allows most
  all[static_cast<std::size_t>(step)].range = Range::non_negative;  // 0: all of the curve
  return all;
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

}  // namespace flexslip
