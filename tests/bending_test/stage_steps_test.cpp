#include <stdexcept>

#include <doctest/doctest.h>

#include "bending_test/history.h"

namespace flexslip {

TEST_CASE("steps of a stage: every turn is met, a last step may be shorter, and a remainder of rounding is none") {
  CHECK(stage_steps(std::vector<double>{0, 1, 0.25}, 0.5) == std::vector<double>{0, 0.5, 1, 0.5, 0.25});
  CHECK(stage_steps(std::vector<double>{0, 0.3}, 0.1).size() == 4);
  CHECK(stage_steps(std::vector<double>{2}, 0.1) == std::vector<double>{2});
  CHECK(stage_steps(std::vector<double>{0, 1, 1}, 2) == std::vector<double>{0, 1, 1});
}

TEST_CASE("steps of a stage: those that are none, or fill the memory, are refused") {
  const std::vector<double> turns{0, 1};
  CHECK_THROWS_AS(stage_steps({}, 1), std::invalid_argument);
  CHECK_THROWS_AS(stage_steps(turns, 0), std::invalid_argument);
  CHECK_THROWS_AS(stage_steps(turns, -1), std::invalid_argument);
  CHECK_THROWS_AS(stage_steps(turns, 1e-12), std::invalid_argument);
}

}  // namespace flexslip
