#include "data/contact.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/data/straight_test.h"

using namespace flexslip;

namespace {

TEST_CASE("contact: contact and slope of a straight test are those it was made with (truth known)") {
  const InitialLine contact = initial_line(straight_test(300, 25.3e-6, 0, 1));
  REQUIRE(contact.status == ContactStatus::found);
  CHECK(std::abs(contact.offset.value - 25.3e-6) < 1e-12);  // rounding of sums of 40 terms, times 1e-4 m
  CHECK(std::abs(contact.slope.value - 60) < 1e-9);         // the same, relative 1e-11
}

TEST_CASE("contact: standard errors of contact and slope cover the truth (simulation)") {
  int offset_covered = 0, slope_covered = 0;
  const int tests = 500;
  for (int seed = 0; seed < tests; ++seed) {
    const InitialLine contact = initial_line(straight_test(300, 25.3e-6, 5e-6, static_cast<unsigned>(seed)));
    REQUIRE(contact.status == ContactStatus::found);
    offset_covered += std::abs(contact.offset.value - 25.3e-6) < 2 * contact.offset.standard_error;
    slope_covered += std::abs(contact.slope.value - 60) < 2 * contact.slope.standard_error;
  }
  // Two standard errors cover 95 %, more as chance correlation only ever widens them; 0.92 is three deviations of 500 draws below.
  CHECK(offset_covered > 0.92 * tests);
  CHECK(slope_covered > 0.92 * tests);
}

TEST_CASE(
    "contact: a contact that settles is found with an error that holds the truth, others are not called settling "
    "(simulation)") {
  int settling = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    Record record = straight_test(300, 25.3e-6, 5e-6, seed);
    settling += initial_line(record).settles;
    const double greatest = *std::max_element(record.force.begin(), record.force.end());
    for (std::size_t i = 0; i < record.force.size(); ++i) {  // 10 µm are taken up while the force rises to a tenth
      const double taken_up = 10e-6 * (1 - std::exp(-30 * std::max(record.force[i], 0.0) / greatest));
      record.stage[i] += taken_up;
      record.deflection[i] += taken_up;
    }
    const InitialLine contact = initial_line(record);
    CHECK(contact.settles);
    CHECK(std::abs(contact.offset.value - 35.3e-6) < 2 * contact.offset.standard_error);
    CHECK(contact.offset.standard_error < 10e-6);
  }
  CHECK(settling <= 2);
}

TEST_CASE("contact: a record that begins under a preload is looked at farther up (truth known)") {
  const Record whole = straight_test(40, 0, 0, 1);
  const InitialLine contact = initial_line(points_between(whole, 4, 40));  // two points below 0.15 of the force
  REQUIRE(contact.status == ContactStatus::found);
  CHECK(std::abs(contact.slope.value - 60) < 1e-9);
}

TEST_CASE("contact: where there is no contact to find, the status says so (limit)") {
  CHECK(initial_line({}).status == ContactStatus::too_few_points);
  CHECK(initial_line(straight_test(8, 0, 0, 1)).status == ContactStatus::too_few_points);
  const std::vector<double> x{0, 1, 2, 3, 4, 5, 6}, none(7, 0.0);
  CHECK(initial_line({x, x, none}).status == ContactStatus::not_rising);
}

}  // namespace
