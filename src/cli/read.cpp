#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/output.h"
#include "instruments/canonical.h"
#include "instruments/export.h"
#include "instruments/export_fields.h"
#include "instruments/export_words.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct ReadRequest {
  std::string file;
  std::size_t specimen = 0;  // from 1; 0 where it is not said
  ExportWords words;
  Output output;
};

std::size_t chosen_specimen(const ReadRequest& request, const Export& file) {
  const std::size_t count = file.specimens.size();
  if (request.specimen > count)
    throw InputError({.file = file.source,
                      .field = "--specimen",
                      .expected = fmt::format("a number from 1 to {}", count),
                      .found = std::to_string(request.specimen)});
  if (request.specimen == 0 && count > 1 && !request.output.json)
    throw InputError({.file = file.source,
                      .expected = "one specimen to write",
                      .found = fmt::format("{}", count),
                      .remedy = fmt::format("choose with --specimen 1 to {}; --json lists them", count)});
  return request.specimen == 0 ? 0 : request.specimen - 1;
}

std::string_view words_for(char mark) {
  switch (mark) {
    case '\0':
      return "none";
    case '\t':
      return "tab";
    case ' ':
      return "space";
    case '.':
      return "point";
    case ',':
      return "comma";
    case ';':
      return "semicolon";
    default:
      return "apostrophe";
  }
}

void note_decisions(const ReadRequest& request, const Export& file, const ExportedSpecimen& specimen) {
  const auto say = [&](const std::string& remark) { note(request.output, remark); };
  std::string as = file.sheet ? fmt::format("the sheet {} of a workbook", in_quotes(*file.sheet)) : "";
  if (file.has_delimiters())
    as += fmt::format("{}{}{}, separated by {}", as.empty() ? "" : ", ", name_of(file.encoding),
                      file.byte_order_mark ? " with byte order mark" : "", words_for(file.separator));
  if (file.has_marks)
    as += fmt::format(", decimal mark: {}, thousands mark: {}", words_for(file.decimal), words_for(file.thousands));
  say(fmt::format("{}: {}; {}", file.source, file.format, as));
  say(fmt::format("{} rows, lines {} to {}{}", specimen.lines.size(), specimen.lines.front(), specimen.lines.back(),
                  specimen.name.empty() ? "" : ", of " + in_quotes(specimen.name)));
  for (const ExportColumn& column : specimen.columns)
    say(fmt::format("column {}: {} in {}: {}", column.number, in_quotes(column.name),
                    column.unit.empty() ? "no unit" : column.unit,
                    column.words.empty() ? name_of(column.role) : "words"));
  for (const std::string& remark : file.notes) say(remark);
  for (const std::string& question : file.asks) say("open question: " + question);
  const bool has_spaces = request.file.find(' ') != std::string::npos;
  say(fmt::format("to read it the same way again: flexslip read {0}{1}{0} {2}", has_spaces ? "\"" : "", request.file,
                  file.repeat_with));
}

void run_read(const ReadRequest& request) {
  Export file = read_export(request.file, options_of(request.words));
  const std::size_t chosen = chosen_specimen(request, file);
  if (request.specimen > 0) file.repeat_with += fmt::format(" --specimen {}", request.specimen);
  if (request.output.json)
    write_json(request.output.path, export_fields()({file, chosen}, {}));
  else
    write_canonical(request.output.path, file, file.specimens[chosen]);
  if (!request.output.json) note_decisions(request, file, file.specimens[chosen]);
}

}  // namespace

void add_read_command(CLI::App& app) {
  const auto request = std::make_shared<ReadRequest>();
  CLI::App* command = app.add_subcommand("read", "An export of any testing machine as plain CSV, and how it was read");
  command->add_option("file", request->file, "Export of a testing machine, or a workbook (.xlsx); - is standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("--specimen", request->specimen, "Which of several specimens to read, counted from 1")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber);
  const auto text = [&](const char* name, std::string& value, const char* description, const char* type) {
    return command->add_option(name, value, description)->type_name(type);
  };
  text("--sheet", request->words.sheet, "Sheet of a workbook (.xlsx), by name or number", "SHEET");
  text("--encoding", request->words.encoding, "Encoding of the text: utf-8, utf-16le, utf-16be, cp1252 or shift-jis",
       "NAME");
  text("--separator", request->words.separator, "Separator between cells: , ; tab or space", "MARK");
  text("--decimal", request->words.decimal, "Decimal mark: . or ,", "MARK");
  text("--thousands", request->words.thousands, "Thousands separator: . , space ' or none", "MARK");
  text("--time", request->words.time, "Column of time, by name or number", "COLUMN");
  text("--crosshead", request->words.crosshead, "Column of crosshead displacement, by name or number", "COLUMN");
  text("--deflection", request->words.deflection, "Column of deflection of the specimen, by name or number", "COLUMN");
  text("--force", request->words.force, "Column of force, by name or number", "COLUMN");
  text("--displacement", request->words.displacement,
       "What a displacement measures if its name does not say: crosshead or deflection", "WHICH")
      ->check(CLI::IsMember({"crosshead", "deflection"}));
  text("--time-unit", request->words.time_unit, "Unit of time", "UNIT");
  text("--displacement-unit", request->words.displacement_unit, "Unit of displacements", "UNIT");
  auto* force_unit = text("--force-unit", request->words.force_unit, "Unit of force", "UNIT");
  text("--calibration", request->words.calibration, "Calibration of a force given in volts, such as \"222 N/V\"",
       "VALUE")
      ->excludes(force_unit);
  add_output_options(*command, request->output);
  command->footer(
      "Reads exports of Instron Bluehill, MTS, Zwick testXpert, Shimadzu Trapezium and others, and plain tables, with\n"
      "any encoding, separator, decimal mark and preamble. Writes CSV with units in the names. What was decided, and\n"
      "what the file leaves open, is written to standard error, or with --json into the result.\n\n"
      "Examples:\n"
      "  flexslip read examples/simulated/test.csv --output plain.csv\n"
      "  flexslip read examples/simulated/test.csv --json");
  command->callback([request] { run_read(*request); });
}

}  // namespace flexslip
