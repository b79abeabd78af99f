// Friction read off a measured curve, point by point: while the fibre slips, (w, F) inverts to (S, μ); suspects;
// and the length imaged.
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

// What limits the accuracy of μ, as standard deviations.
struct MeasurementErrors {
  double force;              // [EI/L^2] of one reading
  double bending_stiffness;  // [1] relative, of EI
  double contact;            // [L] of the contact point, and so of the deflection
};

// Deflections [L] below it are left out unless the caller says otherwise: friction is hardly measurable there.
inline constexpr double min_profile_deflection = 0.02;

// Past it [L] friction is measurable to a few hundredths.
inline constexpr double min_judged_deflection = 0.1;

inline constexpr double min_friction = -0.1;  // [1] that errors may feign

// Deflections below it [L] say hardly anything of friction.
inline constexpr double min_friction_deflection = 0.05;

// [L] Where friction is told on a fibre: from there, and from twice its thickness on.
double min_informative_deflection(const Fibre& fibre, double min_deflection = min_friction_deflection);

struct ProfilePoint {
  std::size_t index;  // in the record
  double
      S;  // [L] 1 and what has been drawn in over both supports since contact: the length between them, if they are edges
  double length;  // [L] of axis between the contacts, where friction is met (fibre.h); S, if they are edges
  double imaged;  // [L] of axis between the verticals through the supports
  double mu;      // [1] mobilised friction; the coefficient of friction while the fibre slips
  // The parts of the standard deviation of μ [1]. The first differs from point to point, the others move all points together.
  double from_force, from_bending_stiffness, from_contact;
  double S_force;  // [L^3/EI] of S with respect to the force at fixed stage position
};

double standard_error(const ProfilePoint& point);

struct FrictionProfile {
  std::vector<ProfilePoint> points;  // in the order of the record
  std::vector<std::size_t>
      unexplained;  // points of the record that no friction in [-20, 20] explains; on rollers or with a thickness in [-2, 2]
};

// The states of the fibre that a record reads: S [L] and q [1] of each of these rows.
struct ReadStates {
  std::vector<std::size_t> rows;
  std::vector<double> S, q;
  std::vector<std::size_t> unexplained;  // as in a FrictionProfile
};

// Domain:     a record without faults; deflections up to `least` [L] are left out.
// Cost:       0.3 µs a point.
ReadStates read_states(const ReducedRecord& record, const Fibre& fibre, double least);

// Domain:     a record without faults; rig.stiffness > 0; errors >= 0; deflections below min_deflection [L] are left out, where
//             friction is hardly measurable (at 0.05 an error of 1 % in EI is one of 0.1 in μ), and those below twice the thickness.
// Cost:       1 µs a point.
FrictionProfile measure_friction(const ReducedRecord& record, const Rig& rig, const MeasurementErrors& errors,
                                 double min_deflection = min_profile_deflection);

// The greatest curvature of the fibre at midspan [1/L] in the states of a profile; NaN if it has none.
double greatest_curvature(const FrictionProfile& profile, const Fibre& fibre = {});

// [1] Friction read off, as it can be run forward: noise and a wrong stiffness read as friction below none, or as any amount of it.
double held_friction(const Fibre& fibre, double mu);

// The profile as a friction table that, run forward, gives the measured curve back, drops included: a value on the load line
// of each point, and within each drop a trough below it, the shallowest part of what the curve leaves unseen.
// Domain:     a profile of this record; at least two points with w > min_friction_deflection.
// Max error:  in F, 1e-3 where no point of the profile had to be raised to μ = 0 (tested on measured curves: validation.md).
FrictionTable replay_table(const ReducedRecord& record, const Rig& rig, const FrictionProfile& profile,
                           std::span<const Drop> drops);

// Is a measured curve plausible as sliding with friction below a limit?
struct SuspectReport {
  double limit;                       // [1]
  std::vector<std::size_t> points{};  // of the record, past the deflection 0.1, where μ exceeds the limit
  std::size_t points_judged = 0;      // past the deflection 0.1
  bool suspect = false;               // more than 5 % of them exceed it
};
SuspectReport find_suspects(const ReducedRecord& record, const FrictionProfile& profile, double limit = 1.0);

// The length pulled in as a camera saw it, against what the force says.

struct ImagedPoint {
  std::size_t index;  // in the record
  double inferred;    // [L] S - 1, from the force
  double imaged;      // [L]
};

struct ImagedLength {
  std::vector<ImagedPoint> points;  // of the profile that were imaged
  Estimate
      offset;  // [L] median of inferred less imaged, its error if the points erred independently; NaN without points
  double scatter;  // [L] about it, 1.48 times the median absolute deviation
};

// Domain:     pulled_in [L] of each point of the record, NaN where it was not imaged.
ImagedLength compare_with_images(const FrictionProfile& profile, std::span<const double> pulled_in);

// The drops of a record as slips of the specimen over its supports.

// Can a drop of the force be a slip of the specimen over its supports?
enum class SlipVerdict {
  possible,     // length is drawn in, and friction stays between nothing and what is plausible
  unexplained,  // no friction gives the force before or after
  implausible,  // friction before it would be beyond the limit, by twice its error
  negative,     // friction after it would be below 0, likewise
  moves_out,    // length would be let out, likewise
  too_short,    // what is drawn in is less than its error, or the specimen is bent too little to tell
};

std::string_view name_of(SlipVerdict verdict);

// One drop of the force as a slip: how far the fibre moved over its supports, and how friction fell.
struct Slip {
  Drop drop;
  SlipVerdict verdict;
  double S_before, S_after;    // [L] NaN where unexplained, as all that follows
  double mu_before, mu_after;  // [1]
  double advance_error;        // [L] standard error of S_after - S_before, by the noise of the force
  // The friction read off before the next drop, or at the end, is less than that before this one, by more than noise: what a crack takes is gone
  // for good. Friction that rises along the specimen can hide one.
  bool can_be_crack = true;
};

// Each of the drops.
std::vector<Slip> slips_of(const FrictionProfile& profile, std::span<const Drop> drops, const MeasurementErrors& errors,
                           double limit);

// The same drops with lengths and frictions by another profile, that at the bending stiffness of the fit: the verdicts stay, as their limits hold
// for that stated.
std::vector<Slip> with_friction_from(const FrictionProfile& profile, std::span<const Slip> judged,
                                     const MeasurementErrors& errors);

// The model-free counterparts of the wavelength and the amplitude of a sawtooth, from the slips that are possible.
struct SlipSummary {
  std::size_t count;
  double
      median_spacing;  // [L] along the fibre, from the beginning of a slip to that of the next; NaN for fewer than two
  double median_fall;  // [1] of μ in a slip; NaN without slips
};
SlipSummary summarise(std::span<const Slip> slips, Nose nose = Nose::holds);

}  // namespace flexslip
