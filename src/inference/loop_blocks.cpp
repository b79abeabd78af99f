#include "inference/loop_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fibre/elementary.h"

namespace flexslip::loops {
namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
constexpr std::size_t most_places = 100;  // of a loop: finer than bumps, coarser than readings

}  // namespace

std::vector<Block> make_blocks(std::span<const Point> points, std::span<const LoopLegs> loops, std::size_t legs,
                               double force_noise) {
  const auto starts = leg_starts(points, legs);
  std::vector<Block> blocks;
  for (const auto& loop : loops) {
    Block block{.rows = {}, .column = loop.column, .roughness = 0, .range = 0};
    double variation = 0, noise = 0, length = 0;
    const auto add = [&](std::size_t leg, double side) {
      for (std::size_t i = starts[leg]; i < starts[leg + 1]; ++i) {
        const Point& point = points[i];
        if (!point.slides) continue;
        const double unit = point.q_force * point.q_force;
        block.rows.push_back(
            {side, point.S, unit, {side * point.q, -side * point.q_log_stiffness, -side * point.q_contact}});
        if (i == starts[leg] || !points[i - 1].slides) continue;
        variation += std::pow(point.q - points[i - 1].q, 2);
        noise += force_noise * force_noise * (unit + points[i - 1].q_force * points[i - 1].q_force);
        length += std::abs(point.S - points[i - 1].S);
      }
    };
    if (loop.loading) add(*loop.loading, 1);
    if (loop.unloading) add(*loop.unloading, -1);
    std::stable_sort(block.rows.begin(), block.rows.end(), [](const Row& a, const Row& b) { return a.S < b.S; });
    if (!block.rows.empty()) block.range = block.rows.back().S - block.rows.front().S;
    // Rather too rough, which only widens the band of μ, than too smooth, which would bend μ.
    if (length > 0)
      block.roughness = std::max({variation - noise, 0.1 * variation, least_noise * least_noise}) / length;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

Pairs pair_directions(const Block& block) {
  std::vector<const Row*> in, out;
  for (const auto& row : block.rows) (row.side > 0 ? in : out).push_back(&row);
  Pairs places;
  if (in.size() < 2 || out.size() < 2) return places;
  std::vector<double> gaps;
  gaps.reserve(in.size());
  for (std::size_t i = 1; i < in.size(); ++i) gaps.push_back(in[i]->S - in[i - 1]->S);
  const double widest = 8 * median_or_zero(gaps);  // wider ones are snaps, within which nothing was measured

  const double low = std::max(in.front()->S, out.front()->S);
  const double high = std::min(in.back()->S, out.back()->S);
  if (!(high > low)) return places;
  const auto count = std::clamp<std::size_t>(std::min(in.size(), out.size()) / 2, 1, most_places);
  const double width = (high - low) / static_cast<double>(count);
  std::size_t place = nowhere;
  double members = 0;
  double brackets = 0;     // of points sliding in
  double in_variance = 0;  // sums over the members
  double out_variance = 0;
  const Row* bracket = nullptr;
  const auto close = [&] {
    if (place == nowhere) return;
    const auto scale = [&](double& sum) { sum /= members; };
    scale(places.S.back());
    scale(places.in.back());
    scale(places.out.back());
    for (double& sum : places.in_slopes.back()) scale(sum);
    for (double& sum : places.out_slopes.back()) scale(sum);
    places.noise_of_unit.push_back((in_variance / brackets + out_variance / members) / members);
  };
  for (const Row* row : out) {
    if (row->S < low || row->S > high) continue;
    const auto after = std::lower_bound(in.begin(), in.end(), row->S, [](const Row* a, double S) { return a->S < S; });
    if (after == in.begin() || after == in.end()) continue;
    const Row& b = **after;
    const Row& a = **(after - 1);
    if (b.S - a.S > widest || !(b.S > a.S)) continue;
    const double t = (row->S - a.S) / (b.S - a.S);
    const auto between = [&](std::size_t j) { return (1 - t) * a.y[j] + t * b.y[j]; };
    const auto here = std::min(static_cast<std::size_t>((row->S - low) / width), count - 1);
    if (here != place) {
      close();
      place = here;
      members = brackets = in_variance = out_variance = 0;
      bracket = nullptr;
      places.S.push_back(0);
      places.in.push_back(0);
      places.out.push_back(0);
      places.in_slopes.push_back({});
      places.out_slopes.push_back({});
    }
    ++members;
    places.S.back() += row->S;
    places.in.back() += between(0);
    places.out.back() += row->y[0];
    for (std::size_t j = 0; j < 2; ++j) {
      places.in_slopes.back()[j] -= between(j + 1);  // y holds regressors, minus the slopes
      places.out_slopes.back()[j] -= row->y[j + 1];
    }
    out_variance += row->variance_of_unit;
    in_variance += (1 - t) * a.variance_of_unit + t * b.variance_of_unit;
    if (bracket != &a) ++brackets;
    bracket = &a;
  }
  close();
  return places;
}

Smoothed smooth(const Block& block, const Noise& noise) {
  struct Step {
    Eigen::Matrix<double, 2, 3> predicted, mean;  // of (μ, δ)
    Eigen::Matrix2d predicted_covariance, covariance, transition;
  };
  constexpr double diffuse = 1e4;  // variance of μ before the first row: friction is below 100
  const double power = noise.difference * noise.difference;
  const std::size_t n = block.rows.size();
  std::vector<Step> steps;
  steps.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Row& row = block.rows[i];
    Step step;
    if (i == 0) {
      step.transition.setIdentity();
      step.predicted.setZero();
      step.predicted_covariance << diffuse, 0, 0, power;
    } else {
      const double distance = row.S - block.rows[i - 1].S;
      const double decay = elementary::exp(-distance / noise.length);
      step.transition << 1, 0, 0, decay;
      step.predicted = step.transition * steps.back().mean;
      step.predicted_covariance = step.transition * steps.back().covariance * step.transition;
      step.predicted_covariance(0, 0) += block.roughness * distance;
      step.predicted_covariance(1, 1) += power * (1 - decay * decay);
    }
    const Eigen::Vector2d h(1, 0.5 * row.side);
    const Eigen::Vector2d Ph = step.predicted_covariance * h;
    const double variance = h.dot(Ph) + noise.force * noise.force * row.variance_of_unit + least_noise * least_noise;
    const Eigen::RowVector3d y(row.y[0], row.y[1], row.y[2]);
    step.mean = step.predicted + Ph * (y - h.transpose() * step.predicted) / variance;
    step.covariance = step.predicted_covariance - Ph * Ph.transpose() / variance;
    steps.push_back(step);
  }
  Smoothed result{std::vector<Eigen::Vector3d>(n), std::vector<double>(n)};
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) {
      const Step& next = steps[i + 1];
      const Eigen::Matrix2d gain = steps[i].covariance * next.transition * next.predicted_covariance.inverse();
      steps[i].mean += gain * (next.mean - next.predicted);
      steps[i].covariance += gain * (next.covariance - next.predicted_covariance) * gain.transpose();
    }
    result.mu[i] = steps[i].mean.row(0).transpose();
    result.variance[i] = std::max(steps[i].covariance(0, 0), 0.0);
  }
  return result;
}

}  // namespace flexslip::loops
