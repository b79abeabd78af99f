#include "data/scales.h"

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <doctest/doctest.h>

#include "data/record.h"

using namespace flexslip;

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

// A reduced curve cannot be taken for a physical one, nor a number for a scale.
static_assert(!std::convertible_to<ReducedRecord, Record> && !std::convertible_to<Record, ReducedRecord>);
static_assert(!std::is_assignable_v<Record&, ReducedRecord> && !std::is_assignable_v<ReducedRecord&, Record>);
static_assert(!std::is_constructible_v<Scales, double>);

TEST_CASE("scales: units of test SS14, from the paper's specimen table") {
  const double EI = 29597874858.20209 * round_section_moment(3.48e-5);
  const Scales scales(1.278e-3, EI);
  CHECK(scales.stiffness_unit() ==
        doctest::Approx(1.0208333333333333).epsilon(1e-12));  // EI/L^3 as in specimens.csv, rounded
  CHECK(scales.reduced_stiffness(90.6455539007583) == doctest::Approx(88.79564463747751).epsilon(1e-12));
}

TEST_CASE("scales: energy is force times length, stiffness is force over length (identity)") {
  const Scales scales(1.278e-3, 2.1e-12);
  CHECK(std::abs(scales.force_unit() * scales.span() / scales.energy_unit() - 1) <= 2 * ulp);      // one rounding each
  CHECK(std::abs(scales.force_unit() / scales.span() / scales.stiffness_unit() - 1) <= 2 * ulp);   // one rounding each
  CHECK(std::abs(scales.stiffness_unit() * std::pow(scales.span(), 3) / 2.1e-12 - 1) <= 8 * ulp);  // four roundings
}

TEST_CASE("scales: there and back again (identity)") {
  const Scales scales(1.278e-3, 2.1e-12);
  for (const double x : {-3.0, 0.0, 1e-12, 0.1, 7.0, 1e9}) {
    const double bound = 2 * ulp * std::abs(x);  // two roundings
    CHECK(std::abs(scales.reduced_length(scales.physical_length(x)) - x) <= bound);
    CHECK(std::abs(scales.reduced_force(scales.physical_force(x)) - x) <= bound);
    CHECK(std::abs(scales.reduced_stiffness(scales.physical_stiffness(x)) - x) <= bound);
  }
}

TEST_CASE("scales: a curve there and back again (identity)") {
  const Scales scales(2.0, 8.0);  // units that are powers of two: exact
  const Record record{{0, 1}, {0, 0.5}, {0, 3}};
  const ReducedRecord reduced = to_reduced(record, scales);
  CHECK(reduced.stage[1] == 0.5);
  CHECK(reduced.deflection[1] == 0.25);
  CHECK(reduced.force[1] == 1.5);
  const Record back = to_physical(reduced, scales);
  CHECK(back.stage == record.stage);
  CHECK(back.deflection == record.deflection);
  CHECK(back.force == record.force);
}

TEST_CASE("scales: section moments against the integral of y^2 over the section (oracle)") {
  // Strips of equal height; the midpoint rule errs by 1/(2 n^2) of the rectangle's moment, and about n^-1.5 of the circle's.
  const int n = 20000;
  const double D = 2, b = 3, h = 2;
  double round = 0, rectangular = 0;
  for (int i = 0; i < n; ++i) {
    const double y = D * ((i + 0.5) / n - 0.5);
    round += y * y * 2 * std::sqrt(D * D / 4 - y * y) * D / n;
    rectangular += y * y * b * h / n;
  }
  CHECK(std::abs(round_section_moment(D) / round - 1) < 1e-5);
  CHECK(std::abs(rectangular_section_moment(b, h) / rectangular - 1) < 1e-8);
}

TEST_CASE("scales: nonsense is refused with its value (contract)") {
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(Scales(bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(Scales(1, bad), std::invalid_argument);
    CHECK_THROWS_AS(round_section_moment(bad), std::invalid_argument);
    CHECK_THROWS_AS(rectangular_section_moment(bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(rectangular_section_moment(1, bad), std::invalid_argument);
  }
  CHECK_THROWS_WITH(Scales(-0.5, 1), "span = -0.5 m is not positive and finite");
  CHECK_THROWS_AS(Scales(1e-200, 1), std::invalid_argument);  // EI/L^2 overflows
}

}  // namespace
