// The equilibria of a case, drawn.
#pragma once

#include "case/equilibrium_study.h"
#include "report/figure.h"

namespace flexslip {

// As region_figure, or equilibrium_figure.
Figure figure_of(const EquilibriumStudy& study);

}  // namespace flexslip
