// What the columns of an export are taken for: as its words say, or as the user does, and what remains to be asked; a force that is
// there only as a voltage.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "instruments/export.h"

namespace flexslip {

// The export whose columns have the roles and units that the options state, with questions for what neither they nor the file say, and the flags
// that decide the same again. The header of its numbers stands on a line, counted from 1.
// Fails:      InputError for options that name no such column, a force in volts without its calibration, a unit that what the file states of its
//             greatest force contradicts.
Export decided(Export file, const ExportOptions& options, const NumberFormat& format, std::size_t header_line);

// A force that is only there as a voltage: a load cell whose calibration the file does not hold.
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
