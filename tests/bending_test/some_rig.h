// A rig of any stiffness, and the stage position of a sliding fibre, by the elastica alone.
#pragma once

#include <cmath>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/elastica.h"
#include "tests/generators.h"

namespace flexslip {

inline Rig any_rig() { return {std::pow(10, *between(0.7, 3))}; }

inline double stage_at(const Friction& friction, const Rig& rig, double S) {
  const auto state = fibre_state(S, friction.at(S).mu);
  return state.w + state.F / rig.stiffness;
}

}  // namespace flexslip
