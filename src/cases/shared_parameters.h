// Parameters that the tests of a campaign share: one value from what all their records say.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/campaign_test.h"

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

// Suspects have no part in it. What the cases state of a stiffness, or their initial slopes say, counts once: it errs in all of them alike.
// Domain:     parameters different; std::invalid_argument otherwise.
// Fails:      InputError if fewer than two records tell one of them.
std::vector<SharedParameter> share_parameters(std::span<const CampaignTest> tests,
                                              const std::vector<Shareable>& parameters);

}  // namespace flexslip
