// A campaign's tables for a paper.
#pragma once

#include <string>
#include <string_view>

#include "campaign/campaign.h"

namespace flexslip {

// Two tables to \input into a document that loads booktabs and longtable: the tests by category, values with their standard
// errors in matching digits, and the categories as mean (min, max) with suspects left out and counted in.
std::string campaign_latex(const Campaign& campaign);

// Text as LaTeX prints it.
std::string latex_escaped(std::string_view text);

}  // namespace flexslip
