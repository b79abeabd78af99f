#include "inference/wave_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double pi = std::numbers::pi;

Descent descent_of(const ForceModel& model, const ModelLayout& layout, const HeldValues& held) {
  return {model, layout, freedom_within(model, layout, held)};
}

// Mean, drift, wave and bending stiffness by weighted linear least squares on the profile, for the wavelengths in p.
VectorXd linear_start(const ForceModel& model, const ModelLayout& layout, VectorXd p, double amplification) {
  const auto& points = model.profile().points;
  const auto rows = static_cast<Index>(points.size());
  const Index columns = (layout.drift ? 2 : 1) + 2 * layout.waves + 1;
  MatrixXd A = MatrixXd::Zero(rows + 1, columns);
  VectorXd y = VectorXd::Zero(rows + 1);
  const double sigma = std::max(model.problem().errors.force, 1e-4);
  for (Index i = 0; i < rows; ++i) {
    const auto& point = points[static_cast<std::size_t>(i)];
    const double weight = 1 / (sigma * std::abs(point.mu_force));
    Index column = 0;
    A(i, column++) = weight;
    if (layout.drift) A(i, column++) = weight * (point.S - model.middle());
    for (Index wave = 0; wave < layout.waves; ++wave) {
      const double angle = pi * (point.S - model.middle()) / p[layout.wave(wave) + 2];
      A(i, column++) = weight * std::cos(angle);
      A(i, column++) = weight * std::sin(angle);
    }
    A(i, column) = -weight * point.mu_log_stiffness;
    y[i] = weight * point.mu;
  }
  A(rows, columns - 1) = 1 / std::sqrt(model.prior_variance());
  const VectorXd solution = A.colPivHouseholderQr().solve(y);
  const Index head = layout.drift ? 2 : 1;
  p.head(head) = solution.head(head);
  for (Index wave = 0; wave < layout.waves; ++wave)
    p.segment(layout.wave(wave), 2) = amplification * solution.segment(head + 2 * wave, 2);
  p[layout.stiffness()] = std::clamp(solution[columns - 1], -0.06, 0.06);
  return p;
}

// A wave added to a solution, from a candidate of a scan.
FitPoint add_wave(const ForceModel& model, const FitPoint& base, const WaveCandidate& candidate, double S_reference,
                  double amplification, const HeldValues& held) {
  const ModelLayout layout{base.layout.drift, base.layout.waves + 1};
  const Index at = layout.wave(layout.waves - 1);
  const double turn = pi * (model.middle() - S_reference) / candidate.wavelength;
  const double a = amplification * (candidate.cosine * std::cos(turn) + candidate.sine * std::sin(turn));
  const double b = amplification * (candidate.sine * std::cos(turn) - candidate.cosine * std::sin(turn));
  VectorXd p(layout.size());
  p.head(at) = base.p.head(at);
  p.segment(at, 3) << a, b, candidate.wavelength;
  p[layout.stiffness()] = std::clamp(base.p[base.layout.stiffness()], -0.1, 0.1);
  const bool correlated = base.noise.correlation > 0.3 && candidate.walk > 0;
  const double force_error = model.problem().errors.force;
  const double first = 16 * std::max(force_error * force_error, 1e-6);
  const auto start = correlated ? CorrelatedNoise{base.noise.correlation, std::max(first, base.noise.variance)}
                                : CorrelatedNoise{0, first};
  if (!correlated) p = linear_start(model, layout, p, amplification);
  const Descent descent = descent_of(model, layout, held);
  p = descent.descend(p, start, 3).p;
  return descent.refined(p, 4, 3);
}

}  // namespace

Freedom freedom_within(const ForceModel& model, const ModelLayout& layout, const HeldValues& values) {
  std::vector<HeldParameter> held;
  if (layout.waves > 0 && values.amplitude) held.push_back({layout.wave(0), *values.amplitude});
  if (layout.waves > 0 && values.wavelength) held.push_back({layout.wave(0) + 1, *values.wavelength});
  return {layout, {model.middle(), model.middle()}, held};
}

FitPoint fit_mean(const ForceModel& model, bool drift, const HeldValues& held) {
  const ModelLayout layout{drift, 0};
  VectorXd p = VectorXd::Zero(layout.size());
  p[0] = 0.5;
  const Descent descent = descent_of(model, layout, held);
  p = descent.descend(p, {0, 0.15 * 0.15}, 3).p;  // 0.15: coarse agreement in F, to begin with
  return descent.refined(p, Descent::least_squares, 4);
}

std::vector<FitPoint> fit_next_wave(const ForceModel& model, const FitPoint& base, const WavelengthScan& scan,
                                    std::size_t most_candidates, const HeldValues& held) {
  auto candidates = scan.candidates;
  if (held.wavelength && base.layout.waves == 0) candidates = {{*held.wavelength, 0, 0, 0, 0}};
  std::vector<FitPoint> fits;
  for (std::size_t i = 0; i < std::min(most_candidates, candidates.size()); ++i) {
    // A candidate far less likely on the profile than the first is not going to win on the curve.
    if (candidates[i].log_likelihood_gain < candidates.front().log_likelihood_gain - 50) continue;
    for (const double amplification : {1.0, 1.5})
      fits.push_back(add_wave(model, base, candidates[i], scan.S_reference, amplification, held));
  }
  const auto by_likelihood = [](const auto& a, const auto& b) { return a.log_likelihood > b.log_likelihood; };
  std::stable_sort(fits.begin(), fits.end(), by_likelihood);
  if (fits.empty()) return fits;
  const Descent descent = descent_of(model, fits.front().layout, held);
  auto polished = descent.polished(fits.front());
  if (polished.log_likelihood >= fits.front().log_likelihood) fits.front() = std::move(polished);
  const Index wavelength = fits.front().layout.stiffness() - 1;
  std::vector<FitPoint> distinct;
  for (auto& fit : fits) {
    const auto same = [&](const FitPoint& other) {
      return std::abs(1 / fit.p[wavelength] - 1 / other.p[wavelength]) < 0.5 / model.length_seen();
    };
    if (std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(std::move(fit));
  }
  return distinct;
}

VectorXd wave_of_profile(const ForceModel& model, const FitPoint& point, double wavelength) {
  VectorXd p = point.p;
  p[point.layout.wave(0) + 2] = wavelength;
  return linear_start(model, point.layout, p, 1);
}

std::vector<ProfilePoint> without_waves(const ForceModel& model, const FitPoint& point) {
  auto rest = model.profile().points;
  for (auto& measured : rest)
    for (Index i = 0; i < point.layout.waves; ++i) {
      const Index at = point.layout.wave(i);
      const double angle = pi * (measured.S - model.middle()) / point.p[at + 2];
      measured.mu -= point.p[at] * std::cos(angle) + point.p[at + 1] * std::sin(angle);
    }
  return rest;
}

}  // namespace flexslip
