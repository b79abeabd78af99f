// Names in the order in which people list them: SS2 before SS10.
#pragma once

#include <string_view>

namespace flexslip {

// Whole numbers within names count as numbers. A strict order: names that differ in leading zeros alone are ordered as text.
bool in_natural_order(std::string_view first, std::string_view second);

}  // namespace flexslip
