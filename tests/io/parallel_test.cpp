#include "io/parallel.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("parallel: each index once, whatever the threads") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    std::vector<int> calls(100);
    for_each_index(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    CHECK(calls == std::vector<int>(100, 1));
  }
  for_each_index(0, 4, [](std::size_t) { FAIL("nothing to do"); });
}

TEST_CASE("parallel: the failure of least index is thrown, and no further call is begun") {
  std::atomic<std::size_t> calls = 0;
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i % 10 == 3) throw std::runtime_error(std::to_string(i));
  };
  CHECK_THROWS_WITH_AS(for_each_index(100, 1, work), "3", std::runtime_error);
  CHECK(calls == 4);
  for (int repeat = 0; repeat < 20; ++repeat)  // indices are handed out in their order
    CHECK_THROWS_WITH_AS(for_each_index(100, 2, work), "3", std::runtime_error);
}

TEST_CASE("parallel: what stops the thread that calls stops them all, and no further call is begun") {
  std::atomic<std::size_t> calls = 0;
  const std::atomic<bool> stop = true;
  const Stoppable stoppable(&stop);
  const auto work = [&](std::size_t) {
    ++calls;
    effort_spent += 1;
  };
  for (const unsigned threads : {1U, 4U}) CHECK_THROWS_AS(for_each_index(1000, threads, work), Stopped);
  CHECK(calls <= 1 + 4);
}
