// Is a specimen as stiff when loaded again as it was at first? The initial slopes of several loadings, and their ratios.
//
// A loss of stiffness means damage; friction on the supports, which makes the loops of a load-unload-reload test, leaves the initial
// slope alone, for it acts through a tangential force that is small there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/record.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {

// The rows [first, last) of one loading, from its beginning to its turning point.
struct LoadingRange {
  std::size_t first, last;
};

// The window of force, the same one [N] for all loadings: what lies below may still be settling, what lies above is bent.
// [least of the greatest forces of loadings that get far enough]
inline constexpr double loading_window_from = 0.05, loading_window_up_to = 0.30;
inline constexpr double relevant_loss = 0.10;       // [1] a loss of stiffness smaller than this is of no relevance
inline constexpr double loading_confidence = 0.95;  // [1] of each verdict, one-sided

enum class DamageVerdict {
  damaged,      // that the loss is at most the relevant one is rejected
  not_damaged,  // that the loss is at least the relevant one is rejected
  undecided,    // neither
};

enum class LoadingStatus {
  ok,
  loaded_too_little,   // not to a third of the greatest force of the first loading
  window_not_covered,  // it begins above the window's lower end, was not unloaded far enough, or never leaves it
  too_few_points,      // fewer than 6 in the window, or 3 in one of its halves
  not_rising,          // the force does not rise in the window, or in one of its halves
  still_drawn_in,  // steeper than at first, and at the same force more than twice as far bent, deflections counting from the
                   // contact: a specimen that friction holds drawn in
  no_reference,  // the first loading has no slope
};

struct LoadingStiffness {
  LoadingStatus status;     // nothing else is valid unless ok
  std::size_t first, last;  // rows [first, last) in the window
  Estimate slope;           // [N/m] dF/dw0, its error from scatter
  // [1] To the slope of the first loading, its error from scatter; for that itself 1, with errors 0 and not_damaged.
  Estimate ratio;
  double ratio_systematic;  // [1] half the difference of the ratios in the lower and in the upper half of the window
  DamageVerdict verdict;
};

// Domain:  a record whose columns are finite and of one length; ranges within it, in time order, not overlapping; std::invalid_argument
//          otherwise.
// Max error: wrong verdicts are no more frequent than 1 - loading_confidence, and ratio +- 1.96 standard errors covers 95 %, less 3 %, for noise of the
//          force that is white or AR(1) up to 0.5, and 30 rows or more in the window (tests/data/loading_stiffness_test.cpp).
// Method:  the window is one of force, not of deflection: the force tells where on its curve a specimen is, whatever the offset of the
//          contact, and a bend of the curve cancels in the ratio. Force and deflection are regressed on the stage, which is imposed and
//          free of their noise; errors allow for AR(1). That they know nothing of contacts that settle differently is what the
//          systematic error is for: real ratios depend on the window by more than the scatter (docs/validation.md).
std::vector<LoadingStiffness> compare_loadings(const Record& record, std::span<const LoadingRange> loadings);

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

// evaluated: which of the loadings, counted from 0.
ReloadChange reload_change(const std::vector<LoadingStiffness>& loadings, std::size_t evaluated);

// Does it show that so much stiffness was lost that no friction can be read off?
bool lost_stiffness(const ReloadChange& reload);

}  // namespace flexslip
