// Which analysis a measured test is given: as a call says, or else its case.
#pragma once

#include <string>
#include <vector>

#include "case/case_file.h"
#include "inference/analysis.h"

namespace flexslip {

struct AnalysisChoice {
  std::string model;  // its name; empty: as the case says, or roughness
  AnalysisOptions options{};
};

// Of the models that can be fitted.
std::vector<std::string> model_names();

// The options of a test: what the call says, and the friction that the supports of its case let act; where it names no model, that which its case names without parameters, for with
// parameters it says how to simulate.
// Fails:      InputError if the case names a model that cannot be fitted.
AnalysisOptions options_for(const Case& input, const AnalysisChoice& choice);

}  // namespace flexslip
