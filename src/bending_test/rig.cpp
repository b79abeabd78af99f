#include "bending_test/rig.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bending_test/sliding_piece.h"
#include "bending_test/sliding_table.h"
#include "contact/over_rollers.h"
#include "numerics/elementary.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

CurveSample sample_on(const SlidingCurve& curve, double x) {
  return tabulated_sample_at(curve.friction, curve.rig, curve.sliding, x);
}

// The stage position, with a sign that makes it increase in the sliding direction.
double advance_of(const SlidingCurve& curve, const RigPoint& point) {
  return direction_of(curve.sliding) * point.stage;
}

double coordinate_of(const SlidingCurve& curve, const RigPoint& point) {
  return coordinate_at(curve.rig.fibre, curve.sliding, point.S);
}

// The error of G at a point, with its derivative.
struct Miss {
  double x, error, slope;
};

// The zero of the error, by the cubic for x as a function of the error through two points with
// their slopes.
double crossing(const Miss& a, const Miss& b) {
  const double h = b.error - a.error;
  return Cubic(a.x, b.x, h / a.slope, h / b.slope).at(-a.error / h).value;
}

// [1] The fraction of the rise between two points that lies below a stage position.
double share_of(const RigPoint& from, const RigPoint& to, double stage) {
  return std::clamp((stage - from.stage) / (to.stage - from.stage), 0.0, 1.0);
}

// The place of G = stage between two points, with G monotone between them, to the accuracy of the
// stored pieces; empty beyond the pieces.
std::optional<double> place_in_pieces(const SlidingCurve& curve, double low, double high, bool rising, double stage) {
  constexpr double close = 1e-5;  // of a piece; the error after a Newton step is its square
  auto piece = std::partition_point(curve.pieces.begin(), curve.pieces.end(),
                                    [&](const CurvePiece& each) { return each.to <= low; });
  for (; piece != curve.pieces.end() && piece->from < high; ++piece) {
    // not in this piece
    if (piece->to < high && (piece->stage.back() < stage) == rising) continue;
    const double from = piece->place_of(std::max(low, piece->from)), to = piece->place_of(std::min(high, piece->to));
    const auto series = CurvePiece::Polynomial::chebyshev(piece->stage);
    const auto miss_at = [&](double t) {
      const auto [value, slope] = series_slope_at(series, t);
      return ValueAndSlope{value - stage, slope};
    };
    const double share = (stage - series_at(series, from)) / (series_at(series, to) - series_at(series, from));
    const double guess = std::clamp(std::lerp(from, to, share), from, to);
    return piece->coordinate_at(zero_between(miss_at, rising ? from : to, rising ? to : from, guess, close));
  }
  return std::nullopt;
}

// The point with G = stage between two lengths, with G monotone between them.
RigPoint point_between(const SlidingCurve& curve, const RigPoint& from, const RigPoint& to, double stage) {
  if (stage == from.stage) return from;
  if (stage == to.stage) return to;
  double low = coordinate_of(curve, from);
  double high = coordinate_of(curve, to);
  const bool rising = to.stage > from.stage;
  Miss last{low, from.stage - stage, 2 * low * from.stage_slope};
  const double chord = std::lerp(low, high, share_of(from, to, stage));
  double x = place_in_pieces(curve, low, high, rising, stage).value_or(chord);
  if (!(x > low && x < high)) x = chord;
  const double rounding = 0x1p-50 * stage;  // in w and F, elastica.h
  RigPoint nearest = from;
  double min_error = infinity;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const CurveSample sample = sample_on(curve, x);
    const Miss miss{x, sample.point.stage - stage, sample.slope};
    if (std::abs(miss.error) < min_error) {
      nearest = sample.point;
      min_error = std::abs(miss.error);
    }
    const double newton = x - miss.error / miss.slope;
    // or below the resolution of S = 1 + x^2
    if (min_error <= rounding || std::abs(x * (newton - x)) <= 0x1p-54) break;
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

void require_on(const SlidingCurve& curve, double S) {
  if (!is_on(curve, S))
    throw std::invalid_argument("length S = " + std::to_string(S) + " is not on the curve, which leads from " +
                                std::to_string(curve.begin.S) + " to " + std::to_string(curve.end.S));
}

// The index of the first fold beyond a length; the number of folds if there is none.
std::size_t first_fold_beyond(const SlidingCurve& curve, double S) {
  const double direction = direction_of(curve.sliding);
  const auto fold = std::partition_point(curve.folds.begin(), curve.folds.end(),
                                         [&](const Fold& f) { return direction * (f.point.S - S) <= 0; });
  return static_cast<std::size_t>(fold - curve.folds.begin());
}

const RigPoint& fold_or_end(const SlidingCurve& curve, std::size_t i) {
  return i < curve.folds.size() ? curve.folds[i].point : curve.end;
}

}  // namespace

double longest_at_stage(double stage) {
  constexpr double min_stage = 1e-6;  // below, S - 1 loses its digits
  if (!(stage >= min_stage && stage < infinity))
    throw std::invalid_argument("stage position must be at least 1e-6 spans, not " + std::to_string(stage));
  constexpr double rounding = 0x1p-51;  // of lengths near 1, at small stage positions
  return 1 + 2.4 * stage * stage + rounding;
}

bool is_on(const SlidingCurve& curve, double S) {
  const double direction = direction_of(curve.sliding);
  const double rounding = 0x1p-51 * S;  // of a length computed from σ²
  return direction * (S - curve.begin.S) >= -rounding && direction * (curve.end.S - S) >= -rounding;
}

RigPoint point_at_length(const SlidingCurve& curve, double S) {
  require_on(curve, S);
  const double direction = direction_of(curve.sliding);
  if (direction * (S - curve.begin.S) <= 0) return curve.begin;
  if (direction * (curve.end.S - S) <= 0) return curve.end;
  return sample_on(curve, coordinate_at(curve.rig.fibre, curve.sliding, S)).point;
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
  require_on(curve, S);
  const double advance = direction_of(curve.sliding) * stage;
  const std::size_t first = first_fold_beyond(curve, S);
  for (std::size_t i = first; i <= curve.folds.size(); ++i) {
    const RigPoint& to = fold_or_end(curve, i);
    if (advance > advance_of(curve, to)) continue;
    const RigPoint from = i > first ? curve.folds[i - 1].point : point_at_length(curve, S);
    if (advance_of(curve, from) <= advance && advance_of(curve, from) < advance_of(curve, to))
      return point_between(curve, from, to, stage);
  }
  return std::nullopt;
}

std::vector<StablePart> stable_parts(const SlidingCurve& curve) {
  std::vector<StablePart> parts{stable_part_from(curve, curve.begin)};
  while (const auto landing = landing_after(curve, parts.back().to.S, parts.back().to.stage))
    parts.push_back(stable_part_from(curve, *landing));
  return parts;
}

RigPoint point_at_stage(const SlidingCurve& curve, const StablePart& part, double stage) {
  const double advance = direction_of(curve.sliding) * stage;
  if (!(advance >= advance_of(curve, part.from) && advance <= advance_of(curve, part.to)))
    throw std::invalid_argument("stage position " + std::to_string(stage) + " is not in the stable part");
  return point_between(curve, part.from, part.to, stage);
}

double end_of_stretch(const Friction& friction, const Fibre& fibre, double S, double S_to, double scales) {
  constexpr double smooth_step = 0.125;  // in σ, over which the elastica varies little
  const double sigma = fibre.sliding_coordinate(S);
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

double longest_in_loading(const Friction& along, const Rig& rig, double stage) {
  if (!(rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(rig.stiffness));
  constexpr double close = 0.99;  // further halving costs more than the shorter trace saves
  const double S_most = longest_at_stage(stage);
  const Friction friction = met(along, rig.fibre, 1, S_most);
  const auto is_beyond = [&](double way) {
    const CurveSample there = tabulated_sample_at(friction, rig, Sliding::in, way);
    return !(there.exists && there.point.stage < stage);
  };
  const auto enough = [](const Bracket& ways) { return !(ways.low < close * ways.high); };
  return rig.fibre.length_at(
      halved_until(enough, {rig.fibre.sliding_coordinate(1), rig.fibre.sliding_coordinate(S_most)}, is_beyond).high);
}

}  // namespace flexslip
