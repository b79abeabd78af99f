#include "design/outcome_fields.h"

#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double no_number = not_a_number;
constexpr FirstSnap no_snap{no_number, no_number, no_number, no_number};

using O = const DesignOutcome&;
using U = const DesignUnits&;

template <class Get>
auto told(Get get) {
  return [get](const DesignResult& result) {
    return result.outcome ? std::optional(get(*result.outcome, *result.units)) : std::nullopt;
  };
}

Fields<DesignResult> fields_of_outcomes() {
  return Fields<DesignResult>()
      .own("stage_reached", kind::length, "stage position that the loading reaches",
           told([](O o, U u) { return u.scales.physical_length(o.stage_reached); }))
      .own("deflection_reached", kind::length, "deflection at that stage position",
           told([](O o, U u) { return u.scales.physical_length(o.w_reached); }))
      .count("snaps", "number of snaps of the specimen, however small", told([](O o, U) { return o.snaps; }))
      .own("first_snap_stage", kind::length, "stage position of the first snap; none without a snap",
           told([](O o, U u) { return u.scales.physical_length(o.first_snap.value_or(no_snap).stage); }))
      .own("first_snap_deflection", kind::length, "deflection before the first snap; none without a snap",
           told([](O o, U u) { return u.scales.physical_length(o.first_snap.value_or(no_snap).w); }))
      .own("first_snap_force_before", kind::force, "force before the first snap; none without a snap",
           told([](O o, U u) { return u.scales.physical_force(o.first_snap.value_or(no_snap).F_before); }))
      .own("first_snap_force_after", kind::force, "force after the first snap; none without a snap",
           told([](O o, U u) { return u.scales.physical_force(o.first_snap.value_or(no_snap).F_after); }))
      .count("drops",
             "number of drops that the record shows: falls of the force between readings, a run of them counting once",
             told([](O o, U) { return o.drops; }))
      .own("largest_drop", kind::force, "largest fall of the force; 0 without drops",
           told([](O o, U u) { return u.scales.physical_force(o.largest_drop); }))
      .own("mean_drop", kind::force, "mean fall of the force; 0 without drops",
           told([](O o, U u) { return u.scales.physical_force(o.mean_drop); }))
      .own("greatest_force", kind::force, "greatest force",
           told([](O o, U u) { return u.scales.physical_force(o.greatest_force); }))
      .number("greatest_strain", "greatest bending strain of the surface at midspan; none without a section",
              told([](O o, U u) { return u.surface ? u.surface->strain(o.greatest_curvature) : no_number; }))
      .own("greatest_stress", kind::pressure,
           "greatest bending stress of the surface at midspan; none without a section",
           told([](O o, U u) { return u.surface ? u.surface->stress(o.greatest_curvature) : no_number; }))
      .own("work", kind::energy, "work measured on the specimen",
           told([](O o, U u) { return u.scales.physical_energy(o.work); }))
      .own("friction_heat", kind::energy, "part of the work that friction turns into heat at the supports",
           told([](O o, U u) { return u.scales.physical_energy(o.friction_heat); }))
      .own("released", kind::energy, "part of the work that the snaps set free beyond friction",
           told([](O o, U u) { return u.scales.physical_energy(o.released); }));
}

}  // namespace

const Fields<DesignResult>& outcome_fields() {
  static const Fields<DesignResult> fields = fields_of_outcomes();
  return fields;
}

}  // namespace flexslip
