#include "cli/trace_flags.h"

#include <string>

namespace flexslip {

void add_trace_options(CLI::App& command, TraceWords& words) {
  const auto text = [&](const char* name, std::string& value, const char* description, const char* type) {
    return command.add_option(name, value, description)->type_name(type)->group("How the trace is read");
  };
  auto* position = text("--position", words.position, "The column of the positions, its name or number", "COLUMN");
  text("--height", words.height, "The column of the heights", "COLUMN");
  text("--position-unit", words.position_unit, "The unit of the positions", "UNIT");
  text("--height-unit", words.height_unit, "The unit of the heights", "UNIT");
  text("--step", words.step, "Distance of the heights, of a file without positions", "LENGTH")->excludes(position);
  text("--sheet", words.sheet, "Of a workbook (.xlsx): the sheet, its name or number", "SHEET");
  text("--encoding", words.encoding, "utf-8, utf-16le, utf-16be, cp1252 or shift-jis", "NAME");
  text("--separator", words.separator, "Between cells: , ; tab or space", "MARK");
  text("--decimal", words.decimal, "Decimal mark: . or ,", "MARK");
  text("--thousands", words.thousands, "Between groups of digits: . , space ' or none", "MARK");
}

}  // namespace flexslip
