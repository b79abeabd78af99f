#include "bending_test/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bending_test/sliding_table.h"
#include "contact/over_rollers.h"
#include "fibre/batch.h"
#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

void require_range(double S_max, int n) {
  if (!(S_max > 1 && std::isfinite(S_max)))
    throw std::invalid_argument("S_max must be above 1 and finite, not " + std::to_string(S_max));
  if (n < 2) throw std::invalid_argument("a curve needs at least 2 points, not " + std::to_string(n));
}

double length_at(const Fibre& fibre, double S_max, int i, int n) {
  if (i == n - 1) return S_max;
  const double fraction = static_cast<double>(i) / (n - 1);
  if (fibre.slides_inward_only()) return 1 + (S_max - 1) * fraction * fraction;
  return fibre.length_at(fibre.sliding_coordinate(1) +
                         (fibre.sliding_coordinate(S_max) - fibre.sliding_coordinate(1)) * fraction);
}

EquilibriumPoint point_of(const FibreState& state) { return {state.S, state.q, state.w, state.F}; }

// The last state before the end of the branch, between two lengths.
EquilibriumPoint last_point(const Friction& friction, const Fibre& fibre, double sign, double exists, double ended) {
  const auto state_at = [&](double S) { return fibre.state(S, sign * friction.at(S).mu); };
  const auto is_close = [](const Bracket& bracket) { return !(bracket.width() > 0x1p-52 * bracket.high); };
  const auto has_ended = [&](double S) { return state_at(S).status != FibreStatus::ok; };
  return point_of(state_at(halved_until(is_close, {exists, ended}, has_ended).low));
}

template <class States>
EquilibriumCurve curve_of(const Friction& along, const Fibre& fibre, Sliding sliding, double S_max, int n,
                          const States& states) {
  require_range(S_max, n);
  constexpr int at_once = 4096;  // fits the caches of the processor
  const double sign = direction_of(sliding);
  const Friction friction = met(along, fibre, sign, S_max);
  EquilibriumCurve curve{EquilibriumStatus::ok, {}};
  curve.points.reserve(static_cast<std::size_t>(n));
  std::vector<double> S;
  S.reserve(at_once);
  for (int first = 0; first < n; first += at_once) {
    S.clear();
    for (int i = first; i < std::min(n, first + at_once); ++i) S.push_back(length_at(fibre, S_max, i, n));
    std::vector<double> q = friction.at(S).mu;
    for (double& value : q) value *= sign;
    const StateArrays at = states(FibrePoints(S, q));
    for (std::size_t i = 0; i < S.size(); ++i) {
      if (std::isnan(at.w[i])) {
        curve.points.push_back(last_point(friction, fibre, sign, curve.points.back().S, S[i]));
        curve.status = EquilibriumStatus::branch_ended;
        return curve;
      }
      curve.points.push_back({S[i], q[i], at.w[i], at.F[i]});
    }
  }
  return curve;
}

}  // namespace

EquilibriumCurve equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n, const Fibre& fibre) {
  return curve_of(friction, fibre, sliding, S_max, n, [&](const FibrePoints& points) { return fibre.states(points); });
}

std::vector<EquilibriumPoint> sliding_up_to(double deflection, double mu, int n, const Fibre& fibre) {
  if (!(deflection > 0))
    throw std::invalid_argument("a curve needs a deflection > 0, not " + std::to_string(deflection));
  double slid_in = 2.6 * deflection * deflection;
  while (true) {
    const EquilibriumCurve curve = equilibrium_curve(Friction::constant(mu), Sliding::in, 1 + slid_in, n, fibre);
    if (curve.status == EquilibriumStatus::branch_ended || curve.points.back().w >= deflection) return curve.points;
    slid_in *= 1.5;
  }
}

double force_at(std::span<const EquilibriumPoint> curve, double deflection) {
  const auto above = std::lower_bound(curve.begin(), curve.end(), deflection,
                                      [](const EquilibriumPoint& point, double w) { return point.w < w; });
  if (above == curve.begin() || above == curve.end()) return not_a_number;
  const EquilibriumPoint& below = *std::prev(above);
  return std::lerp(below.F, above->F, (deflection - below.w) / (above->w - below.w));
}

EquilibriumCurve tabulated_equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n,
                                             const Fibre& fibre) {
  return curve_of(friction, fibre, sliding, S_max, n,
                  [&](const FibrePoints& points) { return fibre.tabulated_states(points); });
}

std::vector<EquilibriumPoint> equilibrium_region(const Friction& friction, double S_max, int n_S, int n_q,
                                                 const Fibre& fibre) {
  require_range(S_max, n_S);
  if (n_q < 2) throw std::invalid_argument("a region needs at least 2 values of q, not " + std::to_string(n_q));
  const Friction in = met(friction, fibre, 1, S_max), out = met(friction, fibre, -1, S_max);
  std::vector<double> S, q;
  for (int i = 0; i < n_S; ++i) {
    const double length = length_at(fibre, S_max, i, n_S);
    const double max_q = in.at(length).mu, min_q = -out.at(length).mu;
    for (int j = 0; j < n_q; ++j) {
      S.push_back(length);
      q.push_back(0.5 * (max_q + min_q) + 0.5 * (max_q - min_q) * (2.0 * j / (n_q - 1) - 1));
    }
  }
  const StateArrays at = fibre.states({S, q});
  std::vector<EquilibriumPoint> region;
  for (std::size_t i = 0; i < S.size(); ++i)
    if (!std::isnan(at.w[i])) region.push_back({S[i], q[i], at.w[i], at.F[i]});
  return region;
}

}  // namespace flexslip
