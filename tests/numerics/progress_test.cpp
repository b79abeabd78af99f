#include "numerics/progress.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "tests/generators.h"

using namespace flexslip;

namespace {

// A piece of work of random stages, some of them pieces themselves, that may end early.
void some_work(int depth) {
  Stages stages;
  const int count = *whole(0, 4);
  for (int i = 0; i < count; ++i) {
    stages.enter(*whole(0, 1) ? "a stage" : "", *between(0, 1.0 / count));
    effort_spent += static_cast<std::uint64_t>(*whole(0, 1'000'000));
    if (depth > 0 && *whole(0, 1)) some_work(depth - 1);
    effort_spent += static_cast<std::uint64_t>(*whole(0, 1'000'000));
  }
}

}  // namespace

TEST_CASE("progress: a stage begins where the previous one ends, and its pieces divide it (table)") {
  std::vector<Reached> told;
  {
    const Watch watch([&](const Reached& reached) { told.push_back(reached); });
    Stages whole;
    whole.enter("first", 0.25);
    whole.enter("", 0.5);
    {
      Stages part;
      part.enter("half", 0.5);
      part.enter("", 0.25);  // the rest is left out
    }
    whole.enter("last", 0.25);
  }
  const std::vector<Reached> expected{{"first", 0}, {"", 0.25}, {"half", 0.25}, {"", 0.5}, {"last", 0.75}};
  REQUIRE(told.size() == expected.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    CHECK(told[i].stage == expected[i].stage);
    CHECK(told[i].share == expected[i].share);
  }
}

TEST_CASE("progress: within a stage the share grows at the rate of the stages before (table)") {
  std::optional<Reached> last;
  const Watch watch([&](const Reached& reached) { last = reached; });
  Stages stages;
  stages.enter("first", 0.2);
  effort_spent += 2 * Watch::every;
  CHECK(last->share == 0);  // what it will take is not known
  stages.enter("second", 0.4);
  effort_spent += Watch::every;  // of four that are expected
  CHECK(last->stage == "second");
  CHECK(last->share == doctest::Approx(0.3).epsilon(1e-15));
  effort_spent += 3 * Watch::every;
  CHECK(last->share == doctest::Approx(0.2 + 0.4 * 0.75).epsilon(1e-15));
  effort_spent += 96 * Watch::every;
  CHECK(last->share == doctest::Approx(0.2 + 0.4 * 0.99).epsilon(1e-15));
}

TEST_CASE("progress: the reported share never decreases and lies between 0 and 1, for any stages (identity)") {
  CHECK(rc::check("random stages", [] {
    double share = 0;
    const Watch watch([&](const Reached& reached) {
      RC_ASSERT(reached.share >= share);
      RC_ASSERT(reached.share <= 1);
      share = reached.share;
    });
    some_work(3);
  }));
}

TEST_CASE("progress: an inner Watch reports its own work; the outer one resumes after it (limit)") {
  int outer = 0, inner = 0;
  {
    const Watch watch([&](const Reached&) { ++outer; });
    {
      const Watch another([&](const Reached&) { ++inner; });
      effort_spent += Watch::every;
    }
    CHECK(outer == 0);
    CHECK(inner == 1);
    effort_spent += Watch::every - 1;
    CHECK(outer == 0);
    effort_spent += 1;
    CHECK(outer == 1);
  }
  effort_spent += 2 * Watch::every;
  CHECK(outer == 1);
  Stages unwatched;
  unwatched.enter("a stage", 1);
  CHECK(outer == 1);
}
