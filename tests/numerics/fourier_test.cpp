#include "numerics/fourier.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {

TEST_CASE("fourier: the sum as it is written (oracle)") {
  Uniform uniform;
  for (const std::size_t n : {1u, 2u, 8u, 64u, 512u}) {
    Complexes x(n);
    double square = 0;
    for (auto& each : x) {
      each = {uniform(-1, 1), uniform(-1, 1)};
      square += std::norm(each);
    }
    const Complexes transformed = fourier(x);
    const double bound = 1e-15 * (1 + std::log2(static_cast<double>(n))) * std::sqrt(square) +
                         1e-15 * std::sqrt(static_cast<double>(n) * square);
    for (std::size_t j = 0; j < n; ++j) {
      std::complex<double> sum = 0;
      for (std::size_t t = 0; t < n; ++t)
        sum += x[t] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j * t % n) / static_cast<double>(n));
      CHECK(std::abs(transformed[j] - sum) <= bound);
    }
  }
}

TEST_CASE("fourier: there and back, and Parseval's sum (identity)") {
  Uniform uniform;
  Complexes x(4096);
  double square = 0, of_transform = 0;
  for (auto& each : x) {
    each = {uniform(-1, 1), 0};
    square += std::norm(each);
  }
  const Complexes transformed = fourier(x), back = inverse_fourier(transformed);
  for (std::size_t i = 0; i < x.size(); ++i) CHECK(std::abs(back[i] - x[i]) < 1e-15 * 12 * std::sqrt(square));
  for (const auto& each : transformed) of_transform += std::norm(each);
  CHECK(of_transform / 4096 == doctest::Approx(square).epsilon(1e-13));
}

TEST_CASE("fourier: only powers of two (limit)") {
  CHECK(message_of([] { fourier(Complexes(12)); }) == "a Fourier transform of 12 numbers: no power of two");
  CHECK(power_of_two_from(1) == 1);
  CHECK(power_of_two_from(1025) == 2048);
}

}  // namespace flexslip
