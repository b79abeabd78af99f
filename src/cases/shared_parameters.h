// Parameters that the tests of a campaign share: estimated from all of them, and then held in each.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cases/campaign_plan.h"
#include "cases/campaign_test.h"

namespace flexslip {

enum class Shareable {
  modulus,            // of tests whose section is known
  bending_stiffness,  // EI
  amplitude,          // of one wave, relative to mu0, over the tests with a sawtooth
  wavelength,         // likewise
};

std::string name_of(Shareable parameter);

// Values at which the fit of a test is held, by the name of the test.
using HeldByTest = std::map<std::string, HeldValues, std::less<>>;

struct SharedFits {
  std::vector<SharedParameter> parameters;  // in the order asked for
  HeldByTest held;
};

// Domain:     threads >= 1.
// Fails:      InputError if fewer than two tests can share a parameter, or no value of it is possible in all of them. Tests
//             that cannot be fitted have no part in it.
// Method:     one parameter after the other, each with those before it held; estimate_shared. What the cases state of the bending
//             stiffness is one statement and counts once; what each record's slope says of it counts each time.
SharedFits share_parameters(const std::vector<PlannedTest>& plan,
                            const std::function<AnalysisOptions(const Case&)>& analysis,
                            const std::vector<Shareable>& parameters, unsigned threads);

}  // namespace flexslip
