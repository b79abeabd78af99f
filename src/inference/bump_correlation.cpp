#include "inference/bump_correlation.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "inference/loop_points.h"

namespace flexslip {
namespace {

constexpr double lost_degrees = 6;  // of freedom: three for the trend, three of Fisher's transform
constexpr double normal_95 = 1.959964;

void require(bool holds, const char* what, double value) {
  if (!holds) throw std::invalid_argument(std::string(what) + ": " + std::to_string(value));
}

std::vector<double> without_trend(std::span<const double> S, std::span<const double> values,
                                  std::span<const double> weights) {
  const auto n = static_cast<Eigen::Index>(S.size());
  const double middle = 0.5 * (S.front() + S.back());
  const double half = 0.5 * (S.back() - S.front());
  Eigen::MatrixXd A(n, 3);
  Eigen::VectorXd b(n);
  Eigen::VectorXd root(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double x = (S[at] - middle) / half;
    A.row(i) << 1, x, x * x;
    b[i] = values[at];
    root[i] = std::sqrt(weights[at]);
  }
  const Eigen::MatrixXd weighted = root.asDiagonal() * A;
  const Eigen::VectorXd rest = b - A * weighted.colPivHouseholderQr().solve(root.cwiseProduct(b));
  return {rest.data(), rest.data() + n};
}

}  // namespace

double effective_count(std::span<const double> a, std::span<const double> b) {
  const auto autocovariance = [](std::span<const double> x, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < x.size(); ++i) sum += x[i] * x[i - lag];
    return sum;
  };
  const double a0 = autocovariance(a, 0);
  const double b0 = autocovariance(b, 0);
  const auto n = static_cast<double>(a.size());
  if (!(a0 > 0 && b0 > 0)) return n;
  double sum = 0;
  for (std::size_t lag = 1; lag < a.size(); ++lag) {
    const double ra = autocovariance(a, lag) / a0;
    const double rb = autocovariance(b, lag) / b0;
    if (ra <= 0 || rb <= 0) break;
    sum += ra * rb;
  }
  return n / (1 + 2 * sum);
}

BumpCorrelation together(std::span<const BumpCorrelation> loops) {
  double sum = 0, weights = 0, points = 0;
  for (const auto& loop : loops) {
    const double weight = loop.effective_points - lost_degrees;
    if (!(weight > 1) || std::isnan(loop.value)) continue;
    sum += weight * std::atanh(loop.value);
    weights += weight;
    points += loop.effective_points;
  }
  if (!(weights > 0)) return {not_a_number, not_a_number, not_a_number, 0};
  const double z = sum / weights;
  const double half = normal_95 / std::sqrt(weights);
  return {std::tanh(z), std::tanh(z - half), std::tanh(z + half), points};
}

BumpCorrelation correlate_bumps(std::span<const double> S, std::span<const double> in, std::span<const double> out,
                                std::span<const double> noise) {
  const std::size_t n = S.size();
  if (in.size() != n || out.size() != n || noise.size() != n)
    throw std::invalid_argument(
        "bumps are correlated at places with one length, two values and their noise: there are " + std::to_string(n) +
        ", " + std::to_string(in.size()) + ", " + std::to_string(out.size()) + " and " + std::to_string(noise.size()));
  for (std::size_t i = 0; i < n; ++i) {
    require(i == 0 || S[i] > S[i - 1], "the lengths at which bumps are correlated must rise", S[i]);
    require(noise[i] >= 0, "a variance of noise must be >= 0", noise[i]);
  }
  if (n < least_pairs) return {not_a_number, not_a_number, not_a_number, static_cast<double>(n)};
  std::vector<double> weights(n, 1.0);
  auto a = without_trend(S, in, weights);
  auto b = without_trend(S, out, weights);
  // Places count by what they tell: the noise of some, near contact, exceeds all bumps.
  std::vector<double> squares;
  squares.reserve(2 * n);
  for (const double value : a) squares.push_back(value * value);
  for (const double value : b) squares.push_back(value * value);
  const double spread =
      loops::median_or_zero(squares) / 0.455;  // 0.455 is the median of the square of a standard normal
  if (!(spread > 0)) return {not_a_number, not_a_number, not_a_number, static_cast<double>(n)};
  for (std::size_t i = 0; i < n; ++i) weights[i] = spread / (spread + noise[i]);
  a = without_trend(S, in, weights);
  b = without_trend(S, out, weights);
  double ab = 0, aa = 0, bb = 0, total = 0, total_squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    ab += weights[i] * a[i] * b[i];
    aa += weights[i] * a[i] * a[i];
    bb += weights[i] * b[i] * b[i];
    total += weights[i];
    total_squares += weights[i] * weights[i];
    a[i] *= std::sqrt(weights[i]);
    b[i] *= std::sqrt(weights[i]);
  }
  const double count = effective_count(a, b) * total * total / (total_squares * static_cast<double>(n));
  const double r = aa > 0 && bb > 0 ? std::clamp(ab / std::sqrt(aa * bb), -1.0, 1.0) : 0;
  // With no degree of freedom left, nothing is known: the interval is all of [-1, 1].
  const double half = normal_95 / std::sqrt(std::max(count - lost_degrees, std::numeric_limits<double>::min()));
  const double z = std::atanh(r);
  return {r, std::tanh(z - half), std::tanh(z + half), count};
}

}  // namespace flexslip
