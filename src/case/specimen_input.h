// What a case says of its specimen, [specimen]. Units: those of a physical case (case_file.h).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "data/section.h"

namespace flexslip {

// To be found from the record.
struct ToFit {
  bool operator==(const ToFit&) const = default;
};

struct Known {
  double value;
  double uncertainty;  // one standard deviation, same unit; 0 if the file states none
  bool operator==(const Known&) const = default;
};

using StatedStiffness = std::variant<ToFit, Known>;

// How stiff the specimen is: the modulus of its section, or the product EI.
struct Modulus {
  StatedStiffness estimate;  // [Pa]
  bool operator==(const Modulus&) const = default;
};

struct BendingStiffness {
  StatedStiffness estimate;  // [N m^2]
  bool operator==(const BendingStiffness&) const = default;
};

// A loss of bending stiffness, at once and for good.
struct CrackInput {
  double deflection;  // [m] at which it happens when that is first reached
  double loss;        // [1] of what is left, in (0, 1)
  bool operator==(const CrackInput&) const = default;
};

struct SpecimenInput {
  std::optional<Section> section;                    // none beside a modulus: the export of the record says it
  std::variant<Modulus, BendingStiffness> rigidity;  // reduced: a bending stiffness, 1 where it is known
  std::optional<std::string> material{};             // "glass", for the literature's friction alone
  std::vector<CrackInput> cracks{};                  // for simulating
  std::optional<double> strain_at_break{};           // [1] in bending, at the surface; for designs
  std::optional<double> strength{};                  // [Pa] instead
  bool operator==(const SpecimenInput&) const = default;
};

}  // namespace flexslip
