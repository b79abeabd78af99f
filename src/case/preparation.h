// What is done to the readings of a file before they are evaluated, step by step: nothing that is not listed here.
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
  std::optional<double> error;  // standard deviation, where it is known
  Kind kind;
};

// A value in the units of a test.
PreparedValue value_in(const Test& test, double value, std::optional<double> error, const Kind& kind);

// Rows of the file, counted from 1, both among them.
struct RowRange {
  std::size_t first, last;
};

struct PreparationStep {
  std::string_view name{};               // one of preparation_steps
  bool changed = false;                  // the numbers are not as in the file, or rows are left out
  std::string done{};                    // in words, a sentence without its full stop
  std::optional<PreparedValue> value{};  // taken off, applied or found
  std::optional<RowRange> rows{};        // that it is about; none: all
  std::optional<KeyChange> otherwise{};  // for having it otherwise; none if nothing would
};

// Their names, in the order in which they are done; the same in every language and version.
inline constexpr std::array<std::string_view, 21> preparation_steps{
    "columns", "missing",      "metadata",   "sign",     "first", "overload", "repeated",
    "held",    "interpolated", "unloaded",   "thinning", "stray", "holds",    "way_back",
    "spikes",  "zero",         "compliance", "loading",  "end",   "stage",    "contact"};

// The change that writes a word in quotes under [record].
KeyChange switch_to(std::string_view key, std::string_view word);

}  // namespace flexslip
