// A campaign as a workbook for spreadsheet programs.
#pragma once

#include <string>

#include "campaign/campaign.h"

namespace flexslip {

// Sheets Tests, Categories, Failures and, if there are any, Shared: numbers as numbers, in the units that read best, which stand
// in the titles; titles stay in sight.
// Fails:      InputError if it cannot be written.
// Method:     the same campaign gives the same bytes: the date of creation is SOURCE_DATE_EPOCH, or the first that ZIP knows.
void write_campaign_xlsx(const std::string& path, const Campaign& campaign);

}  // namespace flexslip
