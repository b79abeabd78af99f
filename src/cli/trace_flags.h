// Flags that say how a height trace is to be read.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "instruments/trace_file.h"

namespace flexslip {

struct TraceFlags {
  std::string position, height, position_unit, height_unit, step;
  std::string sheet, encoding, separator, decimal, thousands;
};

void add_trace_options(CLI::App& command, TraceFlags& flags);

// Fails:      InputError that names the flag.
TraceOptions options_of(const TraceFlags& flags);

// "," or "comma", "none": a mark as the user wrote it.
// Fails:      InputError that names the flag.
char mark_named(const std::string& text, std::string_view flag);
// The same of some alone.
char mark_of(const std::string& text, std::string_view flag, std::string_view allowed);

}  // namespace flexslip
