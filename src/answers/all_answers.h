// Every answer of every command, by what it holds, of which the page docs/results.md is made; and what `keys --json` tells of a key of case files.
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
  std::string_view what;     // in a few words
  bool is_table;             // CSV: of columns; else JSON, of keys
  std::vector<Description> entries;
};

std::vector<AnswerDescription> all_answers();

// A key or a column on a line.
struct ResultLine {
  std::string key;  // "drops[].row_before"; "categories.*.mu0.mean", where * stands for any name; the title of a column
  std::string_view shape;
  std::string_view unit, reduced_unit;  // of numbers and estimates
  std::string_view meaning;
};

// Groups and lists stand before what they hold.
std::vector<ResultLine> lines_of(const AnswerDescription& answer);
Fields<ResultLine> line_fields();

}  // namespace flexslip
