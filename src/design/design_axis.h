// The numbers of a test that a designer may change, and what they go through in a map or a sweep.
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

// The row of a key (case_keys.h) that can be varied, known by its name.
struct DesignParameter {
  std::string_view name;  // "mu0", as in files and on the command line
  const CaseKey* key;
  std::string_view description;  // "mean friction coefficient"
  std::string_view symbol;       // in the markup of figures (report/plot.h)
  Range range;
  double most;  // [units of the case] the greatest value within the range

  const Kind& kind() const { return *key->kind; }  // of the quantity; a plain number in reduced cases
};

// In this order for good: the samples of a sweep are drawn by it.
std::span<const DesignParameter> design_parameters();

// One of them.
// Domain:     there is one of that name; std::invalid_argument otherwise.
const DesignParameter& design_parameter(std::string_view name);

// Is this a value that it may have?
bool is_within(const DesignParameter& parameter, double value);

// A number of one loading (design_result.h), in SI or reduced, as the test; none if it has no such parameter. A table of friction has no wavelength, a rectangular
// section height and width and no diameter, a reduced test neither span nor modulus. Of friction, mu0 is one with any waves, reference only if it
// is stated (else it is the span, whatever that is), and amplitude, wavelength and phase are those of a single one; tables and rough profiles are
// used as they are. Those of a section count only if the bending stiffness follows from them.
// Domain:     name as design_parameter, here and below.
std::optional<double> value_of(const Test& test, std::string_view name);

// Sets it.
// Fails:      InputError if the test does not have it, or the value is out of its range.
// Whether the numbers go together is told by design_of (design_result.h).
void set(Test& test, std::string_view name, double value);

enum class Spacing { linear, logarithmic };

// From one end to the other, both finite and included; logarithmic ones are positive.
struct AxisRange {
  double from, to;  // SI or reduced, as the case
  Spacing spacing;
  std::uint64_t points;  // of a grid, at least 2; 0 in a Latin hypercube
};

using AxisValues = std::vector<double>;  // at least one; only in a grid

// A parameter of a design that goes through values.
struct DesignAxis {
  DesignParameter parameter;
  std::variant<AxisRange, AxisValues> values;
};

// The value of a range at t in [0, 1]; at 0 and 1 its ends, exactly.
// Max error:  4 ulp if linear, 30 ulp if logarithmic.
// Method:     linear; or halving the ratio of the ends by square roots until it is linear to rounding.
double value_at(const AxisRange& range, double t);

// How many values an axis of a grid has.
std::uint64_t points_of(const DesignAxis& axis);

// The numbers of a row of a grid, one for each axis: SI or reduced, as the case. The last axis changes fastest.
// Domain:     at least one axis, row below the product of their points.
std::vector<double> grid_inputs(const std::vector<DesignAxis>& axes, std::uint64_t row);

// The test with a value for each axis.
// Fails:      as set.
Test with_values(Test test, const std::vector<DesignAxis>& axes, const std::vector<double>& values);

}  // namespace flexslip
