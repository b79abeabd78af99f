#include "data/scales.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace flexslip {
namespace {

double require_positive(double value, const char* name, const char* unit) {
  if (value > 0 && std::isfinite(value)) return value;
  std::ostringstream message;
  message << name << " = " << value << unit << " is not positive and finite";
  throw std::invalid_argument(message.str());
}

}  // namespace

Scales::Scales(double span, double bending_stiffness)
    : span_(require_positive(span, "span", " m")),
      bending_stiffness_(require_positive(bending_stiffness, "bending stiffness", " N m^2")),
      force_unit_(require_positive(bending_stiffness / span / span, "unit of force EI/L^2", " N")) {
  require_positive(stiffness_unit(), "unit of stiffness EI/L^3", " N/m");
  require_positive(energy_unit(), "unit of energy EI/L", " J");
}

double round_section_moment(double diameter) {
  const double D = require_positive(diameter, "diameter", " m");
  return std::numbers::pi * D * D * D * D / 64;
}

double tubular_section_moment(double diameter, double inner_diameter) {
  const double D = require_positive(diameter, "diameter", " m");
  const double d = require_positive(inner_diameter, "inner diameter", " m");
  const double twice_the_wall = require_positive(D - d, "diameter less inner diameter", " m");
  return std::numbers::pi * twice_the_wall * (D + d) * (D * D + d * d) / 64;
}

double rectangular_section_moment(double width, double height) {
  const double b = require_positive(width, "width", " m");
  const double h = require_positive(height, "height", " m");
  return b * h * h * h / 12;
}

}  // namespace flexslip
