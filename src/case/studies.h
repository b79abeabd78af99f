// What is asked of a test besides a fit and a simulation: all its equilibria, the friction read off its record, the numbers of the bending standards.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bending_test/history.h"
#include "case/case_file.h"
#include "case/measurement.h"
#include "case/mechanics.h"
#include "case/standards.h"
#include "contact/friction.h"
#include "data/scales.h"
#include "fibre/fibre.h"
#include "fibre/supported_state.h"
#include "inference/profile.h"

namespace flexslip {

struct EquilibriumChoice {
  bool region = false;  // all equilibria, not the curve of loading
  int points = 0;   // along the length, from 2 to max_equilibria; 0: as many as the friction needs, or 100 of a region
  int levels = 41;  // of the friction in a region, from 2 to max_levels
  std::string longest{};  // length between the supports up to which to compute, with its unit; empty: 1.5 spans
};

inline constexpr int max_equilibria = 1'000'000;
inline constexpr int max_levels = 10'000;

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
EquilibriumStudy study_equilibria(const Test& input, const EquilibriumChoice& choice);

// As a picture shows them.
EquilibriumPortrait portrait_of(const EquilibriumStudy& study);

struct InvertedTest {
  Measurement measurement;
  BendingStiffnessUsed stiffness;
  Scales scales;
  FrictionProfile profile;
  std::vector<std::string> remarks;  // sentences: what was assumed, and left out
  std::string why_no_answer;         // "" if a reading tells a friction
};

// Supports other than those of the case; none: those of the case.
using OtherSupports = std::function<std::optional<Supports>(const Test& completed, const Scales& scales)>;

// Fails:      InputError as read_measurement, bending_stiffness_of, scales_of and rig_of.
InvertedTest invert_test(const Test& asked, const OtherSupports& other = {});

struct ModulusStudy {
  Measurement measurement;
  BeamGeometry geometry;
  SmallDeflection numbers;
  SupportsGain supports;
};

// The straight part as two words say it, "0.1" and "30 %"; none of none.
// Domain:     no words, or two.
// Fails:      InputError that names the flag --window, unless they are rising shares from 0 to 1.
std::optional<ForceWindow> window_of(const std::vector<std::string>& words);

// Fails:      InputError as read_measurement, and for a record of fewer points than tell the noise.
ModulusStudy study_modulus(const Test& input, const std::optional<ForceWindow>& window,
                           const std::optional<ShareRange>& friction);

}  // namespace flexslip
