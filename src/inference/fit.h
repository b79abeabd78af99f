// Which friction along the fibre explains a measured curve, and how certainly.
//
// Friction is a mean, perhaps with a drift and a wave, and a random roughness about it (process_mode.h). The record tells of it through first
// passages; every answer is an average over how smooth the roughness may be and over the waves that may be there. The paper's own models,
// without roughness, are fitted on the same likelihood. Reduced variables of the nominal bending stiffness.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "data/record.h"
#include "fibre/fibre.h"
#include "inference/correlations.h"
#include "inference/fit_problem.h"
#include "inference/kernel.h"
#include "inference/profile.h"
#include "inference/rig_correction.h"
#include "inference/search_options.h"
#include "inference/stated_quantity.h"
#include "numerics/statistics.h"

namespace flexslip {

// Of the logarithm of the evidence: what one wave more must bring to be claimed.
inline constexpr double claiming_gain = 3;

// A wave of friction, (4.25).
struct WaveEstimate {
  Estimate amplitude;        // [1] A, relative to mu0
  Estimate wavelength;       // [L] λ; under a free nose the period in S, which else is 2 λ
  Estimate phase;            // [rad] φ of (4.25), at S = 0: strongly correlated with λ
  Estimate phase_at_middle;  // [rad] π S_middle/λ + φ, which is not; under a free nose 2π S_middle/λ + φ
  std::vector<Correlation> correlations{};  // with all that goes with it
};

// The posterior of a parameter and its prior: their quotient is the estimate of the record alone.
struct Marginal {
  NormalMixture posterior;
  double prior_mean, prior_deviation;  // of a normal distribution
};

// One explanation among those that the answer averages over.
struct Explanation {
  Kernel kernel;
  std::vector<double> wavelengths;  // [L] of its waves
  double log_evidence;
  double log_likelihood;  // of its waves where its posterior is greatest, integrated over all else
  double weight;          // [1] of all; they add up to 1
};

struct ScannedWave {
  double wavelength;  // [L]
  double gain;        // of the logarithm of the evidence, by a wave added to what explains the record without one
};

// Friction along the fibre seen: at each of many lengths what is known of it.
struct ProfileBand {
  std::vector<double> S;                // [L] drawn in, rising
  std::vector<double> mean, deviation;  // [1]
};

// Without deflections beyond 0.8.
// Domain:     a record without faults, stage not falling; rig.stiffness > 0; errors >= 0, that of EI at most max_stiffness_error;
//             std::invalid_argument otherwise.
FitProblem usable_part(const FitProblem& whole);

// Of a record of so many points, which are fitted: every so many, so that there are at most 1200.
std::size_t thinning_of(std::size_t points);
FitProblem thinned(const FitProblem& problem);

struct ConstantFit {
  double mu0;             // [1]
  double standard_error;  // [1] of the residuals, allowing for their correlation, and of the bending stiffness
};

// Constant friction by least squares in the force at the measured deflections. The bending stiffness is taken as nominal, and its error carried into the interval: given the freedom, a constant would bend
// it to suit the roughness.
// Domain:     as fit_friction.
// Method:     Gauss-Newton; autocovariance of the scores tapered (Newey & West) over a tenth of the record.
ConstantFit fit_constant(const FitProblem& problem);

enum class ProfileModel {
  roughness,  // a mean, a drift, a random roughness, and one wave where the evidence claims it
  constant,   // the paper's models: μ0
  drift,      // μ0 and a slope along the fibre
  sinusoid,   // (4.25) on a drifting mean
  sinusoids,  // two waves on a drifting mean
};

std::string_view name_of(ProfileModel model);
struct FitOptions {
  ProfileModel model = ProfileModel::roughness;
  SearchOptions search{};
};

// By how much what is told would be larger, were a quantity stated larger by the whole of it [1], or by one span [1/L] (changes_in_spans). To first
// order, averaged over the explanations.
using Sensitivities = PerQuantity<double>;

// [1] By how much a rig as soft as that [EI/L^3] hides the mean friction, a standard deviation: the specimen slips on from crest to crest, too
// little to be seen. 0.13 at 10 and less, nothing from 20 on, by simulations (docs/validation.md).
double hidden_by_soft_rig(double stiffness);

enum class FrictionFitStatus {
  ok,
  too_few_points,  // fewer than 20 readings are deep enough to tell of friction: nothing else is valid
  not_explained,  // fewer than 20 of them, or than two in three, are such as some friction gives (Passages), or the fibre passes nothing: nothing else is valid
};

struct FrictionFit {
  FrictionFitStatus status;
  ProfileModel model;
  std::size_t readings;     // that tell of friction
  double S_begin, S_end;    // [L] the fibre seen, by what has been drawn in
  ContactPath along;        // where its contacts were then
  double share = 0.5;       // [1] of what slides: share_of_sliding
  bool overshoots = false;  // snaps do, as stated or by the record
  double S_middle;    // [L] between the contacts midway: where phase_at_middle is meant, and mu0 with drift and wave
  Estimate mu0;       // [1] mean of μ over the fibre seen
  bool mu0_is_bound;  // the record does not tell it from 0: mu0.high is an upper limit of 95 %, mu0.low is 0
  double hidden_by_rig = 0;    // [1] what of its error is that of a soft rig
  Estimate drift;              // [1/L] dμ/dS, S between the contacts; 0 of a constant
  Estimate roughness;          // [1] standard deviation of μ about its mean; 0 of the paper's models
  Estimate length;             // [L] correlation length of it along the fibre; likewise
  Estimate bending_stiffness;  // [1] relative to the nominal one
  // Of mu0, and of ln bending_stiffness; none of a constant.
  std::optional<Sensitivities> friction_by{}, log_stiffness_by{};
  std::vector<Correlation>
      correlations;  // over all explanations, or, where a wave is claimed, over those that have it; empty of a constant
  Estimate noise;    // [EI/L^2] standard deviation of a force reading
  double noise_correlation;         // [1] of readings one row apart
  std::vector<WaveEstimate> waves;  // the likeliest, the largest first, claimed or not
  double
      log_evidence_of_wave;  // ln of the evidence with a wave over that without; NaN of models that have a wave or cannot
  bool
      wave_claimed;  // it exceeds 3, and the wave is shorter than a quarter of the fibre seen; true of models that have one
  double shortest_wave;                   // [L] of friction that would be found; 0 of a constant
  std::vector<Explanation> explanations;  // likeliest first
  std::vector<ScannedWave> scan;          // λ rising
  ProfileBand band;
  RigCorrection correction;  // of what the rig is found to be off by
  FrictionTable mean;  // the mean of μ over what is drawn in, for runs forward: at the estimated bending stiffness
  std::vector<FrictionTable> draws;    // profiles that explain the record as well, drawn at random (20), likewise
  std::vector<double> draw_stiffness;  // [1] relative bending stiffness of each
  std::vector<double> force;           // [EI/L^2] that `mean`, run forward, lets each row of the record read
  double residual_rms;                 // [EI/L^2] of it, over the readings that tell of friction
  std::vector<double>
      innovations;  // [1] what each reading adds to what those before it tell, over its standard deviation; empty of a constant
  Marginal of_mu0, of_log_roughness, of_log_length;  // the latter two only of `roughness`

  // [L] Between the contacts, of the fibre drawn in to a length: what friction along the specimen is a function of.
  double between_contacts(double S) const { return along.length_at(along.at(S)); }
};

// Friction is not negative: what is known of a mean that may be near zero. A bound is an upper limit of 95 %.
struct MeanFriction {
  Estimate estimate;
  bool is_bound;
};
MeanFriction mean_friction(const NormalMixture& mixture);

// The weight of the explanations without roughness; 0 of a model that has none by itself.
double weight_without_roughness(const FrictionFit& fit);

// Does it tell a length along the fibre? A wave that is claimed does, and roughness where there is some: a fit whose explanations have none by more
// than half tells none.
bool tells_lengths(const FrictionFit& fit);

// Domain:     as usable_part.
// Fails:      too_few_points, not_explained. Of more than 1200 points every so many are fitted.
// Cost:       0.1 s at most for 200 points (bench/analyses).
FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options = {});

}  // namespace flexslip
