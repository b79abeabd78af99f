#include "data/rounded_drops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

constexpr std::size_t beside = 2;  // steps before and after a drop that are compared

// A drop, by what its steps fall beyond the smooth curve [N].
struct Rounded {
  std::array<double, beside> before, after;  // the nearest step first
  double fall;

  double longer() const { return sum(after) - sum(before); }
  static double sum(const std::array<double, beside>& steps) {
    return std::accumulate(steps.begin(), steps.end(), 0.0);
  }
};

// What some part of the drops is of their falls, all together.
struct Share {
  double value, scatter;  // [1] standard error by how it differs between them
};

template <class Part>
Share share_of(const std::vector<Rounded>& drops, Part part) {
  double sum = 0, fall = 0, squares = 0;
  for (const Rounded& drop : drops) {
    sum += part(drop);
    fall += drop.fall;
  }
  const double share = sum / fall, count = static_cast<double>(drops.size());
  for (const Rounded& drop : drops) squares += (part(drop) - share * drop.fall) * (part(drop) - share * drop.fall);
  return {share, std::sqrt(squares * count / (count - 1)) / fall};
}

std::vector<Rounded> drops_of(const Record& record) {
  constexpr std::size_t fewest = 30;  // as find_drops has it
  std::vector<Rounded> drops;
  if (record.force.size() < fewest) return drops;
  const std::vector<double> smooth = smooth_steps(record);
  constexpr double surely = 5;  // standard deviations of a step
  const double noise = StepNoise(record, smooth).over(1);
  std::vector<double> fall;  // of each step
  for (std::size_t i = 0; i < smooth.size(); ++i)
    fall.push_back(std::max(smooth[i], 0.0) - (record.force[i + 1] - record.force[i]));
  for (std::size_t i = beside; i + beside < fall.size(); ++i) {
    const auto at = fall.begin() + static_cast<std::ptrdiff_t>(i);
    if (!(record.force[i + 1] < record.force[i]) || !(*at > surely * noise)) continue;
    if (*std::max_element(at - beside, at + beside + 1) > *at) continue;
    Rounded drop{{}, {}, *at};
    for (std::size_t k = 0; k < beside; ++k) {
      drop.before[k] = fall[i - k - 1];
      drop.after[k] = fall[i + k + 1];
    }
    drops.push_back(drop);
  }
  return drops;
}

// [1] The same of snaps at any time between two rows, behind a low-pass.
double longer_by_lag(double rows) {
  constexpr int snaps = 64;
  double longer = 0, all = 0;
  for (int snap = 0; snap < snaps; ++snap) {
    const double first = (snap + 0.5) / snaps;   // [rows] from the snap to the next row
    std::array<double, 2 * beside + 2> steps{};  // the first that falls is in the middle, or beside it
    double left = 1;
    for (std::size_t k = 0; beside + k < steps.size(); ++k) {
      const double then = elementary::exp(-(first + static_cast<double>(k)) / rows);
      steps[beside + k] = left - then;
      left = then;
    }
    const std::size_t steepest = steps[beside] >= steps[beside + 1] ? beside : beside + 1;
    for (std::size_t k = 1; k <= beside; ++k) longer += steps[steepest + k] - steps[steepest - k];
    all += steps[steepest];
  }
  return longer / all;
}

double lag_of(const std::vector<Rounded>& drops) {
  const Share share = share_of(drops, [](const Rounded& drop) { return drop.longer(); });
  const auto count = static_cast<double>(drops.size());
  constexpr double of_one =
      0.15;  // [1] by when it comes between two rows; three that agree by chance are not as sure as they look
  const double error = elementary::length(share.scatter, of_one / std::sqrt(count));
  constexpr double no_lag = 0.1;
  if (!(share.value - (1.3 + 1 / count) * error > no_lag)) return 0;
  constexpr Bracket lags{0.05, 8};
  const auto fine = [](const Bracket& lag) { return lag.width() < 1e-3; };
  return halved_until(fine, lags, [&](double lag) { return longer_by_lag(lag) > share.value; }).low;
}

// In the steps next to it a drop falls on by a third of its own or more, and by about as much on either side: behind a low-pass less is before it.
double spread_of(const std::vector<Rounded>& drops) {
  const Share before = share_of(drops, [](const Rounded& drop) { return drop.before.front(); });
  const Share after = share_of(drops, [](const Rounded& drop) { return drop.after.front(); });
  constexpr double surely = 2, one_row = 1.0 / 3, alike = 0.8;
  const auto is_spread = [&](const Share& share) { return share.value - surely * share.scatter > one_row; };
  if (!is_spread(before) || !is_spread(after) || before.value < alike * after.value) return 0;
  const Share all =
      share_of(drops, [](const Rounded& drop) { return Rounded::sum(drop.before) + Rounded::sum(drop.after); });
  return 1 + std::max(all.value, before.value + after.value);
}

// Does the force differ less from one row to the next than white noise would, beside what it differs over three?
bool is_smooth_from_row_to_row(const Record& record) {
  const std::vector<double> smooth = smooth_steps(record);
  const StepNoise noise(record, smooth);
  constexpr double of_white = 1.4;  // 1 without a filter, 1.7 behind the mildest
  return noise.over(3) > of_white * noise.over(1);
}

}  // namespace

RoundedDrops rounded_drops(const Record& record) {
  const std::vector<Rounded> drops = drops_of(record);
  constexpr std::size_t fewest = 3;
  if (drops.size() < fewest) return {drops.size(), 0, 0};
  const double spread = spread_of(drops);
  return {drops.size(), lag_of(drops), spread > 0 && is_smooth_from_row_to_row(record) ? spread : 0};
}

}  // namespace flexslip
