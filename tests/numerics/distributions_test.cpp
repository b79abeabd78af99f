#include <cmath>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {

TEST_CASE("distributions: the Gaussian's tail and quantile (oracle: Boost.Math)") {
  const boost::math::normal gaussian;
  for (const double x : {-3.0, -0.5, 0.0, 1.0, 4.0})
    CHECK(gaussian_tail(x) == doctest::Approx(cdf(complement(gaussian, x))).epsilon(1e-14));
  for (const double p : {1e-6, 0.05, 0.5, 0.95, 0.999})
    CHECK(std::abs(elementary::gaussian_quantile(p) - quantile(gaussian, p)) <= 1e-12);
}

TEST_CASE("distributions: Student's tail and quantile to their stated error (oracle: Boost.Math)") {
  for (const double nu : {8.0, 30.0, 100.0})
    for (const double x : {0.5, 2.0, 4.0}) {
      const double exact = cdf(complement(boost::math::students_t(nu), x));
      if (exact > 1e-6) CHECK(std::abs(student_tail(x, nu) / exact - 1) <= 0.02);
    }
  for (const double nu : {2.0, 5.0, 30.0}) {
    const double exact = quantile(boost::math::students_t(nu), 0.975);
    CHECK(std::abs(student_quantile(elementary::gaussian_quantile(0.975), nu) / exact - 1) <= 0.041);
  }
}

}  // namespace flexslip
