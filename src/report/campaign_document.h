// What a campaign says: made once for the terminal, the page and the paper.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "report/document.h"

namespace flexslip {

// How many tests, with what verdicts, what friction, what share of the work, what is suspect and what failed.
std::string campaign_in_short(const Campaign& campaign);

// An estimate in print, "0.519 (0.40 to 0.64)" or "0.519 ± 0.060", in a unit that is `factor` of its own.
using WriteEstimate = std::string(const Estimate& estimate, double factor);
WriteEstimate with_interval, with_error;

// All of it: test by test, by category, between specimens, what tests share, what failed, what surface would explain it, the force curves, what the
// columns say. The estimates of the tests are written so; links lead to the reports of the tests with an answer, in their order, if they are given.
std::vector<Chapter> document_of(const Campaign& campaign, WriteEstimate* written,
                                 const std::vector<std::string>& links = {});

// For a terminal.
std::string campaign_text(const Campaign& campaign);

// What the literature gives for the materials, if all tests state the same ones.
std::optional<LiteratureFriction> literature_of(const Campaign& campaign);

}  // namespace flexslip
