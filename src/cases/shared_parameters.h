// Parameters that the tests of a campaign share: estimated from all of them, and then known in each.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "cases/campaign_plan.h"
#include "cases/campaign_test.h"

namespace flexslip {

enum class Shareable {
  modulus,            // of tests whose section is known
  bending_stiffness,  // EI
};

std::string name_of(Shareable parameter);

struct SharedFits {
  std::vector<SharedParameter> parameters;  // in the order asked for
  std::vector<PlannedTest> plan;            // the tests that share a stiffness are told it, with its standard error
};

// What is done when `stop` becomes true is not to be used.
// Domain:     threads >= 1, parameters different, not both modulus and bending_stiffness; std::invalid_argument otherwise.
// Fails:      InputError if fewer than two tests can share a parameter. Tests that cannot be fitted have no part in it.
// Method:     one parameter after the other, those before it known: each test is fitted alone, estimate_shared. What the cases state
//             of a stiffness, or their initial slopes say, counts once: it errs in all of them alike.
SharedFits share_parameters(std::vector<PlannedTest> plan, const std::function<AnalysisOptions(const Case&)>& analysis,
                            const std::vector<Shareable>& parameters, unsigned threads,
                            const std::atomic<bool>* stop = nullptr);

}  // namespace flexslip
