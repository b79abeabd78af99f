#include "cli/trace_flags.h"

#include "instruments/export_words.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {

TraceOptions options_of(const TraceFlags& flags) {
  using namespace std::string_view_literals;
  TraceOptions options;
  if (!flags.sheet.empty()) options.file.sheet = flags.sheet;
  if (!flags.encoding.empty()) options.file.encoding = encoding_named(flags.encoding);
  if (!flags.separator.empty()) options.file.separator = mark_named(flags.separator, "--separator");
  if (!flags.decimal.empty()) options.file.decimal = mark_of(flags.decimal, "--decimal", ".,");
  if (!flags.thousands.empty()) options.file.thousands = mark_of(flags.thousands, "--thousands", "., '\0"sv);
  options.position = flags.position;
  options.height = flags.height;
  options.position_unit = flags.position_unit;
  options.height_unit = flags.height_unit;
  if (!flags.step.empty()) try {
      options.step = parse_quantity(flags.step, kind::length, Range::positive);
    } catch (const InputError& error) {
      throw located(error, "", 0, "--step");
    }
  return options;
}

void add_trace_options(CLI::App& command, TraceFlags& flags) {
  const auto text = [&](const char* name, std::string& value, const char* description, const char* type) {
    return command.add_option(name, value, description)->type_name(type)->group("How the trace is read");
  };
  auto* position = text("--position", flags.position, "The column of the positions, its name or number", "COLUMN");
  text("--height", flags.height, "The column of the heights", "COLUMN");
  text("--position-unit", flags.position_unit, "The unit of the positions", "UNIT");
  text("--height-unit", flags.height_unit, "The unit of the heights", "UNIT");
  text("--step", flags.step, "Distance of the heights, of a file without positions", "LENGTH")->excludes(position);
  text("--sheet", flags.sheet, "Of a workbook (.xlsx): the sheet, its name or number", "SHEET");
  text("--encoding", flags.encoding, "utf-8, utf-16le, utf-16be, cp1252 or shift-jis", "NAME");
  text("--separator", flags.separator, "Between cells: , ; tab or space", "MARK");
  text("--decimal", flags.decimal, "Decimal mark: . or ,", "MARK");
  text("--thousands", flags.thousands, "Between groups of digits: . , space ' or none", "MARK");
}

}  // namespace flexslip
