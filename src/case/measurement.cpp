#include "case/measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/mechanics.h"
#include "case/rows_that_count.h"
#include "case/toml.h"
#include "data/contact.h"
#include "data/drops.h"
#include "data/failure.h"
#include "data/no_readings.h"
#include "data/record.h"
#include "inference/first_passages.h"
#include "instruments/export.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "io/statistics_rows.h"
#include "io/table.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {

namespace {

enum class Reading { stage, deflection, force, length };

// The columns of a record, each still as its machine counts.
struct Readings {
  Test test;                     // completed with what the file says of span and section
  Table table;                   // two columns [m], [N], and perhaps a length [m]
  std::vector<Reading> columns;  // what each of them is
  Preparation preparation;       // how they were found

  bool has(Reading reading) const { return std::find(columns.begin(), columns.end(), reading) != columns.end(); }
  const std::vector<double>& of(Reading reading) const {
    const auto at = std::find(columns.begin(), columns.end(), reading) - columns.begin();
    return table.columns[static_cast<std::size_t>(at)].values;
  }
  // Of the displacement, the one that comes first.
  const std::vector<double>& displacement() const { return table.columns.front().values; }
};

// In any unit, the force or what is proportional to it.
std::vector<double> force_or_difference(const Readings& readings) {
  if (readings.has(Reading::force)) return readings.of(Reading::force);
  std::vector<double> difference = readings.of(Reading::stage);
  const std::vector<double>& deflection = readings.of(Reading::deflection);
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= deflection[i];
  return difference;
}

Record record_of(const Readings& readings, double stiffness) {
  const auto of = [&](Reading reading) { return readings.of(reading); };
  if (!readings.has(Reading::force))
    return record_from_stage_and_deflection(of(Reading::stage), of(Reading::deflection), stiffness);
  return readings.has(Reading::stage)
             ? record_from_stage_and_force(of(Reading::stage), of(Reading::force), stiffness)
             : record_from_deflection_and_force(of(Reading::deflection), of(Reading::force), stiffness);
}

PreparedValue value_in(const Test& test, double value, std::optional<double> error, const Kind& kind) {
  return {value, error, kind_in(test, kind)};
}

KeyChange switch_to(std::string_view key, std::string_view value) {
  return {"record", key, fmt::format("\"{}\"", value)};
}

std::string to_say(const Test& test, KeyChange change) {
  return to_say(test, std::vector<KeyChange>{std::move(change)});
}

// What the file and the test leave open, each with its remedy. Of a rig, `stiffness` is the question that its stiffness answers; none if it is not asked.
std::vector<std::string> questions_about_rig(const Test& input, const Needs& needs, std::string_view stiffness,
                                             const std::optional<double>& span_of_file) {
  std::vector<std::string> questions;
  if (!stiffness.empty() && !(input.rig && input.rig->stiffness))
    questions.push_back(fmt::format("{} {}", stiffness, to_say(input, KeyChange{"rig", "stiffness", "\"… N/m\""})));
  if (needs.span && !span_of_file && !(input.rig && input.rig->span))
    questions.push_back("how far are the supports apart? " + to_say(input, KeyChange{"rig", "span", "\"… mm\""}));
  return questions;
}

// Where more than one question is open, all of them are asked at once; one alone is asked by what needs its answer.
void require_one_at_most(const std::vector<std::string>& questions, InputFault fault, const std::string& where = "") {
  if (questions.size() < 2) return;
  fault.problem = fmt::format("leaves {} questions open{}", questions.size(), where);
  for (std::size_t i = 0; i < questions.size(); ++i)
    fault.problem += fmt::format("{} ({}) {}", i == 0 ? ":" : "", i + 1, questions[i]);
  throw InputError(std::move(fault));
}

Readings readings_of_table(const Test& input, const Needs& needs) {
  const RecordInput& asked = *input.record;
  const bool is_stage = asked.stage && !asked.deflection;
  require_one_at_most(questions_about_rig(input, needs, is_stage ? "how stiff is the load train?" : "", {}),
                      {.file = asked.given ? "the record" : asked.file});
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
    if (asked.given) return *asked.given;
    try {
      return read_record(asked.file, wanted, asked.decimal.value_or('.'), asked.sheet);
    } catch (const InputError& error) {
      InputFault fault = error.fault;
      // The titles are not on the first line: a preamble may stand there.
      if (fault.line != 1 || fault.part != TablePart::title || !fault.remedy.empty()) throw;
      fault.remedy = fmt::format(
          "if it is the export of a testing machine, {} (or \"deflection\") instead of column titles; flexslip read "
          "shows what the file holds",
          to_say(input, switch_to("displacement", "crosshead")));
      throw InputError(fault);
    }
  }();
  static constexpr std::string_view names[] = {"stage", "deflection", "force", "length pulled in"};
  std::string words;
  for (std::size_t i = 0; i < columns.size(); ++i)
    words += fmt::format("{}the {} is the column '{}'", i == 0 ? "" : ", ", names[static_cast<std::size_t>(columns[i])],
                         table.columns[i].name);
  words += ", as stated";
  for (const std::string& note : table.notes) words += "; " + note;
  Preparation steps;
  steps.add("columns", false, std::move(words), {}, {}, RowRange{1, table.rows_of_file()});
  if (!table.left_out.empty()) steps.add("missing", true, table.left_out, {});
  return {input, std::move(table), std::move(columns), std::move(steps)};
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
  if (asked.displacement_column)
    options.columns[asked.displacement ? role_of(*asked.displacement) : ColumnRole::displacement] =
        *asked.displacement_column;
  if (asked.force) options.columns[ColumnRole::force] = *asked.force;
  if (asked.calibration) options.units[ColumnRole::force] = *asked.calibration;
  return options;
}

const ExportedSpecimen& specimen_of(const Test& input, const Export& file) {
  const std::size_t count = file.specimens.size();
  if (const auto asked = input.record->specimen) {
    if (*asked <= count) return file.specimens[static_cast<std::size_t>(*asked - 1)];
    throw wrong_value(input, "record.specimen", fmt::format("one of the {} specimens of {}", count, file.origin.source),
                      std::to_string(*asked));
  }
  if (count == 1) return file.specimens.front();
  throw InputError({.file = file.origin.source,
                    .expected = "one specimen, or the number of one",
                    .found = fmt::format("{} specimens", count),
                    .remedy = to_say(input, KeyChange{"record", "specimen", "1"})});
}

// The column with a role; the key that names it is what a file that has none, or several, is asked for.
const ExportColumn& column_for(std::string_view key, const Test& input, const Export& file,
                               const ExportedSpecimen& specimen, ColumnRole role) {
  return column_with(
      file, specimen, role,
      to_say(input, switch_to(key, "…")) + ": the name of the column, or its number in the file, from 1");
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
                        .expected = fmt::format("a displacement of the {}, as stated", words_for(role).word()),
                        .found = fmt::format("one whose name says {}", words_for(other).word()),
                        .remedy = to_say(input, switch_to("displacement", words_for(other).word())) + "; or " +
                                  to_say(input, switch_to("displacement_column", column.name)) +
                                  " besides, if its name is wrong"});
    }
    return {displacement_with(found), *asked.displacement, true};
  }
  // A deflectometer comes first: ISO 178 prefers it.
  for (const DisplacementOf kind : {DisplacementOf::deflection, DisplacementOf::crosshead})
    if (has_role(specimen, role_of(kind))) return {displacement_with(role_of(kind)), kind, false};
  const ExportColumn& column = displacement_with(ColumnRole::displacement);
  throw InputError(
      {.file = file.origin.source,
       .field = fmt::format("column {}", in_quotes(column.name)),
       .expected = "a displacement known to be that of the crosshead or of the specimen's midpoint",
       .found = "a name that does not say which",
       .remedy = to_say(input, switch_to("displacement", "crosshead")) +
                 ": it is then corrected for the stiffness of the load train, as a modulus requires (ISO 178); "
                 "\"deflection\" if a deflectometer or a camera measured it"});
}

// Adds what the file says and the case does not. No section where a file states a diameter beside width or thickness, as forms of a machine do
// that list them all.
void complete(Test& input, const ExportedTest& said, Preparation& preparation) {
  const auto note = [&](std::string words, double value, KeyChange otherwise) {
    preparation.add("metadata", false, std::move(words), std::move(otherwise), PreparedValue{value, {}, kind::length});
  };
  if (said.span && !(input.rig && input.rig->span)) {
    if (!input.rig) input.rig.emplace();
    input.rig->span = *said.span;
    note("the span is the one in the file", *said.span, KeyChange{"rig", "span", "\"…\""});
  }
  if (section_of(input)) return;
  SpecimenInput specimen = input.specimen.value_or(SpecimenInput{});
  if (said.diameter && (said.width || said.thickness)) {
    note(fmt::format("no section is taken from the file, which states a diameter beside a {}",
                     said.width && said.thickness ? "width and a thickness"
                     : said.width                 ? "width"
                                                  : "thickness"),
         *said.diameter, KeyChange{"specimen", "diameter", "\"…\""});
    return;
  }
  if (said.diameter) {
    specimen.diameter = *said.diameter;
    note("the diameter is the one in the file", *said.diameter, KeyChange{"specimen", "diameter", "\"…\""});
  } else if (said.width && said.thickness) {
    specimen.width = *said.width;
    specimen.height = *said.thickness;
    note("the width is the one in the file", *said.width, KeyChange{"specimen", "width", "\"…\""});
    note("the height is the thickness in the file", *said.thickness, KeyChange{"specimen", "height", "\"…\""});
  } else {
    return;
  }
  input.specimen = specimen;
}

// The columns of a specimen, without their values, with the roles that they have for a case: of displacements only that which is evaluated.
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

void require_answers(const Test& input, const Needs& needs, const Export& file) {
  const RecordInput& asked = *input.record;
  const std::size_t count = file.specimens.size();
  const std::size_t chosen = asked.specimen && *asked.specimen <= count ? static_cast<std::size_t>(*asked.specimen) : 1;
  std::vector<std::string> questions;
  const std::vector<std::string>& sheets = file.origin.alike;
  if (!sheets.empty())
    questions.push_back(fmt::format("which of the sheets {}, which hold such a table each? {}", listed(sheets),
                                    to_say(input, KeyChange{"record", "sheet", toml_text(sheets.front())})));
  if (count > 1 && !asked.specimen)
    questions.push_back(
        fmt::format("which of the {} specimens? {}", count, to_say(input, KeyChange{"record", "specimen", "1"})));
  const std::vector<ExportColumn> columns = asked_columns(asked, file.specimens[chosen - 1]);
  for (const OpenQuestion& each : questions_of(columns)) {
    if (each.with_test.empty()) continue;
    std::vector<KeyChange> changes;
    for (const RecordKey& key : each.with_test) changes.push_back({"record", key.name, key.value});
    questions.push_back(each.words + " " + to_say(input, changes));
  }
  const auto has = [&](ColumnRole role) {
    return std::any_of(columns.begin(), columns.end(), [=](const ExportColumn& each) { return each.role == role; });
  };
  const std::string_view stiffness = has(ColumnRole::deflection) ? ""
                                     : has(ColumnRole::crosshead)
                                         ? "how stiff is the load train?"
                                         : "how stiff is the load train, if the displacement is the crosshead's?";
  for (std::string& each : questions_about_rig(input, needs, stiffness, file.test.span))
    questions.push_back(std::move(each));
  require_one_at_most(questions, {.file = file.origin.source, .remedy = file.unplaced},
                      file.origin.sheet ? fmt::format(" on the sheet {}", in_quotes(*file.origin.sheet)) : "");
}

// The row that a place is, if it is one of the record's; else `none`.
std::size_t row_or(const std::optional<PlaceInRecord>& place, std::size_t rows, std::size_t none) {
  const auto* at = place ? std::get_if<AtRow>(&*place) : nullptr;
  return at && at->row >= 1 && at->row <= rows ? at->row : none;
}

// Fails:      InputError where the times of a file say that its rows run backwards or are out of order, or that a second record begins where
//             displacement and time do anew.
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
                      .expected = "times that rise from row to row",
                      .found = "times that fall",
                      .remedy = "write the rows in the reverse order"});
  if (falling == 0) return;
  // A clock that begins anew, at a stage of the test or at midnight, falls to where it began or farther.
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(std::abs(times[i] - times[i - 1]));
  const double step = median_of(std::move(steps));
  double earliest = times[0];
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] < times[i - 1] - 0.5 * step && times[i] > earliest + 1.5 * step)
      throw InputError({.file = file,
                        .line = specimen.lines[first + i],
                        .field = fmt::format("the column '{}'", time->name),
                        .expected = "times that rise from row to row",
                        .found = "one that falls",
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
    throw InputError({.file = file,
                      .line = specimen.lines[first + i],
                      .expected = "one record",
                      .found = fmt::format("a second one from row {} on, where time and displacement begin anew", next),
                      .remedy = fmt::format("take the first ({}) or the second ({})",
                                            to_say(input, KeyChange{"record", "until", row}),
                                            to_say(input, KeyChange{"record", "first", next}))});
  }
}

// A column in SI, whose unit a case says in its title.
std::vector<double> in_si_of(const Test& input, const Export& file, const ExportColumn& column, const Kind& kind,
                             std::string_view key) {
  return in_si(file, column, kind, words_for(column.role).usual_unit, [&](std::string_view unit) {
    return "name the column with its unit: " + to_say(input, switch_to(key, fmt::format("{} [{}]", column.name, unit)));
  });
}

Readings readings_from(const Test& input, const Needs& needs, const Export& file) {
  const RecordInput& asked = *input.record;
  require_answers(input, needs, file);
  if (!file.origin.alike.empty())
    throw wrong_value(input, "record.sheet",
                      fmt::format("one of the sheets {}, which hold such a table each", listed(file.origin.alike)),
                      "none", to_say(input, KeyChange{"record", "sheet", toml_text(file.origin.alike.front())}));
  const ExportedSpecimen& specimen = specimen_of(input, file);
  const auto [column, kind, is_stated] = displacement_of(input, file, specimen);
  const ExportColumn& force = column_for("force", input, file, specimen, ColumnRole::force);
  require_one_run(input, specimen, column, file.origin.source);
  const bool is_crosshead = kind == DisplacementOf::crosshead;
  const auto* until = asked.until ? std::get_if<AtRow>(&*asked.until) : nullptr;
  std::vector<double> displacements = in_si_of(input, file, column, kind::length, "displacement_column");
  std::vector<double> forces = in_si_of(input, file, force, kind::force, "force");
  const RowsLeftOut missing =
      rows_without_numbers(file, specimen, {&column, &force}, until ? until->row : specimen.lines.size());
  Readings readings{.test = input,
                    .table = {file.origin.source,
                              {{column.name, without_rows(std::move(displacements), missing.rows)},
                               {force.name, without_rows(std::move(forces), missing.rows)}},
                              without_rows(specimen.lines, missing.rows),
                              {},
                              missing.rows},
                    .columns = {is_crosshead ? Reading::stage : Reading::deflection, Reading::force},
                    .preparation = {}};
  std::string words =
      fmt::format("an export, {}: the displacement is the column '{}', of the {}, as {}; the force is the column '{}'",
                  file.format, column.name, is_crosshead ? "crosshead" : "specimen's midpoint",
                  is_stated ? "stated" : "the file says", force.name);
  if (!file.origin.which_sheet.empty()) words += "; " + file.origin.which_sheet;
  for (const std::string& note : file.row_notes) words += "; " + note;
  if (file.specimens.size() > 1)
    words += fmt::format("; the specimen is number {} of {}", *asked.specimen, file.specimens.size());
  if (asked.calibration) words += fmt::format("; the force was given in volts, {} as stated", *asked.calibration);
  readings.preparation.add("columns", asked.calibration.has_value(), std::move(words),
                           switch_to("displacement", is_crosshead ? "deflection" : "crosshead"), {},
                           RowRange{1, readings.table.rows_of_file()});
  if (!missing.words.empty()) readings.preparation.add("missing", true, missing.words, {});
  complete(readings.test, file.test, readings.preparation);
  return readings;
}

Readings readings_of_export(const Test& input, const Needs& needs) {
  const Export file = read_export(input.record->file, options_of(*input.record));
  try {
    return readings_from(input, needs, file);
  } catch (const InputError& error) {
    throw with_other_sheets(error, file.origin);
  }
}

// The columns of a record as its file has them, in SI: from a table whose columns are named, or from the export of a testing machine, whose columns
// say themselves what they are.
// Fails:      InputError, besides what read_table and read_export throw: a displacement of which neither case nor file says what it
//             is one of, several specimens of which none is chosen, one that is not there.
Readings read_readings(const Test& input, const Needs& needs) {
  try {
    return input.record->is_export() ? readings_of_export(input, needs) : readings_of_table(input, needs);
  } catch (const InputError& error) {
    if (error.fault.key != "record.sheet") throw;
    throw wrong_value(input, "record.sheet", error.fault.expected, error.fault.found, error.fault.remedy);
  }
}

// Rows whose force is within four times the noise of zero say that there is no contact yet, if they are this many more than a
// specimen in contact from the first row on would show.
constexpr double min_free_rows = 5;
// A stage that runs back by less, the larger of both, is one whose encoder is noisy; farther, the record is another test, or out of order.
constexpr double max_stage_noise = 0.005;  // [travel]
constexpr double stage_noise_range = 5;    // [noise of the stage] between the extremes of some hundred readings

void require_finite(const Record& record, const Table& table) {
  const RecordCheck check = check_record(record);
  if (check.fault != RecordFault::not_finite) return;
  throw InputError({.file = table.source,
                    .line = table.lines[check.index],
                    .expected = "readings of a bending test",
                    .found = "numbers that are too large",
                    .remedy = "check the units"});
}

double stiffness_for(const Test& input, const Readings& readings) {
  if (input.rig && input.rig->stiffness) return rig_stiffness_of(input);
  // A deflection with its force needs no stiffness: what the stage did is not asked then.
  if (!readings.has(Reading::stage)) return infinity;
  if (!readings.has(Reading::deflection))
    throw wrong_value(input, "rig.stiffness",
                      "the stiffness of the load train, as the displacement is that of the stage", "none",
                      to_say(input, KeyChange{"rig", "stiffness", "\"… N/m\""}) +
                          "; \"inf\" if the displacement is that of the specimen's midpoint or already corrected");
  throw missing(input, input.rig ? "rig.stiffness" : "rig");
}

// By the rows [first, last), counted from 0.
void find_sign(SignRule rule, std::size_t first, std::size_t last, Readings& readings, Preparation& steps) {
  Signs signs{1, 1};
  if (rule == SignRule::reverse) signs = {-1, -1};
  if (rule == SignRule::find) {
    const std::vector<double> all = force_or_difference(readings);
    const auto force = std::span(all).subspan(first, last - first);
    const std::size_t rows = points_before_wrap(force);
    signs = find_signs(std::span(readings.displacement()).subspan(first, rows), force.first(rows));
    // Without a force column its sign is that of the displacements it is the difference of.
    if (!readings.has(Reading::force) && signs.force != signs.displacement) signs = {1, 1};
  }
  for (std::size_t i = 0; i < readings.columns.size(); ++i)
    if (const Reading is = readings.columns[i];
        is != Reading::length && (is == Reading::force ? signs.force : signs.displacement) < 0)
      for (double& value : readings.table.columns[i].values) value = -value;
  const bool is_found = rule == SignRule::find;
  const bool changed = signs.displacement < 0 || signs.force < 0;
  std::string words = signs.displacement < 0 && signs.force < 0 ? "displacement and force are reversed"
                      : signs.displacement < 0                  ? "the displacement is reversed"
                      : signs.force < 0                         ? "the force is reversed"
                                                                : "displacement and force keep their signs";
  words += !is_found ? ", as stated" : changed ? ", as compression is negative in the file" : ", positive in loading";
  steps.add("sign", changed, std::move(words),
            KeyChange{"record", "sign",
                      !is_found ? "\"find\""
                      : changed ? "\"keep\""
                                : "\"reverse\""});
}

// The rows of the first loading, up to its greatest force.
Record first_rise(const Record& record) {
  const std::vector<Leg> legs = find_legs(record.stage);
  const std::size_t points = legs.empty() ? record.force.size() : legs.front().last;
  const auto greatest =
      std::max_element(record.force.begin(), record.force.begin() + static_cast<std::ptrdiff_t>(points));
  return first_points(record, static_cast<std::size_t>(greatest - record.force.begin()) + 1);
}

ForceZero zero_of(const Record& rise) {
  if (rise.force.size() < least_noise_points) return {ForceZeroStatus::no_free_rows, 0, 0, 0};
  return find_force_zero(rise.stage, rise.force, force_noise(rise));
}

Record with_force_zero(const Record& record, const Baseline& zero, bool stage_is_read, double stiffness) {
  std::vector<double> force = record.force;
  const std::vector<double>& displacement = stage_is_read ? record.stage : record.deflection;
  for (std::size_t i = 0; i < force.size(); ++i) force[i] -= zero.at(displacement[i]);
  return stage_is_read ? record_from_stage_and_force(record.stage, force, stiffness)
                       : record_from_deflection_and_force(record.deflection, force, stiffness);
}

Record zeroed(const Test& input, const Record& record, const Record& rise, bool stage_is_read, double stiffness,
              const Sampling& sampling, const Baseline& baseline, Preparation& steps) {
  const ForceZeroRule& rule = input.record->zero;
  if (rule == ForceZeroRule{ZeroWord::keep}) {
    steps.add("zero", false, "the force is counted from the file's own zero, as stated",
              KeyChange{"record", "zero", "\"find\""});
    return record;
  }
  if (const auto* stated = std::get_if<double>(&rule)) {
    steps.add("zero", *stated != 0, "the force is counted from the zero stated",
              KeyChange{"record", "zero", "\"keep\""}, value_in(input, *stated, {}, kind::force));
    return with_force_zero(record, {.level = *stated}, stage_is_read, stiffness);
  }
  if (rule == ForceZeroRule{ZeroWord::slope} && baseline.points > 0) {
    steps.add("zero", true,
              fmt::format("the force that {} before contact is subtracted, and led on behind it",
                          baseline.settles_by != 0 ? "settles" : "drifts"),
              KeyChange{"record", "zero", "\"find\""}, value_in(input, baseline.change, baseline.error, kind::force),
              RowRange{1, rows_of_points(sampling, baseline.points)});
    return with_force_zero(record, baseline, stage_is_read, stiffness);
  }
  const ForceZero zero = zero_of(rise);
  if (zero.status != ForceZeroStatus::found) {
    steps.add("zero", false,
              "the record has no rows before contact that show the zero of the force: the file's own zero is kept",
              KeyChange{"record", "zero", "\"…\""});
    return record;
  }
  const bool changed = is_significant(zero);
  steps.add("zero", changed,
            changed ? "the mean force before contact is subtracted"
                    : "the mean force before contact is zero within four standard errors and is not subtracted",
            KeyChange{"record", "zero", "\"keep\""}, value_in(input, zero.offset, zero.error, kind::force),
            RowRange{1, rows_of_points(sampling, zero.points)});
  return changed ? with_force_zero(record, {.level = zero.offset}, stage_is_read, stiffness) : record;
}

void note_compliance(const Test& input, const Readings& readings, double stiffness, Preparation& steps) {
  const bool is_stiff = std::isinf(stiffness);
  const bool is_stated = input.rig && input.rig->stiffness;
  const std::string_view of =
      support_compliance_of(input) > 0 ? "the stiffness of load train and supports" : "load-train stiffness";
  std::string words;
  if (!readings.has(Reading::force))
    words = fmt::format("the force is {} times the difference between stage displacement and deflection", of);
  else if (readings.has(Reading::stage))
    words = is_stiff ? "the deflection equals the stage displacement, as the load train is stated to be rigid"
                     : fmt::format("the deflection is the stage displacement minus force over {}", of);
  else
    words = !is_stated ? "the stage displacement is taken to equal the deflection, as no load-train stiffness is stated"
            : is_stiff ? "the stage displacement equals the deflection, as the load train is stated to be rigid"
                       : fmt::format("the stage displacement is the deflection plus force over {}", of);
  std::optional<PreparedValue> value;
  if (!is_stiff) value = value_in(input, stiffness, {}, kind::stiffness);
  steps.add("compliance", !is_stiff, std::move(words), KeyChange{"rig", "stiffness", is_stiff ? "\"…\"" : "\"inf\""},
            value);
}

// A load train under a force gives way by no more than the stage moves: the rest is the deflection.
void require_stiff_enough(const Test& input, const Record& record, double stiffness) {
  const Record rise = first_rise(record);
  const double force = rise.force.back() - rise.force.front();
  const double way = rise.stage.back() - rise.stage.front();
  if (!(way > 0) || force / stiffness <= way) return;
  const Kind force_kind = kind_in(input, kind::force);
  throw wrong_value(input, "rig.stiffness", "a load train that yields by less than the stage moves",
                    fmt::format("{0}, which yields by {2} under {1}, but the stage moved {3}",
                                readable(stiffness, kind_in(input, kind::stiffness)), readable(force, force_kind),
                                readable_length(input, force / stiffness), readable_length(input, way)),
                    "check it and the units of stage and force; write \"inf\" if the displacement is that of the "
                    "specimen's midpoint or already corrected");
}

// Values of the rows of a table, at those of its file; NaN at rows without a number.
std::vector<double> of_file_rows(const std::vector<double>& values, const Table& table) {
  std::vector<double> all(table.rows_of_file(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < values.size(); ++row) all[table.file_row(row)] = values[row];
  return all;
}

// Holds the stage where it runs back by no more than its noise.
// Fails: InputError where it runs back farther.
void hold_stage(const Test& input, const Table& table, Record& record, std::span<const std::size_t> rows, bool turns,
                Preparation& steps) {
  std::vector<double>& stage = record.stage;
  double farthest = stage.front();
  const auto [least, most] = std::minmax_element(stage.begin(), stage.end());
  const double allowed =
      turns ? infinity : std::max(max_stage_noise * (*most - *least), stage_noise_range * stage_noise(stage));
  std::size_t held = 0;
  double largest = 0;
  for (std::size_t i = 1; i < stage.size(); ++i) {
    if (farthest - stage[i] > allowed)
      throw InputError({.file = table.source,
                        .line = table.lines[table.rows_before(rows[i])],
                        .field = "the stage",
                        .expected = fmt::format("a position no smaller than the farthest before it, {}",
                                                readable_length(input, farthest == 0 ? 0 : farthest)),
                        .found = readable_length(input, stage[i] == 0 ? 0 : stage[i]),
                        .remedy = i < 30
                                      ? fmt::format("check the sign of the displacement: {} or \"reverse\"",
                                                    to_say(input, switch_to("sign", "keep")))
                                      : "keep only the loading: " +
                                            to_say(input, KeyChange{"record", "until", fmt::format("{}", rows[i])})});
    if (stage[i] < farthest) {
      ++held;
      largest = std::max(largest, farthest - stage[i]);
    }
    farthest = std::max(farthest, stage[i]);
    stage[i] = farthest;
  }
  if (held > 0)
    steps.add("stage", true,
              fmt::format("where the stage runs back, at {} {}, its farthest position so far is used", held,
                          held == 1 ? "point" : "points"),
              {}, value_in(input, largest, {}, kind::length));
}

bool begins_before_contact(const Record& record, const Contact& contact, double noise) {
  if (contact.status != ContactStatus::found) return false;
  const auto free =
      std::find_if(record.force.begin(), record.force.end(), [&](double force) { return std::abs(force) > 4 * noise; });
  const double step = (record.stage.back() - record.stage.front()) / static_cast<double>(record.stage.size() - 1);
  return static_cast<double>(free - record.force.begin()) >= min_free_rows + 4 * noise / (contact.slope * step);
}

// What is known of a test before its record is looked at. Without a span, as of a modulus that asks none, the curve is as good as straight.
BeginningOf beginning_of(const Test& input, const Record& record, double stiffness) {
  constexpr double straight = 20;  // [greatest deflection]
  BeginningOf beginning{.span = straight * *std::max_element(record.deflection.begin(), record.deflection.end()),
                        .load_train_stiffness = stiffness};
  if (!(beginning.span > 0)) beginning.span = 1;
  if (!input.rig || !input.rig->span) return beginning;
  beginning.span = *input.rig->span;
  if (input.rig->roller_radius) beginning.support_radius = *input.rig->roller_radius;
  if (states_stiffness(input)) {
    const BendingStiffnessUsed stated = bending_stiffness_of(input);
    beginning.bending_stiffness = stated.value;
    beginning.bending_stiffness_error = stated.relative_error;
  }
  return beginning;
}

void require_points(const Table& table, const Record& record, std::size_t min_points) {
  if (record.force.size() >= min_points) return;
  const std::size_t rows = table.lines.size();
  throw InputError({.file = table.source,
                    .expected = fmt::format("at least {} rows of readings before failure", min_points),
                    .found = fmt::format("{} of {}", record.force.size(), rows),
                    .remedy = rows < min_points
                                  ? ""
                                  : "check that the rows stand in the order of time, and the column of the "
                                    "displacement: a loading ends where it goes back"});
}

// Fails:      InputError where the stage stands still all along, which bends no specimen.
void require_moving(const Test& input, const Table& table, const Record& record) {
  const auto [least, most] = std::minmax_element(record.stage.begin(), record.stage.end());
  if (*least < *most) return;
  throw InputError(
      {.file = table.source,
       .line = table.lines[0],
       .field = "the stage",
       .expected = "one that moves",
       .found = fmt::format("{} in all {} rows", readable_length(input, *least == 0 ? 0 : *least), record.stage.size()),
       .remedy = "check the column of the displacement"});
}

struct Loading {
  Leg leg;
  EvaluatedLoading counted;
  std::string_view why{};
};

// The first loading that goes about as far as any, or whose force no later one reaches again: what comes after is another specimen, a damaged one.
// Fails:      InputError where the stage only goes back.
Loading loading_to_evaluate(const Test& input, const Table& table, const Record& record, const std::vector<Leg>& legs) {
  constexpr double as_far = 0.95;  // of the way of that which goes farthest, and of the force
  const std::vector<double>& stage = record.stage;
  const auto greatest_force = [&](const Leg& leg) {
    const auto force = std::span(record.force).subspan(leg.first, leg.last - leg.first);
    return *std::max_element(force.begin(), force.end());
  };
  const auto [least, farthest] = std::minmax_element(stage.begin(), stage.end());
  const double far = *least + as_far * (*farthest - *least);
  std::vector<Leg> loadings;
  for (const Leg& leg : legs)
    if (leg.direction == Direction::loading) loadings.push_back(leg);
  Loading evaluated{{0, stage.size(), Direction::loading}, {0, loadings.size()}};
  std::vector<double> later(loadings.size(), -infinity);  // the greatest force of those that come after
  for (std::size_t i = loadings.size(); i-- > 1;) later[i - 1] = std::max(later[i], greatest_force(loadings[i]));
  for (std::size_t i = 0; i < loadings.size() && evaluated.counted.number == 0; ++i) {
    const double end = stage[loadings[i].last - 1];
    if (end < far && as_far * greatest_force(loadings[i]) <= std::max(later[i], 0.0)) continue;
    evaluated.leg = loadings[i];
    evaluated.counted.number = i + 1;
    evaluated.why = end < far         ? "no later one reaches its force again"
                    : end < *farthest ? "the first that goes about as far as any"
                                      : "none goes farther";
  }
  if (legs.empty()) return {evaluated.leg, {}};
  if (evaluated.counted.number > 0) return evaluated;
  throw InputError(
      {.file = table.source,
       .line = table.lines[0],
       .field = "the stage",
       .expected = "a record that has a loading",
       .found = "one that only unloads",
       .remedy = "if the stage is counted the other way, " +
                 to_say(input, switch_to("sign", input.record->sign == SignRule::reverse ? "keep" : "reverse"))});
}

// [N] The force at the beginning of a record, whatever one reading says.
double force_at_start(std::span<const double> force) {
  return force.size() < 3 ? 0 : median_of({force[0], force[1], force[2]});
}

// Fails:      InputError where a loading begins under more than a fifth of its greatest force, and the force falls steadily to nearly none: an
//             unloading, or rows that run backwards.
void require_rise(const Test& input, const Table& table, const Record& record, const Leg& leg,
                  const Sampling& sampling) {
  const auto force = std::span(record.force).subspan(leg.first, leg.last - leg.first);
  constexpr std::size_t fewest = 30, parts = 20;
  if (force.size() < fewest) return;
  std::array<double, parts> mean;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * force.size() / parts, end = (part + 1) * force.size() / parts;
    mean[part] = std::accumulate(force.begin() + static_cast<std::ptrdiff_t>(begin),
                                 force.begin() + static_cast<std::ptrdiff_t>(end), 0.0) /
                 static_cast<double>(end - begin);
  }
  const auto greatest = std::max_element(mean.begin(), mean.end());
  constexpr double little = 0.2, rise = 0.05;  // of the greatest
  const double first = std::min(mean.front(), force_at_start(force));
  if (first < little * *greatest || mean.back() > little * *greatest) return;
  constexpr std::ptrdiff_t at_once = 5;  // where it gives way, it falls in less
  std::ptrdiff_t between = 0;
  for (auto part = greatest + 1; part != mean.end(); ++part) {
    if (*part > *(part - 1) + rise * *greatest) return;
    if (*part > little * *greatest && *part < (1 - little) * *greatest) ++between;
  }
  if (between < at_once) return;
  const std::size_t row = sampling.rows[leg.first];
  throw InputError(
      {.file = table.source,
       .line = table.lines[table.rows_before(row)],
       .field = "the force",
       .expected = "one that rises as the specimen is bent",
       .found = fmt::format("one that begins with {} and falls steadily to {}",
                            readable(force.front(), kind_in(input, kind::force)),
                            readable(force.back(), kind_in(input, kind::force))),
       .remedy = "if the rows run backwards in time, write them in the reverse order; if this is the unloading of a "
                 "test, give the rows of its loading"});
}

// How many rows lie before a place, a row or where the stage or the deflection first gets there; and how many up to it, itself among them.
struct RowsTo {
  std::size_t before, up_to;
};

// Fails:      InputError where the record does not get there.
RowsTo rows_to(const PlaceInRecord& place, std::string_view key, const Test& input, const Record& every,
               const Table& table) {
  if (const auto* at = std::get_if<AtRow>(&place)) {
    if (at->row > table.rows_of_file())
      throw wrong_value(input, key, fmt::format("one of the {1} rows of {0}", table.source, table.rows_of_file()),
                        std::to_string(at->row));
    return {table.rows_before(at->row - 1), table.rows_before(at->row)};
  }
  const auto* stage = std::get_if<AtStage>(&place);
  const auto& positions = stage ? every.stage : every.deflection;
  const double position = stage ? stage->position : std::get<AtDeflection>(place).position;
  const auto there = std::find_if(positions.begin(), positions.end(), [&](double at) { return at >= position; });
  if (there == positions.end())
    throw wrong_value(input, key,
                      fmt::format("a {} within the record, which reaches {}", stage ? "stage position" : "deflection",
                                  readable_length(input, *std::max_element(positions.begin(), positions.end()))),
                      readable_length(input, position));
  const auto before = static_cast<std::size_t>(there - positions.begin());
  return {before, before + (*there == position ? 1 : 0)};
}

// The points before where the record is stated to end.
std::size_t points_until(std::size_t until, Measurement& result, Preparation& steps) {
  result.end = MeasurementEnd::until;
  const bool changed = until < result.rows;
  steps.add("end", changed, fmt::format("the record ends with row {}, as stated", until),
            KeyChange{"record", "until", fmt::format("{}", result.rows)}, {},
            changed ? std::optional(RowRange{until + 1, result.rows}) : std::nullopt);
  return points_before(until, result.sampling);
}

// Drops of the force of a loading from a point on, which come after what is evaluated.
std::size_t drops_behind(const Record& all, const Leg& loading, std::size_t from, const Sampling& sampling) {
  Record record = points_between(all, loading.first, loading.last);
  record.stage = advancing(record.stage);
  const Drops found = find_drops(record, {.halts = sampling.halts_between(loading.first, loading.last)});
  return static_cast<std::size_t>(std::count_if(found.drops.begin(), found.drops.end(),
                                                [&](const Drop& drop) { return loading.first + drop.before >= from; }));
}

// Ends a loading before the failure, which the way back may tell. What is left, in points of the record.
std::size_t end_of(const Test& input, const Record& all, const Leg& loading, const Leg& way_back, Measurement& result,
                   Preparation& steps) {
  if (input.record->failure == FailureRule::none) {
    steps.add("end", false, "failure was not looked for, as stated: all rows are used",
              KeyChange{"record", "failure", "\"find\""});
    return loading.last;
  }
  const Failure failure = find_failure(points_between(all, loading.first, way_back.last));
  if (const std::size_t points = loading.first + failure.points;
      failure.status == FailureStatus::found && points < loading.last) {
    result.end = MeasurementEnd::failure;
    result.drops_behind = drops_behind(all, loading, loading.first + failure.fallen, result.sampling);
    const std::size_t last = rows_of_points(result.sampling, points);
    steps.add("end", true, fmt::format("the specimen failed after row {}: later rows are left out", last),
              KeyChange{"record", "failure", "\"none\""}, {}, RowRange{last + 1, result.rows});
    return points;
  }
  steps.add("end", false, "no failure was found: all rows are kept", KeyChange{"record", "until", "…"});
  return loading.last;
}

// The loading to evaluate, without what follows its end; all loadings, where there are several, are the cycles. Returns its first point and
// that after its last.
Leg evaluated_loading(const Test& input, const Table& table, const Record& all, const std::optional<std::size_t>& until,
                      Measurement& result, Preparation& steps) {
  std::size_t points = all.force.size();
  if (until) points = std::min(points, points_until(*until, result, steps));
  const Record looked_at = first_points(all, points);
  const std::vector<double>& stage = looked_at.stage;
  const std::vector<Leg> legs = find_legs(stage);
  Loading loading = loading_to_evaluate(input, table, looked_at, legs);
  require_rise(input, table, looked_at, loading.leg, result.sampling);
  result.loading = loading.counted;
  const auto row = [&](std::size_t point) { return rows_of_points(result.sampling, point); };
  if (result.loading.of > 1)
    steps.add("loading", true,
              fmt::format("loading {} of {} is evaluated, rows {} to {}: {}", result.loading.number, result.loading.of,
                          result.sampling.rows[loading.leg.first] + 1, row(loading.leg.last), loading.why),
              result.loading.number > 1
                  ? std::optional(KeyChange{"record", "until", fmt::format("{}", row(legs.front().last))})
                  : std::nullopt,
              {}, RowRange{result.sampling.rows[loading.leg.first] + 1, row(loading.leg.last)});
  else if (legs.size() > 1)
    steps.add("loading", true,
              fmt::format("the stage turns back after row {}, where the loading ends", row(loading.leg.last)), {}, {},
              RowRange{row(loading.leg.last) + 1, result.rows});
  if (loading.leg.last < points) result.end = MeasurementEnd::turn;
  if (result.end == MeasurementEnd::until && loading.leg.last == points) {
    Leg whole{loading.leg.first, all.force.size(), Direction::loading};
    for (const Leg& leg : find_legs(all.stage))
      if (leg.first == whole.first) whole.last = leg.last;
    result.drops_behind = drops_behind(all, whole, points, result.sampling);
  }
  std::size_t last = loading.leg.last;
  if (!until) {
    const auto next = std::find_if(legs.begin(), legs.end(), [&](const Leg& leg) { return leg.first >= last; });
    last = end_of(input, all, loading.leg, next == legs.end() ? loading.leg : *next, result, steps);
  }
  const bool is_whole = last == loading.leg.last;
  if (legs.size() > 1 && (is_whole || loading.leg.first > 0))
    result.cycles = first_points(all, is_whole ? points : last);
  return {loading.leg.first, last, Direction::loading};
}

// [N] The force under which a record begins whose file counts from the contact, where none of its specimen could be there; below zero where no
// specimen makes it; else 0.
double force_at_beginning(const Record& record, const Contact& contact, double slope, double contact_error,
                          double noise) {
  constexpr double surely = 3, of_noise = 4, of_greatest = 0.01;
  const auto& force = record.force;
  const double first = force_at_start(force);
  if (first < -std::max(of_noise * noise, of_greatest * *std::max_element(force.begin(), force.end()))) return first;
  if (contact.status != ContactStatus::found ||
      contact.offset.value > record.stage.front() - surely * contact_error)  // or its first reading is an outlier
    return 0;
  const double way = std::max(record.deflection.front() + surely * contact_error, 0.0);
  return record.force.front() > slope * way + of_noise * noise ? record.force.front() : 0;
}

// Fewer readings than a fit needs are bent far enough to tell of friction.
bool tells_no_friction(const Test& input, const Record& record) {
  const Scales scales(*input.rig->span, 1);
  return readings_judged(to_reduced(record, scales), fibre_of(input, scales)).size() < min_readings;
}

// Do at least so many points lie behind a contact?
bool leaves(std::size_t points, const Record& record, double contact) {
  return record.stage.size() >= points && record.stage[record.stage.size() - points] >= contact;
}

// Does the straight part meet zero force farther behind the contact than friction and supports explain? All before it is then a toe.
bool begins_with_toe(const Record& record, const StraightPart& straight, const BeamGeometry& geometry, double contact,
                     double contact_error) {
  constexpr double surely = 3;
  const double middle = straight.middle(record);
  const double error = elementary::length(contact_error, straight.origin_error(record));
  const double steeper = most_steepening(geometry, middle - contact);
  return straight.origin - contact > surely * error + (middle - contact) * steeper / (1 + steeper);
}

// What the contact is taken off at, and how certainly.
void find_zero_displacement(const Test& input, const Record& whole, double stiffness, std::size_t min_points,
                            Measurement& result, Preparation& steps) {
  const std::optional<ContactRule>& rule = input.record->contact;
  const BeginningOf beginning = beginning_of(input, whole, stiffness);
  const Contact contact = find_contact(whole, beginning);
  result.own_contact = contact;
  const double usual = usual_contact_error * beginning.span;
  const std::optional<StraightPart>& straight = result.straight;
  result.begins_free = result.baseline.points > 0 || begins_before_contact(whole, contact, result.force_noise);
  const bool is_asked = rule == ContactRule{ContactWord::find};
  // The stage's own zero is far from where the force begins to rise, and that is where the record begins.
  constexpr double far = 10, near = 0.25;
  const bool begins_elsewhere =
      contact.status == ContactStatus::found && std::abs(contact.offset.value) > far * contact.offset.standard_error &&
      std::abs(contact.offset.value - whole.stage.front()) < near * std::abs(contact.offset.value);
  if (is_asked && contact.status != ContactStatus::found)
    throw wrong_value(input, "record.contact",
                      "a force that rises from contact over at least 5 rows, to find the contact", "none",
                      "state the contact, or leave the key out");
  // A baseline is off by its error, where it is led on to the contact.
  const double by_baseline = contact.status == ContactStatus::found ? result.baseline.error / contact.slope : 0;
  const double slope = result.straight_is_initial ? straight->slope.value : contact.slope;
  if (result.baseline.points == 0)
    result.begins_under = force_at_beginning(whole, contact, slope, usual, result.force_noise);
  const bool is_found = is_asked || (!rule && contact.status == ContactStatus::found &&
                                     (result.begins_free || begins_elsewhere || result.begins_under > 0));

  if ((is_asked || !rule) && result.straight_is_initial && leaves(min_points, whole, straight->origin) &&
      begins_with_toe(whole, *straight, geometry_of(input), is_found ? contact.offset.value : 0,
                      is_found ? contact.offset.standard_error : usual)) {
    result.contact = ContactSource::found;
    result.contact_offset = straight->origin;
    const double between = contact.status == ContactStatus::found ? straight->origin - contact.offset.value : 0;
    result.contact_error = elementary::length(usual, between);
    result.own_contact = counted_from(straight->origin, contact);
    steps.add(
        "contact", true,
        fmt::format("the record begins with a toe: displacements are counted from where the straight part, rows {} "
                    "to {}, would meet zero force",
                    result.sampling.rows[result.first + straight->first] + 1,
                    rows_of_points(result.sampling, result.first + straight->last)),
        KeyChange{"record", "contact", "\"first row\""},
        value_in(input, straight->origin, result.contact_error, kind::length));
    return;
  }
  if (is_found) {
    result.contact = ContactSource::found;
    result.contact_offset = contact.offset.value;
    result.contact_error = elementary::length(contact.offset.standard_error, by_baseline);
    result.own_contact = counted_from(contact.offset.value, contact);
    steps.add("contact", true, "displacements are counted from where the record itself begins",
              KeyChange{"record", "contact", "\"first row\""},
              value_in(input, contact.offset.value, contact.offset.standard_error, kind::length),
              contact.points_before > 0
                  ? std::optional(RowRange{result.sampling.rows[result.first] + 1,
                                           rows_of_points(result.sampling, result.first + contact.points_before)})
                  : std::nullopt);
    return;
  }
  const auto* stated = rule ? std::get_if<Known>(&*rule) : nullptr;
  if (rule) {
    result.contact = ContactSource::stated;
    result.contact_offset = stated ? stated->value : whole.stage.front();
    result.own_contact = counted_from(result.contact_offset, contact);
  }
  result.contact_error = stated ? stated->uncertainty.value_or(usual) : usual;
  if (contact.status == ContactStatus::found) {  // wide enough to hold the record's own
    const Estimate& own = result.own_contact.offset;
    result.contact_error =
        elementary::length(result.contact_error, std::max(std::abs(own.value) - own.standard_error, 0.0));
  }
  if (!rule) {
    steps.add("contact", false, "displacements are counted from the file's own zero",
              KeyChange{"record", "contact", "\"find\""});
    return;
  }
  steps.add("contact", result.contact_offset != 0,
            stated ? "displacements are counted from the contact stated"
                   : "displacements are counted from the first row, as stated",
            KeyChange{"record", "contact", "\"find\""},
            value_in(input, result.contact_offset, stated ? stated->uncertainty : std::nullopt, kind::length));
}

}  // namespace

Measurement read_measurement(const Test& asked, const Needs& needs) {
  const std::size_t min_points = needs.points;
  if (min_points < least_noise_points)
    throw std::invalid_argument(fmt::format("the noise of {} points cannot be estimated", min_points));
  if (!asked.record) throw missing(asked, "record");
  Readings readings = read_readings(asked, needs);
  Table& table = readings.table;
  Measurement result{.test = std::move(readings.test),
                     .preparation = std::move(readings.preparation),
                     .file = table.source,
                     .rows = table.rows_of_file(),
                     .missing = table.missing_rows.size()};
  const Test& input = result.test;
  Preparation& steps = result.preparation;

  const double stiffness = stiffness_for(input, readings);
  const std::size_t sign_from = table.rows_before(row_or(input.record->first, result.rows, 1) - 1);
  const std::size_t sign_to = table.rows_before(row_or(input.record->until, result.rows, result.rows));
  find_sign(input.record->sign, std::min(sign_from, sign_to), sign_to, readings, steps);
  Record every = record_of(readings, stiffness);
  if (readings.has(Reading::length)) result.pulled_in = of_file_rows(readings.of(Reading::length), table);
  require_finite(every, table);
  StatedRows stated;
  if (const auto& place = input.record->until)
    stated.until = rows_to(*place, "record.until", input, every, table).up_to;
  if (const auto& place = input.record->first)
    stated.first = rows_to(*place, "record.first", input, every, table).before;
  const std::size_t first = stated.first > 0 ? table.file_row(stated.first - 1) + 1 : 0;  // of the file
  std::optional<std::size_t> until;                                                       // likewise, the last
  if (stated.until) until = *stated.until > 0 ? table.file_row(*stated.until - 1) + 1 : 0;
  if (until && first >= *until)
    throw wrong_value(input, "record.first", fmt::format("a place before the end of the record, row {}", *until),
                      fmt::format("row {}", first + 1));
  if (first > 0)
    steps.add("first", true, fmt::format("the record begins with row {}, as stated", first + 1),
              KeyChange{"record", "first", "1"}, {}, RowRange{1, first});
  CountedRows counted = rows_that_count(std::move(every), table, readings.displacement(), stated, stiffness, steps);
  every = std::move(counted.record);
  result.sampling = std::move(counted.sampling);
  if (counted.ends_in_overload) result.end = MeasurementEnd::overload;
  const Record asked_for = until ? first_points(every, points_before(*until, result.sampling)) : every;
  require_points(table, asked_for, min_points);  // where rows do not count, none may be left
  require_moving(input, table, asked_for);
  const Record rise = first_rise(asked_for);
  if (rise.force.size() >= least_noise_points)
    result.baseline = find_baseline(readings.has(Reading::stage) ? rise.stage : rise.deflection, rise.force);
  result.baseline_is_off = input.record->zero == ForceZeroRule{ZeroWord::slope} && result.baseline.points > 0;
  const Record all =
      zeroed(input, every, rise, readings.has(Reading::stage), stiffness, result.sampling, result.baseline, steps);
  note_compliance(input, readings, stiffness, steps);
  result.is_derived = readings.has(Reading::stage) && !readings.has(Reading::deflection);

  const Leg loading = evaluated_loading(input, table, all, until, result, steps);
  result.first = loading.first;
  Record whole = points_between(all, loading.first, loading.last);
  require_points(table, whole, min_points);
  if (readings.has(Reading::stage) && readings.has(Reading::force)) require_stiff_enough(input, whole, stiffness);
  hold_stage(input, table, whole, std::span(result.sampling.rows).subspan(loading.first), result.cycles.has_value(),
             steps);
  result.force_noise = force_noise(whole);
  SmallDeflectionOptions options;
  if (result.is_derived) options.load_train_error = rig_errors_of(result).load_train;
  options.halts = result.sampling.halts_between(loading.first, loading.last);
  result.straight = straight_part(whole, geometry_of(input), options);
  result.straight_is_initial =
      result.straight && input.rig && input.rig->span && result.loading.number <= 1 && tells_no_friction(input, whole);
  find_zero_displacement(input, whole, stiffness, min_points, result, steps);

  const auto begin = std::lower_bound(whole.stage.begin(), whole.stage.end(), result.contact_offset);
  const std::size_t skipped =
      result.contact == ContactSource::first_point ? 0 : static_cast<std::size_t>(begin - whole.stage.begin());
  result.first += skipped;
  if (whole.force.size() - skipped < min_points)
    throw wrong_value(input, "record.contact", fmt::format("at least {} rows of readings after contact", min_points),
                      std::to_string(whole.force.size() - skipped));
  result.record = counted_from(result.contact_offset, std::move(whole), skipped);
  if (result.straight && result.straight->first >= skipped) {
    result.straight->first -= skipped;
    result.straight->last -= skipped;
    result.straight->origin -= result.contact_offset;
  } else {
    options.halts = result.sampling.halts_between(result.first, loading.last);
    result.straight = straight_part(result.record, geometry_of(input), options);
  }
  if (result.cycles) result.cycles = counted_from(result.contact_offset, std::move(*result.cycles));
  return result;
}

Record first_loading(const Measurement& measurement) {
  if (measurement.loading.number <= 1 || !measurement.cycles) return measurement.record;
  const Leg first = find_legs(measurement.cycles->stage).front();
  return points_between(*measurement.cycles, first.first, first.last);
}

std::size_t file_row(const Measurement& measurement, std::size_t point) {
  return cyclic_file_row(measurement, measurement.first + point);
}

std::size_t cyclic_file_row(const Measurement& measurement, std::size_t point) {
  return measurement.sampling.rows[point] + 1;
}

std::size_t last_file_row(const Measurement& measurement, std::size_t point) {
  return rows_of_points(measurement.sampling, measurement.first + point + 1);
}

}  // namespace flexslip
