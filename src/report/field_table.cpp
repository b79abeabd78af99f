#include "report/field_table.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "fibre/limits.h"
#include "io/text.h"

namespace flexslip {
namespace {

// Of an entry of a group: first the group.
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

double number_or_nan(const Json& value) { return value.is_number() ? value.get<double>() : not_a_number; }

std::string words_for(const Json& value, const Shown& column) {
  if (!value.is_string()) return "";
  const auto words = value.get<std::string>();
  const auto said = std::find_if(column.in_words.begin(), column.in_words.end(),
                                 [&](const auto& each) { return each.first == words; });
  return said == column.in_words.end() ? printable(words) : std::string(said->second);
}

std::string with_error(const Json& value, const Json& error, const Kind& kind) {
  return value.is_number() ? readable(number_or_nan(value), number_or_nan(error), kind) : "";
}

// A column of one cell per row, under its heading.
PrintedTable column_of(const std::vector<Description>& fields, const Json& rows, const Frame& frame,
                       const Shown& column) {
  PrintedTable cells{{column.heading}, {}};
  const auto add = [&](std::string cell) { cells.rows.push_back({std::move(cell)}); };
  if (column.field.empty()) {
    for (std::size_t i = 0; i < rows.size(); ++i) add(fmt::format("{}", i + 1));
    return cells;
  }
  const Description field = described(fields, column.field);
  const Kind& kind = frame.reduced ? kind::number : frame.in_inches ? in_inches(field.kind) : field.kind;
  switch (field.shape) {
    case Shape::number: {
      NumberColumn numbers{column.heading, {}, kind, column.digits};
      for (const Json& row : rows) numbers.values.push_back(column.factor * number_or_nan(entry(row, column.field)));
      return printed({numbers});
    }
    case Shape::estimate:
      for (const Json& row : rows) {
        const Json estimate = entry(row, column.field);
        add(with_error(entry(estimate, "value"), entry(estimate, "standard_error"), kind));
      }
      return cells;
    case Shape::count:
      if (!column.last.empty()) described(fields, column.last);
      for (const Json& row : rows) {
        const Json first = entry(row, column.field);
        const Json last = column.last.empty() ? nullptr : entry(row, column.last);
        add(first.is_null() ? "" : last.is_null() ? first.dump() : fmt::format("{}–{}", first.dump(), last.dump()));
      }
      return cells;
    case Shape::numbers:
      for (const Json& row : rows) {
        std::string range;
        for (const Json& value : entry(row, column.field))
          range += (range.empty() ? "" : "–") + (value.is_number() ? fmt::format("{}", value.get<double>()) : "");
        add(std::move(range));
      }
      return cells;
    case Shape::words:
      for (const Json& row : rows) add(words_for(entry(row, column.field), column));
      return cells;
    default:
      throw std::invalid_argument(fmt::format("'{}' is no column of a printed table", column.field));
  }
}

}  // namespace

PrintedTable shown(const FieldList& answer, const void* of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns) {
  const Description what = described(answer.descriptions(), list);
  const std::string_view first = list.substr(0, list.find('.'));
  const auto found = std::find_if(answer.fields().begin(), answer.fields().end(),
                                  [&](const Field& field) { return field.what.name == first; });
  Json top = Json::object();
  put(top, first, found->of(of, frame));
  const Json entries = entry(top, list);
  PrintedTable table;
  table.rows.resize(entries.size());
  for (const Shown& column : columns) {
    const PrintedTable cells = column_of(what.entries, entries, frame, column);
    table.head.push_back(cells.head.front());
    for (std::size_t i = 0; i < entries.size(); ++i) table.rows[i].push_back(cells.rows[i].front());
  }
  return table;
}

}  // namespace flexslip
