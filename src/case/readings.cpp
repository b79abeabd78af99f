#include "case/readings.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "instruments/export.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

KeyChange switch_to(std::string_view key, std::string_view value) {
  return {"record", key, fmt::format("\"{}\"", value)};
}

Readings readings_from(const Case& input, const TableColumns& asked) {
  std::vector<WantedColumn> wanted;
  std::vector<Reading> columns;
  const auto want = [&](const std::optional<std::string>& title, Reading reading, const Kind& kind) {
    if (!title) return;
    wanted.push_back({*title, kind_in(input, kind)});
    columns.push_back(reading);
  };
  want(asked.stage, Reading::stage, kind::length);
  want(asked.deflection, Reading::deflection, kind::length);
  want(asked.force, Reading::force, kind::force);
  want(asked.length, Reading::length, kind::length);
  Table table = [&] {
    if (input.record->given) return *input.record->given;
    try {
      return read_table(input.record->file, wanted, asked.decimal, input.record->sheet);
    } catch (const InputError& error) {
      InputFault fault = error.fault;
      // The titles are not on the first line: a preamble may stand there.
      if (fault.line != 1 || fault.part != TablePart::title || !fault.remedy.empty()) throw;
      fault.remedy =
          "if it is the export of a testing machine, write displacement = \"crosshead\" or \"deflection\" into "
          "[record], or pass --displacement, instead of column titles; flexslip read shows what the file holds";
      throw InputError(fault);
    }
  }();
  static constexpr std::string_view names[] = {"stage", "deflection", "force"};
  std::string words;
  for (std::size_t i = 0; i < columns.size(); ++i)
    words += fmt::format("{}the {} is the column '{}'", i == 0 ? "" : ", ", names[static_cast<std::size_t>(columns[i])],
                         table.columns[i].name);
  words += ", as stated";
  for (const std::string& note : table.notes) words += "; " + note;
  PreparationStep step{"columns", false, std::move(words), {}, RowRange{1, table.rows()}, {}};
  return {input, std::move(table), std::move(columns), {{std::move(step)}}};
}

bool has_role(const ExportedSpecimen& specimen, ColumnRole role) {
  return std::any_of(specimen.columns.begin(), specimen.columns.end(),
                     [&](const ExportColumn& column) { return column.role == role; });
}

ColumnRole role_of(DisplacementOf displacement) {
  return displacement == DisplacementOf::crosshead ? ColumnRole::crosshead : ColumnRole::deflection;
}

ExportOptions options_for(const RecordInput& record, const ExportColumns& asked) {
  ExportOptions options;
  options.sheet = record.sheet;
  options.decimal = asked.decimal;
  if (asked.displacement_column)
    options.columns[asked.displacement ? role_of(*asked.displacement) : ColumnRole::displacement] =
        *asked.displacement_column;
  if (asked.force) options.columns[ColumnRole::force] = *asked.force;
  if (asked.calibration) options.units[ColumnRole::force] = *asked.calibration;
  return options;
}

const ExportedSpecimen& specimen_of(const Case& input, const ExportColumns& asked, const Export& file) {
  const std::size_t count = file.specimens.size();
  if (asked.specimen) {
    if (*asked.specimen <= count) return file.specimens[*asked.specimen - 1];
    throw wrong_value(input, "record.specimen", fmt::format("one of the {} specimens of {}", count, file.source),
                      std::to_string(*asked.specimen));
  }
  if (count == 1) return file.specimens.front();
  throw InputError({.file = file.source,
                    .expected = "one specimen, or the number of one",
                    .found = fmt::format("{} specimens", count),
                    .remedy = "write specimen = 1 into [record], or pass --specimen 1"});
}

// The one column with a role; how to name it where there is none, or several.
const ExportColumn& only_column(const Export& file, const ExportedSpecimen& specimen, ColumnRole role,
                                std::string_view key, std::string_view flag) {
  std::vector<const ExportColumn*> columns;
  std::vector<std::string> names;
  for (const ExportColumn& column : specimen.columns) {
    if (column.role != role) continue;
    columns.push_back(&column);
    names.push_back(column.name);
  }
  if (columns.size() == 1) return *columns.front();
  throw InputError({.file = file.source,
                    .field = role == ColumnRole::force ? "the force" : "the displacement",
                    .expected = "one column with it",
                    .found = names.empty() ? "none" : listed(names),
                    .remedy = fmt::format("write {} = \"…\" into [record], or pass {}: the name of the column, or its "
                                          "number in the file, from 1",
                                          key, flag)});
}

const ExportColumn& displacement_with(const Export& file, const ExportedSpecimen& specimen, ColumnRole role) {
  return only_column(file, specimen, role, "displacement_column", "--displacement-column");
}

struct FoundDisplacement {
  const ExportColumn& column;
  DisplacementOf kind;
  bool is_stated;
};

FoundDisplacement displacement_of(const ExportColumns& asked, const Export& file, const ExportedSpecimen& specimen) {
  if (asked.displacement) {
    const ColumnRole role = role_of(*asked.displacement);
    const ColumnRole found = has_role(specimen, role) ? role : ColumnRole::displacement;
    return {displacement_with(file, specimen, found), *asked.displacement, true};
  }
  // A deflectometer comes first: ISO 178 prefers it.
  for (const DisplacementOf kind : {DisplacementOf::deflection, DisplacementOf::crosshead})
    if (has_role(specimen, role_of(kind))) return {displacement_with(file, specimen, role_of(kind)), kind, false};
  const ExportColumn& column = displacement_with(file, specimen, ColumnRole::displacement);
  throw InputError(
      {.file = file.source,
       .field = fmt::format("column {}", in_quotes(column.name)),
       .expected = "a displacement known to be that of the crosshead or of the specimen's midpoint",
       .found = "a name that does not say which",
       .remedy = "write displacement = \"crosshead\" into [record], or pass --displacement crosshead: it is then "
                 "corrected for the stiffness of the load train, as a modulus requires (ISO 178); write "
                 "\"deflection\" if a deflectometer or a camera measured it"});
}

std::vector<LineRun> runs_of(const std::vector<std::size_t>& lines) {
  std::vector<LineRun> runs;
  for (std::size_t row = 0; row < lines.size(); ++row)
    if (row == 0 || lines[row] != lines[row - 1] + 1) runs.push_back({row, lines[row]});
  return runs;
}

// Adds what the file says and the case does not.
void complete(Case& input, const ExportedTest& said, Preparation& preparation) {
  const auto note = [&](std::string words, double value, KeyChange otherwise) {
    preparation.steps.push_back(
        {"metadata", false, std::move(words), PreparedValue{value, {}, kind::length}, {}, std::move(otherwise)});
  };
  if (said.span && !(input.rig && input.rig->span)) {
    {
      if (!input.rig) input.rig.emplace();
      input.rig->span = *said.span;
    }
    note("the span is the one in the file", *said.span, KeyChange{"rig", "span", "\"…\""});
  }
  if (input.specimen && input.specimen->section) return;
  std::optional<Section> section;
  if (said.diameter) {
    section = RoundSection{*said.diameter};
    note("the diameter is the one in the file", *said.diameter, KeyChange{"specimen", "diameter", "\"…\""});
  } else if (said.width && said.thickness) {
    section = RectangularSection{*said.width, *said.thickness};
    note("the width is the one in the file", *said.width, KeyChange{"specimen", "width", "\"…\""});
    note("the height is the thickness in the file", *said.thickness, KeyChange{"specimen", "height", "\"…\""});
  }
  if (!section) return;
  if (!input.specimen) input.specimen = SpecimenInput{{}, Modulus{ToFit{}}};
  input.specimen->section = section;
}

Readings readings_from(const Case& input, const ExportColumns& asked, const Export& file) {
  const ExportedSpecimen& specimen = specimen_of(input, asked, file);
  const auto [column, kind, is_stated] = displacement_of(asked, file, specimen);
  const ExportColumn& force = only_column(file, specimen, ColumnRole::force, "force", "--force");
  const bool is_crosshead = kind == DisplacementOf::crosshead;
  Readings readings{.test = input,
                    .table = {file.source,
                              {{column.name, in_si(file, specimen, column, kind::length)},
                               {force.name, in_si(file, specimen, force, kind::force)}},
                              runs_of(specimen.lines)},
                    .columns = {is_crosshead ? Reading::stage : Reading::deflection, Reading::force},
                    .preparation = {}};
  std::string words =
      fmt::format("an export, {}: the displacement is the column '{}', of the {}, as {}; the force is the column '{}'",
                  file.format, column.name, is_crosshead ? "crosshead" : "specimen's midpoint",
                  is_stated ? "stated" : "the file says", force.name);
  if (file.sheet && file.sheets.size() > 1) words += "; " + file.notes.front();  // of which sheet
  for (const std::string& note : file.row_notes) words += "; " + note;
  if (file.specimens.size() > 1)
    words += fmt::format("; the specimen is number {} of {}", *asked.specimen, file.specimens.size());
  if (asked.calibration) words += fmt::format("; the force was given in volts, {} as stated", *asked.calibration);
  readings.preparation.steps.push_back({"columns",
                                        asked.calibration.has_value(),
                                        std::move(words),
                                        {},
                                        RowRange{1, readings.table.rows()},
                                        switch_to("displacement", is_crosshead ? "deflection" : "crosshead")});
  complete(readings.test, file.test, readings.preparation);
  return readings;
}

Readings readings_from(const Case& input, const ExportColumns& asked) {
  const Export file = read_export(input.record->file, options_for(*input.record, asked));
  try {
    return readings_from(input, asked, file);
  } catch (const InputError& error) {
    if (!file.sheet || file.sheet_is_chosen) throw;
    throw with_other_sheets(error, *file.sheet, file.sheets);
  }
}
}  // namespace

Readings read_readings(const Case& input) {
  if (!input.record) throw std::invalid_argument("a case without a record has no readings");
  try {
    return std::visit([&](const auto& columns) { return readings_from(input, columns); }, input.record->columns);
  } catch (const InputError& error) {
    if (error.fault.key != "record.sheet") throw;
    throw wrong_value(input, "record.sheet", error.fault.expected, error.fault.found, error.fault.remedy);
  }
}

}  // namespace flexslip
