// Friction inverted point by point from a measured curve: while the specimen slides, (w, F) inverts
// to (S, μ); implausible points; and comparison with imaged lengths.
//
// Reduced variables. A record is one loading up to the failure of the specimen.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "contact/nose.h"
#include "data/drops.h"
#include "data/record.h"
#include "fibre/supported_state.h"
#include "numerics/statistics.h"

namespace flexslip {

// The standard deviations that limit the accuracy of μ.
struct MeasurementErrors {
  double force;              // [EI/L^2] of one reading
  double bending_stiffness;  // [1] relative, of EI
  double contact;            // [L] of the contact point, and therefore of the deflection
};

// [L] Default lower limit of the deflections of a profile.
inline constexpr double min_profile_deflection = 0.02;

// [L] At larger deflections friction is measurable to a few hundredths.
inline constexpr double min_judged_deflection = 0.1;

inline constexpr double min_friction =
    -0.1;  // [1] lower limit of apparent friction; errors can make it slightly negative

// [L] Smaller deflections carry almost no information about friction.
inline constexpr double min_friction_deflection = 0.05;

// [L] The smallest deflection at which friction can be determined: the larger of min_deflection and
// twice the thickness.
double min_informative_deflection(const Fibre& fibre, double min_deflection = min_friction_deflection);

struct ProfilePoint {
  std::size_t index;  // in the record
  double S;           // [L] 1 + the sliding length over both supports; on knife edges, the arc length between them
  double length;      // [L] of the axis between the contacts, on which friction depends (fibre.h); S on knife edges
  double imaged;      // [L] of the axis between the vertical planes through the supports
  double mu;          // [1] mobilised friction; the coefficient of friction while the specimen slides
  // The parts of the standard deviation of μ [1]. The first differs from point to point, the others
  // move all points together.
  double from_force, from_bending_stiffness, from_contact;
  double S_force;  // [L^3/EI] of S with respect to the force at fixed stage position
};

double standard_error(const ProfilePoint& point);

struct FrictionProfile {
  std::vector<ProfilePoint> points;  // in the order of the record
  std::vector<std::size_t>
      unexplained;  // points that no friction in [-20, 20] explains; [-2, 2] on rollers or with a thickness
};

// The states inverted from a record: S [L] and q [1] of each row.
struct ReadStates {
  std::vector<std::size_t> rows;
  std::vector<double> S, q;
  std::vector<std::size_t> unexplained;  // as in FrictionProfile
};

// Domain:     a record without faults. Deflections up to `min_deflection` [L] are left out.
// Cost:       0.3 µs a point.
ReadStates read_states(const ReducedRecord& record, const Fibre& fibre, double min_deflection);

// Domain:     a record without faults; rig.stiffness > 0; errors >= 0; deflections below
//             min_deflection [L] and below twice the thickness are left out. (At 0.05, an error of
//             1 % in EI changes μ by 0.1.)
// Cost:       1 µs a point.
FrictionProfile measure_friction(const ReducedRecord& record, const Rig& rig, const MeasurementErrors& errors,
                                 double min_deflection = min_profile_deflection);

// [1/L] The maximum curvature at midspan over the states of a profile; NaN without states.
double max_curvature(const FrictionProfile& profile, const Fibre& fibre = {});

// [1] Inverted friction, clamped to the range that can be simulated. Noise and a wrong stiffness
// can leave it.
double held_friction(const Fibre& fibre, double mu);

// The profile as a friction table whose simulation reproduces the measured curve and its drops: the
// inverted friction at each point, and within each drop the shallowest trough that the curve
// allows.
// Domain:     a profile of this record; at least two points with w > min_friction_deflection.
// Max error:  1e-3 in F, if no point of the profile had to be raised to μ = 0 (validation.md).
FrictionTable replay_table(const ReducedRecord& record, const Rig& rig, const FrictionProfile& profile,
                           std::span<const Drop> drops);

// The points whose friction exceeds a plausible limit.
struct SuspectReport {
  double limit;                       // [1]
  std::vector<std::size_t> points{};  // of the record, beyond a deflection of 0.1, with μ above the limit
  std::size_t points_judged = 0;      // beyond a deflection of 0.1
  bool suspect = false;               // more than 5 % of the judged points exceed the limit
};
SuspectReport find_suspects(const ReducedRecord& record, const FrictionProfile& profile, double limit = 1.0);

// ---- Comparison with imaged lengths

struct ImagedPoint {
  std::size_t index;  // in the record
  double inferred;    // [L] S - 1, from the force
  double imaged;      // [L]
};

struct ImagedLength {
  std::vector<ImagedPoint> points;  // of the profile with an image
  Estimate offset;  // [L] median of inferred - imaged, with its error for independent points; NaN without points
  double scatter;   // [L] 1.48 times the median absolute deviation
};

// Domain:     pulled_in [L], the imaged sliding length of each point of the record; NaN without an
//             image.
ImagedLength compare_with_images(const FrictionProfile& profile, std::span<const double> pulled_in);

// ---- Drops as slips

// The result of testing whether a force drop can be a slip of the specimen over its supports.
enum class SlipVerdict {
  possible,     // a length slides in, and friction stays between 0 and the limit
  unexplained,  // no friction explains the force before or after
  implausible,  // friction before it exceeds the limit by twice its error
  negative,     // friction after it is below 0 by twice its error
  moves_out,    // a length slides out, by twice its error
  too_short,    // the length is smaller than its error, or the deflection is too small
};

std::string_view name_of(SlipVerdict verdict);

// One force drop as a slip: the sliding lengths and frictions before and after.
struct Slip {
  Drop drop;
  SlipVerdict verdict;
  double S_before, S_after;    // [L] NaN if unexplained, as are the next fields
  double mu_before, mu_after;  // [1]
  double advance_error;        // [L] standard error of S_after - S_before due to noise of the force
  // The friction before the next drop, or at the end, is lower than before this drop by more than
  // noise, because a crack loses stiffness permanently. Friction that rises along the specimen can
  // hide a crack.
  bool can_be_crack = true;
};

// The slips of all drops.
std::vector<Slip> slips_of(const FrictionProfile& profile, std::span<const Drop> drops, const MeasurementErrors& errors,
                           double limit);

// The same slips with lengths and frictions from another profile, at the fitted bending stiffness.
// The verdicts stay.
std::vector<Slip> with_friction_from(const FrictionProfile& profile, std::span<const Slip> judged,
                                     const MeasurementErrors& errors);

// The model-free counterparts of wavelength and amplitude of a sawtooth, from the possible slips.
struct SlipSummary {
  std::size_t count;
  double median_spacing;  // [L] along the specimen, between the starts of consecutive slips; NaN for fewer than two
  double median_fall;     // [1] of μ in a slip; NaN without slips
};
SlipSummary summarise(std::span<const Slip> slips, Nose nose = Nose::holds);

}  // namespace flexslip
