#include "result/mechanics.h"

namespace flexslip {
namespace {

// Of a jump: where it begins and ends.
template <class Jump>
Fields<Jump> jump_fields() {
  return Fields<Jump>()
      .number("stage", kind::length, "stage position, which does not change on the way", &Jump::stage)
      .number("deflection_before", kind::length, "deflection before it", [](const Jump& jump) { return jump.before.w; })
      .number("deflection_after", kind::length, "deflection after it", [](const Jump& jump) { return jump.after.w; })
      .number("force_before", kind::force, "force before it", [](const Jump& jump) { return jump.before.F; })
      .number("force_after", kind::force, "force after it", [](const Jump& jump) { return jump.after.F; });
}

}  // namespace

Fields<Snap> snap_fields() {
  return jump_fields<Snap>()
      .number("length_before", kind::length, "drawn in before it, and the span",
              [](const Snap& snap) { return snap.before.S; })
      .number("length_after", kind::length, "drawn in after it, and the span",
              [](const Snap& snap) { return snap.after.S; });
}

Fields<CrackOpened> crack_fields() {
  return jump_fields<CrackOpened>()
      .number("left", "of the first bending stiffness after it",
              [](const CrackOpened& crack) { return crack.after.left; })
      .number("released", kind::energy, "energy that the crack sets free", &CrackOpened::released);
}

Fields<EnergyAccount> energy_fields() {
  return Fields<EnergyAccount>()
      .number("stage_work", kind::energy, "work of the stage", &EnergyAccount::stage_work)
      .number("bending", kind::energy, "stored in the bent specimen", &EnergyAccount::bending)
      .number("load_train", kind::energy, "stored in the load train", &EnergyAccount::load_train)
      .number("friction", kind::energy, "heat of friction at the supports", &EnergyAccount::friction)
      .number("snaps", kind::energy, "set free by snaps beyond friction; of a measured test all that is lost in drops",
              &EnergyAccount::snaps)
      .number("imbalance", kind::energy, "what the account does not close by", &EnergyAccount::imbalance);
}

}  // namespace flexslip
