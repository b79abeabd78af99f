// What was done to a file before it became the record that is evaluated. Nothing is done that is not listed here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/quantity.h"

namespace flexslip {

struct PreparedValue {
  double value;                 // [SI unit of the kind]
  std::optional<double> error;  // standard deviation, where it is known
  Kind kind;
};

// Rows of the file, counted from 1, both among them.
struct RowRange {
  std::size_t first, last;
};

struct PreparationStep {
  std::string name;                    // "columns", "sign", "zero", ..., the same in every language and version
  bool changed;                        // the numbers are not as in the file, or rows are left out
  std::string done;                    // in words, a sentence without its full stop
  std::optional<PreparedValue> value;  // taken off, applied or found
  std::optional<RowRange> rows;        // that it is about; none: all
  std::string key;                     // what to write into the case for having it otherwise; empty if nothing would
};

// In the order in which they are done: columns, metadata, sign, thinning, zero, compliance, end, turn, stage, contact.
struct Preparation {
  std::vector<PreparationStep> steps;
};

// The flag that says what a key of a case says: "--sign keep" for `[record] sign = "keep"`; empty for an empty key.
std::string flag_of(const PreparationStep& step);

}  // namespace flexslip
