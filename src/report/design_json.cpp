#include "report/design_json.h"

#include <cmath>
#include <string>
#include <utility>

#include "report/design_words.h"

namespace flexslip {
namespace {

void add_outcome(Json& json, const DesignOutcome& outcome, const DesignUnits& units) {
  for (const OutcomeColumn& column : outcome_columns()) {
    const double value = column.value(outcome, units);
    json[std::string(column.name)] =
        column.stored_as == StoredAs::float64 ? Json(value) : Json(static_cast<std::size_t>(value));
  }
}

}  // namespace

Json design_json(const DesignAnswer& answer) {
  Json parameters = Json::object();
  for (const DesignParameterName& known : design_parameters())
    if (answer.input.has(known.parameter)) parameters[std::string(known.name)] = answer.input.value(known.parameter);
  Json changes = Json::array();
  const auto words = changes_in_words(answer);
  for (std::size_t i = 0; i < answer.changes.size(); ++i)
    changes.push_back(
        {{"parameter", described(answer.changes[i].parameter).name},
         {"from", answer.changes[i].from},
         {"to", answer.changes[i].to},
         {"and_beyond", answer.changes[i].and_beyond},
         {"largest_drop_share", answer.changes[i].outcome.largest_drop / answer.changes[i].outcome.greatest_force},
         {"words", words[i]}});
  Json json{{"status", word_of(status_of(answer.outcome))}};
  add_outcome(json, answer.outcome, {answer.scales, answer.surface});
  json["wraps_nose"] = answer.wraps_nose;
  json["friction_share"] = answer.outcome.friction_heat / answer.outcome.work;
  json["answer"] = design_in_short(answer);
  json["critical_stiffness"] = answer.scales.physical_stiffness(answer.critical);
  json["snaps_whatever_the_stiffness"] = answer.critical > 0 && !std::isfinite(answer.critical);
  if (const auto& phases = answer.phases)
    json["phases"] = {{"count", phases->phases},
                      {"snapping", phases->snapping},
                      {"least_largest_drop", answer.scales.physical_force(phases->least_drop)},
                      {"greatest_largest_drop", answer.scales.physical_force(phases->largest_drop)},
                      {"critical_stiffness", answer.scales.physical_stiffness(phases->critical)}};
  else
    json["phases"] = nullptr;
  json["changes"] = std::move(changes);
  json["parameters"] = std::move(parameters);
  json["units"] = units_json(answer.input.reduced());
  return json;
}

Json design_map_json(const DesignCase& input, const std::vector<DesignAxis>& axes,
                     const std::vector<MapPoint>& points) {
  Json rows = Json::array();
  for (const MapPoint& point : points) {
    Json row{{"status", word_of(point.result.status)}};
    if (point.result.outcome) {
      add_outcome(row, *point.result.outcome, *point.result.units);
      row["stiffness_margin"] = point.margin;
    }
    for (std::size_t i = 0; i < axes.size(); ++i) row[std::string(axes[i].parameter.name)] = point.values[i];
    rows.push_back(std::move(row));
  }
  return {{"units", units_json(input.reduced())}, {"designs", std::move(rows)}};
}

}  // namespace flexslip
