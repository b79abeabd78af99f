// The settings of an analysis as flags, for every command that evaluates measured tests.
#pragma once

#include <CLI/CLI.hpp>

#include "case/analysis_choice.h"

namespace flexslip {

// Gives a command the options --model, --false-alarms, --suspect-limit and --check-stability.
void add_analysis_options(CLI::App& command, AnalysisChoice& choice);

}  // namespace flexslip
