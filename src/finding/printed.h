// Numbers in print: with no more digits than their uncertainty leaves them, each in the unit that reads best, or reduced without
// units.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "case/fitted.h"
#include "io/quantity.h"
#include "numerics/statistics.h"

namespace flexslip {

// A number and its standard uncertainty, two digits of the latter.
struct MatchedDigits {
  std::string value;
  std::string error;      // empty if it is not known, or the value is held; it then has four significant digits
  std::string low, high;  // ends of the 95 % interval, likewise
};

// Domain:     factor > 0: from the unit of the estimate to that shown.
MatchedDigits matched_digits(const Estimate& estimate, double factor);

// A number with this many significant digits, trailing zeros among them, without an exponent. Domain: digits >= 1.
std::string format_significant(double value, int digits);

class Print {
 public:
  Print(const Test& test, const Scales& scales) : test_(test), scales_(scales) {}
  explicit Print(const FittedTest& test) : Print(test.measurement.test, test.analysis.scales) {}

  Kind as(const Kind& kind) const { return kind_in(test_, kind); }
  // From reduced variables; "not known" for NaN.
  std::string length(double value) const { return own(scales_.physical_length(value), kind::length); }
  std::string force(double value) const { return own(scales_.physical_force(value), kind::force); }
  std::string energy(double value) const { return own(scales_.physical_energy(value), kind::energy); }
  // Already in the units of the test.
  std::string own(double value, const Kind& kind) const;

 private:
  const Test& test_;
  const Scales& scales_;
};

std::string format_count(std::size_t count, std::string_view one, std::string_view many);

// A share [1] as "12 %".
std::string format_percent(double share);

// To two digits, as many as there are: "0.5 %", "1 %", "626 %".
std::string format_relative(double share);

// A part of a whole, "0.1 %".
std::string format_share(double part, double whole);

// To two digits.
std::string format_roughly(double value, const Kind& kind);

}  // namespace flexslip
