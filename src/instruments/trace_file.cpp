#include "instruments/trace_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "instruments/column_unit.h"
#include "instruments/column_words.h"
#include "io/input_error.h"
#include "io/table.h"
#include "io/text.h"
#include "surface/texture.h"

namespace flexslip {
namespace {

constexpr std::array<std::string_view, 9> of_position{"x",      "s",       "position", "distance", "lateral",
                                                      "length", "abstand", "weg",      "arc"};
constexpr std::array<std::string_view, 9> of_height{"z",    "y",       "height", "topography", "profile",
                                                    "edge", "zsensor", "höhe",   "elevation"};

std::string bytes_of(const std::string& path) {
  const auto in = open_to_read(path);
  return {std::istreambuf_iterator<char>(*in), {}};
}

// Gwyddion's gnuplot style has its titles in a comment, "# x [m]  y [m]", right above the numbers: without its mark they are read as titles.
std::string with_titles(std::string bytes) {
  std::size_t last = std::string::npos;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string_view line = trimmed(std::string_view(bytes).substr(at, end - at));
    if (!line.empty() && line.front() != '#') break;
    if (line.find('[') != std::string_view::npos && line.find(']') != std::string_view::npos)
      last = at + bytes.substr(at, end - at).find('#');
    at = end + 1;
  }
  if (last != std::string::npos) bytes[last] = ' ';
  return bytes;
}

class TraceColumns {
 public:
  TraceColumns(const Export& file, const ExportedSpecimen& columns) : file_(file), columns_(columns) {
    for (const ExportColumn& column : columns.columns)
      if (column.words.empty()) numeric_.push_back(&column);
  }

  std::size_t count() const { return numeric_.size(); }

  // The one that a user names, and the unit that is named with it.
  std::pair<const ExportColumn*, std::string> named(const std::string& wanted, std::string_view flag) const {
    std::vector<std::string> names;
    for (const ExportColumn* column : numeric_) {
      names.push_back(column->name);
      if (wanted == std::to_string(column->number) || wanted == column->name) return {column, ""};
    }
    const ColumnTitle title = parse_column_title(wanted);
    for (const ExportColumn* column : numeric_)
      if (title.name == column->name) return {column, title.unit};
    const std::string meant = nearest(title.name, names);
    throw InputError({.file = file_.source,
                      .field = std::string(flag),
                      .expected = "one of the columns " + listed(names) + ", or its number",
                      .found = in_quotes(wanted),
                      .remedy = meant.empty() ? "" : "did you mean " + in_quotes(meant) + "?"});
  }

  // The one whose words say what it is.
  const ExportColumn* told(std::span<const std::string_view> words, const ExportColumn* but) const {
    for (const std::string_view word : words)
      for (const ExportColumn* column : numeric_) {
        if (column == but) continue;
        const std::string name = folded(column->name);
        if (name == word || name.starts_with(std::string(word) + " ") || name.starts_with(std::string(word) + "_") ||
            (word.size() > 3 && name.find(word) != std::string::npos))
          return column;
      }
    return nullptr;
  }

  const ExportColumn* other_than(const ExportColumn* one) const {
    const auto other = std::find_if(numeric_.begin(), numeric_.end(), [&](const auto* each) { return each != one; });
    return other == numeric_.end() ? nullptr : *other;
  }

  const ExportColumn* at(std::size_t i) const { return numeric_.at(i); }

  [[noreturn]] void ask(std::string_view what, std::string_view flag) const {
    std::vector<std::string> names;
    for (const ExportColumn* column : numeric_) names.push_back(column->name);
    throw InputError({.file = file_.source,
                      .expected = fmt::format("a column known to hold the {}", what),
                      .found = "the columns " + listed(names),
                      .remedy = fmt::format("name it with {}, by name or number", flag)});
  }

  std::vector<double> values(const ExportColumn& column, const std::string& unit_given, const Kind& kind,
                             std::string_view flag) const {
    const auto refuse = [&](std::size_t line, std::string expected, std::string found, std::string remedy) {
      throw InputError({file_.source, line, "column " + in_quotes(column.name), std::move(expected), std::move(found),
                        std::move(remedy)});
    };
    Unit unit{};
    if (kind.dimension == Dimension{}) {
      if (!column.unit.empty() || !unit_given.empty())
        refuse(0, "plain numbers, in spans, as the case is reduced", in_quotes(column.unit + unit_given), "");
    } else {
      const std::optional<Unit> stated = column.unit.empty() ? std::nullopt : machine_unit(column.unit);
      const std::optional<Unit> given = unit_given.empty() ? std::nullopt : machine_unit(unit_given);
      const std::string remedy = fmt::format("state it with {}, as in {} um", flag, flag);
      if (!unit_given.empty() && (!given || given->dimension != kind.dimension))
        throw InputError({.field = std::string(flag), .expected = "a unit of length", .found = in_quotes(unit_given)});
      if (!given && column.unit.empty()) refuse(0, "a unit of length", "none", remedy);
      if (!given && (!stated || stated->dimension != kind.dimension))
        refuse(0, "a unit of length", in_quotes(column.unit), remedy);
      if (given && stated && *given != *stated)
        refuse(0, fmt::format("the unit {}, as you say", in_quotes(unit_given)), in_quotes(column.unit),
               "leave the unit out, as the file states it");
      unit = given ? *given : *stated;
    }
    std::vector<double> values;
    values.reserve(column.values.size());
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      if (!std::isfinite(column.values[row])) refuse(columns_.lines[row], "a number", "none", "delete the line");
      values.push_back(to_si(column.values[row], unit));
    }
    return values;
  }

 private:
  const Export& file_;
  const ExportedSpecimen& columns_;
  std::vector<const ExportColumn*> numeric_;
};

void require_rising(const TraceFile& read, std::span<const double> x, const Kind& kind) {
  const bool falls = x.back() < x.front();
  for (std::size_t i = 1; i < x.size(); ++i)
    if (falls ? !(x[i] < x[i - 1]) : !(x[i] > x[i - 1]))
      throw InputError({.file = read.source,
                        .line = read.lines[i],
                        .field = "column " + in_quotes(read.position),
                        .expected = fmt::format("positions that {} from row to row", falls ? "fall" : "rise"),
                        .found = fmt::format("{} after {}", readable(x[i], kind), readable(x[i - 1], kind)),
                        .remedy = "a trace runs one way: cut the file, or choose another column"});
}

}  // namespace

TraceFile read_trace(const std::string& path, const TraceOptions& options, const Kind& kind) {
  const std::string source = path == "-" ? "standard input" : path;
  const Export file = read_export(with_titles(bytes_of(path)), source, options.file);
  if (file.specimens.size() != 1)
    throw InputError({.file = source,
                      .expected = "one trace",
                      .found = fmt::format("{} tables", file.specimens.size()),
                      .remedy = "write each into a file of its own"});
  const ExportedSpecimen& table = file.specimens.front();
  const TraceColumns columns(file, table);
  TraceFile read{source, "", "", table.lines, {}, file.notes};
  if (columns.count() == 0) columns.ask("height", "--height");

  const ExportColumn* position = nullptr;
  const ExportColumn* height = nullptr;
  std::string position_unit = options.position_unit, height_unit = options.height_unit;
  const auto take = [&](const std::string& wanted, std::string_view flag, std::string& unit) {
    const auto [column, stated] = columns.named(wanted, flag);
    if (!stated.empty()) unit = stated;
    return column;
  };
  if (!options.position.empty()) position = take(options.position, "--position", position_unit);
  if (!options.height.empty()) height = take(options.height, "--height", height_unit);
  const bool has_positions = !options.step && (position || columns.count() > 1);
  if (!position && has_positions) {
    position = columns.count() == 2 ? (height ? columns.other_than(height) : columns.at(0))
                                    : columns.told(of_position, height);
    if (!position) columns.ask("position", "--position");
  }
  if (!height) {
    height = columns.count() == 1               ? columns.at(0)
             : columns.count() == 2 && position ? columns.other_than(position)
                                                : columns.told(of_height, position);
    if (!height) columns.ask("height", "--height");
  }
  read.height = height->name;
  const std::vector<double> z = columns.values(*height, height_unit, kind, "--height-unit");
  if (z.size() < fewest_heights)
    throw InputError({.file = source,
                      .expected = fmt::format("{} heights or more", fewest_heights),
                      .found = fmt::format("{}", z.size())});
  if (!has_positions) {
    if (!options.step)
      throw InputError({.file = source,
                        .expected = "a column of positions beside the heights, or their distance",
                        .found = fmt::format("the column {}", in_quotes(height->name)),
                        .remedy = "state the distance with --step, as in --step \"0.1 um\""});
    read.sampled = {{0, *options.step, z}, false, 0, false};
    return read;
  }
  if (position == height)
    throw InputError({.file = source, .expected = "two columns", .found = in_quotes(height->name) + " for both"});
  read.position = position->name;
  const std::vector<double> x = columns.values(*position, position_unit, kind, "--position-unit");
  require_rising(read, x, kind);
  read.sampled = sampled(x, z);
  if (read.sampled.turned) std::reverse(read.lines.begin(), read.lines.end());
  if (read.sampled.turned) read.notes.emplace_back("positions fall, so the rows are read in reverse order");
  if (read.sampled.interpolated)
    read.notes.push_back(
        fmt::format("distances differ by up to {:.0f} % from their mean: heights are interpolated at "
                    "the mean distance",
                    100 * read.sampled.unevenness));
  return read;
}

}  // namespace flexslip
