// What the drops of a test and a reload say of its specimen, all weighed together.
#pragma once

#include <vector>

#include "data/loading_stiffness.h"
#include "inference/analysis.h"
#include "numerics/elementary.h"

namespace flexslip {

// The mean friction told if a share of the stiffness was lost by the middle of the record: of what is only a limit, that limit.
struct FrictionIfLost {
  double loss, friction;  // [1]
};

struct Judgement {
  CrackVerdict drops;  // by the rises, and by the reload where there is one
  double cracks_alone =
      not_a_number;               // [1] probability that they alone made the drops, likewise; NaN where nothing tells
  bool drops_are_cracks = false;  // there are some, and they are
  bool lost_stiffness = false;    // a reload, or the rises between the drops, show it: no friction can be read off
  std::size_t impossible = 0;     // drops that cannot be slips
  double loss_needed =
      not_a_number;  // [1] of stiffness, by cracks alone to make the drops; NaN where no loading comes after that analysed
  bool friction_falls =
      false;  // along all that is seen, surely, by a third of its mean or more: as the force of a specimen that cracks would
  // For losses of a tenth and a fifth, or for what the reload leaves open; none of a specimen that lost stiffness.
  std::vector<FrictionIfLost> if_lost{};
};

// Does the record contradict the bending stiffness stated, which the verdict on the rises takes for granted (checks.h, stiffness_errors)? A load train
// stated too stiff makes it do that.
bool stiffness_is_off(const TestAnalysis& analysis);

// Of three drops or more half or more that cannot be slips: the load train is not as stated, before anything else.
bool most_are_impossible(std::size_t impossible, std::size_t drops);

// A reload that is softer says cracks. One that lost less than cracks alone would need to make the drops makes these less probable; where the rises
// tell nothing, by more than its error at 95 %, it says that they were not cracks alone. Where half of three drops or more cannot be slips, or the
// bending stiffness is off (stiffness_is_off), there is no probability, unless it is one of cracks. Drops are not asked about where there are none.
// Domain:     analysis.status is ok; std::invalid_argument otherwise. reload: of the loading that was analysed.
Judgement judge(const TestAnalysis& analysis, const ReloadChange& reload = {});

}  // namespace flexslip
