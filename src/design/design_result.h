// What came of a design of a case.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "design/design_case.h"

namespace flexslip {

enum class ResultStatus {
  ok,
  slipped_through,  // the outcomes are those up to there
  impossible,       // as DesignFault, and without outcomes
  not_computable,   // likewise
  breaks,           // the outcomes are those up to there
};
inline constexpr std::array<std::string_view, 5> result_status_words{"ok", "slipped_through", "impossible",
                                                                     "not_computable", "breaks"};
std::string_view word_of(ResultStatus status);
ResultStatus status_of(const DesignOutcome& outcome);

struct DesignResult {
  ResultStatus status;
  std::optional<DesignUnits> units;  // both, or none
  std::optional<DesignOutcome> outcome;
};

// What a number is too extreme for is not computable, whatever part of the computation finds out.
DesignResult result_of(const DesignCase& input);

}  // namespace flexslip
