// What the drops of a test and a reload tell about its specimen, all weighed together.
#pragma once

#include <vector>

#include "inference/analysis.h"
#include "inference/causes.h"
#include "numerics/elementary.h"

namespace flexslip {

// The mean friction told if a share of the stiffness was lost by the middle of the record: of what is only a limit, that limit.
struct FrictionIfLost {
  double loss, friction;  // [1]
};

// What became of the specimen.
enum class Conclusion {
  no_drops,          // the force falls nowhere as in a snap, and no stiffness was seen to be lost
  slips,             // it slipped; from one loading, stiffness may have been lost besides
  cracks,            // it lost stiffness; some of the drops may be slips
  slips_and_damage,  // it slipped and lost stiffness, by a reload
  settled,           // it or a support gave way for good, and no stiffness was lost, by a reload
  undecided,
};

struct Judgement {
  Conclusion conclusion = Conclusion::undecided;
  Causes causes{};              // of the drops that are judged; NaN of none
  bool tells_friction = false;  // there is a fit, and it allows for all that was lost
  bool friction_falls =
      false;  // along all that is seen, surely, by a third of its mean or more: as the force of a specimen that cracks would
  // For losses of a tenth and a fifth; none where a reload tells the loss, and where no friction is told.
  std::vector<FrictionIfLost> if_lost{};
};

// Of the loss of a reload, as -ln of what is left: besides its own error, passes of sound specimens differ by 2 %.
double log_loss_error(const PassesFit& passes);

// Was stiffness lost before the evaluated loading, and does none after it tell what it lost itself?
bool lost_before(const TestAnalysis& analysis);

// Does the force of a specimen that is hardly bent sink by a tenth, and not in drops? No elastic specimen does that.
bool sinks(const TestAnalysis& analysis);

// Does a loading after the evaluated one tell what was lost?
bool is_reloaded(const TestAnalysis& analysis);

// Does the friction told allow for all that was lost?
bool allows_for_losses(const TestAnalysis& analysis);

// Does the record tell how friction varies along the specimen? Not where it cannot be told from none, unless a wave is claimed.
inline bool tells_variation(const FrictionFit& fit) { return !fit.mu0_is_bound || fit.wave_claimed; }

// Is the loss beyond its errors, or, negative, the gain? It allows for passes that differ by 2 % for other reasons.
bool is_lost(const PassesFit& passes);
bool is_gained(const PassesFit& passes);
bool is_settled(const PassesFit& passes);

// Of a test of any status.
Judgement judge(const TestAnalysis& analysis);

}  // namespace flexslip
