// The straight beginning of a loading curve, and the zero of its force before that.
#pragma once

#include <cstddef>
#include <span>

#include "data/record.h"
#include "numerics/statistics.h"

namespace flexslip {

enum class ContactStatus {
  found,
  too_few_points,  // fewer than 5 in the range of force looked at: nothing else is valid
  not_rising,      // the force does not rise there: nothing else is valid
};

struct InitialLine {
  ContactStatus status;
  Estimate offset;          // [m] stage position, and so deflection, at which the contact begins
  Estimate slope;           // [N/m] initial dF/dw0, the stiffness of the specimen
  std::size_t first, last;  // points [first, last) the line was drawn through
  bool settles;             // the curve bends where it begins: the line is drawn through what comes above
};

// The straight beginning of a loading curve, force = slope (deflection - offset), between 0.02 and 0.15 of the maximum force: below, the
// contact may still be settling; above, curves of large deflection are no longer straight. A record with fewer than 5 points there, as one
// that begins under a preload, is looked at up to 0.3.
// Method: force and deflection are both regressed on the stage, which is imposed and so free of their noise; the slope is the
//         ratio. Standard errors allow for residuals correlated from point to point (AR(1)). Where the upper half of the range meets
//         zero force later than the lower one, by four standard errors, the contact settles: the line is then that of the upper
//         half and of as much above the range, and how far the result moves by that is part of its error.
InitialLine initial_line(const Record& record);

// What a load cell shows before it carries anything: the zero of the force, from the rows before the contact.

enum class ForceZeroStatus {
  found,
  no_free_rows,  // the record begins in contact, or too few rows before it can be told from it
};

struct ForceZero {
  ForceZeroStatus status;
  double offset;       // [N] mean of the rows; 0 unless found
  double error;        // [N] its standard error; 0 unless found
  std::size_t points;  // the first of the record, that the mean is of
};

// The mean force before the specimen is touched.
// Domain: columns of one length, displacement rising but for noise, finite; noise [N] of one force reading, at least 0;
//         std::invalid_argument otherwise.
// Method: the force is level up to the last of the first rows that stay within 4 noise of their running mean; a specimen in
//         contact from the first row on would leave that band much earlier. The mean is of the first half of that way, which
//         keeps the toe, where the contact settles, out of it. Its error allows for drift from row to row (AR(1)).
ForceZero find_force_zero(std::span<const double> displacement, std::span<const double> force, double noise);

// A force that is not level before the contact: it drifts, or settles.
struct Baseline {
  std::size_t points = 0;               // of the record, before the contact; 0: too few to tell, or they are level
  double begin = 0, level = 0;          // [m], [N] at the first of them
  double slope = 0;                     // [N/m]
  double settles_by = 0, settling = 1;  // [N], [m] over which it settles to 1/e
  double change = 0, error = 0;         // [N] over the way before the contact, and its standard error

  double at(double displacement) const;  // [N]
};

// Domain:     columns of one length, displacement rising but for noise, finite; 11 points or more.
// Method:     the contact is where a line through 5 to 20 % of the greatest force meets the level of the rows before, twice; of a line and exponentials
//             through these the one that they scatter least about counts, if its change is six times its error (AR(1)).
Baseline find_baseline(std::span<const double> displacement, std::span<const double> force);

// Is an offset more than its error makes likely, four times as much?
bool is_significant(const ForceZero& zero);

}  // namespace flexslip
