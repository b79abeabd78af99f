#include "report/campaign_units.h"

#include <utility>
#include <vector>

namespace flexslip {

TableUnit print_unit(double value, const std::string& si_unit) {
  if (si_unit == "1") return {"", 1};
  const Unit si = parse_unit(si_unit);
  for (const Kind* kind : {&kind::length, &kind::pressure, &kind::bending_stiffness})
    if (kind->dimension == si.dimension) return best_unit_of({value}, *kind);
  return {si_unit, 1};
}

CampaignUnits units_of(const Campaign& campaign) {
  std::vector<double> wavelengths, stiffnesses, residuals, works;
  for (const auto& test : campaign.tests) {
    if (!test.summary) continue;
    if (test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
    stiffnesses.push_back(test.summary->bending_stiffness.value);
    residuals.push_back(test.summary->residual_rms);
    works.push_back(test.summary->work_of_fracture);
  }
  return {best_unit_of(std::move(wavelengths), kind::length),
          best_unit_of(std::move(stiffnesses), kind::bending_stiffness),
          best_unit_of(std::move(residuals), kind::force), best_unit_of(std::move(works), kind::energy)};
}

}  // namespace flexslip
