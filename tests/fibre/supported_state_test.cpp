#include "fibre/supported_state.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/approximately.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

// By mpmath to 40 digits and by shooting, from the derivation of these formulas: friction at the axis where the half depth is 0.
struct Reference {
  double q, radius, half_depth, length, slid_to, w, F, theta0, Pn, U, curvature;
};
constexpr std::array references{
    Reference{0, .02, 0, 0.99850665365876, 1.0017059712105, 0.026664025434299, 1.2797272271329, 0.079982938792555,
              0.64191577361819, 0.017082820028994, 0.32027358855922},
    Reference{.6, .02, 0, 1.010247790327, 1.0214989256429, 0.095089730556177, 4.8491499805484, 0.28127838289768,
              2.1508726277702, 0.21083242865617, 1.1382123564671},
    Reference{-.3, .05, 0, 1.0296067862526, 1.0852992295894, 0.19038853445598, 6.0376005953761, 0.55692443336741,
              4.3730991077872, 0.78950918654888, 2.0558555492577},
    Reference{1, .109375, 0, 0.95595763445951, 1.0375956089309, 0.12575224659053, 8.0209072068422, 0.37320216901214,
              3.0950502302972, 0.39678538182498, 1.6379873799988},
    Reference{.6, 0, .0157, 0.99980138792026, 0.99980138792026, 0.037251630785025, 1.8203189106874, 0.11242017760508,
              0.85783364412205, 0.033247446676086, 0.44613113842173},
    Reference{.6, 0, .0157, 1.0257700733441, 1.0257700733441, 0.12574876777945, 6.0708406879805, 0.37149469244921,
              2.6404351596368, 0.35671531987547, 1.4607388711745},
    Reference{.6, .008, .0157, 1.0197529312162, 1.0256981190392, 0.12558356418614, 6.1427784345787, 0.37157423894089,
              2.6716873326823, 0.35893892795463, 1.4695268756269},
    Reference{-.6, .008, .0157, 1.0012240664929, 1.0043899671918, 0.066556585460725, 2.8922320012907, 0.19786879367978,
              1.6765791336327, 0.10542638046189, 0.7875006200326},
    Reference{.4, .078125, .03125, 0.95699049187845, 1.0351829323475, 0.16730968618594, 8.6724978532042,
              0.50043161900189, 4.0552324264183, 0.68656965819834, 2.0716712435509},
    Reference{.9, .01, .0157, 1.0729816576021, 1.0850884199103, 0.21237453791085, 9.9249781410279, 0.60533811541144,
              3.7187638477254, 0.9126927364981, 2.3290409000202}};

// The fibre integrated from a contact to midspan in small steps (Runge and Kutta), from a given state's force, slope and couple.
struct Shot {
  double x, y, theta, curvature;
};
Shot shot_at(const SupportedState& state, const Supports& supports) {
  const auto& [r, tau] = supports;
  const double R = r + tau, V = 0.5 * state.F,
               H = state.Pn * (std::sin(state.theta0) - state.q * std::cos(state.theta0));
  std::array<double, 4> y{R * std::sin(state.theta0), R * (1 - std::cos(state.theta0)), state.theta0,
                          state.q * state.Pn * tau};
  // dθ/ds = -κ, dκ/ds = V cos θ + H sin θ: the moment of the forces at the contact.
  const auto slope = [&](const std::array<double, 4>& at) {
    return std::array{std::cos(at[2]), std::sin(at[2]), -at[3], V * std::cos(at[2]) + H * std::sin(at[2])};
  };
  constexpr int steps = 2000;
  const double h = 0.5 * state.length / steps;
  for (int i = 0; i < steps; ++i) {
    const auto moved = [&](const std::array<double, 4>& by, double share) {
      auto to = y;
      for (std::size_t j = 0; j < 4; ++j) to[j] += share * h * by[j];
      return to;
    };
    const auto a = slope(y), b = slope(moved(a, 0.5)), c = slope(moved(b, 0.5)), d = slope(moved(c, 1));
    for (std::size_t j = 0; j < 4; ++j) y[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
  }
  return {y[0], y[1], y[2], y[3]};
}

struct SomeState {
  double w, q;
  Supports supports;
};
SomeState some_state() { return {*between(0.005, 0.35), *between(-0.8, 1.5), {*between(0, 0.1), *between(0, 0.05)}}; }

}  // namespace

TEST_CASE("supported_state: ten states to 13 digits (40-digit values)") {
  constexpr double digits = 2e-13;
  for (const Reference& r : references) {
    const SupportedState state = state_on_supports(r.w, r.q, {r.radius, r.half_depth});
    REQUIRE(state.status == FibreStatus::ok);
    CAPTURE(r.w);
    CHECK(state.length == to(digits, r.length));
    CHECK(1 + state.slid == to(digits, r.slid_to));
    CHECK(state.F == to(digits, r.F));
    CHECK(state.theta0 == to(digits, r.theta0));
    CHECK(state.Pn == to(digits, r.Pn));
    CHECK(state.U == to(digits, r.U));
    CHECK(state.curvature == to(digits, r.curvature));
  }
}

TEST_CASE("supported_state, limit: edges and no thickness are the fibre of elastica.h") {
  CHECK(rc::check([] {
    const double S = 1 + std::pow(10, *between(-5, -0.3)), q = *between(-0.5, 2);
    const FibreState fibre = fibre_state(S, q);
    if (fibre.status != FibreStatus::ok) return;
    const SupportedState state = state_on_supports(fibre.w, q, {0, 0});
    RC_ASSERT(state.status == FibreStatus::ok);
    RC_ASSERT(state.slid == to(1e-12, S - 1));  // S itself holds S - 1 to 2^-53/(S - 1)
    RC_ASSERT(state.F == to(1e-11, fibre.F));   // its condition number
    RC_ASSERT(state.U == to(1e-12, fibre.U));
    RC_ASSERT(state.curvature == to(1e-12, curvature_at_midspan(fibre)));
    RC_ASSERT(state.length == state.imaged);
  }));
}

TEST_CASE("supported_state, oracle: the fibre integrated from the contact meets midspan level") {
  CHECK(rc::check([] {
    const auto [w, q, supports] = some_state();
    const SupportedState state = state_on_supports(w, q, supports);
    if (q < -0.3 && state.status != FibreStatus::ok) return;  // such friction may leave no force
    RC_ASSERT(state.status == FibreStatus::ok);
    RC_ASSERT(state.imaged ==
              to(1e-12, state.length + 2 * (supports.radius + supports.half_depth) * std::tan(state.theta0)));
    const Shot shot = shot_at(state, supports);
    RC_ASSERT(std::abs(shot.x - 0.5) < 1e-11);
    RC_ASSERT(std::abs(shot.y - w) < 1e-11);
    RC_ASSERT(std::abs(shot.theta) < 1e-10);
    RC_ASSERT(shot.curvature == to(1e-9, state.curvature));
  }));
}

TEST_CASE("supported_state, energy: dU = F dw - q Pn [(1 + κ0 τ/2) dS + 2 r dθ0] along any path") {
  CHECK(rc::check([] {
    const auto [w, q, supports] = some_state();
    const double h = 1e-4, along_w = *between(-1, 1) * w, along_q = *between(-1, 1);
    const auto at = [&, w = w, q = q, supports = supports](double t) {
      return state_on_supports(w + t * along_w, q + t * along_q, supports);
    };
    std::array<SupportedState, 5> path{at(-2 * h), at(-h), at(0), at(h), at(2 * h)};
    for (const auto& state : path)
      if (state.status != FibreStatus::ok) return;
    const auto slope = [&](double SupportedState::*of) {  // by five points: the error is as the fourth power of h
      return ((path[0].*of - path[4].*of) + 8 * (path[3].*of - path[1].*of)) / (12 * h);
    };
    const SupportedState& state = path[2];
    const double couple = state.q * state.Pn * supports.half_depth;
    const double work = state.F * along_w;
    const double heat = state.q * state.Pn *
                        ((1 + 0.5 * couple * supports.half_depth) * slope(&SupportedState::length) +
                         2 * supports.radius * slope(&SupportedState::theta0));
    const double size = std::abs(work) + std::abs(heat) + state.U;
    RC_ASSERT(std::abs(slope(&SupportedState::U) - (work - heat)) <= 1e-8 * size);
  }));
}

TEST_CASE("supported_state, limit: the initial slope carries 1/(1 + 3 q τ), and the surface slides out at first") {
  const double tau = 0.0157;
  for (const double q : {0.6, -0.6}) {
    const SupportedState state = state_on_supports(1e-5, q, {0, tau});
    CHECK(state.F / (48 * state.w) == doctest::Approx(1 / (1 + 3 * q * tau)).epsilon(2e-4));  // the next order is q w
    CHECK(state.slid < 0);
  }
  CHECK(state_on_supports(1e-5, 0.6, {0, tau}).F / 48e-5 == doctest::Approx(0.97251668).epsilon(2e-4));
  CHECK(state_on_supports(0.01, 0, {0, tau}).slid == doctest::Approx(2.4e-4 - 6 * tau * 0.01).epsilon(0.02));
  // ∂F/∂q at constant w changes its sign where the length does not change with w, at 1.25 τ.
  const auto by_q = [&](double w) {
    return state_on_supports(w, 0.1, {0, tau}).F - state_on_supports(w, -0.1, {0, tau}).F;
  };
  CHECK(by_q(1.1 * tau) < 0);
  CHECK(by_q(1.4 * tau) > 0);
}

TEST_CASE("supported_state, identity: deflection and force determine the friction, beyond twice the thickness") {
  int told = 0;
  for (const double radius : {0.0, 0.004, 0.05, 0.078125})
    for (const double half_depth : {0.0, 0.0157, 0.03125})
      for (double w = 0.02; w < 0.36; w += 0.017)
        for (double q = -0.8; q < 1.5; q += 0.23) {
          CAPTURE(radius);
          CAPTURE(half_depth);
          CAPTURE(w);
          CAPTURE(q);
          const Supports supports{radius, half_depth};
          const SupportedState state = state_on_supports(w, q, supports);
          if (state.status != FibreStatus::ok) continue;
          const SupportedState back = state_on_supports_from_force(w, state.F, supports);
          if (w < 4 * half_depth) {
            CHECK(back.status == FibreStatus::no_friction);
            continue;
          }
          REQUIRE(back.status == FibreStatus::ok);
          CHECK(std::abs(back.q - q) < 1e-9);
          CHECK(std::abs(back.length - state.length) < 1e-9);
          ++told;
        }
  CHECK(told > 1000);
  CHECK(state_on_supports_from_force(0.1, 48 * 0.1 * 3, {0.05, 0}).status == FibreStatus::no_friction);
  CHECK_THROWS_AS(state_on_supports_from_force(0.1, -1, {0.05, 0}), std::invalid_argument);
}

TEST_CASE("supported_state: what is no support, and no state") {
  CHECK_THROWS_AS(state_on_supports(0.1, 0, {0.3, 0.2}), std::invalid_argument);
  CHECK_THROWS_AS(state_on_supports(0.1, 0, {-0.1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(state_on_supports(0, 0, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(state_on_supports(0.1, 30, {0, 0}), std::invalid_argument);
  CHECK(state_on_supports(1.5, 0, {0, 0}).status == FibreStatus::beyond_branch);
  CHECK(state_on_supports(1.5, 0, {0.05, 0.02}).status == FibreStatus::beyond_branch);
}

}  // namespace flexslip
