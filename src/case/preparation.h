// The steps that prepare the readings of a file. Every change is listed here.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "case/case_file.h"
#include "io/quantity.h"

namespace flexslip {

struct PreparedValue {
  double value;                 // [SI unit of the kind]
  std::optional<double> error;  // standard deviation, if known
  Kind kind;
};

// A value in the units of a test.
PreparedValue value_in(const Test& test, double value, std::optional<double> error, const Kind& kind);

// Rows of the file, from 1, both included.
struct RowRange {
  std::size_t first, last;
};

struct PreparationStep {
  std::string_view name{};               // one of preparation_steps
  bool changed = false;                  // true if numbers or rows differ from the file
  std::string done{};                    // in words, without a full stop
  std::optional<PreparedValue> value{};  // subtracted, applied or found
  std::optional<RowRange> rows{};        // affected rows; empty: all
  std::optional<KeyChange> otherwise{};  // the key that changes this decision; empty if there is none
};

// The names of the steps in order; the same in every version.
inline constexpr std::array<std::string_view, 21> preparation_steps{
    "columns", "missing",      "metadata",   "sign",     "first", "overload", "repeated",
    "held",    "interpolated", "unloaded",   "thinning", "stray", "holds",    "way_back",
    "spikes",  "zero",         "compliance", "loading",  "end",   "stage",    "contact"};

// The change that writes a word in quotes under [record].
KeyChange switch_to(std::string_view key, std::string_view word);

}  // namespace flexslip
