// What the stage is to do in the test that a case describes.
#pragma once

#include <vector>

#include "case/case_file.h"

namespace flexslip {

// How far it may move.
inline constexpr double nearest_reduced = 1e-6;  // [L] of the stage: what the loading curve can be traced for
inline constexpr double farthest_reduced = 100;  // [L] of the stage: a fibre is through its supports within a few spans

// What the stage is to do.
struct StageProgramme {
  std::vector<double> positions;  // [m] in steps: of every reading; else the turning points, exactly followed
  double farthest;                // [m] the greatest of them
  bool in_steps;
  bool measured;  // read from a file
};

// The programme of a case, its cycles and steps written out; a measured one is read from its file.
// Fails:      InputError if the case has none, or one that goes nowhere, farther than a specimen bends, behind the contact, or
//             back in time.
StageProgramme programme_of(const Case& input);

}  // namespace flexslip
