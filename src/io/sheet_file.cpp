#include "io/sheet_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "io/number_format.h"
#include "io/text.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

// Spreadsheets keep digits unchanged in ="1.23". The = before a quote at the start of a cell is not
// part of the text.
void make_formulas_words(std::string& text) {
  static constexpr std::string_view before_cells = ",;\t \n\r";
  for (std::size_t at = text.find("=\""); at != std::string::npos; at = text.find("=\"", at + 1))
    if (at == 0 || before_cells.find(text[at - 1]) != std::string_view::npos) text[at] = ' ';
}

// ---- commas between cells and before decimals

using Parts = std::vector<std::string_view>;

Parts parts_of(std::string_view line, char separator) {
  Parts parts;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    parts.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  while (parts.size() > 1 && parts.back().empty()) parts.pop_back();
  return parts;
}

bool are_digits(std::string_view text) { return !text.empty() && std::all_of(text.begin(), text.end(), is_digit); }

// True for a whole number with an optional sign, or after a comma with an exponent.
bool are_whole(const Parts& parts) {
  return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), [](std::string_view part) {
           if (part.starts_with('-') || part.starts_with('+')) part.remove_prefix(1);
           const std::size_t exponent = std::min(part.find_first_of("eE"), part.size());
           std::string_view power = part.substr(std::min(exponent + 1, part.size()));
           if (power.starts_with('-') || power.starts_with('+')) power.remove_prefix(1);
           return are_digits(part.substr(0, exponent)) && (exponent == part.size() || are_digits(power));
         });
}

// True for digits that no whole number has, and that are therefore decimals.
bool begins_with_zero(std::string_view part) { return part.size() > 1 && part.front() == '0' && is_digit(part[1]); }

// The text with semicolons between cells, if its commas separate both cells and decimals: n titles,
// and 2n whole numbers in each row, some with a leading zero as decimals. Otherwise nullopt.
// Fails:      InputError if rows have different numbers of cells, as if some numbers have no
//             decimals.
std::optional<std::string> with_semicolons(std::string_view text) {
  constexpr std::size_t fewest = 2, longest_preamble = 200;  // lines
  std::string_view header, first_row;
  std::size_t titles = 0, others = 0, rows = 0, least = 0, most = 0;
  bool has_decimals = false, are_pairs = true;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (trimmed(line).empty()) continue;
    const Parts parts = parts_of(line, ',');
    if (!are_whole(parts)) {
      if (rows >= fewest || ++others > longest_preamble)
        return std::nullopt;  // another number of cells, or words, within the rows
      titles = parts.size();
      header = line;
      rows = 0;
      continue;
    }
    if (rows++ == 0) {
      first_row = line;
      least = most = parts.size();
      has_decimals = false;
      are_pairs = true;
    }
    least = std::min(least, parts.size());
    most = std::max(most, parts.size());
    if (rows >= longest_preamble && most <= titles) return std::nullopt;
    for (std::size_t part = 1; part < parts.size(); ++part) {
      has_decimals = has_decimals || begins_with_zero(parts[part]);
      are_pairs = are_pairs && (part % 2 == 0 || is_digit(parts[part].front()));
    }
  }
  if (rows < fewest || titles < 2 || !has_decimals || most <= titles || most > 2 * titles) return std::nullopt;
  const Parts names = parts_of(header, ',');
  if (std::any_of(names.begin(), names.end(), [](std::string_view name) { return !number_cell(name).number.empty(); }))
    return std::nullopt;
  const auto above = static_cast<std::size_t>(first_row.data() - text.data());
  if (least < most || most < 2 * titles || !are_pairs)
    throw InputError(
        {.line = 1 + static_cast<std::size_t>(
                         std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(above), '\n')),
         .problem = fmt::format("Commas separate cells and decimals alike: {} titles above rows of {}{} whole numbers",
                                titles, least < most ? fmt::format("{} to ", least) : "", most),
         .remedy = "export it with semicolons or tabs between cells, or with decimal points"});
  std::string out(text);
  bool is_decimal = true;  // true if the next comma follows a whole number
  for (std::size_t at = 0; at < out.size(); ++at) {
    if (out[at] == '\n' || out[at] == '\r') is_decimal = true;
    if (out[at] != ',') continue;
    if (at < above || !is_decimal) out[at] = ';';
    if (at >= above) is_decimal = !is_decimal;
  }
  return out;
}

SheetFile sheet_of_text(std::string text, SheetOrigin origin, const SheetOptions& options, SheetFor purpose) {
  static constexpr std::string_view known = ",;\t ";
  if (options.separator && known.find(*options.separator) == std::string_view::npos)
    throw InputError({.field = "separator",
                      .problem = fmt::format("{} is not a comma, a semicolon, a tab or a space",
                                             in_quotes(std::string_view(&*options.separator, 1)))});
  make_formulas_words(text);
  const bool has_titles = purpose != SheetFor::readings;
  origin.separator = options.separator ? *options.separator
                     : has_titles      ? separator_of_titles(text)
                                       : separator_of(text);
  if (purpose == SheetFor::words && origin.separator == ' ') origin.separator = ',';  // otherwise one column
  if (!has_titles && origin.separator == ',')
    if (std::optional<std::string> apart = with_semicolons(text))
      return {std::move(origin),
              Sheet(std::move(*apart), ';'),
              {"commas separate cells and decimals alike: of the numbers in a row each two are one"}};
  return {std::move(origin), Sheet(std::move(text), origin.separator), {}};
}

SheetFile sheet_of_workbook(std::string_view bytes, SheetOrigin origin, const SheetOptions& options, SheetFor purpose) {
  WorkbookSheet sheet = read_sheet(bytes, options.sheet, purpose);
  origin.sheet = std::move(sheet.name);
  origin.sheets = std::move(sheet.sheets);
  origin.alike = std::move(sheet.alike);
  origin.which_sheet = std::move(sheet.which);
  origin.sheet_is_chosen = options.sheet.has_value();
  origin.has_delimiters = sheet.text.has_value();
  for (const auto& [is_given, flag] :
       {std::pair{options.encoding.has_value(), "--encoding"}, std::pair{options.separator.has_value(), "--separator"}})
    if (is_given && !origin.has_delimiters)
      throw InputError({.field = flag,
                        .problem = "The file is a workbook, which needs no such choice",
                        .remedy = fmt::format("leave out {}", flag)});
  SheetFile file = sheet.text ? sheet_of_text(std::move(*sheet.text), std::move(origin), options, purpose)
                              : SheetFile{std::move(origin), std::move(sheet.cells), {}};
  file.notes = std::move(sheet.notes);
  return file;
}

// Files without a text table, recognised by their first bytes.
void refuse_other_kinds(std::string_view bytes) {
  const auto refuse = [](std::string found, std::string remedy) {
    throw InputError({.problem = fmt::format("The file is {}, not a table as text or an Excel workbook (.xlsx)", found),
                      .remedy = std::move(remedy)});
  };
  if (bytes.starts_with("\x1f\x8b"))
    refuse("a compressed file, as testXpert keeps its tests (.zs2)",
           "export the curves from testXpert as .xlsx or as ASCII; a file .gz is unpacked with gunzip");
  const std::size_t first = std::min(bytes.find_first_not_of("\xef\xbb\xbf \t\r\n"), bytes.size());
  const std::string begin = folded(bytes.substr(first, 20));
  for (const std::string_view mark : {"<?xml", "<html", "<!doctype", "<table"})
    if (begin.starts_with(mark))
      refuse("a page in HTML or XML, as some programs write it under the name .xls",
             "open it in a spreadsheet program, and save it as .xlsx or CSV");
  struct Kind {
    std::string_view mark, name, remedy;
  };
  static constexpr std::array kinds{
      Kind{"%PDF", "a PDF", "export the readings as CSV or .xlsx"},
      Kind{"TDSm", "a file of LabVIEW (.tdms)", "export the channels as text, from LabVIEW or with nptdms in Python"},
      Kind{"MATLAB 5.0", "a file of MATLAB (.mat)", "write the columns as CSV: writematrix([t w F], \"test.csv\")"},
      Kind{"\x89HDF", "a file of HDF5, as MATLAB 7.3 writes (.mat)", "write the columns as CSV"},
      Kind{"SQLite format", "a database (SQLite)", "export the readings as CSV"},
      Kind{"Rar!", "an archive", "unpack it"},
      Kind{"7z\xbc\xaf", "an archive", "unpack it"}};
  for (const Kind& kind : kinds)
    if (bytes.starts_with(kind.mark)) refuse(std::string(kind.name), std::string(kind.remedy));
}

SheetFile sheet_in_bytes(std::string bytes, const std::string& source, const SheetOptions& options, SheetFor purpose) {
  SheetOrigin origin{.source = source};
  refuse_other_kinds(bytes);
  if (is_packed(bytes)) return sheet_of_workbook(bytes, std::move(origin), options, purpose);
  if (options.sheet)
    throw InputError({.field = "--sheet",
                      .problem = "The file is a text file, which has no sheets",
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
  return InputError(
      {.file = file.origin.source,
       .line = line + 1,
       .field =
           fmt::format("sheet {}, cell {}", in_quotes(file.origin.sheet.value_or("")), cell_name(line + 1, column + 1)),
       .problem = fmt::format("The cell holds the {} {}, not {}", what, file.cells.shown(line, column), expected),
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
