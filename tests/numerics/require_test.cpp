#include "numerics/require.h"

#include <limits>
#include <stdexcept>

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("contract: a true condition does nothing, a false one names the number and its value") {
  CHECK_NOTHROW(require(true, "noise", -1));
  CHECK_THROWS_WITH_AS(require(false, "noise", -1e-9), "noise = -1e-09 is out of range", std::invalid_argument);
  CHECK_THROWS_WITH_AS(require(false, "noise", std::numeric_limits<double>::quiet_NaN()), "noise = nan is out of range",
                       std::invalid_argument);
}

}  // namespace flexslip
