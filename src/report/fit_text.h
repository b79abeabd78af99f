// A fitted test as plain text: the short answer on a terminal.
#pragma once

#include <string>

#include "cases/fitted_test.h"

namespace flexslip {

std::string fit_text(const FittedTest& test);

}  // namespace flexslip
