// A result with its error.
#pragma once

#include "flexslip/test.h"

namespace flexslip::v1 {

// Units:      as the quantity. All not_known where the result does not exist.
struct Estimate {
  double value = not_known;           // median
  double standard_error = not_known;  // standard deviation
  double low = not_known;             // 95 % interval
  double high = not_known;
};

}  // namespace flexslip::v1
