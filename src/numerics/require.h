// Checks of the domain of a number.
#pragma once

namespace flexslip {

// Fails:      throws std::invalid_argument "name = value is out of range" unless `holds`.
void require(bool holds, const char* name, double value);

}  // namespace flexslip
