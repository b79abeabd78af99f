// The settings of an analysis as flags, for every command that evaluates measured tests.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cases/case_file.h"
#include "inference/analysis.h"

namespace flexslip {

struct AnalysisFlags {
  std::vector<std::string> models;  // names; none: all
  double false_alarms = DropOptions{}.false_alarms_per_test;
  double suspect_limit = AnalysisOptions{}.suspect_limit;
  std::size_t bootstrap = 0;  // refits; 0: none
};

// Gives a command the options --model, --false-alarms, --suspect-limit and --bootstrap.
void add_analysis_options(CLI::App& command, AnalysisFlags& flags);

// The options of a test: what the flags say; where they name no models, those that its case lists without parameters, for with
// parameters it says how to simulate.
// Fails:      InputError if the case lists a model that cannot be fitted.
AnalysisOptions options_for(const Case& input, const AnalysisFlags& flags);

}  // namespace flexslip
