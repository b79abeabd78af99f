#include "instruments/trace_file.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/table.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::array<std::string_view, 9> of_position{"x",      "s",       "position", "distance", "lateral",
                                                      "length", "abstand", "weg",      "arc"};
constexpr std::array<std::string_view, 9> of_height{"z",    "y",       "height", "topography", "profile",
                                                    "edge", "zsensor", "höhe",   "elevation"};

// A column of numbers, and the unit that the user states with it; otherwise empty.
struct TraceColumn {
  const ExportColumn* column;
  std::string unit;
};

using Columns = std::vector<const ExportColumn*>;

std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for (const ExportColumn* column : columns) names.push_back(column->name);
  return names;
}

// The column that the user names, perhaps with its unit in brackets.
TraceColumn named(const Export& file, const std::string& wanted, std::string_view key) {
  const ExportedSpecimen& all = file.specimens.front();
  const bool is_whole = std::any_of(all.columns.begin(), all.columns.end(),
                                    [&](const ExportColumn& column) { return column.name == wanted; });
  const ColumnTitle title = is_whole ? ColumnTitle{wanted, ""} : parse_column_title(wanted);
  return {&all.columns[column_named(file, all, title.name, key)], title.unit};
}

// The column whose title means the quantity.
const ExportColumn* told(const Columns& columns, std::span<const std::string_view> words, const ExportColumn* but) {
  for (const std::string_view word : words)
    for (const ExportColumn* column : columns) {
      if (column == but) continue;
      const std::string name = folded(column->name);
      const bool begins = name.starts_with(word) &&
                          (name.size() == word.size() || name[word.size()] == ' ' || name[word.size()] == '_');
      if (begins || (word.size() > 3 && name.find(word) != std::string::npos)) return column;
    }
  return nullptr;
}

// The other one of two columns.
const ExportColumn* other_than(const Columns& two, const ExportColumn* one) { return two[one == two[0] ? 1 : 0]; }

[[noreturn]] void ask(const Export& file, const Columns& columns, std::string_view what) {
  throw InputError(
      {.file = file.origin.source,
       .problem = fmt::format("No column among {} is recognised as the {}", listed(names_of(columns)), what),
       .remedy = fmt::format("write {} = \"…\" into [friction], its name or number", what)});
}

// The values of a column [SI, or reduced].
std::vector<double> values_of(const Export& file, const TraceColumn& of, const Kind& kind, std::string_view key) {
  ExportColumn column = *of.column;
  const auto refuse = [&](std::string problem, std::string remedy) {
    throw InputError({.file = file.origin.source,
                      .field = "column " + in_quotes(column.name),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  const std::optional<Unit> stated = machine_unit(column.unit), given = machine_unit(of.unit);
  if (kind.dimension == Dimension{} && !(column.unit.empty() && of.unit.empty()))
    refuse(fmt::format("The case is reduced, so the column holds plain numbers, in spans, without the unit {}",
                       in_quotes(column.unit + of.unit)),
           "");
  if (!of.unit.empty()) {
    if (!given || given->dimension != kind.dimension)
      throw InputError(
          {.field = std::string(key), .problem = fmt::format("{} is not a unit of length", in_quotes(of.unit))});
    if (stated && *given != *stated)
      refuse(fmt::format("The unit in the file is {}, not {}", in_quotes(column.unit), in_quotes(of.unit)),
             "leave the unit out, as the file states it");
    column.unit = of.unit;
  }
  return in_si(file, column, kind, "um", [&](std::string_view unit) {
    return fmt::format("write {} = \"{} [{}]\" into [friction]", key, column.name, unit);
  });
}

void require_rising(const Export& file, const ExportColumn& column, std::span<const double> x, const Kind& kind) {
  const bool falls = x.back() < x.front();
  for (std::size_t i = 1; i < x.size(); ++i)
    if (falls ? !(x[i] < x[i - 1]) : !(x[i] > x[i - 1]))
      throw InputError(
          {.file = file.origin.source,
           .line = file.specimens.front().lines[i],
           .field = "column " + in_quotes(column.name),
           .problem = fmt::format("Positions must {} throughout, but {} follows {}", falls ? "decrease" : "increase",
                                  readable(x[i], kind), readable(x[i - 1], kind)),
           .remedy = "split the file, or choose another column"});
}

}  // namespace

TraceFile read_trace(const std::string& path, const TraceOptions& options, const Kind& kind) {
  const Export file = read_export(path);
  if (file.specimens.size() != 1)
    throw InputError({.file = file.origin.source,
                      .problem = fmt::format("The file holds {} tables, not one trace", file.specimens.size()),
                      .remedy = "write each into a file of its own"});
  TraceFile read{file.origin.source, "", "", {}};
  Columns columns;
  for (const ExportColumn& column : file.specimens.front().columns)
    if (column.words.empty()) columns.push_back(&column);
  if (columns.empty()) ask(file, columns, "height");

  TraceColumn position{nullptr, ""}, height{nullptr, ""};
  if (!options.position.empty()) position = named(file, options.position, "position");
  if (!options.height.empty()) height = named(file, options.height, "height");
  const bool has_positions = !options.step && (position.column != nullptr || columns.size() > 1);
  if (position.column == nullptr && has_positions) {
    position.column = columns.size() > 2         ? told(columns, of_position, height.column)
                      : height.column != nullptr ? other_than(columns, height.column)
                                                 : columns.front();
    if (position.column == nullptr) ask(file, columns, "position");
  }
  if (height.column == nullptr) {
    height.column = columns.size() == 1                                 ? columns.front()
                    : columns.size() == 2 && position.column != nullptr ? other_than(columns, position.column)
                                                                        : told(columns, of_height, position.column);
    if (height.column == nullptr) ask(file, columns, "height");
  }
  read.height = height.column->name;
  const std::vector<double> z = values_of(file, height, kind, "height");
  if (z.size() < fewest_heights)
    throw InputError(
        {.file = file.origin.source,
         .problem = fmt::format("The trace has {} heights; at least {} are needed", z.size(), fewest_heights)});
  if (!has_positions) {
    if (!options.step)
      throw InputError({.file = file.origin.source,
                        .problem = fmt::format("The file has heights ({}) but no positions", in_quotes(read.height)),
                        .remedy = "write trace_step = \"0.1 um\" into [friction]"});
    read.trace = {0, *options.step, z};
    return read;
  }
  if (position.column == height.column)
    throw InputError(
        {.file = file.origin.source,
         .problem = fmt::format("The column {} is chosen for both heights and positions", in_quotes(read.height))});
  read.position = position.column->name;
  const std::vector<double> x = values_of(file, position, kind, "position");
  require_rising(file, *position.column, x, kind);
  read.trace = sampled(x, z);
  return read;
}

}  // namespace flexslip
