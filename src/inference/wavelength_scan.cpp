#include "inference/wavelength_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/Dense>

namespace flexslip {
namespace {

using Columns = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Variances of the random walk over a median step, in units of the median variance of the noise. The likelihood changes
// little within a decade.
const std::vector<double>& walks() {
  static const std::vector<double> values = [] {
    std::vector<double> v{0.0};
    for (int i = -2; i <= 4; ++i) v.push_back(std::pow(10.0, i));
    return v;
  }();
  return values;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Filter {
  Eigen::ArrayXd gain, inverse_deviation;
  double log_variance;
};

// The Kalman filter of a random walk seen through noise of relative variance `noise`.
Filter filter_for(double walk, const Eigen::ArrayXd& steps, const Eigen::ArrayXd& noise) {
  const auto n = noise.size();
  Filter filter{Eigen::ArrayXd(n), Eigen::ArrayXd(n), 0};
  double variance = 0;  // of the level; the mean of the profile is a column of its own
  for (Eigen::Index i = 0; i < n; ++i) {
    variance += walk * steps[i];
    const double total = variance + noise[i];
    filter.gain[i] = variance / total;
    filter.inverse_deviation[i] = 1 / std::sqrt(total);
    filter.log_variance += std::log(total);
    variance *= 1 - filter.gain[i];
  }
  return filter;
}

Columns whitened(const Columns& columns, const Filter& filter) {
  Columns result(columns.rows(), columns.cols());
  Eigen::Array<double, 1, Eigen::Dynamic> level = Eigen::Array<double, 1, Eigen::Dynamic>::Zero(columns.cols());
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const Eigen::Array<double, 1, Eigen::Dynamic> innovation = columns.row(i) - level;
    result.row(i) = innovation * filter.inverse_deviation[i];
    level += filter.gain[i] * innovation;
  }
  return result;
}

}  // namespace

WavelengthScan scan_wavelengths(std::span<const ProfilePoint> unsorted, const ScanOptions& options) {
  if (unsorted.size() < 20)
    throw std::invalid_argument("a scan for wavelengths needs at least 20 points, not " +
                                std::to_string(unsorted.size()));
  std::vector<ProfilePoint> points(unsorted.begin(), unsorted.end());
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.S < b.S; });
  const auto n = static_cast<Eigen::Index>(points.size());
  const double S_first = points.front().S;
  const double S_last = points.back().S;
  const double length = 0.5 * (S_last - S_first);  // along the fibre

  WavelengthScan scan{.S_reference = 0.5 * (S_first + S_last), .wavelengths = {}, .gains = {}, .candidates = {}};
  const double frequency_step = 1 / (8 * length);
  const double lowest = options.periods / length;
  for (int i = 0; lowest + i * frequency_step < 1 / options.least_wavelength; ++i)
    scan.wavelengths.push_back(1 / (lowest + i * frequency_step));
  const auto waves = static_cast<Eigen::Index>(scan.wavelengths.size());
  if (waves == 0) return scan;

  // Columns: friction, mean, bending stiffness, then a cosine and a sine for each wavelength.
  constexpr Eigen::Index base = 2;
  Columns columns(n, 1 + base + 2 * waves);
  Eigen::ArrayXd noise(n);
  Eigen::ArrayXd steps(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& point = points[static_cast<std::size_t>(i)];
    noise[i] = point.mu_force * point.mu_force;
    steps[i] = i == 0 ? 0 : point.S - points[static_cast<std::size_t>(i - 1)].S;
    columns(i, 0) = point.mu;
    columns(i, 1) = 1;
    columns(i, 2) = -point.mu_log_stiffness;
    // cos(2π f x) at evenly spaced f, by rotation from one to the next
    const double x = 0.5 * (point.S - scan.S_reference);
    const double angle = 2 * std::numbers::pi * x / scan.wavelengths.front();
    const double turn = 2 * std::numbers::pi * x / (8 * length);
    double c = std::cos(angle);
    double s = std::sin(angle);
    const double turn_c = std::cos(turn);
    const double turn_s = std::sin(turn);
    for (Eigen::Index j = 0; j < waves; ++j) {
      columns(i, 1 + base + j) = c;
      columns(i, 1 + base + waves + j) = s;
      const double next = c * turn_c - s * turn_s;
      s = s * turn_c + c * turn_s;
      c = next;
    }
  }
  noise /= median({noise.begin(), noise.end()});
  // Steps much shorter than the typical one are noise of S: they count as a fiftieth of it.
  const double typical = median({steps.begin(), steps.end()});
  const double floor = typical > 0 ? 0.02 * typical : 1.0;
  steps = (steps.max(floor) / std::max(typical, floor)).eval();
  steps[0] = 0;

  Eigen::ArrayXd best = Eigen::ArrayXd::Constant(waves, -std::numeric_limits<double>::infinity());
  std::vector<WaveCandidate> waves_at_best(static_cast<std::size_t>(waves));
  double without = -std::numeric_limits<double>::infinity();
  const auto observations = static_cast<double>(n);
  double deviation = median([&] {
    std::vector<double> errors;
    errors.reserve(points.size());
    for (const auto& point : points) errors.push_back(std::max(point.from_force, 1e-6) / std::abs(point.mu_force));
    return errors;
  }());
  for (const double walk : walks()) {
    const Filter filter = filter_for(walk, steps, noise);
    const Columns white = whitened(columns, filter);
    const Eigen::MatrixXd all = white.matrix();
    const auto target = all.col(0);

    // Least squares on the base columns, with the prior of the bending stiffness as one more observation, in units of
    // the deviation, which is found by two rounds.
    Eigen::MatrixXd B(n + 1, base);
    Eigen::VectorXd y(n + 1);
    y << target, 0;
    Eigen::MatrixXd Q;
    Eigen::VectorXd residual;
    for (int round = 0; round < 2; ++round) {
      B.topRows(n) = all.middleCols(1, base);
      B.row(n) << 0, deviation / options.stiffness_error;
      const Eigen::HouseholderQR<Eigen::MatrixXd> qr(B);
      Q = qr.householderQ() * Eigen::MatrixXd::Identity(n + 1, base);
      residual = y - Q * (Q.transpose() * y);
      deviation = std::sqrt(std::max(residual.squaredNorm(), 1e-300) / observations);
    }
    const double rss0 = residual.squaredNorm();
    const auto likelihood = [&](double rss) {
      return -0.5 * (observations * std::log(std::max(rss, 1e-300) / observations) + filter.log_variance);
    };
    without = std::max(without, likelihood(rss0));

    const auto C = all.middleCols(1 + base, waves);
    const auto Sn = all.middleCols(1 + base + waves, waves);
    const Eigen::MatrixXd QC = Q.topRows(n).transpose() * C;
    const Eigen::MatrixXd QS = Q.topRows(n).transpose() * Sn;
    const Eigen::ArrayXd cc =
        C.colwise().squaredNorm().transpose().array() - QC.colwise().squaredNorm().transpose().array();
    const Eigen::ArrayXd ss =
        Sn.colwise().squaredNorm().transpose().array() - QS.colwise().squaredNorm().transpose().array();
    const Eigen::ArrayXd cs =
        (C.array() * Sn.array()).colwise().sum().transpose() - (QC.array() * QS.array()).colwise().sum().transpose();
    const Eigen::ArrayXd cy = (C.transpose() * residual.head(n)).array();
    const Eigen::ArrayXd sy = (Sn.transpose() * residual.head(n)).array();
    const Eigen::ArrayXd det = cc * ss - cs * cs;
    for (Eigen::Index j = 0; j < waves; ++j) {
      const double a = (ss[j] * cy[j] - cs[j] * sy[j]) / det[j];
      const double b = (cc[j] * sy[j] - cs[j] * cy[j]) / det[j];
      const double value = likelihood(rss0 - (a * cy[j] + b * sy[j]));
      if (!(value > best[j])) continue;
      best[j] = value;
      waves_at_best[static_cast<std::size_t>(j)] = {scan.wavelengths[static_cast<std::size_t>(j)], a, b, 0, walk};
    }
  }

  for (Eigen::Index j = 0; j < waves; ++j) {
    const double gain = best[j] - without;
    waves_at_best[static_cast<std::size_t>(j)].log_likelihood_gain = gain;
    scan.gains.push_back(gain);
    const bool above_left = j == 0 || best[j] >= best[j - 1];
    const bool above_right = j + 1 == waves || best[j] > best[j + 1];
    if (above_left && above_right) scan.candidates.push_back(waves_at_best[static_cast<std::size_t>(j)]);
  }
  std::stable_sort(scan.candidates.begin(), scan.candidates.end(),
                   [](const auto& a, const auto& b) { return a.log_likelihood_gain > b.log_likelihood_gain; });
  if (scan.candidates.size() > static_cast<std::size_t>(options.most_candidates))
    scan.candidates.resize(static_cast<std::size_t>(options.most_candidates));
  return scan;
}

}  // namespace flexslip
