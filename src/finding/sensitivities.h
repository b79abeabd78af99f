// What an answer hangs on: each quantity that is stated or taken as something, by how much it may be off, and what that does to friction and to its
// share of the work.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

struct Sensitivity {
  std::string_view quantity, title;   // "load_train", "load train"
  std::string stated;                 // "90.65 N/m"; "edges, not stated"
  std::string step;                   // "1 %"
  std::string may_be_off;             // that, "1 %, assumed"
  bool is_supposed;                   // it is taken for none, and told for some
  double friction;                    // [1], or [1/m]: by how much it would be larger, were the quantity stated larger
  double friction_moves, work_moves;  // [1] friction and its share of the work, for as much more; no work of a limit
};

// Those that may be off, what moves friction most first; and last, for a thousandth of the span, a radius of the supports and a thickness that are
// taken for none.
// Domain:     any test; empty where the fit tells no sensitivities.
std::vector<Sensitivity> sensitivities_of(const FittedTest& test);

// One line: friction for as much more of each as it may be off; and what moves the share of the work most, if that is told.
// Domain:     the fit tells sensitivities.
std::string sensitivities_in_words(const FittedTest& test, bool tells_work);

// Of quantities that a case can state with an error and does not.
std::vector<FindingNumber> assumed_errors(const FittedTest& test);

// Of lengths that are taken for none, what is told all the same.
inline constexpr double unstated_length = 0.001;  // [L]

// "+0.04", "−0.04".
std::string signed_number(double value);

}  // namespace flexslip
