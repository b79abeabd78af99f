// The fields of every answer of every command, from which docs/results.md is generated, and the
// fields of `keys --json`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/case_keys.h"
#include "result/fields.h"

namespace flexslip {

Fields<CaseKey> key_fields();

struct AnswerDescription {
  std::string_view command;  // "fit --json"
  std::string_view what;     // a short phrase
  bool is_table;             // CSV with columns; otherwise JSON with keys
  std::vector<Description> entries;
};

std::vector<AnswerDescription> all_answers();

// One key or column in the list of `flexslip results`.
struct ResultLine {
  // "drops[].row_before"; "categories.*.mu0.mean", where * is any name; or a column title
  std::string key;
  std::string_view shape;
  std::string_view unit, reduced_unit;  // of numbers and estimates
  std::string_view meaning;
};

// A group or list precedes its entries.
std::vector<ResultLine> lines_of(const AnswerDescription& answer);
Fields<ResultLine> line_fields();

}  // namespace flexslip
