#include "cases/design_result.h"

#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace flexslip {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr FirstSnap no_snap{nothing, nothing, nothing, nothing};

using O = const DesignOutcome&;
using U = const DesignUnits&;

constexpr std::array columns{
    OutcomeColumn{"stage_reached", kind::length, StoredAs::float64, "stage position that the loading gets to",
                  [](O o, U u) { return u.scales.physical_length(o.stage_reached); }},
    OutcomeColumn{"deflection_reached", kind::length, StoredAs::float64, "deflection at that stage position",
                  [](O o, U u) { return u.scales.physical_length(o.w_reached); }},
    OutcomeColumn{"snaps", kind::number, StoredAs::uint32, "snaps of the specimen, however small",
                  [](O o, U) { return static_cast<double>(o.snaps); }},
    OutcomeColumn{"first_snap_stage", kind::length, StoredAs::float64,
                  "stage position of the first snap; NaN if there is none",
                  [](O o, U u) { return u.scales.physical_length(o.first_snap.value_or(no_snap).stage); }},
    OutcomeColumn{"first_snap_deflection", kind::length, StoredAs::float64,
                  "deflection before the first snap; NaN if there is none",
                  [](O o, U u) { return u.scales.physical_length(o.first_snap.value_or(no_snap).w); }},
    OutcomeColumn{"first_snap_force_before", kind::force, StoredAs::float64,
                  "force before the first snap; NaN if there is none",
                  [](O o, U u) { return u.scales.physical_force(o.first_snap.value_or(no_snap).F_before); }},
    OutcomeColumn{"first_snap_force_after", kind::force, StoredAs::float64,
                  "force after the first snap; NaN if there is none",
                  [](O o, U u) { return u.scales.physical_force(o.first_snap.value_or(no_snap).F_after); }},
    OutcomeColumn{"drops", kind::number, StoredAs::uint32,
                  "falls of the force between readings, a run of them counting once: the teeth that the record shows",
                  [](O o, U) { return static_cast<double>(o.drops); }},
    OutcomeColumn{"largest_drop", kind::force, StoredAs::float64, "largest fall of the force; 0 without drops",
                  [](O o, U u) { return u.scales.physical_force(o.largest_drop); }},
    OutcomeColumn{"mean_drop", kind::force, StoredAs::float64, "mean fall of the force; 0 without drops",
                  [](O o, U u) { return u.scales.physical_force(o.mean_drop); }},
    OutcomeColumn{"greatest_force", kind::force, StoredAs::float64, "greatest force",
                  [](O o, U u) { return u.scales.physical_force(o.greatest_force); }},
    OutcomeColumn{"greatest_strain", kind::number, StoredAs::float64,
                  "greatest bending strain, at the surface at midspan; NaN without a section",
                  [](O o, U u) { return u.surface ? u.surface->strain(o.greatest_curvature) : nothing; }},
    OutcomeColumn{"greatest_stress", kind::pressure, StoredAs::float64, "greatest bending stress, likewise",
                  [](O o, U u) { return u.surface ? u.surface->stress(o.greatest_curvature) : nothing; }},
    OutcomeColumn{"work", kind::energy, StoredAs::float64, "work measured on the specimen",
                  [](O o, U u) { return u.scales.physical_energy(o.work); }},
    OutcomeColumn{"friction_heat", kind::energy, StoredAs::float64,
                  "part of the work that friction turns into heat at the supports",
                  [](O o, U u) { return u.scales.physical_energy(o.friction_heat); }},
    OutcomeColumn{"released", kind::energy, StoredAs::float64,
                  "part of the work that the snaps set free beyond friction",
                  [](O o, U u) { return u.scales.physical_energy(o.released); }},
};

struct UnitNames {
  Dimension dimension;
  std::string_view physical, reduced;
};

constexpr std::array unit_names{
    UnitNames{kind::number.dimension, "1", "1"},         UnitNames{kind::angle.dimension, "rad", "rad"},
    UnitNames{kind::length.dimension, "m", "L"},         UnitNames{kind::force.dimension, "N", "EI/L^2"},
    UnitNames{kind::energy.dimension, "J", "EI/L"},      UnitNames{kind::stiffness.dimension, "N/m", "EI/L^3"},
    UnitNames{kind::pressure.dimension, "Pa", "EI/L^4"},
};

ResultStatus status_of(DesignFault fault) {
  return fault == DesignFault::impossible ? ResultStatus::impossible : ResultStatus::not_computable;
}

}  // namespace

std::string_view word_of(ResultStatus status) { return result_status_words.at(static_cast<std::size_t>(status)); }

ResultStatus status_of(const DesignOutcome& outcome) {
  switch (outcome.status) {
    case DesignStatus::ok:
      return ResultStatus::ok;
    case DesignStatus::breaks:
      return ResultStatus::breaks;
    case DesignStatus::slipped_through:
      return ResultStatus::slipped_through;
  }
  throw std::invalid_argument("no such status");
}

DesignResult result_of(const DesignCase& input) try {
  const auto plan = input.plan();
  if (const auto* refused = std::get_if<DesignRefusal>(&plan)) return {status_of(refused->fault), {}, {}};
  const auto& [design, units] = std::get<PlannedDesign>(plan);
  const DesignOutcome outcome = outcome_of(design);
  return {status_of(outcome), units, outcome};
} catch (const std::invalid_argument&) {
  return {ResultStatus::not_computable, {}, {}};
}

std::span<const OutcomeColumn> outcome_columns() { return columns; }

std::string_view unit_of(const Kind& kind, bool reduced) {
  for (const UnitNames& names : unit_names)
    if (names.dimension == kind.dimension) return reduced ? names.reduced : names.physical;
  throw std::invalid_argument(fmt::format("unit_of: no unit for {}", kind.name));
}

}  // namespace flexslip
