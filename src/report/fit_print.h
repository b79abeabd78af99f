// What a fitted test says, in tables for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/printed.h"

namespace flexslip {

struct ParameterRow {
  std::string name;    // as in JSON
  std::string symbol;  // "λ"; empty for the second wave
  std::string meaning;
  std::string value;     // with its standard error, digits to match
  std::string interval;  // of 95 %
  std::string remark;    // why the error is not to be trusted, or what the value depends on; mostly empty
};

// Where the bending stiffness comes from that the fit begins with: "stated", "of the loops", …
std::string_view stiffness_beforehand(const FittedTest& test);

// Domain of all below: analysis.status is ok.
std::vector<ParameterRow> parameter_rows(const FittedTest& test);

inline constexpr std::size_t listed_explanations = 8;
PrintedTable explanation_table(const FittedTest& test);  // what the answer averages over, likeliest first
PrintedTable drop_table(const FittedTest& test);         // the drops measured, as slips
PrintedTable snap_table(const FittedTest& test);         // the snaps of the mean run forward
PrintedTable energy_table(const FittedTest& test);

}  // namespace flexslip
