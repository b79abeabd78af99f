// Readings of a loading as first passages: sliding in, the fibre passes a length S when the stage first reaches G(S; μ(S));
// and the gaps that were jumped over.
//
// Each reading tells friction twice, and both are linear in μ: an equality where the fibre is, and a bound on the friction that it jumped
// over. Noise of the force moves the inverted state along the level curve of the stage position, so that readings are linearised at the
// state fitted, never at the noisy one (theory.md, "First passages"). Reduced variables of the nominal EI.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fibre/fibre.h"
#include "inference/fit.h"
#include "inference/rig_error_effects.h"
#include "inference/search_options.h"

namespace flexslip {

// What something that is off does to each reading.
//
// Taken along the curve of one friction, not at the readings: what an error does to roughness, a size that is not known beforehand, tells nothing
// of the error.
struct RigError {
  std::vector<Shift> shift;
  std::vector<double> friction;  // [1] that it would be read larger by
  std::vector<double> place;     // [L] of S
};

inline constexpr std::size_t most_rig_errors = 9;  // which the columns of a chain have room for

// Where the fibre stuck after a snap that overshot: its friction is at least what held it.
struct Stuck {
  std::size_t reading;   // the first that slides again; the number of readings where none does
  double S;              // [L]
  double landing, last;  // [L] stage positions at which the snap came to rest, and up to which it stuck
};

// The readings of it.
struct Rest {
  std::vector<double> S, S_force;  // [L] as inverted; dS/de of an error of the force
  double jump;                     // [L] of the snap before it
};

// The readings of a record that tell of friction, in its order.
struct Passages {
  SearchOptions options{};           // by which they were chosen and are searched
  std::size_t judged = 0;            // readings deep enough to tell of friction, whether any friction gives them or not
  std::vector<std::size_t> row;      // in the record
  std::vector<double> stage, force;  // [L], [EI/L^2]
  std::vector<double> S, q;          // [L], [1] inverted at the nominal EI
  std::vector<double> advance;       // [L] of S since the reading before, were friction constant
  bool overshoots;                   // its snaps are taken to
  bool may_overshoot;                // they are not, and the record leaves it open
  std::vector<Stuck> stuck;          // after each that does, but one before the first reading
  std::vector<Rest> rests;           // of each
  Fibre fibre;                       // on its supports
  double compliance;                 // [L^3/EI] of the load train
  double stiffness_error;            // [1] standard deviation of ln EI beforehand
  RigError stiffness;                // of ln EI, by one
  std::vector<RigError> rig_errors;  // by one standard deviation, independent of each other
  PerQuantity<RigError> quantities;  // of each that is larger than stated, as RigErrorEffects::by
  double noise;                      // [EI/L^2] of a reading, by second differences
  ContactPath along;                 // the specimen, past its contacts
  double share;                      // [1] of what slides (share_of_sliding)
  double S_middle;                   // [L] of it
  double range;                      // [L] of places on the fibre: that share of what has passed

  std::size_t size() const { return row.size(); }
  double place(double S_at) const { return share * (along.at(S_at) - S_middle); }  // [L] x of matern.h
  double sliding_length_at(double place) const { return along.sliding_length_at(S_middle + place / share); }
};

// [L] The deflection from which on readings are judged: 0.08, or half the greatest if that is less, never below min_informative_deflection.
double min_fit_deflection(double greatest_deflection, const Fibre& fibre);

// The readings past min_fit_deflection and up to 0.8 where the stage advances, by their rows; those within a drop of several readings are left out.
// Domain:     forces in any unit; a record of at least 3 readings.
std::vector<std::size_t> readings_judged(const ReducedRecord& record, const Fibre& fibre);

// Fewer of them tell no friction.
inline constexpr std::size_t min_readings = 20;

// Method:     Of the readings judged those that some friction in [-1.5, 2.2] explains; where the problem states that snaps overshoot, without those at
//             which the fibre sticks (snap_rests.h).
Passages passages_of(const FitProblem& problem, const SearchOptions& options = {});

// ln p of the forces read while the fibre stuck, of errors of this deviation [EI/L^2] and correlation.
// Method:     each rest anywhere within twice its jump beforehand.
double log_density_of_rests(const Passages& passages, double noise, double correlation);

inline constexpr double nugget = 0.0007;  // [1] of μ, what no kernel follows

// Where the friction of a reading was found, and how the stage position goes on from there.
struct LevelFound {
  double S, stage, compliance;  // [L], [L], [L^3] over the EI fitted: where a friction was found
  double F;                     // [EI/L^2]
  double stage_S, stage_mu;     // [1], [L] of the stage position
};

// The readings linearised: y_i = μ(x_i) + h_E (η - η0) + Σ h_r (ε_r - ε_r0) + D e_i, e_i being the error of the force, η = ln EI/nominal, ε_r
// the errors of the rig, each over its standard deviation, h the friction that each reads larger by (Passages).
struct Linearisation {
  double eta = 0;                      // [1] η0
  std::vector<double> rig;             // [1] ε_r0; empty: 0
  std::vector<double> stage, force;    // [L], [EI/L^2] what was read, less those errors of the rig
  std::vector<double> S, slope;        // the fitted states: [L] not falling, [1/L] dμ/dS
  std::vector<double> wave_slope;      // [1/L] of its waves; empty: 0
  std::vector<double> mu;              // [1] the friction at which the fibre passes S at the stage position read
  std::vector<LevelFound> found;       // of mu; empty: mu is only near
  std::vector<double> S_seen;          // [L] where the force read would put it
  std::vector<double> S_force, S_eta;  // dS/de at fixed stage, dS/dη at fixed force
  std::vector<double> noise_gain;      // D, its factor G'/G_S not below 0.05
  std::vector<double> y;
  double log_jacobian;  // Σ ln |dy/dF|
};

// Has more passed than no reading resolves?
inline bool has_slid(const Linearisation& at) { return at.S.back() - at.S.front() > 1e-6; }

// Completes eta, rig, S and slope; mu need only be near.
// Method:     Everything is taken at (S, m(S; ws)), so that the error of the force enters y linearly: a reading inverted as it stands is
//             biased by the curvature of the level curve, on soft rigs by more than the errors of a wavelength.
void complete(Linearisation& at, const Passages& passages);

// [1] The friction at which the fibre passes each length when the stage is at a position.
// Domain:     S in (1, 2.1); `near` are frictions not far from those sought. Where hardly any force is left (states_slopes_before_branch_end) it is the
//             nearest friction with a force; to 0.05 more, where the branch ends before.
std::vector<double> friction_at_stage(std::span<const double> S, std::span<const double> stage,
                                      std::span<const double> near, const Fibre& fibre, double compliance, double eta);

// Where the search begins: S over the stage cut into the straight, non-falling pieces of least cost.
// Method:     dynamic programming; a piece costs 1.5 ln n. Noise: second differences of the force.
Linearisation rises_of(const Passages& passages);

// Gaps that the fibre jumped over, and what is taken for the bounds that friction had there.

inline constexpr double bound_softness = 0.003;  // [1] of μ

// What a place in a gap, where friction must have been below a bound, or one where it held the fibre, above it, is taken for: a Gaussian of the slack
// between the two.
struct SkippedPoint {
  std::size_t reading;           // the first beyond the gap
  std::size_t node, nodes;       // which of how many
  std::optional<Stuck> stuck{};  // beyond the gap; none where it slid on at once
  bool held = false;             // where it stuck: friction is above the level
  double precision = 0;          // [1]
  double precision_mean = 0;     // [1]
  double wave_slope = 0;         // [1/L] dμ/dS of the waves fitted
};

// [L] Where the fibre stuck, between the readings around it at lengths fitted.
double landing_of(const Stuck& stuck, std::span<const double> S);

// The sites of a linearisation at a noise [EI/L^2] of the force: where the fibre advanced by far more than friction that stays would let it, it jumped.
// Those that were there before stay as they were.
std::vector<SkippedPoint> skipped_segments(const Passages& passages, const Linearisation& at, double noise,
                                           const std::vector<SkippedPoint>& before);

// What a site adds to the evidence beyond the Gaussian that stands for it, which gives the slack this mean and variance.
double log_weight(const SkippedPoint& site, double mean, double variance);

}  // namespace flexslip
