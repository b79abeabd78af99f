// A height trace, what an edge sees of it, its spectrum, and the friction that it predicts.
#pragma once

#include "case/surface_study.h"
#include "report/figure.h"

namespace flexslip {

Figure surface_figure(const SurfaceStudy& study);

}  // namespace flexslip
