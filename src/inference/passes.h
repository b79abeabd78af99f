// The fit of all passes of a record together: loading, unloading and loading again, any number of
// times and to any depth.
//
// All passes belong to one specimen on one rig. In an inward pass the specimen slides on q = +μ(S),
// in an outward pass on q = -μ(S). Friction is the same in both but for wear, so the half-sum of
// the branches gives the stiffness and the half-difference the friction (theory.md, "A reload"). A
// loss of stiffness changes the ratio of the branches; settling shifts them along the deflection.
// Reduced variables of the nominal EI.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "data/drops.h"
#include "data/record.h"
#include "inference/fit.h"
#include "inference/rig_correction.h"
#include "numerics/statistics.h"

namespace flexslip {

// The priors of the fit, as standard deviations unless stated otherwise, and its length.
struct PassesOptions {
  // Friction along the specimen.
  double friction = 0.45;        // [1] mean
  double friction_error = 0.35;  // [1]
  double friction_trend = 0.2;   // [1] over half of the sliding length
  double slow_friction = 0.06;   // [1] variation over a third of the sliding length
  double spacing = 0.0025;       // [L] between the nodes of the profile; a wider spacing misses roughness
  double max_nodes = 160;        // the cost grows with their cube

  // The change of friction from pass to pass, as a logarithm.
  double level_at_top = 0.1;     // at the start of an unloading
  double level_at_bottom = 0.6;  // at a reload, where the specimen may lie elsewhere
  double level_trend = 0.1;      // over half of the sliding length

  // Losses of stiffness, as a logarithm.
  double share_of_drops = 0.5;   // [loss required by the drops as cracks] in a loading: mean and standard deviation
  double each_drop = 0.35;       // [loss required by the drop as a crack] additional, per drop
  double gradual_loss = 0.1;     // per loading, outside its drops
  double course_of_loss = 0.04;  // deviation of a gradual loss from proportionality to the deflection, at its middle
  double loss_at_turn = 0.012;
  double loss_at_reload = 0.06;  // at a reload that is itself unloaded
  double stiffening = 0.02;      // any of these as a gain, except in drops

  // Deflections.
  double settling = 0.03;            // [L] permanent deflection after a loading
  double rising = 0.001;             // [L] the same upwards
  double contact_change = 0.0015;    // [L] at a reload
  double contact_change_at_top = 0;  // [L] at the start of an unloading

  // Bedding of the specimen on its supports, tried if the fit does not explain the record.
  double bedding = 0.006;    // [L] of the contact, and of its changes at both turns
  double bedded_from = 0.3;  // [maximum deflection] rows below are left out

  // The zero of the force, in addition to RigErrors.
  double zero = 0.0015;    // [maximum force]
  double drift = 0.003;    // [maximum force] from the first row to the last
  double wander = 0.0012;  // [maximum force] slow deviations

  double of_forces = 0.03;  // [1] difference between the forces of two loadings of a sound specimen

  double min_deflection = 0.02;  // [L] rows below are left out: they carry no information on friction
  double min_force = 0.01;       // [maximum force] rows below are left out
  int rounds = 13;               // of linearisation
};

struct PassesProblem {
  ReducedRecord record;  // of all passes, measured from the contact point
  Rig rig;
  MeasurementErrors errors;
  RigErrors rig_errors{};
  std::size_t first, last;  // rows [first, last) of the evaluated loading
  std::vector<Drop> drops;  // of all loadings, in rows of the record
  PassesOptions options{};
};

// One pass of a record.
struct PassFriction {
  Leg rows;
  std::size_t sliding;  // number of rows in which it slides
  Estimate friction;    // [1] mean over the sliding length; NaN without sliding
};

// One row.
struct PassPoint {
  std::size_t row, pass;
  double S, q;  // [L], [1] inverted at the fitted EI, corrected for errors of the rig
  bool slides;
};

enum class PassesStatus {
  ok,
  // Fewer than 20 rows slide outwards. Only sliding_out and the loss from the forces of two
  // loadings are valid.
  not_sliding_out,
  // Friction, losses and bedding reproduce the rows neither to five times their noise nor to 0.04
  // of the maximum force. As above.
  not_explained,
};

struct PassesFit {
  PassesStatus status = PassesStatus::not_explained;
  std::vector<PassFriction> passes{};
  std::size_t sliding_out = 0;      // number of rows
  std::vector<PassPoint> points{};  // in the order of the record
  double S_first = 0, S_last = 0;   // [L] the range over which the evaluated loading and another pass slid
  Estimate mean_friction{};         // [1] over this range
  Estimate log_stiffness{};         // [1] ln(EI/nominal) before any loss
  double correlation = 0;           // [1] between these two
  bool is_reloaded = false;         // a loading follows another one and slides: the loss is valid
  bool is_followed = false;         // a loading follows the evaluated one
  Estimate loss{};                  // [1] share of the stiffness lost in all loadings that another pass follows
  double loss_needed = 0;           // [1] required by the drops of these loadings as cracks only
  std::size_t drops_again = 0;      // drops after the evaluated loading, below its maximum deflection
  Estimate settled{};               // [L] in these loadings
  // [1] Standard deviation of lengths along the specimen in the evaluated loading, relative, from
  // the errors of the rig, the losses and the settling; and [L] of their middle.
  double stretch = 0, displaced = 0;
  RigCorrection correction{};  // of the evaluated loading, for errors of the rig, losses and settling
  Sensitivities friction_by{}, log_stiffness_by{};  // as in FrictionFit
};

// Domain:     a record without faults, of at least two legs (find_legs); rig.stiffness > 0;
//             std::invalid_argument otherwise.
// Max error:  94 % of the 95 % intervals contain the friction for 275 records of an independent
//             simulator (bench/causes).
// Fails:      not_sliding_out, not_explained; the loss then follows from the forces of two loadings
//             at the same deflections.
// Method:     Gauss-Newton in friction at the nodes and all other unknowns, each with a Gaussian
//             prior. Residuals are forces at the measured deflections, with a robust loss and
//             weights from the remaining noise, which decreases step by step. Size and length of
//             the roughness maximise the evidence. Cracks too small for a drop have losses too
//             (with_breaks).
// Cost:       about 0.2 s for 600 rows; longer records are thinned to 1200 rows.
PassesFit fit_passes(const PassesProblem& problem);

// The friction of the evaluated loading, given the results of all passes for the rig, EI, losses
// and settling. Its errors include those of both fits. Posterior samples use the estimated rig.
// Domain:     passes.status is ok; `whole` is the loading for which they were fitted.
// Fails:      as fit_friction.
FrictionFit fit_evaluated(const FitProblem& whole, const PassesFit& passes, const FitOptions& options = {});

// [EI/L^2] The force at which an unloaded specimen starts to slide outwards, at this length and
// friction. 0 if the nose lifts off first.
// Domain:     a state of the fibre; friction >= 0.
double sliding_out_force(const Fibre& fibre, double S, double friction);

}  // namespace flexslip
