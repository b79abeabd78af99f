#include "instruments/export_json.h"

#include <cmath>
#include <optional>
#include <utility>

#include "data/names.h"

namespace flexslip {
namespace {

Json text_of(char mark) { return mark == '\0' ? Json(nullptr) : Json(std::string(1, mark)); }

Json number_or_null(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json metadata_json(const std::vector<Metadatum>& metadata) {
  Json json = Json::object();
  for (const Metadatum& datum : metadata)
    if (!json.contains(datum.name)) json[datum.name] = datum.value;  // of several with one name the first
  return json;
}

Json columns_json(const ExportedSpecimen& specimen) {
  Json json = Json::array();
  for (const ExportColumn& column : specimen.columns) {
    const bool numbers = column.words.empty();
    json.push_back({{"number", column.number},
                    {"name", column.name},
                    {"unit", column.unit.empty() ? Json(nullptr) : Json(column.unit)},
                    {"role", name_of(column.role)},
                    {"first", numbers ? number_or_null(column.values.front()) : Json(column.words.front())},
                    {"last", numbers ? number_or_null(column.values.back()) : Json(column.words.back())}});
  }
  return json;
}

}  // namespace

std::string_view name_of(ColumnRole role) {
  return name_in_order<ColumnRole::other>(role, {"time", "displacement", "crosshead", "deflection", "force", "other"});
}

Json export_json(const Export& file, std::size_t chosen) {
  const ExportedSpecimen& shown = file.specimens.at(chosen);
  Json specimens = Json::array();
  for (const ExportedSpecimen& specimen : file.specimens)
    specimens.push_back({{"name", specimen.name},
                         {"columns", columns_json(specimen)},
                         {"rows", specimen.lines.size()},
                         {"first_line", specimen.lines.front()},
                         {"last_line", specimen.lines.back()},
                         {"metadata", metadata_json(specimen.metadata)}});
  return {{"format", file.format},
          {"encoding", name_of(file.encoding)},
          {"byte_order_mark", file.byte_order_mark},
          {"delimiter", text_of(file.separator)},
          {"decimal", text_of(file.decimal)},
          {"thousands", text_of(file.thousands)},
          {"quoted", file.quoted},
          {"columns", columns_json(shown)},
          {"rows", shown.lines.size()},
          {"specimens", std::move(specimens)},
          {"metadata", metadata_json(file.metadata)},
          {"test",
           {{"span", optional_json(file.test.span)},
            {"diameter", optional_json(file.test.diameter)},
            {"width", optional_json(file.test.width)},
            {"thickness", optional_json(file.test.thickness)},
            {"rate", optional_json(file.test.rate)}}},
          {"notes", file.notes},
          {"asks", file.asks},
          {"repeat_with", file.repeat_with}};
}

}  // namespace flexslip
