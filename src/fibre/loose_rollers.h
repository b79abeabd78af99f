// The elastica on rollers that roll loose on a flat base, and come nearer to each other as it is drawn in.
//
// A roller bears two forces, of the specimen and of the base, which lie on one line: q = tan(θ0/2), whatever the friction, as long as that suffices for
// it. Nothing is lost, but for what bending the axis of a thick specimen takes with it as it leaves the span, some millionths, and the way back is that of
// the way there (theory.md, "Rollers and thickness").
#pragma once

#include "fibre/supported_state.h"

namespace flexslip {

struct LooseState {
  SupportedState state;  // lengths and forces in the span of the straight fibre; slid past where the rollers stood then
  double span;           // [L] between the axes of the rollers
};

// Domain:     w in (0, deepest_on_supports]; radius > 0 and half depth as state_on_supports; std::invalid_argument otherwise.
// Max error:  1e-11, as state_on_supports.
// Fails:      as state_on_supports.
// Method:     span and friction of the state before, over and over: a contraction, for w <= 0.3 by five and more.
// Cost:       a dozen of states.
LooseState state_on_loose_rollers(double w, const Supports& supports);

}  // namespace flexslip
