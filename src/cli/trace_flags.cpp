#include "cli/trace_flags.h"

#include <string>

namespace flexslip {

void add_trace_options(CLI::App& command, TraceWords& words) {
  const auto text = [&](const char* name, std::string& value, const char* description, const char* type) {
    return command.add_option(name, value, description)->type_name(type)->group("How the trace is read");
  };
  auto* position = text("--position", words.position, "Column of positions, by name or number", "COLUMN");
  text("--height", words.height, "Column of heights, by name or number", "COLUMN");
  text("--position-unit", words.position_unit, "Unit of positions", "UNIT");
  text("--height-unit", words.height_unit, "Unit of heights", "UNIT");
  text("--step", words.step, "Distance between heights, for a file without positions", "LENGTH")->excludes(position);
  text("--sheet", words.sheet, "Sheet of a workbook (.xlsx), by name or number", "SHEET");
  text("--encoding", words.encoding, "Encoding of the text: utf-8, utf-16le, utf-16be, cp1252 or shift-jis", "NAME");
  text("--separator", words.separator, "Separator between cells: , ; tab or space", "MARK");
  text("--decimal", words.decimal, "Decimal mark: . or ,", "MARK");
  text("--thousands", words.thousands, "Thousands separator: . , space ' or none", "MARK");
}

}  // namespace flexslip
