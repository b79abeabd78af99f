// In what an answer is told: the units of its test, and the rows of its file.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "data/scales.h"
#include "io/quantity.h"

namespace flexslip {

struct Frame {
  Scales scales = Scales(1, 1);  // from the reduced variables of the library to those of the test
  bool reduced = false;          // the test is reduced itself
  bool in_inches = false;        // people are shown it in inches and pounds
  std::function<std::size_t(std::size_t)> row = [](std::size_t point) { return point + 1; };  // of the file, of a point
};

// Domain:     a kind of mechanics: lengths, forces, their products and powers that kind:: has; std::invalid_argument otherwise.

// [SI, or reduced if the test is] A number in reduced variables.
double physical(double reduced, const Kind& kind, const Scales& scales);

// The unit of such numbers: "N"; "EI/L^2" of a reduced test; "1" of a plain number.
std::string_view unit_of(const Kind& kind, bool reduced);

}  // namespace flexslip
