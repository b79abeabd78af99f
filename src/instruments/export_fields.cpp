#include "instruments/export_fields.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "data/names.h"

namespace flexslip {
namespace {

std::optional<std::string> text_of(char mark) {
  return mark == '\0' ? std::nullopt : std::optional(std::string(1, mark));
}

// Of several with one name the first.
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
      .count("number", "of the column in the file, from 1", &ExportColumn::number)
      .words("name", "as in the file", &ExportColumn::name)
      .words("unit", "as in the file; null if there is none",
             [](C column) { return column.unit.empty() ? std::nullopt : std::optional(column.unit); })
      .words("role", "time, displacement, crosshead, deflection, force or other",
             [](C column) { return name_of(column.role); })
      .any("first", "what stands in its first row",
           [end](C column) {
             return end(column, column.values.empty() ? NAN : column.values.front(),
                        [&] { return column.words.front(); });
           })
      .any("last", "what stands in its last row", [end](C column) {
        return end(column, column.values.empty() ? NAN : column.values.back(), [&] { return column.words.back(); });
      });
}

Fields<ExportedSpecimen> specimen_fields() {
  using S = const ExportedSpecimen&;
  return Fields<ExportedSpecimen>()
      .words("name", "empty if the file names none", &ExportedSpecimen::name)
      .list("columns", "that it has", column_fields(), &ExportedSpecimen::columns)
      .count("rows", "that it has", [](S specimen) { return specimen.lines.size(); })
      .count("first_line", "of the file, that its first row stands on",
             [](S specimen) { return specimen.lines.front(); })
      .count("last_line", "of the file, that its last row stands on", [](S specimen) { return specimen.lines.back(); })
      .words_by_name("metadata", "what the file says of it alone, under the file's names",
                     [](S specimen) { return first_of_each(specimen.metadata); });
}

Fields<ExportedTest> test_fields() {
  return Fields<ExportedTest>()
      .own("span", kind::length, "between the supports", &ExportedTest::span)
      .own("diameter", kind::length, "of the specimen", &ExportedTest::diameter)
      .own("width", kind::length, "of the specimen", &ExportedTest::width)
      .own("thickness", kind::length, "of the specimen", &ExportedTest::thickness)
      .number("rate", "speed of the crosshead, in m/s", &ExportedTest::rate);
}

}  // namespace

std::string_view name_of(ColumnRole role) {
  return name_in_order<ColumnRole::other>(role, {"time", "displacement", "crosshead", "deflection", "force", "other"});
}

Fields<ToldExport> export_fields() {
  using E = const ToldExport&;
  const auto chosen = [](E told) -> const ExportedSpecimen& { return told.file.specimens.at(told.chosen); };
  const auto of = [](auto part) { return [part](E told) { return told.file.*part; }; };
  const auto mark = [](char Export::*part) { return [part](E told) { return text_of(told.file.*part); }; };
  return Fields<ToldExport>()
      .words("format", "Instron Bluehill, …, or table", of(&Export::format))
      .words("sheet", "of the workbook (.xlsx) that was read; null of a text file", of(&Export::sheet))
      .words("sheets", "of that workbook, in their order", of(&Export::sheets))
      .words("encoding", "of the text", [](E told) { return name_of(told.file.encoding); })
      .yes_no("byte_order_mark", "the file begins with one", of(&Export::byte_order_mark))
      .words("delimiter", "between columns", mark(&Export::separator))
      .words("decimal", "mark", mark(&Export::decimal))
      .words("thousands", "mark between them; null without one", mark(&Export::thousands))
      .yes_no("quoted", "cells stand in quotes", of(&Export::quoted))
      .list("columns", "of the specimen chosen", column_fields(), [chosen](E told) { return chosen(told).columns; })
      .count("rows", "of the specimen chosen", [chosen](E told) { return chosen(told).lines.size(); })
      .list("specimens", "that the file holds", specimen_fields(), of(&Export::specimens))
      .words_by_name("metadata", "what the file says of all, under its own names",
                     [](E told) { return first_of_each(told.file.metadata); })
      .group("test", "what was understood of that; null what was not stated", test_fields(), of(&Export::test))
      .words("notes", "what was decided or left out", of(&Export::notes))
      .words("asks", "what the file does not say and an evaluation needs, with the flag that says it",
             of(&Export::asks))
      .words("repeat_with", "flags that make the same decisions again", of(&Export::repeat_with));
}

}  // namespace flexslip
