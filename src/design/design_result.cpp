#include "design/design_result.h"

#include <stdexcept>

namespace flexslip {
namespace {

ResultStatus status_of(DesignFault fault) {
  return fault == DesignFault::impossible ? ResultStatus::impossible : ResultStatus::not_computable;
}

}  // namespace

std::string_view word_of(ResultStatus status) { return result_status_words.at(static_cast<std::size_t>(status)); }

ResultStatus status_of(const DesignOutcome& outcome) {
  switch (outcome.status) {
    case DesignStatus::ok:
      return ResultStatus::ok;
    case DesignStatus::breaks:
      return ResultStatus::breaks;
    case DesignStatus::slipped_through:
      return ResultStatus::slipped_through;
  }
  throw std::invalid_argument("no such status");
}

DesignResult result_of(const DesignCase& input) try {
  const auto plan = input.plan();
  if (const auto* refused = std::get_if<DesignRefusal>(&plan)) return {status_of(refused->fault), {}, {}};
  const auto& [design, units] = std::get<PlannedDesign>(plan);
  const DesignOutcome outcome = outcome_of(design);
  return {status_of(outcome), units, outcome};
} catch (const std::invalid_argument&) {
  return {ResultStatus::not_computable, {}, {}};
}

}  // namespace flexslip
