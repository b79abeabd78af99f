#include "bending_test/rig.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "bending_test/curve_samples.h"
#include "bending_test/fold_search.h"
#include "contact/over_rollers.h"
#include "fibre/limits.h"

namespace flexslip {
namespace {

// Periods of the roughness in one trace, beyond which it would take seconds.
constexpr double most_periods = 1e6;

CurveSample sample_on(const SlidingCurve& curve, double x) {
  return sample_at(curve.friction, curve.rig, curve.sliding, x);
}

// Stage positions in the sense of the way: a fibre let out meets falling ones.
double advance_of(const SlidingCurve& curve, const RigPoint& point) {
  return direction_of(curve.sliding) * point.stage;
}

double way_of(const SlidingCurve& curve, const RigPoint& point) {
  return way_at(curve.rig.fibre, curve.sliding, point.S);
}

// What G lacks at a point of the way, and its slope there.
struct Miss {
  double x, error, slope;
};

// Where the error vanishes, by the cubic through two points with their slopes that gives x for an error.
double crossing(const Miss& a, const Miss& b) {
  const double h = b.error - a.error;
  const double t = -a.error / h;
  const double rise = b.x - a.x;
  const double d0 = h / a.slope;
  const double d1 = h / b.slope;
  return a.x + t * (d0 + t * (3 * rise - 2 * d0 - d1 + t * (d0 + d1 - 2 * rise)));
}

// The point between two lengths, G being monotone there, at which G = stage.
RigPoint point_between(const SlidingCurve& curve, const RigPoint& from, const RigPoint& to, double stage,
                       std::optional<double> x_guess = {}) {
  if (stage == from.stage) return from;
  if (stage == to.stage) return to;
  double low = way_of(curve, from);
  double high = way_of(curve, to);
  const bool rising = to.stage > from.stage;
  // Steps are short: the tangent where they begin is the best guess, the chord the next.
  Miss last{low, from.stage - stage, 2 * low * from.stage_slope};
  const double tangent = last.x - last.error / last.slope;
  const double chord = low + (high - low) * std::clamp((stage - from.stage) / (to.stage - from.stage), 0.0, 1.0);
  double x = x_guess && *x_guess > low && *x_guess < high ? *x_guess
             : tangent > low && tangent < high            ? tangent
                                                          : chord;
  const double rounding = 0x1p-50 * stage;  // of w and F, elastica.h
  RigPoint nearest = from;
  double least_error = infinity;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const CurveSample sample = sample_on(curve, x);
    const Miss miss{x, sample.point.stage - stage, sample.slope};
    if (std::abs(miss.error) < least_error) {
      nearest = sample.point;
      least_error = std::abs(miss.error);
    }
    const double newton = x - miss.error / miss.slope;
    if (least_error <= rounding || std::abs(x * (newton - x)) <= 0x1p-54) break;  // or less than S = 1 + x^2 can tell
    ((miss.error < 0) == rising ? low : high) = x;
    double next = crossing(last, miss);
    if (!(next > low && next < high)) next = newton;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (!(next > low && next < high)) break;
    last = miss;
    x = next;
  }
  return nearest;
}

void require_traceable(const Friction& friction, const Rig& rig, double S_max) {
  if (!(rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(rig.stiffness));
  if (!(S_max > 1 && S_max < infinity))
    throw std::invalid_argument("S_max must be above 1 and finite, not " + std::to_string(S_max));
  constexpr double finest = 1e-9;  // of a period, in spans: finer ones would be lost in the rounding of S
  if (4 * friction.smooth_scale() < finest)
    throw std::invalid_argument("a period of the roughness of " + std::to_string(4e9 * friction.smooth_scale()) +
                                "e-9 spans is finer than 1e-9 spans, the finest that is traced");
  const double periods = (S_max - 1) / (4 * friction.smooth_scale());
  if (periods > most_periods)
    throw std::invalid_argument("the roughness has " + std::to_string(periods) +
                                " periods on this length; at most 1e6 are traced");
}

// The first fold beyond a length, on the way; the number of folds if there is none.
std::size_t first_fold_beyond(const SlidingCurve& curve, double S) {
  const double x = way_at(curve.rig.fibre, curve.sliding, S);
  const auto fold = std::partition_point(curve.folds.begin(), curve.folds.end(),
                                         [&](const Fold& f) { return way_of(curve, f.point) <= x; });
  return static_cast<std::size_t>(fold - curve.folds.begin());
}

const RigPoint& fold_or_end(const SlidingCurve& curve, std::size_t i) {
  return i < curve.folds.size() ? curve.folds[i].point : curve.end;
}

}  // namespace

SlidingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max) {
  require_traceable(friction, rig, S_max);
  return find_folds(met(friction, rig.fibre, 1, S_max), rig, Sliding::in, 1, S_max);
}

SlidingCurve trace_unloading_curve(const Friction& friction, const Rig& rig, double S_from) {
  require_traceable(friction, rig, S_from);
  return find_folds(met(friction, rig.fibre, -1, S_from), rig, Sliding::out, S_from, 1);
}

double longest_at_stage(double stage) {
  constexpr double least = 1e-6;  // below it S - 1 has lost its digits
  if (!(stage >= least && stage < infinity))
    throw std::invalid_argument("stage position must be at least 1e-6 spans, not " + std::to_string(stage));
  constexpr double rounding = 0x1p-51;  // of the lengths near 1 that belong to small stage positions
  return 1 + 2.4 * stage * stage + rounding;
}

RigPoint point_at_length(const SlidingCurve& curve, double S) {
  // A length is known to its rounding: that of σ², of which it is made.
  const double rounding = 0x1p-51 * S;
  const double direction = direction_of(curve.sliding);
  if (!(direction * (S - curve.begin.S) >= -rounding && direction * (curve.end.S - S) >= -rounding))
    throw std::invalid_argument("length S = " + std::to_string(S) + " is not on the curve, which leads from " +
                                std::to_string(curve.begin.S) + " to " + std::to_string(curve.end.S));
  if (direction * (S - curve.begin.S) <= 0) return curve.begin;
  if (direction * (curve.end.S - S) <= 0) return curve.end;
  return sample_on(curve, way_at(curve.rig.fibre, curve.sliding, S)).point;
}

std::vector<OverallEquilibrium> overall_equilibria(const SlidingCurve& curve, double stage) {
  const double close = 1e-9 * stage;
  std::vector<OverallEquilibrium> found;
  RigPoint from = curve.begin;
  for (std::size_t i = 0; i <= curve.folds.size(); ++i) {
    const bool is_fold = i < curve.folds.size();
    const RigPoint to = is_fold ? curve.folds[i].point : curve.end;
    const bool stable = advance_of(curve, to) > advance_of(curve, from);
    const bool at_from = i > 0 && std::abs(from.stage - stage) <= close;
    const bool at_to = is_fold && std::abs(to.stage - stage) <= close;
    if (!at_from && !at_to && std::min(from.stage, to.stage) <= stage && stage <= std::max(from.stage, to.stage))
      found.push_back({point_between(curve, from, to, stage), stable ? Stability::stable : Stability::unstable});
    if (at_to) found.push_back({to, Stability::partially_stable});
    from = to;
  }
  return found;
}

StablePart stable_part_from(const SlidingCurve& curve, const RigPoint& point) {
  const RigPoint& next = fold_or_end(curve, first_fold_beyond(curve, point.S));
  return {point, advance_of(curve, next) > advance_of(curve, point) ? next : point};
}

std::optional<RigPoint> landing_after(const SlidingCurve& curve, double S, double stage) {
  const double advance = direction_of(curve.sliding) * stage;
  RigPoint from = point_at_length(curve, S);
  for (std::size_t i = first_fold_beyond(curve, S); i <= curve.folds.size(); ++i) {
    const RigPoint& to = fold_or_end(curve, i);
    if (advance_of(curve, from) <= advance && advance <= advance_of(curve, to) &&
        advance_of(curve, to) > advance_of(curve, from))
      return point_between(curve, from, to, stage);
    from = to;
  }
  return std::nullopt;
}

std::vector<StablePart> stable_parts(const SlidingCurve& curve) {
  std::vector<StablePart> parts{stable_part_from(curve, curve.begin)};
  while (const auto landing = landing_after(curve, parts.back().to.S, parts.back().to.stage))
    parts.push_back(stable_part_from(curve, *landing));
  return parts;
}

RigPoint point_at_stage(const SlidingCurve& curve, const StablePart& part, double stage,
                        std::optional<double> S_guess) {
  const double advance = direction_of(curve.sliding) * stage;
  if (!(advance >= advance_of(curve, part.from) && advance <= advance_of(curve, part.to)))
    throw std::invalid_argument("stage position " + std::to_string(stage) + " is not in the stable part");
  if (S_guess) S_guess = way_at(curve.rig.fibre, curve.sliding, *S_guess);
  return point_between(curve, part.from, part.to, stage, S_guess);
}

double end_of_stretch(const Friction& friction, const Fibre& fibre, double S, double S_to, double scales) {
  constexpr double smooth_step = 0.125;  // in σ, over which the elastica itself varies little
  const double sigma = fibre.way(S);
  const auto knots = friction.knots();
  if (S_to > S) {
    const auto knot = std::upper_bound(knots.begin(), knots.end(), S);
    const double end = std::min({S_to, friction.end_of(S, scales, true), fibre.length_at(sigma + smooth_step)});
    return knot == knots.end() ? end : std::min(end, *knot);
  }
  const auto knot = std::lower_bound(knots.begin(), knots.end(), S);
  const double end =
      std::max({S_to, friction.end_of(S, scales, false), fibre.length_at(std::max(sigma - smooth_step, 0.0))});
  return knot == knots.begin() ? end : std::max(end, *std::prev(knot));
}

}  // namespace flexslip
