// Correlations between the errors of estimates.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace flexslip {

// The correlation of two parameters; for bending stiffness, roughness and correlation length, of
// their logarithms.
struct Correlation {
  std::string_view of, with;  // as parameter_names
  double value;               // [1]
};

// The values of all parameters in one explanation, or in one sample of it. NaN: undetermined.
struct JointPart {
  enum Parameter : std::size_t {
    mu0,
    drift,
    bending_stiffness,
    roughness,
    correlation_length,
    amplitude,
    wavelength,
    phase,
    count
  };
  static constexpr std::array<std::string_view, count> parameter_names{
      "mu0", "drift", "bending_stiffness", "roughness", "correlation_length", "amplitude", "wavelength", "phase"};
  static constexpr std::size_t normal = 3;  // the first parameters have a covariance

  double weight;
  std::array<double, count> value;  // [1], [1/L], ln of three, [1], [L], [rad]
  std::array<std::array<double, normal>, normal> covariance{};
};

// The correlation of each pair of parameters that varies, over all parts. Where a parameter is NaN,
// its mean is used.
// Domain:     weights positive.
std::vector<Correlation> correlations_of(std::span<const JointPart> parts);

}  // namespace flexslip
