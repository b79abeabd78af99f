#include "fibre/fibre.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>

#include "tests/approximately.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

const Fibre& some_fibre() {
  static const std::vector<Fibre> fibres{Fibre({0, .0157}), Fibre({.008, .0157}), Fibre({.078125, .03125}),
                                         Fibre({.02, 0})};
  return fibres[*rc::gen::inRange<std::size_t>(0, fibres.size())];
}

// Bent beyond its smallest length.
struct Bent {
  double w, q;
};
Bent some_bent(const Fibre& fibre) {
  return {*between(3 * fibre.supports().half_depth + 0.005, 0.35), *between(-0.8, 2)};
}

}  // namespace

TEST_CASE("fibre, limit: on edges it is the map of elastica.h, bit by bit") {
  CHECK(rc::check([] {
    const double S = 1 + std::pow(10, *between(-5, 0)), q = *between(-1, 2);
    const Fibre fibre;
    const FibreStateSlopes a = fibre.state_slopes(S, q), b = fibre_state_slopes(S, q);
    RC_ASSERT(a.state.status == b.state.status);
    if (a.state.status != FibreStatus::ok) return;
    RC_ASSERT(a.state.w == b.state.w);
    RC_ASSERT(a.state.F == b.state.F);
    RC_ASSERT(a.slopes.F_S == b.slopes.F_S);
    RC_ASSERT(fibre.length_between_contacts(a.state) == S);
    RC_ASSERT(fibre.bending_energy_lost_at_contact(a.state) == 0);
  }));
}

TEST_CASE("fibre, oracle: the tables give the states of supported_state.h, by length and by force") {
  CHECK(rc::check([] {
    const Fibre& fibre = some_fibre();
    const auto [w, q] = some_bent(fibre);
    const SupportedState exact = state_on_supports(w, q, fibre.supports());
    if (q < 0 && exact.status != FibreStatus::ok) return;  // such friction may leave no force
    RC_ASSERT(exact.status == FibreStatus::ok);
    constexpr double close = 2e-12;
    const double condition = 1 + q * q + (w * exact.Pn * std::abs(q) / exact.F);
    const FibreState state = fibre.state(1 + exact.slid, q);
    RC_ASSERT(state.status == FibreStatus::ok);
    RC_ASSERT(state.w == to(close * (1 + 1e-4 / exact.slid), w));  // a length has an absolute rounding
    const Fibre::DeflectionState bent = fibre.at_deflection(w, q);
    RC_ASSERT(std::abs(bent.state.S - 1 - exact.slid) <= close);
    RC_ASSERT(bent.state.F == to(close * condition, exact.F));
    RC_ASSERT(bent.state.theta0 == to(close, exact.theta0));
    RC_ASSERT(bent.state.Pn == to(close * condition, exact.Pn));
    RC_ASSERT(fibre.state_at_deflection(w, q).U == to(close, exact.U));
    RC_ASSERT(fibre.length_between_contacts(bent.state) == to(close, exact.length));
    RC_ASSERT(fibre.curvature_at_midspan(bent.state) == to(close, exact.curvature));
    const double by_friction = bent.S_q - 2 * fibre.supports().radius * bent.theta0_q;
    RC_ASSERT(fibre.length_friction_derivatives({&w, 1}, {&q, 1}).front() == to(1e-12, by_friction));
    if (const double S = bent.state.S; S >= 1)
      RC_ASSERT(fibre.curvatures_at_midspan({{&S, 1}, {&q, 1}}, {&w, 1}).front() == to(close, exact.curvature));
    if (w < least_half_depths * fibre.supports().half_depth || std::abs(q) > 1.9) return;
    const FibreState back = fibre.state_from_force(w, exact.F);
    RC_ASSERT(back.status == FibreStatus::ok);
    RC_ASSERT(std::abs(back.q - q) < 1e-10 / (w * w));
  }));
}

TEST_CASE(
    "fibre, oracle: a state that supported_state.h finds is found by its length, however much the fibre is bent") {
  const Supports supports{0, 0.5 * 34.8 / 1278};
  const Fibre fibre(supports);
  for (double w = 0.5; w < 1.1; w += 0.05)
    for (double q = 0.25; q < 4; q += 0.25) {
      CAPTURE(w);
      CAPTURE(q);
      const SupportedState exact = state_on_supports(w, q, supports);
      if (exact.status != FibreStatus::ok) continue;
      const FibreState found = fibre.state(1 + exact.slid, q);
      REQUIRE(found.status == FibreStatus::ok);
      CHECK(found.w == doctest::Approx(w).epsilon(1e-9));
      CHECK(found.F == doctest::Approx(exact.F).epsilon(1e-7));
    }
}

TEST_CASE("fibre, identity: many states by length equal single states, which are computed by deflection") {
  CHECK(rc::check([] {
    const Fibre& fibre = some_fibre();
    const auto [w, q] = some_bent(fibre);
    const double S = 1 + state_on_supports(w, q, fibre.supports()).slid;
    if (!(S > 1)) return;
    const FibreStateSlopes one = fibre.state_slopes(S, q);
    if (one.state.status != FibreStatus::ok) return;
    const SlopeArrays many = fibre.tabulated_states_slopes(FibrePoints({&S, 1}, {&q, 1}));
    const double condition = 1 + q * q + (w * one.state.Pn * std::abs(q) / one.state.F);
    const double rounding = 1 + 1e-4 / (S - 1);  // a length has an absolute one
    RC_ASSERT(many.w[0] == to(4e-12 * rounding, one.state.w));
    RC_ASSERT(many.F[0] == to(4e-12 * condition * rounding, one.state.F));
    const double close = 1e-9 * condition;
    RC_ASSERT(many.w_S[0] == to(close, one.slopes.w_S));
    RC_ASSERT(std::abs(many.w_q[0] - one.slopes.w_q) <= close * w);
    RC_ASSERT(std::abs(many.F_S[0] - one.slopes.F_S) <= close * (std::abs(one.slopes.F_S) + one.state.F / w));
    RC_ASSERT(many.F_q[0] == to(close, one.slopes.F_q));
  }));
}

TEST_CASE("fibre, definition: slopes in length and friction agree with differences") {
  CHECK(rc::check([] {
    const Fibre& fibre = some_fibre();
    const auto [w, q] = some_bent(fibre);
    if (q < -0.5) return;
    const double S = fibre.at_deflection(w, q).state.S;
    if (!(S > 1)) return;
    const double h = 1e-5 * (S - 1 + 0.01);
    const auto at = [&](double dS, double dq) { return fibre.state(S + dS, q + dq); };
    const auto [state, d] = fibre.state_slopes(S, q);
    const auto close = [](double a, double b, double size) { return std::abs(a - b) <= 1e-6 * (std::abs(a) + size); };
    const auto along = [&](double FibreState::*of) { return (at(h, 0).*of - at(-h, 0).*of) / (2 * h); };
    const auto across = [&](double FibreState::*of) { return (at(0, 1e-4).*of - at(0, -1e-4).*of) / 2e-4; };
    if (S - h < 1) return;
    RC_ASSERT(close(d.w_S, along(&FibreState::w), 1));
    RC_ASSERT(close(d.F_S, along(&FibreState::F), 48));
    RC_ASSERT(close(d.Pn_S, along(&FibreState::Pn), 48));
    RC_ASSERT(close(d.U_S, along(&FibreState::U), 1));
    RC_ASSERT(close(d.theta0_S, along(&FibreState::theta0), 3));
    RC_ASSERT(close(d.w_q, across(&FibreState::w), w));
    RC_ASSERT(close(d.F_q, across(&FibreState::F), state.F));
    RC_ASSERT(close(d.Pn_q, across(&FibreState::Pn), state.Pn));
    RC_ASSERT(close(d.U_q, across(&FibreState::U), state.U));
    RC_ASSERT(close(d.theta0_q, across(&FibreState::theta0), 1));
  }));
}

TEST_CASE(
    "fibre, identity: more friction causes more force where the surface slides in with deflection, and "
    "less before") {
  CHECK(rc::check([] {
    const Fibre& fibre = some_fibre();
    const double w = *between(0.002, 0.3), q = *between(-0.3, 1.5);
    const Fibre::DeflectionState at = fibre.at_deflection(w, q);
    RC_ASSERT(at.state.status == FibreStatus::ok);
    constexpr double least = 0.02;  // of slopes that have a sign: what the axis loses that leaves the span is left out
    if (std::abs(at.S_w) > least) RC_ASSERT((at.F_q > 0) == (at.S_w > 0));
  }));
}

TEST_CASE("fibre, definition: many states are the same as one by one") {
  const Fibre fibre({.008, .0157});
  std::vector<double> S, q;
  for (int i = 0; i < 300; ++i) {
    S.push_back(1 + 0.0005 * i);
    q.push_back(-0.5 + 0.005 * i);
  }
  const SlopeArrays at = fibre.states_slopes({S, q});
  for (std::size_t i = 0; i < S.size(); ++i) {
    const auto [state, d] = fibre.state_slopes(S[i], q[i]);
    CHECK(at.w[i] == state.w);
    CHECK(at.F[i] == state.F);
    CHECK(at.w_S[i] == d.w_S);
    CHECK(at.F_q[i] == d.F_q);
  }
}

TEST_CASE(
    "fibre, definition: a single tabulated state equals one of many, bit for bit, and the one at a known deflection "
    "equals the one by length") {
  for (const Supports& supports : {Supports{0, 0}, {0, .0157}, {.008, .0157}}) {
    const Fibre fibre(supports);
    std::vector<double> S, q;
    for (int i = 0; i < 200; ++i) {
      S.push_back(1.0002 + 0.003 * i);
      q.push_back(-0.5 + 0.012 * i);
    }
    const FibrePoints points(S, q);
    const SlopeArrays many = fibre.on_edges() ? fibre.states_slopes(points) : fibre.tabulated_states_slopes(points);
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (std::size_t i = 0; i < S.size(); ++i) {
      CAPTURE(S[i]);
      const auto one = fibre.tabulated_state_slopes(S[i], q[i]);
      CHECK((same(one.w, many.w[i]) && same(one.F, many.F[i]) && same(one.w_S, many.w_S[i])));
      CHECK((same(one.w_q, many.w_q[i]) && same(one.F_S, many.F_S[i]) && same(one.F_q, many.F_q[i])));
      const auto [state, d] = fibre.state_slopes(S[i], q[i]);
      const auto known = fibre.state_slopes(S[i], q[i], state.w);
      CHECK((same(known.state.F, state.F) && same(known.state.U, state.U) && same(known.slopes.Pn_S, d.Pn_S)));
    }
  }
}

TEST_CASE("fibre, bad input: supports that leave no span") {
  CHECK_THROWS_AS(Fibre({0.4, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(Fibre({-0.1, 0.1}), std::invalid_argument);
}

}  // namespace flexslip
