#include "data/sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "data/order.h"

namespace flexslip {
namespace {

double greatest_of(std::span<const double> force) {
  double greatest = 0;
  for (const double value : force) greatest = std::max(greatest, std::abs(value));
  return greatest;
}

// Are changes other than those of a coarse converter, which are a few of its steps?
bool are_fine(const std::vector<double>& changes) {
  if (changes.empty()) return false;
  const double least = *std::min_element(changes.begin(), changes.end());
  if (median_of(changes) > 4 * least) return true;
  const auto is_whole = [&](double change) {
    constexpr double rounding = 0.01;
    return std::abs(change / least - std::round(change / least)) < rounding;
  };
  return 2 * std::count_if(changes.begin(), changes.end(), is_whole) < static_cast<std::ptrdiff_t>(changes.size());
}

// Whether equal forces one after the other are held values; all of them are where a specimen bears a load.
bool holds_values(std::span<const double> force, double loaded) {
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
  return 4 * equal >= steps && are_fine(changes);
}

// Where a record goes straight on from row to row, to the last digits, there is no noise: its readings are where it bends, or the row
// beside. Empty: it does not.
std::vector<std::size_t> readings_of(std::span<const double> displacement, const std::vector<double>& force,
                                     double greatest) {
  constexpr double straight = 1e-7;  // [greatest force] less than converters tell, more than files round
  const auto bend_at = [&](std::size_t i) { return std::abs(force[i - 1] - 2 * force[i] + force[i + 1]); };
  const auto bends_at = [&](std::size_t i) { return bend_at(i) > straight * greatest; };
  std::vector<std::size_t> readings{0};
  std::vector<double> bends;
  std::size_t rows_straight = 0;
  for (std::size_t i = 1; i + 1 < force.size(); ++i) {
    // While the stage stands nothing lies between readings: all such rows are.
    if (displacement[i - 1] == displacement[i] || displacement[i] == displacement[i + 1]) {
      readings.push_back(i);
      continue;
    }
    if (!bends_at(i)) {
      ++rows_straight;
      continue;
    }
    // A reading between two rows bends both: the one that is not on the way of a fall counts.
    bends.push_back(bend_at(i));
    const bool bends_next = i + 2 < force.size() && bends_at(i + 1);
    const bool falls_then = bends_next && force[i + 2] < force[i + 1];
    readings.push_back(bends_next && !falls_then ? i + 1 : i);
    if (bends_next) ++i;
  }
  constexpr std::size_t least_readings = 100;  // what bends more rarely may be straight by itself
  constexpr std::size_t of_rows = 10;          // by chance far fewer lie straight
  if (readings.size() < least_readings || of_rows * rows_straight < force.size() || !are_fine(bends)) return {};
  readings.push_back(force.size() - 1);
  return readings;
}

// The values at some rows.
std::vector<double> values_at(const std::vector<std::size_t>& rows, std::span<const double> values) {
  std::vector<double> picked;
  for (const std::size_t row : rows) picked.push_back(values[row]);
  return picked;
}

// Of the rows those that a test keeps, by their place among them; how many it does not.
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

Sampling sampling_of(std::span<const double> displacement, std::span<const double> force, std::size_t most) {
  Sampling sampling{std::vector<std::size_t>(force.size()), 0, 0, 0, 1};
  auto& rows = sampling.rows;
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  sampling.repeated = leave_out(rows, [&](std::size_t i) {
    return i == 0 || force[i] != force[i - 1] || displacement[i] != displacement[i - 1];
  });
  const double greatest = greatest_of(force);
  constexpr double of_greatest = 0.05;
  const double loaded = of_greatest * greatest;
  auto forces = values_at(rows, force);
  if (holds_values(forces, loaded)) {
    sampling.held = leave_out(
        rows, [&](std::size_t i) { return i == 0 || forces[i] != forces[i - 1] || !(std::abs(forces[i]) > loaded); });
    forces = values_at(rows, force);
  }
  if (const auto readings = readings_of(values_at(rows, displacement), forces, greatest); !readings.empty())
    sampling.interpolated =
        leave_out(rows, [&](std::size_t i) { return std::binary_search(readings.begin(), readings.end(), i); });
  sampling.stride = (rows.size() + most - 1) / most;
  if (sampling.stride > 1) leave_out(rows, [&](std::size_t i) { return i % sampling.stride == 0; });
  return sampling;
}

}  // namespace flexslip
