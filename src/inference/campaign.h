// Many tests together: what each comes to in a line, and what a category of them has in common.
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

// The parameters of friction that one record determines by itself. Logarithms are those of numbers in SI.
struct MeasuredFriction {
  std::optional<Measured> mu0, log_roughness, log_length;
};

// What a reload shows of the stiffness lost in a test.
struct LostStiffness {
  double lost, error;  // [1]
  double needed;       // [1] by its drops, if they were cracks only
};

// A test in a line. Units: SI.
struct TestSummary {
  std::string name;
  SawtoothCategory category;
  bool suspect = false;           // it is left out of means: a finding stands against its conclusion
  bool on_assumed_edges = false;  // its supports are not stated, and friction depends on them
  ProfileModel model;             // that was fitted
  Estimate mu0;                   // [1] mean friction over the fibre seen
  bool mu0_is_bound;              // the record does not tell it from none: mu0.high is its upper limit
  Estimate roughness;             // [1] 0 of a model without
  Estimate correlation_length;    // [m] likewise
  // The likeliest wave, the paper's (4.25), claimed or only indicative; none of a model without.
  std::optional<Estimate> amplitude{};   // [1]
  std::optional<Estimate> wavelength{};  // [m]
  std::optional<Estimate> phase{};       // [rad] φ
  bool wave_claimed;
  Estimate bending_stiffness;  // [N m^2] EI
  double residual_rms;         // [N] of the fit's mean run forward
  std::size_t drops;
  double
      spacing;  // [m] of the specimen, from one slip to the next, median; NaN with fewer than two, and where no friction is told
  double
      friction_share;  // [1] of the measured work of fracture: friction and snaps; NaN of a limit, and of a test not trusted
  double friction_share_error = not_a_number;  // [1] its standard deviation, where it has one
  double work_of_fracture;                     // [J]
  // [1] What a standard deviation of the rig's load train, span and gain, which its tests share, makes mu0 larger by.
  double mu0_by_load_train = 0, mu0_by_span = 0, mu0_by_gain = 0;
  MeasuredFriction measured;
  std::optional<LostStiffness> loss{};  // of a test that was loaded again
};

// Domain:     analysis.status is ok; std::invalid_argument otherwise.
TestSummary summary_of(const std::string& name, const TestAnalysis& analysis);

// Of a test whose fit is not to be used, or whose specimen lost stiffness: NaN or none for all that is friction.
TestSummary without_friction(TestSummary summary);

// Mean (min, max) of a parameter over the tests that tell it, as the paper reports it; those not to be trusted tell nothing.
struct Spread {
  std::size_t count;      // 0: nothing else is valid
  double mean, min, max;  // unit of the parameter
};

struct CategorySpread {
  std::size_t tests;
  Spread mu0;                     // [1] without tests that tell only a limit
  Spread mu0_limit{};             // [1] over those that tell only a limit: the limits
  std::size_t waves_claimed = 0;  // of those that amplitude and wavelength are taken over
  Spread amplitude;   // [1] over the tests of categories with a sawtooth that have a wave, claimed or indicative
  Spread wavelength;  // [m] likewise
};

// A category of tests; none: all tests.
struct CategorySummary {
  std::optional<SawtoothCategory> category;
  CategorySpread without_suspects, with_suspects;
  // [1], ln of [1], ln of [m]; without suspects, and none of fewer than min_tests_of_population records that determine it. Friction is not
  // negative: what is estimated below 0 is 0, and none if all of its 95 % interval lies there.
  std::optional<Population> mu0, log_roughness, log_length;
};

// The shares of specimens whose drops slips made, cracks, or both.
struct CauseShares {
  std::size_t tests = 0;  // with probabilities; 0: nothing else is valid
  struct Share {
    double median, low, high;  // [1] 95 % lie between low and high
  };
  Share slips{}, cracks{}, both{};
};

// Domain:     those that are NaN tell nothing.
// Method:     the likelihood of shares is the product of the sums of share times probability, under a uniform prior; on a grid of a fiftieth.
CauseShares cause_shares(std::span<const Causes> tests);

// [1] The mean share of friction in the work over the tests that tell one and are not suspect. Its interval allows for the scatter between specimens,
// and for the mean error of a test in full: most of it is of the rig, which the tests share. NaN of no such test, and no interval of tests without errors.
Estimate mean_friction_share(std::span<const TestSummary> tests);

// [1] Of the mean friction of tests on one rig, the standard deviation that more of them do not make smaller; 0 without tests that tell any.
double shared_error_of(std::span<const TestSummary> tests);

// The categories clear, nominal and none, then all tests together.
std::vector<CategorySummary> summarise(std::span<const TestSummary> tests);

}  // namespace flexslip
