// FlexSlip as a library: three-point bending tests in which the specimen slips over its supports.
//
//   using namespace flexslip::v1;
//   const Fit answer = fit({.diameter = 34.8e-6, .modulus = 29.6e9, .span = 1278e-6, .load_train_stiffness = 90.65},
//                          {.stage = stages, .force = forces});
//
// SI units throughout. Functions have no state and may run on several threads. The same input gives the same bits on
// every machine. docs/stability.md says what stays the same in 1.x.
#pragma once

#include <string>

#include "flexslip/design.h"
#include "flexslip/error.h"
#include "flexslip/estimate.h"
#include "flexslip/fit.h"
#include "flexslip/modulus.h"
#include "flexslip/read.h"
#include "flexslip/simulate.h"
#include "flexslip/state.h"
#include "flexslip/test.h"

namespace flexslip::v1 {

// The version of the library, "1.0.0".
std::string version();

}  // namespace flexslip::v1
