#include "inference/theta.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/approximately.h"

namespace flexslip {

TEST_CASE("theta: what is usual, in numbers (published: the spread of the 26 tests lies within)") {
  const ThetaPrior prior = ThetaPrior::of(0.3, 0.001);
  constexpr double wavelength = 0.0085;
  const double logs[] = {std::log(wavelength)};
  const Theta theta = prior.usual(logs);
  CHECK(theta.size() == 5);
  CHECK(std::exp(theta.log_wavelength(0)) == to(1e-14, wavelength));
  const Hyperparameters at = hyperparameters_of(theta);
  CHECK(at.noise == to(1e-14, 0.03));
  CHECK(at.roughness == to(1e-14, 0.03));
  CHECK(at.length == to(1e-14, 0.03));
  CHECK(at.correlation == to(1e-14, max_correlation / (1 + std::exp(1.0))));
}

TEST_CASE("theta: bounds hold each value, and leave waves alone") {
  const ThetaPrior prior = ThetaPrior::of(0.3, 0.01);
  for (const double far : {-100.0, 100.0}) {
    Theta theta = prior.usual();
    theta.values.fill(far);
    prior.bound(theta);
    for (std::size_t i = 0; i < 4; ++i) CHECK(theta.values[i] == (far < 0 ? prior.min[i] : prior.max[i]));
    CHECK(theta.values[Theta::first_wave] == far);
    CHECK(hyperparameters_of(theta).correlation < max_correlation);
    CHECK(hyperparameters_of(theta).noise >= 0.2 * 0.01 * (1 - 1e-14));
  }
}

TEST_CASE(
    "theta: the density is normal, its slope the derivative (oracle: differences), roughness counted where there is a "
    "kernel") {
  const ThetaPrior prior = ThetaPrior::of(0.2, 0.002);
  Theta theta = prior.usual();
  CHECK(prior.log_density(Kernel::matern_3_2, theta) == 0);
  theta.values = {-3, 0.5, -2.5, -4, 0, 0};
  CHECK(prior.log_density(Kernel::none, theta) > prior.log_density(Kernel::matern_3_2, theta));
  for (std::size_t i = 0; i < 4; ++i) {
    constexpr double h = 1e-5;
    Theta above = theta, below = theta;
    above.values[i] += h, below.values[i] -= h;
    const double difference =
        (prior.log_density(Kernel::matern_3_2, above) - prior.log_density(Kernel::matern_3_2, below)) / (2 * h);
    CHECK(prior.slope(theta, i) == doctest::Approx(difference).epsilon(1e-8));
  }
  // ∫ exp(log_density + log_scale) = 1, by the deviations of a normal distribution.
  const double peak = std::exp(prior.log_scale(Kernel::none));
  CHECK(peak * 2 * std::acos(-1.0) * prior.deviation[Theta::log_noise] * prior.deviation[Theta::logit_correlation] ==
        to(1e-14, 1.0));
}

}  // namespace flexslip
