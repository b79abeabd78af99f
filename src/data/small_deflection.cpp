#include "data/small_deflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t min_points = 5;                          // of a line that is to tell its own error
constexpr double max_correlation = 0.95;                       // beyond it the stretch is too short to tell
constexpr double step = 0.05, width = 0.25, last_up_to = 0.9;  // [greatest force] of the windows tried
constexpr double max_deflection = 0.1;  // [span] beyond it a deflection is not small, where the span is known
constexpr double strain_from = 0.0005, strain_to = 0.0025;  // ISO 178

void require(bool holds, const char* what, double value) {
  if (holds) return;
  std::ostringstream message;
  message << what << " = " << value << " is out of its range";
  throw std::invalid_argument(message.str());
}

std::ptrdiff_t as_difference(std::size_t points) { return static_cast<std::ptrdiff_t>(points); }

struct Straight {
  ForceWindow window;
  std::size_t first, last;
  Estimate slope;
  double origin;
};

std::optional<Straight> straight_in(const Record& record, std::size_t points, double most, ForceWindow window) {
  const auto force = std::span(record.force).first(points);
  std::size_t last = 0;
  while (last < points && force[last] <= window.up_to * most) ++last;
  std::size_t first = last;
  while (first > 0 && force[first - 1] >= window.from * most) --first;
  const std::size_t n = last - first;
  // A window that the record does not leave above is not covered; the one up to the greatest force is left by none.
  if (n < min_points || (last == points && window.up_to < 1)) return std::nullopt;

  const auto F = force.subspan(first, n);
  const auto w = std::span(record.deflection).subspan(first, n);
  const auto stage = std::span(record.stage).subspan(first, n);
  const CommonLine line = common_line(stage, F, w);
  if (std::isnan(line.slope)) return std::nullopt;
  const double error = slope_error(line, correlation_lost_to_line(line.residuals), max_correlation);
  return Straight{window, first, last, normal_estimate(line.slope, error), line.z.mean_y - line.y.mean_y / line.slope};
}

std::optional<Straight> steepest(const Record& record, std::size_t points, double most,
                                 const SmallDeflectionOptions& options) {
  if (options.window) return straight_in(record, points, most, *options.window);
  std::optional<Straight> best;
  for (int i = 1; i * step + width <= last_up_to + 0.5 * step; ++i) {
    const auto tried = straight_in(record, points, most, {i * step, i * step + width});
    if (tried && (!best || tried->slope.value > best->slope.value)) best = tried;
  }
  return best;
}

// The force where the deflection first reaches a value.
std::optional<double> force_at(const Record& record, std::size_t points, double deflection) {
  const auto& w = record.deflection;
  for (std::size_t i = 1; i < points; ++i) {
    if (!(w[i - 1] <= deflection && deflection < w[i])) continue;
    const double share = (deflection - w[i - 1]) / (w[i] - w[i - 1]);
    return std::lerp(record.force[i - 1], record.force[i], share);
  }
  return std::nullopt;
}

std::optional<Chord> chord_of(const Record& record, std::size_t points, const Straight& straight, double span,
                              const Section& section) {
  const double deflection_per_strain = span * span / (6 * depth(section));
  const double from = strain_from * deflection_per_strain;
  const double to = strain_to * deflection_per_strain;
  const auto low = force_at(record, points, straight.origin + from);
  const auto high = force_at(record, points, straight.origin + to);
  if (!low || !high || !(*high > *low)) return std::nullopt;
  const double noise = force_noise(record);
  const Estimate slope = normal_estimate((*high - *low) / (to - from), std::numbers::sqrt2 * noise / (to - from));
  return Chord{slope, from, to, slope.value * span * span * span / (48 * second_moment(section))};
}

}  // namespace

std::optional<double> usual_roller_radius(const BeamGeometry& geometry) {
  constexpr double thinnest = 1e-3, thin = 3e-3;          // [m] of the bars of ISO 178
  constexpr double radius_of_thin = 2e-3, radius = 5e-3;  // [m]
  constexpr double least_spans = 8;                       // of the thinnest bar, 16 times as long as thick
  if (!geometry.span || !geometry.section || !(depth(*geometry.section) > thinnest)) return std::nullopt;
  const double usual = depth(*geometry.section) > thin ? radius : radius_of_thin;
  return *geometry.span >= least_spans * usual ? std::optional(usual) : std::nullopt;
}

SmallDeflection small_deflection(const Record& record, const BeamGeometry& geometry,
                                 const SmallDeflectionOptions& options) {
  if (options.window) {
    require(options.window->from >= 0 && options.window->from < options.window->up_to, "window from",
            options.window->from);
    require(options.window->up_to <= 1, "window up to", options.window->up_to);
  }
  if (geometry.span) require(*geometry.span > 0 && std::isfinite(*geometry.span), "span", *geometry.span);

  SmallDeflection result{};
  result.status = SmallDeflectionStatus::no_straight_part;
  if (record.force.size() < min_points) return result;
  const auto greatest =
      static_cast<std::size_t>(std::max_element(record.force.begin(), record.force.end()) - record.force.begin());
  const double most = record.force[greatest];
  if (!(most > 0)) return result;
  const std::size_t points = greatest + 1;
  std::size_t small = points;  // of them, the ones before the deflection is large
  if (geometry.span) {
    const double limit = max_deflection * *geometry.span;
    const auto beyond = std::find_if(record.deflection.begin(), record.deflection.begin() + as_difference(points),
                                     [=](double w) { return w > limit; });
    small = static_cast<std::size_t>(beyond - record.deflection.begin());
  }
  if (small < min_points) return result;
  const double reference = *std::max_element(record.force.begin(), record.force.begin() + as_difference(small));
  const auto straight = steepest(record, small, reference, options);
  if (!straight) return result;

  result.status = SmallDeflectionStatus::ok;
  result.window = straight->window;
  result.window_force = reference;
  result.first = straight->first;
  result.last = straight->last;
  result.stiffness = straight->slope;
  result.origin = straight->origin;
  result.greatest_force = most;
  result.deflection = record.deflection[greatest] - straight->origin;
  if (!geometry.span) return result;
  const double L = *geometry.span;
  result.deflection_large = result.deflection > max_deflection * L;
  result.bending_stiffness = straight->slope.value * L * L * L / 48;
  if (!geometry.section) return result;
  const double I = second_moment(*geometry.section);
  const double h = depth(*geometry.section);
  result.shear_share = shear_share(*geometry.section, L);
  result.modulus = *result.bending_stiffness / I;
  result.stress = most * L * h / (8 * I);
  result.strain = 6 * result.deflection * h / (L * L);
  result.chord = chord_of(record, points, *straight, L, *geometry.section);
  return result;
}

}  // namespace flexslip
