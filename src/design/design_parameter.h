// The numbers of a case that a designer may change.
#pragma once

#include <span>
#include <string_view>

#include "io/quantity.h"

namespace flexslip {

// In this order for good: the samples of a sweep are drawn by it.
enum class DesignParameter {
  mu0,
  amplitude,
  wavelength,
  phase,
  span,
  diameter,
  modulus,
  stiffness,
  travel,
  step,
  height,
  width,
  reference,
  pin_friction
};

struct DesignParameterName {
  DesignParameter parameter;
  std::string_view name;         // "mu0", as in files and on the command line
  Kind kind;                     // of the quantity; a plain number in reduced cases
  std::string_view description;  // "mean friction coefficient"
  std::string_view symbol;       // in the markup of figures (report/plot.h)
  Range range;
  double most;  // [units of the case] the greatest value within the range
};
std::span<const DesignParameterName> design_parameters();

// The name of one of them.
const DesignParameterName& described(DesignParameter parameter);

// Is this a value that it may have?
bool is_within(const DesignParameterName& parameter, double value);

}  // namespace flexslip
