// One fit of all passes of a record: loading, unloading and loading again, any number of times and to any depth.
//
// All passes show one specimen on one rig. In a pass inwards it slides on q = +μ(S), in a pass outwards on q = -μ(S). Both pass the same places, and
// friction is the same there but for its wear. So the half-sum of the branches gives the stiffness, and the half-difference the friction (theory.md,
// "A reload"). A loss of stiffness changes the ratio of the branches. A specimen that settles shifts them along the deflection.
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

// The priors of the fit, as standard deviations where nothing else is said, and its length.
struct PassesOptions {
  // Friction along the fibre.
  double friction = 0.45;        // [1] its mean
  double friction_error = 0.35;  // [1]
  double friction_trend = 0.2;   // [1] over half of the stretch that the specimen slides over
  double slow_friction = 0.06;   // [1] its variation over a third of that stretch
  double spacing = 0.0025;       // [L] of the nodes at which friction is known; wider ones miss roughness
  double most_nodes = 160;       // the cost grows with their cube

  // The change of friction from pass to pass, as a logarithm.
  double level_at_top = 0.1;     // where the specimen is unloaded
  double level_at_bottom = 0.6;  // where it is loaded again and may lie elsewhere
  double level_trend = 0.1;      // over half of the stretch

  // Losses of stiffness, as a logarithm.
  double share_of_drops =
      0.5;  // [loss that the drops need as cracks] in the drops of a loading: mean and standard deviation
  double each_drop = 0.35;    // [likewise] in each drop besides
  double gradual_loss = 0.1;  // of a loading, besides that in its drops
  double course_of_loss =
      0.04;  // by which half of a gradual loss may come earlier or later than in proportion to the deflection
  double loss_at_turn = 0.012;
  double loss_at_reload = 0.06;  // where the pass that is loaded again is unloaded, too
  double stiffening = 0.02;      // any of these but those of drops, as a gain, which nothing does

  // Deflections.
  double settling = 0.03;            // [L] that a loading leaves for good
  double rising = 0.001;             // [L] likewise upwards, which nothing does
  double contact_change = 0.0015;    // [L] where the specimen is loaded again
  double contact_change_at_top = 0;  // [L] where it is unloaded

  // A specimen that beds down on its supports: what is tried where that does not explain the record.
  double bedding = 0.006;    // [L] the contact, and its changes at either turn
  double bedded_from = 0.3;  // [greatest deflection] rows with less are left out

  // The zero of the force, besides RigErrors.
  double zero = 0.0015;    // [maximum force]
  double drift = 0.003;    // [maximum force] from the first row to the last
  double wander = 0.0012;  // [maximum force] besides

  double of_forces =
      0.03;  // [1] by which the forces of two loadings of a sound specimen differ, where only they are compared

  double min_deflection = 0.02;  // [L] rows with less are left out: they show no friction
  double min_force = 0.01;       // [maximum force] likewise
  int rounds = 13;               // of linearisation
};

struct PassesProblem {
  ReducedRecord record;  // of all passes, counted from the contact
  Rig rig;
  MeasurementErrors errors;
  RigErrors rig_errors{};
  std::size_t first, last;  // rows [first, last) of the loading that is evaluated
  std::vector<Drop> drops;  // of all loadings, by the rows of the record
  PassesOptions options{};
};

// One pass of a record.
struct PassFriction {
  Leg rows;
  std::size_t sliding;  // rows that show sliding friction
  Estimate friction;    // [1] mean over what the specimen slid over in it; NaN where it did not slide
};

// What one row shows.
struct PassPoint {
  std::size_t row, pass;
  double S, q;  // [L], [1] read at the EI of the fit, less the errors of the rig
  bool slides;
};

enum class PassesStatus {
  ok,
  not_sliding_out,  // fewer than 20 rows slide outwards; only sliding_out, and the loss by the forces of two loadings, are valid
  not_explained,  // no friction, losses and bedding give the rows to within five times their noise, nor .04 of the greatest force: likewise
};

struct PassesFit {
  PassesStatus status = PassesStatus::not_explained;
  std::vector<PassFriction> passes{};
  std::size_t sliding_out = 0;      // rows
  std::vector<PassPoint> points{};  // in the order of the record
  double S_first = 0, S_last = 0;   // [L] the stretch that the evaluated loading and another pass slid over
  Estimate mean_friction{};         // [1] over it
  Estimate log_stiffness{};         // [1] ln of EI over the nominal one, before anything is lost
  double correlation = 0;           // [1] of these two
  bool is_reloaded = false;         // a loading comes after another one, and slides: the loss is valid
  bool is_followed = false;         // one comes after the evaluated loading
  Estimate loss{};                  // [1] share of the stiffness lost in all loadings that are followed by another pass
  double loss_needed = 0;           // [1] likewise, by the drops of these loadings, if they were cracks only
  std::size_t drops_again = 0;      // in loadings after the evaluated one, before they reach its greatest deflection
  Estimate settled{};               // [L] in these loadings
  RigCorrection correction{};       // of the evaluated loading: errors of the rig, losses and settling
  Sensitivities friction_by{}, log_stiffness_by{};  // as those of FrictionFit
};

// Domain:     a record without faults, of at least two legs (find_legs); rig.stiffness > 0; std::invalid_argument otherwise.
// Max error:  of 275 records of a foreign simulator with all errors of the rig at once, 94 % of intervals hold the friction (bench/causes).
// Fails:      not_sliding_out, not_explained: then the loss is told by the forces of two loadings at the same deflections.
// Method:     Gauss-Newton in friction at the nodes and in all other unknowns at once, each with a Gaussian prior. Residuals are forces at the deflections
//             read. Their weights come from the noise that is left, which is lowered step by step, and from a robust loss. The size and the length of
//             the roughness are chosen by evidence. Cracks too small for a fall have losses as drops have (with_breaks).
// Cost:       about 0.2 s for 600 rows; of more than 1200 rows every so many are fitted.
PassesFit fit_passes(const PassesProblem& problem);

// Friction of the loading that is evaluated, given what all passes say of the rig, of EI and of what was lost and settled; its errors are those of
// both. Draws are given the rig as found.
// Domain:     passes.status is ok; `whole` is the loading for which they were fitted.
// Fails:      as fit_friction.
FrictionFit fit_evaluated(const FitProblem& whole, const PassesFit& passes, const FitOptions& options = {});

// [EI/L^2] The force at which a specimen that is unloaded begins to slide outwards: at the length and on the friction of a point of its loading.
// Domain:     a state of the fibre; friction >= 0. 0 where it does not slide before the nose leaves it.
double sliding_out_force(const Fibre& fibre, double S, double friction);

}  // namespace flexslip
