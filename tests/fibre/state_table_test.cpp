#include "fibre/state_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "tests/fibre/instruction_sets.h"
#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {
namespace {

struct TabledPoints {
  std::vector<double> S, q;
};

// Evenly in σ and q over the table, at its edges, and down to S - 1 = 1e-15; where there is a state.
TabledPoints points_in_table() {
  TabledPoints points;
  Uniform uniform;
  const auto add = [&](double S, double q) {
    if (fibre_state(S, q).status != FibreStatus::ok) return;
    points.S.push_back(S);
    points.q.push_back(q);
  };
  for (int i = 0; i < 200000; ++i)
    add(1 + std::pow(uniform(0, table_sigma), 2), uniform(table_q.least, table_q.greatest));
  for (int i = 0; i < 20000; ++i) add(1 + std::pow(10, uniform(-15, -1)), uniform(table_q.least, table_q.greatest));
  for (int i = 0; i < 2000; ++i) {
    add(1 + std::pow(uniform(0, table_sigma), 2), table_q.least);
    add(1 + table_sigma * table_sigma, uniform(table_q.least, table_q.greatest));
  }
  return points;
}

// What a relative change in S - 1 or in q does to F.
double condition_of_F(const FibreStateSlopes& at) {
  const auto& [state, d] = at;
  return 1 + std::abs((state.S - 1) * d.F_S / state.F) + std::abs(state.q * d.F_q / state.F);
}

TEST_CASE("oracle: w and F of the table agree with the exact states to 1e-12, its slopes to 1e-10, each as promised") {
  const TabledPoints points = points_in_table();
  const StateArrays states = tabulated_states({points.S, points.q});
  const SlopeArrays slopes = tabulated_states_slopes({points.S, points.q});
  double worst_w = 0, worst_F = 0, worst_S = 0, worst_q = 0;
  for (std::size_t i = 0; i < points.S.size(); ++i) {
    const auto at = fibre_state_slopes(points.S[i], points.q[i]);
    const auto& [state, d] = at;
    const double condition = condition_of_F(at);
    worst_w = std::max(worst_w, std::abs(states.w[i] / state.w - 1));
    worst_F = std::max(worst_F, std::abs(states.F[i] / state.F - 1) / condition);
    const double X_S[][3] = {{slopes.w_S[i], d.w_S, state.w}, {slopes.F_S[i], d.F_S, state.F}};
    const double X_q[][3] = {{slopes.w_q[i], d.w_q, state.w}, {slopes.F_q[i], d.F_q, state.F}};
    for (int k = 0; k < 2; ++k) {
      const double F_factor = k == 0 ? 1 : condition;
      worst_S = std::max(worst_S, std::abs(X_S[k][0] - X_S[k][1]) / F_factor /
                                      std::max(std::abs(X_S[k][1]), X_S[k][2] / (state.S - 1)));
      worst_q = std::max(worst_q, std::abs(X_q[k][0] - X_q[k][1]) / F_factor /
                                      std::max(std::abs(X_q[k][1]), X_q[k][2] / (1 + std::abs(state.q))));
    }
  }
  MESSAGE("worst of ", points.S.size(), " states: w ", worst_w, ", F ", worst_F, ", slopes ", worst_S, " and ",
          worst_q);
  CHECK(worst_w <= 1e-12);
  CHECK(worst_F <= 1e-12);
  CHECK(worst_S <= 1e-10);
  CHECK(worst_q <= 1e-10);
}

TEST_CASE("identity: all instruction sets give the same bits") {
  const TabledPoints points = points_in_table();
  std::vector<double> w, F, F_S, F_q;
  on_each_instruction_set([&] {
    const StateArrays states = tabulated_states({points.S, points.q});
    const SlopeArrays slopes = tabulated_states_slopes({points.S, points.q});
    if (w.empty()) {
      w = states.w;
      F = states.F;
      F_S = slopes.F_S;
      F_q = slopes.F_q;
    }
    CHECK(states.w == w);
    CHECK(states.F == F);
    CHECK(slopes.w == w);
    CHECK(slopes.F == F);
    CHECK(slopes.F_S == F_S);
    CHECK(slopes.F_q == F_q);
  });
}

TEST_CASE(
    "limit: beyond the table and the branch the answers equal the exact batch; a state outside the domain is "
    "refused") {
  const std::vector<double> S{1.0, 2.11, 2.15, 1.2, 1.3, 1.5, 40.0};
  const std::vector<double> q{0.5, 0.5, 1.0, 5.0, -3.0, -1.0, 0.1};
  const auto exact = fibre_states({S, q});
  const auto table = tabulated_states({S, q});
  CHECK(table.w[0] == 0);
  CHECK(table.F[0] == 0);
  for (std::size_t i = 1; i < S.size(); ++i) {
    CAPTURE(i);
    CHECK((table.w[i] == exact.w[i] || (std::isnan(table.w[i]) && std::isnan(exact.w[i]))));
  }
  CHECK(std::isnan(table.w[5]));  // the branch for q = -1 ends at 1.177
  CHECK(tabulated_states({{}, {}}).w.empty());
  const auto slopes = tabulated_states_slopes({S, q});
  CHECK(slopes.F[0] == 0);
  CHECK((std::isnan(slopes.w_S[0]) && std::isnan(slopes.F_q[0])));
  const std::vector<double> wrong{1.1, 1.2, 1.3, 0.5}, friction(4, 0.5);
  CHECK(message_of([&] { tabulated_states({wrong, friction}); }).find("state 3: ") == 0);
}

}  // namespace
}  // namespace flexslip
