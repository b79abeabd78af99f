// Numbers in print with no more digits than their uncertainty leaves them.
#pragma once

#include <string>

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
std::string significant(double value, int digits);

}  // namespace flexslip
