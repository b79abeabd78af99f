// The parameters of a test that a designer may vary, and the values that they take in a map or a
// sweep.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "io/quantity.h"

namespace flexslip {

// A key of a case (case_keys.h) that can be varied, identified by its name.
struct DesignParameter {
  std::string_view name;  // "mu0", as in files and on the command line
  const CaseKey* key;
  std::string_view description;  // "mean friction coefficient"
  std::string_view symbol;       // in the markup of plot.h
  Range range;
  double most;  // [units of the case] the maximum of the range

  const Kind& kind() const { return *key->kind; }  // in physical cases; plain numbers in reduced ones
};

// All parameters. The order must not change, because the samples of a sweep depend on it.
std::span<const DesignParameter> design_parameters();

// The parameter of that name.
// Domain:     an existing name; std::invalid_argument otherwise.
const DesignParameter& design_parameter(std::string_view name);

// True if the parameter may take the value.
bool is_within(const DesignParameter& parameter, double value);

// The value of a parameter of one loading (design_result.h), in the units of the test. Empty if the
// test does not have the parameter:
// - A table of friction has no wavelength, and is used unchanged, as is a rough profile.
// - A rectangular section has height and width but no diameter. Dimensions count only if the
//   bending stiffness follows from them.
// - A reduced test has neither span nor modulus.
// - Any waves have mu0; a single wave has amplitude, wavelength and phase. A reference that is not
//   stated is the span, and no parameter.
// Domain:     name as design_parameter, here and below.
std::optional<double> value_of(const Test& test, std::string_view name);

// Sets the value.
// Fails:      throws InputError if the test does not have the parameter, or the value is out of
//             range. design_of (design_result.h) checks combinations.
void set(Test& test, std::string_view name, double value);

enum class Spacing { linear, logarithmic };

// A range with both ends, which are finite; for logarithmic spacing they are positive.
struct AxisRange {
  double from, to;  // SI or reduced, as the case
  Spacing spacing;
  std::uint64_t points;  // of a grid, at least 2; 0 in a Latin hypercube
};

using AxisValues = std::vector<double>;  // at least one; grids only

// A parameter with its values.
struct DesignAxis {
  DesignParameter parameter;
  std::variant<AxisRange, AxisValues> values;
};

// The value of a range at t in [0, 1]; exactly its ends at 0 and 1.
// Max error:  4 ulp if linear, 30 ulp if logarithmic.
// Method:     linear; or the ratio of the ends is halved by square roots until it is linear to
//             rounding.
double value_at(const AxisRange& range, double t);

// The number of values of an axis of a grid.
std::uint64_t points_of(const DesignAxis& axis);

// The values of one row of a grid, one per axis, in the units of the case. The last axis changes
// fastest.
// Domain:     at least one axis, row below the product of their points.
std::vector<double> grid_inputs(const std::vector<DesignAxis>& axes, std::uint64_t row);

// The test with one value per axis.
// Fails:      as set.
Test with_values(Test test, const std::vector<DesignAxis>& axes, const std::vector<double>& values);

}  // namespace flexslip
