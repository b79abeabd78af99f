// What a case says of its rig, [rig]. Units: those of a physical case (case_file.h).
#pragma once

#include <optional>
#include <string>

namespace flexslip {

// Where friction acts on the specimen: at its surface, or, as the paper has it, at its axis, as if it had no thickness.
enum class FrictionAt { surface, axis };

// What rollers do when the specimen slides over them: nothing, turn on their pins, or roll on a flat base.
enum class Rollers { fixed, pinned, loose };

struct RigInput {
  std::optional<double> span;                     // [m] reduced: 1; none: the export of the record says it
  std::optional<double> stiffness;                // [N/m] infinite for displacement control
  std::optional<std::string> support_material{};  // "steel", likewise
  std::optional<double> nose_radius{};            // [m] none: sharp
  std::optional<double> support_stiffness{};      // [N/m] of each support, vertically; none: rigid
  std::optional<double> roller_radius{};          // [m] none: edges
  Rollers rollers = Rollers::fixed;
  double pin_radius = 0, pin_friction = 0;       // [m], [1] of rollers on pins
  FrictionAt friction_at = FrictionAt::surface;  // one with the axis where no section says how thick the specimen is
  bool in_inches = false;                        // the span is stated so: people are answered in inches and pounds
  bool operator==(const RigInput&) const = default;

  // Whatever the specimen's friction, pins that hold their rollers so fast never turn.
  bool pins_turn() const { return rollers != Rollers::pinned || pin_friction * pin_radius < *roller_radius; }
};

}  // namespace flexslip
