#include "data/sampling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "data/no_readings.h"
#include "data/record.h"
#include "numerics/statistics.h"

namespace flexslip {

namespace {

double greatest_of(std::span<const double> force) {
  double greatest = 0;
  for (const double value : force) greatest = std::max(greatest, std::abs(value));
  return greatest;
}

// The step of a force: the smallest difference of two forces above rounding. 0 for a constant
// force.
double step_of(std::vector<double> force, double greatest) {
  // [maximum force] above the rounding of doubles, below the step of a converter
  constexpr double rounding = 1e-9;
  std::sort(force.begin(), force.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < force.size(); ++i)
    if (const double gap = force[i] - force[i - 1]; gap > rounding * greatest) step = std::min(step, gap);
  return std::isfinite(step) ? step : 0;
}

// True if the changes exceed a few steps of a coarse converter.
bool are_fine(std::vector<double> changes, double step) {
  constexpr double few = 4;
  return !changes.empty() && median_of(std::move(changes)) > few * step;
}

// True if equal successive forces are held values. Equal forces count only under load.
bool holds_values(std::span<const double> force, double loaded, double step) {
  std::vector<double> changes;
  std::size_t steps = 0, equal = 0;
  for (std::size_t i = 1; i < force.size(); ++i) {
    if (!(std::abs(force[i]) > loaded)) continue;
    ++steps;
    const double change = std::abs(force[i] - force[i - 1]);
    if (change > 0)
      changes.push_back(change);
    else
      ++equal;
  }
  return 4 * equal >= steps && are_fine(std::move(changes), step);
}

// The largest second difference of rows interpolated between readings; empty if the record has
// none.
// A force in steps as coarse as its noise is also straight over many rows, but it bends by one step
// more often than by none. In a file with few digits, rounding bends interpolated rows by one digit
// about as often as by none, and never by two.
std::optional<double> bend_of_interpolated(const std::vector<double>& bends, double step, double greatest) {
  constexpr double rounding = 1e-7;  // [maximum force] above the rounding of eight digits
  constexpr double share = 0.1;      // of the rows
  const auto count = [&](double from, double to) {
    return static_cast<double>(
        std::count_if(bends.begin(), bends.end(), [=](double bend) { return bend > from && bend <= to; }));
  };
  const auto others_are_fine = [&](double tolerance) {
    std::vector<double> others;
    std::copy_if(bends.begin(), bends.end(), std::back_inserter(others), [=](double bend) { return bend > tolerance; });
    return are_fine(std::move(others), step);
  };
  const double enough = share * static_cast<double>(bends.size());
  const double exact = rounding * greatest, by_one = 1.5 * step;
  if (count(-1, exact) - count(exact, by_one) > enough && others_are_fine(exact)) return exact;
  const double straight = count(-1, by_one), by_two = count(by_one, by_one + 2 * step);
  const bool is_rounded = count(0.5 * step, by_one) > share * straight;
  constexpr double at_most = 4;  // [1] ratio of straight triples to triples bent by two steps, for noise
  if (is_rounded && straight - at_most * by_two > enough && others_are_fine(by_one)) return by_one;
  return {};
}

// The rows at which the record bends, or their neighbours: its readings, if the rows between are
// straight to the last digits. Empty if they are not.
std::vector<std::size_t> readings_of(std::span<const double> displacement, const std::vector<double>& force,
                                     double greatest, double loaded) {
  const auto bend_at = [&](std::size_t i) { return std::abs(force[i - 1] - 2 * force[i] + force[i + 1]); };
  // While the stage is stationary nothing is interpolated: all rows are readings.
  const auto stands_at = [&](std::size_t i) {
    return displacement[i - 1] == displacement[i] || displacement[i] == displacement[i + 1];
  };
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < force.size(); ++i)
    if (!stands_at(i) && std::abs(force[i]) > loaded) bends.push_back(bend_at(i));
  const auto interpolated = bend_of_interpolated(bends, step_of(force, greatest), greatest);
  if (!interpolated) return {};
  const auto bends_at = [&](std::size_t i) { return bend_at(i) > *interpolated; };
  std::vector<std::size_t> readings{0};
  for (std::size_t i = 1; i + 1 < force.size(); ++i) {
    if (stands_at(i)) {
      readings.push_back(i);
      continue;
    }
    if (!bends_at(i)) continue;
    // An outlier affects both neighbouring differences; keep the one that is not part of a drop.
    const bool bends_next = i + 2 < force.size() && bends_at(i + 1);
    const bool falls_then = bends_next && force[i + 2] < force[i + 1];
    readings.push_back(bends_next && !falls_then ? i + 1 : i);
    if (bends_next) ++i;
  }
  constexpr std::size_t min_readings = 100;  // a record with fewer bends may simply be straight
  if (readings.size() < min_readings) return {};
  readings.push_back(force.size() - 1);
  return readings;
}

// The values at the given rows.
std::vector<double> values_at(const std::vector<std::size_t>& rows, std::span<const double> values) {
  std::vector<double> picked;
  for (const std::size_t row : rows) picked.push_back(values[row]);
  return picked;
}

// Keeps the rows that pass a test, given by their index, and returns the number of the others.
template <class Kept>
std::size_t leave_out(std::vector<std::size_t>& rows, Kept is_kept) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (is_kept(i)) kept.push_back(rows[i]);
  const std::size_t left_out = rows.size() - kept.size();
  rows = std::move(kept);
  return left_out;
}

}  // namespace

std::vector<std::size_t> Sampling::halts_between(std::size_t first, std::size_t last) const {
  std::vector<std::size_t> points(std::max(std::min(last, rows.size()), first) - first);
  std::iota(points.begin(), points.end(), first);
  return halts_among(points);
}

std::vector<std::size_t> Sampling::halts_among(std::span<const std::size_t> points) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::binary_search(halts.begin(), halts.end(), rows[points[i]])) found.push_back(i);
  return found;
}

void Sampling::leave_out_at_rest(const std::vector<std::size_t>& points) {
  if (points.empty()) return;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i == 0 || points[i] > points[i - 1] + 1) halts.push_back(rows[points[i] - 1]);
  std::sort(halts.begin(), halts.end());
  last_at_rest = std::max(last_at_rest, rows[points.back()]);
  at_rest += leave_out(rows, [&](std::size_t i) { return !std::binary_search(points.begin(), points.end(), i); });
}

namespace {

// The loaded part: between the first and the last force that differs from the force of the first
// rows, extended by a fraction of its length on both sides.
struct Loaded {
  std::size_t first, last;
};

Loaded loaded_of(std::span<const double> force) {
  constexpr double of_greatest = 0.05;
  constexpr std::size_t beside = 10;  // a tenth of the loaded rows
  std::vector<double> change = medians_of_five(force);
  const double at_first = force.empty() ? 0 : change[std::min<std::size_t>(2, change.size() - 1)];
  for (double& value : change) value -= at_first;
  const double least = of_greatest * greatest_of(change);
  const auto is_loaded = [=](double value) { return std::abs(value) > least; };
  const auto first = std::find_if(change.begin(), change.end(), is_loaded);
  const auto last = std::find_if(change.rbegin(), change.rend(), is_loaded).base();
  if (first == change.end()) return {0, force.size()};
  const auto begin = static_cast<std::size_t>(first - change.begin()),
             end = static_cast<std::size_t>(last - change.begin());
  const std::size_t more = (end - begin) / beside + beside;
  return {begin - std::min(begin, more), std::min(end + more, force.size())};
}

void thin(Sampling& sampling, std::span<const double> displacement, std::span<const double> all_force,
          std::size_t max_rows) {
  if (sampling.rows.size() <= max_rows) return;
  sampling.leave_out_at_rest(find_halts(values_at(sampling.rows, displacement)));
  if (sampling.rows.size() <= max_rows) return;
  const std::vector<double> force = values_at(sampling.rows, all_force);
  // a tenth of the rows that count, before and after the load each
  constexpr std::size_t part_unloaded = 10;
  const auto [first, last] = loaded_of(force);
  const std::size_t few = std::min(max_rows / part_unloaded, force.size() - (last - first));
  sampling.stride = (last - first + max_rows - 2 * few - 1) / (max_rows - 2 * few);
  const std::size_t beside = few * sampling.stride;
  const std::size_t begin = first - std::min(first, beside), end = std::min(last + beside, force.size());
  sampling.unloaded = force.size() - (end - begin);
  const auto by_magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto greatest =
      static_cast<std::size_t>(std::max_element(force.begin(), force.end(), by_magnitude) - force.begin());
  leave_out(sampling.rows, [&](std::size_t i) {
    return i == greatest || (i >= begin && i < end && (i - begin) % sampling.stride == 0);
  });
}

}  // namespace

Sampling sampling_of(std::span<const double> displacement, std::span<const double> force, std::size_t max_rows) {
  Sampling sampling{std::vector<std::size_t>(force.size()), force.size(), 0, 0, 0, 0, 1};
  auto& rows = sampling.rows;
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  sampling.repeated = leave_out(rows, [&](std::size_t i) {
    return i == 0 || force[i] != force[i - 1] || displacement[i] != displacement[i - 1];
  });
  const double greatest = greatest_of(medians_of_five(force));
  constexpr double of_greatest = 0.05;
  const double loaded = of_greatest * greatest;
  auto forces = values_at(rows, force);
  if (holds_values(forces, loaded, step_of(forces, greatest))) {
    sampling.held = leave_out(
        rows, [&](std::size_t i) { return i == 0 || forces[i] != forces[i - 1] || !(std::abs(forces[i]) > loaded); });
    forces = values_at(rows, force);
  }
  if (const auto readings = readings_of(values_at(rows, displacement), forces, greatest, loaded); !readings.empty())
    sampling.interpolated =
        leave_out(rows, [&](std::size_t i) { return std::binary_search(readings.begin(), readings.end(), i); });
  thin(sampling, displacement, force, max_rows);
  return sampling;
}

}  // namespace flexslip
