#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "instruments/export.h"
#include "instruments/export_fields.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

constexpr std::array flags_of_exports{
    ReadingFlag{"time COLUMN", "Column of time, by name or number"},
    ReadingFlag{"crosshead COLUMN", "Column of crosshead displacement, by name or number"},
    ReadingFlag{"deflection COLUMN", "Column of deflection of the specimen, by name or number"},
    ReadingFlag{"force COLUMN", "Column of force, by name or number"},
    ReadingFlag{"displacement WHICH", "What a displacement measures if its name does not say: crosshead or deflection"},
    ReadingFlag{"time-unit UNIT", "Unit of time"},
    ReadingFlag{"displacement-unit UNIT", "Unit of displacements"},
    ReadingFlag{"force-unit UNIT", "Unit of force"},
    ReadingFlag{"calibration VALUE", "Calibration of a force given in volts, such as \"222 N/V\""}};

struct ReadRequest {
  std::string file;
  std::size_t specimen = 0;  // from 1; 0: not given
  ReadingWords words;
  Output output{.path = ""};  // empty: no table is written
};

bool writes_table(const ReadRequest& request) { return !request.output.json && !request.output.path.empty(); }

// The specimen that is described, from 0.
std::size_t chosen_specimen(const ReadRequest& request, const Export& file) {
  const std::size_t count = file.specimens.size();
  if (request.specimen > count)
    throw InputError(
        {.file = file.origin.source,
         .field = "--specimen",
         .problem = fmt::format("Specimen {} is asked for, but the file holds {}", request.specimen, count)});
  if (request.specimen == 0 && count > 1 && writes_table(request))
    throw InputError(
        {.file = file.origin.source,
         .problem = fmt::format("The file holds {} specimens, and only one can be written", count),
         .remedy = fmt::format("choose with --specimen 1 to {}; without --output they are listed", count)});
  return request.specimen == 0 ? 0 : request.specimen - 1;
}

std::string_view words_for(char mark) {
  constexpr std::string_view marks("\0\t .,;", 6);
  constexpr std::array words{"none", "tab", "space", "point", "comma", "semicolon", "apostrophe"};
  return words[std::min(marks.find(mark), marks.size())];
}

// What was recognised, open questions, and the flags that repeat the decisions.
std::string summary_of(const ReadRequest& request, const Export& file, std::size_t chosen) {
  const ExportedSpecimen& specimen = file.specimens[chosen];
  std::string text;
  const auto say = [&](const std::string& line) { text += line + "\n"; };
  std::string as = file.origin.sheet ? fmt::format("the sheet {} of a workbook", in_quotes(*file.origin.sheet)) : "";
  if (file.origin.has_delimiters)
    as += fmt::format("{}{}{}, separated by {}", as.empty() ? "" : ", ", name_of(file.origin.encoding),
                      file.origin.byte_order_mark ? " with byte order mark" : "", words_for(file.origin.separator));
  if (file.has_marks)
    as += fmt::format(", decimal mark: {}, thousands mark: {}", words_for(file.marks.decimal),
                      words_for(file.marks.thousands));
  say(fmt::format("{}: {}; {}", file.origin.source, file.format, as));
  if (request.specimen == 0 && file.specimens.size() > 1) {
    say(fmt::format("{} specimens:", file.specimens.size()));
    for (std::size_t i = 0; i < file.specimens.size(); ++i) {
      const ExportedSpecimen& each = file.specimens[i];
      say(fmt::format("  {}: {} rows, lines {} to {}{}", i + 1, each.lines.size(), each.lines.front(),
                      each.lines.back(), each.name.empty() ? "" : ", " + in_quotes(each.name)));
    }
    say("columns of the first:");
  } else {
    say(fmt::format("{} rows, lines {} to {}{}", specimen.lines.size(), specimen.lines.front(), specimen.lines.back(),
                    specimen.name.empty() ? "" : ", of " + in_quotes(specimen.name)));
  }
  for (const ExportColumn& column : specimen.columns)
    say(fmt::format("column {}: {} in {}: {}", column.number, in_quotes(column.name),
                    column.unit.empty() ? "no unit" : column.unit,
                    column.words.empty() ? words_for(column.role).name : "words"));
  for (const std::string& remark : file.notes) say(remark);
  for (const OpenQuestion& question : specimen.asks) say("open question: " + question.words + " " + question.with_read);
  const bool has_spaces = request.file.find(' ') != std::string::npos;
  say(fmt::format("to read it the same way again: flexslip read {0}{1}{0} {2}{3}", has_spaces ? "\"" : "", request.file,
                  specimen.repeat_with, request.specimen > 0 ? fmt::format(" --specimen {}", request.specimen) : ""));
  return text;
}

// The summary goes to standard output, unless the table is written there.
void run_read(const ReadRequest& request) {
  Export file = read_export(request.file, options_of(request.words));
  const std::size_t chosen = chosen_specimen(request, file);
  if (request.output.json) {
    if (request.specimen > 0) file.specimens[chosen].repeat_with += fmt::format(" --specimen {}", request.specimen);
    write_json(request.output.path.empty() ? "-" : request.output.path, export_fields()({file, chosen}, {}));
    return;
  }
  if (writes_table(request)) write_canonical(request.output.path, file, file.specimens[chosen]);
  if (writes_table(request) && request.output.quiet) return;
  std::ostream& screen = request.output.path == "-" && writes_table(request) ? std::cerr : std::cout;
  screen << summary_of(request, file, chosen) << std::flush;
}

}  // namespace

void add_read_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "read", "What an export of any testing machine holds, how it was read, and its readings as plain CSV",
      run_read);
  add_option(command, "file FILE", request.file,
             "Export of a testing machine, or a workbook (.xlsx); - is standard input")
      ->required();
  add_option(command, "--specimen NUMBER", request.specimen, "Which of several specimens to read, counted from 1")
      ->check(CLI::PositiveNumber);
  const std::string& group = command.option_defaults()->get_group();
  add_reading_flags(command, request.words, flags_of_files, group);
  add_reading_flags(command, request.words, flags_of_exports, group);
  command.get_option("--displacement")->check(CLI::IsMember({"crosshead", "deflection"}));
  command.get_option("--calibration")->excludes("--force-unit");
  add_output_flags(command, request.output, "Write JSON instead of the summary");
  add_output_file(command, "-o,--output", request.output.path,
                  "Write the readings as CSV to this file; - is standard output");
  command.footer(
      "Reads exports of Instron Bluehill, MTS, Zwick testXpert, Shimadzu Trapezium and others, and plain tables, with\n"
      "any encoding, separator, decimal mark and preamble. Prints what was understood, what was decided, and what the\n"
      "file leaves open; with --output writes the readings as CSV with units in the names.\n\n"
      "Examples:\n"
      "  flexslip read examples/simulated/test.csv\n"
      "  flexslip read examples/simulated/test.csv --output plain.csv\n"
      "  flexslip read examples/simulated/test.csv --json");
}

}  // namespace flexslip
