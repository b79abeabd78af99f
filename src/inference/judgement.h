// What a test comes to when all is weighed: what stands against its answer, the weightiest first, and what to do next.
#pragma once

#include <string_view>

#include "inference/analysis.h"
#include "inference/cyclic_answer.h"

namespace flexslip {

// How far an answer is one, by the weightiest of what is found against it (finding/finding.h).
enum class Standing {
  sound,      // nothing
  doubtful,   // what may not matter
  suspect,    // what the conclusion does not survive
  untrusted,  // there is no answer, or none to use
};

std::string_view name_of(Standing standing);

// Is the answer one?
constexpr bool is_trusted(Standing standing) { return standing != Standing::untrusted; }

// What the drops and a reload say of the specimen, all weighed together.
struct Judgement {
  CrackVerdict drops;                   // by the rises, and by the reload where there is one
  bool drops_are_cracks = false;        // there are some, and they are
  std::size_t impossible = 0;           // drops that cannot be slips
  bool softer_reload = false;           // the last comparable one has lost stiffness
  bool changed_reload = false;          // it is softer or stiffer by more than its error, and by a twentieth
  double loss = NAN, loss_error = NAN;  // [1] of stiffness, that it shows; NaN without
  double loss_needed = NAN;             // [1] of stiffness, by cracks alone to make the drops; NaN without a reload
  bool friction_falls =
      false;  // along all that is seen, surely, by a third of its mean or more: as the force of a specimen that cracks would
  bool few_rows = false;  // most rises between drops have fewer than five
  double jumped = 0;      // [1] of the length seen, that passed in slips
  // [EI/L^3] of a rig on which the mean of the fit does not snap, where more than half of the length seen passed in slips; NaN otherwise
  double stiffness_for_all = NAN;
};

// Does a reload, or do the rises between the drops, show that the specimen lost stiffness on the way? No friction can then be read off.
bool lost_stiffness(const Judgement& judgement);

// A reload that is softer says cracks; one that lost less, at 95 %, than cracks would need to make the drops says that these were not cracks
// alone. Drops are not asked about where there are none.
// Domain:     analysis.status is ok; std::invalid_argument otherwise. cycles null: it was loaded once.
Judgement judge(const TestAnalysis& analysis, const CyclicAnswer* cycles);

}  // namespace flexslip
