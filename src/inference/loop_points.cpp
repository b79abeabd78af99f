#include "inference/loop_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "data/order.h"
#include "fibre/elastica.h"
#include "fibre/elementary.h"
#include "fibre/limits.h"

namespace flexslip::loops {
namespace {

// Slope of q on the stage over points [first, last); NaN where the stage stands still.
double slope_of_q(std::span<const Point> points, std::size_t first, std::size_t last) {
  // From the first position on: where the stage stands still, all are zero, and so is their mean.
  const auto travel = [&](std::size_t i) { return points[i].stage - points[first].stage; };
  double x = 0, y = 0;
  for (std::size_t i = first; i < last; ++i) x += travel(i), y += points[i].q;
  const auto n = static_cast<double>(last - first);
  x /= n;
  y /= n;
  double xx = 0, xy = 0;
  for (std::size_t i = first; i < last; ++i) {
    xx += (travel(i) - x) * (travel(i) - x);
    xy += (travel(i) - x) * (points[i].q - y);
  }
  return xx > 0 ? xy / xx : not_a_number;
}

}  // namespace

double median_or_zero(std::vector<double> values) { return values.empty() ? 0 : median_of(std::move(values)); }

double reading_noise(const ReducedRecord& record, std::span<const Leg> legs) {
  std::vector<double> bends;
  for (const auto& leg : legs)
    for (std::size_t i = leg.first + 1; i + 1 < leg.last; ++i)
      bends.push_back(std::abs(record.force[i - 1] - 2 * record.force[i] + record.force[i + 1]));
  return median_or_zero(bends) / (0.6745 * std::sqrt(6.0));
}

std::vector<LoopLegs> pair_legs(std::span<const Leg> legs) {
  std::vector<LoopLegs> loops;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].direction == Direction::loading)
      loops.push_back({i, std::nullopt, loops.size()});
    else if (loops.empty())
      loops.push_back({std::nullopt, i, 0});
    else
      loops.back().unloading = i;
  }
  return loops;
}

std::vector<Point> locate(const ReducedRecord& record, const Rig& rig, double least_deflection,
                          std::span<const Leg> legs, const Calibration& calibration,
                          std::span<const std::size_t> columns) {
  std::vector<Point> points;
  points.reserve(record.force.size());
  const double scale = elementary::exp(-calibration.log_stiffness);  // of forces
  const double c = 1 / (rig.stiffness * scale);
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const double contact = calibration.contact[columns[leg]];
    for (std::size_t i = legs[leg].first; i < legs[leg].last; ++i) {
      const double w = record.deflection[i] - contact;
      const double F = record.force[i] * scale;
      if (!(w > least_deflection && F > 0)) continue;
      const auto state = rig.fibre.state_from_force(w, F);
      if (state.status != FibreStatus::ok) continue;
      const auto d = rig.fibre.state_slopes(state.S, state.q).slopes;
      // The inverse of the Jacobian of Ψ: its second row.
      const double jacobian = d.w_S * d.F_q - d.w_q * d.F_S;
      const double q_F = d.w_S / jacobian;
      const double q_w = -d.F_S / jacobian;
      points.push_back({.index = i,
                        .leg = leg,
                        .stage = record.stage[i] - contact,
                        .S = state.S,
                        .q = state.q,
                        .q_log_stiffness = -F * q_F,
                        .q_contact = -q_w,
                        .q_force = (q_F - q_w * c) * scale,  // at the stage position imposed
                        .stick_rate = 1 / (d.w_q + c * d.F_q),
                        .slides = true});
    }
  }
  return points;
}

std::vector<std::size_t> leg_starts(std::span<const Point> points, std::size_t legs) {
  std::vector<std::size_t> starts;
  starts.reserve(legs + 1);
  for (std::size_t leg = 0; leg <= legs; ++leg)
    starts.push_back(static_cast<std::size_t>(
        std::partition_point(points.begin(), points.end(), [&](const Point& point) { return point.leg < leg; }) -
        points.begin()));
  return starts;
}

void mark_stuck(std::vector<Point>& points, std::span<const Leg> legs, double force_noise) {
  const auto starts = leg_starts(points, legs.size());
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const std::size_t first = starts[leg];
    const std::size_t last = starts[leg + 1];
    if (first == last || points[first].index != legs[leg].first) continue;
    if (leg == 0 && legs[leg].direction == Direction::loading) continue;
    if (leg > 0 && (first == 0 || points[first - 1].index + 1 != legs[leg].first)) continue;
    const Point& turn = points[leg > 0 ? first - 1 : first];
    const double rate = turn.stick_rate;
    std::vector<double> steps;
    for (std::size_t i = first + 1; i < last; ++i) steps.push_back(std::abs(points[i].stage - points[i - 1].stage));
    const double step = median_or_zero(steps);
    // Points in a window whose slope is known to an eighth of the rate: its standard error is σ/step √(12/m³).
    const double ratio = 8 * force_noise * std::abs(turn.q_force) / (rate * step);
    const double needed = std::cbrt(12 * ratio * ratio);
    const auto window =
        step > 0 ? std::max<std::size_t>(4, static_cast<std::size_t>(std::min(std::ceil(needed), 1e4))) : last - first;
    std::size_t slides_from = last;
    for (std::size_t i = first; i + window < last; ++i)
      if (slope_of_q(points, i, i + window + 1) < 0.25 * rate) {
        // By a third of the window it may still stick: there the slope of a bent line falls to a quarter.
        slides_from = i + window / 3 + 1;
        break;
      }
    for (std::size_t i = first; i < slides_from; ++i) points[i].slides = false;
  }
}

}  // namespace flexslip::loops
