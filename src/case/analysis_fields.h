// The options of an analysis, described once: what a report tells of them, and what an answer that is kept depends on.
#pragma once

#include "inference/analysis.h"
#include "result/fields.h"

namespace flexslip {

Fields<AnalysisOptions> analysis_fields();

}  // namespace flexslip
