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

constexpr std::size_t compared = 2;  // compared steps on either side of a drop

// A drop and the falls of its neighbouring steps relative to the smooth trend [N].
struct Rounded {
  std::array<double, compared> before, after;  // the nearest step first
  double fall;

  double longer() const { return sum(after) - sum(before); }
  static double sum(const std::array<double, compared>& steps) {
    return std::accumulate(steps.begin(), steps.end(), 0.0);
  }
};

// The ratio of a part of the drops to their falls, for all drops together.
struct Share {
  double value, scatter;  // [1] standard error from the scatter between drops
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
  constexpr std::size_t min_count = 30;  // as in find_drops
  std::vector<Rounded> drops;
  if (record.force.size() < min_count) return drops;
  const std::vector<double> smooth = smooth_steps(record);
  constexpr double min_errors = 5;  // standard deviations of a step
  const double noise = StepNoise(record, smooth).over(1);
  std::vector<double> fall;  // of each step
  for (std::size_t i = 0; i < smooth.size(); ++i)
    fall.push_back(std::max(smooth[i], 0.0) - (record.force[i + 1] - record.force[i]));
  for (std::size_t i = compared; i + compared < fall.size(); ++i) {
    const auto at = fall.begin() + static_cast<std::ptrdiff_t>(i);
    if (!(record.force[i + 1] < record.force[i]) || !(*at > min_errors * noise)) continue;
    if (*std::max_element(at - compared, at + compared + 1) > *at) continue;
    Rounded drop{{}, {}, *at};
    for (std::size_t k = 0; k < compared; ++k) {
      drop.before[k] = fall[i - k - 1];
      drop.after[k] = fall[i + k + 1];
    }
    drops.push_back(drop);
  }
  return drops;
}

// [1] The expected statistic for snaps at random times between two rows, after a low-pass.
double longer_by_lag(double rows) {
  constexpr int snaps = 64;
  double longer = 0, all = 0;
  for (int snap = 0; snap < snaps; ++snap) {
    const double first = (snap + 0.5) / snaps;  // [rows] from the snap to the next row
    // the first falling step is in the middle or next to it
    std::array<double, 2 * compared + 2> steps{};
    double left = 1;
    for (std::size_t k = 0; compared + k < steps.size(); ++k) {
      const double then = elementary::exp(-(first + static_cast<double>(k)) / rows);
      steps[compared + k] = left - then;
      left = then;
    }
    const std::size_t steepest = steps[compared] >= steps[compared + 1] ? compared : compared + 1;
    for (std::size_t k = 1; k <= compared; ++k) longer += steps[steepest + k] - steps[steepest - k];
    all += steps[steepest];
  }
  return longer / all;
}

double lag_of(const std::vector<Rounded>& drops) {
  const Share share = share_of(drops, [](const Rounded& drop) { return drop.longer(); });
  const auto count = static_cast<double>(drops.size());
  // [1] due to the time between two rows; the scatter of three drops can be small by chance
  constexpr double of_one = 0.15;
  const double error = elementary::length(share.scatter, of_one / std::sqrt(count));
  constexpr double no_lag = 0.1;
  if (!(share.value - (1.3 + 1 / count) * error > no_lag)) return 0;
  constexpr Bracket lags{0.05, 8};
  const auto fine = [](const Bracket& lag) { return lag.width() < 1e-3; };
  return halved_until(fine, lags, [&](double lag) { return longer_by_lag(lag) > share.value; }).low;
}

// The width of a symmetric filter. The adjacent steps on both sides fall by at least a third of the
// drop, and equally; a low-pass acts less before the drop.
double spread_of(const std::vector<Rounded>& drops) {
  const Share before = share_of(drops, [](const Rounded& drop) { return drop.before.front(); });
  const Share after = share_of(drops, [](const Rounded& drop) { return drop.after.front(); });
  constexpr double min_errors = 2, one_row = 1.0 / 3, alike = 0.8;
  const auto is_spread = [&](const Share& share) { return share.value - min_errors * share.scatter > one_row; };
  if (!is_spread(before) || !is_spread(after) || before.value < alike * after.value) return 0;
  const Share all =
      share_of(drops, [](const Rounded& drop) { return Rounded::sum(drop.before) + Rounded::sum(drop.after); });
  return 1 + std::max(all.value, before.value + after.value);
}

// True if the force varies less from row to row, relative to three rows, than for white noise.
bool is_smooth_from_row_to_row(const Record& record) {
  const std::vector<double> smooth = smooth_steps(record);
  const StepNoise noise(record, smooth);
  constexpr double of_white = 1.4;  // 1 without a filter, 1.7 for the mildest filter
  return noise.over(3) > of_white * noise.over(1);
}

}  // namespace

RoundedDrops rounded_drops(const Record& record) {
  const std::vector<Rounded> drops = drops_of(record);
  constexpr std::size_t min_count = 3;
  if (drops.size() < min_count) return {drops.size(), 0, 0};
  const double spread = spread_of(drops);
  return {drops.size(), lag_of(drops), spread > 0 && is_smooth_from_row_to_row(record) ? spread : 0};
}

}  // namespace flexslip
