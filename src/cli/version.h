// The version of the program, and the commit that it was built from.
#pragma once

#include <string>

namespace flexslip {

// "flexslip 1.0.0 (45446f9f of 2026-11-30)"; without the commit if the sources were not a clone.
std::string version_in_words();

}  // namespace flexslip
