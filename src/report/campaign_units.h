// The units in which a campaign is printed.
#pragma once

#include <string>

#include "campaign/campaign.h"
#include "result/table.h"

namespace flexslip {

// That of one number in an SI unit, or in "1".
TableUnit print_unit(double value, const std::string& si_unit);

// The units in which the tests of a campaign are printed.
struct CampaignUnits {
  TableUnit wavelength, bending_stiffness, residual, work;
};
CampaignUnits units_of(const Campaign& campaign);

}  // namespace flexslip
