#include "design/reload_study.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "tests/design/some_design.h"

namespace flexslip {
namespace {

// Up to 560 um the specimen slides outwards when it is unloaded.
Test toothed() {
  Test test = loading_of(with("40 um", "10.9 um"));
  set(test, "travel", 560e-6);
  return test;
}

const ReloadStudy& study() {
  static const ReloadStudy made = reload_study(toothed(), {.threads = 2});
  return made;
}

}  // namespace

TEST_CASE("reload study, identity: at each travel, deeper unloading determines the loss as well or better") {
  constexpr double by_chance = 1.1;  // the noise of each record is another
  std::size_t compared = 0;
  for (std::size_t i = 1; i < study().plans.size(); ++i) {
    const ReloadPlan &before = study().plans[i - 1], &plan = study().plans[i];
    if (plan.travel != before.travel) continue;
    CHECK(plan.unload_to < before.unload_to);
    CHECK(plan.force < before.force);
    CHECK(plan.drops == before.drops);
    if (!std::isfinite(before.loss_error)) continue;
    CHECK(plan.loss_error < by_chance * before.loss_error);
    ++compared;
  }
  CHECK(compared >= 12);
}

TEST_CASE("reload study, identity: the reported plan has the smallest sufficient travel") {
  const auto least = study().least();
  REQUIRE(least);
  CHECK(study().suffices(*least));
  for (const ReloadPlan& plan : study().plans)
    if (study().suffices(plan)) CHECK(plan.travel >= least->travel);
  CHECK(study().suffices(study().of_travel()));
  CHECK(study().of_travel().travel == study().plans.back().travel);
  CHECK(study().changes.empty());
}

TEST_CASE(
    "reload study, limit: drops that need less than three errors do not suffice, and the changes that are named do") {
  Test polished = toothed();
  set(polished, "amplitude", 0.04);
  set(polished, "travel", 520e-6);
  const auto few = reload_study(polished, {});
  std::size_t small = 0;
  for (const ReloadPlan& plan : few.plans)
    if (plan.loss_needed < 3 * plan.loss_error) {
      CHECK(!few.suffices(plan));
      ++small;
    }
  CHECK(small > 0);
  CHECK(!few.least());
  REQUIRE(!few.changes.empty());
  for (const ReloadChange& change : few.changes) CHECK(few.suffices(change.plan));
}

TEST_CASE("reload study, limit: without drops there is nothing to decide") {
  Test smooth = toothed();  // a rig so stiff that nothing snaps, and friction without waves
  set(smooth, "stiffness", std::numeric_limits<double>::infinity());
  set(smooth, "amplitude", 0);
  set(smooth, "travel", 400e-6);
  const auto nothing = reload_study(smooth, {});
  CHECK(nothing.drops == 0);
  CHECK(nothing.plans.empty());
  CHECK(!nothing.least());
}

TEST_CASE("reload study, limit: noise that hides the drops leaves nothing to decide, and the default noise is small") {
  CHECK(study().noise_is_usual);
  const auto noisy = reload_study(toothed(), {.noise = 100 * study().noise});
  CHECK(noisy.plans.empty());
  CHECK(!noisy.noise_is_usual);
}

TEST_CASE("reload study, identity: the same for any number of threads") {
  const auto one = reload_study(toothed(), {.threads = 1});
  REQUIRE(one.plans.size() == study().plans.size());
  for (std::size_t i = 0; i < one.plans.size(); ++i) {
    const double here = one.plans[i].loss_error, there = study().plans[i].loss_error;
    CHECK((here == there || (std::isnan(here) && std::isnan(there))));
  }
}

}  // namespace flexslip
