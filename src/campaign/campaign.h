// One test of a campaign in the form that the campaign stores. Tables, figures and pages need
// nothing else, whether the test was computed in this run or an earlier one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bending_test/equilibrium.h"
#include "case/fitted.h"
#include "data/literature_friction.h"
#include "fibre/supported_state.h"
#include "inference/campaign.h"

namespace flexslip {

// The curves of a test for figures, from contact to failure. Units: SI; in a reduced test all
// scales are 1.
struct CampaignCurves {
  double span;                                   // [m]
  double bending_stiffness;                      // [N m^2] nominal
  double load_train_stiffness;                   // [N/m]
  Supports supports;                             // [span]
  std::vector<double> stage, deflection, force;  // [m], [m], [N] measured
  // [m], [N] the simulated best-fit profile, with snaps
  std::vector<double> model_deflection, model_force;
  std::vector<std::size_t> drops;  // the last measured row before each drop
};

// The numbers of a bending standard, and the possible effect of friction at the supports.
struct StandardSummary {
  Estimate modulus;                      // [Pa] of the chord, or else of the linear region
  double strength;                       // [Pa] stress at the maximum force; NaN if the specimen did not break
  std::optional<FrictionGain> friction;  // as in SupportsGain
};

struct CampaignTest {
  std::string name;
  // as status_of; or "failed", when only name, file and reason are valid
  std::string status;
  std::string reason;                    // empty if the status is "ok"
  std::string file;                      // the case, data file or line of a table with the test
  std::string verdict;                   // one word: "SLIP"
  Causes causes;                         // of the drops; NaN without drops
  std::optional<TestSummary> summary;    // empty without a fit
  std::optional<CampaignCurves> curves;  // empty without a fit
  std::vector<std::string> remarks;      // remarks for readers of the table
  std::optional<Materials> materials{};  // of specimen and supports; empty unless both are stated
  // empty unless span and section are known and the record determines a modulus
  std::optional<StandardSummary> standard{};
};

// True if the verdict answers whether the drops are slips or cracks.
bool is_answered(const CampaignTest& test);

// False for a specimen that cracked, and without an answer.
bool determines_friction(const CampaignTest& test);

// True if the friction is determined but left out of the means.
bool is_excluded(const CampaignTest& test);

// The frictionless curve (deflection and force in SI) of a specimen of some bending stiffness
// [N m^2] on the supports of the test. It starts at zero and includes the maximum deflection of the
// test. Empty if the specimen was not bent.
std::vector<EquilibriumPoint> frictionless_curve(const CampaignCurves& curves, double bending_stiffness);

// The summary and curves of a test.
CampaignTest campaign_test_of(const FittedTest& test, const std::string& file);

// A test without an answer, with the reason.
CampaignTest failed_test(const std::string& name, const std::string& file, const std::string& reason);

struct Campaign {
  std::vector<CampaignTest> tests;  // in the order of the plan
  std::vector<CategorySummary> categories;
  CauseShares causes{};
  double shared_error = 0;  // [1] error of the mean friction that all tests on the rig share
  // [1] mean friction share of the work
  Estimate friction_share = normal_estimate(not_a_number, not_a_number);
  std::vector<std::string> notes;  // of the plan: omitted files, duplicate records
};

}  // namespace flexslip
