// The fibre and the rig of the paper's Fig. 8: μ = 0.6 (1 + 0.4 cos(S/0.02)), k = 30.
#pragma once

#include <numbers>

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

inline Friction friction_of_fig_8() { return Friction::sinusoid(0.6, 0.4, 0.02 * std::numbers::pi, 0); }
inline const Rig rig_of_fig_8{30};

}  // namespace flexslip
