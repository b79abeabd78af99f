// Friction read off the record of a case, point by point, at the bending stiffness stated: no fit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"
#include "case/measurement.h"
#include "case/stiffness_used.h"
#include "data/scales.h"
#include "fibre/supported_state.h"
#include "inference/profile.h"

namespace flexslip {

struct InvertedTest {
  Measurement measurement;
  BendingStiffnessUsed stiffness;
  Scales scales;
  FrictionProfile profile;
  std::vector<std::string> remarks;  // sentences: what was assumed, and left out
  std::string why_no_answer;         // "" if a reading tells a friction
};

// Supports other than those of the case; none: those of the case.
using OtherSupports = std::function<std::optional<Supports>(const Case& completed, const Scales& scales)>;

// Fails:      InputError as read_measurement, bending_stiffness_of, scales_of and rig_of.
InvertedTest invert_test(const Case& asked, const OtherSupports& other = {});

}  // namespace flexslip
