#include "bending_test/curve_samples.h"

#include <cmath>
#include <cstddef>

#include "fibre/batch.h"
#include "fibre/limits.h"

namespace flexslip {
namespace {

// The straight fibre, where derivatives in S are infinite, but not those in x.
CurveSample straight(double direction, double compliance, double q) {
  const double slope = std::sqrt(15.0) / 6 * (1 + 48 * compliance);
  return {true, {1, q, 0, 0, 0, infinity}, direction * slope, slope};
}

// What is known of the fibre at one length.
struct FibreThere {
  double w, F, w_S, w_q, F_S, F_q;  // NaN beyond the end of the branch
};

CurveSample sample_of(double direction, const Rig& rig, double S, const FrictionPoint& mu, const FibreThere& fibre) {
  const double q = direction * mu.mu, compliance = 1 / rig.stiffness;
  if (S == 1 && rig.fibre.begins_straight()) return straight(direction, compliance, q);
  const double sigma = rig.fibre.way(S);  // that of the rounded S, at which everything is evaluated
  const double smooth = fibre.w_S + compliance * fibre.F_S;
  const double rough = direction * (fibre.w_q + compliance * fibre.F_q) * mu.slope;
  return {.exists = !std::isnan(fibre.w),
          .point = {S, q, fibre.w, fibre.F, fibre.w + compliance * fibre.F, smooth + rough},
          .slope = direction * 2 * sigma * (smooth + rough),
          .scale = 2 * sigma * (fibre.w_S + compliance * std::abs(fibre.F_S) + std::abs(rough))};
}

template <class States>
std::vector<CurveSample> samples(const Friction& friction, const Rig& rig, Sliding sliding, std::span<const double> x,
                                 const States& states) {
  const double direction = direction_of(sliding);
  std::vector<double> S(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) S[i] = rig.fibre.length_at(x[i]);
  const FrictionArrays mu = friction.at(S);
  std::vector<double> q(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) q[i] = direction * mu.mu[i];
  const SlopeArrays at = states(FibrePoints(S, q));
  std::vector<CurveSample> result;
  result.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    result.push_back(sample_of(direction, rig, S[i], {mu.mu[i], mu.slope[i]},
                               {at.w[i], at.F[i], at.w_S[i], at.w_q[i], at.F_S[i], at.F_q[i]}));
  return result;
}

}  // namespace

double way_at(const Fibre& fibre, Sliding sliding, double S) { return direction_of(sliding) * fibre.way(S); }

CurveSample sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x) {
  const double S = rig.fibre.length_at(x);
  const double direction = direction_of(sliding);
  const FrictionPoint mu = friction.at(S);
  const auto [state, slopes] = rig.fibre.state_slopes(S, direction * mu.mu);
  return sample_of(direction, rig, S, mu, {state.w, state.F, slopes.w_S, slopes.w_q, slopes.F_S, slopes.F_q});
}

std::vector<CurveSample> samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                    std::span<const double> x) {
  return samples(friction, rig, sliding, x, [&](const FibrePoints& points) { return rig.fibre.states_slopes(points); });
}

std::vector<CurveSample> tabulated_samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                              std::span<const double> x) {
  return samples(friction, rig, sliding, x,
                 [&](const FibrePoints& points) { return rig.fibre.tabulated_states_slopes(points); });
}

}  // namespace flexslip
