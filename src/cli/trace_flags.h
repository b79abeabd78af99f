// Flags that say how a height trace is to be read.
#pragma once

#include <CLI/CLI.hpp>

#include "instruments/trace_words.h"

namespace flexslip {

void add_trace_options(CLI::App& command, TraceWords& words);

}  // namespace flexslip
