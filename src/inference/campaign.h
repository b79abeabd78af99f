// A campaign of tests: a summary of each test, and the statistics of each category.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "inference/analysis.h"
#include "inference/causes.h"
#include "inference/judgement.h"
#include "inference/population.h"
#include "numerics/elementary.h"

namespace flexslip {

// The parameters of friction that one record determines. Logarithms are of SI values.
struct MeasuredFriction {
  std::optional<Measured> mu0, log_roughness, log_length;
};

// The loss of stiffness measured by a reload.
struct LostStiffness {
  double lost, error;  // [1]
  double needed;       // [1] the loss that its drops require if they are cracks only
};

// The summary of one test. Units: SI.
struct TestSummary {
  std::string name;
  SawtoothCategory category;
  bool suspect = false;           // a finding contradicts the conclusion; means exclude the test
  bool on_assumed_edges = false;  // the supports are not stated and friction depends on them
  ProfileModel model;             // as fitted
  Estimate mu0;                   // [1] mean friction over the observed length
  bool mu0_is_bound;              // friction cannot be distinguished from zero; mu0.high is its upper limit
  Estimate roughness;             // [1] 0 for a model without roughness
  Estimate correlation_length;    // [m] 0 for a model without roughness
  // The most probable wave (4.25), detected or not; empty for a model without waves.
  std::optional<Estimate> amplitude{};   // [1]
  std::optional<Estimate> wavelength{};  // [m]
  std::optional<Estimate> phase{};       // [rad] φ
  bool wave_claimed;
  Estimate bending_stiffness;  // [N m^2] EI
  double residual_rms;         // [N] of the simulated mean of the fit
  std::size_t drops;
  double spacing;  // [m] median length between slips; NaN with fewer than two, or without friction
  double
      friction_share;  // [1] share of friction and snaps in the work of fracture; NaN for a limit or an excluded test
  double friction_share_error = not_a_number;  // [1] standard deviation
  double work_of_fracture;                     // [J]
  // [1] The change of mu0 per standard deviation of load train, span and force calibration, which
  // the tests of a rig share.
  double mu0_by_load_train = 0, mu0_by_span = 0, mu0_by_gain = 0;
  MeasuredFriction measured;
  std::optional<LostStiffness> loss{};  // if the test has a reload
};

// Domain:     analysis.status is ok; std::invalid_argument otherwise.
TestSummary summary_of(const std::string& name, const TestAnalysis& analysis);

// The summary without its friction, which becomes NaN or empty: for an unusable fit, or a specimen
// that lost stiffness.
TestSummary without_friction(TestSummary summary);

// Mean (min, max) of a parameter over the tests that determine it, as the paper reports it.
struct Spread {
  std::size_t count;      // 0: nothing else is valid
  double mean, min, max;  // unit of the parameter
};

struct CategorySpread {
  std::size_t tests;
  Spread mu0;                     // [1] without tests that give only a limit
  Spread mu0_limit{};             // [1] the limits of the tests that give only a limit
  std::size_t waves_claimed = 0;  // among the tests used for amplitude and wavelength
  Spread amplitude;               // [1] over the tests with a sawtooth that have a wave, detected or not
  Spread wavelength;              // [m] over the same tests
};

// One category of tests; empty: all tests.
struct CategorySummary {
  std::optional<SawtoothCategory> category;
  CategorySpread without_suspects, with_suspects;
  // [1], ln of [1], ln of [m]; without suspects. Empty with fewer than min_tests_of_population
  // records that determine the parameter. A negative friction is reported as 0; empty if its whole
  // 95 % interval is negative.
  std::optional<Population> mu0, log_roughness, log_length;
};

// The shares of specimens whose drops are slips only, cracks only, or both.
struct CauseShares {
  std::size_t tests = 0;  // with probabilities; 0: nothing else is valid
  struct Share {
    double median, low, high;  // [1] 95 % lie between low and high
  };
  Share slips{}, cracks{}, both{};
};

// Domain:     entries of NaN are ignored.
// Method:     the likelihood is the product over tests of Σ share × probability, with a uniform
//             prior, on a grid of 1/50.
CauseShares cause_shares(std::span<const Causes> tests);

// [1] The mean friction share of the work over the tests that have one and are not suspect. Its
// interval includes the scatter between specimens and the whole mean error of a test, most of which
// comes from the shared rig. NaN without tests.
Estimate mean_friction_share(std::span<const TestSummary> tests);

// [1] The standard deviation of the mean friction of tests on one rig that more tests do not
// reduce; 0 without tests.
double shared_error_of(std::span<const TestSummary> tests);

// The categories clear, nominal and none, then all tests together.
std::vector<CategorySummary> summarise(std::span<const TestSummary> tests);

}  // namespace flexslip
