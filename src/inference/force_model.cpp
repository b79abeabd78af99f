#include "inference/force_model.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
constexpr double pi = std::numbers::pi;

struct Reach {
  double least, greatest;  // [L]
};

Reach lengths_of(const FrictionProfile& profile) {
  const auto [least, greatest] = std::minmax_element(profile.points.begin(), profile.points.end(),
                                                     [](const auto& a, const auto& b) { return a.S < b.S; });
  return {least->S, greatest->S};
}

double least_wavelength_of(const FrictionProfile& profile) {
  const auto [least, greatest] = lengths_of(profile);
  constexpr double least_points_per_wave = 6;  // fewer do not show a wave between its jumps
  constexpr double most_waves = 200;           // of more there would be hundreds of drops in a test
  const double points_per_wave =
      std::max(least_points_per_wave, static_cast<double>(profile.points.size()) / most_waves);
  return points_per_wave * 0.5 * (greatest - least) / static_cast<double>(profile.points.size());
}

SlidingLadder make_ladder(const FrictionProfile& profile) {
  constexpr double lengths_per_period = 8;  // at the end of the ladder, where they are farthest apart
  return {std::min(1 + 1.15 * (lengths_of(profile).greatest - 1), longest_ladder),
          2 * least_wavelength_of(profile) / lengths_per_period};
}

}  // namespace

ForceModel::ForceModel(FitProblem problem, FrictionProfile profile)
    : problem_(std::move(problem)),
      profile_(std::move(profile)),
      least_wavelength_(least_wavelength_of(profile_)),
      ladder_(make_ladder(profile_)),
      force_(
          Eigen::Map<const VectorXd>(problem_.record.force.data(), static_cast<Index>(problem_.record.force.size()))) {
  const auto [least, greatest] = lengths_of(profile_);
  S_middle_ = 0.5 * (least + greatest);
  length_seen_ = 0.5 * (greatest - least);
}

double ForceModel::prior_variance() const {
  const double deviation = std::max(problem_.errors.bending_stiffness, 1e-9);  // exact: practically no freedom
  return deviation * deviation;
}

ForceModel ForceModel::with(const VectorXd& force, double prior_mean) const {
  ForceModel other = *this;
  other.force_ = force;
  other.prior_mean_ = prior_mean;
  return other;
}

// Friction at the lengths of the ladder. The phase of a wave is quadratic in their number, so that it is advanced by two
// rotations a step instead of a cosine each; the rounding of a thousand steps stays below 1e-12.
std::vector<double> ForceModel::friction(const ModelLayout& layout, const VectorXd& p) const {
  const auto lengths = ladder_.lengths();
  std::vector<double> mu(lengths.size());
  for (std::size_t i = 0; i < mu.size(); ++i) mu[i] = p[0] + (layout.drift ? p[1] * (lengths[i] - S_middle_) : 0);
  for (Index wave = 0; wave < layout.waves; ++wave) {
    const Index at = layout.wave(wave);
    const double wavenumber = pi / p[at + 2];
    const double step = wavenumber * ladder_.sigma_step() * ladder_.sigma_step();
    std::complex<double> phase = std::polar(1.0, wavenumber * (1 - S_middle_));
    std::complex<double> turn = std::polar(1.0, step);
    const std::complex<double> more = std::polar(1.0, 2 * step);
    const auto product = [](std::complex<double> a, std::complex<double> b) {
      return std::complex<double>(a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real());
    };
    for (auto& value : mu) {
      value += p[at] * phase.real() + p[at + 1] * phase.imag();
      phase = product(phase, turn);
      turn = product(turn, more);
    }
  }
  return mu;
}

ForceModel::Response ForceModel::response(const ModelLayout& layout, const VectorXd& p) const {
  const auto mu = friction(layout, p);
  const SlopeArrays curve = ladder_.slopes(mu);
  const double stiffening = 1 + p[layout.stiffness()];
  const double compliance = stiffening / problem_.rig.stiffness;
  const auto measured = measured_curve(curve.w, curve.F, compliance, problem_.record.stage);
  const Index n = force_.size();
  Response model{stiffening * Eigen::Map<const VectorXd>(measured.F.data(), n), {}};

  model.slopes.resize(n, layout.size());
  for (Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::size_t cell = measured.cell[k];
    const double x = measured.fraction[k];
    const double sigma = ladder_.sigma_step() * (static_cast<double>(cell) + x);
    const double S = 1 + sigma * sigma;
    const double F_q = curve.F_q[cell] + x * (curve.F_q[cell + 1] - curve.F_q[cell]);
    const double w_q = curve.w_q[cell] + x * (curve.w_q[cell + 1] - curve.w_q[cell]);
    // At a fold G' vanishes and the force responds without limit, but only until the fibre snaps: the response is that of
    // a curve at least a twentieth as steep as that of rigid loading.
    const double rigid = curve.w[cell + 1] - curve.w[cell];
    const double follow = measured.F_slope[k] / std::max(measured.G_slope[k], 0.05 * rigid);
    const double F_mu = mu[cell] > 0 ? stiffening * (F_q - follow * (w_q + compliance * F_q)) : 0;
    model.slopes(i, 0) = F_mu;
    if (layout.drift) model.slopes(i, 1) = F_mu * (S - S_middle_);
    for (Index wave = 0; wave < layout.waves; ++wave) {
      const Index at = layout.wave(wave);
      const double angle = pi * (S - S_middle_) / p[at + 2];
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      model.slopes(i, at) = F_mu * c;
      model.slopes(i, at + 1) = F_mu * s;
      model.slopes(i, at + 2) = F_mu * (p[at] * s - p[at + 1] * c) * angle / p[at + 2];
    }
    model.slopes(i, layout.stiffness()) = measured.F[k] - stiffening * follow * measured.F[k] / problem_.rig.stiffness;
  }
  return model;
}

VectorXd ForceModel::force(const ModelLayout& layout, const VectorXd& p) const {
  const auto values = force_at(layout, p, problem_.record.stage);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

std::vector<double> ForceModel::force_at(const ModelLayout& layout, const VectorXd& p,
                                         std::span<const double> stages) const {
  const auto curve = ladder_.curve(friction(layout, p));
  const double stiffening = 1 + p[layout.stiffness()];
  auto force = measured_curve(curve.w, curve.F, stiffening / problem_.rig.stiffness, stages).F;
  for (auto& value : force) value *= stiffening;
  return force;
}

bool ForceModel::permits(const ModelLayout& layout, const VectorXd& p) const {
  if (!(std::abs(p[layout.stiffness()]) < 0.3)) return false;  // beyond that it would be another specimen
  if (!(p[0] > 0) || !p.allFinite()) return false;
  constexpr double most_friction = 20;  // that the mechanics covers
  if (layout.drift && p[0] + 2 * length_seen_ * std::abs(p[1]) > most_friction) return false;
  double total = 0;
  for (Index i = 0; i < layout.waves; ++i) {
    const Index at = layout.wave(i);
    const double wavelength = p[at + 2];
    if (!(wavelength > 0.75 * least_wavelength_ && wavelength < 1)) return false;
    total += std::hypot(p[at], p[at + 1]);
    // Two waves closer than the length seen can resolve are one wave, or beats that nothing in the data demands.
    for (Index j = 0; j < i; ++j)
      if (std::abs(1 / wavelength - 1 / p[layout.wave(j) + 2]) < 0.75 / length_seen_) return false;
  }
  return total <= p[0];  // the amplitudes add up to at most 1
}

}  // namespace flexslip
