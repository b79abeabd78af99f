#include "io/table.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "io/call_files.h"
#include "io/durable_file.h"
#include "io/input_error.h"
#include "io/number_format.h"
#include "io/sheet.h"
#include "io/statistics_rows.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t most_labelled = 1 << 16;  // rows with a label; where there are more, labels are data

bool is_number_with(char decimal, std::string_view cell) { return !std::isnan(number_in(cell, {decimal})); }

// Is the cell called a number, and none that a column may have: "nan", "-inf", "1e999"?
bool is_not_finite(std::string_view cell) {
  double value = 0;
  const auto [end, error] = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc{} && end == cell.data() + cell.size() && !std::isfinite(value);
}

bool names_unit(std::string_view text) {
  if (text == "1" || text == "-") return true;
  try {
    parse_unit(text);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// The title of a column as a file has it: a unit at the end in either kind of brackets, or else all of it is a name.
ColumnTitle title_in_header(std::string_view text) {
  const std::size_t open = text.find_last_of("[(");
  if (open == std::string_view::npos || open == 0) return {std::string(text), ""};
  const std::string_view bracketed = text.substr(open);
  const std::string_view unit = without_brackets(bracketed);
  if (unit.size() == bracketed.size() || !names_unit(unit)) return {std::string(text), ""};
  return {std::string(trimmed(text.substr(0, open))), std::string(unit)};
}

struct HeaderCell {
  std::string text;  // as it stands
  ColumnTitle title;
};

// A wanted column, found in the file.
struct Source {
  std::size_t cell;   // which one of a line
  std::string field;  // for messages
  Kind kind;
  std::vector<std::string> units;  // wherever one is stated: in the title asked for, the header, the line of units
};

// A table to read from: a text file is read as it is needed, a workbook at once.
struct OpenedTable {
  std::shared_ptr<std::istream> text;
  std::unique_ptr<const WorkbookSheet> sheet;  // of a workbook
  TableRows rows;
};

// "-" is standard input.
// Fails:      OutputClash if the call writes it; InputError if it cannot be opened, of what read_sheet refuses, and if a sheet is
//             wanted of a file that is no workbook.
OpenedTable open_table(const std::string& path, const std::optional<SheetChoice>& wanted, SheetFor purpose) {
  const std::string source = path == "-" ? "standard input" : path;
  std::shared_ptr<std::istream> text = open_to_read(path);
  std::unique_ptr<const WorkbookSheet> sheet;
  // What begins like a workbook is taken whole, as a stream need not go back.
  if (const auto first = text->peek(); first == 'P' || first == 0xd0) {
    std::string bytes{std::istreambuf_iterator<char>(*text), {}};
    if (is_packed(bytes)) try {
        sheet = std::make_unique<const WorkbookSheet>(read_sheet(bytes, wanted, purpose));
      } catch (const InputError& error) {
        throw located(error, source, error.fault.line, error.fault.field);
      }
    text = std::make_shared<std::istringstream>(sheet && sheet->text ? *sheet->text : std::move(bytes));
  }
  if (wanted && !sheet) throw no_workbook(source);
  TableRows rows = sheet && !sheet->text ? TableRows(sheet->cells, source) : TableRows(*text, source);
  return {std::move(text), std::move(sheet), std::move(rows)};
}

class TableReader {
 public:
  TableReader(TableRows& rows, char decimal, const WorkbookSheet* sheet)
      : rows_(rows), decimal_(decimal), sheet_(sheet) {}

  Table read(const std::vector<WantedColumn>& wanted) {
    read_header();
    find(wanted);
    bool has_row = rows_.next();
    if (has_row && is_unit_line()) {
      take_units();
      has_row = rows_.next();
    }
    std::vector<Unit> units;
    for (const Source& source : sources_) units.push_back(agreed_unit(source));
    Table table{.source = rows_.source(), .columns = {}, .lines = {}, .notes = {}};
    for (const Source& source : sources_) table.columns.push_back({header_[source.cell].title.name, {}});
    std::vector<double> row(sources_.size());
    for (; has_row; has_row = rows_.next()) {
      if (!read_row(row)) continue;
      if (!label_.empty() && labelled_.size() <= most_labelled)
        labelled_.push_back({table.rows(), names_statistic(label_)});
      add_line(table, rows_.number());
      for (std::size_t i = 0; i < row.size(); ++i) table.columns[i].values.push_back(to_si(row[i], units[i]));
    }
    if (table.rows() == 0) refuse(header_line_, "", "rows of numbers", "a header only", "");
    leave_out_statistics(table);
    table.notes = notes_;
    return table;
  }

 private:
  [[noreturn]] void refuse(std::size_t line, std::string field, std::string expected, std::string found,
                           std::string remedy, TablePart part = TablePart::none) const {
    InputFault fault{rows_.source(), line, std::move(field), std::move(expected), std::move(found), std::move(remedy)};
    fault.part = part;
    throw InputError(std::move(fault));
  }

  // A number of this row, which is that of a workbook or written with the mark of the table; NaN if it is none.
  double number(std::size_t column, std::string_view cell) const {
    const bool is_word = sheet_ == nullptr || sheet_->cells.kind(rows_.number() - 1, column) == CellKind::word;
    return number_in(cell, {is_word ? decimal_ : '.'});
  }

  // Likewise, or what is called one: "nan", "-inf".
  bool is_number(std::size_t column, std::string_view cell) const {
    return !std::isnan(number(column, cell)) || is_not_finite(cell);
  }

  void read_header() {
    if (!rows_.next())
      refuse(0, "", "a header line and rows of numbers", rows_.number() == 0 ? "an empty file" : "no line with content",
             "");
    header_line_ = rows_.number();
    delimiter_ = rows_.delimiter();
    bool all_numbers = true;
    const auto cells = rows_.cells(delimiter_);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::string text(cells[i]);
      const bool names_another = delimiter_ == ' ' && !header_.empty() && text.starts_with('[');
      if (names_another)
        text = header_.back().text + " " + text;  // "w_s [m] F [N]": the space before a unit separates nothing
      if (names_another) header_.pop_back();
      all_numbers = all_numbers && (cells[i].empty() || is_number(i, cells[i]));
      header_.push_back({text, title_in_header(text)});
    }
    if (all_numbers)
      refuse(header_line_, "", "a header line that names the columns", "numbers",
             "add one above, such as \"w_s [m],F [N]\"");
    while (header_.back().text.empty()) header_.pop_back();  // a delimiter at the end of the line begins no column
  }

  void find(const std::vector<WantedColumn>& wanted) {
    for (const WantedColumn& each : wanted) {
      const ColumnTitle asked = parse_column_title(each.title);
      std::vector<std::size_t> by_text;
      std::vector<std::size_t> by_name;
      for (std::size_t i = 0; i < header_.size(); ++i) {
        if (header_[i].text == trimmed(each.title)) by_text.push_back(i);
        if (header_[i].title.name == asked.name || header_[i].text == asked.name) by_name.push_back(i);
      }
      const std::vector<std::size_t>& found = by_text.empty() ? by_name : by_text;
      const std::string field = "column " + in_quotes(asked.name);
      if (found.empty()) refuse_missing(asked.name, field);
      if (found.size() > 1)
        refuse(header_line_, field, "one column", std::to_string(found.size()) + " of this name", "rename them");
      for (const Source& other : sources_)
        if (other.cell == found[0])
          refuse(header_line_, field, "another column for each quantity", "the same one asked for twice", "");
      Source source{found[0], field, each.kind, {}};
      if (!asked.unit.empty()) source.units.push_back(asked.unit);
      if (!header_[found[0]].title.unit.empty()) source.units.push_back(header_[found[0]].title.unit);
      sources_.push_back(std::move(source));
    }
  }

  [[noreturn]] void refuse_missing(const std::string& name, const std::string& field) const {
    std::vector<std::string> names;
    for (const HeaderCell& cell : header_) names.push_back(cell.title.name);
    const std::string meant = nearest(name, names);
    throw InputError({.file = rows_.source(),
                      .line = header_line_,
                      .field = field,
                      .remedy = meant.empty() ? "" : "did you mean " + in_quotes(meant) + "?",
                      .problem = "is missing: the file has " + listed(names),
                      .part = TablePart::title});
  }

  // A line of units has words where the wanted columns should have numbers.
  bool is_unit_line() {
    bool words = false;
    bool numbers = false;
    const auto cells = rows_.cells(delimiter_);
    for (const Source& source : sources_) {
      if (source.cell >= cells.size() || cells[source.cell].empty()) continue;
      const std::string_view cell = cells[source.cell];
      const bool starts_as_number = std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
      const bool word = !is_number(source.cell, cell) && (!starts_as_number || names_unit(without_brackets(cell)));
      (word ? words : numbers) = true;
    }
    return words && !numbers;
  }

  void take_units() {
    const auto cells = rows_.cells(delimiter_);
    for (Source& source : sources_)
      if (source.cell < cells.size() && !cells[source.cell].empty())
        source.units.emplace_back(without_brackets(cells[source.cell]));
  }

  // What stands behind the last underscore of a name that states no unit elsewhere, where it is a unit: "w_s_m".
  static std::string_view unit_in(std::string_view name) {
    const std::size_t at = name.rfind('_');
    if (at == std::string_view::npos || at == 0) return {};
    const std::string_view end = name.substr(at + 1);
    return names_unit(end) ? end : std::string_view{};
  }

  Unit agreed_unit(const Source& source) {
    const std::string& name = header_[source.cell].title.name;
    if (source.units.empty() && source.kind.name != kind::number.name)
      if (const std::string_view unit = unit_in(name); !unit.empty()) {
        const Dimension dimension = parse_unit(unit).dimension;
        if (dimension == source.kind.dimension) {
          notes_.push_back(fmt::format("the unit of '{}' is the end of its name, {}", name, unit));
          return parse_unit(unit, source.kind);
        }
        if (dimension == kind::length.dimension || dimension == kind::force.dimension)
          refuse(header_line_, source.field, fmt::format("{} and its unit", source.kind.name),
                 fmt::format("a name that ends in {}", in_quotes(unit)),
                 fmt::format("if it is {} all the same, name it with its unit, such as \"{} [{}]\"", source.kind.name,
                             name, source.kind.units.back()));
      }
    try {
      const Unit unit = parse_unit(source.units.empty() ? "" : source.units.front(), source.kind);
      for (const std::string& other : source.units)
        if (parse_unit(other, source.kind) != unit)
          refuse(header_line_, source.field, "one unit", listed(source.units),
                 "the file and the title asked for must agree");
      return unit;
    } catch (const InputError& error) {
      const InputError placed = located(error, rows_.source(), header_line_, source.field);
      if (!source.units.empty()) throw InputError(placed);
      InputFault fault = placed.fault;
      fault.remedy = fmt::format("name it with its unit, such as \"{} [{}]\"", name, source.kind.units.back());
      throw InputError(fault);
    }
  }

  // One line into one row; false if all its cells are empty, as spreadsheets write them below a table, or if a word stands for a
  // statistic where a number is wanted.
  bool read_row(std::vector<double>& row) {
    const auto cells = rows_.cells(delimiter_);
    const std::size_t line = rows_.number() - 1;
    const Source* lacking = nullptr;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const std::size_t at = sources_[i].cell;
      row[i] = at < cells.size() ? number(at, cells[at]) : not_a_number;
      if (std::isnan(row[i]) && (lacking == nullptr || at < lacking->cell)) lacking = &sources_[i];
      if (sheet_ != nullptr && is_dated(sheet_->cells.kind(line, at)))
        throw sheet_->dated(rows_.source(), line, at, "a number in the " + sources_[i].field);
    }
    const auto first = std::find_if(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); });
    label_ = first != cells.end() && is_label(*first) ? *first : std::string_view{};
    const bool has_surplus =
        std::any_of(cells.begin() + static_cast<std::ptrdiff_t>(std::min(cells.size(), header_.size())), cells.end(),
                    [](std::string_view cell) { return !cell.empty(); });
    const bool is_short = cells.size() < header_.size();
    if (!has_surplus && !is_short && lacking == nullptr) return true;
    if (first == cells.end()) return false;
    if (has_surplus || is_short) refuse_count(cells.size());
    if (names_statistic(label_)) {
      statistics_.push_back(rows_.number());
      return false;
    }
    refuse_cell(lacking->field, cells[lacking->cell]);
  }

  // Rows that say something of the readings, and those that may.
  void leave_out_statistics(Table& table) {
    std::vector<std::size_t> rows = rows_below_readings(labelled_, table.rows());
    const LineRun end = table.lines.back();
    const std::size_t below_break = end.row > 0 ? table.rows() - end.row : 0;
    if (rows.empty()) {
      std::vector<std::span<const double>> columns;
      for (const Column& column : table.columns) columns.emplace_back(column.values);
      for (std::size_t tail = statistics_at_end(columns, below_break); tail > 0; --tail)
        rows.push_back(table.rows() - tail);
    }
    for (const std::size_t row : rows) statistics_.push_back(table.line_of(row));
    std::sort(statistics_.begin(), statistics_.end());
    if (rows.empty() && are_few(below_break, table.rows()))
      notes_.push_back(below_a_break(end.line, end.line + below_break - 1));
    if (!statistics_.empty()) notes_.push_back(left_out_statistics(statistics_));
    if (!rows.empty()) table = without(rows, table);
  }

  static Table without(const std::vector<std::size_t>& rows, const Table& all) {
    Table kept{.source = all.source, .columns = {}, .lines = {}, .notes = {}};
    for (const Column& column : all.columns) kept.columns.push_back({column.name, {}});
    auto next = rows.begin();
    for (std::size_t row = 0; row < all.rows(); ++row) {
      if (next != rows.end() && *next == row) {
        ++next;
        continue;
      }
      add_line(kept, all.line_of(row));
      for (std::size_t i = 0; i < all.columns.size(); ++i) kept.columns[i].values.push_back(all.columns[i].values[row]);
    }
    return kept;
  }

  // The next row of a table stands on a line.
  static void add_line(Table& table, std::size_t line) {
    const std::size_t row = table.rows();
    if (table.lines.empty() || line - table.lines.back().line != row - table.lines.back().row)
      table.lines.push_back({row, line});
  }

  [[noreturn]] void refuse_count(std::size_t cells) const {
    const bool perhaps_commas = delimiter_ == ',' && cells > header_.size();
    refuse(rows_.number(), "", fmt::format("{} cells as in the header on line {}", header_.size(), header_line_),
           std::to_string(cells),
           perhaps_commas
               ? "if these are decimal commas, write decimal points, or separate cells by ; and pass --decimal ,"
               : "");
  }

  [[noreturn]] void refuse_cell(const std::string& field, std::string_view cell) const {
    const bool is_infinite = is_not_finite(cell);
    refuse(rows_.number(), field, is_infinite ? "a finite number" : "a number",
           cell.empty() ? "an empty cell" : in_quotes(cell),
           cell.empty()  ? "fill it in or delete the line"
           : is_infinite ? "delete the line"
                         : remedy_for_cell(cell),
           TablePart::cell);
  }

  std::string remedy_for_cell(std::string_view cell) const {
    const bool comma = cell.find(',') != std::string_view::npos;
    if (comma && decimal_ == '.' && is_number_with(',', cell)) return "write decimal points, or pass --decimal ,";
    if (!comma && decimal_ == ',' && is_number_with('.', cell)) return "write decimal commas, or leave out --decimal ,";
    std::string digits(cell);
    std::erase_if(digits, [](char c) { return c == ',' || c == '.'; });
    if (comma && is_number_with('.', digits)) return "write no thousands separators";
    return "";
  }

  TableRows& rows_;
  char decimal_;
  const WorkbookSheet* sheet_;  // of a workbook
  char delimiter_ = ',';
  std::size_t header_line_ = 0;
  std::vector<HeaderCell> header_;
  std::vector<Source> sources_;
  std::vector<std::string> notes_;
  std::string_view label_;               // that the row begins with
  std::vector<LabelledRow> labelled_;    // the first of them
  std::vector<std::size_t> statistics_;  // lines
};

void append_word(fmt::memory_buffer& text, std::string_view word) {
  if (word.find_first_of(",\"\r\n") == std::string_view::npos) {
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

void append_cell(fmt::memory_buffer& text, const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell))
    fmt::format_to(fmt::appender(text), "{}", *number);
  else
    append_word(text, std::get<std::string>(cell));
}

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

ColumnTitle parse_column_title(std::string_view title) {
  const std::string_view body = trimmed(title);
  const std::size_t open = body.ends_with(']') ? body.rfind('[') : std::string_view::npos;
  const std::string_view name = trimmed(body.substr(0, open));
  if (name.empty())
    throw InputError(
        {.expected = "the name of a column", .found = in_quotes(title), .remedy = "write it as in \"F_N [N]\""});
  if (open == std::string_view::npos) return {std::string(name), ""};
  const std::string_view unit = without_brackets(body.substr(open));
  if (!names_unit(unit)) parse_unit(unit);  // says what is wrong with it
  return {std::string(name), std::string(unit)};
}

std::size_t Table::line_of(std::size_t row) const {
  const auto after =
      std::upper_bound(lines.begin(), lines.end(), row, [](std::size_t r, const LineRun& run) { return r < run.row; });
  const LineRun& run = *std::prev(after);
  return run.line + (row - run.row);
}

namespace {

Table read_table(TableRows& rows, const std::vector<WantedColumn>& wanted, char decimal, const WorkbookSheet* sheet) {
  if (wanted.empty()) throw std::invalid_argument("read_table: no column wanted");
  if (decimal != '.' && decimal != ',')
    throw std::invalid_argument(fmt::format("read_table: decimal mark '{}'", decimal));
  return TableReader(rows, decimal, sheet).read(wanted);
}

}  // namespace

Table read_table(std::istream& in, std::string source, const std::vector<WantedColumn>& wanted, char decimal) {
  TableRows rows(in, std::move(source));
  return read_table(rows, wanted, decimal, nullptr);
}

Table read_table(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal,
                 const std::optional<SheetChoice>& choice) {
  auto [text, sheet, rows] = open_table(path, choice, SheetFor::readings);
  try {
    Table table = read_table(rows, wanted, decimal, sheet && !sheet->text ? sheet.get() : nullptr);
    if (sheet) table.notes.insert(table.notes.begin(), sheet->notes.begin(), sheet->notes.end());
    return table;
  } catch (const InputError& error) {
    if (!sheet || choice) throw;
    throw with_other_sheets(error, sheet->name, sheet->sheets);
  }
}

TextTable read_text_table(const std::string& path) {
  auto [text, sheet, rows] = open_table(path, {}, SheetFor::words);
  TextTable table{.source = rows.source(), .header_line = 0, .titles = {}, .rows = {}};
  const auto refuse = [&](std::size_t line, std::string expected, std::string found, std::string remedy) {
    throw InputError({table.source, line, "", std::move(expected), std::move(found), std::move(remedy)});
  };
  char delimiter = ',';
  while (rows.next()) {
    const bool is_header = table.titles.empty();
    if (is_header && rows.delimiter() != ' ') delimiter = rows.delimiter();  // or else one column
    std::vector<std::string> cells;
    for (const std::string_view cell : rows.cells(delimiter)) {
      if (sheet && is_dated(sheet->cells.kind(rows.number() - 1, cells.size())))
        throw sheet->dated(table.source, rows.number() - 1, cells.size(), "a number or words");
      cells.push_back(with_formula(std::string(cell)));
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    if (is_header) {
      table.header_line = rows.number();
      table.titles = std::move(cells);
      continue;
    }
    if (cells.size() > table.titles.size())
      refuse(rows.number(), fmt::format("{} cells, as the header has", table.titles.size()),
             std::to_string(cells.size()), "put a cell that holds the delimiter in quotes");
    cells.resize(table.titles.size());
    table.rows.push_back({rows.number(), std::move(cells)});
  }
  if (table.titles.empty()) refuse(0, "a header line that names the columns", "an empty file", "");
  for (auto title = table.titles.begin(); title != table.titles.end(); ++title) {
    if (title->empty()) refuse(table.header_line, "a title for every column", "an empty one", "");
    if (std::find(table.titles.begin(), title, *title) != title)
      refuse(table.header_line, "each title once", in_quotes(*title) + " twice", "");
  }
  return table;
}

void write_table(std::ostream& out, const std::vector<std::string>& titles, const NextRow& next) {
  constexpr std::size_t block = 1 << 16;  // [bytes] handed to the stream at a time
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (i > 0) text.push_back(',');
    append_word(text, titles[i]);
  }
  text.push_back('\n');
  for (std::vector<Cell> cells; next(cells);) {
    if (cells.size() != titles.size())
      throw std::invalid_argument(fmt::format("write_table: {} cells under {} titles", cells.size(), titles.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text.push_back(',');
      append_cell(text, cells[i]);
    }
    text.push_back('\n');
    if (text.size() < block) continue;
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  }
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.flush();
  if (!out) throw InputError({.expected = "room to write a table", .found = "an error while writing"});
}

void write_table(const std::string& path, const std::vector<std::string>& titles, const NextRow& next) {
  OutputFile file(path);
  try {
    write_table(file.stream(), titles, next);
  } catch (const InputError& error) {
    throw located(error, path == "-" ? "standard output" : path, 0, "");
  }
  file.finish();
}

std::shared_ptr<std::istream> open_to_read(const std::string& path) {
  announce_input(path);
  if (path == "-") return {std::shared_ptr<void>(), &std::cin};  // not ours to close
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError({.file = path, .expected = "a file", .found = "a directory"});
  errno = 0;
  auto file = std::make_shared<std::ifstream>(path, std::ios::binary);
  if (!*file) throw unreadable(path, reason(errno));
  return file;
}

}  // namespace flexslip
