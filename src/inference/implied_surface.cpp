#include "inference/implied_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "numerics/elementary.h"
#include "numerics/statistics.h"
#include "surface/height_trace.h"
#include "surface/slope_friction.h"

namespace flexslip {
namespace {

// Slopes at the places, from the trapezoids between which the heights come.
ImpliedProfile profile_of(const std::vector<double>& mu, const std::vector<double>& position) {
  const double base = base_friction(mu);
  ImpliedProfile out;
  for (const double each : mu) out.slope.push_back(slope_of_friction(each, base));
  HeightTrace trace{0, 1, {0}};
  for (std::size_t i = 1; i < mu.size(); ++i)
    trace.height.push_back(trace.height.back() +
                           0.5 * (out.slope[i - 1] + out.slope[i]) * (position[i] - position[i - 1]));
  out.height = levelled(std::move(trace), 1).height;
  return out;
}

// Of positive numbers that were drawn, as if their logarithms were normal; of so few that Student's t is wider.
Estimate estimate_of(const std::vector<double>& drawn) {
  const auto n = static_cast<double>(drawn.size());
  double mean = 0, squares = 0;
  for (const double each : drawn) mean += elementary::log(std::max(each, 1e-300)) / n;
  for (const double each : drawn) {
    const double away = elementary::log(std::max(each, 1e-300)) - mean;
    squares += away * away;
  }
  const double deviation = std::sqrt(squares / (n - 1)), value = elementary::exp(mean);
  const double reach = student_quantile(two_sided_95, n - 1) * std::sqrt(1 + 1 / n) * deviation;
  return {value, value * deviation, value * elementary::exp(-reach), value * elementary::exp(reach)};
}

}  // namespace

ShortWaves without_long_waves(const std::vector<double>& height, double step, double longest) {
  const HeightTrace level = levelled({0, step, height}, 2);
  const HeightTrace waviness = smoothed(level, longest);
  std::vector<double> rest, slopes;
  for (std::size_t i = 0; i < height.size(); ++i) rest.push_back(level.height[i] - waviness.height[i]);
  for (std::size_t i = 1; i < rest.size(); ++i) slopes.push_back((rest[i] - rest[i - 1]) / step);
  return {root_mean_square(slopes), root_mean_square(rest)};
}

std::optional<ImpliedSurface> implied_surface(const FrictionFit& fit) {
  constexpr std::size_t fewest_draws = 5;
  if (fit.status != FrictionFitStatus::ok || fit.draws.size() < fewest_draws) return std::nullopt;
  ImpliedSurface out{};
  for (const double S : fit.mean.S) out.position.push_back(0.5 * fit.between_contacts(S));
  if (!std::is_sorted(out.position.begin(), out.position.end(), std::less_equal<>())) return std::nullopt;
  const double range = out.position.back() - out.position.front();
  const double step = range / static_cast<double>(out.position.size() - 1);
  out.mean = profile_of(fit.mean.mu, out.position);
  out.longest = 0.25 * range;
  std::vector<double> slopes, heights;
  for (const FrictionTable& draw : fit.draws) {
    out.draws.push_back(profile_of(draw.mu, out.position));
    const ShortWaves rms = without_long_waves(out.draws.back().height, step, out.longest);
    slopes.push_back(rms.rms_slope);
    heights.push_back(rms.rms_height);
  }
  if (*std::max_element(slopes.begin(), slopes.end()) < 1e-12) return std::nullopt;  // friction that varies nowhere
  out.rms_slope = estimate_of(slopes);
  out.rms_height = estimate_of(heights);
  return out;
}

}  // namespace flexslip
