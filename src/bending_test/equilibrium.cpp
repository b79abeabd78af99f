#include "bending_test/equilibrium.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/elastica.h"

namespace flexslip {
namespace {

void require_range(double S_max, int n) {
  if (!(S_max > 1 && std::isfinite(S_max)))
    throw std::invalid_argument("S_max must be above 1 and finite, not " + std::to_string(S_max));
  if (n < 2) throw std::invalid_argument("a curve needs at least 2 points, not " + std::to_string(n));
}

double length_at(double S_max, int i, int n) {
  const double fraction = static_cast<double>(i) / (n - 1);
  return i == n - 1 ? S_max : 1 + (S_max - 1) * fraction * fraction;
}

EquilibriumPoint point_of(const FibreState& state) { return {state.S, state.q, state.w, state.F}; }

}  // namespace

EquilibriumCurve equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n) {
  require_range(S_max, n);
  const double sign = sliding == Sliding::in ? 1 : -1;
  const auto state_at = [&](double S) { return fibre_state(S, sign * friction.at(S).mu); };
  EquilibriumCurve curve{EquilibriumStatus::ok, {}};
  curve.points.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const auto state = state_at(length_at(S_max, i, n));
    if (state.status == FibreStatus::ok) {
      curve.points.push_back(point_of(state));
      continue;
    }
    double exists = curve.points.back().S;
    double ended = state.S;
    while (ended - exists > 0x1p-52 * ended) {
      const double middle = 0.5 * (exists + ended);
      if (middle <= exists || middle >= ended) break;
      (state_at(middle).status == FibreStatus::ok ? exists : ended) = middle;
    }
    curve.points.push_back(point_of(state_at(exists)));
    curve.status = EquilibriumStatus::branch_ended;
    break;
  }
  return curve;
}

std::vector<EquilibriumPoint> equilibrium_region(const Friction& friction, double S_max, int n_S, int n_q) {
  require_range(S_max, n_S);
  if (n_q < 2) throw std::invalid_argument("a region needs at least 2 values of q, not " + std::to_string(n_q));
  std::vector<EquilibriumPoint> region;
  for (int i = 0; i < n_S; ++i) {
    const double S = length_at(S_max, i, n_S);
    const double mu = friction.at(S).mu;
    for (int j = 0; j < n_q; ++j) {
      const auto state = fibre_state(S, mu * (2.0 * j / (n_q - 1) - 1));
      if (state.status == FibreStatus::ok) region.push_back(point_of(state));
    }
  }
  return region;
}

}  // namespace flexslip
