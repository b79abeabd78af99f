// The fields of simulated tests: path, snaps, cracks, energy account; and of `simulate`.
#pragma once

#include "bending_test/history.h"
#include "case/simulated_test.h"
#include "result/fields.h"

namespace flexslip {

// The units of all plain numbers of an answer.
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

// The fields of an energy account with the work of fracture.
template <class Account>
Fields<Account> with_work(Fields<Account> fields, Getter<Account> work, Getter<Account> friction_share) {
  return fields
      .number("work_of_fracture", kind::energy, "work on the specimen: area under force over deflection",
              std::move(work))
      .number("friction_share", "share of the work of fracture that went into friction and snaps",
              std::move(friction_share));
}

// The optional columns of a path.
struct PathColumns {
  bool surface, three_lengths, two_sides, energies;
};
inline constexpr PathColumns all_columns{true, true, true, true};

// The columns that a test has.
inline PathColumns columns_of(const Simulation& test, bool energies) {
  return {test.has_surface, test.has_three_lengths, test.has_two_sides, energies};
}

Fields<SimulatedPoint> path_fields(const PathColumns& columns);

// The fields of `simulate --json`.
Fields<Simulation> simulation_fields(const PathColumns& columns);

}  // namespace flexslip
