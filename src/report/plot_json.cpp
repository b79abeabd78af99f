#include "report/plot_json.h"

#include <cmath>
#include <string>

#include "data/names.h"
#include "report/plot_layout.h"

namespace flexslip {
namespace {

Json json_of(const AxisLayout& laid, const Axis& axis) {
  Json ticks = Json::array(), texts = Json::array();
  for (const Tick& tick : laid.ticks) {
    ticks.push_back(tick.at);
    texts.push_back(tick.text);
  }
  return {{"label", label_of(axis)},
          {"from", laid.from},
          {"to", laid.to},
          {"logarithmic", axis.logarithmic},
          {"shown", !laid.label.empty()},
          {"numbers", laid.has_numbers},
          {"ticks", ticks},
          {"texts", texts}};
}

Json json_of(const Style& style) {
  return {{"colour", named(style.colour).hex},
          {"width", style.width},
          {"dash", name_in_order<Dash::dotted>(style.dash, {"solid", "dashed", "long_dashed", "dotted"})},
          {"symbol", name_in_order<Symbol::cross>(
                         style.symbol, {"", "disc", "circle", "square", "triangle", "down", "star", "cross"})},
          {"size", style.size},
          {"opacity", style.opacity}};
}

Json json_of(const Plot& plot, const Mark& mark) {
  Json columns = Json::array(), at = Json::array(), only = Json::object();
  if (!mark.table.empty()) {
    const PlotTable& table = table_of(plot, mark.table);
    for (const std::size_t column : mark.columns) columns.push_back(table.titles.at(column));
    for (const Condition& condition : mark.only) only[table.titles.at(condition.column)] = condition.value;
  }
  for (const double number : mark.at)
    at.push_back(std::isfinite(number) ? Json(number) : Json(number > 0 ? "end" : "begin"));
  return {{"kind", name_in_order<MarkKind::key_fill>(
                       mark.kind, {"line", "points", "band", "area", "bars", "spans", "arrows", "pixels", "horizontal",
                                   "vertical", "rectangle", "label", "key_line", "key_points", "key_fill"})},
          {"table", mark.table},
          {"columns", columns},
          {"at", at},
          {"only", only},
          {"title", has_something(plot, mark) ? mark.title : ""},
          {"style", json_of(mark.style)}};
}

}  // namespace

Json json_of(const Plot& plot) {
  const PlotLayout layout = layout_of(plot);
  Json panels = Json::array(), stops = Json::array();
  for (const PaletteStop& stop : palette) stops.push_back({stop.at, stop.hex});
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const Panel& panel = plot.panels[i];
    const PanelLayout& laid = layout.panels[i];
    Json marks = Json::array();
    for (const Mark& mark : panel.marks) marks.push_back(json_of(plot, mark));
    panels.push_back({{"title", panel.title},
                      {"left", laid.lower.x},
                      {"bottom", laid.lower.y},
                      {"width", laid.upper.x - laid.lower.x},
                      {"height", laid.upper.y - laid.lower.y},
                      {"key_rows", laid.key_rows},
                      {"key_left", laid.key.x},
                      {"key_bottom", laid.key.y},
                      {"x", json_of(laid.x, panel.x)},
                      {"y", json_of(laid.y, panel.y)},
                      {"colour", laid.colour.ticks.empty() ? Json(nullptr) : json_of(laid.colour, panel.colour)},
                      {"marks", marks}});
  }
  return {{"name", plot.name},     {"title", plot.title},     {"caption", plot.caption}, {"width", plot.width},
          {"height", plot.height}, {"columns", plot.columns}, {"x_label", layout.x},     {"y_label", layout.y},
          {"palette", stops},      {"panels", panels}};
}

Json json_with_data(const Plot& plot) {
  Json json = json_of(plot), data = Json::object();
  for (const PlotTable& table : plot.data) {
    Json columns = Json::object();
    for (std::size_t k = 0; k < table.titles.size(); ++k) {
      Json values = Json::array();
      for (const auto& row : table.rows)
        values.push_back(k < row.size() && std::isfinite(row[k]) ? Json(row[k]) : Json(nullptr));
      columns[table.titles[k]] = values;
    }
    data[table.name] = columns;
  }
  json["data"] = data;
  return json;
}

}  // namespace flexslip
