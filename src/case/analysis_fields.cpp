#include "case/analysis_fields.h"

namespace flexslip {

Fields<AnalysisOptions> analysis_fields() {
  using O = const AnalysisOptions&;
  return Fields<AnalysisOptions>()
      .words("model", "friction model", [](O options) { return name_of(options.fit.model); })
      .number("false_alarms", "number of drops expected in a test without slips",
              [](O options) { return options.drops.false_alarms_per_test; })
      .number("suspect_limit", "limit above which friction is implausible", &AnalysisOptions::suspect_limit)
      .yes_no("check_stability", "whether the check of stability was asked for", &AnalysisOptions::check_stability);
}

}  // namespace flexslip
