// A height trace, what an edge sees of it, its spectrum, and the friction that it predicts.
#pragma once

#include "case/surface_study.h"
#include "report/plot.h"

namespace flexslip {

Plot surface_figure(const SurfaceStudy& study);

}  // namespace flexslip
