#include "instruments/export_fields.h"

#include <cmath>
#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "instruments/metadata.h"
#include "io/quantity.h"
#include "io/table.h"
#include "io/text_file.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// ---- the canonical form

std::string remark(const Metadatum& datum) {
  return datum.value.empty() ? fmt::format("# {}\n", datum.name) : fmt::format("# {}: {}\n", datum.name, datum.value);
}

// A line of the preamble, rewritten so that it keeps its meaning in a table with decimal points.
std::string translated(const Metadatum& datum, const NumberFormat& format) {
  const std::span<const Metadatum> alone(&datum, 1);
  const NumberFormat here{};
  const ExportedTest test = test_in(alone, format);
  const auto force = stated_maximum(alone, format);
  const auto force_here = stated_maximum(alone, here);
  const bool same_force = force.has_value() == force_here.has_value() && (!force || force->value == force_here->value);
  if (test == test_in(alone, here) && same_force) return remark(datum);
  for (const auto& length : {test.span, test.diameter, test.width, test.thickness})
    if (length) {
      const auto unit = best_unit(*length, kind::length);
      return remark({datum.name, fmt::format("{:.15g} {}", from_si(*length, parse_unit(unit)), unit), 0});
    }
  if (test.rate) return remark({datum.name, fmt::format("{} m/s", *test.rate), 0});
  if (force) return remark({datum.name, fmt::format("{} N", force->value), 0});
  return fmt::format("# not understood: {} = {}\n", datum.name, datum.value);
}

// ---- fields

std::optional<std::string> text_of(char mark) {
  return mark == '\0' ? std::nullopt : std::optional(std::string(1, mark));
}

// If several have the same name, the first is used.
std::vector<std::pair<std::string, std::string>> first_of_each(const std::vector<Metadatum>& metadata) {
  std::vector<std::pair<std::string, std::string>> first;
  std::map<std::string, bool> known;
  for (const Metadatum& datum : metadata)
    if (known.emplace(datum.name, true).second) first.emplace_back(datum.name, datum.value);
  return first;
}

Fields<ExportColumn> column_fields() {
  using C = const ExportColumn&;
  const auto end = [](C column, double number, const auto& word) {
    return !column.words.empty() ? Json(word()) : std::isnan(number) ? Json() : Json(number);
  };
  return Fields<ExportColumn>()
      .count("number", "number of the column in the file, from 1", &ExportColumn::number)
      .words("name", "name of the column, as in the file", &ExportColumn::name)
      .words("unit", "unit of the column, as in the file; null if there is none",
             [](C column) { return column.unit.empty() ? std::nullopt : std::optional(column.unit); })
      .words("role", "role of the column: time, displacement, crosshead, deflection, force or other",
             [](C column) { return words_for(column.role).name; })
      .any("first", "content of the first row",
           [end](C column) {
             return end(column, column.values.empty() ? not_a_number : column.values.front(),
                        [&] { return column.words.front(); });
           })
      .any("last", "content of the last row", [end](C column) {
        return end(column, column.values.empty() ? not_a_number : column.values.back(),
                   [&] { return column.words.back(); });
      });
}

Fields<ExportedSpecimen> specimen_fields() {
  using S = const ExportedSpecimen&;
  return Fields<ExportedSpecimen>()
      .words("name", "name of the specimen; empty if the file names none", &ExportedSpecimen::name)
      .list("columns", "columns of the specimen", column_fields(), &ExportedSpecimen::columns)
      .count("rows", "number of rows of the specimen", [](S specimen) { return specimen.lines.size(); })
      .count("first_line", "line of the file with the first row", [](S specimen) { return specimen.lines.front(); })
      .count("last_line", "line of the file with the last row", [](S specimen) { return specimen.lines.back(); })
      .words_by_name("metadata", "what the file says about this specimen, under the file's own names",
                     [](S specimen) { return first_of_each(specimen.metadata); });
}

Fields<ExportedTest> test_fields() {
  return Fields<ExportedTest>()
      .own("span", kind::length, "support span", &ExportedTest::span)
      .own("diameter", kind::length, "diameter of the specimen", &ExportedTest::diameter)
      .own("width", kind::length, "width of the specimen", &ExportedTest::width)
      .own("thickness", kind::length, "thickness of the specimen", &ExportedTest::thickness)
      .number("rate", "speed of the crosshead, in m/s", &ExportedTest::rate);
}

}  // namespace

Fields<ToldExport> export_fields() {
  using E = const ToldExport&;
  const auto chosen = [](E told) -> const ExportedSpecimen& { return told.file.specimens.at(told.chosen); };
  const auto of = [](auto part) { return [part](E told) { return told.file.*part; }; };
  const auto of_origin = [](auto part) { return [part](E told) { return told.file.origin.*part; }; };
  const auto mark = [](char NumberFormat::*part) { return [part](E told) { return text_of(told.file.marks.*part); }; };
  return Fields<ToldExport>()
      .words("format", "format of the file: Instron Bluehill, …, or table", of(&Export::format))
      .words("sheet", "sheet of the workbook (.xlsx) that was read; null for a text file",
             of_origin(&SheetOrigin::sheet))
      .words("sheets", "sheets of the workbook, in their order", of_origin(&SheetOrigin::sheets))
      .words("encoding", "encoding of the text", [](E told) { return name_of(told.file.origin.encoding); })
      .yes_no("byte_order_mark", "the file begins with a byte order mark", of_origin(&SheetOrigin::byte_order_mark))
      .words("delimiter", "separator between columns", [](E told) { return text_of(told.file.origin.separator); })
      .words("decimal", "decimal mark", mark(&NumberFormat::decimal))
      .words("thousands", "mark between thousands; null without one", mark(&NumberFormat::thousands))
      .yes_no("quoted", "cells are in quotes", of(&Export::quoted))
      .list("columns", "columns of the chosen specimen", column_fields(),
            [chosen](E told) { return chosen(told).columns; })
      .count("rows", "number of rows of the chosen specimen", [chosen](E told) { return chosen(told).lines.size(); })
      .list("specimens", "specimens in the file", specimen_fields(), of(&Export::specimens))
      .words_by_name("metadata", "what the file says about all specimens, under its own names",
                     [](E told) { return first_of_each(told.file.metadata); })
      .group("test", "metadata that were understood; null if not stated", test_fields(), of(&Export::test))
      .words("notes", "decisions about the file, and what was left out", of(&Export::notes))
      .words("asks",
             "questions that the file leaves open about the chosen specimen and an evaluation needs answered, each "
             "with its flag",
             [chosen](E told) {
               std::vector<std::string> asks;
               for (const OpenQuestion& each : chosen(told).asks) asks.push_back(each.words + " " + each.with_read);
               return asks;
             })
      .words("repeat_with", "flags that make the same decisions again",
             [chosen](E told) { return chosen(told).repeat_with; });
}

void write_canonical(std::ostream& out, const Export& file, const ExportedSpecimen& specimen, const CsvMarks& marks) {
  std::vector<Metadatum> all = file.metadata;
  const bool of_several = file.specimens.size() > 1;  // the stated maximum force may belong to another specimen
  if (of_several) std::erase_if(all, states_maximum_force);
  all.insert(all.end(), specimen.metadata.begin(), specimen.metadata.end());
  for (const Metadatum& datum : all) out << translated(datum, file.marks);
  if (!specimen.name.empty() && specimen_name(all) != specimen.name) out << remark({"Specimen", specimen.name, 0});
  std::vector<std::string> titles;
  titles.reserve(specimen.columns.size());
  for (const ExportColumn& column : specimen.columns)
    titles.push_back(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
  std::size_t row = 0;
  const auto next = [&](std::vector<Cell>& cells) {
    if (row == specimen.lines.size()) return false;
    cells.clear();
    for (const ExportColumn& column : specimen.columns)
      cells.push_back(column.words.empty() ? Cell(column.values[row]) : Cell(column.words[row]));
    ++row;
    return true;
  };
  write_table(out, titles, next, marks);
}

void write_canonical(const std::string& path, const Export& file, const ExportedSpecimen& specimen,
                     const CsvMarks& marks) {
  std::ostringstream text;
  write_canonical(text, file, specimen, marks);
  write_text(path, text.str());
}

}  // namespace flexslip
