// A force that is only there as a voltage: a load cell whose calibration the file does not hold.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace flexslip {

struct VoltageFinding {
  std::size_t column;   // index of the one in volts
  double correlation;   // with the force; NaN if there is none
  bool force_is_noise;  // the force does not rise above its own scatter, and the voltage does
};

struct MeasuredColumn {
  std::span<const double> values;
  bool is_voltage, is_force;
};

// The column in volts that may be the force of the test: the words of none say otherwise. The file must not be evaluated
// without a decision if there is no force beside it, or if it follows the force (a second load cell: |correlation| of at
// least 0.9), or if the force is noise and the voltage is not. nullopt if the voltages are something else.
// Cost:       linear.
std::optional<VoltageFinding> voltage_for_force(std::span<const MeasuredColumn> columns);

}  // namespace flexslip
