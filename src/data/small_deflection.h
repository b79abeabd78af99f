// Stiffness, flexural modulus, stress and strain by the formulas of the bending standards.
//
// The formulas assume supports without friction, deflections below a tenth of the span and no
// shear. A test with friction and large deflection violates the first two. The numbers accompany a
// fit for comparison between laboratories.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "data/record.h"
#include "data/section.h"
#include "numerics/statistics.h"

namespace flexslip {

// An interval of force, as fractions of the maximum force at small deflection.
struct ForceWindow {
  double from, up_to;  // [1]
};

// [Pa] No material is stiffer: diamond.
inline constexpr double max_material_modulus = 1200e9;
// [Pa] only carbides and diamond are stiffer
inline constexpr double high_material_modulus = 450e9;

// [m] An interval of deflection of one loading, measured from the contact point.
struct DeflectionRange {
  double from, to;
};

// [1] The largest relative increase in slope, from one deflection range to a later one, that the
// supports and their friction can cause.
using Steepening = std::function<double(DeflectionRange earlier, DeflectionRange later)>;

struct SmallDeflectionOptions {
  // Default: the steepest linear region, see find_linear_region.
  std::optional<ForceWindow> window{};
  // [1] Relative standard deviation of the load-train stiffness, if the deflection was computed
  // from the stage position; 0 if it was measured.
  double load_train_error = 0;
  double greatest_modulus = max_material_modulus;  // [Pa] infinite in reduced units
  // points after which the stage stops, see DropOptions
  std::vector<std::size_t> halts{};
  // default: max_steepening at the middle of the later range
  Steepening steepening{};
  // [m] stated zero of strain; default: the origin of the linear region
  std::optional<Estimate> contact{};
};

// Dimensions of the test. A result that needs a missing dimension is empty.
struct BeamGeometry {
  std::optional<double> span;  // [m]
  std::optional<Section> section;
  std::optional<double> support_radius{};  // [m] 0 for knife edges
  // [1] standard deviations of the span and of the second moment, 0 if not stated
  double span_error = 0, moment_error = 0;
};

// [m] The assumed support radius if the supports are not stated: the radius of ISO 178 for a bar
// thicker than 1 mm and long enough. Otherwise a twentieth of the span, as on the smallest rig of
// ASTM C1161, but at most the radius of ISO 178. Empty without a span, or for stated supports.
std::optional<double> standard_roller_radius(const BeamGeometry& geometry);

// [1] The relative increase in slope up to a deflection [m] for a friction of 1 and supports of the
// stated or standard radius: 4.8 w/L + 27 R w/L², where R includes half the thickness (theory.md,
// "Rollers and thickness"). 0 without a span.
double max_steepening(const BeamGeometry& geometry, double deflection);

// The part of the loading that determines the stiffness of the specimen.
struct LinearRegion {
  ForceWindow window;
  double window_force;      // [N] unit of `window`
  std::size_t first, last;  // the line is fitted to points [first, last)
  Estimate slope;           // [N/m] dF/dw0
  // [m] deflection at which the line reaches zero force, or the start of the record if that is
  // later
  double origin;
  // [m] distance from the zero of the line to a later start of the record
  double origin_before_record;
  double load_train_share;  // [1] of the stage travel over this region

  double middle(const Record& record) const;  // [m] deflection
  // [m] standard deviation, due to the slope alone
  double origin_error(const Record& record) const;
};

// Domain:     a loading without its failure and without faults (check_record); lengths positive; 0
//             <= from < up_to <= 1; std::invalid_argument otherwise.
// Fails:      empty if every candidate has fewer than 3 points, or the force does not rise.
// Max error:  the standard error of the slope includes the autocorrelated scatter about the line
//             (AR(1)), at least the noise, and the error of the load train. If all candidates are
//             equally steep, the choice biases the slope by up to 2 errors.
// Method:     force and deflection are both regressed on the stage position; the slope is the
//             ratio. Candidates are all regions of at least three points over at least a quarter of
//             the maximum force, at deflections below a tenth of the span. The region with the
//             largest slope minus three errors is chosen: the steepest that is not steep by chance.
//             A region half as long may be the sticking part of a sawtooth. No region continues
//             past a drop that starts above a quarter of the maximum force, because the rise after
//             it is a tooth.
std::optional<LinearRegion> find_linear_region(const Record& record, const BeamGeometry& geometry,
                                               const SmallDeflectionOptions& options = {});

// The chord of ISO 178, between flexural strains of 0.05 % and 0.25 %.
struct Chord {
  Estimate stiffness;                     // [N/m]
  double deflection_from, deflection_to;  // [m] from the origin of the linear region
  Estimate modulus;                       // [Pa]
};

enum class SmallDeflectionStatus {
  ok,
  no_straight_part,  // fewer than 3 points in every candidate, or the force does not rise
  uncertain,         // the standard error of the stiffness exceeds half of the stiffness
  too_stiff,         // the modulus exceeds greatest_modulus
};

// One point of the loading.
struct LoadPoint {
  double force;                  // [N]
  double deflection;             // [m] from the origin
  std::optional<double> stress;  // [Pa] F L depth/(8 I)
  std::optional<double> strain;  // [1] 6 deflection depth/L^2
};

struct SmallDeflection {
  // unless ok, only load_train_share is valid; if too_stiff, also modulus
  SmallDeflectionStatus status;
  // [1] of the stage travel over the linear region; without one, up to the maximum force
  double load_train_share;
  std::optional<Estimate> modulus;  // [Pa] E_f = slope L^3/(48 I)
  ForceWindow window;               // of the linear region
  double window_force;              // [N] unit of `window`
  std::size_t first, last;          // points [first, last) of the linear region
  Estimate stiffness;               // [N/m] dF/dw0
  // [m] zero of strain: the end of the toe (LinearRegion), or the stated contact point
  double origin;
  double origin_error;          // [m] standard deviation
  double origin_before_record;  // [m] see LinearRegion; 0 with a stated contact point
  LoadPoint greatest;           // at the maximum force
  LoadPoint end;                // at the last point; at break, if a failure was removed
  // at the conventional strain of ISO 178, 3.5 %; empty if the record does not reach it
  std::optional<LoadPoint> at_conventional_strain;
  // [1] slope over the last tenth of the deflection, relative to `stiffness`
  double end_slope;
  double end_share;                           // [1] of the span, deflection at the end; 0 without a span
  std::optional<Estimate> bending_stiffness;  // [N m^2] EI = slope L^3/48
  // Empty if span or section is unknown, or the record does not cover both strains.
  std::optional<Chord> chord;
  // the curve stiffens between the two strains by more than the specimen explains
  bool chord_in_toe;
  // [1] relative excess of the slope of the linear region over the chord's slope
  double toe_excess;
  // [1] the part that supports and friction can cause; 0 within its error
  double toe_excess_explained;
  bool deflection_large;  // the maximum force occurs beyond a tenth of the span
  // [1] relative increase of the deflection due to shear (section.h)
  std::optional<double> shear_share;
};

// Domain:     a record as for find_linear_region, and its linear region.
// Max error:  as find_linear_region. The errors of modulus and bending
//             stiffness include the errors of span and section that the geometry states.
// Method:     the chord connects the points, interpolated linearly, at which the record first
//             reaches the two strains. Its error is the error of two readings. The chord lies in
//             the toe under two conditions. Its lower end is above the line of the linear region by
//             more than the noise. This region is steeper than the chord by more than the errors
//             and `steepening` explain, and by more than a tenth: in 36 public tests whose
//             laboratories report the chord, it is steeper by up to 9 %.
SmallDeflection small_deflection(const Record& record, const std::optional<LinearRegion>& linear,
                                 const BeamGeometry& geometry, const SmallDeflectionOptions& options);
SmallDeflection small_deflection(const Record& record, const BeamGeometry& geometry,
                                 const SmallDeflectionOptions& options = {});

// True if the specimen yields: the force levels off, without a break, to a slope below a tenth of the
// initial slope, at a deflection below a fifth of the span. Beyond it, an elastic specimen does so.
bool yields(const SmallDeflection& numbers);

// True if the record ends while the force still rises, so that its maximum is no strength.
bool ends_rising(const SmallDeflection& numbers);

// True if the chord gives the modulus to report: there is one, and it does not lie in the toe.
bool reports_chord(const SmallDeflection& numbers);

// [Pa] The modulus to report, from the chord or the linear region. Empty unless the status is ok and
// the section is known.
std::optional<Estimate> standard_modulus(const SmallDeflection& numbers);

}  // namespace flexslip
