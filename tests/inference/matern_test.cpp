#include "inference/matern.h"

#include <cmath>
#include <functional>

#include <doctest/doctest.h>

namespace flexslip::matern {
namespace {

// Of variance 1, by its closed form over r = rate · distance.
double kernel(Kernel kind, double r) {
  if (kind == Kernel::exponential) return std::exp(-r);
  if (kind == Kernel::matern_3_2) return (1 + r) * std::exp(-r);
  return (1 + r + 3 * r * r / 7 + 2 * r * r * r / 21 + r * r * r * r / 105) * std::exp(-r);
}

double integral(const std::function<double(double)>& f, double to) {
  constexpr int steps = 2000;  // Simpson's rule: an error of 1e-12
  double sum = f(0) + f(to);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(to * i / steps);
  return sum * to / (3 * steps);
}

// Whether the state at a, and again at a + b, is that at a + b; and whether what is expected of it is the kernel.
template <int G>
void check_transitions(Kernel kind) {
  constexpr double a = 0.7, b = 1.9, rounding = 1e-14;
  const auto over = [](double way) { return transition_over<G>(way, std::exp(-way)); };
  const auto over_a = over(a), over_b = over(b), over_both = over(a + b);
  const auto P = stationary<G>();
  for (int i = 0; i < G; ++i) {
    double expected = 0;
    for (int j = 0; j < G; ++j) {
      double both = 0;
      for (int k = 0; k < G; ++k) both += over_b(i, k) * over_a(k, j);
      CHECK(std::abs(both - over_both(i, j)) < rounding);
      if (i == 0) expected += over_a(0, j) * P(j, 0);
    }
    if (i == 0) CHECK(std::abs(expected - kernel(kind, a)) < rounding);
  }
}

}  // namespace

TEST_CASE(
    "identity: two steps are one of their sum, and what follows a state is correlated with it as the kernel says") {
  check_transitions<1>(Kernel::exponential);
  check_transitions<2>(Kernel::matern_3_2);
  check_transitions<5>(Kernel::matern_9_2);
}

TEST_CASE("oracle: integrals of the kernels are those of Simpson's rule") {
  for (const Kernel kind : {Kernel::exponential, Kernel::matern_3_2, Kernel::matern_9_2})
    for (const double R : {0.01, 0.6, 4.0, 15.0}) {
      CAPTURE(name_of(kind));
      CAPTURE(R);
      const auto found = integrals_to(R, kind);
      const auto k = [&](double r) { return kernel(kind, r); };
      CHECK(std::abs(found.of_kernel - integral(k, R)) < 1e-10);
      CHECK(std::abs(found.of_tapered - integral([&](double r) { return (R - r) * k(r); }, R)) < 1e-10 * (1 + R));
    }
}

}  // namespace flexslip::matern
