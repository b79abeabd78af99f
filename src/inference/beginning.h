// The contact point of a loading, from a fit of the specimen's own curve to the first part of its
// rise.
//
// A straight line would meet zero force too late, because the curve stiffens from the start by 2.4
// (q + 5.6 R) w with friction and rollers. Its error would also be too small.
#pragma once

#include <cstddef>
#include <optional>

#include "data/contact.h"
#include "data/record.h"
#include "numerics/statistics.h"

namespace flexslip {

// A test before its record is examined.
struct BeginningOf {
  double span;                                // [m]
  double load_train_stiffness;                // [N/m] infinite: the deflection is that of the stage
  double support_radius = 0;                  // [m]
  std::optional<double> bending_stiffness{};  // [N m^2] EI; default: from the rise
  double bending_stiffness_error = 0;         // [1] its standard deviation
};

struct Contact {
  ContactStatus status;
  Estimate offset{};              // [m] stage position of the contact, after settling if it settles
  double slope = 0;               // [N/m] dF/dw0 at the contact, the stiffness of the specimen
  std::size_t points_before = 0;  // with the stage before the contact
  double seat = 0;                // [1] probability that the seat settles
  bool settles = false;           // the seat settles by more than its error and more than friction curves the record
};

// [L] The assumed error of a contact point stated without one.
inline constexpr double default_contact_error = 0.0005;

// [L] The smallest error of a contact point found here: seats, a lag of one row and varying
// friction shift it by as much.
inline constexpr double least_contact_error = 0.00025;

// Domain:     a record without faults; lengths and stiffnesses positive.
// Max error:  for simulated beginnings with friction between 0 and 1 the offset is within two of
//             its errors in 95 % (tests/inference).
// Method:     fits force = offset + e F(deflection - contact) from the first row to 15 % of the
//             maximum force, F being the curve of one friction; several frictions are weighed by
//             their fit. The loss grows as a logarithm, so that outliers do not count; errors allow
//             for correlated noise. The offset of the force is free if at least three rows lie
//             before the contact. A settling seat takes d (1 - exp(-F/F_seat)) off the deflection;
//             it is fitted up to 30 % of the maximum force and used if d exceeds four of its
//             errors.
Contact find_contact(const Record& record, const BeginningOf& test);

// The same contact with its offset measured from another position [m].
Contact counted_from(double place, Contact contact);

}  // namespace flexslip
