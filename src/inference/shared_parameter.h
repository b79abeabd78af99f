// One value of a parameter for several tests, each weighing as much as its own record says.
#pragma once

#include <optional>
#include <span>

#include "inference/fit.h"

namespace flexslip {

struct OwnEstimate {
  double value, error;  // unit of the parameter; standard error
};

// What a record alone says of a parameter, of which the fit was told `stated` beforehand; none if that is next to nothing: less
// than a tenth of the weight of what was stated. Normal distributions throughout.
// Domain:     errors > 0; std::invalid_argument otherwise.
std::optional<OwnEstimate> of_the_record(const OwnEstimate& fitted, const OwnEstimate& stated);

struct SharedEstimate {
  ParameterEstimate estimate;  // unit of the parameter
  double scatter;              // [1] of the tests about the shared value, over what their errors explain
};

// The mean weighted by the errors; its own error is taken larger by the scatter where that exceeds 1 (Birge's ratio). What was
// stated beforehand counts once, however many tests were told it.
// Domain:     at least two tests or one statement, errors > 0 and finite; std::invalid_argument otherwise.
SharedEstimate estimate_shared(std::span<const OwnEstimate> tests, const std::optional<OwnEstimate>& stated);

}  // namespace flexslip
