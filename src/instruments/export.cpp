#include "instruments/export.h"

#include <cmath>
#include <istream>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "instruments/column_flags.h"
#include "instruments/column_unit.h"
#include "instruments/export_reader.h"
#include "instruments/voltage.h"
#include "io/input_error.h"
#include "io/table.h"
#include "io/workbook.h"

namespace flexslip {
namespace {

// The options as they are for a sheet: its cells are apart. Its decimal mark is that of numbers kept as words.
ExportOptions options_for(const WorkbookSheet& sheet, ExportOptions options) {
  if (sheet.holds == SheetHolds::lines_of_text) return options;
  for (const auto& [is_given, flag] :
       {std::pair{options.encoding.has_value(), "--encoding"}, std::pair{options.separator.has_value(), "--separator"}})
    if (is_given)
      throw InputError({.field = flag,
                        .expected = "a text file",
                        .found = "a workbook, which needs no such choice",
                        .remedy = fmt::format("leave {} out", flag)});
  options.separator = '\t';
  return options;
}

Export read_workbook(std::string_view bytes, const std::string& source, const ExportOptions& options) {
  WorkbookSheet sheet = read_sheet(bytes, options.sheet);
  const DecodedText text{std::move(sheet.text), Encoding::utf8, false};
  try {
    return export_in(text, source, options_for(sheet, options), sheet);
  } catch (const InputError& error) {
    if (sheet.is_chosen) throw;
    throw with_other_sheets(error, sheet.name, sheet.sheets);
  }
}

}  // namespace

Export read_export(std::string_view bytes, const std::string& source, const ExportOptions& options) {
  try {
    if (is_packed(bytes)) return read_workbook(bytes, source, options);
    if (options.sheet)
      throw InputError({.field = "--sheet",
                        .expected = "a workbook (.xlsx), as this names a sheet",
                        .found = "a text file",
                        .remedy = "leave it out",
                        .key = "record.sheet"});
    const DecodedText decoded = decode(bytes, options.encoding);
    if (decoded.text.find_first_not_of(" \t\r\n") == std::string::npos)
      throw InputError({.expected = "rows of numbers",
                        .found = decoded.byte_order_mark ? "an empty file: a byte order mark and nothing else"
                                 : bytes.empty()         ? "an empty file"
                                                         : "an empty file: blanks only",
                        .remedy = "export the test again"});
    return export_in(decoded, source, options);
  } catch (const InputError& error) {
    const bool is_of_call = error.fault.field.starts_with("--") && error.fault.key.empty();
    if (!error.fault.file.empty() || is_of_call) throw;
    throw located(error, source, error.fault.line, error.fault.field);
  }
}

Export read_export(const std::string& path, const ExportOptions& options) {
  const auto in = open_to_read(path);
  const std::string bytes{std::istreambuf_iterator<char>(*in), std::istreambuf_iterator<char>()};
  return read_export(bytes, path == "-" ? "standard input" : path, options);
}

std::vector<double> in_si(const Export& file, const ExportedSpecimen& specimen, const ExportColumn& column,
                          const Kind& kind) {
  const auto refuse = [&](std::size_t line, std::string expected, std::string found, std::string remedy) {
    throw InputError({file.source, line, "column " + in_quotes(column.name), std::move(expected), std::move(found),
                      std::move(remedy)});
  };
  const std::optional<Unit> unit = machine_unit(column.unit);
  const std::string wanted = fmt::format("a unit of {}", kind.name.substr(kind.name.find(' ') + 1));
  const std::string remedy = fmt::format("state it with {}, as in {} {}", unit_flag_of(column.role),
                                         unit_flag_of(column.role), usual_unit(column.role));
  if (is_voltage(column.unit))
    refuse(0, wanted, in_quotes(column.unit), "give its calibration, as in --calibration \"222 N/V\"");
  if (!unit) refuse(0, wanted, column.unit.empty() ? "none" : in_quotes(column.unit) + ", which is unknown", remedy);
  if (unit->dimension != kind.dimension) refuse(0, wanted, in_quotes(column.unit), remedy);
  std::vector<double> values;
  values.reserve(column.values.size());
  for (std::size_t row = 0; row < column.values.size(); ++row) {
    if (std::isnan(column.values[row]))
      throw InputError({.file = file.source,
                        .line = specimen.lines[row],
                        .field = "column " + in_quotes(column.name),
                        .expected = "a number",
                        .found = "none",
                        .remedy = "delete the line",
                        .part = TablePart::cell});
    values.push_back(to_si(column.values[row], *unit));
  }
  return values;
}

const ExportColumn& column_with(const Export& file, const ExportedSpecimen& specimen, ColumnRole role) {
  std::vector<std::string> names;
  std::vector<std::string> all;
  const ExportColumn* found = nullptr;
  for (const ExportColumn& column : specimen.columns) {
    all.push_back(column.name);
    if (column.role != role) continue;
    found = &column;
    names.push_back(column.name);
  }
  if (found != nullptr && names.size() == 1) return *found;
  throw InputError({.file = file.source,
                    .field = std::string(word_for(role)),
                    .expected = "one column with it",
                    .found = names.empty() ? "no name that says so among " + listed(all) : "several: " + listed(names),
                    .remedy = fmt::format("say which with {} COLUMN", flag_of(role))});
}

}  // namespace flexslip
