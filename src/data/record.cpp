#include "data/record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>

#include "numerics/effort.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t half_window =
    10;  // steps on either side: 21 determine a slope to 0.3 σ, with little effect of curvature
// steps: a scale to 15 %, and short enough to fit between slips
constexpr std::size_t noise_window = 30;
constexpr std::size_t noise_stride = 5;  // steps between windows
// of the windows: a test that slips half the time has them
constexpr double quiet_fraction = 0.1;
constexpr std::size_t min_residuals = 10;  // the minimum for a scale

void require_one_length(std::span<const double> a, std::span<const double> b) {
  if (a.size() == b.size()) return;
  throw std::invalid_argument("columns of " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                              " points");
}

void require_stiffness(double stiffness, double largest) {
  if (stiffness > 0 && stiffness <= largest) return;
  std::ostringstream message;
  message << "load-train stiffness = " << stiffness << " N/m is not positive";
  if (std::isinf(stiffness)) message << " and finite: with it, stage and deflection do not tell the force";
  throw std::invalid_argument(message.str());
}

template <class Operation>
std::vector<double> combined(std::span<const double> a, std::span<const double> b, Operation operation) {
  std::vector<double> result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), operation);
  return result;
}

std::vector<double> copy_of(std::span<const double> values) { return {values.begin(), values.end()}; }

template <class Operation>
std::vector<double> mapped(std::span<const double> values, Operation operation) {
  std::vector<double> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(), operation);
  return result;
}

// The slope of the force over one step of the stage, and its weight: the travel.
struct StepSlope {
  double slope;   // [N/m]
  double weight;  // [m]
};

std::vector<StepSlope> step_slopes(const Record& record) {
  std::vector<StepSlope> steps;
  for (std::size_t i = 1; i < record.force.size(); ++i) {
    const double travel = record.stage[i] - record.stage[i - 1];
    steps.push_back({travel == 0 ? 0 : (record.force[i] - record.force[i - 1]) / travel, std::abs(travel)});
  }
  return steps;
}

// The median slopes of moving windows; each sort starts from the order of the previous window.
class MiddleSlopes {
 public:
  // Domain:     at most half_window, with this many steps on either side of each centre.
  MiddleSlopes(std::span<const StepSlope> steps, std::size_t half) : steps_(steps), half_(half) {}

  // The weighted median g, which minimises Σ weight |slope - g|, of slopes corrected by a bend [N/m
  // per step]. Without the correction the median of a strongly curved trend is the middle step
  // itself, with its noise.
  double about(std::size_t centre, double bend) {
    effort_spent += 1;
    const std::span<const StepSlope> window = steps_.subspan(centre - half_, 2 * half_ + 1);
    const std::size_t n = window.size();
    std::array<double, 2 * half_window + 1> slopes;
    const double middle = 0.5 * static_cast<double>(n - 1);
    double total = 0;
    for (std::size_t i = 0; i < n; ++i) {
      slopes[i] = window[i].slope - bend * (static_cast<double>(i) - middle);
      total += window[i].weight;
    }
    move_to(centre);
    for (std::size_t sorted = 1; sorted < n; ++sorted) {
      const std::size_t next = order_[sorted];
      std::size_t to = sorted;
      for (; to > 0 && slopes[order_[to - 1]] > slopes[next]; --to) order_[to] = order_[to - 1];
      order_[to] = next;
    }
    if (!(total > 0)) return 0;  // the stage is stationary
    double median = slopes[order_[0]], below = 0;
    for (std::size_t i = 0; i < n && below < 0.5 * total; ++i) {
      median = slopes[order_[i]];
      below += window[order_[i]].weight;
    }
    return median;
  }

 private:
  // Keeps the order of the previous window: the first step leaves, one step is appended.
  void move_to(std::size_t centre) {
    const std::size_t n = 2 * half_ + 1;
    if (centre == centre_ + 1) {
      for (std::size_t& at : std::span(order_).first(n)) at = at == 0 ? n - 1 : at - 1;
    } else if (centre != centre_) {
      std::iota(order_.begin(), order_.end(), std::size_t{0});
    }
    centre_ = centre;
  }

  std::span<const StepSlope> steps_;
  std::size_t half_;
  std::size_t centre_ = std::numeric_limits<std::size_t>::max() - 1;  // before the first window
  std::array<std::size_t, 2 * half_window + 1> order_;
};

// The ratio of the quietest tenth of the windows to the true scale for Gaussian noise, fitted to
// simulations of 30 to 3000 points.
double shown_by_quietest(std::size_t windows) {
  return 0.70 + 0.30 * elementary::exp(-0.1 * static_cast<double>(windows));
}

}  // namespace

void require_readings(std::span<const double> stage, std::span<const double> deflection,
                      std::span<const double> force) {
  if (stage.size() != force.size() || deflection.size() != force.size())
    throw std::invalid_argument("the columns of the record are not of one length: " + std::to_string(stage.size()) +
                                ", " + std::to_string(deflection.size()) + ", " + std::to_string(force.size()));
  for (std::size_t i = 0; i < force.size(); ++i)
    if (!(std::isfinite(stage[i]) && std::isfinite(deflection[i]) && std::isfinite(force[i])))
      throw std::invalid_argument("the readings of row " + std::to_string(i) + " of the record are not finite");
}

ReducedRecord to_reduced(const Record& record, const Scales& scales) {
  const auto length = [&](double x) { return scales.reduced_length(x); };
  const auto force = [&](double x) { return scales.reduced_force(x); };
  return {mapped(record.stage, length), mapped(record.deflection, length), mapped(record.force, force)};
}

Record to_physical(const ReducedRecord& record, const Scales& scales) {
  const auto length = [&](double x) { return scales.physical_length(x); };
  const auto force = [&](double x) { return scales.physical_force(x); };
  return {mapped(record.stage, length), mapped(record.deflection, length), mapped(record.force, force)};
}

Record record_from_stage_and_force(std::span<const double> stage, std::span<const double> force, double stiffness) {
  require_one_length(stage, force);
  require_stiffness(stiffness, std::numeric_limits<double>::infinity());
  return {copy_of(stage), combined(stage, force, [=](double ws, double F) { return ws - F / stiffness; }),
          copy_of(force)};
}

Record record_from_deflection_and_force(std::span<const double> deflection, std::span<const double> force,
                                        double stiffness) {
  require_one_length(deflection, force);
  require_stiffness(stiffness, std::numeric_limits<double>::infinity());
  return {combined(deflection, force, [=](double w0, double F) { return w0 + F / stiffness; }), copy_of(deflection),
          copy_of(force)};
}

Record record_from_stage_and_deflection(std::span<const double> stage, std::span<const double> deflection,
                                        double stiffness) {
  require_one_length(stage, deflection);
  require_stiffness(stiffness, std::numeric_limits<double>::max());
  return {copy_of(stage), copy_of(deflection),
          combined(stage, deflection, [=](double ws, double w0) { return stiffness * (ws - w0); })};
}

Record first_points(const Record& record, std::size_t points) {
  const auto head = [=](std::span<const double> values) {
    return copy_of(values.first(std::min(points, values.size())));
  };
  return {head(record.stage), head(record.deflection), head(record.force)};
}

Record points_between(const Record& record, std::size_t first, std::size_t last) {
  return counted_from(0, first_points(record, last), first);
}

Record counted_from(double contact, Record record, std::size_t skipped) {
  for (auto* column : {&record.stage, &record.deflection, &record.force})
    column->erase(column->begin(), column->begin() + static_cast<std::ptrdiff_t>(skipped));
  for (auto* column : {&record.stage, &record.deflection})
    for (double& value : *column) value -= contact;
  return record;
}

Record picked(const Record& record, std::span<const std::size_t> points) {
  const auto of = [points](const std::vector<double>& values) {
    std::vector<double> result;
    result.reserve(points.size());
    for (const std::size_t point : points) result.push_back(values[point]);
    return result;
  };
  return {of(record.stage), of(record.deflection), of(record.force)};
}

RecordCheck check_record(const Record& record) {
  const auto& [stage, deflection, force] = record;
  const std::size_t n = std::min({stage.size(), deflection.size(), force.size()});
  if (n != std::max({stage.size(), deflection.size(), force.size()})) return {RecordFault::lengths_differ, n};
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(stage[i]) || !std::isfinite(deflection[i]) || !std::isfinite(force[i]))
      return {RecordFault::not_finite, i};
  for (std::size_t i = 1; i < n; ++i)
    if (stage[i] < stage[i - 1]) return {RecordFault::stage_runs_back, i};
  return {RecordFault::none, 0};
}

std::vector<double> smooth_steps(const Record& record) {
  const std::vector<StepSlope> slopes = step_slopes(record);
  const std::size_t n = slopes.size();
  if (n == 0) return {};

  const std::size_t h = std::min(half_window, (n - 1) / 2);
  const std::size_t head = h, tail = n - 1 - h;  // the first and the last step with a full window
  std::vector<double> rough(n);
  MiddleSlopes unbent(slopes, h), straightened(slopes, h);
  for (std::size_t i = head; i <= tail; ++i) rough[i] = unbent.about(i, 0);

  std::vector<double> smooth(n);
  for (std::size_t i = 0; i < n; ++i) {
    // at the ends the outermost window is used
    const std::size_t centre = std::clamp(i, head, tail);
    const std::size_t from = centre - std::min(h, centre - head), to = std::min(centre + h, tail);
    const double bend = to > from ? (rough[to] - rough[from]) / static_cast<double>(to - from) : 0;
    const double ahead = static_cast<double>(i) - static_cast<double>(centre);
    smooth[i] = (straightened.about(centre, bend) + bend * ahead) * (record.stage[i + 1] - record.stage[i]);
  }
  return smooth;
}

double resolution_of(std::vector<double> readings) {
  std::sort(readings.begin(), readings.end());
  const double rounding =
      // the rounding of decimal fractions
      1e-12 * std::max(std::abs(readings.front()), std::abs(readings.back()));
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<double> gaps;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const double gap = readings[i] - readings[i - 1];
    if (gap <= rounding) continue;
    smallest = std::min(smallest, gap);
    gaps.push_back(gap);
  }
  if (gaps.empty()) return 0;
  if (gaps.size() + 1 < readings.size()) return smallest;  // two are equal
  // True if at least three sizes of gaps are all multiples of the step: a noiseless straight line
  // has a single size.
  const auto are_steps_of = [&](double step) {
    std::set<double> sizes;
    for (const double gap : gaps) {
      constexpr double off = 1e-4;  // [1] of a gap
      const double steps = gap / step;
      if (std::abs(steps - std::round(steps)) > off * steps) return false;
      sizes.insert(std::round(steps));
    }
    return sizes.size() >= 3;
  };
  constexpr std::size_t min_values = 20;
  constexpr int max_parts = 10;  // steps in the smallest gap
  for (int parts = 1; gaps.size() >= min_values && parts <= max_parts; ++parts)
    if (are_steps_of(smallest / parts)) return smallest / parts;
  return 0;
}

StepNoise::StepNoise(const Record& record, std::span<const double> smooth) : record_(record), smooth_(smooth) {
  if (smooth.size() + 1 != record.force.size())
    throw std::invalid_argument(std::to_string(smooth.size()) + " smooth steps of " +
                                std::to_string(record.force.size()) + " points");
  resolution_ = resolution_of(record.force);
}

double StepNoise::over(std::size_t steps) const {
  const std::vector<double>& force = record_.force;
  const std::size_t points = force.size();
  if (steps < 1 || points < steps + min_residuals)
    throw std::invalid_argument("no noise over " + std::to_string(steps) + " steps of " + std::to_string(points) +
                                " points");

  std::vector<double> residual(points - steps);
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] = force[i + steps] - force[i];
    for (std::size_t j = i; j < i + steps; ++j) residual[i] -= smooth_[j];
  }

  // Windows with a constant reading indicate a frozen load cell; they are not quiet.
  const std::size_t width = std::min(noise_window, residual.size());
  std::vector<double> scales;
  std::vector<double> deviations(width);
  for (std::size_t i = 0; i + width <= residual.size(); i += noise_stride) {
    const auto window = std::span(force).subspan(i, width + steps);
    if (std::all_of(window.begin(), window.end(), [&](double F) { return F == window.front(); })) continue;
    for (std::size_t j = 0; j < width; ++j) deviations[j] = std::abs(residual[i + j]);
    scales.push_back(deviation_by_median * median_of(deviations));
  }
  if (scales.empty()) return 0;

  const std::size_t windows = scales.size();
  std::sort(scales.begin(), scales.end());
  const double quietest = quantile_in_order(scales, quiet_fraction);

  // The difference of two rounded readings has a standard deviation of resolution/√6.
  return std::max(quietest / shown_by_quietest(windows), resolution_ / std::sqrt(6.0));
}

double stage_noise(std::span<const double> stage) {
  return std::max(noise_of_second_differences(second_differences(stage)),
                  resolution_of({stage.begin(), stage.end()}) / std::sqrt(6.0));
}

double force_noise(const Record& record) {
  const std::vector<double> smooth = smooth_steps(record);
  return StepNoise(record, smooth).over(1) / std::numbers::sqrt2;
}

std::vector<Leg> find_legs(std::span<const double> stage, const LegOptions& options) {
  if (!(options.min_travel > 0 && options.min_travel < 1))
    throw std::invalid_argument("the least travel of a leg must lie between 0 and 1 of the range of the stage: " +
                                std::to_string(options.min_travel));
  for (std::size_t i = 0; i < stage.size(); ++i)
    if (!std::isfinite(stage[i]))
      throw std::invalid_argument("stage position " + std::to_string(i) +
                                  " is not finite: " + std::to_string(stage[i]));
  if (stage.empty()) return {};
  const auto [least, greatest] = std::minmax_element(stage.begin(), stage.end());
  const double range = *greatest - *least, travel = options.min_travel * range;
  if (!(travel > 0)) return {};

  constexpr double of_travel = 0.25, of_noise = 8, of_resolution = 1.5, of_way = 0.5, max_share = 0.25;
  const double min_travel_at_first = of_travel * travel;
  std::optional<double> noise;
  const auto is_beyond_noise = [&](double way) {
    if (!noise)
      noise = std::min(max_share * range, std::max(of_noise * noise_of_second_differences(second_differences(stage)),
                                                   of_resolution * resolution_of({stage.begin(), stage.end()})));
    return way > *noise;
  };

  std::vector<Leg> legs;
  std::size_t first = 0;
  std::size_t lowest = 0;                            // since the last turning point
  std::size_t highest = 0;                           // since the last turning point
  double low = stage.front(), high = stage.front();  // so far
  const auto turn = [&](std::size_t at, Direction ended) {
    legs.push_back({first, at + 1, ended});
    first = at + 1;
  };
  bool started = false;
  auto direction = Direction::loading;
  for (std::size_t i = 1; i < stage.size(); ++i) {
    if (stage[i] < stage[lowest]) lowest = i;
    if (stage[i] > stage[highest]) highest = i;
    low = std::min(low, stage[i]);
    high = std::max(high, stage[i]);
    const double first_travel = std::max(min_travel_at_first, of_way * (high - low));
    const auto has_turned = [&](double way) { return way > std::min(travel, first_travel) && is_beyond_noise(way); };
    const bool rose = has_turned(stage[i] - stage[lowest]);
    const bool fell = has_turned(stage[highest] - stage[i]);
    if (!started) {
      if (!rose && !fell) continue;
      started = true;
      direction = rose ? Direction::loading : Direction::unloading;
      lowest = highest = i;
    } else if (direction == Direction::loading && fell) {
      turn(highest, direction);
      direction = Direction::unloading;
      lowest = highest = i;
    } else if (direction == Direction::unloading && rose) {
      turn(lowest, direction);
      direction = Direction::loading;
      lowest = highest = i;
    }
  }
  legs.push_back({first, stage.size(), direction});
  return legs;
}

std::vector<double> medians_of_five(std::span<const double> values) {
  constexpr std::size_t min_values = 30, count = 5, middle = count / 2;
  std::vector<double> medians(values.begin(), values.end());
  if (values.size() < min_values) return medians;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<double, count> sorted{};
    std::copy_n(
        values.begin() + static_cast<std::ptrdiff_t>(std::clamp(i, middle, values.size() - 1 - middle) - middle), count,
        sorted.begin());
    std::nth_element(sorted.begin(), sorted.begin() + middle, sorted.end());
    medians[i] = sorted[middle];
  }
  return medians;
}

Signs find_signs(std::span<const double> displacement, std::span<const double> force) {
  if (displacement.size() != force.size())
    throw std::invalid_argument("columns of " + std::to_string(displacement.size()) + " and " +
                                std::to_string(force.size()) + " points");
  if (force.empty()) return {1, 1};

  const std::vector<double> calm = medians_of_five(force);
  const auto by_magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto greatest = std::max_element(calm.begin(), calm.end(), by_magnitude);
  const int force_sign = *greatest < 0 ? -1 : 1;
  const auto by_compression = [=](double a, double b) { return force_sign * a < force_sign * b; };
  auto least = greatest == calm.begin() ? std::min_element(greatest, calm.end(), by_compression)
                                        : std::min_element(calm.begin(), greatest, by_compression);
  // The last row with a small force before the maximum, because earlier ones may belong to a return
  // of the stage.
  constexpr double as_little = 0.05;  // [rise]
  const double little = as_little * std::abs(*greatest - *least), fewest = *least;
  for (auto row = least; row < greatest; ++row)
    if (std::abs(*row - fewest) <= little) least = row;
  const auto at = [&](auto row) { return displacement[static_cast<std::size_t>(row - calm.begin())]; };
  return {at(greatest) < at(least) ? -1 : 1, force_sign};
}

}  // namespace flexslip
