// Surfaces for tests, made by other means than those tested: sums of cosines, autoregression.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace flexslip {

class SimulatedSurface {
 public:
  explicit SimulatedSurface(std::uint64_t seed) : generator_(seed) {}

  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }

  // Correlation exp(-(s/length)²): white noise through weights exp(-2 (s/length)²).
  std::vector<double> gaussian(std::size_t n, double step, double rms, double length) {
    const auto reach = static_cast<std::size_t>(std::ceil(4 * length / step));
    std::vector<double> weight, noise, z(n, 0);
    double squares = 0;
    for (std::size_t k = 0; k <= 2 * reach; ++k) {
      const double x = (static_cast<double>(k) - static_cast<double>(reach)) * step / length;
      weight.push_back(std::exp(-2 * x * x));
      squares += weight.back() * weight.back();
    }
    for (std::size_t i = 0; i < n + 2 * reach; ++i) noise.push_back(rms / std::sqrt(squares) * normal());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k <= 2 * reach; ++k) z[i] += weight[k] * noise[i + k];
    return z;
  }

  // Correlation exp(-s/length).
  std::vector<double> exponential(std::size_t n, double step, double rms, double length) {
    std::vector<double> z;
    const double rho = std::exp(-step / length);
    double at = rms * normal();
    for (std::size_t i = 0; i < n; ++i) {
      z.push_back(at);
      at = rho * at + rms * std::sqrt(1 - rho * rho) * normal();
    }
    return z;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace flexslip
