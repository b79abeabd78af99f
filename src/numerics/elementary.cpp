#include "numerics/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "numerics/root.h"

namespace flexslip::elementary {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using One = hn::CappedTag<double, 1>;

// ln(erfc(x) e^(x^2)) - ln t for x >= 0, t = 2/(2 + x): Chebyshev coefficients in 2t - 1, computed with 40 digits.
constexpr std::array chebyshev{
    -1.3026537197817094342,     0.6419697923564902603,      0.019476473204185836312,    -0.0095615147868086316419,
    -0.0009465953444820368663,  0.00036683949785276145187,  4.2523324806907771645e-5,   -2.0278578112534243154e-5,
    -1.6242900046470255135e-6,  1.3036558355805232018e-6,   1.5626441722066143178e-8,   -8.5238095914926542525e-8,
    6.5290544390988514964e-9,   5.0593434955514689418e-9,   -9.9136415649303308674e-10, -2.2736512229318358557e-10,
    9.646791102015526802e-11,   2.3940380830391147447e-12,  -6.8860275264975533984e-12, 8.9448792730907257167e-13,
    3.1309213993429580783e-13,  -1.1270822361367252366e-13, 3.8109052551892320552e-16,  7.1060976136092369878e-15,
    -1.5230282014571043043e-15, -9.4574945712912340005e-17, 1.2102371892242789923e-16,  -2.8166630877471769718e-17};

// ln(erfc(x) e^(x^2)) for x >= 0.
double log_scaled_complement(double x) {
  const double t = 2 / (2 + x);
  const double y = 2 * (2 * t - 1);
  double b = 0;
  double b_before = 0;
  for (std::size_t j = chebyshev.size() - 1; j > 0; --j) {
    const double next = y * b - b_before + chebyshev[j];
    b_before = b;
    b = next;
  }
  return 0.5 * (chebyshev[0] + y * b) - b_before + log(t);
}

}  // namespace

double exp(double x) {
  const One tag;
  return hn::GetLane(hn::Exp(tag, hn::Set(tag, x)));
}

double log(double x) {
  const One tag;
  return hn::GetLane(hn::Log(tag, hn::Set(tag, x)));
}

double exp_less_one(double x) {
  const One tag;
  return hn::GetLane(hn::Expm1(tag, hn::Set(tag, x)));
}

double log_of_one_and(double x) {
  const One tag;
  return hn::GetLane(hn::Log1p(tag, hn::Set(tag, x)));
}

SineAndCosine sine_and_cosine(double x) {
  const One tag;
  const auto v = hn::Set(tag, x);
  return {hn::GetLane(hn::Sin(tag, v)), hn::GetLane(hn::Cos(tag, v))};
}

namespace {

using Two = hn::CappedTag<double, 2>;

// Calls function(tag, i) for two numbers at a time; a last odd number is processed alone.
template <class Function>
void for_all(std::span<const double> x, Function function) {
  const std::size_t lanes = hn::Lanes(Two());
  std::size_t i = 0;
  for (; i + lanes <= x.size(); i += lanes) function(Two(), i);
  for (; i < x.size(); ++i) function(One(), i);
}

}  // namespace

void exp(std::span<const double> x, std::span<double> results) {
  for_all(x, [&](auto tag, std::size_t i) { hn::StoreU(hn::Exp(tag, hn::LoadU(tag, &x[i])), tag, &results[i]); });
}

void sine_and_cosine(std::span<const double> x, std::span<double> sines, std::span<double> cosines) {
  for_all(x, [&](auto tag, std::size_t i) {
    const auto v = hn::LoadU(tag, &x[i]);
    hn::StoreU(hn::Sin(tag, v), tag, &sines[i]);
    hn::StoreU(hn::Cos(tag, v), tag, &cosines[i]);
  });
}

double length(double a, double b) { return std::sqrt(a * a + b * b); }

double wrapped_angle(double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle - turn * std::round(angle / turn);
}

double angle(double y, double x) {
  const double a = std::abs(x), b = std::abs(y);
  if (a == 0 && b == 0) return 0;
  const One tag;
  const double within = hn::GetLane(hn::Atan(tag, hn::Set(tag, std::min(a, b) / std::max(a, b))));
  const double first = b > a ? 0.5 * std::numbers::pi - within : within;  // in the first quadrant
  return std::copysign(x < 0 ? std::numbers::pi - first : first, y);
}

GaussianBelow gaussian_below(double z) {
  const double x = std::abs(z) / std::numbers::sqrt2;
  const double log_scaled = log_scaled_complement(x);
  const double log_tail = log_scaled - x * x - std::numbers::ln2;  // of P(z' < -|z|)
  constexpr double root_two_over_pi = std::numbers::sqrt2 * std::numbers::inv_sqrtpi;
  if (z <= 0) return {log_tail, root_two_over_pi * exp(-log_scaled)};
  const double tail = exp(log_tail);
  return {log(1 - tail), 0.5 * root_two_over_pi * exp(-x * x) / (1 - tail)};
}

double gaussian_quantile(double probability) {
  // The smaller tail is used, because its logarithm loses no digits.
  const double wanted = log(std::min(probability, 1 - probability));
  const double z =
      halved(60, {-10, 0}, [&](double below) { return !(gaussian_below(below).log_probability < wanted); }).low;
  return probability < 0.5 ? z : -z;
}

}  // namespace flexslip::elementary
