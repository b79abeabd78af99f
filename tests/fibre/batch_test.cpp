#include "fibre/batch.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "tests/fibre/instruction_sets.h"
#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {
namespace {

// NaN is the same as NaN; -0 is not 0.
bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

struct Points {
  std::vector<double> S, q;
  void add(double length, double friction) {
    S.push_back(length);
    q.push_back(friction);
  }
};

// States as tests visit them, and all that a batch must leave to the scalar code: S = 1, one ulp above it, large q, the end of the branch
// and beyond.
Points mixed_points() {
  Points points;
  Uniform uniform;
  for (int i = 0; i < 4000; ++i) points.add(1 + std::pow(uniform(0, 0.8), 2), uniform(-0.3, 2));
  for (int i = 0; i < 1000; ++i) points.add(1 + std::pow(10, uniform(-15.5, 0.3)), uniform(-20, 20));
  for (int i = 0; i < 200; ++i) {
    const double q = uniform(-2, 0.8);
    const double end = fibre_branch_end(q).S;
    points.add(end * (1 + uniform(-1e-3, 1e-3)), q);
    points.add(end * (1 + uniform(-1e-15, 1e-15)), q);
  }
  for (const double S : {1.0, std::nextafter(1.0, 2.0), 2.1, 2.17, 30.0})
    for (const double q : {-20.0, -1.2, -0.0, 0.0, 3.0, 20.0}) points.add(S, q);
  return points;
}

TEST_CASE("oracle: a batch has the bits of the scalar states and slopes, on every instruction set") {
  const Points points = mixed_points();
  on_each_instruction_set([&] {
    const StateArrays states = fibre_states({points.S, points.q});
    SlopeArrays slopes = fibre_states_slopes({points.S, points.q});
    int different = 0;
    int none = 0;
    for (std::size_t i = 0; i < points.S.size(); ++i) {
      const auto [state, d] = fibre_state_slopes(points.S[i], points.q[i]);
      const double expected[] = {state.w, state.F, d.w_S, d.w_q, d.F_S, d.F_q};
      different += !same_bits(states.w[i], state.w) + !same_bits(states.F[i], state.F);
      for (std::size_t k = 0; k < 6; ++k) different += !same_bits(slopes.columns()[k][i], expected[k]);
      none += state.status == FibreStatus::beyond_branch;
    }
    CHECK(different == 0);
    CHECK(none > 100);  // some were beyond the branch
  });
}

TEST_CASE("identity: a state's bits depend neither on its neighbours nor on their number, on every instruction set") {
  const Points points = mixed_points();
  on_each_instruction_set([&] {
    const StateArrays all = fibre_states({points.S, points.q});
    int different = 0;
    for (std::size_t n = 1; n <= 19; ++n)
      for (std::size_t first = 0; first + n <= points.S.size(); first += 97) {
        const StateArrays some = fibre_states({{&points.S[first], n}, {&points.q[first], n}});
        for (std::size_t i = 0; i < n; ++i)
          different += !same_bits(some.w[i], all.w[first + i]) + !same_bits(some.F[i], all.F[first + i]);
      }
    CHECK(different == 0);
  });
}

TEST_CASE("limit: no states, lengths without frictions, and a state outside the domain, named by its index") {
  CHECK(fibre_states({{}, {}}).w.empty());
  const std::vector<double> one{1.1}, two{1.1, 1.2};
  CHECK_THROWS_AS(FibrePoints(one, two), std::invalid_argument);
  for (const double wrong : {0.99, std::numeric_limits<double>::quiet_NaN(), -1.0}) {
    const std::vector<double> S{1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.1, 1.2, 1.3, wrong};
    const std::vector<double> q(S.size(), 0.5);
    CHECK(message_of([&] { fibre_states({S, q}); }).find("state 9: ") == 0);
    CHECK(message_of([&] { fibre_states_slopes({S, q}); }).find("state 9: ") == 0);
  }
  const std::vector<double> q{20.5};
  CHECK(message_of([&] { fibre_states({one, q}); }).find("state 0: ") == 0);
}

}  // namespace
}  // namespace flexslip
