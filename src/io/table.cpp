#include "io/table.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/durable_file.h"
#include "io/input_error.h"
#include "io/number_format.h"
#include "io/sheet_file.h"
#include "io/statistics_rows.h"
#include "io/text.h"

namespace flexslip {
namespace {

bool is_number_with(char decimal, std::string_view cell) { return !std::isnan(number_in(cell, {decimal})); }

// True for a special number, which no column may contain: "nan", "-inf", "1e999".
bool is_not_finite(std::string_view cell) {
  const std::optional<double> value = plain_number(cell);
  return value && !std::isfinite(*value);
}

bool names_unit(std::string_view text) { return text == "1" || text == "-" || unit_named(text); }

// The title of a column in a file. A unit is at the end, in either kind of brackets; otherwise all
// of the text is a name.
ColumnTitle title_in_header(std::string_view text) {
  const std::size_t open = text.find_last_of("[(");
  if (open == std::string_view::npos || open == 0) return {std::string(text), ""};
  const std::string_view bracketed = text.substr(open);
  const std::string_view unit = without_brackets(bracketed);
  if (unit.size() == bracketed.size() || !names_unit(unit)) return {std::string(text), ""};
  return {std::string(trimmed(text.substr(0, open))), std::string(unit)};
}

struct HeaderCell {
  std::string text;  // unchanged
  ColumnTitle title;
  std::string_view name_before_unit() const;  // of brackets at the end without a unit; otherwise empty
};

std::string_view HeaderCell::name_before_unit() const {
  const std::size_t open = text.find_last_of("[(");
  if (open == std::string::npos || open == 0 || !title.unit.empty()) return {};
  return without_brackets(std::string_view(text).substr(open)).size() < text.size() - open
             ? trimmed(std::string_view(text).substr(0, open))
             : std::string_view{};
}

// A requested column, found in the file.
struct Source {
  std::size_t cell;   // index in a line
  std::string field;  // for messages
  Kind kind;
  std::vector<std::string> units;  // all stated units: in the requested title, the header, the line of units
};

struct Header {
  std::size_t line;  // from 0
  std::vector<HeaderCell> cells;
};

// The input of the steps.
struct Opened {
  const SheetFile& file;
  char decimal;  // of words

  const Sheet& sheet() const { return file.cells; }
  bool is_row(std::size_t line) const { return !sheet().is_comment(line) && !sheet().is_blank(line); }

  // A number of a workbook, or one with the decimal mark of the table; otherwise NaN.
  double number(std::size_t line, std::size_t column, CellKind kind) const {
    return number_in(sheet().at(line, column), {kind == CellKind::word ? decimal : '.'});
  }
  // True for a number, or for a special one: "nan", "-inf".
  bool has_number(std::size_t line, std::size_t column) const {
    return !std::isnan(number(line, column, sheet().kind(line, column))) || is_not_finite(sheet().at(line, column));
  }

  // Lines count from 0.
  [[noreturn]] void refuse(std::size_t line, std::string field, std::string problem, std::string remedy,
                           TablePart part = TablePart::none) const {
    throw InputError({.file = file.origin.source,
                      .line = line + 1,
                      .field = std::move(field),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy),
                      .part = part});
  }
};

// Lines that are rows, with paired quotes.
std::optional<std::size_t> next_row(const Opened& opened, std::size_t line) {
  while (line < opened.sheet().size() && !opened.is_row(line)) ++line;
  if (line == opened.sheet().size()) return std::nullopt;
  if (const std::size_t cell = opened.sheet().stray_quote(line); cell > 0)
    opened.refuse(line, "", fmt::format("Cell {} holds a stray quote: quotes come in pairs around a whole cell", cell),
                  "delete it");
  return line;
}

Header header_of(const Opened& opened) {
  const std::optional<std::size_t> line = next_row(opened, 0);
  if (!line)
    throw InputError({.file = opened.file.origin.source,
                      .problem = opened.sheet().size() == 0 ? "The file is empty" : "No line of the file has content"});
  Header header{*line, {}};
  bool all_numbers = true;
  const auto cells = opened.sheet().cells(*line);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::string text(cells[i]);
    // "w_s [m] F [N]": the space before a unit does not separate.
    if (opened.file.origin.separator == ' ' && !header.cells.empty() && text.starts_with('[')) {
      text = header.cells.back().text + " " + text;
      header.cells.pop_back();
    }
    all_numbers = all_numbers && (cells[i].empty() || opened.has_number(*line, i));
    header.cells.push_back({text, title_in_header(text)});
  }
  if (all_numbers)
    opened.refuse(*line, "", "This line holds numbers, where the names of the columns are needed",
                  "add one above, such as \"w_s [m],F [N]\"");
  while (header.cells.back().text.empty())
    header.cells.pop_back();  // a separator at the end of the line starts no column
  return header;
}

InputError missing_column(const Opened& opened, const Header& header, const std::string& name,
                          const std::string& field) {
  std::vector<std::string> names;
  for (const HeaderCell& cell : header.cells) names.push_back(cell.title.name);
  return InputError({.file = opened.file.origin.source,
                     .line = header.line + 1,
                     .field = field,
                     .problem = "No column has this name; the file has " + listed(names),
                     .remedy = did_you_mean(name, names),
                     .part = TablePart::title});
}

// The text after the last underscore of a name without a unit: "m" of "w_s_m".
std::string_view end_of(std::string_view name) {
  const std::size_t at = name.rfind('_');
  return at == std::string_view::npos || at == 0 ? std::string_view{} : name.substr(at + 1);
}

// True if a name requested without a unit matches a column whose name ends in its unit.
bool is_before_end(const ColumnTitle& asked, const Kind& kind, std::string_view name) {
  const std::string_view end = end_of(name);
  if (!asked.unit.empty() || end.empty() || name.substr(0, name.size() - end.size() - 1) != asked.name) return false;
  const std::optional<Unit> unit = unit_named(end);
  return unit && unit->dimension == kind.dimension && kind.name != kind::number.name;
}

std::vector<Source> sources_of(const Opened& opened, const Header& header, const std::vector<WantedColumn>& wanted) {
  std::vector<Source> sources;
  for (const WantedColumn& each : wanted) {
    const ColumnTitle asked = parse_column_title(each.title);
    std::vector<std::size_t> by_text, by_name, by_name_before_unit;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
      const HeaderCell& cell = header.cells[i];
      if (cell.name_before_unit() == asked.name || is_before_end(asked, each.kind, cell.title.name))
        by_name_before_unit.push_back(i);
      if (cell.text == trimmed(each.title)) by_text.push_back(i);
      if (cell.title.name == asked.name || cell.text == asked.name) by_name.push_back(i);
    }
    const std::vector<std::size_t>& found = !by_text.empty()   ? by_text
                                            : !by_name.empty() ? by_name
                                                               : by_name_before_unit;
    const std::string field = "column " + in_quotes(asked.name);
    if (found.empty()) throw missing_column(opened, header, asked.name, field);
    if (found.size() > 1)
      opened.refuse(header.line, field, fmt::format("{} columns have this name", found.size()), "rename them");
    for (const Source& other : sources)
      if (other.cell == found[0]) opened.refuse(header.line, field, "The same column is asked for twice", "");
    Source source{found[0], field, each.kind, {}};
    for (const std::string& unit : {asked.unit, header.cells[found[0]].title.unit})
      if (!unit.empty()) source.units.push_back(unit);
    sources.push_back(std::move(source));
  }
  return sources;
}

// True for a line of units: the requested columns have words instead of numbers.
bool is_unit_line(const Opened& opened, const std::vector<Source>& sources, std::size_t line) {
  bool words = false;
  bool numbers = false;
  for (const Source& source : sources) {
    const std::string_view cell = opened.sheet().at(line, source.cell);
    if (cell.empty()) continue;
    const bool starts_as_number = std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
    const bool word =
        !opened.has_number(line, source.cell) && (!starts_as_number || names_unit(without_brackets(cell)));
    (word ? words : numbers) = true;
  }
  return words && !numbers;
}

// The unit of a requested column, on which all sources must agree, and its note.
struct AgreedUnit {
  Unit unit;
  std::string note{};
};

AgreedUnit agreed_unit(const Opened& opened, const Header& header, const Source& source) {
  const std::string& name = header.cells[source.cell].title.name;
  const auto as_in = [&] { return fmt::format("such as \"{} [{}]\"", name, source.kind.units.back()); };
  const bool is_stated = !source.units.empty() || source.kind.name == kind::number.name;
  const std::string_view end = is_stated ? std::string_view{} : end_of(name);
  if (const std::optional<Unit> unit = unit_named(end)) {
    if (unit->dimension == source.kind.dimension)
      return {*unit, fmt::format("the unit of '{}' is the end of its name, {}", name, end)};
    if (unit->dimension == kind::length.dimension || unit->dimension == kind::force.dimension)
      opened.refuse(header.line, source.field,
                    fmt::format("The name ends in {}, which is not a unit of {}", in_quotes(end), noun(source.kind)),
                    fmt::format("if it is {} all the same, name it with its unit, {}", source.kind.name, as_in()));
  }
  try {
    const Unit unit = parse_unit(source.units.empty() ? "" : source.units.front(), source.kind);
    for (const std::string& other : source.units)
      if (parse_unit(other, source.kind) != unit)
        throw InputError({.problem = fmt::format("The units {} contradict each other", listed(source.units)),
                          .remedy = "the file and the title asked for must agree"});
    return {unit};
  } catch (const InputError& error) {
    InputFault fault = located(error, opened.file.origin.source, header.line + 1, source.field).fault;
    const HeaderCell& cell = header.cells[source.cell];
    const std::string_view before = cell.name_before_unit();
    const std::string stated =
        before.empty()
            ? ""
            : std::string(without_brackets(std::string_view(cell.text).substr(cell.text.find_last_of("[("))));
    const std::vector<std::string_view> meant =
        meant_units(stated.empty() && !source.units.empty() ? source.units.front() : stated, source.kind);
    if (!stated.empty() && source.units.size() < 2 && source.kind.dimension != Dimension{})
      fault.problem = fmt::format("{} is not a unit of {}", in_quotes(stated), noun(source.kind));
    if (source.units.empty() || !meant.empty())
      fault.remedy = fmt::format("{}name it with its unit, such as \"{} [{}]\"",
                                 meant.empty() ? "" : fmt::format("if {} is meant, ", fmt::join(meant, " or ")),
                                 before.empty() ? std::string_view(name) : before,
                                 meant.empty() ? source.kind.units.back() : meant.front());
    throw InputError(fault);
  }
}

std::string remedy_for_cell(std::string_view cell, char decimal) {
  const bool comma = cell.find(',') != std::string_view::npos;
  if (comma && decimal == '.' && is_number_with(',', cell)) return "write decimal points, or pass --decimal ,";
  if (!comma && decimal == ',' && is_number_with('.', cell)) return "write decimal commas, or leave out --decimal ,";
  std::string digits(cell);
  std::erase_if(digits, [](char c) { return c == ',' || c == '.'; });
  if (comma && is_number_with('.', digits)) return "write no thousands separators";
  return "";
}

[[noreturn]] void refuse_cell(const Opened& opened, std::size_t line, const Source& source) {
  const std::string_view cell = opened.sheet().at(line, source.cell);
  const bool is_infinite = is_not_finite(cell);
  opened.refuse(line, source.field,
                cell.empty()
                    ? "The cell is empty"
                    : fmt::format("{} is not {}", in_quotes(cell), is_infinite ? "a finite number" : "a number"),
                cell.empty()  ? "fill it in or delete the line"
                : is_infinite ? "delete the line"
                              : remedy_for_cell(cell, opened.decimal),
                TablePart::cell);
}

// True for as many cells as the header, or empty ones beyond.
void require_count(const Opened& opened, const Header& header, std::size_t line) {
  const Sheet::Cells cells = opened.sheet().cells(line);
  const std::size_t count = header.cells.size();
  bool has_surplus = false;
  for (std::size_t i = count; i < cells.size(); ++i) has_surplus = has_surplus || !cells[i].empty();
  if (cells.size() >= count && !has_surplus) return;
  const bool perhaps_commas = opened.file.origin.separator == ',' && cells.size() > count;
  opened.refuse(line, "",
                fmt::format("The line has {} cell{}, but the header on line {} has {}", cells.size(),
                            cells.size() == 1 ? "" : "s", header.line + 1, count),
                perhaps_commas
                    ? "if these are decimal commas, write decimal points, or separate cells by ; and pass --decimal ,"
                    : "");
}

// The rows of numbers, and the rows that only have words for statistics. Lines count from 0.
struct NumberRows {
  std::vector<std::size_t> lines;
  std::vector<std::vector<double>> columns;  // [SI]
  std::vector<std::size_t> statistics;
};

NumberRows rows_from(std::optional<std::size_t> row, const Opened& opened, const Header& header,
                     const std::vector<Source>& sources, const std::vector<Unit>& units) {
  NumberRows out{{}, std::vector<std::vector<double>>(sources.size()), {}};
  std::vector<double> values(sources.size());
  const std::size_t most = opened.sheet().size() - header.line;
  out.lines.reserve(most);
  for (std::vector<double>& column : out.columns) column.reserve(most);
  for (; row; row = next_row(opened, *row + 1)) {
    const Source* lacking = nullptr;  // the first without a number
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const std::size_t cell = sources[i].cell;
      const CellKind kind = opened.sheet().kind(*row, cell);
      if (is_dated(kind)) throw dated(opened.file, *row, cell, "a number in the " + sources[i].field);
      values[i] = opened.number(*row, cell, kind);
      if (std::isnan(values[i]) && (lacking == nullptr || cell < lacking->cell)) lacking = &sources[i];
    }
    require_count(opened, header, *row);
    if (lacking != nullptr && names_statistic(label_of(opened.sheet(), *row))) {
      out.statistics.push_back(*row);
      continue;
    }
    if (lacking != nullptr) refuse_cell(opened, *row, *lacking);
    out.lines.push_back(*row);
    for (std::size_t i = 0; i < values.size(); ++i) out.columns[i].push_back(to_si(values[i], units[i]));
  }
  if (out.lines.empty()) opened.refuse(header.line, "", "The file has a header only, and no rows of numbers", "");
  return out;
}

// The requested columns of a sheet. Nothing is guessed, because the user names them.
Table recognise(const Opened& opened, const std::vector<WantedColumn>& wanted) {
  const Header header = header_of(opened);
  std::vector<Source> sources = sources_of(opened, header, wanted);
  std::optional<std::size_t> row = next_row(opened, header.line + 1);
  if (row && is_unit_line(opened, sources, *row)) {
    for (Source& source : sources)
      if (const std::string_view unit = opened.sheet().at(*row, source.cell); !unit.empty())
        source.units.emplace_back(without_brackets(unit));
    row = next_row(opened, *row + 1);
  }
  Table table{opened.file.origin.source, {}, {}, opened.file.notes};
  std::vector<Unit> units;
  for (const Source& source : sources) {
    AgreedUnit agreed = agreed_unit(opened, header, source);
    units.push_back(agreed.unit);
    if (!agreed.note.empty()) table.notes.push_back(std::move(agreed.note));
  }
  NumberRows rows = rows_from(row, opened, header, sources, units);
  auto& [lines, columns, statistics] = rows;
  const StatisticsRows left_out = statistics_among(opened.sheet(), lines, columns, std::move(statistics));
  table.notes.insert(table.notes.end(), left_out.notes.begin(), left_out.notes.end());
  for (std::size_t i = 0; i < sources.size(); ++i)
    table.columns.push_back(
        {header.cells[sources[i].cell].title.name, without_rows(std::move(columns[i]), left_out.rows)});
  table.lines = without_rows(std::move(lines), left_out.rows);
  for (std::size_t& line : table.lines) ++line;  // counted from 1
  return table;
}

Table recognise(const SheetFile& file, const std::vector<WantedColumn>& wanted, char decimal) {
  if (wanted.empty()) throw std::invalid_argument("read_table: no column wanted");
  if (decimal != '.' && decimal != ',')
    throw std::invalid_argument(fmt::format("read_table: decimal mark '{}'", decimal));
  try {
    return recognise(Opened{file, decimal}, wanted);
  } catch (const InputError& error) {
    throw with_other_sheets(error, file.origin);
  }
}

void append_word(fmt::memory_buffer& text, std::string_view word, const CsvMarks& marks) {
  if (word.find_first_of("\"\r\n") == std::string_view::npos &&
      word.find(marks.separator()) == std::string_view::npos) {
    text.append(word);
    return;
  }
  text.push_back('"');
  for (const char c : word) {
    if (c == '"') text.push_back('"');
    text.push_back(c);
  }
  text.push_back('"');
}

void append_cell(fmt::memory_buffer& text, const Cell& cell, const CsvMarks& marks) {
  if (const auto* number = std::get_if<double>(&cell)) {
    const std::size_t begin = text.size();
    fmt::format_to(fmt::appender(text), "{}", *number);
    std::replace(text.begin() + begin, text.end(), '.', marks.decimal);
  } else {
    append_word(text, std::get<std::string>(cell), marks);
  }
}

}  // namespace

ColumnTitle parse_column_title(std::string_view title) {
  const std::string_view body = trimmed(title);
  const std::size_t open = body.ends_with(']') ? body.rfind('[') : std::string_view::npos;
  const std::string_view name = trimmed(body.substr(0, open));
  if (name.empty())
    throw InputError({.problem = fmt::format("{} is not the name of a column", in_quotes(title)),
                      .remedy = "write it as in \"F_N [N]\""});
  if (open == std::string_view::npos) return {std::string(name), ""};
  const std::string_view unit = without_brackets(body.substr(open));
  if (!names_unit(unit)) parse_unit(unit);  // reports what is wrong with it
  return {std::string(name), std::string(unit)};
}

std::size_t Table::file_row(std::size_t row) const {
  for (const std::size_t missing : missing_rows) {
    if (missing > row) break;
    ++row;
  }
  return row;
}

std::size_t Table::rows_before(std::size_t file_row) const {
  return file_row - static_cast<std::size_t>(std::lower_bound(missing_rows.begin(), missing_rows.end(), file_row) -
                                             missing_rows.begin());
}

Table read_table(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal,
                 const std::optional<SheetChoice>& sheet) {
  return recognise(open_sheet(path, {.sheet = sheet}, SheetFor::titled_readings), wanted, decimal);
}

Table table_in(std::string bytes, const std::string& source, const std::vector<WantedColumn>& wanted, char decimal) {
  return recognise(sheet_in(std::move(bytes), source, {}, SheetFor::titled_readings), wanted, decimal);
}

TextTable read_text_table(const std::string& path) {
  const SheetFile file = open_sheet(path, {}, SheetFor::words);
  const Opened opened{file, '.'};
  TextTable table{.source = file.origin.source, .header_line = 0, .titles = {}, .rows = {}};
  const auto refuse = [&](std::size_t line, std::string problem, std::string remedy) {
    throw InputError({.file = table.source, .line = line, .problem = std::move(problem), .remedy = std::move(remedy)});
  };
  for (auto row = next_row(opened, 0); row; row = next_row(opened, *row + 1)) {
    std::vector<std::string> cells;
    for (const std::string_view cell : file.cells.cells(*row)) {
      if (is_dated(file.cells.kind(*row, cells.size()))) throw dated(file, *row, cells.size(), "a number or words");
      cells.push_back(with_formula(std::string(cell)));
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    if (table.titles.empty()) {
      table.header_line = *row + 1;
      table.titles = std::move(cells);
      continue;
    }
    if (cells.size() > table.titles.size())
      refuse(*row + 1, fmt::format("The line has {} cells, but the header has {}", cells.size(), table.titles.size()),
             "put a cell that holds the delimiter in quotes");
    cells.resize(table.titles.size());
    table.rows.push_back({*row + 1, std::move(cells)});
  }
  if (table.titles.empty()) refuse(0, "The file is empty", "");
  for (auto title = table.titles.begin(); title != table.titles.end(); ++title) {
    if (title->empty()) refuse(table.header_line, "A column has no title", "");
    if (std::find(table.titles.begin(), title, *title) != title)
      refuse(table.header_line, fmt::format("The title {} occurs twice", in_quotes(*title)), "");
  }
  return table;
}

void write_table(std::ostream& out, const std::vector<std::string>& titles, const NextRow& next,
                 const CsvMarks& marks) {
  constexpr std::size_t block = 1 << 16;  // [bytes] written to the stream at a time
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (i > 0) text.push_back(marks.separator());
    append_word(text, titles[i], marks);
  }
  text.push_back('\n');
  for (std::vector<Cell> cells; next(cells);) {
    if (cells.size() != titles.size())
      throw std::invalid_argument(fmt::format("write_table: {} cells under {} titles", cells.size(), titles.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text.push_back(marks.separator());
      append_cell(text, cells[i], marks);
    }
    text.push_back('\n');
    if (text.size() < block) continue;
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  }
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.flush();
  if (!out) throw InputError({.problem = "The table could not be written"});
}

void write_table(const std::string& path, const std::vector<std::string>& titles, const NextRow& next,
                 const CsvMarks& marks) {
  OutputFile file(path);
  try {
    write_table(file.stream(), titles, next, marks);
  } catch (const InputError& error) {
    throw located(error, path == "-" ? "standard output" : path, 0, "");
  }
  file.finish();
}

}  // namespace flexslip
