#include "contact/friction.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/elementary.h"
#include "tests/fibre/instruction_sets.h"
#include "tests/generators.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void refused(const std::string& what, const std::string& value, const std::function<void()>& call) {
  try {
    call();
    FAIL_CHECK("not refused: ", what, " ", value);
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    INFO("message: ", message);
    CHECK(message.find(what) != std::string::npos);
    CHECK(message.find(value) != std::string::npos);
  }
}

Friction some_waves() {
  return Friction::waves(
      {.mu0 = 0.5, .drift = -0.2, .terms = {{0.3, 0.013, 1.0}, {0.2, 0.0217, -0.4}, {0.05, 0.2, 3.0}}});
}
Friction some_table() { return Friction::table({{1.0, 1.02, 1.1, 1.15, 1.3, 1.31}, {0.4, 0.7, 0.7, 0.2, 0.25, 0.0}}); }

// The slope against a difference over h, to the size of μ''' h^2 and to rounding.
void slope_is_that_of_mu(const Friction& friction, double S, double h, double third) {
  const double difference = (friction.at(S + h).mu - friction.at(S - h).mu) / ((S + h) - (S - h));
  CAPTURE(S);
  CHECK(std::abs(friction.at(S).slope - difference) <= third * h * h / 6 + 8 * unit / h);
}

}  // namespace

TEST_CASE("friction: no length has more friction than the maximum (identity)") {
  const auto holds = [](const Friction& friction, double S_max) {
    const double most = friction.max_up_to(S_max);
    for (int i = 0; i <= 1000; ++i)
      // The rounding of a sum of some terms, and of a cubic between equal values.
      RC_ASSERT(friction.at(1 + (S_max - 1) * i / 1000).mu <= most * (1 + 16 * unit));
  };
  CHECK(rc::check("waves with a drift and a reference", [&] {
    const double mu0 = *between(0, 2);
    holds(Friction::waves({.mu0 = mu0,
                           .drift = *between(-5, 5),
                           .terms = {{*between(0, 0.6), *between(0.01, 0.5), 1}, {*between(0, 0.4), 0.0217, 2}},
                           .S_reference = *between(0.9, 3)}),
          *between(1, 3));
  }));
  CHECK(rc::check("tables", [&] { holds(some_table(), *between(1, 1.5)); }));
  CHECK(some_table().max_up_to(1.05) == 0.7);
  CHECK(Friction::table({{0.9, 1.0, 1.1}, {5, 0.4, 0.5}}).max_up_to(1.2) ==
        0.5);  // what lies below the span is not met
  // Attained, by a drift alone: at the end that it rises to.
  const auto drifting = [](double drift, double S_reference) {
    return Friction::waves({.mu0 = 0.3, .drift = drift, .terms = {}, .S_reference = S_reference});
  };
  CHECK(drifting(2, 1.25).max_up_to(1.5) == 0.8);
  CHECK(drifting(-2, 1.25).max_up_to(1.5) == 0.8);
  CHECK(drifting(2, 1.25).max_up_to(1) == 0);  // held at zero
}

TEST_CASE("friction: constant (identity)") {
  const auto friction = Friction::constant(0.37);
  for (const double S : {1.0, 1.5, 100.0}) {
    CHECK(friction.at(S).mu == 0.37);
    CHECK(friction.at(S).slope == 0);
  }
  CHECK(std::isinf(friction.smooth_scale()));
  CHECK(friction.knots().empty());
  CHECK(Friction::constant(0).at(1.2).mu == 0);
}

TEST_CASE("friction: mu0 (1 + A cos(pi S/lambda + phi)) (paper, (4.25))") {
  const double mu0 = 0.6, A = 0.4, lambda = 0.02 * std::numbers::pi;
  const auto friction = Friction::sinusoid(mu0, A, lambda, 0.0);
  for (const double S : {1.0, 1.0371, 1.1, 1.4}) {
    const double argument = 8 * unit * S / 0.02;  // its rounding
    CHECK(std::abs(friction.at(S).mu - 0.6 * (1 + 0.4 * std::cos(S / 0.02))) <= mu0 * A * argument + 4 * unit);
    CHECK(std::abs(friction.at(S).slope + 0.6 * 0.4 / 0.02 * std::sin(S / 0.02)) <=
          mu0 * A / 0.02 * (argument + 4 * unit));
  }
  // A wave of length λ along the fibre has the period 2 λ in S, and is shifted by the phase.
  CHECK(friction.at(1.1).mu == doctest::Approx(friction.at(1.1 + 2 * lambda).mu).epsilon(1e-13));
  const auto shifted = Friction::sinusoid(mu0, A, lambda, std::numbers::pi);
  CHECK(shifted.at(1.1).mu == doctest::Approx(friction.at(1.1 + lambda).mu).epsilon(1e-13));
  CHECK(friction.smooth_scale() == doctest::Approx(2 * lambda / 4).epsilon(4 * unit));
}

TEST_CASE("friction: waves and drift add up (identity)") {
  const auto friction = some_waves();
  const auto first = Friction::sinusoid(0.5, 0.3, 0.013, 1.0), second = Friction::sinusoid(0.5, 0.2, 0.0217, -0.4),
             third = Friction::sinusoid(0.5, 0.05, 0.2, 3.0);
  for (const double S : {1.0, 1.05, 1.111, 1.2}) {
    const double sum = first.at(S).mu + second.at(S).mu + third.at(S).mu - 2 * 0.5 - 0.2 * (S - 1);
    CHECK(friction.at(S).mu == doctest::Approx(sum).epsilon(16 * unit));
    CHECK(friction.at(S).slope ==
          doctest::Approx(first.at(S).slope + second.at(S).slope + third.at(S).slope - 0.2).epsilon(1e-13));
  }
  CHECK(friction.smooth_scale() == doctest::Approx(0.013 / 2).epsilon(4 * unit));  // of the shortest
}

TEST_CASE("friction: the slope agrees with mu, in every form (oracle: central differences)") {
  const auto waves = some_waves();
  const auto table = some_table();
  const auto rough = Friction::rough(0.5, 0.2, 0.01, 3, 1.5);
  const double third_of_waves = 0.5 * 0.3 * std::pow(std::numbers::pi / 0.013, 3) * 2;
  for (int i = 0; i < 200; ++i) {
    const double S = 1.0007 + 0.4 * i / 200;
    slope_is_that_of_mu(Friction::constant(0.4), S, 1e-5, 0);
    slope_is_that_of_mu(Friction::sinusoid(0.5, 0.3, 0.013, 1), S, 1e-6, third_of_waves);
    slope_is_that_of_mu(waves, S, 1e-6, third_of_waves);
    const auto away_from_knots = [&](const Friction& friction, double h) {  // where the second derivative jumps
      const auto knots = friction.knots();
      return std::none_of(knots.begin(), knots.end(), [&](double knot) { return std::abs(knot - S) <= h; });
    };
    if (away_from_knots(table, 1e-6)) slope_is_that_of_mu(table, S, 1e-6, 12 * 0.3 / std::pow(0.01, 3));
    if (away_from_knots(rough, 1e-7)) slope_is_that_of_mu(rough, S, 1e-7, 12 * 1.0 / std::pow(0.0025, 3));
  }
}

TEST_CASE("friction: a table is exact at its knots, smooth across them and constant beyond (identity)") {
  const FrictionTable given{{1.0, 1.02, 1.1, 1.15, 1.3, 1.31}, {0.4, 0.7, 0.7, 0.2, 0.25, 0.0}};
  const auto friction = Friction::table(given);
  for (std::size_t i = 0; i < given.S.size(); ++i) {
    CHECK(friction.at(given.S[i]).mu == given.mu[i]);
    if (i == 0 || i + 1 == given.S.size()) continue;
    const double before = friction.at(given.S[i] * (1 - unit)).slope,
                 after = friction.at(given.S[i] * (1 + unit)).slope;
    CHECK(before == doctest::Approx(after).epsilon(1e-9));  // slopes vary by 1e5 a unit of S at most
  }
  CHECK(friction.at(1.5).mu == 0.0);
  CHECK(friction.at(1.5).slope == 0);
  CHECK(friction.knots().size() == given.S.size());
  CHECK(std::isinf(friction.smooth_scale()));

  const auto late = Friction::table({{1.2, 1.4}, {0.3, 0.5}});  // two knots: a straight line
  CHECK(late.at(1.0).mu == 0.3);
  CHECK(late.at(1.3).mu == doctest::Approx(0.4).epsilon(4 * unit));
  CHECK(late.at(1.3).slope == doctest::Approx(1.0).epsilon(8 * unit));
  CHECK(Friction::table({{1.1}, {0.3}}).at(1.3).mu == 0.3);
}

TEST_CASE("friction: a table is monotone between knots and never overshoots them (identity)") {
  CHECK(rc::check("random tables", [] {
    FrictionTable given;
    double S = 1;
    const int n = *whole(2, 12);
    for (int i = 0; i < n; ++i) {
      S += std::pow(10, *between(-4, 0));
      given.S.push_back(S);
      given.mu.push_back(*whole(0, 3) == 0 ? 0.0 : *between(0, 1.5));
    }
    const auto friction = Friction::table(given);
    for (std::size_t i = 0; i + 1 < given.S.size(); ++i) {
      const double rise = given.mu[i + 1] - given.mu[i];
      const double least = std::min(given.mu[i], given.mu[i + 1]), most = std::max(given.mu[i], given.mu[i + 1]);
      const double width = given.S[i + 1] - given.S[i];
      double before = given.mu[i];
      for (int j = 0; j <= 50; ++j) {
        const auto [mu, slope] = friction.at(std::min(given.S[i] + width * j / 50, given.S[i + 1]));
        RC_ASSERT(mu >= least - 8 * unit && mu <= most + 8 * unit && mu >= 0);
        RC_ASSERT((mu - before) * rise >= -8 * unit * std::abs(rise));
        RC_ASSERT(slope * rise >= -64 * unit * rise * rise / width);
        before = mu;
      }
    }
  }));
}

TEST_CASE("friction: cubic tables reproduce straight lines (identity)") {
  CHECK(rc::check("random knots on a line", [] {
    const double at_1 = *between(0.1, 1), slope = *between(0, 2);
    FrictionTable given;
    double S = 1;
    for (int i = 0; i < 8; ++i) {
      given.S.push_back(S);
      given.mu.push_back(at_1 + slope * (S - 1));
      S += *between(0.01, 0.2);
    }
    const auto friction = Friction::table(given);
    const double where = *between(1, given.S.back());
    RC_ASSERT(std::abs(friction.at(where).mu - (at_1 + slope * (where - 1))) <= 16 * unit * (at_1 + slope));
  }));
}

TEST_CASE("friction: an invalid friction is refused, and the message says what is wrong (contract)") {
  refused("mu0", "-0.1", [] { Friction::constant(-0.1); });
  refused("mu0", "nan", [] { Friction::constant(nan); });
  refused("mu0", "inf", [] { Friction::constant(infinity); });
  refused("amplitude", "-0.2", [] { Friction::sinusoid(0.5, -0.2, 0.01, 0); });
  refused("amplitude", "nan", [] { Friction::sinusoid(0.5, nan, 0.01, 0); });
  refused("negative", "1.01", [] { Friction::sinusoid(0.5, 1.01, 0.01, 0); });
  refused("negative", "1.2", [] {
    Friction::waves({.mu0 = 0.5, .drift = 0, .terms = {{0.7, 0.01, 0}, {0.5, 0.02, 0}}});
  });
  refused("wavelength", "0.0", [] { Friction::sinusoid(0.5, 0.2, 0, 0); });
  refused("wavelength", "-0.01", [] { Friction::sinusoid(0.5, 0.2, -0.01, 0); });
  refused("wavelength", "nan", [] { Friction::sinusoid(0.5, 0.2, nan, 0); });
  refused("wavelength", "0.9", [] { Friction::sinusoid(0.5, 0.2, 0.9e-12, 0); });
  refused("wavelength", "inf", [] { Friction::sinusoid(0.5, 0.2, infinity, 0); });
  refused("phase", "inf", [] { Friction::sinusoid(0.5, 0.2, 0.01, infinity); });
  refused("reference", "inf", [] { Friction::waves({.mu0 = 0.5, .drift = 0, .terms = {}, .S_reference = infinity}); });
  refused("drift", "nan", [] { Friction::waves({.mu0 = 0.5, .drift = nan, .terms = {}}); });
  refused("table", "0", [] { Friction::table({{}, {}}); });
  refused("table", "3", [] { Friction::table({{1.0, 1.1, 1.2}, {0.5, 0.5}}); });
  refused("table", "-0.3", [] { Friction::table({{1.0, 1.1}, {0.5, -0.3}}); });
  refused("table", "nan", [] { Friction::table({{1.0, 1.1}, {0.5, nan}}); });
  refused("length", "nan", [] { Friction::table({{1.0, nan}, {0.5, 0.5}}); });
  refused("rise", "1.1", [] { Friction::table({{1.0, 1.1, 1.1}, {0.5, 0.5, 0.5}}); });
  refused("rise", "1.05", [] { Friction::table({{1.0, 1.1, 1.05}, {0.5, 0.5, 0.5}}); });
  refused("roughness", "-0.1", [] { Friction::rough(0.5, -0.1, 0.01, 1, 1.5); });
  refused("correlation", "0.0", [] { Friction::rough(0.5, 0.1, 0, 1, 1.5); });
  refused("correlation", "inf", [] { Friction::rough(0.5, 0.1, infinity, 1, 1.5); });
  refused("rough profile", "1.0", [] { Friction::rough(0.5, 0.1, 0.01, 1, 1.0); });
  refused("friction", "-0.5", [] { Friction::rough(-0.5, 0.1, 0.01, 1, 1.5); });
}

TEST_CASE("friction: never negative, to the last amplitude (limit)") {
  CHECK(rc::check("amplitudes that add up to 1", [] {
    const double a = *between(0, 1);
    const auto friction = Friction::waves(
        {.mu0 = *between(0, 1), .drift = 0, .terms = {{a, *between(0.01, 0.1), 0.3}, {1 - a, *between(0.01, 0.1), 2}}});
    for (int i = 0; i < 200; ++i) RC_ASSERT(friction.at(1 + 0.003 * i).mu >= 0);
  }));
}

TEST_CASE("friction: zero, and level, where a falling drift would carry it below (limit)") {
  const auto friction = Friction::waves({.mu0 = 0.5, .drift = -0.4, .terms = {{0.2, 0.01, 0}}});
  int zeros = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double S = 1 + 2.0 * i / 20000;
    const double unlimited = 0.5 * (1 + 0.2 * std::cos(std::numbers::pi * S / 0.01)) - 0.4 * (S - 1);
    const auto [mu, slope] = friction.at(S);
    CHECK(mu == doctest::Approx(std::max(unlimited, 0.0)).scale(1).epsilon(1e-12));  // the argument, 1e3, to rounding
    if (mu == 0) CHECK(slope == 0);
    zeros += mu == 0;
  }
  CHECK(zeros > 5000);
  CHECK(Friction::waves({.mu0 = 0, .drift = -1, .terms = {}}).at(1.5).mu == 0);
}

TEST_CASE("friction: the drift turns about the length of reference (identity)") {
  const auto about_start = Friction::waves({.mu0 = 0.5, .drift = 0.3, .terms = {}});
  const auto about_middle = Friction::waves({.mu0 = 0.56, .drift = 0.3, .terms = {}, .S_reference = 1.2});
  for (const double S : {1.0, 1.2, 1.5}) {
    CHECK(about_start.at(S).mu == doctest::Approx(about_middle.at(S).mu).epsilon(8 * unit));
    CHECK(about_start.at(S).slope == about_middle.at(S).slope);
  }
}

TEST_CASE("friction: the same seed gives the same roughness, bit for bit (identity)") {
  const auto first = Friction::rough(0.5, 0.2, 0.01, 42, 1.5), second = Friction::rough(0.5, 0.2, 0.01, 42, 1.5);
  const auto other = Friction::rough(0.5, 0.2, 0.01, 43, 1.5);
  const auto& a = std::get<FrictionTable>(first.form()).mu;
  CHECK(a == std::get<FrictionTable>(second.form()).mu);
  CHECK(a != std::get<FrictionTable>(other.form()).mu);
  const auto longer = Friction::rough(0.5, 0.2, 0.01, 42, 1.8);
  CHECK(longer.knots().back() >= 1.8);
  CHECK(first.knots()[1] - first.knots()[0] ==
        doctest::Approx(2 * 0.01 / 8).epsilon(1e-12));  // eight a length along the fibre
}

TEST_CASE("friction: roughness has the mean, spread and correlation promised (oracle: statistics of a long sample)") {
  const double mu0 = 0.5, rms = 0.3, length = 0.001;
  const auto friction =
      Friction::rough(mu0, rms, length, 20210829, 21.0);  // 10 000 correlation lengths along the fibre
  const auto& mu = std::get<FrictionTable>(friction.form()).mu;
  const auto n = mu.size();
  REQUIRE(n >= 80000);
  std::vector<double> g(n);  // the Gaussian back
  for (std::size_t i = 0; i < n; ++i) g[i] = std::log(mu[i] / mu0) + 0.5 * rms * rms;
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < n; ++i) sum += g[i] * g[i + lag];
    return sum / static_cast<double>(n - lag);
  };
  double mean = 0, mean_mu = 0;
  for (std::size_t i = 0; i < n; ++i) {
    mean += g[i] / static_cast<double>(n);
    mean_mu += mu[i] / static_cast<double>(n);
  }
  // Independent pieces are √(2π) correlation lengths long: 4 000 of them, so a standard error of rms/63; four of these.
  const double four_errors = 4 * rms / 63;
  CHECK(std::abs(mean) <= four_errors);
  CHECK(std::abs(mean_mu - mu0) <= four_errors * mu0);
  CHECK(std::abs(std::sqrt(covariance(0)) - rms) <= four_errors);
  for (const std::size_t lag : {4u, 8u, 12u, 16u}) {  // eight steps are a correlation length
    const double x = static_cast<double>(lag) / 8;
    CHECK(std::abs(covariance(lag) / (rms * rms) - std::exp(-x * x / 2)) <= 4.0 / 63);
  }
  CHECK(std::abs(covariance(40) / (rms * rms)) <= 4.0 / 63);
}

TEST_CASE("friction: without roughness, rough is constant (limit)") {
  const auto friction = Friction::rough(0.5, 0, 0.01, 1, 1.5);
  for (const double S : {1.0, 1.123, 1.5}) CHECK(friction.at(S).mu == doctest::Approx(0.5).epsilon(4 * unit));
}

TEST_CASE("friction: many lengths at once have the bits of one, on every instruction set (identity)") {
  const auto sums = Friction::waves({.mu0 = 0.5,
                                     .drift = -0.7,
                                     .terms = {{0.4, 0.0123, 1.0}, {0.3, 0.07, -40.0}, {0.1, 1e-5, 0.3}},
                                     .S_reference = 1.1});
  const auto table = Friction::table({{1.0, 1.2, 1.3, 1.9}, {0.3, 0.6, 0.1, 0.5}});
  std::vector<double> S;
  for (int i = 0; i < 1003; ++i) S.push_back(1 + 0.001 * i);
  for (const Friction& friction : {sums, table, Friction::constant(0.4)})
    on_each_instruction_set([&] {
      const FrictionArrays all = friction.at(S);
      for (std::size_t i = 0; i < S.size(); ++i) {
        CHECK(all.mu[i] == friction.at(S[i]).mu);
        CHECK(all.slope[i] == friction.at(S[i]).slope);
      }
    });
}

}  // namespace flexslip
