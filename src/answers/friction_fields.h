// The friction of a fitted test, described once: its parameters, its waves, its explanations, and what the fit is held against.
#pragma once

#include <string_view>

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// Those of the model that the fit is of, and the contact; without a fit that alone.
Fields<FittedTest> parameter_fields();

// The likeliest wave, claimed or not. Domain: the fit has one.
Fields<FittedTest> likeliest_wave_fields();

// The parameters that a campaign tells of each of its tests, too.
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

Fields<Explanation> explanation_fields();

// Friction at each of many lengths.
Fields<FittedTest> band_fields();

Fields<Check> check_fields();

}  // namespace flexslip
