// What made the drops of a loading: slips, cracks, or both.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "inference/drop_features.h"
#include "numerics/elementary.h"

namespace flexslip {

// [1] Probabilities of the causes of the drops. They are equally likely beforehand. NaN: nothing is known.
struct Causes {
  double slips = not_a_number, cracks = not_a_number, both = not_a_number;
};

// What the probabilities depend on, each between -1 and 1 or so.
inline constexpr std::array cause_input_names{"one",      "follows",    "follows_sure", "steepest",   "back_near",
                                              "back_far", "above_zero", "below_zero",   "given_sure", "rough",
                                              "sure",     "drawn_in",   "stiff"};
using CauseInputs = std::array<double, cause_input_names.size()>;

// Domain:     features with drops; load_train [EI/L^3] > 0, may be infinite.
CauseInputs inputs_of(const DropFeatures& features, double load_train);

// By one loading. `cracks`, and `slips` below .5, are reliable: they say whether the specimen slipped at all, and whether it lost stiffness at all. One
// loading cannot distinguish slips only from slips and cracks.
// Domain:     as inputs_of.
// Method:     multinomial logistic regression on simulated records (tools/calibrate-verdict; docs/slip-or-crack.md).
Causes causes_of(const DropFeatures& features, double load_train);

// What a reload shows of the loading before it.
struct Reload {
  double log_loss, error;  // of the stiffness, as -ln of what is left
  double log_needed;       // likewise by the drops, if they were cracks only
  bool drops_again;        // does any drop come again? Cracks are made once.
};

// By one loading and a reload.
// Domain:     error >= 0, log_needed > 0; by_one_loading may be NaN.
// Method:     likewise.
Causes causes_of(const Causes& by_one_loading, const Reload& reload);

// Did the specimen surely slip: is cracks only below 5 %? Did it surely lose stiffness: is slips only below 5 %, or below 3 % by one loading?
bool slips_at_all(const Causes& causes);
bool loses_at_all(const Causes& causes, bool is_reloaded);

// Is a loss, as -ln of what is left, more than three times its error?
bool is_loss(double log_loss, double error);

// [1] How often a reload finds the true cause of drops: that nothing was lost if they were slips only, and the loss that they need if they were
// cracks only.
struct CauseChances {
  double slips, cracks;

  double least() const { return std::min(slips, cracks); }
};

// Domain:     as causes_of. Of cracks, one loading is assumed to show nothing.
// Max error:  0.002.
// Method:     the measured loss is normally distributed, and the loss that the drops need is uncertain besides.
CauseChances chances_of_causes(double log_needed, double error, const Causes& slips_by_one_loading,
                               bool slips_come_again);

}  // namespace flexslip
