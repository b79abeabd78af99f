#include "report/design_json.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "report/design_words.h"

namespace flexslip {
namespace {

std::string_view name_of(DesignStatus status) { return status == DesignStatus::ok ? "ok" : "slipped_through"; }

Json outcome_json(const DesignOutcome& outcome, const Scales& scales) {
  Json first = nullptr;
  if (outcome.first_snap)
    first = {{"stage", scales.physical_length(outcome.first_snap->stage)},
             {"deflection", scales.physical_length(outcome.first_snap->w)},
             {"force_before", scales.physical_force(outcome.first_snap->F_before)},
             {"force_after", scales.physical_force(outcome.first_snap->F_after)}};
  return {{"status", name_of(outcome.status)},
          {"end", scales.physical_length(outcome.end)},
          {"snaps", outcome.snaps},
          {"first_snap", std::move(first)},
          {"drops", outcome.drops},
          {"largest_drop", scales.physical_force(outcome.largest_drop)},
          {"mean_drop", scales.physical_force(outcome.mean_drop)},
          {"greatest_force", scales.physical_force(outcome.greatest_force)},
          {"work", scales.physical_energy(outcome.work)},
          {"friction", scales.physical_energy(outcome.friction)},
          {"released", scales.physical_energy(outcome.released)},
          {"friction_share", outcome.friction / outcome.work}};
}

}  // namespace

Json design_json(const DesignAnswer& answer) {
  Json parameters = Json::object();
  for (const auto& [parameter, name, kind] : design_parameters())
    if (answer.input.has(parameter)) parameters[std::string(name)] = answer.input.value(parameter);
  Json changes = Json::array();
  const auto words = changes_in_words(answer);
  for (std::size_t i = 0; i < answer.changes.size(); ++i)
    changes.push_back(
        {{"parameter", described(answer.changes[i].parameter).name},
         {"from", answer.changes[i].from},
         {"to", answer.changes[i].to},
         {"largest_drop_share", answer.changes[i].outcome.largest_drop / answer.changes[i].outcome.greatest_force},
         {"words", words[i]}});
  Json json = outcome_json(answer.outcome, answer.scales);
  json["answer"] = design_in_short(answer);
  json["critical_stiffness"] = answer.scales.physical_stiffness(answer.critical);
  json["snaps_whatever_the_stiffness"] = answer.critical > 0 && !std::isfinite(answer.critical);
  json["changes"] = std::move(changes);
  json["parameters"] = std::move(parameters);
  json["units"] = units_json(answer.input.reduced());
  return json;
}

Json design_map_json(const DesignCase& input, const std::vector<MapAxis>& axes, const std::vector<MapPoint>& points) {
  Json rows = Json::array();
  for (const MapPoint& point : points) {
    Json row = point.outcome ? outcome_json(*point.outcome, *point.scales) : Json{{"status", "impossible"}};
    if (point.outcome) row["stiffness_margin"] = point.margin;
    for (std::size_t i = 0; i < axes.size(); ++i) row[std::string(described(axes[i].parameter).name)] = point.values[i];
    rows.push_back(std::move(row));
  }
  return {{"units", units_json(input.reduced())}, {"designs", std::move(rows)}};
}

}  // namespace flexslip
