// Figures of a campaign: the distributions of the paper's Fig. 9, and the force curves of all tests, as its Figs. 10 to 13.
#pragma once

#include <vector>

#include "campaign/campaign.h"
#include "report/plot.h"

namespace flexslip {

// Wavelength by test for clear and nominal sawteeth; friction by test for all categories, its wave as a bar, with the means and
// the literature's band. Domain: at least one test has a summary; std::invalid_argument otherwise.
Plot distribution_figure(const Campaign& campaign);

// Pages of at most 20 panels: clear, nominal, none, then the suspect tests once more. A test without curves has no panel.
std::vector<Plot> atlas_pages(const Campaign& campaign);

}  // namespace flexslip
