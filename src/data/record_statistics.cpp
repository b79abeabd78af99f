#include "data/record_statistics.h"

#include <algorithm>
#include <cmath>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

double rows_between(const std::vector<Drop>& drops) {
  constexpr std::size_t min_drops = 3;
  if (drops.size() < min_drops) return not_a_number;
  std::vector<double> rows;
  for (std::size_t i = 1; i < drops.size(); ++i)
    rows.push_back(static_cast<double>(drops[i].before - drops[i - 1].after + 1));
  return median_of(rows);
}

WidestStep widest_step(const std::vector<double>& stage) {
  if (stage.size() < 2) return {};
  std::vector<double> steps;
  for (std::size_t i = 1; i < stage.size(); ++i) steps.push_back(stage[i] - stage[i - 1]);
  const auto widest = std::max_element(steps.begin(), steps.end());
  return {.behind = static_cast<std::size_t>(widest - steps.begin()),
          .length = *widest,
          .usual = median_of(steps),
          .share_of_travel = *widest / (stage.back() - stage.front())};
}

Sinking sinking(const std::vector<double>& force, const std::vector<Drop>& drops) {
  constexpr std::size_t min_points = 20;
  if (force.size() < min_points) return {};
  const double greatest = *std::max_element(force.begin(), force.end());
  if (!(greatest > 0)) return {};
  const std::vector<double> smooth = medians_of_five(force);
  Sinking deepest;
  std::size_t top = 0;
  double by_drops = 0;  // since the maximum
  auto drop = drops.begin();
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    for (; drop != drops.end() && drop->after <= i; ++drop) by_drops += drop->force_fall;
    if (smooth[i] >= smooth[top]) {
      top = i;
      by_drops = 0;
    }
    const double share = (smooth[top] - smooth[i] - by_drops) / greatest;
    if (share > deepest.share) deepest = {.from = top, .share = share};
  }
  return deepest;
}

// The changes during a drop, beyond the trend of the rows before it.
struct InDrop {
  double farther;     // [m] additional deflection
  double leap;        // [m] additional movement of the stage
  double travel;      // [m] movement of the stage at its earlier rate
  double force_drop;  // [N] decrease of the force
};

std::vector<InDrop> changes_in_drops(const Record& record, const std::vector<Drop>& drops) {
  constexpr std::size_t max_rows = 5;
  std::vector<InDrop> all;
  for (std::size_t i = 0; i < drops.size(); ++i) {
    const std::size_t before = drops[i].before, after = drops[i].after;
    const std::size_t rows = std::min(before - (i == 0 ? 0 : std::min(drops[i - 1].after, before)), max_rows);
    if (rows == 0) continue;
    const double times = static_cast<double>(after - before) / static_cast<double>(rows);
    const auto usual = [&](const std::vector<double>& column) {
      return times * (column[before] - column[before - rows]);
    };
    const auto beyond = [&](const std::vector<double>& column) {
      return column[after] - column[before] - usual(column);
    };
    if (!(beyond(record.force) < 0)) continue;
    all.push_back({.farther = beyond(record.deflection),
                   .leap = beyond(record.stage),
                   .travel = usual(record.stage),
                   .force_drop = -beyond(record.force)});
  }
  return all;
}

TrainInDrops train_in_drops(const Record& record, const std::vector<Drop>& drops, double load_train_stiffness) {
  const std::vector<InDrop> changes = changes_in_drops(record, drops);
  if (changes.empty()) return {};
  const double stated = 1 / load_train_stiffness;
  TrainInDrops train{.drops = changes.size()};
  std::vector<double> compliances;  // [m/N]
  double leaps = 0, reliefs = 0, squares = 0;
  for (const InDrop& drop : changes) {
    compliances.push_back(drop.farther / drop.force_drop);
    train.misfits += std::abs(drop.farther - stated * drop.force_drop) > 0.5 * stated * drop.force_drop + drop.travel;
    leaps += drop.leap * drop.force_drop;
    reliefs += drop.force_drop * drop.force_drop;
  }
  for (const InDrop& drop : changes) {
    const double rest = drop.leap - leaps / reliefs * drop.force_drop;
    squares += rest * rest;
  }
  train.compliance = median_of(compliances);
  train.leap = leaps / reliefs / stated;
  if (changes.size() > 1)
    train.leap_error = std::sqrt(squares / (static_cast<double>(changes.size() - 1) * reliefs)) / stated;
  return train;
}

}  // namespace

RecordStatistics statistics_of(const Record& record, const std::vector<Drop>& drops, double load_train_stiffness) {
  return {.rounded = rounded_drops(record),
          .rows_between_drops = rows_between(drops),
          .widest_step = widest_step(record.stage),
          .sinking = sinking(record.force, drops),
          .train = train_in_drops(record, drops, load_train_stiffness)};
}

}  // namespace flexslip
