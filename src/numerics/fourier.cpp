#include "numerics/fourier.h"

#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/elementary.h"

namespace flexslip {

std::size_t power_of_two_from(std::size_t n) {
  std::size_t power = 1;
  while (power < n) power *= 2;
  return power;
}

Complexes fourier(Complexes x) {
  const std::size_t n = x.size();
  if (n == 0 || (n & (n - 1)) != 0)
    throw std::invalid_argument("a Fourier transform of " + std::to_string(n) + " numbers: no power of two");
  for (std::size_t i = 1, j = 0; i < n; ++i) {  // the order of reversed bits
    std::size_t bit = n / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  Complexes turn(n / 2);
  for (std::size_t k = 0; k < n / 2; ++k) {
    const auto [sine, cosine] =
        elementary::sine_and_cosine(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
    turn[k] = {cosine, -sine};
  }
  for (std::size_t half = 1; half < n; half *= 2) {
    const std::size_t stride = n / (2 * half);
    for (std::size_t begin = 0; begin < n; begin += 2 * half)
      for (std::size_t k = 0; k < half; ++k) {
        const double re = x[begin + k + half].real(), im = x[begin + k + half].imag();
        const std::complex<double>& w = turn[k * stride];
        const std::complex<double> turned{re * w.real() - im * w.imag(), re * w.imag() + im * w.real()};
        x[begin + k + half] = x[begin + k] - turned;
        x[begin + k] += turned;
      }
  }
  return x;
}

Complexes inverse_fourier(Complexes x) {
  for (auto& each : x) each = std::conj(each);
  x = fourier(std::move(x));
  const auto n = static_cast<double>(x.size());
  for (auto& each : x) each = std::conj(each) / n;
  return x;
}

}  // namespace flexslip
