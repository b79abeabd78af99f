// Every number of `fit --json`, described once.
#pragma once

#include <string_view>

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// The units of the test, and the rows of its file. The test must outlive it.
Frame frame_of(const FittedTest& test);

// Where the analysis did not succeed, what depends on it is null or empty, and "status" says why.
const Fields<FittedTest>& fit_fields();

Json fit_json(const FittedTest& test);

// Its parameters, which a campaign tells of each of its tests, too.
namespace parameter {

inline constexpr Named mu0{"mu0", kind::number, "mean friction over the specimen seen"};
inline constexpr Named roughness{"roughness", kind::number, "standard deviation of friction about its mean"};
inline constexpr Named correlation_length{"correlation_length", kind::length,
                                          "correlation length of friction along the specimen"};
inline constexpr Named amplitude{"amplitude", kind::number,
                                 "amplitude of the likeliest wave of friction, relative to mu0"};
inline constexpr Named wavelength{"wavelength", kind::length,
                                  "wavelength of the likeliest wave of friction, along the specimen"};
inline constexpr Named phase{"phase", kind::angle, "phase of the likeliest wave of friction at the length 0"};
inline constexpr Named bending_stiffness{"bending_stiffness", kind::bending_stiffness, "EI of the fit"};
inline constexpr std::string_view bound =
    "mu0 cannot be distinguished from 0, and the upper end of its interval is a limit";

}  // namespace parameter

}  // namespace flexslip
