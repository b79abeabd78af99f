// What is tested, and on what: a fibre with friction on a rig.
#pragma once

#include "bending_test/rig.h"
#include "contact/friction_law.h"

namespace flexslip {

// Where a snap comes to rest.
enum class SnapRest {
  nearest_stable,  // at the next stable state, q = μ_k: whatever is set free is lost at once (the paper's postulate, (4.32))
  overshoot,  // the energy set free carries the fibre on, until friction has consumed it: it rests with |q| below the
              // static friction, after swinging back if need be. What does not end in 1,000 swings, or swings so
              // far back that only a friction beyond 20 would hold the fibre, rests as above.
};

struct BendingTest {
  FrictionLaw
      friction;  // on two supports that are not alike without a static excess, and at rest at the nearest stable state
  Rig rig;
  SnapRest rest = SnapRest::nearest_stable;
};

}  // namespace flexslip
