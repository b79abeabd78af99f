#include "data/small_deflection.h"

#include <algorithm>
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

// A force [N] over deflections [m] in steps, up to the last, with noise.
template <class Force>
Record in_steps(double step, double last, double noise, unsigned seed, Force force_at, double load_train = 1e7) {
  std::mt19937 random(seed);
  std::normal_distribution<double> unit(0, 1);
  std::vector<double> deflection, force;
  for (int i = 0; i * step <= last * (1 + 1e-12); ++i) {
    const double w = i * step;
    deflection.push_back(w);
    force.push_back(force_at(w) + noise * unit(random));
  }
  return record_from_deflection_and_force(deflection, force, load_train);
}

// Straight up to a knee, and a fifteenth as steep beyond: a metal that yields.
double yielding(double w) {
  constexpr double knee = 1.5e-3;
  return k * (std::min(w, knee) + std::max(w - knee, 0.0) / 15);
}

}  // namespace

TEST_CASE("small_deflection: modulus, stress and strain of a straight record against the formulas (table)") {
  const SmallDeflection found = small_deflection(bending(0.5e-3, 0, 1e6, 1), known());
  REQUIRE(found.status == SmallDeflectionStatus::ok);
  constexpr double roundings = 1e-9;  // sums over hundreds of points, differences of like numbers
  CHECK(found.stiffness.value == to(roundings, k));
  CHECK(found.bending_stiffness->value == to(roundings, E * I));
  CHECK(found.modulus->value == to(roundings, E));
  CHECK(found.origin == to(1e-6, 0.25e-3));  // the toe's: the slope is 1e-9 right, and the lever ten times the origin
  const double w = 8e-6 * 499;
  CHECK(found.greatest.deflection == to(1e-6, w - 0.25e-3));
  CHECK(found.greatest.force == to(roundings, k * (w - 0.25e-3)));
  CHECK(*found.greatest.stress == to(roundings, 3 * found.greatest.force * L / (2 * 10e-3 * 4e-3 * 4e-3)));
  CHECK(*found.greatest.strain == to(1e-6, 6 * (w - 0.25e-3) * 4e-3 / (L * L)));
  REQUIRE(found.chord);
  CHECK(found.chord->deflection_from == to(1e-12, 0.0005 * L * L / (6 * 4e-3)));
  CHECK(found.chord->deflection_to == to(1e-12, 0.0025 * L * L / (6 * 4e-3)));
  CHECK_FALSE(found.deflection_large);
}

TEST_CASE("small_deflection: the chord of a straight record without a toe is its slope (identity)") {
  const SmallDeflection found = small_deflection(bending(1e-12, 0, 1e6, 1), known());
  REQUIRE(found.chord);
  CHECK(found.chord->stiffness.value == to(1e-6, k));
  CHECK(found.chord->modulus.value == to(1e-6, E));
}

TEST_CASE("small_deflection: the stated errors of span and section enter as L³/I (identity)") {
  BeamGeometry geometry = known();
  const SmallDeflection exact = small_deflection(bending(1e-12, 0.3, 1e6, 1), geometry);
  geometry.span_error = 0.01;
  geometry.moment_error = 0.04;
  const SmallDeflection found = small_deflection(bending(1e-12, 0.3, 1e6, 1), geometry);
  const auto relative = [](const Estimate& estimate) { return estimate.standard_error / estimate.value; };
  CHECK(found.modulus->value == exact.modulus->value);
  CHECK(relative(*found.modulus) == to(1e-12, std::hypot(relative(*exact.modulus), 0.03, 0.04)));
  CHECK(relative(found.chord->modulus) == to(1e-12, std::hypot(relative(exact.chord->modulus), 0.03, 0.04)));
  CHECK(relative(*found.bending_stiffness) == to(1e-12, std::hypot(relative(*exact.bending_stiffness), 0.03)));
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

TEST_CASE("small_deflection: few rows on the straight part cost error, not the answer (truth)") {
  constexpr double noise = 0.2;  // [N]
  std::vector<double> errors;
  // 150, 15, 8, 5 and 4 rows below the knee.
  for (const double step : {0.01e-3, 0.1e-3, 0.2e-3, 0.35e-3, 0.45e-3}) {
    double error = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      CAPTURE(step);
      CAPTURE(seed);
      const auto found = small_deflection(in_steps(step, 12e-3, noise, seed, yielding), {100e-3, bar});
      REQUIRE(found.status == SmallDeflectionStatus::ok);
      CHECK(std::abs(found.stiffness.value - k) < 4 * found.stiffness.standard_error + 0.003 * k);
      CHECK(found.origin >= 0);
      CHECK(found.origin < 4 * (noise + found.stiffness.standard_error * 0.75e-3) / k);  // at the lever of a middle
      error += found.stiffness.standard_error / 20;
    }
    errors.push_back(error);
  }
  CHECK(errors.back() > 2 * errors.front());
}

TEST_CASE("small_deflection: strain counts from a contact that is stated (truth)") {
  const Record record = bending(0.5e-3, 0, infinity, 1);
  SmallDeflectionOptions options;
  options.contact = normal_estimate(0.1e-3, 2e-6);
  const auto stated = small_deflection(record, known(), options), own = small_deflection(record, known());
  CHECK(stated.origin == 0.1e-3);
  CHECK(stated.origin_error == 2e-6);
  CHECK(stated.stiffness.value == own.stiffness.value);
  CHECK(stated.greatest.deflection - own.greatest.deflection == to(1e-9, own.origin - 0.1e-3));
  CHECK(stated.chord_in_toe);
}

TEST_CASE("small_deflection: few rows behind a contact, which lies anywhere between two of them (truth)") {
  for (const double contact : {1.05e-3, 1.2e-3, 1.35e-3}) {
    CAPTURE(contact);
    const auto later = [&](double w) { return yielding(std::max(w - contact, 0.0)); };
    const auto found = small_deflection(in_steps(0.3e-3, 12e-3, 0.2, 5, later), {100e-3, bar});
    REQUIRE(found.status == SmallDeflectionStatus::ok);
    CHECK(std::abs(found.stiffness.value - k) < 4 * found.stiffness.standard_error);
    CHECK(found.origin == to(0.03, contact));
  }
}

TEST_CASE("small_deflection: the straight part of a curve that rounds off is where it is steepest (truth)") {
  const auto rounding = [](double w) {
    const double u = std::max(w - 1e-3, 0.0);
    return k * (std::min(w, 1e-3) + u - 60 * u * u);
  };
  for (const double step : {0.02e-3, 0.1e-3, 0.4e-3}) {
    CAPTURE(step);
    const auto found = small_deflection(in_steps(step, 7e-3, 0, 1, rounding), {100e-3, bar});
    REQUIRE(found.status == SmallDeflectionStatus::ok);
    CHECK(found.stiffness.value == to(0.03, k));
    CHECK(found.window.from < 0.05);
  }
}

TEST_CASE("small_deflection: teeth are not the straight part, however steep they rise (truth known)") {
  // From 6 mm on a tooth every half millimetre, and all of them together twice as steep as the specimen.
  const auto sawtooth = [](double w) {
    return k * (w < 6e-3 ? w : 6e-3 + 3 * (w - 6e-3) - 0.5e-3 * std::floor((w - 6e-3) / 0.5e-3));
  };
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto straight = find_linear_region(in_steps(0.02e-3, 12e-3, 0.1, seed, sawtooth), {});
    REQUIRE(straight);
    CHECK(straight->slope.value == to(0.01, k));
    CHECK(straight->origin < 0.1e-3);
  }
}

TEST_CASE("small_deflection: the toe does not lie before the record begins (limit)") {
  // Begun under a preload; and bent down from the first row on.
  const auto preloaded = [](double w) { return k * (w + 1e-3); };
  const auto found = small_deflection(in_steps(0.01e-3, 4e-3, 0.1, 1, preloaded), known());
  CHECK(found.stiffness.value == to(0.01, k));
  CHECK(found.origin == 0);
  CHECK(found.origin_before_record == to(0.02, 1e-3));
  CHECK(found.greatest.deflection == to(1e-12, 4e-3));
  const auto bent_down = [](double w) { return k * (w - 100 * w * w); };
  CHECK(small_deflection(in_steps(0.01e-3, 4e-3, 0.1, 1, bent_down), known()).origin >= 0);
}

TEST_CASE(
    "small_deflection: a chord in the toe is not the modulus to report; one of a specimen that friction steepens is "
    "(truth)") {
  constexpr double toe = 1e-3;  // a contact that settles: the force rises as the square of the deflection
  const auto settling = [](double w) { return k * (w < toe ? w * w / (2 * toe) : w - 0.5 * toe); };
  const auto found = small_deflection(in_steps(0.01e-3, 4e-3, 0.02, 1, settling), known());
  REQUIRE(found.status == SmallDeflectionStatus::ok);
  CHECK(found.chord_in_toe);
  REQUIRE(found.chord.has_value());
  CHECK(found.chord->modulus.value < 0.9 * E);
  CHECK(standard_modulus(found)->value == found.modulus->value);
  CHECK(found.modulus->value == to(0.01, E));

  const auto pulled_in = [](double w) { return k * w * (1 + 2.4 * w / L); };  // friction of 1
  const auto steepened = small_deflection(in_steps(0.01e-3, 6e-3, 0.02, 1, pulled_in), known());
  REQUIRE(steepened.chord.has_value());
  CHECK_FALSE(steepened.chord_in_toe);
  CHECK(standard_modulus(steepened)->value == steepened.chord->modulus.value);
  const auto on_pins = small_deflection(in_steps(0.01e-3, 6e-3, 0.02, 1, pulled_in), known(),
                                        {.steepening = [](DeflectionRange, DeflectionRange) { return 0.01; }});
  CHECK(on_pins.chord_in_toe);
  CHECK(on_pins.toe_excess_explained == 0.01);
  CHECK(on_pins.toe_excess == to(1e-12, steepened.modulus->value / steepened.chord->modulus.value - 1));
  CHECK(steepened.modulus->value > 1.1 * steepened.chord->modulus.value);
}

TEST_CASE("small_deflection: what relaxes while the stage halts ends no straight part (limit)") {
  constexpr std::size_t halt = 150;  // of 400: above a quarter of the maximum force
  Record record = in_steps(0.01e-3, 4e-3, 0.02, 1, [](double w) { return k * w; });
  for (std::size_t i = halt + 1; i < record.force.size(); ++i) record.force[i] -= 0.05 * record.force[halt];
  const auto ends_at = [&](const SmallDeflectionOptions& options) {
    return find_linear_region(record, known(), options)->last;
  };
  CHECK(ends_at({}) <= halt + 1);
  CHECK(ends_at({.halts = {halt}}) > halt + 100);
}

TEST_CASE("small_deflection: the error of the load train counts, until the modulus is undetermined (truth)") {
  const auto share_of = [](double share) { return k * (1 - share) / share; };  // a load train that takes such a share
  for (const double share : {0.1, 0.5, 0.9, 0.97}) {
    CAPTURE(share);
    const auto found = small_deflection(in_steps(
                                            0.01e-3, 4e-3, 0, 1, [](double w) { return k * w; }, share_of(share)),
                                        known(), {.load_train_error = 0.01});
    REQUIRE(found.status == SmallDeflectionStatus::ok);
    CHECK(found.load_train_share == to(1e-9, share));
    CHECK(found.stiffness.standard_error == to(1e-6, 0.01 * share / (1 - share) * k));
  }
  const auto lost = small_deflection(in_steps(
                                         0.01e-3, 4e-3, 0, 1, [](double w) { return k * w; }, share_of(0.985)),
                                     known(), {.load_train_error = 0.01});
  CHECK(lost.status == SmallDeflectionStatus::uncertain);
  CHECK(lost.load_train_share == to(1e-9, 0.985));
  CHECK_FALSE(lost.modulus.has_value());
  CHECK_FALSE(standard_modulus(lost).has_value());
  // A load train that takes the whole stage travel, and noise instead of a deflection.
  std::vector<double> stage, force;
  for (int i = 0; i < 120; ++i) stage.push_back(0.2e-6 * i), force.push_back(2 * i + 0.3 * (i % 3));
  CHECK(small_deflection(record_from_stage_and_force(stage, force, 1e7), known(), {.load_train_error = 0.01}).status ==
        SmallDeflectionStatus::uncertain);
}

TEST_CASE("small_deflection: a modulus above every material is refused (limit)") {
  const auto force = [](double w) { return 500 * k * w; };  // 1350 GPa
  const auto found = small_deflection(in_steps(0.01e-3, 4e-3, 0, 1, force), known());
  CHECK(found.status == SmallDeflectionStatus::too_stiff);
  CHECK(found.modulus->value == to(1e-9, 500 * E));
  CHECK(small_deflection(in_steps(0.01e-3, 4e-3, 0, 1, [](double w) { return 440 * k * w; }), known()).status ==
        SmallDeflectionStatus::ok);
}

TEST_CASE("small_deflection: noise above half of the slope leaves the modulus undetermined (limit)") {
  const auto found = small_deflection(in_steps(0.2e-3, 4e-3, 1e3, 3, [](double w) { return 10 * k * w; }), known());
  CHECK((found.status == SmallDeflectionStatus::uncertain || found.status == SmallDeflectionStatus::no_straight_part));
}

TEST_CASE("small_deflection: greatest and last point, each with stress and strain (table)") {
  const auto softens = [](double w) { return k * (w < 3e-3 ? w : 3e-3 - 0.5 * (w - 3e-3)); };
  const auto found = small_deflection(in_steps(0.01e-3, 4e-3, 0, 1, softens), known());
  CHECK(found.greatest.force == to(1e-9, k * 3e-3));
  CHECK(found.greatest.deflection == to(1e-9, 3e-3));
  CHECK(found.end.force == to(1e-9, k * 2.5e-3));
  CHECK(found.end.deflection == to(1e-9, 4e-3));
  CHECK(*found.end.stress == to(1e-9, 3 * found.end.force * L / (2 * 10e-3 * 4e-3 * 4e-3)));
  CHECK(*found.end.strain == to(1e-9, 6 * 4e-3 * 4e-3 / (L * L)));
}

TEST_CASE("small_deflection: what is not known stays out (limit)") {
  const auto bare = small_deflection(bending(0.5e-3, 0, 1e6, 1), {});
  CHECK(bare.stiffness.value == to(1e-9, k));
  CHECK_FALSE(bare.bending_stiffness.has_value());
  CHECK_FALSE(bare.modulus.has_value());
  CHECK_FALSE(bare.chord.has_value());
  const auto with_span = small_deflection(bending(0.5e-3, 0, 1e6, 1), {L, {}});
  CHECK(with_span.bending_stiffness->value == to(1e-9, E * I));
  CHECK_FALSE(with_span.greatest.stress.has_value());
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

TEST_CASE("standard_roller_radius: the radius of ISO 178 for bars, a twentieth of the span for smaller ones (table)") {
  const auto radius = [](double span, double height) {
    return standard_roller_radius({span, RectangularSection{.width = 0.01, .height = height}});
  };
  CHECK(radius(0.064, 0.004) == std::optional(0.005));
  CHECK(radius(0.048, 0.003) == std::optional(0.002));
  CHECK(radius(0.024, 0.0015) == std::optional(0.002));
  CHECK(radius(0.016, 0.001) == std::optional(0.0008));
  CHECK(radius(0.100, 0.001) == std::optional(0.002));
  CHECK(radius(0.030, 0.004) == std::optional(0.0015));  // a span that no bar so thick is tested on
  CHECK(standard_roller_radius({0.020, RoundSection{0.5e-3}}) == std::optional(0.001));
  CHECK(*standard_roller_radius({1278e-6, RoundSection{34.8e-6}}) == doctest::Approx(63.9e-6));
  CHECK(!standard_roller_radius({std::nullopt, RoundSection{0.004}}));
  CHECK(*standard_roller_radius({0.064, std::nullopt}) == doctest::Approx(0.0032));
  CHECK(!standard_roller_radius({0.064, RoundSection{0.004}, 0.0}));
  CHECK(!standard_roller_radius({0.064, RoundSection{0.004}, 0.001}));
}

TEST_CASE("small_deflection: nonsense is refused (contract)") {
  const Record record = bending(0.5e-3, 0, 1e6, 1);
  CHECK_THROWS_AS(small_deflection(record, {-1, {}}), std::invalid_argument);
  CHECK_THROWS_AS(small_deflection(record, {}, {.window = ForceWindow{0.5, 0.4}}), std::invalid_argument);
  CHECK_THROWS_AS(small_deflection(record, {}, {.window = ForceWindow{0.5, 1.1}}), std::invalid_argument);
}
