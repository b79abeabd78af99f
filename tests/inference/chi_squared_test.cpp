#include "inference/chi_squared.h"

#include <cmath>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("table: the tail of chi squared against Boost") {
  for (const std::size_t freedoms : std::vector<std::size_t>{1, 2, 3, 7, 25, 200})
    for (const double x : {1e-6, 0.1, 1.0, 3.84, 18.0, 120.0, 900.0}) {
      const double expected = boost::math::cdf(complement(boost::math::chi_squared(static_cast<double>(freedoms)), x));
      CHECK(std::abs(chi_squared_beyond(x, freedoms) - expected) < 1e-12);  // as promised
    }
}

}  // namespace flexslip
