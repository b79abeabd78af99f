// A campaign as text for a terminal.
#pragma once

#include <string>

#include "cases/campaign_test.h"

namespace flexslip {

std::string campaign_text(const Campaign& campaign);

}  // namespace flexslip
