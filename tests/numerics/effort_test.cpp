#include "numerics/effort.h"

#include <atomic>

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("limit: stoppable work ends where it counts effort, and only then") {
  effort_spent.clear();
  std::atomic<bool> stop = false;
  {
    const Stoppable stoppable(&stop);
    effort_spent += 3;
    stop = true;
    CHECK_THROWS_AS(effort_spent += 4, Stopped);
    {
      const Stoppable no_other(nullptr);
      CHECK_THROWS_AS(effort_spent += 4, Stopped);
      const std::atomic<bool> never = false;
      const Stoppable inner(&never);
      effort_spent += 5;
    }
    CHECK(Stoppable::of_this_thread() == &stop);
  }
  effort_spent += 6;
  CHECK(effort_spent.spent() == 3 + 5 + 6);
  CHECK(Stoppable::of_this_thread() == nullptr);
}
