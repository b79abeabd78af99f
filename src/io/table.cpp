#include "io/table.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "io/call_files.h"
#include "io/cells.h"
#include "io/durable_file.h"
#include "io/input_error.h"
#include "io/statistics_rows.h"
#include "io/table_source.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t most_labelled = 1 << 16;  // rows with a label; where there are more, labels are data
constexpr std::size_t few_below = 12;           // rows below a break, which may be no readings; more are another cycle

// A cell as a number, if all of it is one; it may be infinite or NaN.
std::optional<double> as_number(std::string_view cell, char decimal) {
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
  std::string with_point;
  if (decimal == ',' && cell.find(',') != std::string_view::npos) {
    if (cell.find('.') != std::string_view::npos) return std::nullopt;
    with_point = cell;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    cell = with_point;
  }
  double value = 0;
  const auto [end, error] = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return value;
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

class TableReader {
 public:
  TableReader(std::istream& in, std::string source, char decimal, const WorkbookSheet* sheet)
      : source_(std::move(source)), decimal_(decimal), sheet_(sheet), lines_(in, source_) {
    if (sheet_ != nullptr && !sheet_->kinds.has_dates()) sheet_ = nullptr;
  }

  Table read(const std::vector<WantedColumn>& wanted) {
    read_header();
    find(wanted);
    std::optional<std::string_view> line = next_line();
    if (line && is_unit_line(*line)) {
      take_units(*line);
      line = next_line();
    }
    std::vector<Unit> units;
    for (const Source& source : sources_) units.push_back(agreed_unit(source));
    Table table{.source = source_, .columns = {}, .lines = {}, .notes = {}};
    for (const Source& source : sources_) table.columns.push_back({header_[source.cell].title.name, {}});
    std::vector<double> row(sources_.size());
    for (; line; line = next_line()) {
      label_ = {};
      if (!read_row(*line, row)) continue;
      const std::size_t index = table.rows();
      if (!label_.empty() && labelled_.size() <= most_labelled) labelled_.push_back({index, names_statistic(label_)});
      if (table.lines.empty() || lines_.number() - table.lines.back().line != index - table.lines.back().row)
        table.lines.push_back({index, lines_.number()});
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
    InputFault fault{source_, line, std::move(field), std::move(expected), std::move(found), std::move(remedy)};
    fault.part = part;
    throw InputError(std::move(fault));
  }

  std::optional<std::string_view> next_line() {
    std::optional<std::string_view> line = lines_.next();
    while (line && is_comment_or_blank(*line)) line = lines_.next();
    return line;
  }

  // Calls visit(index, cell) for each cell of a line.
  template <class Visit>
  std::size_t for_each_cell(std::string_view line, const Visit& visit) const {
    CellReader cells(line, delimiter_);
    std::size_t count = 0;
    while (const std::optional<std::string_view> cell = cells.next()) visit(count++, *cell);
    if (cells.broken())
      refuse(lines_.number(), "", "quotes in pairs around a whole cell",
             "a stray quote in cell " + std::to_string(count + 1), "delete it");
    return count;
  }

  void read_header() {
    const std::optional<std::string_view> line = next_line();
    if (!line)
      refuse(0, "", "a header line and rows of numbers",
             lines_.number() == 0 ? "an empty file" : "no line with content", "");
    header_line_ = lines_.number();
    delimiter_ = delimiter_of(*line);
    bool all_numbers = true;
    for_each_cell(*line, [&](std::size_t, std::string_view cell) {
      std::string text = unescaped(cell);
      const bool names_another = delimiter_ == ' ' && !header_.empty() && cell.starts_with('[');
      if (names_another)
        text = header_.back().text + " " + text;  // "w_s [m] F [N]": the space before a unit separates nothing
      if (names_another) header_.pop_back();
      all_numbers = all_numbers && (cell.empty() || as_number(cell, decimal_));
      header_.push_back({text, title_in_header(text)});
    });
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
    wanted_by_.assign(header_.size(), sources_.size());
    for (std::size_t i = 0; i < sources_.size(); ++i) wanted_by_[sources_[i].cell] = i;
  }

  [[noreturn]] void refuse_missing(const std::string& name, const std::string& field) const {
    std::vector<std::string> names;
    for (const HeaderCell& cell : header_) names.push_back(cell.title.name);
    const std::string meant = nearest(name, names);
    throw InputError({.file = source_,
                      .line = header_line_,
                      .field = field,
                      .remedy = meant.empty() ? "" : "did you mean " + in_quotes(meant) + "?",
                      .problem = "is missing: the file has " + listed(names),
                      .part = TablePart::title});
  }

  // A line of units has words where the wanted columns should have numbers.
  bool is_unit_line(std::string_view line) const {
    bool words = false;
    bool numbers = false;
    for_each_cell(line, [&](std::size_t i, std::string_view cell) {
      if (i >= wanted_by_.size() || wanted_by_[i] == sources_.size() || cell.empty()) return;
      const bool starts_as_number = std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
      const bool word = !as_number(cell, decimal_) && (!starts_as_number || names_unit(without_brackets(cell)));
      (word ? words : numbers) = true;
    });
    return words && !numbers;
  }

  void take_units(std::string_view line) {
    for_each_cell(line, [&](std::size_t i, std::string_view cell) {
      if (i < wanted_by_.size() && wanted_by_[i] < sources_.size() && !cell.empty())
        sources_[wanted_by_[i]].units.emplace_back(without_brackets(cell));
    });
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
      const InputError placed = located(error, source_, header_line_, source.field);
      if (!source.units.empty()) throw InputError(placed);
      InputFault fault = placed.fault;
      fault.remedy = fmt::format("name it with its unit, such as \"{} [{}]\"", name, source.kind.units.back());
      throw InputError(fault);
    }
  }

  // One line into one row; false if all its cells are empty, as spreadsheets write them below a table, or if a word stands for a
  // statistic where a number is wanted.
  bool read_row(std::string_view line, std::vector<double>& row) {
    bool surplus = false;
    bool lacking = false;
    bool is_first = true;
    const std::size_t cells = for_each_cell(line, [&](std::size_t i, std::string_view cell) {
      if (!cell.empty() && std::exchange(is_first, false) && is_label(cell)) label_ = cell;
      if (i >= wanted_by_.size()) {
        surplus = surplus || !cell.empty();
      } else if (wanted_by_[i] < row.size()) {
        const std::optional<double> value = as_number(cell, decimal_);
        if (value && std::isfinite(*value))
          row[wanted_by_[i]] = *value;
        else
          lacking = true;
        if (sheet_ != nullptr && value && is_dated(sheet_->kinds.at(lines_.number(), i + 1)))
          throw sheet_->dated(source_, lines_.number(), i + 1, *value,
                              fmt::format("a number in the {}", sources_[wanted_by_[i]].field));
      }
    });
    if (!surplus && !lacking && cells >= header_.size()) return true;
    if (line.find_first_not_of(" \t\",;") == std::string_view::npos) return false;
    if (surplus || cells < header_.size()) refuse_count(cells);
    if (names_statistic(label_)) {
      statistics_.push_back(lines_.number());
      return false;
    }
    refuse_cell(line);
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
    if (rows.empty() && below_break > 0 && below_break <= few_below && 2 * below_break < end.row)
      notes_.push_back(below_a_break(end.line, end.line + below_break - 1));
    if (!statistics_.empty()) notes_.push_back(left_out_statistics(statistics_));
    if (!rows.empty()) leave_out(table, rows);
  }

  static void leave_out(Table& table, const std::vector<std::size_t>& rows) {
    const Table all = std::move(table);
    table = {.source = all.source, .columns = {}, .lines = {}, .notes = all.notes};
    for (const Column& column : all.columns) table.columns.push_back({column.name, {}});
    std::size_t next = 0;
    for (std::size_t row = 0; row < all.rows(); ++row) {
      if (next < rows.size() && rows[next] == row) {
        ++next;
        continue;
      }
      const std::size_t index = table.rows(), line = all.line_of(row);
      if (table.lines.empty() || line - table.lines.back().line != index - table.lines.back().row)
        table.lines.push_back({index, line});
      for (std::size_t i = 0; i < all.columns.size(); ++i)
        table.columns[i].values.push_back(all.columns[i].values[row]);
    }
  }

  [[noreturn]] void refuse_count(std::size_t cells) const {
    const bool perhaps_commas = delimiter_ == ',' && cells > header_.size();
    refuse(lines_.number(), "", fmt::format("{} cells as in the header on line {}", header_.size(), header_line_),
           std::to_string(cells),
           perhaps_commas
               ? "if these are decimal commas, write decimal points, or separate cells by ; and pass --decimal ,"
               : "");
  }

  [[noreturn]] void refuse_cell(std::string_view line) const {
    for_each_cell(line, [&](std::size_t i, std::string_view cell) {
      if (i >= wanted_by_.size() || wanted_by_[i] == sources_.size()) return;
      const std::string& field = sources_[wanted_by_[i]].field;
      const std::optional<double> value = as_number(cell, decimal_);
      if (value && std::isfinite(*value)) return;
      const std::string found = cell.empty() ? "an empty cell" : in_quotes(cell);
      const std::string remedy = cell.empty() ? "fill it in or delete the line"
                                 : value      ? "delete the line"
                                              : remedy_for_cell(cell);
      refuse(lines_.number(), field, value ? "a finite number" : "a number", found, remedy, TablePart::cell);
    });
    throw std::logic_error("read_row refuses only lines with a cell that is no finite number");
  }

  std::string remedy_for_cell(std::string_view cell) const {
    const bool comma = cell.find(',') != std::string_view::npos;
    if (comma && decimal_ == '.' && as_number(cell, ',')) return "write decimal points, or pass --decimal ,";
    if (!comma && decimal_ == ',' && as_number(cell, '.')) return "write decimal commas, or leave out --decimal ,";
    std::string digits(cell);
    std::erase_if(digits, [](char c) { return c == ',' || c == '.'; });
    if (comma && as_number(digits, '.')) return "write no thousands separators";
    return "";
  }

  std::string source_;
  char decimal_;
  const WorkbookSheet* sheet_;  // of a workbook with dates
  LineReader lines_;
  char delimiter_ = ',';
  std::size_t header_line_ = 0;
  std::vector<HeaderCell> header_;
  std::vector<Source> sources_;
  std::vector<std::string> notes_;
  std::string_view label_;               // that the row begins with
  std::vector<LabelledRow> labelled_;    // the first of them
  std::vector<std::size_t> statistics_;  // lines
  std::vector<std::size_t> wanted_by_;   // for each cell of a line: which source takes it, sources_.size() if none
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

Table read_table(std::istream& in, std::string source, const std::vector<WantedColumn>& wanted, char decimal,
                 const WorkbookSheet* sheet) {
  if (wanted.empty()) throw std::invalid_argument("read_table: no column wanted");
  if (decimal != '.' && decimal != ',')
    throw std::invalid_argument(fmt::format("read_table: decimal mark '{}'", decimal));
  return TableReader(in, std::move(source), decimal, sheet).read(wanted);
}

}  // namespace

Table read_table(std::istream& in, std::string source, const std::vector<WantedColumn>& wanted, char decimal) {
  return read_table(in, std::move(source), wanted, decimal, nullptr);
}

Table read_table(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal,
                 const std::optional<SheetChoice>& sheet) {
  const TableSource source = open_table(path, sheet);
  if (!source.sheet) return read_table(*source.text, source.name, wanted, decimal, nullptr);
  try {
    Table table = read_table(*source.text, source.name, wanted, decimal, &*source.sheet);
    table.notes.insert(table.notes.begin(), source.sheet->notes.begin(), source.sheet->notes.end());
    return table;
  } catch (const InputError& error) {
    if (sheet) throw;
    throw with_other_sheets(error, source.sheet->name, source.sheet->sheets);
  }
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
