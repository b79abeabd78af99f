// Friction that gets no farther than to where something else gives way: at rollers on pins the pins, once the torque of the specimen turns them.
#pragma once

#include <vector>

#include "contact/friction.h"

namespace flexslip {

// The lesser of the friction of the specimen and a cap, at lengths up to S_most.
// Domain:     a friction of one support, along its points; cap >= 0; std::invalid_argument otherwise.
// Tolerance:  lengths at which the cap is crossed are bisected to rounding, between samples at a sixteenth of the shortest period.
Friction capped(const Friction& friction, double cap, double S_most);

// [1] Friction of rollers on pins, which turn at a torque of pin_friction on the radius of the pin: m/√(1 - m²), m = pin_friction pin_radius/radius.
// Domain:     m < 1.
double friction_of_pins(double pin_friction, double pin_radius, double radius);

}  // namespace flexslip
