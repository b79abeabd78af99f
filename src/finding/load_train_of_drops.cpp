#include "finding/load_train_of_drops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "data/rounded_drops.h"
#include "finding/printed.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

// What changes in a drop beyond what changed in the rows before it.
struct InDrop {
  double farther;  // [m] the specimen bends
  double leap;     // [m] the stage moves
  double way;      // [m] the stage moves as before
  double relief;   // [N] of the load train
};

std::vector<InDrop> in_drops(T test) {
  const Record& record = test.analysis.record;
  const std::vector<Drop>& drops = test.analysis.drops.drops;
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
                   .way = usual(record.stage),
                   .relief = -beyond(record.force)});
  }
  return all;
}

double stated_compliance(T test) { return 1 / test.analysis.scales.physical_stiffness(test.analysis.rig.stiffness); }

constexpr std::size_t enough = 3;  // drops

}  // namespace

bool is_bent_enough(T test) { return test.analysis.status != AnalysisStatus::bent_too_little; }

std::string load_train_in_words(T test) {
  const double stiffness = test.analysis.rig.stiffness;
  return std::isfinite(stiffness) ? Print(test).own(test.analysis.scales.physical_stiffness(stiffness), kind::stiffness)
                                  : "∞";
}

// A stage moves evenly from row to row; a deflection leaps in each drop by what the load train gives back.
std::optional<Finding> deflection_for_stage(T test) {
  if (!is_bent_enough(test) || !test.measurement.is_derived || std::isinf(test.analysis.rig.stiffness))
    return std::nullopt;
  const std::vector<InDrop> drops = in_drops(test);
  if (drops.size() < enough) return std::nullopt;
  double leaps = 0, reliefs = 0, squares = 0;
  for (const InDrop& drop : drops) {
    leaps += drop.leap * drop.relief;
    reliefs += drop.relief * drop.relief;
  }
  for (const InDrop& drop : drops) {
    const double rest = drop.leap - leaps / reliefs * drop.relief;
    squares += rest * rest;
  }
  const double stated = stated_compliance(test), share = leaps / reliefs / stated;
  const double error = std::sqrt(squares / (static_cast<double>(drops.size() - 1) * reliefs)) / stated;
  constexpr double surely = 3, half = 0.5;
  if (!(share - surely * error > half)) return std::nullopt;
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("In each of the {} drops the column taken for the stage leaps ahead, by {:.2f} of what "
                              "the load train gives back; a stage moves evenly. It holds the deflection.",
                              drops.size(), share),
      .short_form = "the stage leaps as a deflection does",
      .remedy = "Name that column as the deflection, or the column of the stage.",
      .numbers = {{"leap", share}}};
}

// What the specimen bends in a drop beyond the rows before it is what the load train gives back. Those drops do not fit in which that is off by more
// than half of what the load train stated makes it, and by more than the stage moves meanwhile.
std::optional<Finding> other_train_in_drops(T test) {
  const double stated = stated_compliance(test);
  const std::size_t drops = test.analysis.drops.drops.size();
  std::size_t misfits = 0;
  std::vector<double> compliances;  // [m/N]
  for (const InDrop& drop : in_drops(test)) {
    compliances.push_back(drop.farther / drop.relief);
    misfits += std::abs(drop.farther - stated * drop.relief) > 0.5 * stated * drop.relief + drop.way;
  }
  if (misfits < enough || 2 * misfits < drops) return std::nullopt;
  if (rounded_drops(test.analysis.record).lag > 0) return std::nullopt;  // of a force that lags behind
  const double compliance = median_of(compliances);
  if (!(compliance > 0)) return std::nullopt;
  const double train = 1 / compliance;
  const std::string as_on = format_roughly(train, Print(test).as(kind::stiffness));
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format(
          "{} of {} drops do not fit the load train stated ({}): while the force falls, the specimen bends as on {}.",
          misfits, drops, load_train_in_words(test), as_on),
      .short_form = fmt::format("load train as of {}", as_on),
      .remedy = fmt::format("State the stiffness of the load train ({}).",
                            keys_in_words(test.measurement.test, "rig", {"stiffness"})),
      .numbers = {{"misfits", static_cast<double>(misfits)}, {"load_train", train, kind::stiffness}}};
}

}  // namespace flexslip
