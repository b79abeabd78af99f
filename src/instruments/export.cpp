#include "instruments/export.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "instruments/column_decisions.h"
#include "instruments/layout.h"
#include "io/input_error.h"
#include "io/text.h"
#include "numerics/elementary.h"

// Reading is a chain: the bytes become a sheet of cells, its lines become tables, all numbers
// together give the number format, each table gives columns, and these give specimens. Finally,
// column_decisions.h gives the columns their roles. Each step returns its decisions, which are the
// input of the next.
namespace flexslip {
namespace {

constexpr std::size_t longest_summary = 50;  // rows; a longer table holds readings

using Notes = std::vector<std::string>;

// The result of a step, and notes on it.
template <class Value>
struct Noted {
  Value value;
  Notes notes;
};

template <class Value>
void append(std::vector<Value>& all, std::vector<Value> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// ---- number format

struct Marks {
  NumberFormat format;
  bool apply = true;  // true if the marks apply to all numbers; in a workbook they apply to words only
};

Marks marks_in(const Sheet& sheet, const Layout& layout, const ExportOptions& options, char separator) {
  NumberEvidence evidence;
  std::size_t undecided = 0, with_commas = 0,
              with_points = 0;  // lines; with_commas and with_points: with several marks in one number
  std::size_t numbers = 0, words = 0;
  for (const TableBlock& block : layout.blocks)
    for (const std::size_t line : block.rows)
      for (std::size_t column = 0; column < layout.columns; ++column) {
        if (!layout.numeric[column]) continue;
        const std::string_view number = number_cell(sheet.at(line, column)).number;
        if (number.empty()) continue;
        ++numbers;
        if (sheet.kind(line, column) != CellKind::word) continue;
        ++words;
        evidence.add(number);
        if (undecided == 0 && number.find_first_of(".,") != std::string_view::npos) undecided = line + 1;
        if (with_commas == 0 && std::count(number.begin(), number.end(), ',') > 1) with_commas = line + 1;
        if (with_points == 0 && std::count(number.begin(), number.end(), '.') > 1) with_points = line + 1;
      }
  if (numbers > 0 && words == 0) return {{}, false};
  NumberFormat format;
  if (options.decimal)
    format.decimal = *options.decimal;
  else if (options.thousands == ',' || options.thousands == '.')
    format.decimal = options.thousands == ',' ? '.' : ',';
  else if (const std::optional<char> proven = evidence.decimal())
    format.decimal = *proven;
  else if (evidence.undecidable() && (separator != ',' || evidence.only_commas()))
    throw InputError(
        {.line = undecided,
         .problem = "Numbers such as '1,234' or '1.234' are ambiguous: the mark is decimal, or it separates thousands",
         .remedy = "say which it is with --decimal . or --decimal ,"});
  format.thousands = options.thousands ? *options.thousands : evidence.thousands(format.decimal);
  if (options.thousands == format.decimal)
    throw InputError(
        {.problem = fmt::format("The decimal mark and the mark between thousands are both '{}'", format.decimal),
         .remedy = "pass --thousands none, or the other one with --decimal"});
  if (format.thousands == '.' && format.decimal == '.')
    throw InputError({.line = with_points,
                      .problem = "A number has several decimal points",
                      .remedy = "pass --decimal , if the points separate thousands"});
  if (format.thousands == ',' && format.decimal == ',')
    throw InputError({.line = with_commas,
                      .problem = "A number has several decimal commas",
                      .remedy = "export the file again without opening it in a spreadsheet, which takes decimal "
                                "commas for separators of thousands; or pass --decimal . if they are separators"});
  return {format};
}

// ---- a column

// The input of the steps after the layout.
struct Laid {
  const Sheet& sheet;
  const Layout& layout;
  NumberFormat format;
};

// Name and unit of a column from its title, the row of units and its cells, which must agree.
ColumnTitle title_of(const std::string& title, const std::string& row_unit, std::string_view cell_unit,
                     std::size_t line) {
  const ColumnTitle parts = title_parts(title);
  const bool counts_nothing = row_unit == "-" || row_unit == "1";
  std::vector<std::string> units;
  for (const std::string& unit : {counts_nothing ? "" : row_unit, std::string(cell_unit), parts.unit})
    if (!unit.empty()) units.push_back(unit);
  ColumnTitle out{parts.name, units.empty() ? "" : units.front()};
  const auto used = machine_unit(out.unit);
  for (const std::string& unit : units) {
    const auto known = machine_unit(unit);
    if (known && used && *known != *used)
      throw InputError({.line = line,
                        .field = "column " + in_quotes(title),
                        .problem = fmt::format("The units {} contradict each other", listed(units)),
                        .remedy = "correct the file: its title, its row of units and its cells must agree"});
  }
  const bool title_has_other = !parts.unit.empty() && out.unit != parts.unit && !used;
  if (title_has_other) out.name = title;
  return out;
}

ColumnRole role_for(const ExportColumn& column) {
  const ColumnRole role = role_of(column.name);
  const std::optional<Unit> unit = machine_unit(column.unit);
  const Kind* wanted = words_for(role).kind;
  const bool is_mass = unit && unit->dimension == Dimension{.kilogram = 1};  // in_si reports what is wrong with it
  const bool fits =
      !unit || wanted == nullptr || unit->dimension == wanted->dimension || (role == ColumnRole::force && is_mass);
  return fits ? role : ColumnRole::other;
}

struct Values {
  std::vector<double> value;
  Notes notes;
  std::vector<CellWithoutNumber> missing{};
};

// The numbers of a column, without numbers in another unit, and notes on missing ones.
Values values_of(const Laid& laid, const TableBlock& block, const ExportColumn& of, std::string_view unit) {
  const std::size_t column = of.number - 1;
  Values out;
  out.value.reserve(block.rows.size());
  for (const std::size_t line : block.rows) {
    const NumberCell parts = number_cell(laid.sheet.at(line, column));
    const bool counts = parts.unit.empty() || parts.unit == unit;
    out.value.push_back(counts ? laid.sheet.number(line, column, laid.format) : not_a_number);
  }
  std::vector<std::size_t> lines;
  for (std::size_t row = 0; row < out.value.size(); ++row)
    if (std::isnan(out.value[row])) {
      lines.push_back(block.rows[row] + 1);
      out.missing.push_back({row, laid.sheet.shown(block.rows[row], column)});
    }
  if (!lines.empty())
    out.notes.push_back(fmt::format("column {}: no number in {} of {} rows: {}{} {}", in_quotes(of.name), lines.size(),
                                    out.value.size(), on_lines(lines),
                                    lines.size() == 1 ? " holds" : "; the first holds",
                                    in_quotes(laid.sheet.shown(lines.front() - 1, column))));
  return out;
}

using ReadColumn = Noted<std::optional<ExportColumn>>;  // nullopt for an omitted column

// A column of a workbook in which enough cells hold numbers and all numbers are dates or clock
// times. It is read as a time, in its unit or in seconds, or as words if its title means no
// reading. nullopt for other columns; their dates are refused where a number is needed.
ReadColumn dated_column(const Laid& laid, const TableBlock& block, ExportColumn out, std::size_t numbers) {
  const std::size_t column = out.number - 1;
  const auto all_are = [&](const auto& is) {
    return numbers ==
           static_cast<std::size_t>(std::count_if(block.rows.begin(), block.rows.end(),
                                                  [&](std::size_t line) { return is(laid.sheet.kind(line, column)); }));
  };
  const bool has_date = all_are([](CellKind kind) { return kind == CellKind::date_and_clock; });
  const bool is_clock = has_date || all_are([](CellKind kind) { return kind == CellKind::clock; });
  const std::optional<Unit> unit = machine_unit(out.unit.empty() ? "s" : out.unit);
  if (out.role == ColumnRole::time && is_clock && unit && unit->dimension == kind::time.dimension) {
    double from = not_a_number;  // [days] midnight before the first date
    for (const std::size_t line : block.rows) {
      const double days = laid.sheet.days(line, column);
      if (std::isnan(from) && !std::isnan(days)) from = has_date ? std::floor(days) : 0;
      out.values.push_back(from_si((days - from) * 86400, *unit));
    }
    if (out.unit.empty()) out.unit = "s";
    std::string said = fmt::format("column {} holds clock times, read in {}{}", in_quotes(out.name), out.unit,
                                   has_date ? ", from the midnight before the first" : "");
    return {std::move(out), {std::move(said)}};
  }
  if (out.role != ColumnRole::other || !all_are(is_dated)) return {};
  out.values.assign(block.rows.size(), not_a_number);
  for (const std::size_t line : block.rows) out.words.push_back(laid.sheet.shown(line, column));
  std::string said = fmt::format("column {} holds dates or clock times and is kept as text", in_quotes(out.name));
  return {std::move(out), {std::move(said)}};
}

ReadColumn column_of(const Laid& laid, const TableBlock& block, const std::vector<std::string>& titles,
                     std::size_t column) {
  std::size_t numbers = 0, words = 0;
  std::string_view unit;  // after the first number
  bool has_dates = false;
  for (const std::size_t line : block.rows) {
    const std::string_view text = laid.sheet.at(line, column);
    const NumberCell parts = number_cell(text);
    if (!parts.number.empty() && numbers++ == 0) unit = parts.unit;
    if (parts.number.empty() && !says_missing(text)) ++words;
    has_dates = has_dates || is_dated(laid.sheet.kind(line, column));
  }
  const std::string title = titles.empty() ? "" : titles[column];
  if (numbers == 0 && words == 0)
    return {{}, title.empty() ? Notes{} : Notes{fmt::format("column {} is empty and left out", in_quotes(title))}};
  auto [name, stated] = title_of(title, block.units.empty() ? "" : block.units[column], unit, block.header_line + 1);
  if (name.empty()) name = fmt::format("column_{}", column + 1);
  ExportColumn out{std::move(name), std::move(stated), ColumnRole::other, {}, column + 1};
  if (numbers < words || numbers == 0) {
    out.values.assign(block.rows.size(), not_a_number);
    for (const std::size_t line : block.rows) out.words.emplace_back(laid.sheet.at(line, column));
    return {std::move(out), {}};
  }
  out.role = role_for(out);
  if (has_dates)
    if (ReadColumn dated = dated_column(laid, block, out, numbers); dated.value) return dated;
  auto [values, notes, missing] = values_of(laid, block, out, unit);
  out.values = std::move(values);
  out.missing = std::move(missing);
  const bool is_empty =
      std::all_of(out.values.begin(), out.values.end(), [](double value) { return std::isnan(value); });
  if (is_empty && !(has_dates && out.role != ColumnRole::other)) return {{}, std::move(notes)};
  return {std::move(out), std::move(notes)};
}

// True if the column holds the unit of the previous column in every row.
bool gives_unit(const ExportColumn& column, const ExportedSpecimen& specimen) {
  if (column.words.empty() || specimen.columns.empty()) return false;
  const ExportColumn& before = specimen.columns.back();
  const std::string& unit = column.words.front();
  return names_a_unit(unit) && before.number + 1 == column.number && before.words.empty() && before.unit.empty() &&
         std::all_of(column.words.begin(), column.words.end(), [&](const std::string& word) { return word == unit; });
}

// ---- specimens

// Makes the lines of a specimen from the rows of the block. The first row remains for notes on the
// table.
Noted<ExportedSpecimen> specimen_of(const Laid& laid, TableBlock& block, const std::vector<std::string>& titles,
                                    const std::vector<std::size_t>& columns, std::vector<Metadatum> metadata) {
  Noted<ExportedSpecimen> out;
  out.value.metadata = std::move(metadata);
  for (const std::size_t each : columns) {
    auto [column, notes] = column_of(laid, block, titles, each);
    append(out.notes, std::move(notes));
    if (column && gives_unit(*column, out.value)) {
      ExportColumn& before = out.value.columns.back();
      before.unit = column->words.front();
      before.role = role_for(before);
    } else if (column) {
      out.value.columns.push_back(std::move(*column));
    }
  }
  out.value.lines = std::exchange(block.rows, {block.rows.front()});
  for (std::size_t& line : out.value.lines) ++line;  // counted from 1
  return out;
}

// The specimens named by a column of words; one specimen without such a column.
std::vector<ExportedSpecimen> split_by_name(ExportedSpecimen all) {
  const auto splits = std::find_if(all.columns.begin(), all.columns.end(), [](const ExportColumn& each) {
    return !each.words.empty() && names_specimens(each.name);
  });
  std::vector<ExportedSpecimen> specimens;
  if (splits == all.columns.end()) {
    specimens.push_back(std::move(all));
    return specimens;
  }
  const std::vector<std::string>& names = splits->words;
  std::map<std::string_view, std::size_t> known;
  std::vector<std::size_t> next(all.columns.size());  // next cell without a number in each column
  for (std::size_t row = 0; row < names.size(); ++row) {
    const auto [at, is_new] = known.emplace(names[row], specimens.size());
    if (is_new) {
      specimens.push_back({.name = names[row], .metadata = all.metadata});
      for (const ExportColumn& column : all.columns)
        specimens.back().columns.push_back({column.name, column.unit, column.role, {}, column.number});
    }
    ExportedSpecimen& one = specimens[at->second];
    one.lines.push_back(all.lines[row]);
    for (std::size_t i = 0; i < all.columns.size(); ++i) {
      one.columns[i].values.push_back(all.columns[i].values[row]);
      const std::vector<CellWithoutNumber>& missing = all.columns[i].missing;
      if (next[i] < missing.size() && missing[next[i]].row == row)
        one.columns[i].missing.push_back({one.lines.size() - 1, missing[next[i]++].says});
      if (!all.columns[i].words.empty()) one.columns[i].words.push_back(all.columns[i].words[row]);
    }
  }
  return specimens;
}

// True for another specimen, with columns of the same names or meanings; false for a table of
// results.
bool is_specimen(const TableBlock& block, const TableBlock& main) {
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

// A number of an additional table as a metadatum. It is named by its column and, if there are
// several rows, by the first cell of its row.
struct SummaryNumber {
  std::string row;
  Metadatum datum;
};

std::vector<SummaryNumber> summaries_in(const Laid& laid, const TableBlock& block) {
  std::vector<SummaryNumber> summaries;
  for (const std::size_t line : block.rows) {
    const std::string_view first = laid.sheet.at(line, 0);
    const bool labelled = number_cell(first).number.empty() || block.titles.front().empty();
    for (std::size_t column = labelled ? 1 : 0; column < laid.layout.columns; ++column) {
      const std::string_view value = laid.sheet.at(line, column);
      if (value.empty()) continue;
      const std::string& title = block.titles[column];
      const std::string unit = block.units.empty() || block.units[column].empty() ? "" : " " + block.units[column];
      summaries.push_back({block.rows.size() > 1 ? std::string(first) : "",
                           {title.substr(0, title.find_last_not_of(": \t") + 1), std::string(value) + unit, line + 1}});
    }
  }
  return summaries;
}

std::vector<Metadatum> metadata_on(const Sheet& sheet, const std::vector<std::size_t>& lines) {
  std::vector<Metadatum> metadata;
  for (const std::size_t line : lines) append(metadata, metadata_on_line(sheet, line));
  return metadata;
}

// The content of a table. Its metadata belong to the file if it is the first table with specimens
// or has no specimens.
struct ReadBlock {
  std::vector<ExportedSpecimen> specimens;
  std::vector<Metadatum> metadata;
  std::vector<SummaryNumber> summaries;
  Notes notes;
};

ReadBlock block_of(const Laid& laid, TableBlock& block, const TableBlock& main, bool is_first) {
  const std::vector<std::string>& titles = block.titles.empty() ? main.titles : block.titles;
  const std::vector<ColumnGroup> groups = side_by_side(titles);
  std::vector<std::size_t> remarks = block.remarks;
  if (!groups.empty()) std::erase(remarks, block.header_line - 1);  // the names of the specimens
  std::vector<Metadatum> own = metadata_on(laid.sheet, remarks);
  ReadBlock out;
  if (is_first || !is_specimen(block, main)) out.metadata = std::exchange(own, {});
  if (!is_specimen(block, main)) {
    if (block.rows.size() > longest_summary)
      out.notes.push_back(fmt::format("left out: another table, with other columns, on lines {} to {}",
                                      block.rows.front() + 1, block.rows.back() + 1));
    else
      out.summaries = summaries_in(laid, block);
    return out;
  }
  if (groups.empty()) {
    std::vector<std::size_t> columns(laid.layout.columns);
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    auto [specimen, notes] = specimen_of(laid, block, titles, columns, std::move(own));
    specimen.name = block.name;
    out.specimens = split_by_name(std::move(specimen));
    out.notes = std::move(notes);
    return out;
  }
  // Specimens side by side, each with the rows in which it has a cell. The name is above its first
  // title.
  for (const ColumnGroup& group : groups) {
    TableBlock rows = block;
    std::erase_if(rows.rows, [&](std::size_t line) {
      return std::all_of(group.columns.begin(), group.columns.end(), [&](std::size_t column) {
        return column < group.first || laid.sheet.at(line, column).empty();
      });
    });
    if (rows.rows.empty()) continue;
    auto [specimen, notes] = specimen_of(laid, rows, titles, group.columns, own);
    const std::string_view above = block.header_line > 0 ? laid.sheet.at(block.header_line - 1, group.first) : "";
    if (number_cell(above).number.empty()) specimen.name = above;
    out.specimens.push_back(std::move(specimen));
    append(out.notes, std::move(notes));
  }
  out.notes.push_back(fmt::format("{} specimens are side by side, with the same titles", groups.size()));
  return out;
}

// Names the specimens: by the file, or if there are several, by a line above each table. A summary
// of one of several specimens becomes its metadata, otherwise metadata of the file.
Export named(Export file, const std::vector<SummaryNumber>& summaries) {
  const bool several = file.specimens.size() > 1;
  for (std::size_t i = 0; i < file.specimens.size(); ++i) {
    ExportedSpecimen& specimen = file.specimens[i];
    if (!specimen.name.empty()) continue;
    specimen.name = specimen_name(several && i > 0 ? specimen.metadata : file.metadata);
    std::vector<Metadatum>& above = i > 0 ? specimen.metadata : file.metadata;
    if (!several || !specimen.name.empty() || above.empty() || !above.back().value.empty()) continue;
    specimen.name = above.back().name;
    above.pop_back();
  }
  for (const auto& [row, datum] : summaries) {
    const auto own = std::find_if(file.specimens.begin(), file.specimens.end(),
                                  [&name = row](const ExportedSpecimen& each) { return each.name == name; });
    if (several && own != file.specimens.end())
      own->metadata.push_back(datum);
    else
      file.metadata.push_back({row.empty() ? datum.name : row + " " + datum.name, datum.value, datum.line});
  }
  return file;
}

// ---- the whole file

// The format from the marks of the program, "Instron Bluehill", ...; otherwise "table".
// `has_bracketed_units`: the units are in brackets on their own line.
std::string program_of(const Export& file, bool has_bracketed_units) {
  const auto has = [](std::string_view text, std::string_view word) {
    return text.find(word) != std::string_view::npos;
  };
  std::string titles;
  for (const ExportColumn& column : file.specimens.front().columns) titles += folded(column.name) + "|";
  std::string preamble;
  for (const Metadatum& datum : file.metadata) preamble += folded(datum.name) + "|";
  if (has(preamble, "mts793")) return "MTS 793";
  if (has(preamble, "file path") && has(preamble, "test run")) return "MTS TestSuite";
  for (const std::string_view word :
       {"standardkraft", "standardweg", "force standard", "course standard", "standard force", "standard travel"})
    if (has(titles, word)) return "Zwick testXpert";
  if (file.origin.encoding == Encoding::shift_jis || has(titles, "試験力") || has(titles, "ストローク"))
    return "Shimadzu Trapezium";
  if (has(titles, "setname|cycle")) return "CellScale";
  if (has(titles, "run #")) return "PASCO Capstone";
  const bool bluehill_names = has(titles, "time|") && (has(titles, "extension|") || has(titles, "displacement|")) &&
                              (has(titles, "load|") || has(titles, "force|"));
  if (bluehill_names && (has_bracketed_units || has(preamble, "raw data") || has(preamble, "results table")))
    return "Instron Bluehill";
  return "table";
}

// The note on rows with another number of cells; empty without such rows.
std::string misfits_of(const Layout& layout) {
  std::vector<std::size_t> lines;
  for (const TableBlock& block : layout.blocks)
    for (const auto& apart : {block.misfits, block.between})
      for (const std::size_t line : apart) lines.push_back(line + 1);
  if (lines.empty()) return "";
  std::sort(lines.begin(), lines.end());
  return fmt::format("left out, because they do not have {} cells: {}", layout.columns, on_lines(lines));
}

Notes notes_on(const Layout& layout) {
  Notes notes;
  if (std::string misfits = misfits_of(layout); !misfits.empty()) notes.push_back(std::move(misfits));
  if (layout.cut_off)
    notes.emplace_back("the file ends in the middle of a row, which is left out; check that the file is complete");
  for (const TableBlock& block : layout.blocks) append(notes, block.notes);
  if (const TableBlock& first = layout.blocks.front(); first.titles.empty())
    notes.push_back(first.unplaced.empty()
                        ? fmt::format("no line above line {} names {} columns", first.rows.front() + 1, layout.columns)
                        : first.unplaced);
  append(notes, layout.notes);
  return notes;
}

// Without names, only columns of numbers are a table: others may be the rest of a preamble.
void require_names(const Export& file, const TableBlock& main) {
  for (const ExportColumn& column : file.specimens.front().columns)
    if (main.titles.empty() && !column.words.empty())
      throw InputError({.line = main.rows.front() + 1,
                        .problem = fmt::format("No line above the rows of numbers and words names the columns{}",
                                               main.unplaced.empty() ? "" : ": " + main.unplaced),
                        .remedy = main.unplaced.empty() ? "add one, or export the raw data of the test as CSV"
                                                        : "add the title that is missing, or delete the one too many"});
}

// Refuses dates in a column with a meaning.
void require_no_dates(const Export& file, const SheetFile& sheet) {
  for (const ExportedSpecimen& specimen : file.specimens)
    for (const ExportColumn& column : specimen.columns)
      for (std::size_t row = 0; column.role != ColumnRole::other && row < specimen.lines.size(); ++row)
        if (std::isnan(column.values[row]) && is_dated(sheet.cells.kind(specimen.lines[row] - 1, column.number - 1)))
          throw dated(sheet, specimen.lines[row] - 1, column.number - 1,
                      fmt::format("a number in the column {}", in_quotes(column.name)));
}

// The content of a sheet.
Export recognise(const SheetFile& opened, const ExportOptions& options) {
  const Sheet& sheet = opened.cells;
  Layout layout = layout_of(sheet);
  const auto [format, apply] = marks_in(sheet, layout, options, opened.origin.separator);
  Export file{
      .origin = opened.origin, .marks = format, .has_marks = apply, .quoted = sheet.quoted(), .notes = opened.notes};
  const TableBlock& main =
      *std::max_element(layout.blocks.begin(), layout.blocks.end(),
                        [](const auto& a, const auto& b) { return a.rows.size() < b.rows.size(); });
  std::vector<SummaryNumber> summaries;
  for (TableBlock& block : layout.blocks) {
    ReadBlock read = block_of({sheet, layout, format}, block, main, file.specimens.empty());
    append(file.specimens, std::move(read.specimens));
    append(file.metadata, std::move(read.metadata));
    append(file.notes, std::move(read.notes));
    append(summaries, std::move(read.summaries));
  }
  require_names(file, main);
  append(file.metadata, metadata_on(sheet, layout.remarks));
  append(file.notes, notes_on(layout));
  for (const std::string& note : opened.notes)
    if (note != opened.origin.which_sheet) file.row_notes.push_back(note);
  file.row_notes.insert(file.row_notes.end(), layout.notes.begin(), layout.notes.end());
  if (std::string misfits = misfits_of(layout); !misfits.empty()) file.row_notes.push_back(std::move(misfits));
  for (const TableBlock& block : layout.blocks) append(file.row_notes, block.notes);
  file.unplaced = main.unplaced;
  if (!main.unplaced.empty()) file.row_notes.push_back(main.unplaced);
  file = named(std::move(file), summaries);
  file.test = test_in(all_metadata(file), format);
  const bool has_bracketed_units = !main.titles.empty() && !main.units.empty() &&
                                   sheet.text(main.header_line + 1).find('(') != std::string_view::npos;
  file.format = program_of(file, has_bracketed_units);
  file = decided(std::move(file), options, layout.blocks.front().header_line + 1);
  require_no_dates(file, opened);
  return file;
}

bool is_empty(const Sheet& sheet) {
  for (std::size_t line = 0; line < sheet.size(); ++line)
    if (!trimmed(sheet.text(line)).empty()) return false;
  return true;
}

// Adds the place to an error.
Export recognised(const SheetFile& file, const ExportOptions& options) {
  try {
    if (is_empty(file.cells))
      throw InputError({.problem = file.origin.byte_order_mark ? "The file holds a byte order mark and nothing else"
                                                               : "The file is empty",
                        .remedy = "export the test again"});
    return recognise(file, options);
  } catch (const InputError& error) {
    const InputFault& fault = error.fault;
    const bool is_placed = !fault.file.empty() || is_of_call(fault);
    throw with_other_sheets(is_placed ? error : located(error, file.origin.source, fault.line, fault.field),
                            file.origin);
  }
}

// A mark as the user wrote it: "," or "comma", "none".
char mark_named(const std::string& text, std::string_view flag) {
  if (text.size() == 1) return text.front();
  if (text == "tab" || text == "\\t") return '\t';
  if (text == "space") return ' ';
  if (text == "comma") return ',';
  if (text == "semicolon") return ';';
  if (text == "point") return '.';
  if (text == "apostrophe") return '\'';
  if (text == "none") return '\0';
  throw InputError(
      {.field = std::string(flag),
       .problem = fmt::format("{} is neither one character nor comma, semicolon, point, tab, space, apostrophe or none",
                              in_quotes(text))});
}

char mark_of(const std::string& text, std::string_view flag, std::string_view allowed) {
  const char mark = mark_named(text, flag);
  if (allowed.find(mark) == std::string_view::npos)
    throw InputError(
        {.field = std::string(flag),
         .problem = fmt::format("{} is not one of {}", in_quotes(text), allowed == ".," ? ". and ," : allowed)});
  return mark;
}

}  // namespace

std::string said(const ReadingWords& words, std::string_view name) {
  const auto found = words.find(name);
  return found == words.end() ? std::string() : found->second;
}

ExportOptions options_of(const ReadingWords& words) {
  using namespace std::string_view_literals;
  const auto said = [&](std::string_view name) { return flexslip::said(words, name); };
  ExportOptions options;
  if (const std::string sheet = said("sheet"); !sheet.empty()) options.file.sheet = sheet;
  if (const std::string number = said("sheet-number"); !number.empty())
    options.file.sheet = std::size_t{std::stoul(number)};
  if (const std::string name = said("encoding"); !name.empty()) options.file.encoding = encoding_named(name);
  if (const std::string mark = said("separator"); !mark.empty())
    options.file.separator = mark_named(mark, "--separator");
  if (const std::string mark = said("decimal"); !mark.empty()) options.decimal = mark_of(mark, "--decimal", ".,");
  if (const std::string mark = said("thousands"); !mark.empty())
    options.thousands = mark_of(mark, "--thousands", "., '\0"sv);
  for (const ColumnRole role : {ColumnRole::time, ColumnRole::crosshead, ColumnRole::deflection, ColumnRole::force})
    if (const std::string column = said(words_for(role).word()); !column.empty()) options.columns[role] = column;
  for (const ColumnRole role : {ColumnRole::time, ColumnRole::displacement, ColumnRole::force})
    if (const std::string unit = said(words_for(role).unit_flag.substr(2)); !unit.empty()) options.units[role] = unit;
  if (const std::string calibration = said("calibration"); !calibration.empty()) {
    if (!calibration.ends_with("/V"))
      throw InputError({.field = "--calibration",
                        .problem = fmt::format("{} is not a calibration such as \"222 N/V\"", in_quotes(calibration))});
    options.units[ColumnRole::force] = calibration;
  }
  if (const std::string which = said("displacement"); !which.empty())
    options.displacement = which == "crosshead" ? ColumnRole::crosshead : ColumnRole::deflection;
  return options;
}

std::vector<Metadatum> all_metadata(const Export& file) {
  std::vector<Metadatum> all = file.metadata;
  if (file.specimens.size() == 1) {
    const std::vector<Metadatum>& own = file.specimens.front().metadata;
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

Export read_export(const std::string& path, const ExportOptions& options) {
  return recognised(open_sheet(path, options.file, SheetFor::readings), options);
}

Export export_in(std::string bytes, const std::string& source, const ExportOptions& options) {
  return recognised(sheet_in(std::move(bytes), source, options.file, SheetFor::readings), options);
}

std::vector<double> in_si(const Export& file, const ExportColumn& column, const Kind& kind) {
  const RoleWords& words = words_for(column.role);
  return in_si(file, column, kind, words.usual_unit, [&](std::string_view unit) {
    return fmt::format("state it with {0}, as in {0} {1}", words.unit_flag, unit);
  });
}

std::vector<double> in_si(const Export& file, const ExportColumn& column, const Kind& kind, std::string_view usual_unit,
                          const std::function<std::string(std::string_view unit)>& remedy) {
  const bool is_plain = kind.dimension == Dimension{} && column.unit.empty();
  const std::optional<Unit> unit = is_plain ? Unit{} : machine_unit(column.unit);
  const auto refuse = [&](std::string found) {
    const bool is_voltage = kind.dimension == kind::force.dimension && volts_in(column.unit);
    const std::vector<std::string_view> meant = meant_units(column.unit, kind);
    std::string with = remedy(meant.empty() ? usual_unit : meant.front());
    if (!meant.empty()) with = fmt::format("if {} is meant, {}", fmt::join(meant, " or "), with);
    throw InputError(
        {.file = file.origin.source,
         .field = "column " + in_quotes(column.name),
         .problem = fmt::format("A unit of {} is needed, but the column has {}", noun(kind), found),
         .remedy = is_voltage ? "state the calibration of the load cell, --calibration \"… N/V\"" : std::move(with)});
  };
  const std::size_t open = column.name.ends_with(')') ? column.name.rfind('(') : std::string::npos;
  const std::string in_brackets =
      open == std::string::npos ? "" : column.name.substr(open + 1, column.name.size() - open - 2);
  if (column.unit.empty() && !is_plain)
    refuse(in_brackets.empty() ? "none" : fmt::format("none: {} is not a unit", in_quotes(in_brackets)));
  if (!unit) refuse(in_quotes(column.unit) + (volts_in(column.unit) ? "" : ", which is unknown"));
  if (unit->dimension != kind.dimension) refuse(in_quotes(column.unit));
  std::vector<double> values;
  values.reserve(column.values.size());
  for (const double value : column.values) values.push_back(to_si(value, *unit));
  return values;
}

RowsLeftOut rows_without_numbers(const Export& file, const ExportedSpecimen& specimen,
                                 const std::vector<const ExportColumn*>& columns, std::size_t rows_used) {
  constexpr std::size_t most_missing_share =
      10;  // rows per row without a number, at least; with more gaps, the record is unknown
  rows_used = std::min(rows_used, specimen.lines.size());
  RowsLeftOut out;
  std::vector<std::string> names;
  std::string says;
  for (const ExportColumn* column : columns) {
    if (column->missing.empty()) continue;
    names.push_back(column->name);
    if (says.empty()) says = column->missing.front().says;
    std::size_t last = rows_used;  // the last row with a number
    while (last > 0 && std::isnan(column->values[last - 1])) --last;
    std::vector<std::size_t> lines;
    std::string word;
    for (const CellWithoutNumber& cell : column->missing) {
      out.rows.push_back(cell.row);
      if (!says_overload(cell.says) || cell.row >= last) continue;
      lines.push_back(specimen.lines[cell.row]);
      if (word.empty()) word = cell.says;
    }
    if (!lines.empty())
      throw InputError({.file = file.origin.source,
                        .line = lines.front(),
                        .field = "column " + in_quotes(column->name),
                        .problem = fmt::format("The sensor was overloaded ({} on {}), and readings follow",
                                               in_quotes(word), on_lines(lines)),
                        .remedy = "end the record before, with until or --until, or measure with a larger range",
                        .part = TablePart::cell});
  }
  std::sort(out.rows.begin(), out.rows.end());
  out.rows.erase(std::unique(out.rows.begin(), out.rows.end()), out.rows.end());
  if (out.rows.empty()) return out;
  std::vector<std::size_t> lines;
  for (const std::size_t row : out.rows) lines.push_back(specimen.lines[row]);
  const std::string which = fmt::format("{} {} {}", on_lines(lines), lines.size() == 1 ? "holds" : "hold",
                                        says.empty() ? "nothing" : in_quotes(says));
  if (out.rows.size() * most_missing_share > specimen.lines.size())
    throw InputError({.file = file.origin.source,
                      .line = lines.front(),
                      .field = (names.size() == 1 ? "column " : "columns ") + listed(names),
                      .problem = fmt::format("{} of {} rows have no number here; at most a tenth may ({})",
                                             out.rows.size(), specimen.lines.size(), which),
                      .remedy = "export the readings again, or choose another column",
                      .part = TablePart::cell});
  out.words = fmt::format("{} without a number in {} {} left out: {}",
                          out.rows.size() == 1 ? "one row" : fmt::format("{} rows", out.rows.size()), listed(names),
                          out.rows.size() == 1 ? "is" : "are", which);
  return out;
}

bool is_called(const ExportColumn& column, std::string_view title) {
  if (column.name == title) return true;
  if (column.unit.empty()) return false;
  return title == fmt::format("{} [{}]", column.name, column.unit) ||
         title == fmt::format("{} ({})", column.name, column.unit) ||
         title == fmt::format("{}_{}", column.name, column.unit);
}

std::size_t column_named(const Export& file, const ExportedSpecimen& specimen, std::string_view wanted,
                         std::string_view flag) {
  std::vector<std::size_t> by_number, by_name;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < specimen.columns.size(); ++i) {
    const ExportColumn& column = specimen.columns[i];
    names.push_back(column.name);
    if (std::to_string(column.number) == wanted) by_number.push_back(i);
    if (is_called(column, wanted)) by_name.push_back(i);
  }
  const std::vector<std::size_t>& found = by_number.empty() ? by_name : by_number;
  const auto refuse = [&](std::string problem, std::string remedy) {
    throw InputError({.file = file.origin.source,
                      .field = std::string(flag),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  if (found.empty())
    refuse(fmt::format("No column is called {}; the file has {}", in_quotes(wanted), listed(names)),
           did_you_mean(wanted, names));
  const ExportColumn& column = specimen.columns[found.front()];
  if (found.size() > 1)
    refuse(fmt::format("{} columns are called {}", found.size(), in_quotes(wanted)),
           fmt::format("give its number: {} {}", flag, column.number));
  if (!column.words.empty()) refuse(fmt::format("The column {} holds words, not numbers", in_quotes(column.name)), "");
  return found.front();
}

namespace {

// The column whose title has a role but whose cells are words; nullptr without such a column.
const ExportColumn* words_titled_as(const ExportedSpecimen& specimen, ColumnRole role) {
  const auto at = std::find_if(specimen.columns.begin(), specimen.columns.end(), [=](const ExportColumn& each) {
    return !each.words.empty() && role_of(each.name) == role;
  });
  return at == specimen.columns.end() ? nullptr : &*at;
}

}  // namespace

const ExportColumn& column_with(const Export& file, const ExportedSpecimen& specimen, ColumnRole role,
                                std::string remedy) {
  std::vector<std::string> names, all;
  const ExportColumn* found = nullptr;
  for (const ExportColumn& column : specimen.columns) {
    all.push_back(column.name);
    if (column.role != role) continue;
    found = &column;
    names.push_back(column.name);
  }
  if (names.size() == 1) return *found;
  const std::string_view wanted = is_displacement(role) ? "displacement" : words_for(role).name;
  const ExportColumn* of_words = names.empty() ? words_titled_as(specimen, role) : nullptr;
  if (of_words)
    throw InputError({.file = file.origin.source,
                      .field = fmt::format("column {}, {}", of_words->number, in_quotes(of_words->name)),
                      .problem = fmt::format("This column holds no numbers (row 1: {})", in_quotes(of_words->words[0])),
                      .remedy = "export the test again"});
  if (remedy.empty()) remedy = fmt::format("pass {} \"TITLE\"", words_for(role).flag);
  const std::string unplaced = file.unplaced.empty() ? "" : ", as " + file.unplaced;
  throw InputError(
      {.file = file.origin.source,
       .problem = names.empty()
                      ? fmt::format("No column is recognised as {} among {}{}", wanted, listed(all), unplaced)
                      : fmt::format("Several columns are recognised as {}: {}{}", wanted, listed(names), unplaced),
       .remedy = std::move(remedy)});
}

}  // namespace flexslip
