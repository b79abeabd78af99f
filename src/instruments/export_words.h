// What a user decides about an export, in words: those of a flag on the command line, or of an argument in Python.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "instruments/export.h"

namespace flexslip {

// Empty where nothing is said.
struct ExportWords {
  std::string sheet;                                    // of a workbook, its name, or its number in words
  std::size_t sheet_number = 0;                         // its number; 0 if it is not said
  std::string encoding, separator, decimal, thousands;  // marks as mark_named takes them
  std::string time, crosshead, deflection, force;       // names or numbers of columns
  std::string displacement;                             // "crosshead" or "deflection"
  std::string time_unit, displacement_unit, force_unit, calibration{};  // "222 N/V"
};

// Fails:      InputError that names the flag.
ExportOptions options_of(const ExportWords& words);

// "," or "comma", "none": a mark as the user wrote it.
// Fails:      InputError that names the flag.
char mark_named(const std::string& text, std::string_view flag);
// The same of some alone.
char mark_of(const std::string& text, std::string_view flag, std::string_view allowed);

}  // namespace flexslip
