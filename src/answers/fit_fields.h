// The fields of `fit --json`.
#pragma once

#include <string_view>

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// The units of the test and the rows of its file. The test must outlive the frame.
Frame frame_of(const FittedTest& test);

// If the analysis failed, the fields that depend on it are null or empty, and "status" gives the
// reason.
const Fields<FittedTest>& fit_fields();

Json fit_json(const FittedTest& test);

// The parameters of a fit, shared with the tests of a campaign.
namespace parameter {

inline constexpr Named mu0{"mu0", kind::number, "mean friction over the observed length"};
inline constexpr Named roughness{"roughness", kind::number, "standard deviation of friction about its mean"};
inline constexpr Named correlation_length{"correlation_length", kind::length,
                                          "correlation length of friction along the specimen"};
inline constexpr Named amplitude{"amplitude", kind::number,
                                 "amplitude of the most probable wave of friction, relative to mu0"};
inline constexpr Named wavelength{"wavelength", kind::length,
                                  "wavelength of the most probable wave of friction, along the specimen"};
inline constexpr Named phase{"phase", kind::angle, "phase of the most probable wave of friction at length 0"};
inline constexpr Named bending_stiffness{"bending_stiffness", kind::bending_stiffness, "fitted EI"};
inline constexpr std::string_view bound =
    "mu0 cannot be distinguished from 0; the upper end of its interval is an upper limit";

}  // namespace parameter

}  // namespace flexslip
