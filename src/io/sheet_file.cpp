#include "io/sheet_file.h"

#include <utility>

#include <fmt/format.h>

#include "io/text_file.h"

namespace flexslip {
namespace {

SheetFile sheet_of_text(std::string text, SheetOrigin origin, const SheetOptions& options, SheetFor purpose) {
  static constexpr std::string_view known = ",;\t ";
  if (options.separator && known.find(*options.separator) == std::string_view::npos)
    throw InputError({.field = "separator",
                      .expected = "a comma, a semicolon, a tab or a space",
                      .found = in_quotes(std::string_view(&*options.separator, 1))});
  const bool has_titles = purpose != SheetFor::readings;
  origin.separator = options.separator ? *options.separator
                     : has_titles      ? separator_of_titles(text)
                                       : separator_of(text);
  if (purpose == SheetFor::words && origin.separator == ' ') origin.separator = ',';  // or else one column
  return {std::move(origin), Sheet(std::move(text), origin.separator), {}};
}

SheetFile sheet_of_workbook(std::string_view bytes, SheetOrigin origin, const SheetOptions& options, SheetFor purpose) {
  WorkbookSheet sheet = read_sheet(bytes, options.sheet, purpose);
  origin.sheet = std::move(sheet.name);
  origin.sheets = std::move(sheet.sheets);
  origin.which_sheet = std::move(sheet.which);
  origin.sheet_is_chosen = options.sheet.has_value();
  origin.has_delimiters = sheet.text.has_value();
  for (const auto& [is_given, flag] :
       {std::pair{options.encoding.has_value(), "--encoding"}, std::pair{options.separator.has_value(), "--separator"}})
    if (is_given && !origin.has_delimiters)
      throw InputError({.field = flag,
                        .expected = "a text file",
                        .found = "a workbook, which needs no such choice",
                        .remedy = fmt::format("leave {} out", flag)});
  SheetFile file = sheet.text ? sheet_of_text(std::move(*sheet.text), std::move(origin), options, purpose)
                              : SheetFile{std::move(origin), std::move(sheet.cells), {}};
  file.notes = std::move(sheet.notes);
  return file;
}

SheetFile sheet_in_bytes(std::string bytes, const std::string& source, const SheetOptions& options, SheetFor purpose) {
  SheetOrigin origin{.source = source};
  if (is_packed(bytes)) return sheet_of_workbook(bytes, std::move(origin), options, purpose);
  if (options.sheet)
    throw InputError({.field = "--sheet",
                      .expected = "a workbook (.xlsx), as this names a sheet",
                      .found = "a text file",
                      .remedy = "leave it out",
                      .key = "record.sheet"});
  DecodedText decoded = decode(std::move(bytes), options.encoding);
  origin.encoding = decoded.encoding;
  origin.byte_order_mark = decoded.byte_order_mark;
  return sheet_of_text(std::move(decoded.text), std::move(origin), options, purpose);
}

}  // namespace

SheetFile sheet_in(std::string bytes, const std::string& source, const SheetOptions& options, SheetFor purpose) {
  try {
    return sheet_in_bytes(std::move(bytes), source, options, purpose);
  } catch (const InputError& error) {
    if (is_of_call(error.fault)) throw;
    throw located(error, source, error.fault.line, error.fault.field);
  }
}

SheetFile open_sheet(const std::string& path, const SheetOptions& options, SheetFor purpose) {
  return sheet_in(bytes_of(path), path == "-" ? "standard input" : path, options, purpose);
}

InputError dated(const SheetFile& file, std::size_t line, std::size_t column, std::string_view expected) {
  const CellKind kind = file.cells.kind(line, column);
  const char* what = kind == CellKind::clock ? "clock time" : kind == CellKind::date ? "date" : "date and clock time";
  return InputError({.file = file.origin.source,
                     .line = line + 1,
                     .field = fmt::format("sheet {}, cell {}", in_quotes(file.origin.sheet.value_or("")),
                                          cell_name(line + 1, column + 1)),
                     .expected = std::string(expected),
                     .found = fmt::format("the {} {}", what, file.cells.shown(line, column)),
                     .remedy = "format the cell as a number and type it again, or delete the row",
                     .part = TablePart::cell});
}

InputError with_other_sheets(const InputError& error, const SheetOrigin& origin) {
  if (!origin.sheet || origin.sheet_is_chosen || origin.sheets.size() < 2 || error.fault.part == TablePart::cell)
    return error;
  std::vector<std::string> others = origin.sheets;
  std::erase(others, *origin.sheet);
  InputFault fault = error.fault;
  fault.remedy += fmt::format("{}this is the sheet {}, and there {} also {}: read another with --sheet \"{}\"",
                              fault.remedy.empty() ? "" : "; ", in_quotes(*origin.sheet),
                              others.size() == 1 ? "is" : "are", listed(others), others.front());
  return InputError(fault);
}

}  // namespace flexslip
