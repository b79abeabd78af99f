#include "report/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "finding/printed.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// The description at a path "group.entry".
Description described(const std::vector<Description>& fields, std::string_view path) {
  const std::size_t dot = path.find('.');
  const std::string_view name = path.substr(0, dot);
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const Description& each) { return each.name == name; });
  if (found == fields.end()) throw std::invalid_argument(fmt::format("no field '{}'", path));
  return dot == std::string_view::npos ? *found : described(found->entries, path.substr(dot + 1));
}

Json entry(const Json& row, std::string_view path) {
  const std::size_t dot = path.find('.');
  const auto found = row.is_object() ? row.find(std::string(path.substr(0, dot))) : row.end();
  if (found == row.end()) return nullptr;
  return dot == std::string_view::npos ? *found : entry(*found, path.substr(dot + 1));
}

// The ends of the 95 % interval of an estimate, in the unit of the value.
std::string with_ends(const Estimate& estimate, const Kind& kind) {
  const auto unit = best_unit(std::max(std::abs(estimate.value), estimate.standard_error), kind);
  const MatchedDigits digits = matched_digits(estimate, unit.empty() ? 1 : from_si(1, parse_unit(unit)));
  return digits.low.empty()
             ? ""
             : fmt::format("{} to {}{}{}", digits.low, digits.high, unit.empty() ? "" : " ", typeset(unit));
}

double number_or_nan(const Json& value) { return value.is_number() ? value.get<double>() : not_a_number; }

std::string words_for(const Json& value, const Shown& column) {
  if (!value.is_string()) return "";
  const auto words = value.get<std::string>();
  const auto said = std::find_if(column.in_words.begin(), column.in_words.end(),
                                 [&](const auto& each) { return each.first == words; });
  return said == column.in_words.end() ? printable(words) : std::string(said->second);
}

// A column of numbers in one unit: the heading with the unit, and the cells.
std::vector<std::string> column_of_numbers(const Shown& column, const std::vector<double>& values, const Kind& kind) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const std::string_view unit = best_unit(largest, kind);
  const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
  const double most = from_si(largest, scale);
  const int decimals =
      most > 0 ? std::clamp(column.digits - 1 - static_cast<int>(std::floor(std::log10(most))), 0, 9) : 1;
  std::vector<std::string> cells{unit.empty()             ? column.heading
                                 : column.heading.empty() ? typeset(unit)
                                                          : fmt::format("{} ({})", column.heading, typeset(unit))};
  for (const double value : values) {
    const double shown = from_si(value, scale);
    const bool is_zero = std::abs(shown) < 0.5 * std::pow(10, -decimals);
    cells.push_back(std::isfinite(value) ? fmt::format("{:.{}f}", is_zero ? 0 : shown, decimals) : "");
  }
  return cells;
}

Kind kind_in(const Frame& frame, const Description& field) {
  return frame.reduced ? kind::number : frame.in_inches ? in_inches(field.kind) : field.kind;
}

// One value as printed; empty if missing, and for lists and groups.
std::string cell_of(const Description& field, const Json& value, const Frame& frame) {
  const Json number = value.is_object() ? entry(value, "value") : value;
  switch (field.shape) {
    case Shape::estimate:
      return number.is_number()
                 ? readable(number_or_nan(number), number_or_nan(entry(value, "standard_error")), kind_in(frame, field))
                 : "";
    case Shape::quantity:
    case Shape::number:
      return !std::isfinite(number_or_nan(number)) ? ""
             : kind_in(frame, field).units.empty() ? fmt::format("{:.3g}", number_or_nan(number))
                                                   : readable(number_or_nan(number), kind_in(frame, field));
    case Shape::count:
      return value.is_null() ? "" : value.dump();
    case Shape::yes_no:
      return !value.is_boolean() ? "" : value.get<bool>() ? "yes" : "no";
    case Shape::words:
      return value.is_string() && field.name != "unit" ? printable(value.get<std::string>()) : "";
    default:
      return "";
  }
}

// The heading of a column and its cells.
std::vector<std::string> column_of(const std::vector<Description>& fields, const Json& rows, const Frame& frame,
                                   const Shown& column) {
  std::vector<std::string> cells{column.heading};
  if (column.field.empty()) {
    for (std::size_t i = 0; i < rows.size(); ++i) cells.push_back(fmt::format("{}", i + 1));
    return cells;
  }
  const Description field = described(fields, column.field);
  if (field.shape == Shape::number) {
    std::vector<double> values;
    for (const Json& row : rows) values.push_back(column.factor * number_or_nan(entry(row, column.field)));
    return column_of_numbers(column, values, kind_in(frame, field));
  }
  constexpr std::array as_cells{Shape::estimate, Shape::count, Shape::numbers, Shape::words};
  if (std::find(as_cells.begin(), as_cells.end(), field.shape) == as_cells.end())
    throw std::invalid_argument(fmt::format("'{}' is no column of a printed table", column.field));
  if (!column.last.empty()) described(fields, column.last);
  for (const Json& row : rows) {
    const Json value = entry(row, column.field);
    std::string& cell =
        cells.emplace_back(field.shape == Shape::words ? words_for(value, column) : cell_of(field, value, frame));
    if (const Json last = column.last.empty() ? nullptr : entry(row, column.last); !cell.empty() && !last.is_null())
      cell += "–" + last.dump();
    if (field.shape != Shape::numbers) continue;
    for (const Json& each : value)
      cell += (cell.empty() ? "" : "–") + (each.is_number() ? fmt::format("{}", each.get<double>()) : "");
  }
  return cells;
}

bool begins_as_number(std::string_view cell) {
  for (const std::string_view before : {"at most ", "a factor ", "p = ", "± ", "< ", "(", "["})
    if (cell.starts_with(before)) cell.remove_prefix(before.size());
  constexpr std::string_view minus = "−";
  if (cell.starts_with(minus)) cell.remove_prefix(minus.size());
  return !cell.empty() && (std::string_view("0123456789-+").find(cell.front()) != std::string_view::npos);
}

// The value at a path in an answer.
Json entry_of(const FieldList& answer, const void* of, const Frame& frame, std::string_view path) {
  const std::string_view first = path.substr(0, path.find('.'));
  const auto found = std::find_if(answer.fields().begin(), answer.fields().end(),
                                  [&](const Field& field) { return field.what.name == first; });
  Json top = Json::object();
  put(top, first, found->of(of, frame));
  return entry(top, path);
}

// A meaning without its remarks on JSON and without names of code.
std::string meaning_for_people(std::string_view meaning) {
  for (const std::string_view remark : {"; null", "; its error from scatter", ": ok, ", ": causes."})
    meaning = meaning.substr(0, meaning.find(remark));
  return replaced(replaced(meaning, "mu0", "μ₀"), "_", " ");
}

// Adds the entries of a group. Entries of nested groups get both names; lists are separate tables.
void add_entries(PrintedTable& table, const std::vector<Description>& entries, const Json& values, const Frame& frame,
                 const std::string& above) {
  for (const Description& each : entries) {
    const Json value = entry(values, each.name);
    const std::string name = above + std::string(each.name);
    const std::string cell = cell_of(each, value, frame);
    std::string interval;
    if (const Json ends = each.shape == Shape::estimate ? entry(value, "interval95") : nullptr;
        ends.is_array() && ends[0].is_number() && ends[0] != ends[1])
      interval = with_ends({number_or_nan(value["value"]), number_or_nan(value["standard_error"]), ends[0], ends[1]},
                           kind_in(frame, each));
    const std::string meaning = meaning_for_people(each.meaning);
    if (!cell.empty())
      table.rows.push_back(
          {name, cell, interval,
           each.shape == Shape::yes_no && !meaning.starts_with("whether ") ? "whether " + meaning : meaning});
    if (each.shape == Shape::estimate || each.shape == Shape::group)
      add_entries(table, each.entries, value, frame, name + ".");
  }
}

}  // namespace

bool is_of_numbers(const PrintedTable& table, std::size_t column) {
  if (column == 0) return false;
  bool has_some = table.rows.empty();
  for (const auto& row : table.rows) {
    if (row[column].empty()) continue;
    if (!begins_as_number(row[column])) return false;
    has_some = true;
  }
  return has_some;
}

PrintedTable picked(const PrintedTable& table, std::vector<std::size_t> columns) {
  if (columns.empty())
    for (std::size_t i = 0; i < table.head.size(); ++i) columns.push_back(i);
  PrintedTable some;
  some.rows.resize(table.rows.size());
  for (const std::size_t column : columns) {
    const auto has_value = [&](const auto& row) { return !row.at(column).empty(); };
    if (!table.rows.empty() && std::none_of(table.rows.begin(), table.rows.end(), has_value)) continue;
    some.head.push_back(table.head.at(column));
    for (std::size_t i = 0; i < table.rows.size(); ++i) some.rows[i].push_back(table.rows[i][column]);
  }
  return some;
}

PrintedTable shown(const FieldList& answer, const void* of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns) {
  const Description what = described(answer.descriptions(), list);
  const Json entries = entry_of(answer, of, frame, list);
  PrintedTable table;
  table.rows.resize(entries.size());
  for (const Shown& column : columns) {
    const std::vector<std::string> cells = column_of(what.entries, entries, frame, column);
    table.head.push_back(cells.front());
    for (std::size_t i = 0; i < entries.size(); ++i) table.rows[i].push_back(cells[i + 1]);
  }
  return table;
}

PrintedTable group_table(const FieldList& answer, const void* of, const Frame& frame, std::string_view group) {
  const Description what = described(answer.descriptions(), group);
  PrintedTable table{.head = {std::string(group), "Value", "95 % interval", meaning_for_people(what.meaning)},
                     .rows = {},
                     .folding = Folding::always};
  add_entries(table, what.entries, entry_of(answer, of, frame, group), frame, "");
  table.on_page = {3, 1, 2};
  return table;
}

}  // namespace flexslip
