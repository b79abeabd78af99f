#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "finding/printed.h"
#include "instruments/export.h"
#include "instruments/export_fields.h"
#include "io/input_error.h"
#include "io/text.h"
#include "report/document.h"

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
  bool full = false;
  Output output{.path = ""};  // none: no table is written
};

bool writes_table(const ReadRequest& request) { return !request.output.json && !request.output.path.empty(); }

// The specimen of the summary, counted from 0.
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

// "commas": the marks between cells, or between thousands.
std::string_view marks_in_words(char mark) {
  constexpr std::string_view marks("\0\t .,;", 6);
  constexpr std::array words{"none", "tabs", "spaces", "points", "commas", "semicolons", "apostrophes"};
  return words[std::min(marks.find(mark), marks.size())];
}

// "UTF-8 with byte order mark, commas between cells, decimal point"
std::string format_in_words(const Export& file) {
  const SheetOrigin& origin = file.origin;
  std::vector<std::string> parts;
  if (origin.sheet) parts.push_back(fmt::format("sheet {} of a workbook", in_quotes(*origin.sheet)));
  if (origin.has_delimiters) {
    std::string encoding(name_of(origin.encoding));
    std::transform(encoding.begin(), encoding.end(), encoding.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    parts.push_back(encoding + (origin.byte_order_mark ? " with byte order mark" : ""));
    parts.push_back(fmt::format("{} between cells", marks_in_words(origin.separator)));
  }
  if (file.has_marks) parts.push_back(file.marks.decimal == ',' ? "decimal comma" : "decimal point");
  if (file.has_marks && file.marks.thousands != '\0')
    parts.push_back(fmt::format("{} between thousands", marks_in_words(file.marks.thousands)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

// The flags of an answer with alternatives, "--displacement crosshead|deflection", in words:
// "--displacement crosshead, or --displacement deflection".
std::string alternatives(const std::string& answer) {
  const std::size_t bar = answer.find('|'), space = answer.rfind(' ', bar);
  if (bar == std::string::npos || space == std::string::npos) return answer;
  return fmt::format("{}, or {}{}", answer.substr(0, bar), answer.substr(0, space + 1), answer.substr(bar + 1));
}

std::string questions_in_words(std::size_t count) {
  return count == 0   ? "No question is open."
         : count == 1 ? "One question is open."
                      : fmt::format("{} questions are open.", count);
}

// True if the question is about this column.
bool is_about(const OpenQuestion& question, const ExportColumn& column) {
  return question.words.find(in_quotes(column.name)) != std::string::npos;
}

// The columns with their numbers, units and roles. An open question follows the first column that
// it names, with its flags on the next line; the other questions come last.
std::string columns_in_words(const ExportedSpecimen& specimen) {
  std::size_t name_width = 0, unit_width = 0;
  for (const ExportColumn& column : specimen.columns) {
    name_width = std::max(name_width, width_of(printable(column.name)));
    unit_width = std::max(unit_width, width_of(printable(column.unit)));
  }
  const auto padded = [](const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, width_of(text)), ' ');
  };
  const std::size_t number_width = std::to_string(specimen.columns.back().number).size();
  const std::string indent(number_width + name_width + unit_width + 8, ' ');
  std::vector<OpenQuestion> open = specimen.asks;
  std::string text;
  for (const ExportColumn& column : specimen.columns) {
    const std::string begin =
        fmt::format("  {:>{}}  {}  {}  ", column.number, number_width, padded(printable(column.name), name_width),
                    padded(printable(column.unit), unit_width));
    const std::string role(column.words.empty() ? words_for(column.role).name : "words");
    const auto question =
        std::find_if(open.begin(), open.end(), [&](const OpenQuestion& each) { return is_about(each, column); });
    if (question == open.end()) {
      text += begin + role + "\n";
      continue;
    }
    text += wrapped(fmt::format("{}: {}", role, printable(question->words)), indent, begin) +
            wrapped(alternatives(question->with_read), indent, indent);
    open.erase(question);
  }
  for (const OpenQuestion& question : open)
    text += wrapped(capitalised(printable(question.words)), "  ", "  ") +
            wrapped(alternatives(question.with_read), "    ", "    ");
  return text;
}

// The call that makes the same decisions again.
std::string same_call(const ReadRequest& request, const ExportedSpecimen& specimen) {
  const bool has_spaces = request.file.find(' ') != std::string::npos;
  return fmt::format("flexslip read {0}{1}{0} {2}{3}", has_spaces ? "\"" : "", request.file, specimen.repeat_with,
                     request.specimen > 0 ? fmt::format(" --specimen {}", request.specimen) : "");
}

std::string rows_in_words(const ExportedSpecimen& specimen) {
  return fmt::format("{}{}", format_count(specimen.lines.size(), "row", "rows"),
                     specimen.name.empty() ? "" : " of " + in_quotes(printable(specimen.name)));
}

// "span 125 mm, width 12.8 mm, thickness 4.2 mm."
std::string dimensions_in_words(const ExportedTest& test) {
  std::vector<std::string> parts;
  const auto add = [&](std::string_view name, const std::optional<double>& length) {
    if (length) parts.push_back(fmt::format("{} {}", name, readable(*length, kind::length)));
  };
  add("span", test.span);
  add("diameter", test.diameter);
  add("width", test.width);
  add("thickness", test.thickness);
  if (test.rate) parts.push_back(fmt::format("speed {:.4g} mm/s", 1e3 * *test.rate));
  return parts.empty() ? "" : fmt::format("{}.", fmt::join(parts, ", "));
}

// What the file contains, what is open, and how it was read.
std::string summary_of(const ReadRequest& request, const Export& file, std::size_t chosen) {
  const ExportedSpecimen& specimen = file.specimens[chosen];
  const bool are_listed = request.specimen == 0 && file.specimens.size() > 1;
  std::string text =
      fmt::format("{}: {}, {}. {}\n\n", file.origin.source, file.format,
                  are_listed ? fmt::format("{} specimens", file.specimens.size()) : rows_in_words(specimen),
                  questions_in_words(specimen.asks.size()));
  if (are_listed) {
    for (std::size_t i = 0; i < file.specimens.size(); ++i)
      text += fmt::format("  specimen {}: {}, lines {} to {}\n", i + 1, rows_in_words(file.specimens[i]),
                          file.specimens[i].lines.front(), file.specimens[i].lines.back());
    text += "\nColumns of specimen 1:\n";
  }
  text += columns_in_words(specimen);
  if (const std::string dimensions = dimensions_in_words(file.test); !dimensions.empty())
    text += wrapped(dimensions, "  ", "The file states: ");
  for (const std::string& remark : file.notes) text += wrapped(remark + ".", "  ", "Note: ");
  const std::string how = capitalised(
      fmt::format("{}, lines {} to {}.", format_in_words(file), specimen.lines.front(), specimen.lines.back()));
  const std::string again =
      "To read it the same way again: " + (request.full ? same_call(request, specimen) : "--full");
  return text + how + (width_of(how) + width_of(again) < line_length ? " " : "\n") + again + "\n";
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
  if (writes_table(request)) write_canonical(request.output.path, file, file.specimens[chosen], request.output.csv);
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
  command.add_flag("--full", request.full, "Also print the call that reads the file the same way again");
  add_output_flags(command, request.output, "Write JSON instead of the summary");
  add_csv_option(command, request.output);
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
