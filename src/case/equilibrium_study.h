// What is in equilibrium of the specimen of a case, whatever the rig: the curve of loading, or all of it.
#pragma once

#include <string>
#include <vector>

#include "bending_test/history.h"
#include "case/case_file.h"
#include "contact/friction.h"
#include "data/scales.h"
#include "fibre/fibre.h"

namespace flexslip {

struct EquilibriumChoice {
  bool region = false;  // all equilibria, not the curve of loading
  int points = 0;   // along the length, from 2 to most_equilibria; 0: as many as the friction needs, or 100 of a region
  int levels = 41;  // of the friction in a region, from 2 to most_levels
  std::string longest{};  // length between the supports up to which to compute, with its unit; empty: 1.5 spans
};

inline constexpr int most_equilibria = 1'000'000;
inline constexpr int most_levels = 10'000;

struct EquilibriumStudy {
  bool reduced, in_inches;  // as the case
  bool region;
  Scales scales;
  Fibre fibre;
  Friction friction;
  double longest;  // [L]
  EquilibriumStatus status;
  std::vector<EquilibriumPoint> points;
};

// Domain:     counts as above.
// Fails:      InputError for a case without span, bending stiffness or friction, as scales_of and friction_of; for `longest`, naming the flag, unless
//             it is a length beyond the span.
EquilibriumStudy study_equilibria(const Case& input, const EquilibriumChoice& choice);

// As a picture shows them.
EquilibriumPortrait portrait_of(const EquilibriumStudy& study);

}  // namespace flexslip
