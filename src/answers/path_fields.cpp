#include "answers/path_fields.h"

#include "data/names.h"
#include "result/mechanics.h"

namespace flexslip {
namespace {

Fields<Snap> snap_fields_with_energies() {
  return snap_fields()
      .number("friction", kind::energy, "heat of friction in the snap", &Snap::friction)
      .number("released", kind::energy, "energy that the snap sets free beyond friction", &Snap::released);
}

// The energies of a stretch of a test.
Fields<EnergyAccount> part_fields() {
  return energy_part_fields("energy set free by snaps beyond friction")
      .number("cracks", kind::energy, "energy set free by cracks", &EnergyAccount::cracks);
}

Fields<SimulatedLeg> simulated_leg_fields() {
  using L = const SimulatedLeg&;
  return Fields<SimulatedLeg>()
      .words("direction", "direction of the leg: loading or unloading",
             [](L leg) {
               return name_in_order<Direction::unloading>(leg.direction, {"loading", "unloading"});
             })
      .own("from", kind::length, "stage position where the leg begins", &SimulatedLeg::from)
      .own("to", kind::length, "stage position where the leg ends", &SimulatedLeg::to)
      .all_of(part_fields(), &SimulatedLeg::change)
      .number("work_of_fracture", kind::energy, "work on the specimen", &SimulatedLeg::work_of_fracture);
}

Fields<EnergyAccount> whole_energy_fields() {
  using E = const EnergyAccount&;
  return energy_fields()
      .number("cracks", kind::energy, "energy set free by cracks", &EnergyAccount::cracks)
      .number("work_of_fracture", kind::energy, "work on the specimen: area under force over deflection",
              work_of_fracture)
      .number("friction_share", "share of the work of fracture that went into friction and snaps",
              [](E energy) { return (energy.friction + energy.snaps) / work_of_fracture(energy); })
      .number("remaining", kind::energy, "work of fracture without friction and snaps",
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
      .own("length", kind::length, "length of the specimen's axis between the contacts", &SimulatedPoint::length)
      .titled("S")
      .number("q", "mobilised friction", &SimulatedPoint::q)
      .words("motion", "how the specimen moves: stick, slip_in, slip_out, snap, crack, apart (the nose lifts off)",
             &SimulatedPoint::motion);
  if (columns.three_lengths)
    fields
        .own("drawn_in", kind::length, "length that has slid past the first contacts, over both supports",
             &SimulatedPoint::drawn_in)
        .own("imaged", kind::length,
             "length of the axis between the verticals through the supports, as a camera sees it",
             &SimulatedPoint::imaged);
  if (columns.surface)
    fields.number("strain", "bending strain of the surface at midspan", &SimulatedPoint::strain)
        .own("stress", kind::pressure, "bending stress of the surface at midspan", &SimulatedPoint::stress);
  if (columns.two_sides)
    fields.own("left", kind::length, "length pulled in over the first support", &SimulatedPoint::left)
        .own("right", kind::length, "length pulled in over the other support", &SimulatedPoint::right);
  if (columns.energies) fields.all_of(part_fields(), &SimulatedPoint::energy);
  return fields;
}

Fields<Simulation> simulation_fields(const PathColumns& columns) {
  return Fields<Simulation>()
      .words("status", "whether the path is complete: ok, or why it ends early: slipped_through, contact_lost",
             &Simulation::status)
      .group("units", "units of plain numbers", units_of_numbers<Simulation>())
      .list("path", "path of the test, point by point", path_fields(columns), &Simulation::path)
      .list("snaps", "snaps of the specimen", snap_fields_with_energies(), &Simulation::snaps)
      .list("cracks", "stated cracks, where they opened", crack_fields(), &Simulation::cracks)
      .number("wraps_nose_from", kind::length,
              "stage position from which the specimen wraps the nose; null if it does not",
              &Simulation::wraps_nose_from)
      .list("legs", "legs from turn to turn of the stage, with the change of each energy", simulated_leg_fields(),
            &Simulation::legs)
      .group("energy", "where the work went, from the start to the end", whole_energy_fields(), &Simulation::energy);
}

}  // namespace flexslip
