#include "bending_test/standard_reading.h"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/approximately.h"

using namespace flexslip;

namespace {

constexpr double L = 64e-3, h = 4e-3;  // [m] of the bar of ISO 178

// Between the strains 0.05 % and 0.25 %, up to the second: 6 w h/L² of the deflection.
LoadingRead chord() { return {0.0005 * L / (6 * h), 0.0025 * L / (6 * h), 0.0025 * L / (6 * h)}; }

Fibre on(double radius, double thickness = h) {
  return Fibre(Supports{.radius = radius / L, .half_depth = 0.5 * thickness / L});
}

}  // namespace

TEST_CASE("standard_reading: the bar of ISO 178 against an independent calculation, to its last digit (table)") {
  struct Row {
    double radius, friction, modulus, stress;
  };
  // Shooting in multiple precision; stress: where it was calculated.
  for (const Row& row :
       {Row{0, 0, 1.0028, 1.0010}, Row{0, 0.1, 1.0104, 1.0059}, Row{0, 0.3, 1.0260, 1.0161},
        Row{0, 0.5, 1.0422, 1.0265}, Row{2e-3, 0, 1.0062, 0}, Row{2e-3, 0.1, 1.0138, 0}, Row{2e-3, 0.3, 1.0295, 0},
        Row{2e-3, 0.5, 1.0458, 0}, Row{5e-3, 0, 1.0113, 1.0041}, Row{5e-3, 0.1, 1.0190, 1.0091},
        Row{5e-3, 0.3, 1.0347, 1.0193}, Row{5e-3, 0.5, 1.0511, 1.0298}}) {
    CAPTURE(row.radius);
    CAPTURE(row.friction);
    const auto read = standard_reading(on(row.radius), row.friction, chord());
    REQUIRE(read);
    constexpr double last_digit = 0.51e-4;
    CHECK(std::abs(read->modulus - row.modulus) < last_digit);
    if (row.stress > 0) CHECK(std::abs(read->stress - row.stress) < last_digit);
  }
}

TEST_CASE("standard_reading: at small deflection, friction at the surface of a beam on edges causes a couple (limit)") {
  constexpr double w = 1e-5;
  for (const double thickness : {1e-3, 4e-3, 8e-3})
    for (const double mu : {0.0, 0.1, 0.5, 1.0}) {
      CAPTURE(thickness);
      CAPTURE(mu);
      const double tau = 0.5 * thickness / L;
      const auto read = standard_reading(on(0, thickness), mu, {0, w, w});
      REQUIRE(read);
      // What is left out is of the order of the deflection: contacts move by 3 w τ of the span, and friction pulls at the axis, 2.4 μ w.
      const double left_out = 5 * (1 + mu) * w;
      CHECK(read->modulus == to(left_out, 1 / (1 - 3 * mu * tau)));
      CHECK(read->stress == to(left_out, 1 / (1 - 2 * mu * tau)));
      CHECK(std::abs(read->work - 3 * mu * tau * (1 - 4 * mu * tau) / (1 - 3 * mu * tau)) < left_out);
    }
}

TEST_CASE("standard_reading: of a slender specimen on edges friction takes 1.6 μ w/(1 + 1.6 μ w) of the work (limit)") {
  for (const double mu : {0.1, 0.5})
    for (const double w : {0.002, 0.02}) {
      CAPTURE(mu);
      CAPTURE(w);
      const auto read = standard_reading(Fibre(), mu, {0.5 * w, w, w});
      REQUIRE(read);
      const double x = 1.6 * mu * w;
      CHECK(read->work == to(0.1 * w / 0.02, x / (1 + x)));  // of second order in w, some 10 % at 0.02
    }
}

TEST_CASE("standard_reading: friction only adds, and the more the more there is of it (identity)") {
  for (const double radius : {0.0, 2e-3, 5e-3}) {
    StandardReading before = *standard_reading(on(radius), 0, chord());
    CHECK(std::abs(before.work) < 1e-12);
    for (double mu = 0.1; mu < 1.05; mu += 0.1) {
      const auto read = standard_reading(on(radius), mu, chord());
      REQUIRE(read);
      CHECK(read->modulus > before.modulus);
      CHECK(read->stress > before.stress);
      CHECK(read->work > before.work);
      before = *read;
    }
  }
}

TEST_CASE("standard_reading: fixed rollers add 13.5 R w/L² to first order (limit)") {
  constexpr double w = 1e-4;
  for (const double radius : {2e-3, 5e-3}) {
    const double R = (radius + 0.5 * h) / L;
    const auto read = standard_reading(on(radius), 0, {0, w, w});
    REQUIRE(read);
    CHECK(read->modulus - 1 == to(0.02, 13.5 * R * w));  // the second order is some w/R of the first
  }
}

TEST_CASE("standard_reading: empty if the specimen slips through, nonsense refused (contract)") {
  CHECK_FALSE(standard_reading(Fibre(), 0, {0.1, 0.2, 3}));
  CHECK_FALSE(standard_reading(Fibre(), 0, {0.1, 0.2, 1.9}));
  CHECK_THROWS_AS(standard_reading(Fibre(), -0.1, {0, 0.1, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(standard_reading(on(0), 2.5, {0, 0.1, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(standard_reading(Fibre(), 0.1, {0.1, 0.1, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(standard_reading(Fibre(), 0.1, {0, 0.1, 0.05}), std::invalid_argument);
}
