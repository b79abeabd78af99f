#include "fibre/batch_inverse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "tests/fibre/instruction_sets.h"
#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct States {
  std::vector<double> w, F, S, q;
};

// As tests visit them, beyond the table, and near the straight fibre.
States mixed_states() {
  States states;
  Uniform uniform;
  const auto add = [&](double S, double q) {
    const auto state = fibre_state(S, q);
    if (state.status != FibreStatus::ok) return;
    states.w.push_back(state.w);
    states.F.push_back(state.F);
    states.S.push_back(S);
    states.q.push_back(q);
  };
  for (int i = 0; i < 3000; ++i) add(1 + std::pow(uniform(0, 0.78), 2), uniform(-0.5, 2));
  for (int i = 0; i < 1000; ++i) add(1 + std::pow(uniform(0, 1.2), 2), uniform(-10, 10));
  for (int i = 0; i < 500; ++i) add(1 + std::pow(10, uniform(-12, -2)), uniform(-2, 4));
  return states;
}

double condition_of_F(double S, double q) {
  const auto [state, d] = fibre_state_slopes(S, q);
  return 1 + std::abs((S - 1) * d.F_S / state.F) + std::abs(q * d.F_q / state.F);
}

TEST_CASE(
    "oracle: put back into the scalar map, the inverse reproduces w to 32 S ulp and F to that times its condition "
    "number") {
  const States states = mixed_states();
  on_each_instruction_set([&] {
    const InverseArrays inverse = fibre_states_from_forces(states.w, states.F);
    double worst_w = 0, worst_F = 0;
    for (std::size_t i = 0; i < states.w.size(); ++i) {
      const auto state = fibre_state(inverse.S[i], inverse.q[i]);
      REQUIRE(state.status == FibreStatus::ok);
      // S is known to its rounding, which is the rounding of w times 1/(S - 1)
      const double rounding = inverse.S[i] * epsilon * (1 + 1 / (inverse.S[i] - 1) / 32);
      worst_w = std::max(worst_w, std::abs(state.w / states.w[i] - 1) / rounding);
      worst_F = std::max(worst_F,
                         std::abs(state.F / states.F[i] - 1) / rounding / condition_of_F(inverse.S[i], inverse.q[i]));
    }
    CHECK(worst_w <= 32);
    CHECK(worst_F <= 32);
  });
}

TEST_CASE("oracle: the inverse of the table reproduces w and F to twice the error of the table") {
  const States states = mixed_states();
  const InverseArrays inverse = tabulated_states_from_forces(states.w, states.F);
  for (std::size_t i = 0; i < states.w.size(); ++i) {
    const auto state = fibre_state(inverse.S[i], inverse.q[i]);
    REQUIRE(state.status == FibreStatus::ok);
    const double rounding = epsilon / (inverse.S[i] - 1);
    CHECK(std::abs(state.w / states.w[i] - 1) <= 2e-12 + rounding);
    CHECK(std::abs(state.F / states.F[i] - 1) <= (2e-12 + rounding) * condition_of_F(inverse.S[i], inverse.q[i]));
  }
}

TEST_CASE(
    "limit: what no friction explains is NaN; the straight fibre has S = 1; what is no force is refused by its index") {
  const std::vector<double> w{0.0, 0.2, 0.3}, F{0.0, 1e4, 12.0};
  for (const auto& inverse : {fibre_states_from_forces(w, F), tabulated_states_from_forces(w, F)}) {
    CHECK(inverse.S[0] == 1);
    CHECK(std::isnan(inverse.S[1]));
    CHECK(std::isnan(inverse.q[1]));
    CHECK(inverse.S[2] > 1.1);
  }
  const double w_end = 0.6, tiny = 1e-9;  // the end of the branch, where F = 0; and where S rounds to 1
  const auto end = fibre_states_from_forces({&w_end, 1}, {F.data(), 1});
  CHECK(end.q[0] == fibre_state_from_force(w_end, 0).q);
  CHECK(std::isnan(fibre_states_from_forces({&tiny, 1}, {&tiny, 1}).S[0]));
  CHECK(fibre_states_from_forces({}, {}).S.empty());
  CHECK_THROWS_AS(fibre_states_from_forces(w, {}), std::invalid_argument);
  const std::vector<double> wrong{12.0, 12.0, -1.0};
  CHECK(message_of([&] { fibre_states_from_forces(w, wrong); }).find("state 2: ") == 0);
}

}  // namespace
}  // namespace flexslip
