// A fitted test as plain text: the short answer on a terminal.
#pragma once

#include <string>

#include "io/fitted_test.h"

namespace flexslip {

std::string fit_text(const FittedTest& test);

}  // namespace flexslip
