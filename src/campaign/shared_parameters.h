// Parameters that the tests of a campaign share: one value from what all their records say.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign.h"

namespace flexslip {

enum class Shareable {
  modulus,             // E, of tests whose section is known
  bending_stiffness,   // EI
  wavelength,          // of one wave, over the tests that claim it
  roughness,           // standard deviation of friction about its mean
  correlation_length,  // of the roughness
  mu0,                 // mean friction
};

std::string name_of(Shareable parameter);

// Of all of them; and those of some, in that order. Names that are none are passed over.
std::vector<std::string> shareable_names();
std::vector<Shareable> shareables_named(const std::vector<std::string>& names);

// Why fewer than two tests of a campaign may tell it.
std::string_view needed_for(Shareable parameter);

// Suspects have no part in it. What the cases state of a stiffness, or their initial slopes say, counts once: it errs in all of them alike.
// Domain:     parameters different; std::invalid_argument otherwise.
// Fails:      the estimate is not a number where fewer than two records tell it.
std::vector<SharedParameter> share_parameters(std::span<const CampaignTest> tests,
                                              const std::vector<Shareable>& parameters);

}  // namespace flexslip
