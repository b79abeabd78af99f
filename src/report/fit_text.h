// A fitted test as plain text: the short answer on a terminal.
#pragma once

#include <string>

#include "case/fitted.h"

namespace flexslip {

std::string fit_text(const FittedTest& test);

}  // namespace flexslip
