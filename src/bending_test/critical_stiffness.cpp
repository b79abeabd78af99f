#include "bending_test/critical_stiffness.h"

#include <algorithm>
#include <cmath>

#include "bending_test/reach.h"
#include "bending_test/rig.h"
#include "fibre/limits.h"

namespace flexslip {
namespace {

struct Stretch {
  double from, to;  // [L] of S
};

// Follows a fold from a stretch on which k(S) exceeds what it is at the beginning to a maximum of it, maybe at the end.
// Method: parabolas through the best three points, golden sections where they lead nowhere (Brent): friction may have kinks.
double stiffness_of_cusp(const Friction& friction, const Fibre& fibre, const Stretch& stretch) {
  const auto k_at = [&](double S) { return stiffness_of_fold(friction, S, fibre); };
  constexpr double golden = 0.3819660112501051;
  constexpr double flat = 1e-8;  // of the stretch: k(S) at the maximum is as flat, and known to the square of it
  double low = stretch.from;
  double high = stretch.to;
  double x = low + golden * (high - low);
  double second = x;
  double third = x;
  double k = k_at(x);
  double k_second = k;
  double k_third = k;
  double step = 0;
  double step_before = 0;
  const double tolerance = std::max(flat * (high - low), 0x1p-50 * high);  // and no finer than lengths are
  while (std::max(high - x, x - low) > 2 * tolerance) {
    const double middle = 0.5 * (low + high);
    const double r = (x - second) * (k - k_third);
    const double t = (x - third) * (k - k_second);
    const double parabola = -((x - third) * t - (x - second) * r) / (2 * (t - r));
    const bool is_good = std::abs(parabola) < 0.5 * std::abs(step_before) && x + parabola > low && x + parabola < high;
    step_before = is_good ? step : (x < middle ? high : low) - x;
    step = is_good ? parabola : golden * step_before;
    const double next = x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const double k_next = k_at(next);
    if (k_next >= k) {
      (next >= x ? low : high) = x;
      third = second;
      k_third = k_second;
      second = x;
      k_second = k;
      x = next;
      k = k_next;
    } else {
      (next < x ? low : high) = next;
      if (k_next >= k_second || second == x) {
        third = second;
        k_third = k_second;
        second = next;
        k_second = k_next;
      } else if (k_next >= k_third || third == x || third == second) {
        third = next;
        k_third = k_next;
      }
    }
  }
  return std::max(k, k_at(stretch.to));
}

// The pair of folds whose cusp is likely to be the stiffest.
Stretch stiffest_pair(const SlidingCurve& curve) {
  Stretch stiffest{};
  double most = -infinity;
  for (std::size_t i = 0; i < curve.folds.size(); i += 2) {
    const RigPoint& other = i + 1 < curve.folds.size() ? curve.folds[i + 1].point : curve.end;
    const Stretch pair{curve.folds[i].point.S, other.S};
    const double k = stiffness_of_fold(curve.friction, 0.5 * (pair.from + pair.to), curve.rig.fibre);
    if (k > most) stiffest = pair;
    most = std::max(most, k);
  }
  return stiffest;
}

}  // namespace

double stiffness_of_fold(const Friction& friction, double S, const Fibre& fibre) {
  const auto mu = friction.at(S);
  const auto [state, slopes] = fibre.state_slopes(S, mu.mu);
  return -(slopes.F_S + slopes.F_q * mu.slope) / (slopes.w_S + slopes.w_q * mu.slope);
}

double critical_stiffness(const Friction& friction, double w_max, const Fibre& fibre) {
  constexpr double softest = 1e-6;
  constexpr double above = 1e-9;  // of k: folds nearer to a cusp than that are one to the tracer
  const Rig stiff{infinity, fibre};
  const auto controlled = trace_loading_curve(friction, stiff, longest_in_loading(friction, stiff, w_max));
  if (controlled.begin.stage >= w_max) return 0;  // a thick specimen has not begun to slide in
  const StablePart part = stable_part_from(controlled, controlled.begin);
  if (!controlled.folds.empty() && part.to.stage <= w_max) return infinity;
  const double S_end = part.to.stage > w_max ? point_at_stage(controlled, part, w_max).S : part.to.S;

  double critical = 0;
  double stiffness = softest;
  while (true) {
    const auto curve = trace_loading_curve(friction, {stiffness, fibre}, S_end);
    if (curve.folds.empty()) return critical;
    const double cusp = stiffness_of_cusp(curve.friction, fibre, stiffest_pair(curve));
    if (!(cusp > stiffness)) return critical;  // what the tracer saw is rounding
    critical = cusp;
    stiffness = (1 + above) * cusp;
  }
}

}  // namespace flexslip
