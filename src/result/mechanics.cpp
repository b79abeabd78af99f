#include "result/mechanics.h"

namespace flexslip {
namespace {

// Of a jump: where it begins and ends.
template <class Jump>
Fields<Jump> jump_fields() {
  return Fields<Jump>()
      .number("stage", kind::length, "stage position, which stays the same", &Jump::stage)
      .number("deflection_before", kind::length, "deflection before the jump",
              [](const Jump& jump) { return jump.before.w; })
      .number("deflection_after", kind::length, "deflection after the jump",
              [](const Jump& jump) { return jump.after.w; })
      .number("force_before", kind::force, "force before the jump", [](const Jump& jump) { return jump.before.F; })
      .number("force_after", kind::force, "force after the jump", [](const Jump& jump) { return jump.after.F; });
}

}  // namespace

Fields<Snap> snap_fields() {
  return jump_fields<Snap>()
      .number("length_before", kind::length,
              "length between the supports before the snap: the span and what was pulled in",
              [](const Snap& snap) { return snap.before.S; })
      .number("length_after", kind::length,
              "length between the supports after the snap: the span and what was pulled in",
              [](const Snap& snap) { return snap.after.S; });
}

Fields<CrackOpened> crack_fields() {
  return jump_fields<CrackOpened>()
      .number("left", "share of the initial bending stiffness that is left after the crack",
              [](const CrackOpened& crack) { return crack.after.left; })
      .number("released", kind::energy, "energy that the crack sets free", &CrackOpened::released);
}

Fields<EnergyAccount> energy_part_fields(std::string_view of_snaps) {
  return Fields<EnergyAccount>()
      .number("stage_work", kind::energy, "work of the stage", &EnergyAccount::stage_work)
      .number("bending", kind::energy, "energy stored in the bent specimen", &EnergyAccount::bending)
      .number("load_train", kind::energy, "energy stored in the load train", &EnergyAccount::load_train)
      .number("friction", kind::energy, "heat of friction at the supports", &EnergyAccount::friction)
      .number("snaps", kind::energy, of_snaps, &EnergyAccount::snaps);
}

Fields<EnergyAccount> energy_fields() {
  return energy_part_fields("energy set free by snaps beyond friction; for a measured test all energy lost in drops")
      .number("imbalance", kind::energy, "amount by which the account does not close", &EnergyAccount::imbalance);
}

}  // namespace flexslip
