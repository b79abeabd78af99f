// What a planned test will show.
#pragma once

#include <string>
#include <vector>

#include "design/design_answer.h"
#include "report/document.h"

namespace flexslip {

// The answer in a sentence.
std::string design_in_short(const DesignAnswer& answer);

// What to change for it to be otherwise, one change each: "a load train of at least 438 N/m instead of 90.65 N/m".
std::vector<std::string> changes_in_words(const DesignAnswer& answer);

// The answer, what decides it, what becomes of the work, and the changes.
std::vector<Chapter> document_of(const DesignAnswer& answer);

}  // namespace flexslip
