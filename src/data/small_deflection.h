// The numbers of the bending standards, for beams that bend little: stiffness, flexural modulus, stress and strain.
//
// They assume what a test with friction and large deflection does not keep: supports that do not hold the specimen back, a
// deflection below a tenth of the span, no shear. They stand beside a fit, to compare with other laboratories.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "data/record.h"
#include "data/section.h"
#include "numerics/statistics.h"

namespace flexslip {

// A stretch of the loading, in shares of the greatest force that is reached at a small deflection.
struct ForceWindow {
  double from, up_to;  // [1]
};

// Beyond that of diamond no material is as stiff.
inline constexpr double max_material_modulus = 1200e9;  // [Pa]
inline constexpr double high_material_modulus = 450e9;  // [Pa] only carbides and diamond are stiffer

// [m] Deflections of one loading between which a slope is told, counted from the contact.
struct DeflectionRange {
  double from, to;
};

// [1] By how much supports and friction on them can make a loading steeper between later deflections than between earlier ones.
using Steepening = std::function<double(DeflectionRange earlier, DeflectionRange later)>;

struct SmallDeflectionOptions {
  // Not given: the steepest stretch that the noise allows.
  std::optional<ForceWindow> window{};
  // [1] Of the stiffness of the load train, standard deviation, where the deflection is what that leaves of the stage; 0 of one that was measured.
  double load_train_error = 0;
  double greatest_modulus = max_material_modulus;  // [Pa]; infinite in reduced units
  std::vector<std::size_t> halts{};                // points after which the stage halted, see DropOptions
  Steepening steepening{};                         // not given: max_steepening at the middle of the later ones
  std::optional<Estimate>
      contact{};  // [m] stated, where strain counts from; not given: the origin of the straight part
};

// What is known of a test besides its record; what is not known stays out of the result.
struct BeamGeometry {
  std::optional<double> span;  // [m]
  std::optional<Section> section;
  std::optional<double> support_radius{};  // [m] 0 of knife edges
};

// [m] The radius that rollers usually have where the supports are not stated: that of ISO 178 under a bar thicker than 1 mm and long enough for
// it; else a twentieth of the span, as on the smallest rig of ASTM C1161, but no more than ISO 178 has. None without a span, or of stated supports.
std::optional<double> standard_roller_radius(const BeamGeometry& geometry);

// [1] By how much friction of 1 and supports of the stated or usual radius steepen the curve up to a deflection [m]: 4.8 w/L and 27 R w/L² (theory.md, "Rollers and
// thickness"), R with half the thickness. 0 without a span.
double max_steepening(const BeamGeometry& geometry, double deflection);

// The stretch of a loading that tells the stiffness of a specimen.
struct LinearRegion {
  ForceWindow window;
  double window_force;          // [N] that the window is in shares of
  std::size_t first, last;      // points [first, last) it is drawn through
  Estimate slope;               // [N/m] dF/dw0
  double origin;                // [m] the deflection at which it would meet zero force; not before the record begins
  double origin_before_record;  // [m] by how much it would be
  double load_train_share;      // [1] of the stage's travel over it

  double middle(const Record& record) const;        // [m] deflection
  double origin_error(const Record& record) const;  // [m] standard deviation, of the slope alone
};

// Domain:     a loading without faults (check_record), its failure taken off; lengths positive; 0 <= from < up_to <= 1; std::invalid_argument otherwise.
// Fails:      none where every stretch has fewer than 3 points, or the force does not rise.
// Max error:  that of its slope is of the scatter about the line, correlated scatter allowed for (AR(1)), at least that of the readings' noise, and of the
//             load train. The steepest stretch is up to 2 errors too steep where all are alike.
// Method:     force and deflection are both regressed on the stage; the slope is the ratio. Of all stretches of three points or more over a quarter of the
//             greatest force, at a deflection below a tenth of the span, the one counts whose slope less three errors is greatest: the steepest one
//             that is not steep by chance. One half as long is as likely to be the sticking of a sawtooth; and none goes on behind a drop from
//             above a quarter of the greatest force: that is how a tooth rises, not the specimen.
std::optional<LinearRegion> find_linear_region(const Record& record, const BeamGeometry& geometry,
                                               const SmallDeflectionOptions& options = {});

// The chord of ISO 178, between the flexural strains 0.05 % and 0.25 %.
struct Chord {
  Estimate stiffness;                     // [N/m]
  double deflection_from, deflection_to;  // [m] from the origin of the straight part
  double modulus;                         // [Pa]
};

enum class SmallDeflectionStatus {
  ok,
  no_straight_part,  // fewer than 3 points in every window, or the force does not rise
  uncertain,         // the error of the stiffness is more than half of it
  too_stiff,         // the modulus is that of no material
};

// A point of a loading.
struct LoadPoint {
  double force;                  // [N]
  double deflection;             // [m] from the origin
  std::optional<double> stress;  // [Pa] F L depth/(8 I)
  std::optional<double> strain;  // [1] 6 deflection depth/L^2
};

struct SmallDeflection {
  SmallDeflectionStatus status;   // unless ok, nothing else is valid but the next two
  double load_train_share;        // [1] of the stage's travel over the straight part, or else up to the greatest force
  std::optional<double> modulus;  // [Pa] E_f = slope L^3/(48 I); of what is too stiff, too
  ForceWindow window;             // of the straight part
  double window_force;            // [N] that the window is in shares of
  std::size_t first, last;        // points [first, last) it was drawn through
  Estimate stiffness;             // [N/m] dF/dw0
  double origin;        // [m] the end of the toe, see LinearRegion, or the contact stated: where strain counts from
  double origin_error;  // [m] its standard deviation
  double origin_before_record;              // [m] see LinearRegion; 0 from a contact stated
  LoadPoint greatest;                       // at the greatest force
  LoadPoint end;                            // at the last point: of a record whose failure was taken off, at break
  std::optional<double> bending_stiffness;  // [N m^2] EI = slope L^3/48
  std::optional<Chord>
      chord;          // where span and section are known, the record covers both strains, and it is not in the toe
  bool chord_in_toe;  // the record bends up between the two strains more than a specimen does
  double toe_excess;  // [1] by how much the straight part is steeper than such a chord
  double toe_excess_explained;  // [1] what of that supports and friction can have done; 0 where it is within its error
  bool deflection_large;        // the greatest force is reached beyond a tenth of the span
  std::optional<double> shear_share;  // [1] what shear adds to a deflection (section.h)
};

// Domain: a record of find_linear_region, and what that tells of it.
// Max error:  that of find_linear_region; it knows nothing of the dimensions of the specimen.
// Method: the chord is drawn between the points where the record first reaches the two strains, by linear interpolation; its error is
//         that of two readings. It lies in the toe where its lower end does, beyond the noise, above the straight part, and this is steeper than
//         the chord, beyond the errors of both, than the steepening of the options explains.
SmallDeflection small_deflection(const Record& record, const std::optional<LinearRegion>& straight,
                                 const BeamGeometry& geometry, const SmallDeflectionOptions& options);
SmallDeflection small_deflection(const Record& record, const BeamGeometry& geometry,
                                 const SmallDeflectionOptions& options = {});

// [Pa] The modulus that a standard would publish: that of its chord, or else of the straight part. None unless the status is ok, and without a section.
std::optional<Estimate> standard_modulus(const SmallDeflection& numbers);

}  // namespace flexslip
