// How a file became the record, step by step, in words.
#pragma once

#include <string>
#include <vector>

#include "case/measurement.h"

namespace flexslip {

struct PreparationRow {
  std::string name;       // "force zero"
  std::string done;       // a sentence without its full stop
  std::string value;      // with its uncertainty; empty if there is none
  std::string rows;       // "1 to 40"; empty for all
  std::string otherwise;  // the key or flag that has it otherwise; empty if nothing has
};

std::vector<PreparationRow> preparation_rows(const Preparation& preparation);

// A step as a sentence; all of them.
std::string step_in_words(const PreparationRow& row);
std::vector<std::string> preparation_in_words(const Preparation& preparation);

}  // namespace flexslip
