// The legs of a simulated test: where the stage turned, and what each loading and unloading cost.
#pragma once

#include <vector>

#include "bending_test/history.h"
#include "data/legs.h"
#include "data/scales.h"
#include "io/json.h"

namespace flexslip {

// Legs of a path, in indices of its points. The way from the straight fibre to the first point belongs to the first leg.
// Domain:     as find_legs.
std::vector<Leg> legs_of(const History& history, const LegOptions& options);

// [{direction, from, to, stage_work, bending, load_train, friction, snaps, cracks, work_of_fracture}], in SI: stage positions, and by
// how much each energy has changed.
Json legs_json(const History& history, const std::vector<Leg>& legs, const Scales& scales);

}  // namespace flexslip
