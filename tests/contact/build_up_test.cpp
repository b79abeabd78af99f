#include "contact/build_up.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <doctest/doctest.h>

#include "bending_test/history.h"

namespace flexslip {
namespace {

constexpr double sigma = 0.004;

Friction building_up(const Friction& friction, double length = sigma) {
  return Friction::path_dependent(std::make_shared<const BuildUp>(friction, length, 1.6));
}

// p' = (μ - p)/σ by many small steps of Heun's.
double stepped(const Friction& along, double S_from, double p, double S_to) {
  const double direction = S_to > S_from ? 1 : -1, way = std::abs(S_to - S_from);
  const int steps = static_cast<int>(std::ceil(way / (1e-3 * sigma)));
  const double h = way / steps;
  for (int i = 0; i < steps; ++i) {
    const double S = S_from + direction * h * i;
    const double first = (along.at(S).mu - p) / sigma;
    const double second = (along.at(S + direction * h).mu - p - h * first) / sigma;
    p += 0.5 * h * (first + second);
  }
  return p;
}

void is_as_stepped(const Friction& along) {
  const Friction in = building_up(along);
  CHECK(in.at(1).mu == doctest::Approx(along.at(1).mu).epsilon(1e-12));
  for (const double S : {1.001, 1.0137, 1.2})
    CHECK(in.at(S).mu == doctest::Approx(stepped(along, 1, along.at(1).mu, S)).epsilon(1e-6));
  const double q = in.at(1.2).mu;
  const Friction out = in.from(1.2, q, -1);
  CHECK(out.at(1.2).mu == doctest::Approx(-q).epsilon(1e-14));
  for (const double S : {1.199, 1.1871, 1.02})
    CHECK(out.at(S).mu == doctest::Approx(stepped(along, 1.2, -q, S)).epsilon(1e-6));
  for (const Friction& way : {in, out})
    for (const double S : {1.0037, 1.05, 1.1999}) {
      const double d = 1e-6;
      CHECK(way.at(S).slope == doctest::Approx((way.at(S + d).mu - way.at(S - d).mu) / (2 * d)).epsilon(1e-5));
    }
}

}  // namespace

TEST_CASE("build up, oracle: waves, a drift, tables and friction held at zero are as stepped, in and out") {
  is_as_stepped(Friction::waves({.mu0 = 0.5, .drift = 0.3, .terms = {{0.3, 0.0085, 1}, {0.1, 0.02, -2}}}));
  is_as_stepped(Friction::rough(0.5, 0.2, 0.004, 1, 1.6));
  is_as_stepped(Friction::waves({.mu0 = 0.3, .drift = -3, .terms = {{0.3, 0.03, 1}}}));
}

TEST_CASE("build up, limit: constant friction falls to its negative as an exponential once it is turned back") {
  const Friction out = building_up(Friction::constant(0.4)).from(1.3, 0.4, -1);
  for (const double way : {0.0, 0.001, 0.01, 0.1})
    CHECK(out.at(1.3 - way).mu == doctest::Approx(0.4 - 0.8 * std::exp(-way / sigma)).epsilon(1e-13));
}

TEST_CASE("build up, published number: of a wave of 10 um, 2.5 um leave 0.7864, lagging by 38 degrees") {
  CHECK(share_after_build_up(2.5, 10) == doctest::Approx(0.7864).epsilon(1e-4));
  const Friction in = building_up(Friction::sinusoid(0.5, 0.2, 4 * sigma, 0));
  double crest = 1.4;
  for (double S = 1.4; S < 1.4 + 8 * sigma; S += 1e-3 * sigma)
    if (in.at(S).mu > in.at(crest).mu) crest = S;
  CHECK(in.at(crest).mu == doctest::Approx(0.5 * (1 + 0.2 * 0.7864)).epsilon(1e-4));
  const double lag = std::numbers::pi * crest / (4 * sigma);
  CHECK(std::fmod(lag, 2 * std::numbers::pi) * 180 / std::numbers::pi == doctest::Approx(38).epsilon(0.01));
}

TEST_CASE("build up, identity: of a programme back and forth, thick or not, all energy is accounted for") {
  const std::vector<double> programme{0, 0.5, 0.3, 0.55, 0.04, 0.3, 0, 0.6, 0.45, 0.6};
  for (const Supports& supports : {Supports{0, 0}, Supports{0, 0.0136}, Supports{0, 0.06}})
    for (const Friction& friction : {Friction::sinusoid(0.5, 0.3, 0.03, 1), Friction::rough(0.4, 0.2, 0.01, 3, 2)}) {
      const Fibre fibre(supports);
      const Friction builds = Friction::path_dependent(std::make_shared<const BuildUp>(friction, sigma, 2.0));
      const History history = follow_continuously({builds, {100, fibre}}, programme, 40);
      REQUIRE(history.status == HistoryStatus::ok);
      const EnergyAccount& energy = history.energy;
      const double stored = energy.bending + energy.load_train;
      CHECK(energy.stage_work == doctest::Approx(stored + energy.friction + energy.snaps).epsilon(1e-10));
      bool sticks = false;
      for (const PathPoint& point : history.path) sticks = sticks || (point.motion == Motion::stick && point.S > 1.01);
      CHECK_FALSE(sticks);
    }
}

TEST_CASE("build up, limit: over a length of a hundred thousandth of the span a loop is that of Coulomb's friction") {
  const Friction friction = Friction::sinusoid(0.5, 0.2, 0.05, 1);
  const Rig rig{200, Fibre()};
  const std::vector<double> stages{0, 0.2, 0.4, 0.3, 0.25, 0.35, 0.5};
  const History sharp = follow_in_steps({friction, rig}, stages);
  const History built = follow_in_steps({building_up(friction, 1e-5), rig}, stages);
  REQUIRE(built.path.size() == sharp.path.size());
  for (std::size_t i = 0; i < sharp.path.size(); ++i)
    CHECK(built.path[i].F == doctest::Approx(sharp.path[i].F).epsilon(2e-3));
}

TEST_CASE("build up, contract: no length, none on two supports, and one too short for what it follows are refused") {
  CHECK_THROWS_AS(building_up(Friction::constant(0.4), 0), std::invalid_argument);
  CHECK_THROWS_AS(building_up(Friction::on_two_supports(Friction::constant(0.4), Friction::constant(0.5), 1.5)),
                  std::invalid_argument);
  CHECK_THROWS_AS(building_up(Friction::rough(0.4, 0.1, 0.01, 1, 2), 1e-6), std::invalid_argument);
}

}  // namespace flexslip
