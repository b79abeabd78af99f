// The sensitivity of friction and of its share of the work to each input: each quantity that the
// case states or the program assumes, its uncertainty, and its effect.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

struct Sensitivity {
  std::string_view quantity, title;  // "load_train", "load train"
  std::string stated;                // "90.65 N/m"; "edges"
  std::string step;                  // "1 %", one standard deviation
  std::string may_be_off;            // the step and its source: "1 %, assumed"
  bool is_supposed;                  // the case states none; the effect of some is shown
  double friction;                   // [1] or [1/m] derivative of friction in the quantity
  double friction_moves,
      work_moves;  // [1] change of friction and of its share of the work per step; NaN without a share
};

// The sensitivities to all uncertain inputs, the largest effect on friction first. The last are a
// support radius and a thickness of unstated_length, if the case states none.
// Domain:     any test. Empty without a fit, and if the fit has no sensitivities.
std::vector<Sensitivity> sensitivities_of(const FittedTest& test);

// "load train +1 %: friction +0.02; EI +3 %: −0.01": the effects of 0.005 or more; and the largest
// effect on the share of the work, if asked for.
// Domain:     the fit has sensitivities.
std::string sensitivities_in_words(const FittedTest& test, bool has_work);

// The default errors of quantities that a case can state with an error and does not.
std::vector<FindingNumber> assumed_errors(const FittedTest& test);

// [L] The support radius and thickness whose effect is shown if the case states none.
inline constexpr double unstated_length = 0.001;

// "+0.04", "−0.04".
std::string signed_number(double value);

}  // namespace flexslip
