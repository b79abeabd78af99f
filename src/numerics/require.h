// What the domain of a declaration asks of a number.
#pragma once

namespace flexslip {

// Fails:      std::invalid_argument "name = value is out of range" where it does not hold.
void require(bool holds, const char* name, double value);

}  // namespace flexslip
