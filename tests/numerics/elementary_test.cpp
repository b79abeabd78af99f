#include "numerics/elementary.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

namespace flexslip {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
constexpr double ulp = std::numeric_limits<double>::epsilon();

double relative_error(double value, const Wide& exact) { return static_cast<double>(abs(Wide(value) / exact - 1)); }

}  // namespace

TEST_CASE("oracle: elementary functions against 50 digits") {
  for (double x = -700; x < 700; x += 0.937) CHECK(relative_error(elementary::exp(x), exp(Wide(x))) < 2 * ulp);
  for (double x = 1e-300; x < 1e300; x *= 3.7) {
    if (std::abs(x - 1) < 0.3) continue;
    CHECK(relative_error(elementary::log(x), log(Wide(x))) < 4 * ulp);
  }
  for (double x = -300; x < 300; x += 0.0917) {
    const auto at = elementary::sine_and_cosine(x);
    CHECK(std::abs(static_cast<double>(Wide(at.sine) - sin(Wide(x)))) < 4 * ulp);
    CHECK(std::abs(static_cast<double>(Wide(at.cosine) - cos(Wide(x)))) < 4 * ulp);
  }
}

TEST_CASE("oracle: exp(x) - 1 and ln(1 + x) against 50 digits, from small x on") {
  for (double x = 1e-18; x < 700; x *= 1.37)
    for (const double sign : {-1.0, 1.0}) {
      CAPTURE(sign * x);
      CHECK(relative_error(elementary::exp_less_one(sign * x), expm1(Wide(sign * x))) < 8 * ulp);
      if (sign * x > -0.99)
        CHECK(relative_error(elementary::log_of_one_and(sign * x), log1p(Wide(sign * x))) < 8 * ulp);
    }
}

TEST_CASE("identity: each of many numbers gives the same bits as alone, also in place") {
  std::vector<double> x;
  for (int i = 0; i < 41; ++i) x.push_back(-30 + 1.7 * i);
  std::vector<double> sines(x.size()), cosines(x.size()), powers = x;
  elementary::sine_and_cosine(x, sines, cosines);
  elementary::exp(powers, powers);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [sine, cosine] = elementary::sine_and_cosine(x[i]);
    CHECK(sines[i] == sine);
    CHECK(cosines[i] == cosine);
    CHECK(powers[i] == elementary::exp(x[i]));
  }
}

TEST_CASE("identity: the logarithm of a product is the sum of the logarithms, far beyond the range of doubles") {
  elementary::LogProduct product;
  double sum = 0;
  for (int i = 1; i <= 3000; ++i) {
    const double x = std::pow(10.0, (i * 37) % 181 - 90) * (1 + 1e-3 * i);
    product.multiply(x);
    sum += elementary::log(x);
    if (i % 500 == 0) CHECK(product.value() == doctest::Approx(sum).epsilon(1e-14));
  }
  CHECK(elementary::LogProduct{}.value() == 0);
}

TEST_CASE("a wrapped angle keeps its direction, from -pi to pi") {
  for (double angle = -30; angle < 30; angle += 0.37) {
    const double wrapped = elementary::wrapped_angle(angle);
    CHECK(std::abs(wrapped) <= std::numbers::pi);
    CHECK(std::cos(wrapped) == doctest::Approx(std::cos(angle)).epsilon(1e-12));
    CHECK(std::sin(wrapped) == doctest::Approx(std::sin(angle)).epsilon(1e-12));
  }
}

TEST_CASE("oracle: angles against 50 digits, in every quadrant") {
  for (int i = 0; i < 720; ++i) {
    const double x = std::cos(0.0087 * i), y = 3.1 * std::sin(0.0087 * i);
    CHECK(std::abs(static_cast<double>(Wide(elementary::angle(y, x)) - atan2(Wide(y), Wide(x)))) < 4 * 3.2 * ulp);
  }
  CHECK(elementary::angle(0, 1) == 0);
  CHECK(elementary::angle(0, 0) == 0);
  CHECK(elementary::angle(1, 0) == doctest::Approx(std::numbers::pi / 2).epsilon(1e-15));
  CHECK(elementary::angle(0, -1) == doctest::Approx(std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("oracle: quantiles of a Gaussian against 50 digits") {
  for (double probability = 0.001; probability < 1; probability += 0.0371) {
    const Wide below = erfc(-Wide(elementary::gaussian_quantile(probability)) / sqrt(Wide(2))) / 2;
    CHECK(std::abs(static_cast<double>(below - Wide(probability))) < 1e-12);
  }
}

TEST_CASE("limit: exp underflows to zero") {
  CHECK(elementary::exp(-1000) == 0);
  CHECK(elementary::exp(0) == 1);
}

TEST_CASE("oracle: a Gaussian below a bound against 50 digits") {
  for (double z = -30; z < 8; z += 0.173) {
    const Wide below = erfc(-Wide(z) / sqrt(Wide(2))) / 2;
    const Wide density = exp(-Wide(z) * z / 2) / sqrt(2 * boost::math::constants::pi<Wide>());
    const auto at = elementary::gaussian_below(z);
    CAPTURE(z);
    CHECK(std::abs(static_cast<double>(Wide(at.log_probability) - log(below))) < 1e-13 * (1 + z * z));
    CHECK(relative_error(at.hazard, density / below) < 1e-13);
  }
  // Far below, the hazard is that of Mills' ratio: -z (1 + 1/z^2 - 2/z^4).
  for (const double z : {-1e2, -1e3, -1e5})
    CHECK(elementary::gaussian_below(z).hazard == doctest::Approx(-z + -1 / z).epsilon(1e-7));
}

}  // namespace flexslip
