// Printed numbers: with the digits that their uncertainty leaves, each in the most readable unit,
// or without units if the test is reduced.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "case/fitted.h"
#include "io/quantity.h"
#include "numerics/statistics.h"

namespace flexslip {

// A number and its standard uncertainty, which has two significant digits.
struct MatchedDigits {
  std::string value;
  std::string error;      // empty if it is unknown or zero; the value then has four significant digits
  std::string low, high;  // limits of the 95 % interval; empty without an error
};

// Domain:     factor > 0, from the unit of the estimate to the printed unit.
MatchedDigits matched_digits(const Estimate& estimate, double factor);

// A number with this many significant digits, including trailing zeros, without an exponent. Empty
// if it is not finite.
// Domain:     digits >= 1.
std::string format_significant(double value, int digits);

// Prints the quantities of one test in its units.
class Print {
 public:
  Print(const Test& test, const Scales& scales) : test_(test), scales_(scales) {}
  explicit Print(const FittedTest& test) : Print(test.measurement.test, test.analysis.scales) {}

  Kind as(const Kind& kind) const { return kind_in(test_, kind); }
  // Arguments in reduced variables. NaN is printed as "not known".
  std::string length(double value) const { return own(scales_.physical_length(value), kind::length); }
  std::string force(double value) const { return own(scales_.physical_force(value), kind::force); }
  std::string energy(double value) const { return own(scales_.physical_energy(value), kind::energy); }
  // An argument in the units of the test.
  std::string own(double value, const Kind& kind) const;

 private:
  const Test& test_;
  const Scales& scales_;
};

// "−3 mN" of "-3 mN": a number to read, not to copy into a case.
std::string with_minus(const std::string& number);

// "1 drop", "3 drops"
std::string format_count(std::size_t count, std::string_view one, std::string_view many);

// "12 %", of a share [1].
std::string format_percent(double share);

// A share [1] with at most two significant digits below 10 %: "0.5 %", "1 %", "626 %".
std::string format_relative(double share);

// The ratio of part to whole: "0.1 %". Empty if the whole is not positive.
std::string format_share(double part, double whole);

// A quantity with two significant digits in its most readable unit.
std::string format_roughly(double value, const Kind& kind);

}  // namespace flexslip
