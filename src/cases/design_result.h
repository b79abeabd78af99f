// What came of a design of a case, and how it is written: the same names in CSV, JSON and HDF5.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "cases/design_case.h"
#include "io/hdf5.h"

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

// One number of an outcome.
struct OutcomeColumn {
  std::string_view name;
  Kind kind;  // of the quantity; a plain number in reduced cases
  StoredAs stored_as;
  std::string_view description;
  double (*value)(const DesignOutcome& outcome,
                  const DesignUnits& units);  // [units of the case] NaN where there is none
};
std::span<const OutcomeColumn> outcome_columns();

// The unit of numbers in files: "N"; "EI/L^2" in a reduced case; "1" of a plain number.
// Domain:     a kind of a parameter or an outcome of a design; std::invalid_argument otherwise.
std::string_view unit_of(const Kind& kind, bool reduced);

}  // namespace flexslip
