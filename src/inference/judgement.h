// What a test comes to when all is weighed: what stands against its answer, the weightiest first, and what to do next.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "inference/analysis.h"
#include "inference/cyclic_answer.h"

namespace flexslip {

// In the order of their weight.
enum class Doubt {
  wrong_stiffness,       // the bending stiffness stated is not that of the record's initial slope
  no_sliding,            // no sliding with friction gives the record
  softer_reload,         // a reload shows a loss of stiffness of a tenth or more
  cracks,                // the rises between the drops are those of a specimen that cracks
  impossible_drops,      // drops that no slip explains
  implausible_friction,  // more friction than is plausible
  failed_check,          // the fit fails a check, other than those of friction and stiffness
  falling_friction,      // friction falls away along the record, as the force of a specimen that cracks would
  changed_reload,   // a reload is softer or stiffer than the first loading by more than its error, and by a twentieth
  coarse_force,     // a drop of less than a twentieth of the greatest force could not be seen
  undecided_drops,  // whether drops are slips or cracks cannot be told
  few_rows,         // most rises between drops have fewer than five rows
  below_frictionless,    // the force lies below that without friction, beyond what errors feign
  settling_contact,      // the curve bends where it begins, and the contact may lie elsewhere than it is taken to
  unexpected_stiffness,  // the bending stiffness of the fit is not that stated, by twice its error
};

std::string_view name_of(Doubt doubt);

enum class Standing {
  sound,     // no doubt
  doubtful,  // doubts that may not matter
  suspect,  // a doubt that the conclusion does not survive: a softer reload, cracks, friction or half the drops impossible
  untrusted,  // a wrong stiffness, or no sliding: the answer is none
};

std::string_view name_of(Standing standing);

// Is the answer one?
constexpr bool is_trusted(Standing standing) { return standing != Standing::untrusted; }

// What would tell most.
enum class NextStep {
  none,
  check_case,   // columns, units, section
  reload,       // unload and load once more
  finer_steps,  // fewer than five rows on most rises
  stiffer_rig,  // the fibre jumps over more than half of what it passes
  image_length,
  state_radius,       // of the supports, which are taken for edges
  find_contact,       // the curve bends where it begins
  finer_force,        // small drops could not be seen
  measure_stiffness,  // the bending stiffness of the fit is not that stated, or the force lies below that without friction
  see_checks,         // a check that failed says what to do
};

std::string_view name_of(NextStep step);

struct Judgement {
  Standing standing = Standing::sound;
  CrackVerdict drops;  // by the rises, and by the reload where there is one
  std::vector<Doubt> doubts{};
  NextStep next = NextStep::none;
  double loss = NAN, loss_error = NAN;  // [1] of stiffness, that the last comparable reload shows; NaN without
  double loss_needed = NAN;             // [1] of stiffness, by cracks alone to make the drops; NaN without a reload
  // [EI/L^3] of a rig on which the mean of the fit does not snap; NaN unless next is stiffer_rig
  double stiffness_for_all = NAN;
};

// Does a reload, or do the rises between the drops, show that the specimen lost stiffness on the way? No friction can then be read off.
bool lost_stiffness(const Judgement& judgement);

// A reload that is softer says cracks; one that lost less, at 95 %, than cracks would need to make the drops says that these were not cracks
// alone. Drops are not asked about where there are none.
// Domain:     analysis.status is ok; std::invalid_argument otherwise. cycles null: it was loaded once.
Judgement judge(const TestAnalysis& analysis, const CyclicAnswer* cycles);

}  // namespace flexslip
