#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Distribution = boost::math::chi_squared;

}  // namespace

TEST_CASE("chi squared: both tails (oracle: Boost.Math)") {
  for (const double freedoms : {1.0, 2.0, 3.0, 3.7, 7.0, 25.0, 200.0, 1234.5})
    for (const double x : {1e-6, 0.1, 1.0, 3.84, 18.0, 120.0, 900.0}) {
      const double below = cdf(Distribution(freedoms), x), beyond = cdf(complement(Distribution(freedoms), x));
      CHECK(std::abs(chi_squared_beyond(x, freedoms) - beyond) < 1e-12);
      if (beyond > 1e-250)
        CHECK(std::abs(chi_squared_beyond(x, freedoms) - beyond) < 1e-10 * std::min(below, beyond) + 1e-15 * beyond);
    }
  CHECK(chi_squared_beyond(0, 4) == 1);
}

}  // namespace flexslip
