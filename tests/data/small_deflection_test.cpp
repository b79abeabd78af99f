#include "data/small_deflection.h"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "tests/approximately.h"

using namespace flexslip;

namespace {

constexpr double L = 64e-3;
const RectangularSection bar{10e-3, 4e-3};
constexpr double E = 2.7e9;
constexpr double I = 10e-3 * 4e-3 * 4e-3 * 4e-3 / 12;
constexpr double k = 48 * E * I / (L * L * L);  // [N/m]

// A toe of half a millimetre, then a straight rise; noise on the force.
Record bending(double toe, double noise, double load_train, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> unit(0, 1);
  std::vector<double> deflection, force;
  for (int i = 0; i < 500; ++i) {
    const double w = 8e-6 * i;
    deflection.push_back(w);
    const double rise = w < toe ? w * w / (2 * toe) : w - 0.5 * toe;
    force.push_back(k * rise + noise * unit(random));
  }
  return record_from_deflection_and_force(deflection, force, load_train);
}

BeamGeometry known() { return {L, bar}; }

}  // namespace

TEST_CASE("small_deflection: modulus, stress and strain of a straight record against the formulas (table)") {
  const SmallDeflection found = small_deflection(bending(0.5e-3, 0, 1e6, 1), known());
  REQUIRE(found.status == SmallDeflectionStatus::ok);
  constexpr double roundings = 1e-9;  // sums over hundreds of points, differences of like numbers
  CHECK(found.stiffness.value == to(roundings, k));
  CHECK(*found.bending_stiffness == to(roundings, E * I));
  CHECK(*found.modulus == to(roundings, E));
  CHECK(found.origin == to(1e-6, 0.25e-3));  // the toe's: the slope is 1e-9 right, and the lever ten times the origin
  const double w = 8e-6 * 499;
  CHECK(found.deflection == to(1e-6, w - 0.25e-3));
  CHECK(found.greatest_force == to(roundings, k * (w - 0.25e-3)));
  CHECK(*found.stress == to(roundings, 3 * found.greatest_force * L / (2 * 10e-3 * 4e-3 * 4e-3)));
  CHECK(*found.strain == to(1e-6, 6 * (w - 0.25e-3) * 4e-3 / (L * L)));
  REQUIRE(found.chord);
  CHECK(found.chord->deflection_from == to(1e-12, 0.0005 * L * L / (6 * 4e-3)));
  CHECK(found.chord->deflection_to == to(1e-12, 0.0025 * L * L / (6 * 4e-3)));
  CHECK_FALSE(found.deflection_large);
}

TEST_CASE("small_deflection: the chord of a straight record without a toe is its slope (identity)") {
  const SmallDeflection found = small_deflection(bending(1e-12, 0, 1e6, 1), known());
  REQUIRE(found.chord);
  CHECK(found.chord->stiffness.value == to(1e-6, k));
  CHECK(found.chord->modulus == to(1e-6, E));
}

TEST_CASE("small_deflection: the error of a stated window covers the truth (truth)") {
  const int tests = 400;
  int covered = 0;
  for (unsigned seed = 1; seed <= tests; ++seed) {
    const auto found = small_deflection(bending(1e-12, 0.3, 1e6, seed), known(),
                                        SmallDeflectionOptions{.window = ForceWindow{0.2, 0.6}});
    REQUIRE(found.status == SmallDeflectionStatus::ok);
    covered += std::abs(found.stiffness.value - k) < 1.96 * found.stiffness.standard_error;
  }
  CAPTURE(covered);
  CHECK(covered >= tests * 92 / 100);  // of nominal 95, with a standard deviation of 1.1
  CHECK(covered <= tests * 99 / 100);
}

TEST_CASE(
    "small_deflection: of windows tried the steepest is at most two errors too steep where all are alike (truth)") {
  double excess = 0;
  const int tests = 200;
  for (unsigned seed = 1; seed <= tests; ++seed) {
    const auto found = small_deflection(bending(1e-12, 0.3, 1e6, seed), known());
    excess += (found.stiffness.value - k) / found.stiffness.standard_error / tests;
  }
  CAPTURE(excess);
  CHECK(excess < 2);
}

TEST_CASE("small_deflection: a softer load train moves the stage, not the answer (identity)") {
  const auto stiff = small_deflection(bending(0.5e-3, 0, 1e7, 1), known());
  const auto soft = small_deflection(bending(0.5e-3, 0, 5e4, 1), known());
  CHECK(soft.stiffness.value == to(1e-9, stiff.stiffness.value));
}

TEST_CASE("small_deflection: what is not known stays out (limit)") {
  const auto bare = small_deflection(bending(0.5e-3, 0, 1e6, 1), {});
  CHECK(bare.stiffness.value == to(1e-9, k));
  CHECK_FALSE(bare.bending_stiffness.has_value());
  CHECK_FALSE(bare.modulus.has_value());
  CHECK_FALSE(bare.chord.has_value());
  const auto with_span = small_deflection(bending(0.5e-3, 0, 1e6, 1), {L, {}});
  CHECK(*with_span.bending_stiffness == to(1e-9, E * I));
  CHECK_FALSE(with_span.stress.has_value());
}

TEST_CASE("small_deflection: flags of large deflection and of thick specimens (limit)") {
  CHECK(small_deflection(bending(0.5e-3, 0, 1e6, 1), {30e-3, bar}).deflection_large);
  // At the span of 16 thicknesses that ISO 178 asks for.
  CHECK(*small_deflection(bending(0.5e-3, 0, 1e6, 1), {64e-3, bar}).shear_share == to(1e-12, 3.06 / 256));
}

TEST_CASE("small_deflection: a force that does not rise, and too few points (limit)") {
  const std::vector<double> w{0, 1, 2, 3, 4, 5, 6, 7};
  const auto status = [&](const std::vector<double>& force) {
    return small_deflection(record_from_deflection_and_force(w, force, 1), {}).status;
  };
  CHECK(status({0, 0, 0, 0, 0, 0, 0, 0}) == SmallDeflectionStatus::no_straight_part);
  CHECK(status({8, 7, 6, 5, 4, 3, 2, 1}) == SmallDeflectionStatus::no_straight_part);
  CHECK(small_deflection({}, {}).status == SmallDeflectionStatus::no_straight_part);
}

TEST_CASE("usual_roller_radius: that of ISO 178 for bars, none for what is no bar (table)") {
  const auto radius = [](double span, double height) {
    return usual_roller_radius({span, RectangularSection{.width = 0.01, .height = height}});
  };
  CHECK(radius(0.064, 0.004) == std::optional(0.005));
  CHECK(radius(0.048, 0.003) == std::optional(0.002));
  CHECK(radius(0.024, 0.0015) == std::optional(0.002));
  CHECK(!radius(0.016, 0.001));
  CHECK(!radius(0.030, 0.004));  // a span that no bar so thick is tested on
  CHECK(!usual_roller_radius({1278e-6, RoundSection{34.8e-6}}));
  CHECK(!usual_roller_radius({std::nullopt, RoundSection{0.004}}));
  CHECK(!usual_roller_radius({0.064, std::nullopt}));
}

TEST_CASE("small_deflection: nonsense is refused (contract)") {
  const Record record = bending(0.5e-3, 0, 1e6, 1);
  CHECK_THROWS_AS(small_deflection(record, {-1, {}}), std::invalid_argument);
  CHECK_THROWS_AS(small_deflection(record, {}, {.window = ForceWindow{0.5, 0.4}}), std::invalid_argument);
  CHECK_THROWS_AS(small_deflection(record, {}, {.window = ForceWindow{0.5, 1.1}}), std::invalid_argument);
}
