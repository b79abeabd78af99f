// What was done to a file before it became the record that is evaluated. Nothing is done that is not listed here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
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

// A key of a case, and what to write there: "find" in quotes, or a number.
struct KeyChange {
  std::string_view section, name;
  std::string value;

  std::string in_case() const;  // "[record] sign = "keep""
  std::string flag() const;     // "--sign "keep"", which says the same
};

struct PreparationStep {
  std::string name;                    // "columns", "sign", "zero", ..., the same in every language and version
  bool changed;                        // the numbers are not as in the file, or rows are left out
  std::string done;                    // in words, a sentence without its full stop
  std::optional<PreparedValue> value;  // taken off, applied or found
  std::optional<RowRange> rows;        // that it is about; none: all
  std::optional<KeyChange> otherwise;  // for having it otherwise; none if nothing would
};

// In the order in which they are done: columns, metadata, sign, thinning, zero, compliance, end, turn, stage, contact.
struct Preparation {
  std::vector<PreparationStep> steps;
};

}  // namespace flexslip
