// What a user decides about a height trace, in words: those of a flag on the command line, or of an argument in Python.
#pragma once

#include <cstddef>
#include <string>

#include "instruments/trace_file.h"

namespace flexslip {

// Empty where nothing is said.
struct TraceWords {
  std::string position, height, position_unit, height_unit, step;
  std::string sheet;             // of a workbook, its name, or its number in words
  std::size_t sheet_number = 0;  // its number; 0 if it is not said
  std::string encoding, separator, decimal, thousands{};
};

// Fails:      InputError that names the flag.
TraceOptions options_of(const TraceWords& words);

}  // namespace flexslip
