#include "instruments/column_decisions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "instruments/column_flags.h"
#include "instruments/column_unit.h"
#include "instruments/voltage.h"
#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr double contradicts = 2;  // of a stated maximum over the measured one: no rounding, but another unit

class Decisions {
 public:
  Decisions(Export& out, const ExportOptions& options, const NumberFormat& format, std::size_t header_line)
      : out_(out), options_(options), format_(format), header_line_(header_line) {}

  void decide() {
    apply_columns();
    require_no_voltage_for_force();
    apply_displacement();
    apply_units();
    require_force_in_newtons();
    compare_with_stated_maximum();
    ask();
    out_.repeat_with = flags();
  }

 private:
  ExportColumn& named(ExportedSpecimen& specimen, std::string_view wanted, ColumnRole role) const {
    std::vector<ExportColumn*> found;
    std::vector<std::string> names;
    for (ExportColumn& column : specimen.columns)
      if (std::to_string(column.number) == wanted) found.push_back(&column);  // as repeat_with says it
    const bool by_number = !found.empty();
    for (ExportColumn& column : specimen.columns) {
      names.push_back(column.name);
      const bool by_title = !column.unit.empty() && (wanted == fmt::format("{} [{}]", column.name, column.unit) ||
                                                     wanted == fmt::format("{} ({})", column.name, column.unit));
      if (!by_number && (column.name == wanted || by_title)) found.push_back(&column);
    }
    const std::string field{flag_of(role)};
    if (found.empty()) {
      const std::string meant = nearest(wanted, names);
      throw InputError({.file = out_.source,
                        .field = field,
                        .expected = "one of the columns " + listed(names) + ", or its number",
                        .found = in_quotes(wanted),
                        .remedy = meant.empty() ? "" : "did you mean " + in_quotes(meant) + "?"});
    }
    if (found.size() > 1)
      throw InputError({.file = out_.source,
                        .field = field,
                        .expected = "one column",
                        .found = fmt::format("{} called {}", found.size(), in_quotes(wanted)),
                        .remedy = fmt::format("give its number: {} {}", field, found.front()->number)});
    if (!found.front()->words.empty())
      throw InputError({.file = out_.source,
                        .field = field,
                        .expected = "a column of numbers",
                        .found = fmt::format("words in {}", in_quotes(found.front()->name))});
    require_kind(*found.front(), role);
    return *found.front();
  }

  // The number of a column of another specimen, one beside this, is that of the same title here.
  std::string of_this(const ExportedSpecimen& specimen, std::string_view wanted) const {
    const auto numbered = [&](const ExportedSpecimen& each) {
      return std::find_if(each.columns.begin(), each.columns.end(),
                          [&](const ExportColumn& column) { return std::to_string(column.number) == wanted; });
    };
    if (numbered(specimen) != specimen.columns.end()) return std::string(wanted);
    for (const ExportedSpecimen& other : out_.specimens)
      if (const auto column = numbered(other); column != other.columns.end())
        for (const ExportColumn& here : specimen.columns)
          if (here.name == column->name) return std::to_string(here.number);
    return std::string(wanted);
  }

  // A column in a unit of another kind than its role is not the one that was meant.
  void require_kind(const ExportColumn& column, ColumnRole role) const {
    const Kind& kind = role == ColumnRole::force ? kind::force : role == ColumnRole::time ? kind::time : kind::length;
    if (column.unit.empty() || role == ColumnRole::other) return;
    std::optional<Unit> unit;
    try {
      unit = parse_unit(column.unit);
    } catch (const InputError&) {
      return;  // unknown: in_si says so where it is needed
    }
    if (unit->dimension != kind.dimension)
      throw InputError({.file = out_.source,
                        .field = std::string(flag_of(role)),
                        .expected = fmt::format("a column in units of {}", kind.name),
                        .found = fmt::format("{} in {}", in_quotes(column.name), in_quotes(column.unit))});
  }

  void apply_columns() {
    for (ExportedSpecimen& specimen : out_.specimens)
      for (const auto& [role, name] : options_.columns) {
        ExportColumn& chosen = named(specimen, of_this(specimen, trimmed(name)), role);
        for (ExportColumn& column : specimen.columns)
          if (column.role == role) column.role = ColumnRole::other;
        chosen.role = role;
      }
  }

  void apply_displacement() {
    if (!options_.displacement) return;
    const ColumnRole role = *options_.displacement;
    if (role != ColumnRole::crosshead && role != ColumnRole::deflection)
      throw InputError({.field = "--displacement", .expected = "crosshead or deflection", .found = "neither"});
    for (ExportedSpecimen& specimen : out_.specimens) {
      std::vector<ExportColumn*> unclear;
      std::vector<ExportColumn*> all;
      for (ExportColumn& column : specimen.columns) {
        if (is_displacement(column.role)) all.push_back(&column);
        if (column.role == ColumnRole::displacement) unclear.push_back(&column);
      }
      const std::vector<ExportColumn*>& candidates = unclear.empty() ? all : unclear;
      if (candidates.size() != 1)
        throw InputError({.file = out_.source,
                          .field = "--displacement",
                          .expected = "one column with a displacement",
                          .found = candidates.empty() ? "none" : std::to_string(candidates.size()),
                          .remedy = fmt::format("name the column with {} instead", flag_of(role))});
      candidates.front()->role = role;
    }
  }

  void require_no_voltage_for_force() const {
    if (options_.columns.contains(ColumnRole::force)) return;
    const std::vector<ExportColumn>& columns = out_.specimens.front().columns;
    std::vector<MeasuredColumn> measured;
    std::vector<const ExportColumn*> which;
    bool calibrated = false;
    for (const ExportColumn& column : columns) {
      const bool open = column.role == ColumnRole::force || column.role == ColumnRole::other;
      if (!open || !column.words.empty()) continue;
      measured.push_back({column.values, is_voltage(column.unit), column.role == ColumnRole::force});
      which.push_back(&column);
      const auto unit = options_.units.find(ColumnRole::force);
      calibrated = calibrated || (measured.back().is_voltage && measured.back().is_force &&
                                  unit != options_.units.end() && unit->second.ends_with("/V"));
    }
    const std::optional<VoltageFinding> finding = voltage_for_force(measured);
    if (!finding || calibrated) return;
    const ExportColumn& voltage = *which[finding->column];
    const auto force = std::find_if(which.begin(), which.end(), [](const ExportColumn* each) {
      return each->role == ColumnRole::force && !is_voltage(each->unit);
    });
    std::string remedy =
        fmt::format("if it is the force, state its calibration: --force {} --calibration \"222 N/V\"", voltage.number);
    std::string found = fmt::format("column {} in {}", in_quotes(voltage.name), voltage.unit);
    if (force != which.end()) {
      remedy += fmt::format("; if {} is the force, pass --force {}", in_quotes((*force)->name), (*force)->number);
      found += finding->force_is_noise
                   ? fmt::format(" beside {}, which holds only noise", in_quotes((*force)->name))
                   : fmt::format(", which follows {} (correlation {:.3f}) as a second load cell would",
                                 in_quotes((*force)->name), finding->correlation);
    }
    throw InputError({.file = out_.source,
                      .line = header_line_,
                      .field = "force",
                      .expected = "a force in units of force",
                      .found = std::move(found),
                      .remedy = std::move(remedy)});
  }

  void require_force_in_newtons() const {
    for (const ExportColumn& column : out_.specimens.front().columns)
      if (column.role == ColumnRole::force && is_voltage(column.unit))
        throw InputError({.file = out_.source,
                          .line = header_line_,
                          .field = "force",
                          .expected = "a force in units of force",
                          .found = fmt::format("column {} in {}", in_quotes(column.name), column.unit),
                          .remedy = "state its calibration, as in --calibration \"222 N/V\""});
  }

  void apply_units() {
    for (ExportedSpecimen& specimen : out_.specimens)
      for (ExportColumn& column : specimen.columns) {
        auto given = options_.units.find(column.role);
        if (given == options_.units.end() && is_displacement(column.role))
          given = options_.units.find(ColumnRole::displacement);
        if (given == options_.units.end()) continue;
        const std::string_view text = trimmed(given->second);
        if (text.ends_with("/V"))
          calibrate(column, text);
        else
          set_unit(column, text);
      }
  }

  void calibrate(ExportColumn& column, std::string_view calibration) {
    const std::string_view per_volt = calibration.substr(0, calibration.size() - 2);
    const std::size_t end = std::min(per_volt.find_first_not_of("+-0123456789.eE"), per_volt.size());
    const double factor = number_in(trimmed(per_volt.substr(0, end)), {});
    const std::string_view unit = trimmed(per_volt.substr(end));
    const std::optional<Unit> known = machine_unit(unit);
    if (std::isnan(factor) || factor == 0 || !known || known->dimension != dimension_of(column.role))
      throw InputError({.field = "--calibration", .expected = "such as \"222 N/V\"", .found = in_quotes(calibration)});
    if (!is_voltage(column.unit))
      throw InputError({.file = out_.source,
                        .field = "column " + in_quotes(column.name),
                        .expected = "a column in volts, as a calibration is given",
                        .found = column.unit.empty() ? "no unit" : in_quotes(column.unit)});
    for (double& value : column.values) value *= volts_in(column.unit) * factor;
    note_once(fmt::format("column {}: {} taken as {} by the calibration {}", in_quotes(column.name), column.unit, unit,
                          calibration));
    column.unit = unit;
  }

  void set_unit(ExportColumn& column, std::string_view text) {
    const std::optional<Unit> unit = machine_unit(text);
    if (!unit || unit->dimension != dimension_of(column.role))
      throw InputError({.field = std::string(unit_flag_of(column.role)),
                        .expected = fmt::format("a unit such as {}", usual_unit(column.role)),
                        .found = in_quotes(text)});
    if (is_voltage(column.unit))
      throw InputError({.file = out_.source,
                        .field = "column " + in_quotes(column.name),
                        .expected = "a calibration",
                        .found = fmt::format("the unit {} for values in {}", in_quotes(text), column.unit),
                        .remedy = "give it as in --calibration \"222 N/V\""});
    if (!column.unit.empty() && machine_unit(column.unit) != unit)
      note_once(fmt::format("column {}: the file says {}; taken as {}, as you ask", in_quotes(column.name),
                            in_quotes(column.unit), text));
    column.unit = text;
  }

  void note_once(std::string note) {
    if (std::find(out_.notes.begin(), out_.notes.end(), note) == out_.notes.end())
      out_.notes.push_back(std::move(note));
  }

  // A file that states the highest force contradicts a unit that is wrong.
  void compare_with_stated_maximum() {
    if (out_.specimens.size() != 1) return;
    const std::vector<Metadatum> metadata = all_metadata(out_);
    const std::optional<StatedForce> stated = stated_maximum(metadata, format_);
    const std::vector<ExportColumn>& columns = out_.specimens.front().columns;
    const auto is_force = [](const ExportColumn& column) { return column.role == ColumnRole::force; };
    const auto force = std::find_if(columns.begin(), columns.end(), is_force);
    if (!stated || force == columns.end() || std::count_if(columns.begin(), columns.end(), is_force) > 1) return;
    const std::optional<Unit> unit = machine_unit(force->unit);
    if (!unit || unit->dimension != kind::force.dimension) return;
    double highest = 0;
    for (const double value : force->values)
      if (!std::isnan(value)) highest = std::max(highest, std::abs(to_si(value, *unit)));
    const double ratio = std::abs(stated->value) / highest;
    if (ratio < contradicts && ratio > 1 / contradicts) {
      if (std::abs(ratio - 1) > 0.01)  // evaluated within limits, or of smoothed values: worth saying, not wrong
        out_.notes.push_back(fmt::format("line {} states a maximum force of {}, but the rows have {}",
                                         stated->where->line, readable(stated->value, kind::force),
                                         readable(highest, kind::force)));
      return;
    }
    const bool unit_given = options_.units.contains(ColumnRole::force);
    if (unit_given) return;
    throw InputError(
        {.file = out_.source,
         .line = stated->where->line,
         .field = "column " + in_quotes(force->name),
         .expected = fmt::format("a maximum of {}, as this line states", readable(stated->value, kind::force)),
         .found = readable(highest, kind::force),
         .remedy = "check that the file is complete; if it is, state the unit of the column with --force-unit"});
  }

  void ask() {
    const std::vector<ExportColumn>& columns = out_.specimens.front().columns;
    std::vector<const ExportColumn*> forces;
    std::vector<const ExportColumn*> unclear;
    std::map<ColumnRole, std::vector<const ExportColumn*>> clear;
    for (const ExportColumn& column : columns) {
      if (column.role == ColumnRole::force) forces.push_back(&column);
      if (column.role == ColumnRole::displacement) unclear.push_back(&column);
      if (column.role == ColumnRole::crosshead || column.role == ColumnRole::deflection)
        clear[column.role].push_back(&column);
    }
    if (forces.empty()) out_.asks.emplace_back("which column is the force? --force COLUMN, its name or number");
    if (forces.size() > 1)
      out_.asks.push_back(fmt::format("which of the columns {} is the force? --force {}", listed_columns(forces),
                                      forces.front()->number));
    if (clear.empty() && unclear.empty())
      out_.asks.emplace_back("which column is the displacement? --crosshead COLUMN or --deflection COLUMN");
    if (unclear.size() == 1 && clear.empty())
      out_.asks.push_back(fmt::format(
          "is {} that of the crosshead or the deflection of the specimen? --displacement crosshead|deflection",
          in_quotes(unclear.front()->name)));
    if (unclear.size() > 1 && clear.empty())
      out_.asks.push_back(
          fmt::format("which of the columns {} is that of the crosshead, or the deflection of the specimen? "
                      "--crosshead COLUMN or --deflection COLUMN",
                      listed_columns(unclear)));
    for (const auto& [role, several] : clear)
      if (several.size() > 1)
        out_.asks.push_back(fmt::format("which of the columns {} is the {}? {} {}", listed_columns(several),
                                        word_for(role), flag_of(role), several.front()->number));
    for (const ExportColumn& column : columns) {
      if (column.role == ColumnRole::other || machine_unit(column.unit)) continue;
      out_.asks.push_back(fmt::format("what is the unit of {}{}? {} {}", in_quotes(column.name),
                                      column.unit.empty() ? "" : ", which says " + in_quotes(column.unit),
                                      unit_flag_of(column.role), usual_unit(column.role)));
    }
  }

  static std::string listed_columns(const std::vector<const ExportColumn*>& columns) {
    std::vector<std::string> names;
    names.reserve(columns.size());
    for (const ExportColumn* column : columns) names.push_back(column->name);
    return listed(names);
  }

  std::string flags() const {
    const auto shown = [](char c) {
      return c == '\0'               ? std::string("none")
             : c == '\t'             ? "tab"
             : c == ' '              ? "space"
             : c == ';' || c == '\'' ? fmt::format("\"{}\"", c)
                                     : std::string(1, c);
    };
    std::string text;
    if (out_.sheet) text = "--sheet " + sheet_word();
    if (out_.has_delimiters())
      text += fmt::format("{}--encoding {} --separator {}", text.empty() ? "" : " ", name_of(out_.encoding),
                          shown(out_.separator));
    if (out_.has_marks) text += fmt::format(" --decimal {} --thousands {}", shown(out_.decimal), shown(out_.thousands));
    std::map<ColumnRole, std::vector<std::size_t>> with;
    for (const ExportColumn& column : out_.specimens.front().columns) with[column.role].push_back(column.number);
    for (const auto& [role, numbers] : with) {
      const bool decided = role != ColumnRole::other && role != ColumnRole::displacement && numbers.size() == 1;
      if (decided) text += fmt::format(" {} {}", flag_of(role), numbers.front());
    }
    for (const auto& [role, unit] : options_.units)
      text += fmt::format(" {} \"{}\"", unit.ends_with("/V") ? "--calibration" : unit_flag_of(role), unit);
    return text;
  }

  // A sheet as a shell takes it: its name, or its number where that would need more than quotes.
  std::string sheet_word() const {
    if (out_.sheet->find_first_of("\"$`\\!") == std::string::npos) return fmt::format("\"{}\"", *out_.sheet);
    const auto at = std::find(out_.sheets.begin(), out_.sheets.end(), *out_.sheet);
    return std::to_string(1 + (at - out_.sheets.begin()));
  }

  Export& out_;
  const ExportOptions& options_;
  const NumberFormat& format_;
  std::size_t header_line_;
};

}  // namespace

std::vector<Metadatum> all_metadata(const Export& file) {
  std::vector<Metadatum> all = file.metadata;
  if (file.specimens.size() == 1) {
    const std::vector<Metadatum>& own = file.specimens.front().metadata;
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

void decide_columns(Export& file, const ExportOptions& options, const NumberFormat& format, std::size_t header_line) {
  Decisions(file, options, format, header_line).decide();
}

}  // namespace flexslip
