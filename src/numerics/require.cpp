#include "numerics/require.h"

#include <sstream>
#include <stdexcept>

namespace flexslip {

void require(bool holds, const char* name, double value) {
  if (holds) return;
  std::ostringstream message;
  message << name << " = " << value << " is out of range";
  throw std::invalid_argument(message.str());
}

}  // namespace flexslip
