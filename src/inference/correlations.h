// How the errors of estimates go together.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace flexslip {

// Of bending stiffness, roughness and correlation length it is the correlation of their logarithms.
struct Correlation {
  std::string_view of, with;  // as parameter_names
  double value;               // [1]
};

// What one explanation, or one draw of it, tells of all parameters at once. NaN: nothing of that one.
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
  static constexpr std::size_t normal = 3;  // of the first so many it tells a covariance, too

  double weight;
  std::array<double, count> value;  // [1], [1/L], ln of three, [1], [L], [rad]
  std::array<std::array<double, normal>, normal> covariance{};
};

// Over all parts, of each pair that varies, once. Of a parameter that some parts tell nothing of it counts in these as what it is on average.
// Domain:     weights positive.
std::vector<Correlation> correlations_of(std::span<const JointPart> parts);

}  // namespace flexslip
