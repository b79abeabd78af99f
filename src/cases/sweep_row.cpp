#include "cases/sweep_row.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace flexslip {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct OutcomeColumn {
  std::string_view name;
  const Kind* kind;
  StoredAs stored_as;
  std::string_view description;
};

constexpr std::array outcome_columns{
    OutcomeColumn{"status", &kind::number, StoredAs::uint8, "whether the design could be computed, and how it ended"},
    OutcomeColumn{"end", &kind::length, StoredAs::float64, "stage position that the loading gets to"},
    OutcomeColumn{"snaps", &kind::number, StoredAs::uint32, "snaps of the specimen, however small"},
    OutcomeColumn{"first_snap_stage", &kind::length, StoredAs::float64,
                  "stage position of the first snap; NaN if there is none"},
    OutcomeColumn{"first_snap_deflection", &kind::length, StoredAs::float64,
                  "deflection before the first snap; NaN if there is none"},
    OutcomeColumn{"first_snap_force_before", &kind::force, StoredAs::float64,
                  "force before the first snap; NaN if there is none"},
    OutcomeColumn{"first_snap_force_after", &kind::force, StoredAs::float64,
                  "force after the first snap; NaN if there is none"},
    OutcomeColumn{"drops", &kind::number, StoredAs::uint32,
                  "falls of the force between readings, a run of them counting once: the teeth that the record shows"},
    OutcomeColumn{"largest_drop", &kind::force, StoredAs::float64, "largest fall of the force; 0 without drops"},
    OutcomeColumn{"mean_drop", &kind::force, StoredAs::float64, "mean fall of the force; 0 without drops"},
    OutcomeColumn{"greatest_force", &kind::force, StoredAs::float64, "greatest force"},
    OutcomeColumn{"work", &kind::energy, StoredAs::float64, "work measured on the specimen"},
    OutcomeColumn{"friction", &kind::energy, StoredAs::float64,
                  "part of the work that friction turns into heat at the supports"},
    OutcomeColumn{"released", &kind::energy, StoredAs::float64,
                  "part of the work that the snaps set free beyond friction"},
};

struct UnitNames {
  Dimension dimension;
  std::string_view physical, reduced;
};

constexpr std::array unit_names{
    UnitNames{kind::number.dimension, "1", "1"},    UnitNames{kind::angle.dimension, "rad", "rad"},
    UnitNames{kind::length.dimension, "m", "L"},    UnitNames{kind::force.dimension, "N", "EI/L^2"},
    UnitNames{kind::energy.dimension, "J", "EI/L"}, UnitNames{kind::stiffness.dimension, "N/m", "EI/L^3"},
    UnitNames{kind::pressure.dimension, "Pa", "1"},
};

std::string units_of(const Kind& kind, bool reduced) {
  for (const UnitNames& names : unit_names)
    if (names.dimension == kind.dimension) return std::string(reduced ? names.reduced : names.physical);
  throw std::invalid_argument(fmt::format("units_of: no unit for {}", kind.name));
}

std::string_view description_of(DesignParameter parameter) {
  switch (parameter) {
    case DesignParameter::mu0:
      return "mean friction coefficient";
    case DesignParameter::amplitude:
      return "amplitude of the friction wave, relative to mu0";
    case DesignParameter::wavelength:
      return "wavelength of the friction along the specimen";
    case DesignParameter::phase:
      return "phase of the friction wave";
    case DesignParameter::span:
      return "support span";
    case DesignParameter::diameter:
      return "diameter of the specimen";
    case DesignParameter::modulus:
      return "flexural modulus of the specimen";
    case DesignParameter::stiffness:
      return "load-train stiffness; infinite for displacement control";
    case DesignParameter::travel:
      return "stage displacement at which the loading ends";
    case DesignParameter::step:
      return "stage displacement between two readings; 0 if the record is continuous";
  }
  throw std::invalid_argument("description_of: no such parameter");
}

std::vector<double> values_of(const DesignOutcome& outcome, const Scales& scales) {
  const auto snap = outcome.first_snap.value_or(FirstSnap{nan, nan, nan, nan});
  const auto status = outcome.status == DesignStatus::ok ? RowStatus::ok : RowStatus::slipped_through;
  return {static_cast<double>(status),
          scales.physical_length(outcome.end),
          static_cast<double>(outcome.snaps),
          scales.physical_length(snap.stage),
          scales.physical_length(snap.w),
          scales.physical_force(snap.F_before),
          scales.physical_force(snap.F_after),
          static_cast<double>(outcome.drops),
          scales.physical_force(outcome.largest_drop),
          scales.physical_force(outcome.mean_drop),
          scales.physical_force(outcome.greatest_force),
          scales.physical_energy(outcome.work),
          scales.physical_energy(outcome.friction),
          scales.physical_energy(outcome.released)};
}

std::vector<double> impossible_row() {
  std::vector<double> values;
  values.reserve(outcome_columns.size());
  for (const OutcomeColumn& column : outcome_columns) values.push_back(column.stored_as == StoredAs::float64 ? nan : 0);
  values.front() = static_cast<double>(RowStatus::impossible);
  return values;
}

}  // namespace

std::vector<SweepColumn> columns_of(const SweepPlan& plan) {
  const bool reduced = plan.input.reduced;
  std::vector<SweepColumn> columns;
  columns.reserve(plan.axes.size() + outcome_columns.size());
  for (const SweepAxis& axis : plan.axes)
    columns.push_back({fmt::format("/inputs/{}", axis.parameter.name), units_of(axis.parameter.kind, reduced),
                       std::string(description_of(axis.parameter.parameter)), StoredAs::float64});
  for (const OutcomeColumn& column : outcome_columns)
    columns.push_back({fmt::format("/outcomes/{}", column.name), units_of(*column.kind, reduced),
                       std::string(column.description), column.stored_as});
  return columns;
}

std::vector<std::string> row_status_words() { return {"ok", "slipped through", "impossible"}; }

std::size_t status_column(const SweepPlan& plan) { return plan.axes.size(); }

RowComputer::RowComputer(const SweepPlan& plan) : case_(plan.input) {
  parameters_.reserve(plan.axes.size());
  for (const SweepAxis& axis : plan.axes) parameters_.push_back(axis.parameter.parameter);
}

std::vector<double> RowComputer::operator()(std::span<const double> inputs) {
  try {
    for (std::size_t i = 0; i < inputs.size(); ++i) case_.set(parameters_[i], inputs[i]);
    return values_of(outcome_of(case_.design()), case_.scales());
  } catch (const InputError&) {
    return impossible_row();
  } catch (const std::invalid_argument&) {  // more roughness than can be followed
    return impossible_row();
  }
}

}  // namespace flexslip
