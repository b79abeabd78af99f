// The numbers of the bending standards, for beams that bend little: stiffness, flexural modulus, stress and strain.
//
// They assume what a test with friction and large deflection does not keep: supports that do not hold the specimen back, a
// deflection below a tenth of the span, no shear. They stand beside a fit, to compare with other laboratories.
#pragma once

#include <cstddef>
#include <optional>

#include "data/record.h"
#include "data/section.h"
#include "numerics/statistics.h"

namespace flexslip {

// A stretch of the loading, in shares of the greatest force that is reached at a small deflection.
struct ForceWindow {
  double from, up_to;  // [1]
};

struct SmallDeflectionOptions {
  // Not given: the steepest of width 0.25 from 0.05 on in steps of 0.05, up to 0.9.
  std::optional<ForceWindow> window{};
};

// What is known of a test besides its record; what is not known stays out of the result.
struct BeamGeometry {
  std::optional<double> span;  // [m]
  std::optional<Section> section;
};

// [m] The radius of the supports that ISO 178 asks for; none of what is no bar: not thicker than 1 mm, or on a span below eight of that radius.
std::optional<double> usual_roller_radius(const BeamGeometry& geometry);

// The chord of ISO 178, between the flexural strains 0.05 % and 0.25 %.
struct Chord {
  Estimate stiffness;                     // [N/m] from scatter
  double deflection_from, deflection_to;  // [m] from the origin of the straight part
  double modulus;                         // [Pa]
};

enum class SmallDeflectionStatus {
  ok,
  no_straight_part,  // fewer than 5 points in every window, or the force does not rise: nothing else is valid
};

struct SmallDeflection {
  SmallDeflectionStatus status;
  ForceWindow window;       // of the straight part
  double window_force;      // [N] that the window is in shares of
  std::size_t first, last;  // points [first, last) it was drawn through
  Estimate stiffness;       // [N/m] dF/dw0, from scatter
  double origin;  // [m] the deflection at which the straight part meets zero force: the toe, where strain counts from
  double greatest_force;                    // [N]
  double deflection;                        // [m] at the greatest force, from the origin
  std::optional<double> bending_stiffness;  // [N m^2] EI = slope L^3/48
  std::optional<double> modulus;            // [Pa] E_f = slope L^3/(48 I)
  std::optional<double> stress;             // [Pa] at the greatest force, F L depth/(8 I)
  std::optional<double> strain;             // [1] there, 6 deflection depth/L^2
  std::optional<Chord> chord;               // where span and section are known and the record covers both strains
  bool deflection_large;                    // the greatest force is reached beyond a tenth of the span
  std::optional<double> shear_share;        // [1] what shear adds to a deflection (section.h)
};

// Domain: a loading without faults (check_record), its failure taken off; lengths positive; 0 <= from < up_to <= 1;
//         std::invalid_argument otherwise.
// Max error: the error is that of the scatter about the line, correlated scatter allowed for (AR(1)); it knows nothing of the
//         dimensions of the specimen. Of windows tried, the steepest is up to 2 errors too steep where all are alike.
// Method: force and deflection are both regressed on the stage, as in initial_line; the slope is the ratio. The chord is drawn
//         between the points where the record first reaches the two strains, by linear interpolation; its error is that of two
//         readings.
SmallDeflection small_deflection(const Record& record, const BeamGeometry& geometry,
                                 const SmallDeflectionOptions& options = {});

}  // namespace flexslip
