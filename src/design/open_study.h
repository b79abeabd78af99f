// The outcomes of a planned test over all that is not known before it: the phase of the waves of
// friction, and the numbers of friction that its case does not state.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "design/planned_case.h"

namespace flexslip {

// The smallest and the largest force of all designs at a stage position.
struct ForceRange {
  double stage;      // [L]
  double low, high;  // [EI/L^2]
};

struct OpenStudy {
  std::vector<OpenNumber> open;  // as given
  std::size_t phases;            // tried of each combination; 1 if the phase has no effect
  std::size_t designs;           // that can be computed
  std::size_t snapping;          // number of these in which the specimen snaps
  // [1] largest snap of a design, as a share of its maximum force: minimum and maximum over the
  // designs; 0 for a design without a snap
  double min_snap, max_snap;
  double min_force, max_force;    // [EI/L^2] of the maximum forces
  std::vector<ForceRange> force;  // along the travel, as far as a design gets
};

// Empty if nothing is open and the case has no phase.
// Method:     three values of each open number, ends and middle, with eight phases; 24 phases if
//             nothing else is open. The band lies between the designs tried and is not smoothed.
// Cost:       one outcome and one record for each design, at most 216.
std::optional<OpenStudy> open_study(const Test& loading, const std::vector<OpenNumber>& open, unsigned threads);

}  // namespace flexslip
