#include "surface/chi_squared_quantile.h"

#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"

namespace flexslip {

TEST_CASE("chi squared quantile: whole and other freedoms (oracle: Boost.Math)") {
  for (const double freedoms : {1.0, 2.0, 3.7, 14.0, 250.0, 1234.5, 1e5})
    for (const double probability : {0.025, 0.5, 0.975}) {
      const double there = boost::math::quantile(boost::math::chi_squared(freedoms), probability);
      CHECK(chi_squared_quantile(probability, freedoms) == doctest::Approx(there).epsilon(1e-9));
      CHECK(std::abs(chi_squared_below(there, freedoms) - probability) < 1e-10);
    }
}

TEST_CASE("chi squared quantile: what it is not made for (limit)") {
  CHECK(has(message_of([] { chi_squared_quantile(0, 3); }), "freedoms"));
  CHECK(has(message_of([] { chi_squared_quantile(0.5, 0.5); }), "freedoms"));
  CHECK(chi_squared_below(0, 4) == 0);
}

}  // namespace flexslip
