// Will this test show a sawtooth, and what would have to change for it to be otherwise?
#pragma once

#include <vector>

#include "cases/design_case.h"

namespace flexslip {

// The nearest value of one parameter, the others as they are, with which the specimen snaps if it does not, or does not if it does.
struct DesignChange {
  DesignParameter parameter;
  double from, to;        // [units of the case]
  DesignOutcome outcome;  // with it
};

struct DesignAnswer {
  DesignCase input;
  Design design;
  Scales scales;
  DesignOutcome outcome;
  double critical;  // [EI/L^3] load-train stiffness above which no loading to a deflection as large as the travel snaps
  std::vector<DesignChange> changes;
};

// Fails:      InputError as DesignCase::design().
// Method:     the stiffness between its own value and the critical one (critical_stiffness.h), and from it in closed form diameter and
//             modulus, of which nothing else depends; the travel is that of the first snap. Of the others the nearest value is sought in
//             steps of 10 %, up to 30 times as much or as little, and its neighbourhood halved to 1e-4: a window narrower than a step
//             may be missed.
// Cost:       some 500 outcomes.
DesignAnswer answer_of(const DesignCase& input);

// How far a rig is from where the fibre begins to snap: ln k/k_critical up to the deflection that the loading gets to, within [-3, 3].
// Above 0 it does not snap. Tolerance: 1 % of the range.
double stiffness_margin(const Design& design);

}  // namespace flexslip
