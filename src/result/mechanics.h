// What a test does, as answers tell it: snaps, and where the energy goes.
#pragma once

#include "bending_test/history.h"
#include "result/fields.h"

namespace flexslip {

// The units of all plain numbers of an answer; of any row.
template <class Row>
Fields<Row> units_of_numbers() {
  const auto unit = [](const Kind& kind) {
    return [kind](const Row& /*row*/, const Frame& frame) { return unit_of(kind, frame.reduced); };
  };
  return Fields<Row>()
      .words("length", "of lengths, stage positions and deflections", unit(kind::length))
      .words("force", "of forces", unit(kind::force))
      .words("energy", "of energies", unit(kind::energy));
}

Fields<Snap> snap_fields();
Fields<CrackOpened> crack_fields();
Fields<EnergyAccount> energy_fields();
// The parts of it, of a test or of a stretch of one, without what the account leaves; `of_snaps` is what the energy of snaps means.
Fields<EnergyAccount> energy_part_fields(std::string_view of_snaps);

}  // namespace flexslip
