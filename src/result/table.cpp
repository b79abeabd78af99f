#include "result/table.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "io/text.h"
#include "io/text_file.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double nothing = not_a_number;

struct EstimatePart {
  std::string_view suffix, meaning;
};
constexpr std::array estimate_parts{EstimatePart{"", ""}, EstimatePart{"_standard_error", "its standard error"},
                                    EstimatePart{"_low", "lower end of its 95 % interval"},
                                    EstimatePart{"_high", "upper end of its 95 % interval"}};

double number_in(const Json& value) { return value.is_number() ? value.get<double>() : nothing; }

// Several words are joined.
std::string words_in(const Json& value) {
  if (!value.is_array()) return value.is_string() ? printable(value.get<std::string>()) : "";
  std::string words;
  for (const Json& each : value) words += (words.empty() ? "" : "; ") + words_in(each);
  return words;
}

}  // namespace

std::vector<TableColumn> columns_of(const std::vector<Description>& fields, bool reduced) {
  std::vector<TableColumn> columns;
  for (const Description& field : fields) {
    const std::string name(field.title.empty() ? field.name : field.title);
    const auto add = [&](std::string_view suffix, std::string_view meaning) {
      const std::string_view unit = unit_of(field.kind, reduced);
      columns.push_back({name + std::string(suffix), true, field.kind,
                         reduced || unit == "1" ? std::string() : std::string(unit), std::string(meaning), name});
    };
    switch (field.shape) {
      case Shape::words:
      case Shape::yes_no:
        columns.push_back({name, false, kind::number, "", std::string(field.meaning), ""});
        break;
      case Shape::number:
      case Shape::count:
        add("", field.meaning);
        break;
      case Shape::estimate:
        for (const auto& [suffix, meaning] : estimate_parts) add(suffix, meaning.empty() ? field.meaning : meaning);
        break;
      case Shape::group:
        for (TableColumn& column : columns_of(field.entries, reduced)) {
          column.name = fmt::format("{}_{}", name, column.name);
          column.quantity = name;
          columns.push_back(std::move(column));
        }
        break;
      default:
        throw std::invalid_argument(fmt::format("{} is no column of a table", field.name));
    }
  }
  return columns;
}

void append_cells(std::vector<Cell>& cells, const Description& field, const Json& value) {
  switch (field.shape) {
    case Shape::words:
      cells.emplace_back(words_in(value));
      break;
    case Shape::yes_no:
      cells.emplace_back(value.is_null() ? "" : value.get<bool>() ? "yes" : "no");
      break;
    case Shape::estimate:
      if (value.is_null()) {
        cells.insert(cells.end(), estimate_parts.size(), nothing);
        break;
      }
      cells.emplace_back(number_in(value.at("value")));
      cells.emplace_back(number_in(value.at("standard_error")));
      for (const Json& end : value.at("interval95")) cells.emplace_back(number_in(end));
      break;
    case Shape::group:
      for (const Description& entry : field.entries)
        append_cells(cells, entry, value.is_null() ? value : value.at(std::string(entry.name)));
      break;
    default:
      cells.emplace_back(number_in(value));
  }
}

std::vector<std::string> titles_of(const std::vector<TableColumn>& columns) {
  std::vector<std::string> titles;
  for (const TableColumn& column : columns)
    titles.push_back(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
  return titles;
}

void write_csv(const std::string& path, const ResultTable& table, const CsvMarks& marks) {
  auto row = table.rows.begin();
  const auto next = [&](std::vector<Cell>& cells) {
    if (row == table.rows.end()) return false;
    cells = *row++;
    for (Cell& cell : cells)
      if (auto* words = std::get_if<std::string>(&cell)) *words = without_formula(*words);
    return true;
  };
  write_table(path, titles_of(table.columns), next, marks);
}

TableUnit best_unit_of(std::vector<double> values, const Kind& kind) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
               values.end());
  for (double& value : values) value = std::abs(value);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const std::string_view unit = best_unit(values.empty() ? 1 : *middle, kind);
  return {std::string(unit), unit.empty() ? 1 : from_si(1, parse_unit(unit))};
}

ResultTable in_best_units(ResultTable table) {
  std::map<std::string, std::string> units;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    auto& column = table.columns[i];
    if (column.unit.empty()) continue;
    const auto [unit, is_first] = units.try_emplace(column.quantity);
    if (is_first) {
      std::vector<double> values;
      for (const auto& row : table.rows) values.push_back(std::get<double>(row[i]));
      unit->second = best_unit_of(std::move(values), column.kind).name;
    }
    column.unit = unit->second;
    const Unit scale = parse_unit(column.unit);
    for (auto& row : table.rows) row[i] = from_si(std::get<double>(row[i]), scale);
  }
  return table;
}

std::string json_text(const Json& json) {
  // file names may be invalid UTF-8
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_json(const std::string& path, const Json& json) { write_text(path, json_text(json)); }

}  // namespace flexslip
