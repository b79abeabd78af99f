#include "data/drops.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "numerics/require.h"
#include "numerics/root.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t shortest_record = 30;
constexpr std::size_t longest_drop = 3;  // [steps]
// two roundings and a little noise that they hide can add up to two steps
constexpr double of_resolution = 2.5;

void require_faultless(const Record& record) {
  const RecordCheck check = check_record(record);
  if (check.fault != RecordFault::none)
    throw std::invalid_argument("no drops of a faulty record: see check_record, index " + std::to_string(check.index));
}

// Degrees of freedom of StepNoise, from its scatter in simulations: 8 at 30 points, 33 at 260, 110
// at 1000.
double noise_freedom(std::size_t points) { return 5 + static_cast<double>(points) / 10; }

// An interval of successive falling steps, from point `from` to point `to`.
struct FallingSteps {
  std::size_t from, to;
  double significance;
};

// True if the drop takes one step, or two steps if the force lags.
bool is_vertical(const std::vector<double>& force, const Drop& drop) {
  constexpr double of_one = 0.6, of_two = 0.75;  // [fall]
  double steepest = 0, steepest_two = 0;
  for (std::size_t i = drop.before; i < drop.after; ++i) {
    steepest = std::max(steepest, force[i] - force[i + 1]);
    if (i + 1 < drop.after) steepest_two = std::max(steepest_two, force[i] - force[i + 2]);
  }
  return steepest >= of_one * drop.force_fall || steepest_two >= of_two * drop.force_fall;
}

}  // namespace

Drops find_drops(const Record& record, const DropOptions& options) {
  require(options.false_alarms_per_test > 0 && std::isfinite(options.false_alarms_per_test), "false alarms per test",
          options.false_alarms_per_test);
  require_faultless(record);
  const auto& force = record.force;
  const std::size_t points = force.size();
  if (points < shortest_record) return {DropStatus::too_short, {}, {}, 0};

  double stretches = 0;
  for (std::size_t length = 1; length <= longest_drop; ++length) stretches += static_cast<double>(points - length);
  const auto false_alarms = [&](double x) { return stretches * student_tail(x, noise_freedom(points)); };

  const auto is_enough = [&](double x) { return !(false_alarms(x) > options.false_alarms_per_test); };
  double beyond = 1;
  while (!is_enough(beyond)) beyond *= 2;
  // The significance with the allowed number of false alarms, far finer than the noise is known.
  const auto fine = [](const Bracket& x) { return !(x.width() > 1e-9 * x.high); };
  const double needed = halved_until(fine, {0, beyond}, is_enough).low;

  const std::vector<double> smooth = smooth_steps(record);
  const auto has_halted = [&](std::size_t point) {
    return std::binary_search(options.halts.begin(), options.halts.end(), point);
  };
  const StepNoise noise_of(record, smooth);
  const double coarse = of_resolution * noise_of.resolution();
  std::vector<std::size_t> falling(points, 0);  // steps up to each point
  for (std::size_t to = 1; to < points; ++to)
    if (force[to] < force[to - 1] && !has_halted(to - 1)) falling[to] = falling[to - 1] + 1;
  const std::size_t longest = std::min(longest_drop, *std::max_element(falling.begin(), falling.end()));
  const double noise_of_a_step = noise_of.over(1);
  std::vector<FallingSteps> found;
  for (std::size_t length = 1; length <= longest; ++length) {
    const double noise = length == 1 ? noise_of_a_step : noise_of.over(length);
    for (std::size_t to = 1; to < points; ++to) {
      if (falling[to] < length) continue;
      const std::size_t from = to - length;
      double course = 0;
      for (std::size_t i = from; i < to; ++i) course += smooth[i];
      const double unexplained = std::min(0.0, course) - (force[to] - force[from]);
      if (unexplained > std::max(needed * noise, coarse)) found.push_back({from, to, unexplained / noise});
    }
  }

  std::sort(found.begin(), found.end(), [](const FallingSteps& a, const FallingSteps& b) {
    return a.significance != b.significance ? a.significance > b.significance : a.from < b.from;
  });
  std::vector<double> significance(points, 0);  // of the interval that contains the step to point i
  for (const FallingSteps& stretch : found) {
    const auto begin = significance.begin() + static_cast<std::ptrdiff_t>(stretch.from) + 1;
    const auto end = significance.begin() + static_cast<std::ptrdiff_t>(stretch.to) + 1;
    if (std::all_of(begin, end, [](double x) { return x == 0; })) std::fill(begin, end, stretch.significance);
  }

  Drops result{.status = DropStatus::ok,
               .drops = {},
               .slow_falls = {},
               .smallest_fall = std::max(needed * noise_of_a_step, coarse)};
  for (std::size_t i = 1; i < points; ++i) {
    if (significance[i] == 0) continue;
    Drop drop{.before = i - 1, .after = i, .force_fall = 0, .advance = 0, .significance = 0};
    for (; i < points && significance[i] > 0; ++i) {
      drop.after = i;
      drop.significance = std::max(drop.significance, significance[i]);
    }
    drop.force_fall = force[drop.before] - force[drop.after];
    drop.advance = record.deflection[drop.after] - record.deflection[drop.before];
    (is_vertical(force, drop) ? result.drops : result.slow_falls).push_back(drop);
  }
  return result;
}

}  // namespace flexslip
