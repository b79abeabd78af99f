// Numbers of one test, or of a design, in print, alone and in tables: each in the unit that reads best, or reduced without units.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "io/quantity.h"

namespace flexslip {

// A table for people: every cell as it is printed.
struct PrintedTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

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

// A column of numbers in one unit, which stands in its title.
struct NumberColumn {
  std::string title;
  std::vector<double> values;  // in the units of the test; NaN leaves a cell empty
  Kind kind;
  int digits = 4;  // of the largest
};

// Domain: columns of one length.
PrintedTable printed(const std::vector<NumberColumn>& columns);

std::string counted(std::size_t count, std::string_view one, std::string_view many);

// A share [1] as "12 %".
std::string percent(double share);

// A part of a whole, "0.1 %".
std::string percent_of(double part, double whole);

// To two digits.
std::string roughly(double value, const Kind& kind);

}  // namespace flexslip
