// Where a loading curve begins by itself: the contact, by a fit of the fibre's own curve to the first of its rise.
//
// A straight line there would meet zero force too late, as the curve bends from the first on, by 2.4 (q + 5.6 R) w with friction and rollers; and it
// would claim more than it knows.
#pragma once

#include <cstddef>
#include <optional>

#include "data/contact.h"
#include "data/record.h"
#include "numerics/statistics.h"

namespace flexslip {

// What is known of a test before its record is looked at.
struct BeginningOf {
  double span;                                // [m]
  double load_train_stiffness;                // [N/m] infinite: the deflection is that of the stage
  double support_radius = 0;                  // [m]
  std::optional<double> bending_stiffness{};  // [N m^2] EI; none: as the rise itself says
  double bending_stiffness_error = 0;         // [1] its standard deviation
};

struct Contact {
  ContactStatus status;
  Estimate offset{};  // [m] stage position at which the contact begins; of one that settles, once it has settled
  double slope = 0;   // [N/m] dF/dw0 there, the stiffness of the specimen
  std::size_t points_before = 0;  // whose stage lies before the contact
  double seat = 0;                // [1] probability that the seat gives way at first
  bool settles = false;  // at first the seat gives way, by more than its error and than friction bends the curve
};

// The uncertainty of a contact that is stated without one [L].
inline constexpr double default_contact_error = 0.0005;

// No beginning tells a contact better [L]: seats, lags of a row and friction that varies at once move it by as much.
inline constexpr double least_contact_error = 0.00025;

// Domain:     a record without faults; lengths and stiffnesses positive.
// Max error:  of simulated beginnings with friction between 0 and 1 the offset is within two of its errors in 95 % (tests/inference).
// Method:     force = offset + e F(deflection - contact), F the curve of one friction, each of several in turn and weighed by how well it fits; from the
//             first row to 15 % of the greatest force. The loss grows as a logarithm, so that single readings do not count; errors allow for
//             correlated noise. The offset of the force is free where at least three rows lie before the contact. A seat that gives way takes
//             d (1 - exp(-F/F_seat)) off the deflection, looked at up to 30 %, and counts where d is beyond four of its errors.
Contact find_contact(const Record& record, const BeginningOf& test);

// The same, counted from another place [m].
Contact counted_from(double place, Contact contact);

}  // namespace flexslip
