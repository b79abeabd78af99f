// The settings of an analysis as flags, for every command that evaluates measured tests.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "case/case_file.h"
#include "inference/analysis.h"

namespace flexslip {

struct AnalysisFlags {
  std::string model;  // its name; empty: as the case says, or roughness
  AnalysisOptions options{};
};

// Gives a command the options --model, --false-alarms, --suspect-limit and --check-stability.
void add_analysis_options(CLI::App& command, AnalysisFlags& flags);

// The options of a test: what the flags say; where they name no model, that which its case names without parameters, for with
// parameters it says how to simulate.
// Fails:      InputError if the case names a model that cannot be fitted.
AnalysisOptions options_for(const Case& input, const AnalysisFlags& flags);

}  // namespace flexslip
