#include "answers/mechanics_fields.h"

#include "data/names.h"

namespace flexslip {
namespace {

// The start and the end of a jump.
template <class Jump>
Fields<Jump> jump_fields() {
  return Fields<Jump>()
      .number("stage", kind::length, "stage position, constant during the jump", &Jump::stage)
      .number("deflection_before", kind::length, "deflection before the jump",
              [](const Jump& jump) { return jump.before.w; })
      .number("deflection_after", kind::length, "deflection after the jump",
              [](const Jump& jump) { return jump.after.w; })
      .number("force_before", kind::force, "force before the jump", [](const Jump& jump) { return jump.before.F; })
      .number("force_after", kind::force, "force after the jump", [](const Jump& jump) { return jump.after.F; });
}

Fields<Snap> snap_fields() {
  return jump_fields<Snap>()
      .number("length_before", kind::length, "span plus sliding length before the snap",
              [](const Snap& snap) { return snap.before.S; })
      .number("length_after", kind::length, "span plus sliding length after the snap",
              [](const Snap& snap) { return snap.after.S; })
      .number("friction", kind::energy, "heat of friction in the snap", &Snap::friction)
      .number("released", kind::energy, "energy released by the snap in excess of friction", &Snap::released);
}

Fields<CrackOpened> crack_fields() {
  return jump_fields<CrackOpened>()
      .number("left", "share of the initial bending stiffness that remains after the crack",
              [](const CrackOpened& crack) { return crack.after.left; })
      .number("released", kind::energy, "energy released by the crack", &CrackOpened::released);
}

// The energy account of a test or of a part of it, without the energy released by jumps.
Fields<EnergyAccount> steady_energy_fields() {
  return Fields<EnergyAccount>()
      .number("stage_work", kind::energy, "work of the stage", &EnergyAccount::stage_work)
      .number("bending", kind::energy, "bending energy of the specimen", &EnergyAccount::bending)
      .number("load_train", kind::energy, "energy stored in the load train", &EnergyAccount::load_train)
      .number("friction", kind::energy, "heat of friction at the supports", &EnergyAccount::friction);
}

Fields<EnergyAccount> part_fields() {
  return steady_energy_fields()
      .number("snaps", kind::energy, "energy released by snaps in excess of friction", &EnergyAccount::snaps)
      .number("cracks", kind::energy, "energy released by cracks", &EnergyAccount::cracks);
}

Fields<SimulatedLeg> simulated_leg_fields() {
  using L = const SimulatedLeg&;
  return Fields<SimulatedLeg>()
      .words("direction", "direction of the leg: loading or unloading",
             [](L leg) {
               return name_in_order<Direction::unloading>(leg.direction, {"loading", "unloading"});
             })
      .own("from", kind::length, "stage position at the start of the leg", &SimulatedLeg::from)
      .own("to", kind::length, "stage position at the end of the leg", &SimulatedLeg::to)
      .all_of(part_fields(), &SimulatedLeg::change)
      .number("work_of_fracture", kind::energy, "work on the specimen", &SimulatedLeg::work_of_fracture);
}

Fields<EnergyAccount> whole_energy_fields() {
  return with_work<EnergyAccount>(part_fields(), work_of_fracture, [](const EnergyAccount& energy) {
    return (energy.friction + energy.snaps) / work_of_fracture(energy);
  });
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
      .words("motion",
             "motion of the specimen: stick, slip_in, slip_out, snap, crack, or apart (no contact at the nose)",
             &SimulatedPoint::motion);
  if (columns.three_lengths)
    fields
        .own("drawn_in", kind::length,
             "sliding length: length that has slid in past the first contacts, over both supports",
             &SimulatedPoint::drawn_in)
        .own("imaged", kind::length,
             "length of the axis between the vertical planes through the supports, as in a side-view image",
             &SimulatedPoint::imaged);
  if (columns.surface)
    fields.number("strain", "bending strain of the surface at midspan", &SimulatedPoint::strain)
        .own("stress", kind::pressure, "bending stress of the surface at midspan", &SimulatedPoint::stress);
  if (columns.two_sides)
    fields.own("left", kind::length, "length that has slid in over the first support", &SimulatedPoint::left)
        .own("right", kind::length, "length that has slid in over the other support", &SimulatedPoint::right);
  if (columns.energies) fields.all_of(part_fields(), &SimulatedPoint::energy);
  return fields;
}

Fields<Simulation> simulation_fields(const PathColumns& columns) {
  return Fields<Simulation>()
      .words("status", "ok; if the path ends early, slipped_through or contact_lost", &Simulation::status)
      .group("units", "units of plain numbers", units_of_numbers<Simulation>())
      .list("path", "path of the test, point by point", path_fields(columns), &Simulation::path)
      .list("snaps", "snaps of the specimen", snap_fields(), &Simulation::snaps)
      .list("cracks", "stated cracks that opened", crack_fields(), &Simulation::cracks)
      .number("wraps_nose_from", kind::length,
              "stage position from which the specimen wraps around the nose; null if it does not",
              &Simulation::wraps_nose_from)
      .list("legs", "legs between reversals of the stage, with the change of each energy", simulated_leg_fields(),
            &Simulation::legs)
      .group("energy", "energy account from start to end", whole_energy_fields(), &Simulation::energy);
}

}  // namespace flexslip
