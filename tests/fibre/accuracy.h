// How far the fibre layer is from the 40-digit tables in reference/: measured here once, asserted against the headers by
// the tests of each file, and written to docs/numerics.md by accuracy_test.cpp.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit.h"

namespace flexslip {

// A reference value, hi + lo, good to 32 digits.
struct Digits {
  double hi, lo;
};

constexpr double inf = std::numeric_limits<double>::infinity();  // in states.inc: the slopes at S = 1

// In units of 2^-52 relative. Near the truth value - hi is exact.
inline double error_of(double value, const Digits& truth) {
  if (value == truth.hi && truth.lo == 0) return 0;
  return std::abs((value - truth.hi) - truth.lo) / (unit * std::abs(truth.hi));
}

// The largest error of one quantity in one group of rows, and the row where it is.
struct Worst {
  std::string group, quantity;
  std::string row;
  double error = 0;  // [2^-52]
  int rows = 0;
};

// Keeps the worst of each group and quantity, in the order in which they come.
class Worsts {
 public:
  void add(std::string_view group, std::string_view quantity, double error, const std::string& row);
  const std::vector<Worst>& all() const { return all_; }
  const Worst* find(std::string_view group, std::string_view quantity) const;  // null if there is none
  const Worst& of(std::string_view quantity) const;                            // over all groups

 private:
  std::vector<Worst> all_;
};

std::string row_name(const char* first, double a, const char* second, double b);

// What the AGM's closed forms keep of S - 1, and what the integrals P and R keep (elliptic.h).
struct LostDigits {
  double excess;   // S - 1
  double agm;      // worst relative error of S - 1 over the u nearby, [2^-52]
  double program;  // the same with P and R
};

Worsts measured_elliptic();             // elliptic_test.cpp
std::vector<LostDigits> digits_of_S();  // elliptic_test.cpp
Worsts measured_states();               // elastica_test.cpp

}  // namespace flexslip
