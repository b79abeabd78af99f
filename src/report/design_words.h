// What a planned test will show, in words.
#pragma once

#include <string>
#include <vector>

#include "design/design_answer.h"

namespace flexslip {

// The answer in a sentence.
std::string design_in_short(const DesignAnswer& answer);

// Paragraphs: what it shows, what decides it, what becomes of the work.
std::vector<std::string> design_in_words(const DesignAnswer& answer);

// What to change for it to be otherwise, one change each: "a load train of at least 438 N/m instead of 90.65 N/m".
std::vector<std::string> changes_in_words(const DesignAnswer& answer);

// All of it, laid out for a terminal.
std::string design_text(const DesignAnswer& answer);

}  // namespace flexslip
