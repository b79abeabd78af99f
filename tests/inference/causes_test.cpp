#include "inference/causes.h"

#include <cmath>

#include <doctest/doctest.h>

#include "data/drops.h"
#include "inference/judgement.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

double sum_of(const Causes& causes) { return causes.slips + causes.cracks + causes.both; }

Causes causes_by_one(const SimulatedTruth& truth, const std::vector<Crack>& cracks = {}) {
  const ReducedRecord record = simulated_record(truth, cracks);
  const Record physical = to_physical(record, Scales(1, 1));
  const DropFeatures features =
      drop_features(record, {truth.stiffness, truth.fibre}, {force_noise(physical), 0.03}, find_drops(physical).drops);
  REQUIRE(features.drops > 0);
  return causes_of(features, truth.stiffness);
}

TEST_CASE("identity: slips, cracks and neither, on soft and on stiff load trains") {
  for (const double k : {20.0, 60.0, 200.0}) {
    CAPTURE(k);
    const Causes slips = causes_by_one({.friction = Friction::sinusoid(0.6, 0.25, 14.0 / 1278, 1.0),
                                        .stiffness = k,
                                        .noise = 0.01,
                                        .deflection = 0.3});
    CHECK(slips_at_all(slips));
    CHECK_FALSE(loses_at_all(slips, false));
    CHECK(sum_of(slips) == doctest::Approx(1).epsilon(1e-12));
  }
  for (const double k : {60.0, 600.0, 6000.0}) {
    CAPTURE(k);
    const Causes cracks = causes_by_one(
        {.friction = Friction::constant(0.5), .stiffness = k, .noise = 0.01, .step = 1e-3, .deflection = 0.37},
        six_cracks);
    CHECK(loses_at_all(cracks, false));
    CHECK_FALSE(slips_at_all(cracks));
  }
}

TEST_CASE(
    "identity: a reload that lost nothing says slips, one that lost what the drops need cracks, and one between both") {
  const auto by = [&](const Causes& one_loading, double share) {
    return causes_of(
        one_loading,
        {.log_loss = -std::log(1 - share), .error = 0.02, .log_needed = -std::log(1 - 0.3), .drops_again = false});
  };
  const Causes open{.slips = 1.0 / 3, .cracks = 1.0 / 3, .both = 1.0 / 3};
  const Causes slipped{.slips = 0.6, .cracks = 0.01, .both = 0.39}, cracked{.slips = 0.02, .cracks = 0.7, .both = 0.28};
  CHECK(by(slipped, 0).slips > 0.7);
  CHECK(by(open, 0).cracks < 0.2);
  CHECK(by(cracked, 0.3).cracks > by(cracked, 0.3).both);
  CHECK(by(cracked, 0.3).slips < 0.01);
  CHECK(by(slipped, 0.12).both > 0.5);
  for (const double share : {0.0, 0.05, 0.12, 0.2, 0.3})
    CHECK(sum_of(by(open, share)) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("identity: a drop that comes again excludes cracks only, and lets both causes stand") {
  const Causes open{.slips = 1.0 / 3, .cracks = 1.0 / 3, .both = 1.0 / 3};
  Reload reload{.log_loss = 0.12, .error = 0.05, .log_needed = 0.2, .drops_again = false};
  const Causes once = causes_of(open, reload);
  reload.drops_again = true;
  const Causes again = causes_of(open, reload);
  CHECK(again.cracks < 0.3 * once.cracks);
  CHECK(again.slips + again.both > once.slips + once.both);
}

TEST_CASE(
    "limit: a reload that knows nothing leaves what one loading told, and nothing known is as likely as anything") {
  const Reload nothing{.log_loss = 0.1, .error = 5, .log_needed = 0.3, .drops_again = false};
  const Causes from_nothing = causes_of(Causes{}, nothing);
  const Causes even{.slips = 1.0 / 3, .cracks = 1.0 / 3, .both = 1.0 / 3};
  CHECK(from_nothing.slips == causes_of(even, nothing).slips);
  CHECK(from_nothing.slips > 0.05);
  CHECK(from_nothing.cracks > 0.05);
}

TEST_CASE("limit: the chances of the true cause are few below three errors, and certain far beyond") {
  const Causes slips{.slips = 0.9, .cracks = 0.02, .both = 0.08};
  for (const double error : {0.02, 0.05, 0.1}) {
    CAPTURE(error);
    double before = 0;
    for (const double errors : {1.0, 2.0, 3.0, 4.0, 5.0}) {
      const double cracks = chances_of_causes(errors * error, error, slips, true).cracks;
      CHECK(cracks > before);
      before = cracks;
    }
    CHECK(chances_of_causes(2 * error, error, slips, true).least() < 0.95);
  }
  CHECK(chances_of_causes(0.4, 0.02, slips, true).least() > 0.99);
  // What one loading tells of slips counts.
  CHECK(chances_of_causes(0.1, 0.03, slips, true).slips > chances_of_causes(0.1, 0.03, {}, true).slips);
}

}  // namespace
}  // namespace flexslip
