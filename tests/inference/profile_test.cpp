#include "inference/profile.h"

#include <cmath>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "inference/slips.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

constexpr double lambda = 12.0 / 1278;

Friction toothed() { return Friction::sinusoid(0.6, 0.3, lambda, 1.0); }

Drop drop_between(std::size_t before, std::size_t after) { return {before, after, 0, 0, 0, 0}; }

TEST_CASE("identity: the profile of a loading without noise is the friction it was made with") {
  const auto record = simulated_record({.friction = toothed()});
  const auto profile = measure_friction(record, {90}, {0, 0, 0});
  REQUIRE(profile.points.size() > 200);
  CHECK(profile.unexplained.empty());
  for (const auto& point : profile.points)
    // The inverse loses the digits that the force does not carry: ulp(F)/(dF/dμ), below 1e-12 from w = 0.02 on.
    CHECK(point.mu == doctest::Approx(toothed().at(point.S).mu).scale(0).epsilon(1e-11));
}

TEST_CASE(
    "oracle: the parts of the error are differences of the inverse under a small change of force, stiffness, contact") {
  const double k = 90;
  const auto record = simulated_record({.friction = toothed()});
  const MeasurementErrors errors{.force = 1e-5, .bending_stiffness = 1e-5, .contact = 1e-7};
  const auto profile = measure_friction(record, {k}, errors);
  for (std::size_t i = 0; i < profile.points.size(); i += 17) {
    const auto& point = profile.points[i];
    const double w = record.deflection[point.index];
    const double F = record.force[point.index];
    const auto mu = [](double deflection, double force) { return fibre_state_from_force(deflection, force).q; };
    // one-sided differences: their truncation is of the relative order of the change itself, 1e-5 times a curvature of order 1/w
    const double tolerance = 1e-3;
    CHECK(point.from_force ==
          doctest::Approx(std::abs(mu(w - 1e-5 / k, F + 1e-5) - point.mu)).scale(0).epsilon(tolerance));
    CHECK(point.from_bending_stiffness ==
          doctest::Approx(std::abs(mu(w, F / (1 + 1e-5)) - point.mu)).scale(0).epsilon(tolerance));
    CHECK(point.from_contact == doctest::Approx(std::abs(mu(w + 1e-7, F) - point.mu)).scale(0).epsilon(tolerance));
  }
}

TEST_CASE("identity: slips of a periodic roughness are one wavelength apart along the fibre") {
  const auto record = simulated_record({.friction = toothed()});
  const auto profile = measure_friction(record, {90}, {0, 0, 0});
  std::vector<Drop> drops;
  for (std::size_t i = 1; i < record.force.size(); ++i)
    if (record.force[i] < record.force[i - 1] - 0.05) drops.push_back(drop_between(i - 1, i));
  const auto slips = slips_of(profile, drops, {0, 0, 0}, 1);
  REQUIRE(slips.size() >= 5);
  // A stage step advances the slip by about a micron: the fold is known to that.
  CHECK(summarise(slips).median_spacing == doctest::Approx(lambda).scale(0).epsilon(0.1));
  CHECK(summarise(slips).median_fall > 0);
  CHECK(summarise(slips).median_fall < 2 * 0.3 * 0.6);
}

TEST_CASE("limit: each drop that can be no slip says why") {
  const ProfilePoint usual{.index = 0,
                           .S = 1.1,
                           .length = 1.1,
                           .imaged = 1.1,
                           .mu = 0.6,
                           .from_force = 0.01,
                           .from_bending_stiffness = 0,
                           .from_contact = 0,
                           .S_force = 0.01};
  const auto verdict = [&](double mu_before, double S_after, double mu_after) {
    FrictionProfile profile{{usual, usual}, {}};
    profile.points[0].mu = mu_before;
    profile.points[1].index = 1;
    profile.points[1].S = S_after;
    profile.points[1].mu = mu_after;
    const std::vector<Drop> drops{drop_between(0, 1)};
    return slips_of(profile, drops, {.force = 0.05, .bending_stiffness = 0, .contact = 0}, 1)[0].verdict;
  };
  CHECK(verdict(0.6, 1.11, 0.4) == SlipVerdict::possible);
  CHECK(verdict(1.01, 1.11, 0.4) == SlipVerdict::possible);  // within its error
  CHECK(verdict(1.05, 1.11, 0.4) == SlipVerdict::implausible);
  CHECK(verdict(0.6, 1.11, -0.1) == SlipVerdict::negative);
  CHECK(verdict(0.6, 1.09, 0.4) == SlipVerdict::moves_out);
  CHECK(verdict(0.6, 1.1005, 0.4) == SlipVerdict::too_short);
  const std::vector<Drop> elsewhere{drop_between(3, 4)};
  CHECK(slips_of({{usual}, {}}, elsewhere, {0.05, 0, 0}, 1)[0].verdict == SlipVerdict::unexplained);
}

TEST_CASE("identity: the measured profile as a table, run forward, gives the curve back, drops included") {
  const Rig rig{90};
  const auto record = simulated_record({.friction = toothed(), .noise = 0.005});
  const auto profile = measure_friction(record, rig, {0.005, 0, 0});
  std::vector<Drop> drops;
  for (std::size_t i = 1; i < record.force.size(); ++i)
    if (record.force[i] < record.force[i - 1] - 0.05) drops.push_back(drop_between(i - 1, i));
  const Friction table = Friction::table(replay_table(record, rig, profile, drops));
  std::vector<double> stages(record.stage.begin(), record.stage.end());
  const auto replay = follow_in_steps({table, rig}, stages);
  REQUIRE(replay.status == HistoryStatus::ok);
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (record.deflection[i] > 0.1) CHECK(std::abs(replay.path[i].F - record.force[i]) < 1e-3);  // a fifth of the noise
}

TEST_CASE("limit: a curve above the limit of friction is suspect, one below is not") {
  for (const double mu : {0.6, 1.2}) {
    const auto record = simulated_record({.friction = Friction::constant(mu)});
    const auto profile = measure_friction(record, {90}, {0.01, 0.03, 0});
    const auto report = find_suspects(record, profile, 1.0);
    CHECK(report.suspect == (mu > 1));
    CHECK(report.points.empty() == (mu < 1));
    CHECK(report.above_euler_bernoulli > 0);  // in the model itself F exceeds 48 w
  }
}

TEST_CASE("limit: a negative force is explained by no friction and listed") {
  const ReducedRecord record{{0.1, 0.2}, {0.1, 0.2}, {-1.0, 8.0}};
  const auto profile = measure_friction(record, {90}, {0, 0, 0});
  REQUIRE(profile.unexplained.size() == 1);
  CHECK(profile.unexplained.front() == 0);
  CHECK(profile.points.size() == 1);
}

}  // namespace
}  // namespace flexslip
