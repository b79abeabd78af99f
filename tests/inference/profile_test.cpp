#include "inference/profile.h"

#include <cmath>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "tests/inference/toothed.h"

namespace flexslip {
namespace {

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

TEST_CASE("identity: the measured profile as a table, run forward, gives the curve back, drops included") {
  const Rig rig{90};
  const auto record = simulated_record({.friction = toothed(), .noise = 0.005});
  const auto profile = measure_friction(record, rig, {0.005, 0, 0});
  const std::vector<Drop> drops = plain_drops(record);
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
