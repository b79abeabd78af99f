#include "design/open_study.h"

#include <algorithm>
#include <numbers>
#include <variant>

#include "design/design_result.h"
#include "io/parallel.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t values_of_each = 3, phases_with_others = 8, phases_alone = 24;
constexpr double positions = 400;  // of the band along the travel

// The design with one combination of the open numbers and one phase.
Test design_number(std::size_t number, const Test& loading, const std::vector<OpenNumber>& open, std::size_t phases) {
  Test test = loading;
  if (phases > 1)
    set(test, "phase",
        value_of(loading, "phase").value() +
            2 * std::numbers::pi * static_cast<double>(number % phases) / static_cast<double>(phases));
  number /= phases;
  for (const OpenNumber& each : open) {
    const double t = static_cast<double>(number % values_of_each) / static_cast<double>(values_of_each - 1);
    set(test, each.axis.parameter.name, value_at(std::get<AxisRange>(each.axis.values), t));
    number /= values_of_each;
  }
  return test;
}

struct Tried {
  std::optional<DesignOutcome> outcome;
  std::vector<RecordedForce> record{};
};

Tried tried(const Test& test) {
  Tried result{result_of(test).outcome};
  if (!result.outcome) return result;
  const Design design = design_of(test).design;
  result.record = record_of({design.friction, design.rig}, result.outcome->stage_reached, design.travel / positions);
  return result;
}

// Widens the band by a record, whose readings lie at the same positions except the last.
void widen(std::vector<ForceRange>& band, const std::vector<RecordedForce>& record) {
  for (std::size_t i = 0; i < record.size(); ++i) {
    const auto& [stage, F] = record[i];
    if (i == band.size()) band.push_back({stage, F, F});
    if (band[i].stage != stage) return;  // the end of a shorter record
    band[i].low = std::min(band[i].low, F);
    band[i].high = std::max(band[i].high, F);
  }
}

}  // namespace

std::optional<OpenStudy> open_study(const Test& loading, const std::vector<OpenNumber>& open, unsigned threads) {
  const bool has_phase = !loading.other && value_of(loading, "phase") && value_of(loading, "amplitude").value_or(0) > 0;
  if (open.empty() && !has_phase) return std::nullopt;
  const std::size_t phases = !has_phase ? 1 : open.empty() ? phases_alone : phases_with_others;
  std::size_t count = phases;
  for (std::size_t i = 0; i < open.size(); ++i) count *= values_of_each;
  std::vector<Tried> designs(count);
  for_each_index(count, threads, [&](std::size_t i) { designs[i] = tried(design_number(i, loading, open, phases)); });
  OpenStudy study{open, phases, 0, 0, infinity, 0, infinity, 0, {}};
  // The longest record first, so that the band has all positions.
  std::stable_sort(designs.begin(), designs.end(),
                   [](const Tried& a, const Tried& b) { return a.record.size() > b.record.size(); });
  for (const Tried& design : designs) {
    if (!design.outcome) continue;
    const DesignOutcome& outcome = *design.outcome;
    const double snap = outcome.largest_snap / outcome.greatest_force;
    ++study.designs;
    if (outcome.snaps > 0) ++study.snapping;
    study.min_snap = std::min(study.min_snap, snap);
    study.max_snap = std::max(study.max_snap, snap);
    study.min_force = std::min(study.min_force, outcome.greatest_force);
    study.max_force = std::max(study.max_force, outcome.greatest_force);
    widen(study.force, design.record);
  }
  return study.designs > 0 ? std::optional(std::move(study)) : std::nullopt;
}

}  // namespace flexslip
