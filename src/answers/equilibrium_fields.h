// What `equilibrium` tells, described once.
#pragma once

#include <string_view>
#include <vector>

#include "bending_test/equilibrium.h"
#include "case/studies.h"
#include "result/fields.h"

namespace flexslip {

struct ToldEquilibrium {
  EquilibriumPoint point;
  double between_contacts;  // [L]
};

struct EquilibriumColumns {
  bool region;    // all equilibria, not the curve of loading
  bool drawn_in;  // is not told by the length
};

Fields<ToldEquilibrium> equilibrium_fields(const EquilibriumColumns& columns);

// Of `equilibrium --json`.
struct Equilibria {
  std::string_view status;
  std::vector<ToldEquilibrium> points;
};
Fields<Equilibria> equilibria_fields(const EquilibriumColumns& columns);

// What a study tells, and in which columns.
Equilibria told_of(const EquilibriumStudy& study);
EquilibriumColumns columns_of(const EquilibriumStudy& study);

}  // namespace flexslip
