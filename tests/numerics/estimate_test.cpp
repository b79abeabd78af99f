#include <boost/math/distributions/students_t.hpp>
#include <doctest/doctest.h>

#include "numerics/statistics.h"

using namespace flexslip;

TEST_CASE("oracle: the interval of an error from few points agrees with Student's t by Boost.Math") {
  for (const double freedom : {2.0, 3.0, 8.0, 100.0}) {
    const Estimate estimate = student_estimate(5, 0.1, freedom);
    const double reach = 0.1 * quantile(boost::math::students_t(freedom), 0.975);
    CAPTURE(freedom);
    CHECK(estimate.high - 5 == doctest::Approx(reach).epsilon(0.041));  // of the quantile: 4.1 % at 2, less beyond
    CHECK(estimate.high - 5 == doctest::Approx(5 - estimate.low).epsilon(1e-14));
  }
}

TEST_CASE("limit: for many points the interval is the normal one") {
  CHECK(student_estimate(5, 0.1, 1e6).high == doctest::Approx(normal_estimate(5, 0.1).high).epsilon(1e-6));
}
