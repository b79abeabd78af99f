// The linear region at the start of a loading curve, and the zero of the force before contact.
#pragma once

#include <cstddef>
#include <span>

#include "data/record.h"
#include "numerics/statistics.h"

namespace flexslip {

enum class ContactStatus {
  found,
  too_few_points,  // fewer than 5 points in the force range; the other fields are invalid
  not_rising,      // the force does not rise in the range; the other fields are invalid
};

struct InitialLine {
  ContactStatus status;
  Estimate offset;          // [m] stage position, and so deflection, at contact
  Estimate slope;           // [N/m] initial dF/dw0, the stiffness of the specimen
  std::size_t first, last;  // the line is fitted to points [first, last)
  bool settles;             // the curve bends at contact, and the line is fitted above the bend
};

// The line force = slope (deflection - offset) at the start of a loading curve.
// The range is 0.02 to 0.15 of the maximum force. Below it the contact may still settle; above it
// curves of large deflection are no longer straight. With fewer than 5 points there, as under a
// preload, the range extends to 0.3.
// Method:     force and deflection are both regressed on the stage position, which is imposed and
//             so free of their noise; the slope is the ratio. Standard errors allow for
//             autocorrelated residuals (AR(1)). The contact settles if the upper half of the range
//             extrapolates to zero force later than the lower half, by four standard errors. The
//             line then fits the upper half and an equally long range above it, and its error
//             includes the change that this causes.
InitialLine initial_line(const Record& record);

// The zero of the force: the reading of the load cell before contact.

enum class ForceZeroStatus {
  found,
  no_free_rows,  // the record begins in contact, or has too few rows before it
};

struct ForceZero {
  ForceZeroStatus status;
  double offset;       // [N] mean of the rows; 0 unless found
  double error;        // [N] standard error; 0 unless found
  std::size_t points;  // number of first points that the mean includes
};

// The mean force before contact.
// Domain:     columns of equal length, finite, the displacement rising except for noise; noise [N]
//             >= 0 of one force reading; std::invalid_argument otherwise.
// Method:     the force is constant over the first rows that stay within 4 noise of their running
//             mean. A specimen in contact from the first row leaves that band much earlier. The
//             mean covers the first half of these rows, which excludes the toe. Its error allows
//             for drift from row to row (AR(1)).
ForceZero find_force_zero(std::span<const double> displacement, std::span<const double> force, double noise);

// A force that drifts or settles before contact.
struct Baseline {
  // points before contact; 0 if too few, or if their force is constant
  std::size_t points = 0;
  double begin = 0, level = 0;          // [m], [N] at the first point
  double slope = 0;                     // [N/m]
  double settles_by = 0, settling = 1;  // [N], [m] amplitude and decay length (to 1/e)
  double change = 0, error = 0;         // [N] total change before contact, and its standard error

  double at(double displacement) const;  // [N]
};

// Domain:     columns of equal length, finite, the displacement rising except for noise; 11 points
//             or more.
// Method:     contact is where a line through 5 to 20 % of the maximum force meets the level of the
//             rows before it; found twice. A straight line and exponentials are fitted to the rows
//             before contact. The one with the smallest scatter is kept if its change is six times
//             its error (AR(1)).
Baseline find_baseline(std::span<const double> displacement, std::span<const double> force);

// True if the offset exceeds four times its error.
bool is_significant(const ForceZero& zero);

}  // namespace flexslip
