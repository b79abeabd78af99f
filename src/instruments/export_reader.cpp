#include "instruments/export_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "instruments/column_decisions.h"
#include "instruments/column_flags.h"
#include "instruments/column_unit.h"
#include "instruments/column_words.h"
#include "instruments/dated_column.h"
#include "instruments/export_cells.h"
#include "instruments/export_program.h"
#include "instruments/layout.h"
#include "instruments/number_format.h"
#include "instruments/regrouped.h"
#include "instruments/rows_of_readings.h"
#include "instruments/side_by_side.h"
#include "io/input_error.h"
#include "io/text.h"
#include "io/workbook.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double missing = not_a_number;
constexpr std::size_t longest_summary = 50;  // rows of a table of results; what is longer was measured

class ExportReader {
 public:
  ExportReader(const DecodedText& decoded, const std::string& source, const ExportOptions& options,
               const std::optional<WorkbookSheet>& workbook)
      : options_(options),
        workbook_(workbook),
        cells_(decoded.text, separator(decoded.text, options), workbook ? &*workbook : nullptr),
        sheet_(cells_.sheet()) {
    out_.source = source;
    if (workbook_) {
      out_.sheet = workbook_->name;
      out_.sheets = workbook_->sheets;
      out_.sheet_is_chosen = workbook_->is_chosen;
      out_.sheet_holds = workbook_->holds;
      out_.notes = workbook_->notes;
    }
    out_.decimal = format_.decimal;
    out_.thousands = format_.thousands;
    out_.encoding = decoded.encoding;
    out_.byte_order_mark = decoded.byte_order_mark;
    out_.separator = separator(decoded.text, options);
    out_.quoted = sheet_.quoted() && out_.has_delimiters();
  }

  Export read() {
    layout_ = layout_of(sheet_);
    for (TableBlock& block : layout_.blocks)
      if (std::string said = leave_out_statistics(block, cells_, layout_.numeric); !said.empty())
        out_.row_notes.push_back(std::move(said));
    decide_number_format();
    const std::size_t main = main_block();
    for (const TableBlock& block : layout_.blocks) take_block(block, layout_.blocks[main]);
    require_names(layout_.blocks[main]);
    for (const std::size_t line : layout_.remarks) take_metadatum(line, out_.metadata);
    note_left_out();
    out_.notes.insert(out_.notes.end(), out_.row_notes.begin(), out_.row_notes.end());
    name_specimens();
    out_.test = test_in(all_metadata(out_), format_);
    out_.format = program_of(out_, has_bracketed_units(layout_.blocks[main]));
    decide_columns(out_, options_, format_, layout_.blocks.front().header_line + 1);
    require_no_dates();
    return std::move(out_);
  }

 private:
  static char separator(std::string_view text, const ExportOptions& options) {
    static constexpr std::string_view known = ",;\t ";
    if (options.separator && known.find(*options.separator) == std::string_view::npos)
      throw InputError({.field = "separator",
                        .expected = "a comma, a semicolon, a tab or a space",
                        .found = in_quotes(std::string_view(&*options.separator, 1))});
    return options.separator ? *options.separator : separator_of(text);
  }

  void take_metadatum(std::size_t line, std::vector<Metadatum>& metadata) const {
    Metadatum datum = metadatum_on(sheet_.text(line), sheet_.cells(line), line + 1);
    for (std::size_t column = 0; workbook_ && column < sheet_.cells(line).size(); ++column)
      if (is_dated(cells_.kind(line, column)) && datum.value == cell(line, column))
        datum.value = cells_.shown(line, column);
    if (!datum.name.empty() || !datum.value.empty()) metadata.push_back(std::move(datum));
  }

  bool has_bracketed_units(const TableBlock& block) const {
    return !block.titles.empty() && !block.units.empty() &&
           sheet_.text(block.header_line + 1).find('(') != std::string_view::npos;
  }

  std::string_view cell(std::size_t line, std::size_t column) const { return cells_.at(line, column); }

  // What is refused, unless nobody wants the column: the first of its cells that hold dates.
  void keep_dated(const TableBlock& block, std::size_t column) {
    const auto line = std::find_if(block.rows.begin(), block.rows.end(),
                                   [&](std::size_t each) { return is_dated(cells_.kind(each, column)); });
    if (line != block.rows.end()) dated_.emplace(column + 1, *line);
  }

  void require_no_dates() const {
    for (const ExportedSpecimen& specimen : out_.specimens)
      for (const ExportColumn& column : specimen.columns) {
        const auto dated = dated_.find(column.number);
        if (column.role == ColumnRole::other || dated == dated_.end()) continue;
        throw workbook_->dated(out_.source, dated->second + 1, column.number,
                               cells_.days(dated->second, column.number - 1),
                               fmt::format("a number in the column {}", in_quotes(column.name)));
      }
  }

  // ---- numbers

  void decide_number_format() {
    NumberEvidence evidence;
    std::size_t undecided = 0;
    std::size_t counted = 0;
    for (const TableBlock& block : layout_.blocks)
      for (const std::size_t line : block.rows)
        for (std::size_t column = 0; column < layout_.columns; ++column) {
          const std::string_view number = number_cell(cell(line, column)).number;
          if (number.empty() || !layout_.numeric[column] || cells_.kind(line, column) != CellKind::word) continue;
          evidence.add(number);
          ++counted;
          if (undecided == 0 && number.find_first_of(".,") != std::string_view::npos) undecided = line + 1;
        }
    if (workbook_ && counted == 0 && workbook_->holds == SheetHolds::numbers) return;  // its numbers are numbers
    out_.has_marks = true;
    if (options_.decimal)
      format_.decimal = *options_.decimal;
    else if (options_.thousands == ',' || options_.thousands == '.')
      format_.decimal = options_.thousands == ',' ? '.' : ',';
    else if (const std::optional<char> proven = evidence.decimal())
      format_.decimal = *proven;
    else if (evidence.undecidable() && (out_.separator != ',' || evidence.only_commas()))
      throw InputError({.line = undecided,
                        .expected = "numbers that distinguish a decimal mark from a thousands separator",
                        .found = "only such as '1,234' or '1.234'",
                        .remedy = "say which it is with --decimal . or --decimal ,"});
    format_.thousands = options_.thousands ? *options_.thousands : evidence.thousands(format_.decimal);
    if (format_.thousands == '.' && format_.decimal == '.')
      throw InputError({.line = undecided,
                        .expected = "numbers with one decimal point",
                        .found = "several in one number",
                        .remedy = "pass --decimal , if the points separate thousands"});
    out_.decimal = format_.decimal;
    out_.thousands = format_.thousands;
  }

  // The numbers of a column, and what is said about those that are not there.
  std::vector<double> values_of(const TableBlock& block, std::size_t column, const std::string& name,
                                std::string_view unit) {
    std::vector<std::string_view> numbers;
    numbers.reserve(block.rows.size());
    std::vector<double> values;
    values.reserve(block.rows.size());
    bool are_words = true;
    for (const std::size_t line : block.rows) {
      const NumberCell parts = number_cell(cell(line, column));
      const bool counts = parts.unit.empty() || parts.unit == unit;
      numbers.push_back(counts ? parts.number : std::string_view{});
      values.push_back(counts ? cells_.number(line, column, format_) : missing);
      are_words = are_words && (parts.number.empty() || cells_.kind(line, column) == CellKind::word);
    }
    if (format_.thousands == ',' && format_.decimal == ',' && are_words) values = restore(block, numbers, name);
    std::vector<std::size_t> lines;
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isnan(values[row])) lines.push_back(block.rows[row] + 1);
    if (!lines.empty())
      out_.notes.push_back(fmt::format("column {}: no number in {} of {} rows: {}{} {}", in_quotes(name), lines.size(),
                                       values.size(), on_lines(lines),
                                       lines.size() == 1 ? " holds" : "; the first holds",
                                       in_quotes(cells_.shown(lines.front() - 1, column))));
    return values;
  }

  std::vector<double> restore(const TableBlock& block, const std::vector<std::string_view>& numbers,
                              const std::string& name) {
    Regrouped column = restored(numbers);
    if (column.status == Regrouped::Status::ambiguous)
      throw InputError({.line = block.rows[column.row] + 1,
                        .field = "column " + in_quotes(name),
                        .expected = "numbers with one decimal comma",
                        .found = in_quotes(numbers[column.row]) + ", with several commas, in a column too uneven to "
                                                                  "show which is the decimal one",
                        .remedy = "export the file again without opening it in a spreadsheet"});
    if (column.status == Regrouped::Status::restored)
      out_.notes.push_back(fmt::format(
          "column {}: a spreadsheet has taken decimal commas for separators of thousands ('100,0292' became "
          "'1,000,292'); in {} of {} cells the comma is put back where the column stays continuous; check them, or "
          "export the file again",
          in_quotes(name), column.moved, numbers.size()));
    return std::move(column.values);
  }

  // ---- tables

  std::size_t main_block() const {
    const auto longest = std::max_element(layout_.blocks.begin(), layout_.blocks.end(),
                                          [](const auto& a, const auto& b) { return a.rows.size() < b.rows.size(); });
    return static_cast<std::size_t>(longest - layout_.blocks.begin());
  }

  // Another specimen has columns of the same names or meanings; a table of results or dimensions has not.
  static bool is_specimen(const TableBlock& block, const TableBlock& main) {
    if (block.titles.empty() || block.titles == main.titles) return true;
    if (block.titles.size() != main.titles.size()) return false;
    std::size_t meant = 0;
    for (std::size_t i = 0; i < block.titles.size(); ++i) {
      const ColumnRole role = role_of(title_parts(block.titles[i]).name);
      if (role != role_of(title_parts(main.titles[i]).name)) return false;
      if (role != ColumnRole::other) ++meant;
    }
    return meant > 1;
  }

  void take_block(const TableBlock& block, const TableBlock& main) {
    const bool first = out_.specimens.empty();
    const std::vector<std::string>& titles = block.titles.empty() ? main.titles : block.titles;
    const std::vector<ColumnGroup> groups = side_by_side(titles);
    ExportedSpecimen specimen;
    std::vector<Metadatum>& metadata = first ? out_.metadata : specimen.metadata;
    for (const std::size_t line : block.remarks)
      if (groups.empty() || line + 1 != block.header_line) take_metadatum(line, metadata);  // their names
    if (!is_specimen(block, main)) {
      for (Metadatum& datum : metadata)
        if (!first) out_.metadata.push_back(std::move(datum));
      take_summary(block);
      return;
    }
    if (!groups.empty()) {
      take_groups(block, titles, groups, specimen);
      return;
    }
    for (const std::size_t line : block.rows) specimen.lines.push_back(line + 1);
    for (std::size_t column = 0; column < layout_.columns; ++column) take_column(block, titles, column, specimen);
    const auto splits = std::find_if(specimen.columns.begin(), specimen.columns.end(), [](const ExportColumn& each) {
      return !each.words.empty() && names_specimens(each.name);
    });
    if (splits == specimen.columns.end())
      out_.specimens.push_back(std::move(specimen));
    else
      split_by(splits->words, specimen);
  }

  // Specimens beside each other, each with the rows in which it has a cell, named by what stands above the first of its titles.
  void take_groups(const TableBlock& block, const std::vector<std::string>& titles,
                   const std::vector<ColumnGroup>& groups, const ExportedSpecimen& common) {
    for (const ColumnGroup& group : groups) {
      TableBlock own = block;
      std::erase_if(own.rows, [&](std::size_t line) {
        return std::all_of(group.columns.begin(), group.columns.end(),
                           [&](std::size_t column) { return column < group.first || cell(line, column).empty(); });
      });
      if (own.rows.empty()) continue;
      ExportedSpecimen specimen = common;
      const std::string_view above = block.header_line > 0 ? cell(block.header_line - 1, group.first) : "";
      if (number_cell(above).number.empty()) specimen.name = above;
      for (const std::size_t line : own.rows) specimen.lines.push_back(line + 1);
      for (const std::size_t column : group.columns) take_column(own, titles, column, specimen);
      out_.specimens.push_back(std::move(specimen));
    }
    out_.notes.push_back(fmt::format("{} specimens stand beside each other, with the same titles", groups.size()));
  }

  // Without names only columns of numbers are a table: others may be what is left of a preamble.
  void require_names(const TableBlock& main) const {
    if (!main.titles.empty()) return;
    for (const ExportColumn& column : out_.specimens.front().columns)
      if (!column.words.empty())
        throw InputError({.line = main.rows.front() + 1,
                          .expected = "a line with the names of the columns above rows of numbers and words",
                          .found = "none",
                          .remedy = "add one, or export the raw data of the test as CSV"});
  }

  // A table beside those of the specimens: each number is a metadatum, named by its column and, of several rows, its row.
  void take_summary(const TableBlock& block) {
    if (block.rows.size() > longest_summary) {
      out_.notes.push_back(fmt::format("left out: another table, with other columns, on lines {} to {}",
                                       block.rows.front() + 1, block.rows.back() + 1));
      return;
    }
    for (const std::size_t line : block.rows) {
      const bool labelled = number_cell(cell(line, 0)).number.empty() || block.titles.front().empty();
      for (std::size_t column = labelled ? 1 : 0; column < layout_.columns; ++column) {
        const std::string_view value = cell(line, column);
        if (value.empty()) continue;
        const std::string& title = block.titles[column];
        const std::string unit = block.units.empty() || block.units[column].empty() ? "" : " " + block.units[column];
        summaries_.emplace_back(
            block.rows.size() > 1 ? std::string(cell(line, 0)) : "",
            Metadatum{title.substr(0, title.find_last_not_of(": \t") + 1), std::string(value) + unit, line + 1});
      }
    }
  }

  struct ColumnContent {
    std::size_t numbers = 0, words = 0;
    std::string_view unit;  // that follows the first number
  };

  ColumnContent content_of(const TableBlock& block, std::size_t column) const {
    ColumnContent content;
    for (const std::size_t line : block.rows) {
      const std::string_view text = cell(line, column);
      const NumberCell parts = number_cell(text);
      if (!parts.number.empty() && content.numbers++ == 0) content.unit = parts.unit;
      if (parts.number.empty() && !says_missing(text)) ++content.words;
    }
    return content;
  }

  void take_column(const TableBlock& block, const std::vector<std::string>& titles, std::size_t column,
                   ExportedSpecimen& specimen) {
    const ColumnContent content = content_of(block, column);
    const std::string title = titles.empty() ? "" : titles[column];
    const std::string row_unit = block.units.empty() ? "" : block.units[column];
    if (content.numbers == 0 && content.words == 0) {
      if (!title.empty()) out_.notes.push_back(fmt::format("column {} is empty and left out", in_quotes(title)));
      return;
    }
    ExportColumn out;
    out.number = column + 1;
    take_title(block, title, row_unit, content.unit, out);
    const bool has_numbers = content.numbers >= content.words && content.numbers > 0;
    out.role = role_for(out);
    if (has_numbers && cells_.has_dates())
      if (std::string said = take_dated(cells_, block.rows, column, content.numbers, out); !said.empty()) {
        out_.notes.push_back(std::move(said));
        specimen.columns.push_back(std::move(out));
        return;
      }
    if (has_numbers) {
      if (cells_.has_dates()) keep_dated(block, column);
      out.values = values_of(block, column, out.name, content.unit);
      const bool is_wanted = dated_.contains(out.number) && out.role != ColumnRole::other;
      if (!is_wanted &&
          std::all_of(out.values.begin(), out.values.end(), [](double value) { return std::isnan(value); }))
        return;
    } else {
      if (gives_unit(block, column, specimen)) return;
      out.role = ColumnRole::other;
      out.values.assign(block.rows.size(), missing);
      for (const std::size_t line : block.rows) out.words.emplace_back(cell(line, column));
    }
    specimen.columns.push_back(std::move(out));
  }

  // Name and unit of a column, from its title, the row of units and its cells, which must agree.
  static void take_title(const TableBlock& block, const std::string& title, const std::string& row_unit,
                         std::string_view cell_unit, ExportColumn& out) {
    const TitleParts parts = title_parts(title);
    const bool counts_nothing = row_unit == "-" || row_unit == "1";
    std::vector<std::string> units;
    for (const std::string& unit : {counts_nothing ? "" : row_unit, std::string(cell_unit), parts.unit})
      if (!unit.empty()) units.push_back(unit);
    out.name = parts.name;
    if (!units.empty()) out.unit = units.front();
    for (const std::string& unit : units) {
      const auto known = machine_unit(unit);
      const auto used = machine_unit(out.unit);
      if (known && used && *known != *used)
        throw InputError({.line = block.header_line + 1,
                          .field = "column " + in_quotes(title),
                          .expected = "one unit",
                          .found = listed(units),
                          .remedy = "correct the file: its title, its row of units and its cells must agree"});
    }
    const bool title_has_other = !parts.unit.empty() && out.unit != parts.unit && !machine_unit(out.unit);
    if (title_has_other) out.name = title;
    if (out.name.empty()) out.name = fmt::format("column_{}", out.number);
  }

  static ColumnRole role_for(const ExportColumn& column) {
    const ColumnRole role = role_of(column.name);
    const std::optional<Unit> unit = machine_unit(column.unit);
    const std::optional<Dimension> wanted = dimension_of(role);
    const bool is_mass = unit && unit->dimension == Dimension{.kilogram = 1};  // in_si says what is wrong with it
    const bool fits = !unit || !wanted || unit->dimension == *wanted || (role == ColumnRole::force && is_mass);
    return fits ? role : ColumnRole::other;
  }

  // A column that holds the unit of the one before, in every row.
  bool gives_unit(const TableBlock& block, std::size_t column, ExportedSpecimen& specimen) const {
    const std::string_view unit = cell(block.rows.front(), column);
    if (specimen.columns.empty() || !names_a_unit(unit)) return false;
    ExportColumn& before = specimen.columns.back();
    const bool adjacent = before.number == column && before.words.empty() && before.unit.empty();
    const bool constant =
        std::all_of(block.rows.begin(), block.rows.end(), [&](std::size_t line) { return cell(line, column) == unit; });
    if (!adjacent || !constant) return false;
    before.unit = unit;
    before.role = role_for(before);
    return true;
  }

  void split_by(const std::vector<std::string>& words, const ExportedSpecimen& all) {
    std::vector<std::string> names;
    std::map<std::string, std::vector<std::size_t>> rows;
    for (std::size_t row = 0; row < words.size(); ++row) {
      if (rows[words[row]].empty()) names.push_back(words[row]);
      rows[words[row]].push_back(row);
    }
    for (const std::string& name : names) {
      ExportedSpecimen one{name, {}, {}, all.metadata};
      for (const std::size_t row : rows[name]) one.lines.push_back(all.lines[row]);
      for (const ExportColumn& column : all.columns) {
        ExportColumn part{column.name, column.unit, column.role, {}, column.number, {}};
        for (const std::size_t row : rows[name]) {
          part.values.push_back(column.values[row]);
          if (!column.words.empty()) part.words.push_back(column.words[row]);
        }
        one.columns.push_back(std::move(part));
      }
      out_.specimens.push_back(std::move(one));
    }
  }

  void note_left_out() {
    std::vector<std::size_t> lines;
    for (const TableBlock& block : layout_.blocks)
      for (const std::size_t line : block.misfits) lines.push_back(line + 1);
    if (!lines.empty())
      out_.notes.push_back(
          fmt::format("left out, as they are not rows of {} cells: {}", layout_.columns, on_lines(lines)));
    if (layout_.blocks.back().cut_off)
      out_.notes.emplace_back(
          "the file ends in the middle of a row, which is left out; check that the file is complete");
    if (layout_.blocks.front().titles.empty())
      out_.notes.push_back(fmt::format("no line above line {} names {} columns",
                                       layout_.blocks.front().rows.front() + 1, layout_.columns));
  }

  // What summaries say of a specimen is its own; of one specimen, or of none, it is the file's.
  void assign_summaries() {
    const bool several = out_.specimens.size() > 1;
    for (const auto& [row, datum] : summaries_) {
      const auto own = std::find_if(out_.specimens.begin(), out_.specimens.end(),
                                    [&name = row](const ExportedSpecimen& each) { return each.name == name; });
      if (several && own != out_.specimens.end())
        own->metadata.push_back(datum);
      else
        out_.metadata.push_back({row.empty() ? datum.name : row + " " + datum.name, datum.value, datum.line});
    }
  }

  void name_specimens() {
    const bool several = out_.specimens.size() > 1;
    for (std::size_t i = 0; i < out_.specimens.size(); ++i) {
      ExportedSpecimen& specimen = out_.specimens[i];
      if (!specimen.name.empty()) continue;
      specimen.name = specimen_name(several && i > 0 ? specimen.metadata : out_.metadata);
      // Of several, each has its name on a line of its own above its table.
      std::vector<Metadatum>& above = i > 0 ? specimen.metadata : out_.metadata;
      if (!several || !specimen.name.empty() || above.empty() || !above.back().value.empty()) continue;
      specimen.name = above.back().name;
      above.pop_back();
    }
    assign_summaries();
  }

  const ExportOptions& options_;
  const std::optional<WorkbookSheet>& workbook_;
  ExportCells cells_;
  const Sheet& sheet_;
  Layout layout_{};
  NumberFormat format_;
  Export out_{};
  std::vector<std::pair<std::string, Metadatum>> summaries_;  // with the first cell of their row
  std::map<std::size_t, std::size_t> dated_;  // columns with dates, from 1: the first line of them, from 0
};

}  // namespace

Export export_in(const DecodedText& decoded, const std::string& source, const ExportOptions& options,
                 const std::optional<WorkbookSheet>& workbook) {
  return ExportReader(decoded, source, options, workbook).read();
}

}  // namespace flexslip
