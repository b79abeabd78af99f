// One test of a campaign as the campaign keeps it: what its table, figures and pages are made of, whether it was computed just
// now or in a run before.
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

// The curves of a test for a figure. Units: SI; in a reduced test all scales are 1. From the contact to the failure.
struct CampaignCurves {
  double span;                                   // [m]
  double bending_stiffness;                      // [N m^2] nominal
  double load_train_stiffness;                   // [N/m]
  Supports supports;                             // [span]
  std::vector<double> stage, deflection, force;  // [m], [m], [N] measured
  std::vector<double> model_deflection,
      model_force;                 // [m], [N] the mean of the fit at the stage positions, snaps included
  std::vector<std::size_t> drops;  // rows of the measured columns before a drop
};

// What a bending standard reads off a record, and what friction at the supports can have done to it.
struct StandardSummary {
  Estimate modulus;                      // [Pa] of the chord, or else of the straight part
  double strength;                       // [Pa] stress at the greatest force
  std::optional<FrictionGain> friction;  // as SupportsGain has it
};

struct CampaignTest {
  std::string name;
  std::string status;                         // as status_of, or "failed": then only name, file and reason are valid
  std::string reason;                         // why the status is not "ok"; empty if it is
  std::string file;                           // case, data file or line of a table that describes the test
  std::string verdict;                        // in one word: "SLIP"
  Causes causes;                              // of its drops; NaN of none
  std::optional<TestSummary> summary;         // where the analysis came to a fit
  std::optional<CampaignCurves> curves;       // likewise
  std::vector<std::string> remarks;           // what a reader of the table should know of it
  std::optional<Materials> materials{};       // in contact, if its case states both
  std::optional<StandardSummary> standard{};  // where span and section are known, and the record tells a modulus
};

// Is the question about its drops answered?
bool is_answered(const CampaignTest& test);

// The curve without friction of a specimen of some bending stiffness [N m^2] on the supports of the test, from the straight specimen to its greatest
// deflection or beyond: deflection and force in SI. Empty if it was not bent.
std::vector<EquilibriumPoint> frictionless_curve(const CampaignCurves& curves, double bending_stiffness);

// The test in a line and in curves.
CampaignTest campaign_test_of(const FittedTest& test, const std::string& file);

// A test that gave no answer, and why.
CampaignTest failed_test(const std::string& name, const std::string& file, const std::string& reason);

struct Campaign {
  std::vector<CampaignTest> tests;  // in the order of the plan
  std::vector<CategorySummary> categories;
  CauseShares causes{};
  double shared_error = 0;  // [1] of mean friction, from the rig that tests share
  Estimate friction_share = normal_estimate(not_a_number, not_a_number);  // [1] of the work, in the mean
  std::vector<std::string> notes;  // of its plan: what was left out or counts once
};

}  // namespace flexslip
