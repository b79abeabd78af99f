#include "instruments/column_decisions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/record.h"
#include "io/input_error.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double contradicts = 2;  // ratio of stated and measured maximum; no rounding, but a wrong unit
constexpr std::string_view calibration_hint = "--calibration \"… N/V\"";

using Columns = std::vector<const ExportColumn*>;

std::string listed_columns(const Columns& columns) {
  std::vector<std::string> names;
  names.reserve(columns.size());
  std::vector<std::size_t> numbers;
  for (const ExportColumn* column : columns) {
    numbers.push_back(column->number);
    if (std::find(names.begin(), names.end(), column->name) == names.end()) names.push_back(column->name);
  }
  return names.size() == columns.size() ? listed(names)
                                        : fmt::format("{} (numbers {})", listed(names), fmt::join(numbers, ", "));
}

Columns with_role(const std::vector<ExportColumn>& columns, ColumnRole role) {
  Columns found;
  for (const ExportColumn& column : columns)
    if (column.role == role) found.push_back(&column);
  return found;
}

// ---- roles

// The unit that an invalid unit probably means, "gf" for "g"; otherwise the usual unit.
std::string_view meant_or_usual(std::string_view unit, const RoleWords& words) {
  const std::vector<std::string_view> meant = meant_units(unit, *words.kind);
  return meant.empty() ? words.usual_unit : meant.front();
}

bool is_of_kind(const std::optional<Unit>& unit, const RoleWords& words) {
  return unit && words.kind != nullptr && unit->dimension == words.kind->dimension;
}

// True for a force that the file gives as a stress: it follows from span and section.
bool may_be_stress(const std::optional<Unit>& unit, ColumnRole role) {
  return role == ColumnRole::force && unit && unit->dimension == kind::pressure.dimension;
}

// A column with a unit of another kind than its role is the wrong column.
void require_kind(const Export& file, const ExportColumn& column, ColumnRole role) {
  const RoleWords& words = words_for(role);
  const std::optional<Unit> unit = machine_unit(column.unit);  // in_si reports an unknown unit
  if (!unit || words.kind == nullptr || is_of_kind(unit, words) || may_be_stress(unit, role)) return;
  throw InputError(
      {.file = file.origin.source,
       .field = std::string(words.flag),
       .problem = fmt::format("The column {} is in {}, not in a unit of {}", in_quotes(column.name),
                              in_quotes(column.unit), noun(*words.kind)),
       .remedy = meant_units(column.unit, *words.kind).empty()
                     ? "name another column"
                     : fmt::format("if it is the right column, give its unit after its name, as in \"{} [{}]\"",
                                   column.name, meant_or_usual(column.unit, words))});
}

// The number of the column with the same title here, if the number belongs to another specimen in
// the same table.
std::string of_this(const Export& file, const ExportedSpecimen& specimen, std::string_view wanted) {
  const auto numbered = [&](const ExportedSpecimen& each) {
    return std::find_if(each.columns.begin(), each.columns.end(),
                        [&](const ExportColumn& column) { return std::to_string(column.number) == wanted; });
  };
  if (numbered(specimen) != specimen.columns.end()) return std::string(wanted);
  for (const ExportedSpecimen& other : file.specimens)
    if (const auto column = numbered(other); column != other.columns.end())
      for (const ExportColumn& here : specimen.columns)
        if (here.name == column->name) return std::to_string(here.number);
  return std::string(wanted);
}

// The column that a user names. The text may add a unit in brackets, "Force [kN]", unless this is
// the name of a column.
ColumnTitle asked_of(const ExportedSpecimen& specimen, std::string_view wanted) {
  const std::size_t open = wanted.ends_with(']') ? wanted.rfind('[') : std::string_view::npos;
  if (open == std::string_view::npos || trimmed(wanted.substr(0, open)).empty()) return {std::string(wanted), ""};
  for (const ExportColumn& column : specimen.columns)
    if (is_called(column, wanted)) return {std::string(wanted), ""};
  return {std::string(trimmed(wanted.substr(0, open))), std::string(without_brackets(wanted.substr(open)))};
}

// Refuses another unit than the file's. Grams state a force, too: their weight.
void require_unit_of_file(const Export& file, const ExportColumn& column, const Unit& said, std::string_view text,
                          std::string_view flag) {
  const std::optional<Unit> stated = machine_unit(column.unit);
  const std::vector<std::string_view> meant = meant_units(column.unit, *words_for(column.role).kind);
  const bool is_meant =
      std::any_of(meant.begin(), meant.end(), [&](std::string_view each) { return machine_unit(each) == said; });
  const bool differs = meant.empty() ? stated && *stated != said : !is_meant;
  if (!volts_in(column.unit) && !differs) return;
  throw InputError({.file = file.origin.source,
                    .field = std::string(flag),
                    .problem = fmt::format("The unit of {} is {} in the file, not {}", in_quotes(column.name),
                                           in_quotes(column.unit), in_quotes(text)),
                    .remedy = volts_in(column.unit) ? fmt::format("give the calibration, as in {}", calibration_hint)
                              : meant.empty()
                                  ? "leave the unit out, or correct the title in the file if it is wrong"
                                  : fmt::format("if {} is meant, write {}", fmt::join(meant, " or "), meant.front())});
}

// The unit that the user states for a column without a valid unit in the file, such as a force in
// grams.
std::string said_unit(const Export& file, ExportColumn column, ColumnRole role, const std::string& unit) {
  const RoleWords& words = words_for(role);
  const std::optional<Unit> said = machine_unit(unit);
  if (!is_of_kind(said, words))
    throw InputError({.field = std::string(words.flag),
                      .problem = fmt::format("The unit {} in brackets behind the name is not a unit such as {}",
                                             in_quotes(unit), meant_or_usual(column.unit, words))});
  column.role = role;
  require_unit_of_file(file, column, *said, unit, words.flag);
  return unit;
}

Export with_columns(Export file, const std::map<ColumnRole, std::string>& columns) {
  for (ExportedSpecimen& specimen : file.specimens)
    for (const auto& [role, name] : columns) {
      const RoleWords& words = words_for(role);
      const ColumnTitle asked = asked_of(specimen, trimmed(name));
      const std::size_t index = column_named(file, specimen, of_this(file, specimen, asked.name), words.flag);
      ExportColumn& chosen = specimen.columns[index];
      if (!asked.unit.empty()) chosen.unit = said_unit(file, chosen, role, asked.unit);
      require_kind(file, chosen, role);
      // A displacement without an explicit choice keeps the role of its title.
      const bool keeps_role = role == ColumnRole::displacement && is_displacement(chosen.role);
      const ColumnRole now = keeps_role ? chosen.role : role;
      for (ExportColumn& column : specimen.columns)
        if (column.role == role || (role == ColumnRole::displacement && is_displacement(column.role)))
          column.role = ColumnRole::other;
      chosen.role = now;
    }
  return file;
}

// A unit decides a role that no title has: the only column in a unit of force is the force, unless
// its title names another quantity.
Export with_roles_by_units(Export file) {
  for (ExportedSpecimen& specimen : file.specimens)
    for (const ColumnRole role : {ColumnRole::time, ColumnRole::displacement, ColumnRole::force}) {
      const auto has_role = [&](const ExportColumn& column) {
        return column.role == role || (role == ColumnRole::displacement && is_displacement(column.role));
      };
      if (std::any_of(specimen.columns.begin(), specimen.columns.end(), has_role)) continue;
      std::vector<ExportColumn*> candidates;
      for (ExportColumn& column : specimen.columns)
        if (column.role == ColumnRole::other && column.words.empty() && !names_other_quantity(column.name) &&
            is_of_kind(machine_unit(column.unit), words_for(role)))
          candidates.push_back(&column);
      if (candidates.empty() && role == ColumnRole::force)  // a stress under the title of a force
        for (ExportColumn& column : specimen.columns)
          if (column.words.empty() && role_of(column.name) == role && may_be_stress(machine_unit(column.unit), role))
            candidates.push_back(&column);
      if (candidates.size() != 1) continue;
      candidates.front()->role = role;
      if (may_be_stress(machine_unit(candidates.front()->unit), role)) continue;
      std::string note =
          fmt::format("column {} is the {}: no other column is in a unit of {}", in_quotes(candidates.front()->name),
                      words_for(role).name, noun(*words_for(role).kind));
      if (std::find(file.notes.begin(), file.notes.end(), note) != file.notes.end()) continue;
      file.row_notes.push_back(note);
      file.notes.push_back(std::move(note));
    }
  return file;
}

Export with_displacement(Export file, ColumnRole role) {
  if (role != ColumnRole::crosshead && role != ColumnRole::deflection)
    throw InputError(
        {.field = "--displacement", .problem = "The displacement is either the crosshead's or a deflection"});
  for (ExportedSpecimen& specimen : file.specimens) {
    std::vector<ExportColumn*> unclear;
    std::vector<ExportColumn*> all;
    for (ExportColumn& column : specimen.columns) {
      if (is_displacement(column.role)) all.push_back(&column);
      if (column.role == ColumnRole::displacement) unclear.push_back(&column);
    }
    const std::vector<ExportColumn*>& candidates = unclear.empty() ? all : unclear;
    if (candidates.size() != 1)
      throw InputError({.file = file.origin.source,
                        .field = "--displacement",
                        .problem = fmt::format("One column with a displacement is needed, and the file has {}",
                                               candidates.empty() ? "none" : std::to_string(candidates.size())),
                        .remedy = fmt::format("name the column with {} instead", words_for(role).flag)});
    candidates.front()->role = role;
  }
  return file;
}

// ---- several columns of one quantity

std::vector<double> numbers_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values;
}

double correlation(std::span<const double> x, std::span<const double> y) {
  double n = 0, mean_x = 0, mean_y = 0, sxx = 0, syy = 0, sxy = 0;  // Welford's sums, without cancellation
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isnan(x[i]) || std::isnan(y[i])) continue;
    ++n;
    const double dx = x[i] - mean_x;
    const double dy = y[i] - mean_y;
    mean_x += dx / n;
    mean_y += dy / n;
    sxx += dx * (x[i] - mean_x);
    syy += dy * (y[i] - mean_y);
    sxy += dx * (y[i] - mean_y);
  }
  return sxx > 0 && syy > 0 ? sxy / std::sqrt(sxx * syy) : 0;
}

void add_note(Export& file, std::string note) {
  if (std::find(file.notes.begin(), file.notes.end(), note) == file.notes.end()) file.notes.push_back(std::move(note));
}

// True for the signal in volts of a sensor whose readings another column has in their unit.
bool is_raw_signal(const std::vector<ExportColumn>& columns, const ExportColumn& column) {
  return volts_in(column.unit) && std::any_of(columns.begin(), columns.end(), [&](const ExportColumn& each) {
           return each.name == column.name && machine_unit(each.unit);
         });
}

bool is_constant(const ExportColumn& column) {
  const auto reading =
      std::find_if(column.values.begin(), column.values.end(), [](double x) { return !std::isnan(x); });
  return std::all_of(reading, column.values.end(), [&](double x) { return std::isnan(x) || x == *reading; });
}

// Of several columns with one role, raw signals and constant columns lose it, unless all are such.
Export without_silent_columns(Export file) {
  for (ExportedSpecimen& specimen : file.specimens)
    for (const ColumnRole role :
         {ColumnRole::displacement, ColumnRole::crosshead, ColumnRole::deflection, ColumnRole::force}) {
      const auto is_silent = [&](const ExportColumn& each) {
        return is_raw_signal(specimen.columns, each) || is_constant(each);
      };
      const Columns all = with_role(specimen.columns, role);
      if (std::all_of(all.begin(), all.end(), [&](const ExportColumn* each) { return is_silent(*each); })) continue;
      for (ExportColumn& column : specimen.columns) {
        if (column.role != role || !is_silent(column)) continue;
        column.role = ColumnRole::other;
        add_note(file, fmt::format("column {} is not used: it {}", in_quotes(column.name),
                                   is_constant(column) ? "holds one value only" : "is the signal in volts"));
      }
    }
  return file;
}

// [SI] The readings of a column; empty if its unit is unknown.
std::vector<double> readings_in_si(const ExportColumn& column) {
  const std::optional<Unit> unit = machine_unit(column.unit);
  if (!unit) return {};
  std::vector<double> values = column.values;
  for (double& value : values) value = to_si(value, *unit);
  return values;
}

double range_of(const std::vector<double>& values) {
  const auto numbers = numbers_of(values);
  if (numbers.empty()) return 0;
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  return *most - *least;
}

double deviation_of(const std::vector<double>& values) {
  double n = 0, mean = 0, sum = 0;
  for (const double value : numbers_of(values)) {
    const double d = value - mean;
    mean += d / ++n;
    sum += d * (value - mean);
  }
  return std::sqrt(sum / n);
}

// The load train between two columns of a displacement.
struct Compliance {
  bool is_first_stage;  // the stage moves farther by the deflection of the load train
  double stiffness;     // [N/m]
};

// The load train by which two displacements differ; nullopt if their difference is not proportional
// to the force.
std::optional<Compliance> compliance_between(const ExportColumn& first, const ExportColumn& second,
                                             const ExportColumn& force) {
  constexpr double proportional = 0.95, min_share = 0.01;  // |correlation|; of the travel
  const std::vector<double> a = readings_in_si(first), b = readings_in_si(second), forces = readings_in_si(force);
  if (a.empty() || b.empty() || forces.empty()) return std::nullopt;
  const double sign_of_a = correlation(a, forces) < 0 ? -1 : 1, sign_of_b = correlation(b, forces) < 0 ? -1 : 1;
  std::vector<double> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = sign_of_a * a[i] - sign_of_b * b[i];
  const double r = correlation(difference, forces);
  if (!(std::abs(r) >= proportional) || range_of(difference) < min_share * range_of(a)) return std::nullopt;
  const double stiffness = deviation_of(forces) / (std::abs(r) * deviation_of(difference));
  // Rounded to six digits: a case that holds it as text then means the same number.
  return Compliance{r > 0, number_in(fmt::format("{:.6g}", stiffness), {})};
}

// Of two displacements whose difference grows with the force, the smaller is the deflection at the
// specimen. Both with the force give the stiffness of the load train.
Export with_load_train(Export file, bool asks_displacement) {
  for (ExportedSpecimen& specimen : file.specimens) {
    std::vector<ExportColumn*> places;
    for (ExportColumn& column : specimen.columns)
      if (is_displacement(column.role)) places.push_back(&column);
    const Columns forces = with_role(specimen.columns, ColumnRole::force);
    if (places.size() != 2 || forces.size() != 1) continue;
    const std::optional<Compliance> between = compliance_between(*places[0], *places[1], *forces[0]);
    if (!between) continue;
    ExportColumn& stage = *places[between->is_first_stage ? 0 : 1];
    ExportColumn& deflected = *places[between->is_first_stage ? 1 : 0];
    if (stage.role == ColumnRole::deflection || deflected.role == ColumnRole::crosshead) continue;
    const bool is_decided = stage.role == ColumnRole::crosshead && deflected.role == ColumnRole::deflection;
    if (!is_decided && asks_displacement) continue;
    specimen.load_train = between->stiffness;
    if (is_decided) continue;
    stage.role = ColumnRole::crosshead;
    deflected.role = ColumnRole::deflection;
    std::string note = fmt::format(
        "column {1} is the deflection, and {0} the crosshead's: their difference grows with the force as the "
        "deflection of a load train of about {2} does",
        in_quotes(stage.name), in_quotes(deflected.name), readable(between->stiffness, kind::stiffness));
    file.row_notes.push_back(note);
    add_note(file, std::move(note));
  }
  return file;
}

double step_of(const ExportColumn& column) {
  const std::vector<double> numbers = numbers_of(column.values);
  return numbers.empty() ? 0 : resolution_of(numbers);
}

// True if both columns are the same displacement with another zero or sign, rounded to a step: they
// then differ by at most this step.
bool is_rounded_to(std::span<const double> coarse, std::span<const double> fine, double step) {
  for (const double sign : {1.0, -1.0}) {
    double least = infinity, most = -infinity;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      const double difference = coarse[i] - sign * fine[i];
      least = std::min(least, difference);  // NaN changes neither
      most = std::max(most, difference);
    }
    constexpr double roundings = 1.01;
    if (most >= least && most - least <= roundings * step) return true;
  }
  return false;
}

// If a position with few digits, "1190.55", is also given from the zero of the test, the finer
// column is used.
Export with_finest(Export file) {
  constexpr double finer = 1.5, least_steps = 10;
  for (ExportedSpecimen& specimen : file.specimens)
    for (ExportColumn& coarse : specimen.columns) {
      if (coarse.role != ColumnRole::crosshead) continue;
      for (ExportColumn& fine : specimen.columns) {
        const bool may_be = coarse.number != fine.number &&
                            (fine.role == ColumnRole::crosshead || fine.role == ColumnRole::displacement);
        if (!may_be || coarse.unit != fine.unit) continue;
        const double step = step_of(coarse);
        if (step == 0) continue;
        const auto numbers = numbers_of(coarse.values);
        const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
        if (*most - *least < least_steps * step || step < finer * step_of(fine) ||
            !is_rounded_to(coarse.values, fine.values, step))
          continue;
        coarse.role = ColumnRole::other;
        fine.role = ColumnRole::crosshead;
        std::string note = fmt::format("column {0} is {1} rounded to {2:.3g} {3}: {1} is used", in_quotes(coarse.name),
                                       in_quotes(fine.name), step, fine.unit);
        add_note(file, std::move(note));
        break;
      }
    }
  return file;
}

// Of several times, the first with a stated unit is used, otherwise the first.
Export with_one_time(Export file) {
  for (ExportedSpecimen& specimen : file.specimens) {
    ExportColumn* used = nullptr;
    for (ExportColumn& column : specimen.columns)
      if (column.role == ColumnRole::time && (!used || (!machine_unit(used->unit) && machine_unit(column.unit))))
        used = &column;
    for (ExportColumn& column : specimen.columns) {
      if (column.role != ColumnRole::time || &column == used) continue;
      column.role = ColumnRole::other;
      std::string note =
          fmt::format("column {} is a time, too: {} is used", in_quotes(column.name), in_quotes(used->name));
      add_note(file, std::move(note));
    }
  }
  return file;
}

// ---- voltages

constexpr double follows = 0.9;  // |correlation|: two load cells in one load train; empirical, a real pair gave 0.999
constexpr double noise = 1;      // of the ratio below: 2 for white noise, almost 0 for a finely sampled curve

// Von Neumann's ratio: mean square of the steps over the variance.
double step_ratio(std::span<const double> values) {
  double n = 0, mean = 0, sum = 0, steps = 0;
  double last = not_a_number;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    ++n;
    const double d = value - mean;
    mean += d / n;
    sum += d * (value - mean);
    if (!std::isnan(last)) steps += (value - last) * (value - last);
    last = value;
  }
  return sum > 0 ? steps / sum : 2;
}

// A force that exists only as a voltage, of a load cell without a calibration.
struct VoltageFinding {
  const ExportColumn* voltage;
  const ExportColumn* force;  // nullptr without a force
  double correlation;         // with the force; NaN without a force
  bool force_is_noise;        // true if the force does not exceed its scatter and the voltage does
};

// The column in volts that may be the force, if no title excludes it. A decision of the user is
// needed if the file has no force and only one voltage, if the voltage follows the force (a second
// load cell), or if the force is noise and the voltage is not. Otherwise nullopt.
std::optional<VoltageFinding> voltage_for_force(const Columns& columns) {
  const ExportColumn* force = nullptr;
  for (const ExportColumn* column : columns)
    if (column->role == ColumnRole::force && !volts_in(column->unit)) force = column;
  for (const ExportColumn* column : columns) {
    if (!volts_in(column->unit)) continue;
    if (force == nullptr) {  // which of several is the force, is asked
      const auto in_volts = [](const ExportColumn* each) { return volts_in(each->unit).has_value(); };
      if (std::count_if(columns.begin(), columns.end(), in_volts) > 1) return std::nullopt;
      return VoltageFinding{column, nullptr, not_a_number, false};
    }
    const double r = correlation(force->values, column->values);
    const bool is_noise = step_ratio(force->values) > noise && step_ratio(column->values) < noise;
    if (std::abs(r) >= follows || is_noise) return VoltageFinding{column, force, r, is_noise};
  }
  return std::nullopt;
}

InputError force_in_volts(const Export& file, std::size_t header_line, std::string found, std::string remedy) {
  return InputError({.file = file.origin.source,
                     .line = header_line,
                     .field = "force",
                     .problem = fmt::format("The force is not in a unit of force: {}", found),
                     .remedy = std::move(remedy)});
}

void require_no_voltage_for_force(const Export& file, const ExportOptions& options, std::size_t header_line) {
  if (options.columns.contains(ColumnRole::force)) return;
  const auto unit = options.units.find(ColumnRole::force);
  const bool has_calibration = unit != options.units.end() && unit->second.ends_with("/V");
  Columns columns;
  for (const ExportColumn& column : file.specimens.front().columns) {
    const bool is_force = column.role == ColumnRole::force;
    if (is_force && volts_in(column.unit) && column.words.empty() && has_calibration) return;
    const bool may_be = column.role == ColumnRole::other && !names_other_quantity(column.name) &&
                        !is_raw_signal(file.specimens.front().columns, column);
    if ((is_force || may_be) && column.words.empty()) columns.push_back(&column);
  }
  const std::optional<VoltageFinding> finding = voltage_for_force(columns);
  if (!finding) return;
  const auto& [voltage, force, r, force_is_noise] = *finding;
  std::string remedy =
      fmt::format("if it is the force, state its calibration: --force {} {}", voltage->number, calibration_hint);
  std::string found = fmt::format("column {} in {}", in_quotes(voltage->name), voltage->unit);
  if (force != nullptr) {
    remedy += fmt::format("; if {} is the force, pass --force {}", in_quotes(force->name), force->number);
    found += force_is_noise ? fmt::format(", while {} holds only noise", in_quotes(force->name))
                            : fmt::format(", which follows {} (correlation {:.3f}) as a second load cell would",
                                          in_quotes(force->name), r);
  }
  throw force_in_volts(file, header_line, std::move(found), std::move(remedy));
}

void require_force_in_newtons(const Export& file, std::size_t header_line) {
  for (const ExportColumn* column : with_role(file.specimens.front().columns, ColumnRole::force))
    if (volts_in(column->unit))
      throw force_in_volts(file, header_line, fmt::format("column {} in {}", in_quotes(column->name), column->unit),
                           fmt::format("state its calibration, as in {}", calibration_hint));
}

// ---- units

// A column in another unit, and a note; no note if nothing needs to be reported.
struct Restated {
  ExportColumn column;
  std::string note;
};

Restated calibrated(const Export& file, ExportColumn column, std::string_view calibration) {
  const std::string_view per_volt = calibration.substr(0, calibration.size() - 2);
  const std::size_t end = std::min(per_volt.find_first_not_of("+-0123456789.eE"), per_volt.size());
  const double factor = number_in(trimmed(per_volt.substr(0, end)), {});
  const std::string_view unit = trimmed(per_volt.substr(end));
  const std::optional<Unit> known = machine_unit(unit);
  if (std::isnan(factor) || factor == 0 || !known || known->dimension != words_for(column.role).kind->dimension)
    throw InputError({.field = "--calibration",
                      .problem = fmt::format("{} is not a calibration such as \"222 N/V\"", in_quotes(calibration))});
  const std::optional<double> volts = volts_in(column.unit);
  if (!volts)
    throw InputError({.file = file.origin.source,
                      .field = "column " + in_quotes(column.name),
                      .problem = fmt::format("A calibration applies to a column in volts, but this one has {}",
                                             column.unit.empty() ? "no unit" : "the unit " + in_quotes(column.unit))});
  for (double& value : column.values) value *= *volts * factor;
  std::string note = fmt::format("column {}: {} taken as {} by the calibration {}", in_quotes(column.name), column.unit,
                                 unit, calibration);
  column.unit = unit;
  return {std::move(column), std::move(note)};
}

Restated in_unit(const Export& file, ExportColumn column, std::string_view text) {
  const RoleWords& words = words_for(column.role);
  const std::optional<Unit> unit = machine_unit(text);
  if (!unit || unit->dimension != words.kind->dimension)
    throw InputError(
        {.field = std::string(words.unit_flag),
         .problem = fmt::format("{} is not a unit such as {}", in_quotes(text), meant_or_usual(column.unit, words))});
  require_unit_of_file(file, column, *unit, text, words.unit_flag);
  std::string note;
  if (!column.unit.empty() && machine_unit(column.unit) != unit)
    note = fmt::format("column {}: the file says {}; taken as {}, as you ask", in_quotes(column.name),
                       in_quotes(column.unit), text);
  column.unit = text;
  return {std::move(column), std::move(note)};
}

Export with_units(Export file, const std::map<ColumnRole, std::string>& units) {
  for (ExportedSpecimen& specimen : file.specimens)
    for (ExportColumn& column : specimen.columns) {
      auto given = units.find(column.role);
      if (given == units.end() && is_displacement(column.role)) given = units.find(ColumnRole::displacement);
      if (given == units.end()) continue;
      const std::string_view text = trimmed(given->second);
      auto [restated, note] = text.ends_with("/V") ? calibrated(file, column, text) : in_unit(file, column, text);
      column = std::move(restated);
      if (!note.empty()) add_note(file, std::move(note));
    }
  return file;
}

// Refuses a unit that contradicts the maximum force stated in the file. A small difference only
// gives a note: the program evaluated a range, or smoothed values.
std::string beside_stated_maximum(const Export& file, const ExportOptions& options) {
  if (file.specimens.size() != 1) return "";
  const std::vector<Metadatum> metadata = all_metadata(file);
  const std::optional<StatedForce> stated = stated_maximum(metadata, file.marks);
  const Columns forces = with_role(file.specimens.front().columns, ColumnRole::force);
  if (!stated || forces.size() != 1) return "";
  const ExportColumn& force = *forces.front();
  const std::optional<Unit> unit = machine_unit(force.unit);
  if (!unit || unit->dimension != kind::force.dimension) return "";
  double highest = 0;
  for (const double value : force.values)
    if (!std::isnan(value)) highest = std::max(highest, std::abs(to_si(value, *unit)));
  const double ratio = std::abs(stated->value) / highest;
  if (ratio < contradicts && ratio > 1 / contradicts)
    return std::abs(ratio - 1) <= 0.01
               ? ""
               : fmt::format("line {} states a maximum force of {}, but the rows have {}", stated->where->line,
                             readable(stated->value, kind::force), readable(highest, kind::force));
  if (options.units.contains(ColumnRole::force)) return "";
  throw InputError({.file = file.origin.source,
                    .line = stated->where->line,
                    .field = "column " + in_quotes(force.name),
                    .problem = fmt::format("This line states a maximum of {}, but the readings reach {}",
                                           readable(stated->value, kind::force), readable(highest, kind::force)),
                    .remedy = "check that the file is complete, and the unit of the column"});
}

// ---- open questions, and flags that repeat the decisions

OpenQuestion which_of(const Columns& columns) {
  const RoleWords& words = words_for(columns.front()->role);
  const std::string number = fmt::format("{}", columns.front()->number);
  return {fmt::format("which of the columns {} is the {}?", listed_columns(columns), words.word()),
          fmt::format("{} {}", words.flag, number),
          words.word() == "force" ? std::vector<RecordKey>{{"force", number}}
                                  : std::vector<RecordKey>{{"displacement", fmt::format("\"{}\"", words.word())},
                                                           {"displacement_column", number}}};
}

// The question for the unit of a column, with the units that it may mean.
OpenQuestion unit_of(const ExportColumn& column) {
  const RoleWords& words = words_for(column.role);
  const std::vector<std::string_view> meant = meant_units(column.unit, *words.kind);
  const std::string_view unit = meant_or_usual(column.unit, words);
  const bool is_force = column.role == ColumnRole::force;
  return {fmt::format("what is the unit of {}{}{}?", in_quotes(column.name),
                      column.unit.empty() ? "" : ", which says " + in_quotes(column.unit),
                      meant.empty() ? "" : fmt::format(": {}", fmt::join(meant, " or "))),
          fmt::format("{} {}", words.unit_flag, unit),
          column.role == ColumnRole::time ? std::vector<RecordKey>{}
                                          : std::vector<RecordKey>{{is_force ? "force" : "displacement_column",
                                                                    fmt::format("\"{} [{}]\"", column.name, unit)}}};
}

// The note on columns that are titled as force and hold no numbers.
std::string words_for_force(const std::vector<ExportColumn>& columns) {
  for (const ExportColumn& column : columns)
    if (!column.words.empty() && role_of(column.name) == ColumnRole::force)
      return fmt::format(" The cells of {} are no numbers: the first is {}.", in_quotes(column.name),
                         in_quotes(column.words.front()));
  return "";
}

// A sheet as a shell argument: its name, or its number if the name needs more than quotes.
std::string sheet_word(const Export& file) {
  if (file.origin.sheet->find_first_of("\"$`\\!") == std::string::npos)
    return fmt::format("\"{}\"", *file.origin.sheet);
  const auto at = std::find(file.origin.sheets.begin(), file.origin.sheets.end(), *file.origin.sheet);
  return std::to_string(1 + (at - file.origin.sheets.begin()));
}

std::string mark_word(char mark) {
  return mark == '\0'                  ? "none"
         : mark == '\t'                ? "tab"
         : mark == ' '                 ? "space"
         : mark == ';' || mark == '\'' ? fmt::format("\"{}\"", mark)
                                       : std::string(1, mark);
}

std::string flags_of(const Export& file, const ExportedSpecimen& specimen, const ExportOptions& options) {
  std::vector<std::string> flags;
  if (file.origin.sheet) flags.push_back("--sheet " + sheet_word(file));
  if (file.origin.has_delimiters)
    flags.push_back(
        fmt::format("--encoding {} --separator {}", name_of(file.origin.encoding), mark_word(file.origin.separator)));
  if (file.has_marks)
    flags.push_back(
        fmt::format("--decimal {} --thousands {}", mark_word(file.marks.decimal), mark_word(file.marks.thousands)));
  for (const ColumnRole role : {ColumnRole::time, ColumnRole::crosshead, ColumnRole::deflection, ColumnRole::force})
    if (const Columns columns = with_role(specimen.columns, role); columns.size() == 1) {
      const ExportColumn& column = *columns.front();
      const auto asked = options.columns.find(role);
      const bool says_unit = asked != options.columns.end() && trimmed(asked->second).ends_with(']') &&
                             trimmed(asked->second) != column.name;
      flags.push_back(says_unit ? fmt::format("{} \"{} [{}]\"", words_for(role).flag, column.number, column.unit)
                                : fmt::format("{} {}", words_for(role).flag, column.number));
    }
  for (const auto& [role, unit] : options.units)
    flags.push_back(fmt::format("{} \"{}\"", unit.ends_with("/V") ? "--calibration" : words_for(role).unit_flag, unit));
  return fmt::format("{}", fmt::join(flags, " "));
}

}  // namespace

std::vector<OpenQuestion> questions_of(const std::vector<ExportColumn>& columns) {
  std::vector<OpenQuestion> asks;
  const Columns forces = with_role(columns, ColumnRole::force);
  const Columns unclear = with_role(columns, ColumnRole::displacement);
  const std::array clear{with_role(columns, ColumnRole::crosshead), with_role(columns, ColumnRole::deflection)};
  const bool has_clear = !clear[0].empty() || !clear[1].empty();
  constexpr const char* either = "--crosshead COLUMN or --deflection COLUMN";
  constexpr const char* which = "--displacement crosshead|deflection";
  const bool has_units =
      std::any_of(columns.begin(), columns.end(), [](const ExportColumn& each) { return !each.unit.empty(); });
  const RecordKey which_displacement{"displacement", "\"crosshead|deflection\""};
  const std::vector<RecordKey> a_displacement{which_displacement,
                                              {"displacement_column", has_units ? "\"COLUMN\"" : "\"COLUMN [mm]\""}};
  if (forces.empty())
    asks.push_back({"which column is the force?" + words_for_force(columns),
                    "--force COLUMN, its name or number",
                    {{"force", has_units ? "\"COLUMN\"" : "\"COLUMN [N]\""}}});
  if (forces.size() > 1) asks.push_back(which_of(forces));
  const bool has_only_time = !with_role(columns, ColumnRole::time).empty() &&
                             std::none_of(columns.begin(), columns.end(), [](const ExportColumn& each) {
                               return each.role == ColumnRole::other && each.words.empty();
                             });
  if (!has_clear && unclear.empty() && has_only_time)
    asks.push_back({"there is no displacement: at which speed did the crosshead move?",
                    "--speed \"0.5 mm/s\" of fit and modulus",
                    {{"speed", "\"… mm/s\""}}});
  else if (!has_clear && unclear.empty())
    asks.push_back({"which column is the displacement?", either, a_displacement});
  if (!has_clear && unclear.size() == 1)
    asks.push_back({fmt::format("was {} measured at the crosshead or at the specimen's midpoint?",
                                in_quotes(unclear.front()->name)),
                    which,
                    {which_displacement}});
  if (!has_clear && unclear.size() > 1)
    asks.push_back({fmt::format("which of the columns {} was measured at the crosshead, or at the specimen's midpoint?",
                                listed_columns(unclear)),
                    either, a_displacement});
  for (const Columns& several : clear)
    if (several.size() > 1) asks.push_back(which_of(several));
  for (const ExportColumn& column : columns)
    if (const auto unit = machine_unit(column.unit); column.role != ColumnRole::other &&
                                                     !is_of_kind(unit, words_for(column.role)) &&
                                                     !may_be_stress(unit, column.role))
      asks.push_back(unit_of(column));
  return asks;
}

Export decided(Export file, const ExportOptions& options, std::size_t header_line) {
  const bool asks_displacement =
      options.displacement || std::any_of(options.columns.begin(), options.columns.end(),
                                          [](const auto& asked) { return is_displacement(asked.first); });
  file = with_columns(std::move(file), options.columns);
  file = with_roles_by_units(std::move(file));
  file = with_one_time(std::move(file));
  file = without_silent_columns(std::move(file));
  if (!asks_displacement) file = with_finest(std::move(file));
  require_no_voltage_for_force(file, options, header_line);
  if (options.displacement) file = with_displacement(std::move(file), *options.displacement);
  file = with_units(std::move(file), options.units);
  require_force_in_newtons(file, header_line);
  file = with_load_train(std::move(file), asks_displacement);
  if (std::string said = beside_stated_maximum(file, options); !said.empty()) file.notes.push_back(std::move(said));
  for (ExportedSpecimen& specimen : file.specimens) {
    specimen.asks = questions_of(specimen.columns);
    specimen.repeat_with = flags_of(file, specimen, options);
  }
  return file;
}

}  // namespace flexslip
