#include "report/equilibrium_figure.h"

#include "report/model_figures.h"

namespace flexslip {

Figure figure_of(const EquilibriumStudy& study) {
  const DrawnIn units{study.scales, study.reduced, study.in_inches};
  return study.region ? region_figure(study.friction, study.fibre, study.longest, units)
                      : equilibrium_figure(study.friction, study.fibre, study.longest, units);
}

}  // namespace flexslip
