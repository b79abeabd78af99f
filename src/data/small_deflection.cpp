#include "data/small_deflection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "data/drops.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/require.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t min_on_a_line = 3;  // points, the minimum that can show curvature
constexpr double max_correlation = 0.95;  // beyond it the region is too short
constexpr double min_rise = 0.25;         // [maximum force] length of a candidate
// of a slope, above which the steepest of many is not steep by chance
constexpr double chance_errors = 3;
constexpr double same_slope = 1e-6;    // [slope] within it, the longest candidate is chosen
constexpr double levels = 50;          // of the force, at which candidates begin and end
constexpr double largest_error = 0.5;  // [stiffness] beyond it the status is uncertain
// [span] limit of a small deflection, if the span is known
constexpr double max_deflection = 0.1;
constexpr double strain_from = 0.0005, strain_to = 0.0025;  // ISO 178
constexpr double conventional_strain = 0.035;               // ISO 178
// [1] excess of the linear region over the chord in tests of laboratories that report the chord
constexpr double usual_excess = 0.1;
constexpr double levelled = 0.1;       // [initial slope]
constexpr double elastic_share = 0.2;  // [span]
constexpr double clearly = 3;          // errors

struct PointRange {
  std::size_t first, last;  // [first, last)
};

// [N] Error of a force reading, from second differences, which allow for the curvature of short
// records. They give 0 if the force often repeats; then force_noise.
double noise_of(const Record& record) {
  constexpr std::size_t min_points = 11;
  const double noise = noise_of_second_differences(second_differences(record.force));
  return noise > 0 || record.force.size() < min_points ? noise : force_noise(record);
}

// The line through points [first, last).
std::optional<LinearRegion> line_of(const Record& record, std::size_t first, std::size_t last, double noise,
                                    double load_train_error) {
  const std::size_t n = last - first;
  const auto F = std::span(record.force).subspan(first, n);
  const auto w = std::span(record.deflection).subspan(first, n);
  const CommonLine line = common_line(std::span(record.stage).subspan(first, n), F, w);
  if (std::isnan(line.slope)) return std::nullopt;
  // The load train turns errors of the force into errors of the deflection; both affect the line.
  const double least = noise / (line.z.slope * line.z.slope * std::sqrt(line.y.sum_xx));
  const double scatter = std::max(slope_error(line, correlation_lost_to_line(line.residuals), max_correlation), least);
  const double share = 1 - line.z.slope;
  const double of_load_train = line.slope * share / line.z.slope * load_train_error;
  return LinearRegion{.window = {},
                      .window_force = 0,
                      .first = first,
                      .last = last,
                      .slope = normal_estimate(line.slope, elementary::length(scatter, of_load_train)),
                      .origin = line.z.mean_y - line.y.mean_y / line.slope,
                      .origin_before_record = 0,
                      .load_train_share = share};
}

std::optional<LinearRegion> region_in(const Record& record, std::size_t points, double max_force, ForceWindow window,
                                      double noise, double load_train_error) {
  const auto force = std::span(record.force).first(points);
  std::size_t last = 0;
  while (last < points && force[last] <= window.up_to * max_force) ++last;
  std::size_t first = last;
  while (first > 0 && force[first - 1] >= window.from * max_force) --first;
  // A window is covered only if the record extends beyond it, except one up to the maximum force.
  if (last - first < min_on_a_line || (last == points && window.up_to < 1)) return std::nullopt;
  auto linear = line_of(record, first, last, noise, load_train_error);
  if (linear) linear->window = window;
  return linear;
}

// Cumulative sums over the points of a record; the sums of a region are their differences.
class RegionSums {
 public:
  RegionSums(const Record& record, std::size_t points, double noise) : noise_(noise) {
    const auto stage = std::span(record.stage).first(points), force = std::span(record.force).first(points),
               deflection = std::span(record.deflection).first(points);
    const std::array middle{mean_of(stage), mean_of(force), mean_of(deflection)};
    sums_.push_back({});
    for (std::size_t i = 0; i < points; ++i) {
      const Point at{stage[i] - middle[0], force[i] - middle[1], deflection[i] - middle[2]};
      const auto& [x, y, z] = at;
      const auto& [x0, y0, z0] = points_.empty() ? Point{} : points_.back();
      const Sums added{x, y, z, x * x, x * y, x * z, y * y, y * z, z * z, y * y0, y * z0 + z * y0, z * z0};
      Sums next = sums_.back();
      for (std::size_t k = 0; k < next.size(); ++k) next[k] += added[k];
      sums_.push_back(next);
      points_.push_back(at);
    }
  }

  // The slope of points [first, last) minus its chance part, with the errors of line_of. Empty if
  // force or deflection does not rise.
  std::optional<double> lower_slope(std::size_t first, std::size_t last) const {
    const auto n = static_cast<double>(last - first);
    Sums of = sums_[last];
    for (std::size_t k = 0; k < of.size(); ++k) of[k] -= sums_[first][k];
    const auto& [x, y, z, xx, xy, xz, yy, yz, zz, yy1, yz1, zz1] = of;
    const double sum_xx = xx - x * x / n;
    const double force = (xy - x * y / n) / sum_xx, deflection = (xz - x * z / n) / sum_xx;
    if (!(sum_xx > 0 && force > 0 && deflection > 0)) return std::nullopt;
    const double slope = force / deflection, offset = (y - slope * z) / n;
    const double squares = yy - 2 * slope * yz + slope * slope * zz - n * offset * offset;
    // Products of neighbouring residuals, without the pair that crosses the start.
    const auto lies = [&](std::size_t i) { return points_[i].y - slope * points_[i].z; };
    const double before = first > 0 ? lies(first) * lies(first - 1) : 0;
    const double lagged =
        yy1 - slope * yz1 + slope * slope * zz1 - before - offset * ((n + 1) * offset - lies(first) - lies(last - 1));
    const double shown = squares > 0 ? lagged / squares : 0;
    const double rho = std::clamp(shown + (2 + 4 * shown) / n, 0.0, max_correlation);
    const double scatter = std::sqrt(std::max(squares, 0.0) / (n - 2) * (1 + rho) / (1 - rho));
    return slope - chance_errors * std::max(scatter, noise_ / deflection) / (deflection * std::sqrt(sum_xx));
  }

 private:
  struct Point {
    double x, y, z;  // [m], [N], [m] from the means
  };
  using Sums = std::array<double, 12>;
  std::vector<Point> points_;
  std::vector<Sums> sums_;
  double noise_;
};

// The points up to the first drop that starts high enough for a region before it.
std::size_t points_before_teeth(const Record& record, std::size_t points, double max_force,
                                const std::vector<std::size_t>& halts) {
  const Drops found = find_drops(first_points(record, points), {.halts = halts});
  if (found.status != DropStatus::ok) return points;
  for (const Drop& drop : found.drops)
    if (record.force[drop.before] - record.force.front() >= min_rise * max_force) return drop.before + 1;
  return points;
}

std::optional<LinearRegion> steepest(const Record& record, std::size_t points, double max_force, double noise,
                                     const SmallDeflectionOptions& options) {
  points = points_before_teeth(record, points, max_force, options.halts);
  const RegionSums sums(record, points, noise);
  const auto& force = record.force;
  // Regions begin and end where the force reaches a level, and at neighbouring points, because a
  // single row may lie between two levels.
  std::vector<std::size_t> ends{0};
  const auto add = [&](std::size_t point) {
    if (point > ends.back()) ends.push_back(point);
  };
  double level = std::floor(levels * force.front() / max_force);
  for (std::size_t i = 1; i < points; ++i)
    if (const double at = std::floor(levels * force[i] / max_force); at > level) {
      for (const std::size_t point : {i - 1, i, i + 1}) add(point);
      level = at;
    }
  add(points);
  std::optional<PointRange> best;
  double steepness = 0;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = ends.size(); j-- > i;) {
      const std::size_t first = ends[i], last = ends[j];
      if (last < first + min_on_a_line || force[last - 1] - force[first] < min_rise * max_force) continue;
      const auto slope = sums.lower_slope(first, last);
      if (!slope || *slope <= steepness * (1 + same_slope)) continue;
      best = PointRange{first, last};
      steepness = *slope;
    }
  if (!best) return std::nullopt;
  auto linear = line_of(record, best->first, best->last, noise, options.load_train_error);
  if (linear) linear->window = {std::max(force[best->first] / max_force, 0.0), force[best->last - 1] / max_force};
  return linear;
}

// The force at which the deflection first reaches a value.
std::optional<double> force_at(const Record& record, std::size_t points, double deflection) {
  const auto& w = record.deflection;
  for (std::size_t i = 1; i < points; ++i) {
    if (!(w[i - 1] <= deflection && deflection < w[i])) continue;
    const double share = (deflection - w[i - 1]) / (w[i] - w[i - 1]);
    return std::lerp(record.force[i - 1], record.force[i], share);
  }
  return std::nullopt;
}

// An estimate times an exact factor, with another relative error.
Estimate scaled(const Estimate& estimate, double factor, double relative_error) {
  const double own = estimate.standard_error / estimate.value;
  const double value = factor * estimate.value;
  return normal_estimate(value, value * elementary::length(own, relative_error));
}

Estimate bending_stiffness_from(const Estimate& slope, const BeamGeometry& geometry) {
  return scaled(slope, beam_bending_stiffness(1, *geometry.span), 3 * geometry.span_error);
}

Estimate modulus_from(const Estimate& slope, const BeamGeometry& geometry) {
  return scaled(bending_stiffness_from(slope, geometry), 1 / second_moment(*geometry.section), geometry.moment_error);
}

// Domain:     a geometry with span and section.
std::optional<Chord> chord_of(const Record& record, std::size_t points, double origin, double load_train_share,
                              double load_train_error, double noise, const BeamGeometry& geometry) {
  const double deflection_per_strain = *geometry.span * *geometry.span / (6 * depth(*geometry.section));
  const double from = strain_from * deflection_per_strain;
  const double to = strain_to * deflection_per_strain;
  const auto low = force_at(record, points, origin + from);
  const auto high = force_at(record, points, origin + to);
  if (!low || !high || !(*high > *low)) return std::nullopt;
  const double slope = (*high - *low) / (to - from);
  const double error = elementary::length(std::numbers::sqrt2 * noise / (to - from) / (1 - load_train_share),
                                          slope * load_train_share / (1 - load_train_share) * load_train_error);
  const Estimate estimate = normal_estimate(slope, error);
  return Chord{estimate, from, to, modulus_from(estimate, geometry)};
}

// [1] How much steeper than the chord supports and friction can make the linear region.
double explained(const Chord& chord, double origin, const LinearRegion& linear, const Record& record,
                 const BeamGeometry& geometry, const Steepening& steepening) {
  if (!steepening) return max_steepening(geometry, linear.middle(record) - origin);
  return steepening({origin + chord.deflection_from, origin + chord.deflection_to},
                    {record.deflection[linear.first], record.deflection[linear.last - 1]});
}

// [1] Fraction of the stage travel up to a point.
double load_train_share(const Record& record, std::size_t point) {
  const double travel = record.stage[point] - record.stage.front();
  return travel > 0 ? 1 - (record.deflection[point] - record.deflection.front()) / travel : 0;
}

// [N/m] Slope of the force over the last tenth of the deflection.
double slope_at_end(const Record& record, double origin) {
  constexpr double part = 0.1;
  const double from = origin + (1 - part) * (record.deflection.back() - origin);
  std::size_t first = record.deflection.size() - std::min(record.deflection.size(), min_on_a_line);
  while (first > 0 && record.deflection[first - 1] >= from) --first;
  const std::size_t n = record.deflection.size() - first;
  const auto w = std::span(record.deflection).subspan(first, n);
  const auto F = std::span(record.force).subspan(first, n);
  const double middle = mean_of(w), level = mean_of(F);
  double sum_ww = 0, sum_wF = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum_ww += (w[i] - middle) * (w[i] - middle);
    sum_wF += (w[i] - middle) * (F[i] - level);
  }
  return sum_ww > 0 ? sum_wF / sum_ww : 0;
}

}  // namespace

std::optional<double> standard_roller_radius(const BeamGeometry& geometry) {
  constexpr double thinnest = 1e-3, thin = 3e-3;          // [m] of the bars of ISO 178
  constexpr double radius_of_thin = 2e-3, radius = 5e-3;  // [m]
  // for the thinnest bar, whose span is 16 times its thickness
  constexpr double min_spans = 8;
  constexpr double spans_of_small = 20;  // ASTM C1161, size A: 1 mm on 20 mm
  if (!geometry.span || geometry.support_radius) return std::nullopt;
  const double thickness = geometry.section ? depth(*geometry.section) : radius;  // [m]
  const double usual = thickness > thin ? radius : radius_of_thin;
  const bool is_bar = geometry.section && thickness > thinnest && *geometry.span >= min_spans * usual;
  return is_bar ? usual : std::min(usual, *geometry.span / spans_of_small);
}

double max_steepening(const BeamGeometry& geometry, double deflection) {
  if (!geometry.span) return 0;
  const double radius = geometry.support_radius ? *geometry.support_radius : *standard_roller_radius(geometry);
  const double R = radius + (geometry.section ? 0.5 * depth(*geometry.section) : 0);
  return (4.8 + 27 * R / *geometry.span) * deflection / *geometry.span;
}

double LinearRegion::origin_error(const Record& record) const {
  return (middle(record) - origin) * slope.standard_error / slope.value;
}

double LinearRegion::middle(const Record& record) const {
  return std::midpoint(record.deflection[first], record.deflection[last - 1]);
}

std::optional<LinearRegion> find_linear_region(const Record& record, const BeamGeometry& geometry,
                                               const SmallDeflectionOptions& options) {
  if (options.window) {
    require(options.window->from >= 0 && options.window->from < options.window->up_to, "window from",
            options.window->from);
    require(options.window->up_to <= 1, "window up to", options.window->up_to);
  }
  if (geometry.span) require(*geometry.span > 0 && std::isfinite(*geometry.span), "span", *geometry.span);
  if (record.force.size() < min_on_a_line) return std::nullopt;
  auto small = std::max_element(record.force.begin(), record.force.end()) - record.force.begin() + 1;
  if (geometry.span)  // only points with a small deflection
    small = std::find_if(record.deflection.begin(), record.deflection.begin() + small,
                         [limit = max_deflection * *geometry.span](double w) { return w > limit; }) -
            record.deflection.begin();
  const auto points = static_cast<std::size_t>(small);
  if (points < min_on_a_line) return std::nullopt;
  const double max_force = *std::max_element(record.force.begin(), record.force.begin() + small);
  if (!(max_force > 0)) return std::nullopt;
  const double noise = noise_of(record);
  auto linear = options.window ? region_in(record, points, max_force, *options.window, noise, options.load_train_error)
                               : steepest(record, points, max_force, noise, options);
  if (!linear) return linear;
  linear->window_force = max_force;
  linear->origin_before_record = std::max(record.deflection.front() - linear->origin, 0.0);
  linear->origin += linear->origin_before_record;
  return linear;
}

bool yields(const SmallDeflection& numbers) {
  return numbers.status == SmallDeflectionStatus::ok && numbers.end_slope < levelled &&
         numbers.end_share < elastic_share;
}

bool ends_rising(const SmallDeflection& numbers) {
  return numbers.status == SmallDeflectionStatus::ok && numbers.end_slope >= levelled &&
         numbers.end.force > (1 - levelled * levelled) * numbers.greatest.force;
}

SmallDeflection small_deflection(const Record& record, const BeamGeometry& geometry,
                                 const SmallDeflectionOptions& options) {
  return small_deflection(record, find_linear_region(record, geometry, options), geometry, options);
}

SmallDeflection small_deflection(const Record& record, const std::optional<LinearRegion>& linear,
                                 const BeamGeometry& geometry, const SmallDeflectionOptions& options) {
  SmallDeflection result{};
  result.status = SmallDeflectionStatus::no_straight_part;
  if (record.force.size() < min_on_a_line) return result;
  const auto greatest =
      static_cast<std::size_t>(std::max_element(record.force.begin(), record.force.end()) - record.force.begin());
  if (!(record.force[greatest] > 0)) return result;
  const double share = linear ? linear->load_train_share : load_train_share(record, greatest);
  result.load_train_share = share;
  if (share * options.load_train_error > largest_error * (1 - share) ||
      (linear && linear->slope.standard_error > largest_error * linear->slope.value)) {
    result.status = SmallDeflectionStatus::uncertain;
    return result;
  }
  if (!linear) return result;
  const auto& section = geometry.section;
  const double L = geometry.span.value_or(0);
  const double stiffness = linear->slope.value;
  if (geometry.span && section) result.modulus = modulus_from(linear->slope, geometry);
  if (result.modulus && result.modulus->value > options.greatest_modulus) {
    result.status = SmallDeflectionStatus::too_stiff;
    return result;
  }

  result.status = SmallDeflectionStatus::ok;
  result.window = linear->window;
  result.window_force = linear->window_force;
  result.first = linear->first;
  result.last = linear->last;
  result.stiffness = linear->slope;
  const Estimate contact = options.contact.value_or(normal_estimate(linear->origin, linear->origin_error(record)));
  result.origin = contact.value;
  result.origin_error = contact.standard_error;
  result.origin_before_record = options.contact ? 0 : linear->origin_before_record;
  const auto load_point = [&](double force, double deflection) {
    LoadPoint at{force, deflection, {}, {}};
    if (!geometry.span || !section) return at;
    at.stress = at.force * L * depth(*section) / (8 * second_moment(*section));
    at.strain = 6 * at.deflection * depth(*section) / (L * L);
    return at;
  };
  const auto reached = [&](std::size_t point) {
    return load_point(record.force[point], record.deflection[point] - result.origin);
  };
  result.greatest = reached(greatest);
  result.end = reached(record.force.size() - 1);
  result.end_slope = slope_at_end(record, result.origin) / stiffness;
  if (!geometry.span) return result;
  result.end_share = result.end.deflection / L;
  result.deflection_large = result.greatest.deflection > max_deflection * L;
  result.bending_stiffness = bending_stiffness_from(linear->slope, geometry);
  if (!section) return result;
  result.shear_share = shear_share(*section, L);
  const double limit = conventional_strain * L * L / (6 * depth(*section));
  if (const auto force = force_at(record, record.force.size(), result.origin + limit))
    result.at_conventional_strain = load_point(*force, limit);
  // A record that begins beyond the lower strain of the chord does not cover it.
  if (result.origin_before_record < strain_from * L * L / (6 * depth(*section)))
    result.chord =
        chord_of(record, greatest + 1, result.origin, share, options.load_train_error, noise_of(record), geometry);
  if (!result.chord) return result;
  const Estimate &of_chord = result.chord->stiffness, &of_part = result.stiffness;
  const double error = elementary::length(of_chord.standard_error, of_part.standard_error);
  result.toe_excess = of_part.value / of_chord.value - 1;
  if (!(of_part.value - clearly * error > of_chord.value)) return result;
  result.toe_excess_explained = explained(*result.chord, result.origin, *linear, record, geometry, options.steepening);
  // In a toe the force lies above the line of the linear region.
  constexpr double surely = 4;  // of the noise of a reading
  const double from = result.chord->deflection_from;
  const auto low = force_at(record, greatest + 1, result.origin + from);
  result.chord_in_toe =
      *low > stiffness * (result.origin + from - linear->origin) + surely * noise_of(record) &&
      of_part.value - clearly * error > (1 + std::max(result.toe_excess_explained, usual_excess)) * of_chord.value;
  return result;
}

bool reports_chord(const SmallDeflection& numbers) { return numbers.chord && !numbers.chord_in_toe; }

std::optional<Estimate> standard_modulus(const SmallDeflection& numbers) {
  if (numbers.status != SmallDeflectionStatus::ok) return std::nullopt;
  return reports_chord(numbers) ? numbers.chord->modulus : numbers.modulus;
}

}  // namespace flexslip
