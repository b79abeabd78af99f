// Units as testing machines write them, which is not always as people who care about them do.
#pragma once

#include <optional>
#include <string_view>

#include "io/quantity.h"

namespace flexslip {

// What parse_unit knows, and "Sec", "Secs", "seconds", "Newton", "kgf", "gf", "inch", "Micrometer" and the like.
// nullopt for what is none of these: a unit is never guessed.
std::optional<Unit> machine_unit(std::string_view text);

// Volts, of a transducer whose calibration the file does not hold: "V", "mV", "Volts".
bool is_voltage(std::string_view text);

// [V] in one of that unit. Domain: is_voltage(text).
double volts_in(std::string_view text);

// A unit or a voltage, "-" or "1": what may stand in a row of units.
bool names_a_unit(std::string_view text);

}  // namespace flexslip
