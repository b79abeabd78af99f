#include <doctest/doctest.h>

#include "inference/profile.h"
#include "tests/inference/toothed.h"

namespace flexslip {
namespace {

TEST_CASE("identity: slips of a periodic roughness are one wavelength apart along the fibre") {
  const auto record = simulated_record({.friction = toothed()});
  const auto profile = measure_friction(record, {90}, {0, 0, 0});
  const std::vector<Drop> drops = plain_drops(record);
  const auto slips = slips_of(profile, drops, {0, 0, 0}, 1);
  REQUIRE(slips.size() >= 5);
  // A stage step advances the slip by about a micron: the fold is known to that.
  CHECK(summarise(slips).median_spacing == doctest::Approx(tooth_wavelength).scale(0).epsilon(0.1));
  CHECK(summarise(slips).median_fall > 0);
  CHECK(summarise(slips).median_fall < 2 * 0.3 * 0.6);
}

TEST_CASE(
    "identity: every drop of a specimen that cracks at constant friction can be a crack; most of one that slips, whose "
    "force comes back, cannot") {
  const auto cracks = [](const ReducedRecord& record) {
    const MeasurementErrors errors{.force = 0.01, .bending_stiffness = 0, .contact = 0};
    std::size_t count = 0, all = 0;
    for (const Slip& slip : slips_of(measure_friction(record, {90}, errors), plain_drops(record), errors, 1)) {
      ++all;
      count += slip.can_be_crack ? 1 : 0;
    }
    REQUIRE(all >= 3);
    return static_cast<double>(count) / static_cast<double>(all);
  };
  CHECK(cracks(simulated_record({.friction = Friction::constant(0.5)}, six_cracks)) == 1);
  CHECK(cracks(simulated_record({.friction = toothed()})) < 0.5);
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
  CHECK(slips_of({{usual}, {4}}, elsewhere, {0.05, 0, 0}, 1)[0].verdict == SlipVerdict::unexplained);
  CHECK(slips_of({{usual}, {}}, elsewhere, {0.05, 0, 0}, 1)[0].verdict == SlipVerdict::too_short);  // hardly bent
}

}  // namespace
}  // namespace flexslip
