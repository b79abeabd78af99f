// The probabilities of the causes of the drops of a loading: slips only, cracks only, or both.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "inference/drop_features.h"
#include "numerics/elementary.h"

namespace flexslip {

// [1] Probabilities of the causes, for equal prior probabilities. NaN if unknown.
struct Causes {
  double slips = not_a_number, cracks = not_a_number, both = not_a_number;
};

// The inputs of the probabilities, each roughly between -1 and 1.
inline constexpr std::array cause_input_names{"one",      "follows",    "follows_sure", "steepest",   "back_near",
                                              "back_far", "above_zero", "below_zero",   "given_sure", "rough",
                                              "sure",     "drawn_in",   "stiff"};
using CauseInputs = std::array<double, cause_input_names.size()>;

// Domain:     features with drops; load_train [EI/L^3] > 0, may be infinite.
CauseInputs inputs_of(const DropFeatures& features, double load_train);

// The probabilities from one loading. `cracks`, and `slips` below 0.5, are reliable; one loading
// cannot distinguish slips only from slips and cracks.
// Domain:     as inputs_of.
// Method:     multinomial logistic regression on simulated records (tools/calibrate-verdict;
//             docs/slip-or-crack.md).
Causes causes_of(const DropFeatures& features, double load_train);

// The result of a reload for the loading before it.
struct Reload {
  double log_loss, error;  // -ln of the remaining stiffness, and its standard deviation
  double log_needed;       // the same loss if the drops are cracks only
  bool drops_again;        // a drop repeats, which a crack cannot
};

// The probabilities from one loading and a reload.
// Domain:     error >= 0, log_needed > 0; by_one_loading may be NaN.
// Method:     as above.
Causes causes_of(const Causes& by_one_loading, const Reload& reload);

// True if the specimen certainly slipped (cracks only below 5 %), or certainly lost stiffness
// (slips only below 5 % with a reload, below 3 % without).
bool slips_at_all(const Causes& causes);
bool loses_at_all(const Causes& causes, bool is_reloaded);

// True if a loss, as -ln of the remaining stiffness, exceeds three times its error.
bool is_loss(double log_loss, double error);

// [1] The probability that a reload leads to the right verdict if the drops are slips only, or
// cracks only.
struct CauseChances {
  double slips, cracks;

  double least() const { return std::min(slips, cracks); }
};

// Domain:     as causes_of. For cracks, one loading is assumed uninformative.
// Max error:  0.002.
// Method:     the measured loss is normal, and the loss that the drops require is uncertain.
CauseChances chances_of_causes(double log_needed, double error, const Causes& slips_by_one_loading,
                               bool slips_come_again);

}  // namespace flexslip
