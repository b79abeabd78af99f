#include "inference/stiffness_from_slope.h"

#include <cmath>

#include "data/contact.h"
#include "fibre/elementary.h"

namespace flexslip {

StiffnessFromSlope stiffness_from_slope(const Record& record, double span) {
  const Contact contact = find_contact(record);
  if (contact.status != ContactStatus::found || !(contact.slope.value > 0)) return {};
  double work = 0;
  double square = 0;
  for (std::size_t i = contact.first; i < contact.last; ++i) {
    work += record.force[i] * record.deflection[i];
    square += record.deflection[i] * record.deflection[i];
  }
  constexpr double bend =
      0.03;  // of the curve over these points, by friction and large deflection: the order of 2.4 q w at w = 0.03
  return {.found = work > 0,
          .value = work / square * span * span * span / 48,
          .relative_error = elementary::length(
              elementary::length(usual_stiffness_error, contact.slope.standard_error / contact.slope.value), bend)};
}

}  // namespace flexslip
