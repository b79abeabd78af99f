// What a test comes to when all is weighed: what stands against its answer, the weightiest first, and what to do next.
#pragma once

#include <string_view>
#include <vector>

#include "inference/analysis.h"
#include "inference/cyclic_answer.h"
#include "numerics/elementary.h"

namespace flexslip {

// How far an answer is one, by the weightiest of what is found against it (finding/finding.h).
enum class Standing {
  sound,        // nothing
  conditional,  // that it holds under conditions which one loading, or what was stated, leaves open
  doubtful,     // what may not matter
  suspect,      // what the conclusion does not survive
  untrusted,    // there is no answer, or none to use
};

std::string_view name_of(Standing standing);

// Is the answer one?
constexpr bool is_trusted(Standing standing) { return standing != Standing::untrusted; }

// The mean friction told if a share of the stiffness was lost by the middle of the record: of what is only a limit, that limit.
struct FrictionIfLost {
  double loss, friction;  // [1]
};

// How the stiffness of a specimen changed from one loading to another.
enum class StiffnessChange {
  none,             // by less than its error or than a twentieth; or no two loadings can be compared
  softer,           // by more than relevant_loss, surely: it lost stiffness
  slightly_softer,  // by more than its error, and by a twentieth, as friction that runs in makes it, too
  stiffer,          // likewise
};

// What a comparable loading says of the stiffness: of the last one after a loading against that; where there is none, of that loading against the first.
struct ReloadChange {
  double loss = not_a_number, loss_error = not_a_number;  // [1] of stiffness; NaN where no two can be compared
  bool comes_after = false;                               // what the loading itself lost is in it
  StiffnessChange change = StiffnessChange::none;
};

// What the drops and a reload say of the specimen, all weighed together.
struct Judgement {
  CrackVerdict drops;  // by the rises, and by the reload where there is one
  double cracks_alone =
      not_a_number;               // [1] probability that they alone made the drops, likewise; NaN where nothing tells
  bool drops_are_cracks = false;  // there are some, and they are
  std::size_t impossible = 0;     // drops that cannot be slips
  ReloadChange reload{};
  double loss_needed =
      not_a_number;  // [1] of stiffness, by cracks alone to make the drops; NaN where no loading comes after that analysed
  bool friction_falls =
      false;  // along all that is seen, surely, by a third of its mean or more: as the force of a specimen that cracks would
  bool few_rows = false;  // most rises between drops have fewer than five
  double jumped = 0;      // [1] of the length seen, that passed in slips
  // [EI/L^3] of a rig on which the mean of the fit does not snap, where more than half of the length seen passed in slips; NaN otherwise
  double stiffness_for_all = not_a_number;
  // For losses of a tenth and a fifth, or for what the reload leaves open; none of a specimen that lost stiffness.
  std::vector<FrictionIfLost> if_lost{};
};

// evaluated: which of the loadings, counted from 0.
ReloadChange reload_change(const std::vector<LoadingStiffness>& loadings, std::size_t evaluated);

// Does it show that so much stiffness was lost that no friction can be read off?
bool lost_stiffness(const ReloadChange& reload);

// Does the record contradict the bending stiffness stated, which the verdict on the rises takes for granted (checks.h, stiffness_errors)? A load train
// stated too stiff makes it do that.
bool stiffness_is_off(const TestAnalysis& analysis);

// Of three drops or more half or more that cannot be slips: the load train is not as stated, before anything else.
bool most_are_impossible(std::size_t impossible, std::size_t drops);

// Does a reload, or do the rises between the drops, show that the specimen lost stiffness on the way? No friction can then be read off.
bool lost_stiffness(const Judgement& judgement);

// A reload that is softer says cracks. One that lost less than cracks alone would need to make the drops makes these less probable; where the rises
// tell nothing, by more than its error at 95 %, it says that they were not cracks alone. Where half of three drops or more cannot be slips, or the
// bending stiffness is off (stiffness_is_off), there is no probability, unless it is one of cracks. Drops are not asked about where there are none.
// Domain:     analysis.status is ok; std::invalid_argument otherwise. cycles null: it was loaded once. evaluated: which of their loadings, counted from 0,
//             was analysed; what it lost is seen by those after it.
Judgement judge(const TestAnalysis& analysis, const CyclicAnswer* cycles, std::size_t evaluated = 0);

}  // namespace flexslip
