// A campaign as text for a terminal.
#pragma once

#include <string>

#include "campaign/campaign.h"

namespace flexslip {

std::string campaign_text(const Campaign& campaign);

}  // namespace flexslip
