#include "answers/path_fields.h"

#include "data/names.h"
#include "result/mechanics.h"

namespace flexslip {
namespace {

Fields<Snap> snap_fields_with_energies() {
  return snap_fields()
      .number("friction", kind::energy, "heat of friction in it", &Snap::friction)
      .number("released", kind::energy, "energy that it sets free beyond friction", &Snap::released);
}

// The energies of a stretch of a test.
Fields<EnergyAccount> part_fields() {
  return Fields<EnergyAccount>()
      .number("stage_work", kind::energy, "work of the stage", &EnergyAccount::stage_work)
      .number("bending", kind::energy, "stored in the bent specimen", &EnergyAccount::bending)
      .number("load_train", kind::energy, "stored in the load train", &EnergyAccount::load_train)
      .number("friction", kind::energy, "heat of friction at the supports", &EnergyAccount::friction)
      .number("snaps", kind::energy, "set free by snaps beyond friction", &EnergyAccount::snaps)
      .number("cracks", kind::energy, "set free by cracks", &EnergyAccount::cracks);
}

Fields<SimulatedLeg> simulated_leg_fields() {
  using L = const SimulatedLeg&;
  return Fields<SimulatedLeg>()
      .words("direction", "loading or unloading",
             [](L leg) {
               return name_in_order<Direction::unloading>(leg.direction, {"loading", "unloading"});
             })
      .own("from", kind::length, "stage position where it begins", &SimulatedLeg::from)
      .own("to", kind::length, "stage position where it ends", &SimulatedLeg::to)
      .all_of(part_fields(), &SimulatedLeg::change)
      .number("work_of_fracture", kind::energy, "work on the specimen", &SimulatedLeg::work_of_fracture);
}

Fields<EnergyAccount> whole_energy_fields() {
  using E = const EnergyAccount&;
  return energy_fields()
      .number("cracks", kind::energy, "set free by cracks", &EnergyAccount::cracks)
      .number("work_of_fracture", kind::energy, "work on the specimen: area under force over deflection",
              work_of_fracture)
      .number("friction_share", "of it that went into friction and snaps",
              [](E energy) { return (energy.friction + energy.snaps) / work_of_fracture(energy); })
      .number("remaining", kind::energy, "of it without friction and snaps",
              [](E energy) { return work_of_fracture(energy) - (energy.friction + energy.snaps); });
}

}  // namespace

Fields<SimulatedPoint> path_fields(const PathColumns& columns) {
  Fields<SimulatedPoint> fields;
  fields.own("stage", kind::length, "stage position", &SimulatedPoint::stage)
      .titled("w_s")
      .own("deflection", kind::length, "deflection at midspan", &SimulatedPoint::deflection)
      .titled("w")
      .own("force", kind::force, "force", &SimulatedPoint::force)
      .titled("F")
      .own("length", kind::length, "of the specimen's axis between the contacts", &SimulatedPoint::length)
      .titled("S")
      .number("q", "mobilised friction", &SimulatedPoint::q)
      .words("motion", "stick, slip_in, slip_out, snap, crack, apart (the nose lifts off), rolls (on loose rollers)",
             &SimulatedPoint::motion);
  if (columns.three_lengths)
    fields
        .own("drawn_in", kind::length, "what has slid past the first contacts, over both supports",
             &SimulatedPoint::drawn_in)
        .own("imaged", kind::length, "of the axis between the verticals through the supports, as a camera sees it",
             &SimulatedPoint::imaged);
  if (columns.surface)
    fields.number("strain", "bending strain of the surface at midspan", &SimulatedPoint::strain)
        .own("stress", kind::pressure, "bending stress there", &SimulatedPoint::stress);
  if (columns.two_sides)
    fields.own("left", kind::length, "drawn in over the first support", &SimulatedPoint::left)
        .own("right", kind::length, "drawn in over the other", &SimulatedPoint::right);
  if (columns.energies) fields.all_of(part_fields(), &SimulatedPoint::energy);
  return fields;
}

Fields<Simulation> simulation_fields(const PathColumns& columns) {
  return Fields<Simulation>()
      .words("status",
             "ok, or why the path ends before its programme: slipped_through, contact_lost, not_computable (on loose "
             "rollers)",
             &Simulation::status)
      .group("units", "of plain numbers", units_of_numbers<Simulation>())
      .list("path", "point by point", path_fields(columns), &Simulation::path)
      .list("snaps", "of the specimen", snap_fields_with_energies(), &Simulation::snaps)
      .list("cracks", "as stated, where they opened", crack_fields(), &Simulation::cracks)
      .number("wraps_nose_from", kind::length,
              "stage position from which the specimen wraps the nose; null where it does not",
              &Simulation::wraps_nose_from)
      .list("legs", "from turn to turn of the stage: by how much each energy changes", simulated_leg_fields(),
            &Simulation::legs)
      .group("energy", "where the work went, from the start to the end", whole_energy_fields(), &Simulation::energy);
}

}  // namespace flexslip
