#include "contact/two_supports.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

namespace flexslip {
namespace {

constexpr double wavelength = 0.02;

Friction wavy(double mu0, double amplitude, double lambda, double phase) {
  return Friction::sinusoid(mu0, amplitude, lambda, phase);
}

double friction_of(const Friction& side, double x) { return side.at(1 + 2 * x).mu; }

struct Step {
  double S, mu;
  ContactPoints at;
};

// The slow, obvious way: the side with less friction goes one small step, again and again.
std::vector<Step> step_by_step(const Friction& left, const Friction& right, ContactPoints at, double S_to, double h) {
  const double direction = S_to > 1 + at.left + at.right ? 1 : -1;
  std::vector<Step> steps;
  bool right_goes = false;
  for (double S = 1 + at.left + at.right; direction * (S_to - S) > 0; S = 1 + at.left + at.right) {
    const double a = friction_of(left, at.left), b = friction_of(right, at.right);
    steps.push_back({S, std::min(a, b), at});
    constexpr double alike = 1e-10;
    if (std::abs(a - b) > alike) right_goes = b < a;  // over a crest of equal height the sliding side continues
    (right_goes ? at.right : at.left) += direction * h;
  }
  return steps;
}

struct Pair {
  std::string name;
  Friction left, right;
};

std::vector<Pair> pairs() {
  const Friction two_waves = Friction::waves(
      {.mu0 = 0.5, .drift = 0, .terms = {{0.2, wavelength, 1}, {0.1, 0.37 * wavelength, 2}}, .S_reference = 1});
  const Friction table =
      Friction::table({{1, 1.02, 1.05, 1.06, 1.11, 1.2, 1.4}, {0.5, 0.6, 0.45, 0.45, 0.62, 0.3, 0.6}});
  return {{"waves of two lengths", wavy(0.5, 0.2, wavelength, 1), wavy(0.52, 0.15, 0.77 * wavelength, 2.5)},
          {"one wave, two phases", wavy(0.5, 0.2, wavelength, 1), wavy(0.5, 0.2, wavelength, 4)},
          {"a wave and a lower constant", wavy(0.5, 0.2, wavelength, 1), Friction::constant(0.3)},
          {"a wave and a constant within it", wavy(0.5, 0.2, wavelength, 1), Friction::constant(0.55)},
          {"two waves and one", two_waves, wavy(0.48, 0.1, 0.6 * wavelength, 0)},
          {"a table and waves", table, two_waves},
          {"two tables", table, Friction::table({{1, 1.03, 1.08, 1.3}, {0.55, 0.4, 0.58, 0.5}})}};
}

}  // namespace

TEST_CASE("oracle: sliding in and then out, the weaker side slides, step by step") {
  constexpr double h = 2e-6, S_most = 1.25, turn = 1.17;
  for (const auto& [name, left, right] : pairs()) {
    CAPTURE(name);
    constexpr double steepest = 0.5 * 0.35 * 2 * 3.15 / (0.3 * wavelength);  // of all of them, along the fibre
    const TwoSupportPath in(left, right, {0, 0}, S_most);
    const TwoSupportPath out = in.from(turn);
    CHECK(out.origin() == doctest::Approx(turn).epsilon(1e-15));
    for (const bool inwards : {true, false}) {
      const TwoSupportPath& walk = inwards ? in : out;
      const auto steps =
          step_by_step(left, right, inwards ? ContactPoints{0, 0} : in.points_at(turn), inwards ? S_most : 1.001, h);
      double off = 0, aside = 0;
      for (std::size_t i = 0; i < steps.size(); i += 37) {
        off = std::max(off, std::abs(walk.at(steps[i].S).mu - steps[i].mu));
        const auto points = walk.points_at(steps[i].S);
        CHECK(1 + points.left + points.right == doctest::Approx(steps[i].S).epsilon(1e-14));
        aside += std::abs(points.left - steps[i].at.left) / static_cast<double>(steps.size()) * 37;
      }
      CAPTURE(inwards);
      CHECK(off < 2 * steepest * h);
      CHECK(aside < 100 * h);  // the other side by chance only at crests of one height
    }
  }
}

TEST_CASE("identity: what slides is at the friction of the fibre, and what rests is below its own") {
  for (const auto& [name, left, right] : pairs()) {
    CAPTURE(name);
    const TwoSupportPath walk(left, right, {0.01, -0.004}, 1.3);
    for (double S = 1; S < 1.3; S += 1.7e-4) {
      const auto [x, y] = walk.points_at(S);
      const double a = friction_of(left, x), b = friction_of(right, y), mu = walk.at(S).mu;
      CHECK(mu == doctest::Approx(std::min(a, b)).epsilon(1e-12));
    }
  }
}

TEST_CASE("identity: the slope agrees with the friction (central differences), except at the knots") {
  constexpr double h = 1e-6;
  for (const auto& [name, left, right] : pairs()) {
    CAPTURE(name);
    const TwoSupportPath walk(left, right, {0, 0}, 1.3);
    for (double S = 1.0003; S < 1.29; S += 1.37e-4) {
      const auto knot = std::lower_bound(walk.knots().begin(), walk.knots().end(), S - 2 * h);
      if (knot != walk.knots().end() && *knot < S + 2 * h) continue;
      CHECK(walk.at(S).slope ==
            doctest::Approx((walk.at(S + h).mu - walk.at(S - h).mu) / (2 * h)).epsilon(1e-4).scale(1));
    }
  }
}

TEST_CASE(
    "published: two sides with one wave look like half the wavelength, with the same mean, in any phase (MODEL 13)") {
  for (const double phase : {0.0, 0.7, 2.0, 3.1, 5.0}) {
    CAPTURE(phase);
    const TwoSupportPath walk(wavy(0.5, 0.2, wavelength, 0.4), wavy(0.5, 0.2, wavelength, 0.4 + phase), {0, 0}, 1.5);
    double mean = 0;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i) {
      const double S = 1.1 + wavelength * i / n;
      CHECK(walk.at(S + wavelength).mu ==
            doctest::Approx(walk.at(S).mu).epsilon(1e-6));  // of one side: 2 wavelengths in S
      mean += walk.at(S).mu / n;
    }
    CHECK(mean == doctest::Approx(0.5).epsilon(1e-3));
  }
}

TEST_CASE("identity: under a nose that holds the fibre both sides act by their mean, at knots of either") {
  const Friction drifting = Friction::waves({.mu0 = 0.3, .drift = -1.5, .terms = {{0.2, wavelength, 1}}});
  auto all = pairs();
  all.push_back({"a drift into zero and waves", drifting, all.front().left});
  for (const auto& [name, left, right] : all) {
    CAPTURE(name);
    const Friction mean = Friction::mean_of(left, right, 1.4);
    for (double S = 1; S < 1.4; S += 0.0037) {
      CHECK(mean.at(S).mu == 0.5 * (left.at(S).mu + right.at(S).mu));
      CHECK(mean.at(S).slope == 0.5 * (left.at(S).slope + right.at(S).slope));
      CHECK(mean.scaled(0.5).at(S).mu == 0.5 * mean.at(S).mu);
      CHECK(mean.at(S).mu <= mean.max_up_to(1.4));
    }
    for (const Friction* side : {&left, &right})
      for (const double knot : side->knots()) CHECK(mean.has_corner_at(knot));
  }
  const Friction held = Friction::mean_of(drifting, Friction::constant(0.3), 1.4);
  REQUIRE(held.knots().size() > 0);  // where the drift has carried one side below zero
  for (const double knot : held.knots()) CHECK(std::abs(drifting.without_limit(knot)) < 1e-12);
}

TEST_CASE("limit: rough sides look shorter along the fibre, smaller and lower than either alone") {
  const double length = 0.005;
  double mean = 0, square = 0, lag = 0, count = 0, side_square = 0, side_lag = 0;
  constexpr double apart = 0.25;  // of a length, along the fibre
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Friction left = Friction::rough(0.5, 0.2, length, seed, 2),
                   right = Friction::rough(0.5, 0.2, length, 100 + seed, 2);
    const TwoSupportPath walk(left, right, {0, 0}, 1.45);
    for (double S = 1.02; S < 1.4; S += 0.001) {
      const double d = walk.at(S).mu - 0.49, there = walk.at(S + 2 * apart * length).mu - 0.49;
      mean += walk.at(S).mu, square += d * d, lag += d * there, ++count;
      const double e = left.at(S).mu - 0.5, e_there = left.at(S + 2 * apart * length).mu - 0.5;
      side_square += e * e, side_lag += e * e_there;
    }
  }
  CHECK(mean / count < 0.5);
  CHECK(mean / count > 0.46);
  CHECK(square < side_square);
  CHECK(square > 0.4 * side_square);
  CHECK(1 - lag / square > 2 * (1 - side_lag / side_square));
}

TEST_CASE("limit: a symmetric pair whose friction falls goes one-sided") {
  const Friction falling = Friction::waves({.mu0 = 0.6, .drift = -0.5, .terms = {}, .S_reference = 1});
  const TwoSupportPath walk(falling, falling, {0, 0}, 1.3);
  for (double S = 1; S < 1.3; S += 0.01) {
    CHECK(walk.points_at(S).right == 0);
    CHECK(walk.at(S).mu == doctest::Approx(falling.at(1 + 2 * (S - 1)).mu).epsilon(1e-14));
    CHECK(walk.at(S).slope == doctest::Approx(-1).epsilon(1e-12));
  }
}

TEST_CASE("limit: a pair that rises alike stays alike, and shows the friction of one") {
  const Friction rising = Friction::waves({.mu0 = 0.3, .drift = 0.5, .terms = {}, .S_reference = 1});
  const TwoSupportPath walk(rising, rising, {0, 0}, 1.3);
  for (double S = 1; S < 1.3; S += 0.01) {
    CHECK(walk.points_at(S).left == doctest::Approx(walk.points_at(S).right).epsilon(1e-12));
    CHECK(walk.at(S).mu == doctest::Approx(rising.at(S).mu).epsilon(1e-14));
    CHECK(walk.at(S).slope == doctest::Approx(0.5).epsilon(1e-12));
  }
}

TEST_CASE("limit: a side that holds at all costs leaves the other alone") {
  const Friction side = wavy(0.5, 0.2, wavelength, 1);
  const TwoSupportPath walk(side, Friction::constant(5), {0, 0}, 1.3);
  for (double S = 1; S < 1.3; S += 0.0013) {
    CHECK(walk.points_at(S).right == 0);
    CHECK(walk.at(S).mu == doctest::Approx(friction_of(side, S - 1)).epsilon(1e-13));
  }
}

TEST_CASE("limit: a drift that runs into zero leaves knots where it does, and zero beyond") {
  const Friction falling =
      Friction::waves({.mu0 = 0.3, .drift = -3, .terms = {}, .S_reference = 1});  // 0 from x = 0.05
  const TwoSupportPath walk(falling, wavy(0.5, 0.2, wavelength, 1), {0, 0}, 1.3);
  const auto held = std::find_if(walk.knots().begin(), walk.knots().end(),
                                 [&](double S) { return std::abs(walk.points_at(S).left - 0.05) < 1e-12; });
  REQUIRE(held != walk.knots().end());
  CHECK(walk.at(*held + 0.01).mu == 0);
  CHECK(walk.at(*held - 1e-4).mu > 0);
}

TEST_CASE("limit: a walk may lead nowhere, and on from any length, let out to the straight fibre again and again") {
  const Friction left = wavy(0.5, 0.2, wavelength, 1), right = wavy(0.52, 0.15, 0.77 * wavelength, 2.5);
  CHECK(TwoSupportPath(left, right, {0, 0}, 1).at(1).mu == TwoSupportPath(left, right, {0, 0}, 1.1).at(1).mu);
  for (int i = 1; i < 400; ++i) {
    TwoSupportPath walk(left, right, {0, 0}, 1.3);
    for (const double turn : {1 + 0.0007 * i, 1.0, 1.25, 1.0, 1.3, 1.0}) walk = walk.from(turn);
    CHECK(walk.origin() == 1);
    CHECK(std::abs(walk.points_at(1).left + walk.points_at(1).right) < 1e-14);
  }
}

TEST_CASE("limit: beyond its ends a walk is constant, and it is refused where there is none") {
  const Friction side = wavy(0.5, 0.2, wavelength, 1);
  const TwoSupportPath walk(side, side, {0, 0}, 1.1);
  CHECK(walk.at(1.2).mu == walk.at(1.1).mu);
  CHECK(walk.at(1.2).slope == 0);
  CHECK(walk.at(0.9).mu == walk.at(1).mu);
  CHECK_THROWS_AS(TwoSupportPath(side, side, {0, 0}, 0.9), std::invalid_argument);
  CHECK_THROWS_AS(TwoSupportPath(side, side, {-0.1, 0}, 1.1), std::invalid_argument);
  CHECK_THROWS_AS(TwoSupportPath(Friction::on_two_supports(side, side, 1.2), side, {0, 0}, 1.1), std::invalid_argument);
}

}  // namespace flexslip
