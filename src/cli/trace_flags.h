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

}  // namespace flexslip
