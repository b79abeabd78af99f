#include "case/analysis_fields.h"

namespace flexslip {

Fields<AnalysisOptions> analysis_fields() {
  using O = const AnalysisOptions&;
  return Fields<AnalysisOptions>()
      .words("model", "of friction", [](O options) { return name_of(options.fit.model); })
      .number("false_alarms", "drops to be expected in a test without slips",
              [](O options) { return options.drops.false_alarms_per_test; })
      .number("suspect_limit", "friction above it is implausible", &AnalysisOptions::suspect_limit)
      .yes_no("check_stability", "whether it was asked for", &AnalysisOptions::check_stability);
}

}  // namespace flexslip
