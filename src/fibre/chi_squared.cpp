#include "fibre/chi_squared.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "fibre/elementary.h"

namespace flexslip {
namespace {

// ln Γ(a), Stirling's series from 12 on: its next term is below 1e-13 there.
double log_gamma(double a) {
  double shift = 0;
  for (; a < 12; a += 1) shift += elementary::log(a);
  const double b = 1 / (a * a);
  const double series = (1.0 / 12 - b * (1.0 / 360 - b * (1.0 / 1260 - b * (1.0 / 1680 - b / 1188)))) / a;
  return (a - 0.5) * elementary::log(a) - a + 0.5 * elementary::log(2 * std::numbers::pi) + series - shift;
}

// The incomplete gamma functions P(a, x) and Q(a, x) = 1 - P, by the series of P below a + 1 and the continued fraction of Q (Lentz) above.
struct Tails {
  double below, beyond;
};

Tails gamma_tails(double a, double x) {
  if (!(x > 0)) return {0, 1};
  const double front = elementary::exp(a * elementary::log(x) - x - log_gamma(a));
  constexpr double enough = 1e-15;
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > enough * sum; n += 1) sum += term *= x / n;
    return {front * sum, 1 - front * sum};
  }
  constexpr double tiny = 1e-300;
  double b = x + 1 - a, c = 1 / tiny, d = 1 / b, h = d;
  for (double i = 1; i < 1e7; i += 1) {
    const double an = -i * (i - a);
    b += 2;
    d = 1 / (std::abs(an * d + b) < tiny ? tiny : an * d + b);
    c = std::abs(b + an / c) < tiny ? tiny : b + an / c;
    h *= d * c;
    if (std::abs(d * c - 1) < enough) break;
  }
  return {1 - front * h, front * h};
}

}  // namespace

double chi_squared_beyond(double x, double freedoms) { return gamma_tails(0.5 * freedoms, 0.5 * x).beyond; }

double chi_squared_quantile(double probability, double freedoms) {
  if (!(probability > 1e-6 && probability < 1 - 1e-6 && freedoms >= 1 && freedoms <= 1e7))
    throw std::invalid_argument("a quantile of chi squared at " + std::to_string(probability) + " of " +
                                std::to_string(freedoms) + " freedoms");
  const double spread = std::sqrt(2 * freedoms);
  double low = 0, high = freedoms + 8 * spread + 40;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (gamma_tails(0.5 * freedoms, 0.5 * middle).below < probability ? low : high) = middle;
    if (high - low < 1e-12 * high) break;
  }
  return 0.5 * (low + high);
}

}  // namespace flexslip
