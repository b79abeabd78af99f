#include "case/readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/dimensions_of_file.h"
#include "case/mechanics.h"
#include "case/toml.h"
#include "instruments/export.h"
#include "io/input_error.h"
#include "io/statistics_rows.h"
#include "numerics/statistics.h"

namespace flexslip {

bool Readings::has(Reading reading) const {
  return std::find(columns.begin(), columns.end(), reading) != columns.end();
}

const std::vector<double>& Readings::of(Reading reading) const {
  const auto at = std::find(columns.begin(), columns.end(), reading) - columns.begin();
  return table.columns[static_cast<std::size_t>(at)].values;
}

std::size_t row_or(const std::optional<PlaceInRecord>& place, std::size_t rows, std::size_t none) {
  const auto* at = place ? std::get_if<AtRow>(&*place) : nullptr;
  return at && at->row >= 1 && at->row <= rows ? at->row : none;
}

namespace {

MissingInput missing_input(const Test& input, const std::vector<KeyChange>& changes, std::string question) {
  constexpr std::string_view pass = "pass ";
  std::string instruction = instruction_to_set(input, changes);
  if (instruction.starts_with(pass)) instruction.erase(0, pass.size());
  return {std::move(instruction), std::move(question)};
}

// The open questions on the rig, each with its remedy. `stiffness` is the question for the
// stiffness, or empty if it is not needed.
std::vector<MissingInput> questions_about_rig(const Test& input, const Needs& needs, std::string_view stiffness,
                                              const std::optional<double>& span_of_file) {
  std::vector<MissingInput> questions;
  if (!stiffness.empty() && !(input.rig && input.rig->stiffness))
    questions.push_back(missing_input(input, {{"rig", "stiffness", "\"… N/m\""}}, std::string(stiffness)));
  if (needs.span && !span_of_file && !(input.rig && input.rig->span))
    questions.push_back(missing_input(input, {{"rig", "span", "\"… mm\""}}, "how far are the supports apart?"));
  return questions;
}

// Asks several open questions at once. A single question is asked by the code that needs its
// answer.
void require_one_at_most(std::vector<MissingInput> questions, InputFault fault, const std::string& where = "") {
  if (questions.size() < 2) return;
  fault.problem = fmt::format("{} more inputs are needed{}:", questions.size(), where);
  fault.asks = std::move(questions);
  throw InputError(std::move(fault));
}

bool has_role(const ExportedSpecimen& specimen, ColumnRole role) {
  return std::any_of(specimen.columns.begin(), specimen.columns.end(),
                     [&](const ExportColumn& column) { return column.role == role; });
}

ColumnRole role_of(DisplacementOf displacement) {
  return displacement == DisplacementOf::crosshead ? ColumnRole::crosshead : ColumnRole::deflection;
}

ExportOptions options_of(const RecordInput& asked) {
  ExportOptions options;
  options.file.sheet = asked.sheet;
  options.decimal = asked.decimal;
  if (asked.stage) options.columns[ColumnRole::crosshead] = *asked.stage;
  if (asked.deflection) options.columns[ColumnRole::deflection] = *asked.deflection;
  if (asked.displacement_column)
    options.columns[asked.displacement ? role_of(*asked.displacement) : ColumnRole::displacement] =
        *asked.displacement_column;
  if (asked.force) options.columns[ColumnRole::force] = *asked.force;
  if (asked.calibration) options.units[ColumnRole::force] = *asked.calibration;
  return options;
}

// The displacement of a crosshead that moves at a stated speed, as a further column of each specimen.
// Fails:      InputError for a file that has a displacement, or no time.
Export with_travel(Export file, const Test& input) {
  const double speed = *input.record->speed;
  const auto fault = [&](std::string problem, std::string remedy = "") {
    return wrong_value(input, "record.speed", std::move(problem), std::move(remedy));
  };
  for (ExportedSpecimen& specimen : file.specimens) {
    const ExportColumn* time = nullptr;
    for (const ExportColumn& column : specimen.columns) {
      if (is_displacement(column.role))
        throw fault(
            fmt::format("{} has a displacement, {}, so no speed is needed", file.origin.source, in_quotes(column.name)),
            "leave the speed out");
      if (column.role == ColumnRole::time) time = &column;
    }
    if (time == nullptr) throw fault(fmt::format("{} has no column of time", file.origin.source));
    std::vector<double> travel = in_si(file, *time, kind::time);
    for (double& each : travel) each *= speed;
    specimen.columns.push_back({"speed × " + time->name, "m", ColumnRole::crosshead, std::move(travel), time->number});
  }
  return file;
}

const ExportedSpecimen& specimen_of(const Test& input, const Export& file) {
  const std::size_t count = file.specimens.size();
  if (const auto asked = input.record->specimen) {
    if (*asked <= count) return file.specimens[static_cast<std::size_t>(*asked - 1)];
    throw wrong_value(input, "record.specimen",
                      fmt::format("Specimen {} is asked for, but {} holds {}", *asked, file.origin.source, count));
  }
  if (count == 1) return file.specimens.front();
  throw InputError({.file = file.origin.source,
                    .problem = fmt::format("The file holds {} specimens", count),
                    .remedy = instruction_to_set(input, KeyChange{"record", "specimen", "1"})});
}

// The column with a role. The remedy names `key`.
const ExportColumn& column_for(std::string_view key, const Test& input, const Export& file,
                               const ExportedSpecimen& specimen, ColumnRole role) {
  return column_with(
      file, specimen, role,
      instruction_to_set(input, switch_to(key, "…")) + ": the name of the column, or its number in the file, from 1");
}

// The columns of a specimen without values, with the roles for a case. Only the evaluated
// displacement keeps its role.
std::vector<ExportColumn> asked_columns(const RecordInput& asked, const ExportedSpecimen& specimen) {
  std::vector<ExportColumn> columns;
  std::array<std::size_t, 3> count{};  // of those unclear, of the crosshead, of the midpoint
  constexpr std::array roles{ColumnRole::displacement, ColumnRole::crosshead, ColumnRole::deflection};
  for (const ExportColumn& each : specimen.columns) {
    columns.push_back({each.name, each.unit, each.role, {}, each.number});
    if (!each.words.empty()) columns.back().words = {each.words.front()};
    for (std::size_t i = 0; i < roles.size(); ++i) count[i] += each.role == roles[i] ? 1 : 0;
  }
  const ColumnRole wanted = asked.displacement ? role_of(*asked.displacement)
                            : count[2] > 0     ? ColumnRole::deflection
                                               : ColumnRole::crosshead;
  const bool has_wanted = count[wanted == ColumnRole::crosshead ? 1 : 2] > 0;
  for (ExportColumn& column : columns) {
    if (asked.displacement && !has_wanted && count[0] == 1 && column.role == ColumnRole::displacement)
      column.role = wanted;
    else if (is_displacement(column.role) && has_wanted && column.role != wanted)
      column.role = ColumnRole::other;
  }
  return columns;
}

struct FoundDisplacement {
  const ExportColumn& column;
  DisplacementOf kind;
  bool is_stated;
};

FoundDisplacement displacement_of(const Test& input, const Export& file, const ExportedSpecimen& specimen) {
  const RecordInput& asked = *input.record;
  const auto displacement_with = [&](ColumnRole role) -> const ExportColumn& {
    return column_for("displacement_column", input, file, specimen, role);
  };
  if (asked.displacement) {
    const ColumnRole role = role_of(*asked.displacement);
    const ColumnRole found = has_role(specimen, role) ? role : ColumnRole::displacement;
    const ColumnRole other = role == ColumnRole::crosshead ? ColumnRole::deflection : ColumnRole::crosshead;
    if (!has_role(specimen, found) && has_role(specimen, other)) {
      const ExportColumn& column = displacement_with(other);
      throw InputError({.file = file.origin.source,
                        .field = fmt::format("column {}", in_quotes(column.name)),
                        .problem = fmt::format("The column is titled as {}, but it is stated as {}",
                                               words_for(other).word(), words_for(role).word()),
                        .remedy = instruction_to_set(input, switch_to("displacement", words_for(other).word())) +
                                  "; or " + instruction_to_set(input, switch_to("displacement_column", column.name)) +
                                  " too, if its name is wrong"});
    }
    return {displacement_with(found), *asked.displacement, true};
  }
  for (const OpenQuestion& each : questions_of(asked_columns(asked, specimen)))
    if (!each.with_test.empty() && each.with_test.front().name == "speed")
      throw InputError(
          {.file = file.origin.source,
           .problem = "The file has times, and no displacement",
           .remedy = instruction_to_set(input, KeyChange{"record", "speed", each.with_test.front().value})});
  // A deflectometer is preferred (ISO 178).
  for (const DisplacementOf kind : {DisplacementOf::deflection, DisplacementOf::crosshead})
    if (has_role(specimen, role_of(kind))) return {displacement_with(role_of(kind)), kind, false};
  const ExportColumn& column = displacement_with(ColumnRole::displacement);
  throw InputError(
      {.file = file.origin.source,
       .field = fmt::format("column {}", in_quotes(column.name)),
       .problem = "The title does not say whether the displacement was measured at the crosshead or at the specimen's "
                  "midpoint",
       .remedy = instruction_to_set(input, switch_to("displacement", "crosshead")) +
                 ": it is then corrected for the stiffness of the load train, as a modulus requires (ISO 178); "
                 "\"deflection\" if a deflectometer or a camera measured it"});
}

void require_answers(const Test& input, const Needs& needs, const Export& file) {
  const RecordInput& asked = *input.record;
  const std::size_t count = file.specimens.size();
  const std::size_t chosen = asked.specimen && *asked.specimen <= count ? static_cast<std::size_t>(*asked.specimen) : 1;
  std::vector<MissingInput> questions;
  const std::vector<std::string>& sheets = file.origin.alike;
  if (!sheets.empty())
    questions.push_back(
        missing_input(input, {{"record", "sheet", toml_text(sheets.front())}},
                      fmt::format("which of the sheets {}, each with a table of readings?", listed(sheets))));
  if (count > 1 && !asked.specimen)
    questions.push_back(
        missing_input(input, {{"record", "specimen", "1"}}, fmt::format("which of the {} specimens?", count)));
  const std::vector<ExportColumn> columns = asked_columns(asked, file.specimens[chosen - 1]);
  for (const OpenQuestion& each : questions_of(columns)) {
    if (each.with_test.empty()) continue;
    std::vector<KeyChange> changes;
    for (const RecordKey& key : each.with_test) changes.push_back({"record", key.name, key.value});
    questions.push_back(missing_input(input, changes, each.words));
  }
  const auto has = [&](ColumnRole role) {
    return std::any_of(columns.begin(), columns.end(), [=](const ExportColumn& each) { return each.role == role; });
  };
  const std::string_view stiffness =
      file.specimens[chosen - 1].load_train || (has(ColumnRole::deflection) && !needs.load_train) ? ""
      : needs.load_train || has(ColumnRole::crosshead)
          ? "how stiff is the load train?"
          : "how stiff is the load train, if the displacement is the crosshead's?";
  for (MissingInput& each : questions_about_rig(input, needs, stiffness, file.test.span))
    questions.push_back(std::move(each));
  require_one_at_most(questions, {.file = file.origin.source, .remedy = file.unplaced},
                      file.origin.sheet ? fmt::format(" on the sheet {}", in_quotes(*file.origin.sheet)) : "");
}

// Fails:      InputError if times show that rows run backwards or are out of order, or that a
//             second record starts with the displacement.
void require_one_run(const Test& input, const ExportedSpecimen& specimen, const ExportColumn& displacement,
                     const std::string& file) {
  const auto is_time = [](const ExportColumn& column) { return column.role == ColumnRole::time; };
  const auto time = std::find_if(specimen.columns.begin(), specimen.columns.end(), is_time);
  if (time == specimen.columns.end()) return;
  const std::size_t rows = time->values.size(), first = row_or(input.record->first, rows, 1) - 1;
  const std::size_t last = std::max(row_or(input.record->until, rows, rows), first);
  constexpr std::size_t fewest = 30;
  if (last - first < fewest) return;
  const auto times = std::span(time->values).subspan(first, last - first);
  const auto places = std::span(displacement.values).subspan(first, last - first);
  std::size_t falling = 0;
  for (std::size_t i = 1; i < times.size(); ++i) falling += times[i] < times[i - 1] ? 1 : 0;
  constexpr double nearly_all = 0.9;
  if (static_cast<double>(falling) > nearly_all * static_cast<double>(times.size() - 1))
    throw InputError({.file = file,
                      .line = specimen.lines[first],
                      .field = fmt::format("the column '{}'", time->name),
                      .problem = "Time falls from row to row",
                      .remedy = "write the rows in the reverse order"});
  if (falling == 0) return;
  // A clock that restarts, in a new stage of the test or at midnight, falls to its first time or
  // below.
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(std::abs(times[i] - times[i - 1]));
  const double step = median_of(std::move(steps));
  double earliest = times[0];
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] < times[i - 1] - 0.5 * step && times[i] > earliest + 1.5 * step)
      throw InputError({.file = file,
                        .line = specimen.lines[first + i],
                        .field = fmt::format("the column '{}'", time->name),
                        .problem = fmt::format("Time decreases at row {}", first + i + 1),
                        .remedy = "write the rows in the order of their times, each once"});
    earliest = std::min(earliest, times[i]);
  }
  const auto [least, most] = std::minmax_element(places.begin(), places.end());
  constexpr double far = 0.5;
  for (std::size_t i = fewest; i + fewest <= times.size(); ++i) {
    const bool begins_anew = times[i] < times[i - 1] && times[i] - times[0] < 1e-3 * (times[i - 1] - times[0]) &&
                             std::abs(places[i] - places[i - 1]) > far * (*most - *least);
    if (!begins_anew) continue;
    const std::string row = fmt::format("{}", first + i), next = fmt::format("{}", first + i + 1);
    throw InputError(
        {.file = file,
         .line = specimen.lines[first + i],
         .problem = fmt::format("A second record starts at row {}, where time and displacement begin anew", next),
         .remedy = fmt::format("take the first ({}) or the second ({})",
                               instruction_to_set(input, KeyChange{"record", "until", row}),
                               instruction_to_set(input, KeyChange{"record", "first", next}))});
  }
}

// A column in SI. The remedy for a missing unit is a title with its unit.
std::vector<double> in_si_of(const Test& input, const Export& file, const ExportColumn& column, const Kind& kind,
                             std::string_view key) {
  return in_si(file, column, kind, words_for(column.role).usual_unit, [&](std::string_view unit) {
    return "name the column with its unit: " +
           instruction_to_set(input, switch_to(key, fmt::format("{} [{}]", column.name, unit)));
  });
}

struct FoundColumn {
  Reading reading;
  const ExportColumn* column;
  std::string_view key;  // names the column
};

// Columns of a specimen in SI, without rows that lack a number in one of them.
Readings readings_of(const Test& input, const Export& file, const ExportedSpecimen& specimen,
                     const std::vector<FoundColumn>& found) {
  const auto* until = input.record->until ? std::get_if<AtRow>(&*input.record->until) : nullptr;
  std::vector<const ExportColumn*> columns;
  for (const FoundColumn& each : found) columns.push_back(each.column);
  const RowsLeftOut missing = rows_without_numbers(file, specimen, columns, until ? until->row : specimen.lines.size());
  Readings readings{.test = input,
                    .table = {.source = file.origin.source,
                              .columns = {},
                              .lines = without_rows(specimen.lines, missing.rows),
                              .missing_rows = missing.rows},
                    .columns = {}};
  for (const auto& [reading, column, key] : found) {
    const bool is_stress = reading == Reading::force && holds_stress(*column);
    const Kind kind =
        is_stress ? kind::pressure : kind_in(input, reading == Reading::force ? kind::force : kind::length);
    std::vector<double> values = in_si_of(input, file, *column, kind, key);
    readings.columns.push_back(reading);
    readings.table.columns.push_back({column->name, without_rows(std::move(values), missing.rows)});
  }
  readings.found_by = {{.name = "columns", .rows = RowRange{1, readings.table.rows_of_file()}}};
  if (!missing.words.empty()) readings.found_by.push_back({.name = "missing", .changed = true, .done = missing.words});
  return readings;
}

std::string notes_of(const Export& file) {
  std::string notes;
  if (!file.origin.which_sheet.empty()) notes += "; " + file.origin.which_sheet;
  for (const std::string& note : file.row_notes) notes += "; " + note;
  return notes;
}

// The description of columns, of a call or of a file.
std::string named_in_words(const std::vector<Reading>& columns, const Table& table) {
  static constexpr std::string_view names[] = {"stage", "deflection", "force", "length pulled in"};
  std::string words;
  for (std::size_t i = 0; i < columns.size(); ++i)
    words += fmt::format("{}the {} is the column '{}'", i == 0 ? "" : ", ", names[static_cast<std::size_t>(columns[i])],
                         table.columns[i].name);
  return words + ", as stated";
}

// The error of a column that a case names, with its title instead of the flag of its role.
InputError by_title(const InputError& error, const ExportOptions& options) {
  InputFault fault = error.fault;
  for (const auto& [role, title] : options.columns)
    if (fault.field == words_for(role).flag) fault.field = "column " + in_quotes(title);
  return InputError(fault);
}

void require_one_sheet(const Test& input, const Export& file) {
  const std::vector<std::string>& alike = file.origin.alike;
  if (alike.empty()) return;
  throw wrong_value(input, "record.sheet",
                    fmt::format("Each of the sheets {} holds a table of readings", listed(alike)),
                    instruction_to_set(input, KeyChange{"record", "sheet", toml_text(alike.front())}));
}

// Turns a force that the file gives as a stress into a force.
void convert_stress(Readings& readings, const Export& file, const ExportColumn& force) {
  if (!holds_stress(force)) return;
  const auto at =
      std::find(readings.columns.begin(), readings.columns.end(), Reading::force) - readings.columns.begin();
  std::vector<double>& values = readings.table.columns[static_cast<std::size_t>(at)].values;
  values = forces_of_stresses(readings.test, file, force, std::move(values));
  PreparationStep& columns = readings.found_by.front();
  columns.changed = true;
  columns.done += "; it holds a stress, from which the force is calculated by span and section";
}

// The columns that a case names by title.
Readings readings_of_named(const Test& input, const Export& file) {
  const RecordInput& asked = *input.record;
  require_one_sheet(input, file);
  const ExportedSpecimen& specimen = specimen_of(input, file);
  std::vector<FoundColumn> found;
  const auto with = [&](ColumnRole role) { return &column_with(file, specimen, role); };
  if (asked.stage) found.push_back({Reading::stage, with(ColumnRole::crosshead), "stage"});
  if (asked.deflection) found.push_back({Reading::deflection, with(ColumnRole::deflection), "deflection"});
  if (asked.force) found.push_back({Reading::force, with(ColumnRole::force), "force"});
  if (asked.length)
    found.push_back(
        {Reading::length, &specimen.columns[column_named(file, specimen, *asked.length, "length")], "length"});
  Readings readings = readings_of(input, file, specimen, found);
  readings.found_by.front().done = named_in_words(readings.columns, readings.table) + notes_of(file);
  if (asked.force) convert_stress(readings, file, *with(ColumnRole::force));
  return readings;
}

// The columns of an export, from its own description.
Readings readings_of_export(const Test& input, const Needs& needs, const Export& file) {
  const RecordInput& asked = *input.record;
  require_answers(input, needs, file);
  require_one_sheet(input, file);
  const ExportedSpecimen& specimen = specimen_of(input, file);
  const auto [column, kind, is_stated] = displacement_of(input, file, specimen);
  const ExportColumn& force = column_for("force", input, file, specimen, ColumnRole::force);
  require_one_run(input, specimen, column, file.origin.source);
  const bool is_crosshead = kind == DisplacementOf::crosshead;
  Readings readings =
      readings_of(input, file, specimen,
                  {{is_crosshead ? Reading::stage : Reading::deflection, &column, "displacement_column"},
                   {Reading::force, &force, "force"}});
  std::string words =
      fmt::format("an export, {}: the displacement is the column '{}', of the {}, as {}; the force is the column '{}'",
                  file.format, column.name, is_crosshead ? "crosshead" : "specimen's midpoint",
                  is_stated ? "stated" : "the file says", force.name);
  words += notes_of(file);
  if (file.specimens.size() > 1)
    words += fmt::format("; the specimen is number {} of {}", *asked.specimen, file.specimens.size());
  if (asked.calibration) words += fmt::format("; the force was given in volts, {} as stated", *asked.calibration);
  PreparationStep& columns = readings.found_by.front();
  columns.changed = asked.calibration.has_value();
  columns.done = std::move(words);
  columns.otherwise = switch_to("displacement", is_crosshead ? "deflection" : "crosshead");
  complete_from_file(readings.test, file.test, specimen.load_train, readings.found_by);
  convert_stress(readings, file, force);
  readings.contradictions = contradictions(input, readings.test, file, specimen, force, column);
  return readings;
}

// The columns of a call in memory.
Readings readings_given(const Test& input) {
  const RecordInput& asked = *input.record;
  Readings readings{.test = input, .table = *asked.given, .columns = {}};
  if (asked.stage) readings.columns.push_back(Reading::stage);
  if (asked.deflection) readings.columns.push_back(Reading::deflection);
  if (asked.force) readings.columns.push_back(Reading::force);
  if (asked.length) readings.columns.push_back(Reading::length);
  readings.found_by = {{.name = "columns",
                        .done = named_in_words(readings.columns, readings.table),
                        .rows = RowRange{1, readings.table.rows_of_file()}}};
  if (const auto& left_out = readings.table.missing_rows; !left_out.empty())
    readings.found_by.push_back(
        {.name = "missing",
         .changed = true,
         .done = left_out.size() == 1 ? fmt::format("row {}, which has no number, is left out", left_out.front() + 1)
                                      : fmt::format("{} rows without a number are left out, the first is row {}",
                                                    left_out.size(), left_out.front() + 1)});
  return readings;
}

}  // namespace

Readings read_readings(const Test& input, const Needs& needs) {
  const RecordInput& asked = *input.record;
  if (!asked.is_export()) {
    const bool is_stage = asked.stage && !asked.deflection;
    require_one_at_most(questions_about_rig(input, needs, is_stage ? "how stiff is the load train?" : "", {}),
                        {.file = asked.given ? "the record" : asked.file});
  }
  if (asked.given) return readings_given(input);
  const ExportOptions options = options_of(asked);
  try {
    Export file = read_export(asked.file, options);
    if (asked.speed) file = with_travel(std::move(file), input);
    try {
      return asked.is_export() ? readings_of_export(input, needs, file) : readings_of_named(input, file);
    } catch (const InputError& error) {
      throw with_other_sheets(error, file.origin);
    }
  } catch (const InputError& error) {
    if (error.fault.key == "record.sheet")
      throw wrong_value(input, "record.sheet", error.fault.problem, error.fault.remedy);
    throw asked.is_export() ? error : by_title(error, options);
  }
}

}  // namespace flexslip
