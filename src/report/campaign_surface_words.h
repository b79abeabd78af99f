// What surface would explain the friction of many tests, and what would settle it.
#pragma once

#include <string>

#include "campaign/campaign.h"

namespace flexslip {

// One paragraph; empty where no test that counts has a wave that is claimed.
std::string surfaces_in_words(const Campaign& campaign);

}  // namespace flexslip
