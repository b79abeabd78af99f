// Studies of a test other than fit and simulation: equilibria, pointwise friction, results of the
// bending standards.
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
  bool region = false;  // true for all equilibria, false for the loading curve
  int points = 0;       // along the length, 2 to max_equilibria; 0: as many as the friction needs, or 100 for a region
  int levels = 41;      // of friction in a region, 2 to max_levels
  std::string longest{};  // maximum arc length between the supports, with unit; empty: 1.5 spans
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
// Fails:      InputError for a case without span, bending stiffness or friction, as scales_of and
//             friction_of; for `longest`, naming the flag, unless it is a length beyond the span.
EquilibriumStudy study_equilibria(const Test& input, const EquilibriumChoice& choice);

// The equilibria for figures.
EquilibriumPortrait portrait_of(const EquilibriumStudy& study);

struct InvertedTest {
  Measurement measurement;
  BendingStiffnessUsed stiffness;
  Scales scales;
  FrictionProfile profile;
  std::vector<std::string> remarks;  // assumptions and omissions, sentences
  std::string why_no_answer;         // "" if a reading determines friction
};

// Supports that replace those in the case; empty: the supports of the case.
using OtherSupports = std::function<std::optional<Supports>(const Test& completed, const Scales& scales)>;

// Fails:      InputError as read_measurement, bending_stiffness_of, scales_of and rig_of.
InvertedTest invert_test(const Test& asked, const OtherSupports& other = {});

struct ModulusStudy {
  Measurement measurement;
  BeamGeometry geometry;
  SmallDeflection numbers;
  SupportsGain supports;
};

// The linear region from two words, "0.1" and "30 %"; empty without words.
// Domain:     no words, or two.
// Fails:      InputError for --window, unless they are increasing shares from 0 to 1.
std::optional<ForceWindow> window_of(const std::vector<std::string>& words);

// Fails:      InputError as read_measurement; for a record with too few points to determine its
//             noise.
ModulusStudy study_modulus(const Test& input, const std::optional<ForceWindow>& window,
                           const std::optional<ShareRange>& friction);

}  // namespace flexslip
