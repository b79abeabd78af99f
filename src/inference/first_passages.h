// The observations of sliding in a loading, and the skipped segments between them: while sliding
// in, the specimen passes a length S when the stage first reaches G(S; μ(S)).
//
// Each reading gives two linear conditions on μ: an equality at the current length, and an upper
// bound over the skipped segment. An error of the force moves the inverted state along the level
// curve of the stage position, so readings are linearised at the fitted state, not at the noisy one
// (theory.md, "First passages"). Reduced variables of the nominal EI.
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

// The effect of one error of the rig on every reading, calculated along the curve of one friction.
// The effect of the error on the roughness carries no information, because the size of the
// roughness is unknown.
struct RigError {
  std::vector<Shift> shift;
  std::vector<double> friction;  // [1] increase of the inverted friction
  std::vector<double> place;     // [L] of S
};

inline constexpr std::size_t rig_error_capacity = 9;  // as many as a chain has columns for

// A point where the specimen stuck after a snap that overshot. Its friction is at least the
// friction that held it.
struct Stuck {
  std::size_t reading;   // the first that slides again; the number of readings if none does
  double S;              // [L]
  double landing, last;  // [L] stage positions where the snap ended, and where the specimen slides again
};

// The readings of one such rest.
struct Rest {
  std::vector<double> S, S_force;  // [L] as inverted; dS/de of an error of the force
  double jump;                     // [L] of the snap before it
};

// The readings of a record that carry information on friction, in the order of the record.
struct Passages {
  SearchOptions options{};           // of the choice of readings and of the search
  std::size_t judged = 0;            // readings deep enough for friction, explained or not
  std::vector<std::size_t> row;      // in the record
  std::vector<double> stage, force;  // [L], [EI/L^2]
  std::vector<double> S, q;          // [L], [1] inverted at the nominal EI
  std::vector<double> advance;       // [L] of S since the previous reading, for constant friction
  bool overshoots;                   // snaps overshoot
  bool may_overshoot;                // snaps do not overshoot, but the record does not exclude it
  std::vector<Stuck> stuck;          // after each overshoot but one before the first reading
  std::vector<Rest> rests;           // one per entry of stuck
  Fibre fibre;                       // on its supports
  double compliance;                 // [L^3/EI] of the load train
  double stiffness_error;            // [1] prior standard deviation of ln EI
  RigError stiffness;                // of ln EI, per unit
  std::vector<RigError> rig_errors;  // per standard deviation, independent of each other
  PerQuantity<RigError> quantities;  // as RigErrorEffects::by
  double noise;                      // [EI/L^2] of a reading, from second differences
  ContactPath along;                 // of the specimen
  double share;                      // [1] share_of_sliding
  double S_middle;                   // [L] middle of the observed length
  double range;                      // [L] of places on the specimen

  std::size_t size() const { return row.size(); }
  double place(double S_at) const { return share * (along.at(S_at) - S_middle); }  // [L] x of matern.h
  double sliding_length_at(double place) const { return along.sliding_length_at(S_middle + place / share); }
};

// [L] The smallest deflection of a fitted reading: 0.08, or half the maximum deflection if that is
// less, but never below min_informative_deflection.
double min_fit_deflection(double max_deflection, const Fibre& fibre);

// The rows of the readings between min_fit_deflection and 0.8 with an advancing stage, without
// readings within a drop.
// Domain:     forces in any unit; a record of at least 3 readings.
std::vector<std::size_t> readings_judged(const ReducedRecord& record, const Fibre& fibre);

// With fewer readings, friction cannot be determined.
inline constexpr std::size_t min_readings = 20;

// Method:     keeps the readings_judged that a friction in [-1.5, 2.2] explains; if the problem
//             states that snaps overshoot, without readings at which the specimen sticks
//             (snap_rests.h).
Passages passages_of(const FitProblem& problem, const SearchOptions& options = {});

// ln p of the forces while the specimen stuck, for errors with this standard deviation [EI/L^2] and
// correlation.
// Method:     uniform prior of each rest within twice its jump.
double log_density_of_rests(const Passages& passages, double noise, double correlation);

inline constexpr double nugget = 0.0007;  // [1] variations of μ that no kernel describes

// The state at which the friction of a reading was found, with the derivatives of the stage
// position.
struct LevelFound {
  double S, stage, compliance;  // [L], [L], [L^3/EI] with the fitted EI
  double F;                     // [EI/L^2]
  double stage_S, stage_mu;     // [1], [L] derivatives of the stage position
};

// The readings linearised: y_i = μ(x_i) + h_E (η - η0) + Σ h_r (ε_r - ε_r0) + D e_i, where e_i is
// the error of the force, η = ln EI/nominal, ε_r an error of the rig over its standard deviation,
// and h its effect on friction (Passages).
struct Linearisation {
  double eta = 0;                    // [1] η0
  std::vector<double> rig;           // [1] ε_r0; empty: 0
  std::vector<double> stage, force;  // [L], [EI/L^2] the readings, corrected for these errors of the rig
  std::vector<double> S, slope;      // the fitted states: [L] non-decreasing, [1/L] dμ/dS
  std::vector<double> wave_slope;    // [1/L] of its waves; empty: 0
  std::vector<double> mu;            // [1] the friction with which the specimen passes S at the measured stage position
  std::vector<LevelFound> found;     // of mu; empty: mu is approximate
  std::vector<double> S_seen;        // [L] by the measured force
  std::vector<double> S_force, S_eta;  // dS/de at fixed stage, dS/dη at fixed force
  std::vector<double> noise_gain;      // D, with G'/G_S at least 0.05
  std::vector<double> y;
  double log_jacobian;  // Σ ln |dy/dF|
};

// True if the sliding length exceeds what a reading resolves.
inline bool has_slid(const Linearisation& at) { return at.S.back() - at.S.front() > 1e-6; }

// Completes a linearisation of which eta, rig, S and slope are set; mu may be approximate.
// Method:     linearises at (S, m(S; ws)), so that the error of the force enters y linearly.
//             Directly inverted readings are biased by the curvature of the level curve.
void complete(Linearisation& at, const Passages& passages);

// [1] The friction with which the specimen passes each length at a stage position.
// Domain:     S in (1, 2.1); `near` are approximate frictions. Near the end of the branch, where
//             the force vanishes, the result is the nearest friction with a force
//             (states_slopes_before_branch_end).
std::vector<double> friction_at_stage(std::span<const double> S, std::span<const double> stage,
                                      std::span<const double> near, const Fibre& fibre, double compliance, double eta);

// The start of the search: S against the stage as straight, non-decreasing pieces.
// Method:     dynamic programming with a cost of 1.5 ln n per piece; the noise is taken from second
//             differences of the force.
Linearisation rises_of(const Passages& passages);

// ---- Skipped segments

inline constexpr double bound_softness = 0.003;  // [1] of μ

// One point in a skipped segment, where friction is below a bound, or a point where the specimen
// stuck, where friction is above it. A Gaussian in the slack approximates the condition.
struct SkippedPoint {
  std::size_t reading;           // the first beyond the segment
  std::size_t node, nodes;       // index and number of points in the segment
  std::optional<Stuck> stuck{};  // beyond the segment; empty if it slid on at once
  bool held = false;             // the specimen stuck: friction is above the bound
  double precision = 0;          // [1]
  double precision_mean = 0;     // [1]
  double wave_slope = 0;         // [1/L] dμ/dS of the fitted waves
};

// [L] The length at which the specimen stuck, interpolated between the fitted lengths of the
// readings around it.
double landing_of(const Stuck& stuck, std::span<const double> S);

// The points in the segments that the specimen skipped: it advanced much farther than constant
// friction allows, for a noise [EI/L^2] of the force. Points in `before` are kept.
std::vector<SkippedPoint> skipped_segments(const Passages& passages, const Linearisation& at, double noise,
                                           const std::vector<SkippedPoint>& before);

// The contribution of a point to the evidence beyond its Gaussian approximation, for a slack with
// this mean and variance.
double log_weight(const SkippedPoint& site, double mean, double variance);

}  // namespace flexslip
