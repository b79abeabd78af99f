// The fit of friction along the specimen to a measured curve, with its errors.
//
// Friction is a mean, possibly with a trend and a wave, and a random roughness (process_mode.h).
// The likelihood is that of first passages. Every answer is an average over smoothnesses of the
// roughness and over possible waves. The paper's own models, without roughness, use the same
// likelihood. Reduced variables of the nominal bending stiffness.
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

// [ln evidence] The gain that a further wave needs to be detected.
inline constexpr double claiming_gain = 3;

// A wave of friction, (4.25).
struct WaveEstimate {
  Estimate amplitude;        // [1] A, relative to mu0
  Estimate wavelength;       // [L] λ; the period in S is 2 λ, or λ under a free nose
  Estimate phase;            // [rad] φ of (4.25), at S = 0; strongly correlated with λ
  Estimate phase_at_middle;  // [rad] π S_middle/λ + φ, uncorrelated with λ; 2π S_middle/λ + φ under a free nose
  std::vector<Correlation> correlations{};  // with the other parameters
};

// The posterior of a parameter and its prior. Their quotient is the likelihood of the record.
struct Marginal {
  NormalMixture posterior;
  double prior_mean, prior_deviation;  // of a normal distribution
};

// One of the explanations that the answer averages.
struct Explanation {
  Kernel kernel;
  std::vector<double> wavelengths;  // [L] of its waves
  double log_evidence;
  double log_likelihood;  // of its waves at the maximum of the posterior, integrated over all else
  double weight;          // [1] the weights of all explanations add up to 1
};

struct ScannedWave {
  double wavelength;  // [L]
  double gain;        // [ln evidence] of adding this wave to the best explanation without one
};

// The posterior mean and standard deviation of friction along the observed length.
struct ProfileBand {
  std::vector<double> S;                // [L] sliding length, increasing
  std::vector<double> mean, deviation;  // [1]
};

// The problem without deflections beyond 0.8.
// Domain:     a record without faults, stage non-decreasing; rig.stiffness > 0; errors >= 0, and at
//             most max_stiffness_error for EI; std::invalid_argument otherwise.
FitProblem usable_part(const FitProblem& whole);

// The step between fitted points, such that at most 1200 are fitted.
std::size_t thinning_of(std::size_t points);
FitProblem thinned(const FitProblem& problem);

struct ConstantFit {
  double mu0;             // [1]
  double standard_error;  // [1] from the correlated residuals and from the bending stiffness
};

// A constant friction by least squares in the force at the measured deflections. The bending
// stiffness stays nominal, with its error added to the interval, because a fitted one would adapt
// to the roughness.
// Domain:     as fit_friction.
// Method:     Gauss-Newton; autocovariance of the scores tapered (Newey & West) over a tenth of the
//             record.
ConstantFit fit_constant(const FitProblem& problem);

enum class ProfileModel {
  roughness,  // a mean, a trend, a random roughness, and a wave if it is detected
  constant,   // the paper's models: μ0
  drift,      // μ0 and a slope along the specimen
  sinusoid,   // (4.25) on a drifting mean
  sinusoids,  // two waves on a drifting mean
};

std::string_view name_of(ProfileModel model);
struct FitOptions {
  ProfileModel model = ProfileModel::roughness;
  SearchOptions search{};
};

// Derivatives of a result in the stated quantities, relative [1] or per span [1/L]
// (changes_in_spans), averaged over the explanations.
using Sensitivities = PerQuantity<double>;

// [1] The additional standard deviation of the mean friction on a soft load train [EI/L^3], where
// the specimen slips unseen from crest to crest. 0.13 up to 10, 0 from 20 on, by simulations
// (docs/validation.md).
double hidden_by_soft_rig(double stiffness);

enum class FrictionFitStatus {
  ok,
  // Fewer than 20 readings are deep enough for friction. Nothing else is valid.
  too_few_points,
  // Some friction explains fewer than 20 of them, or fewer than two thirds (Passages), or nothing
  // slides. Nothing else is valid.
  not_explained,
};

struct FrictionFit {
  FrictionFitStatus status;
  ProfileModel model;
  std::size_t readings;        // that carry information on friction
  double S_begin, S_end;       // [L] sliding lengths between which friction is observed
  ContactPath along;           // of the contacts
  double share = 0.5;          // [1] share_of_sliding
  bool overshoots = false;     // snaps overshoot, as stated or by the record
  double S_middle;             // [L] length between the contacts at the middle, to which phase_at_middle and mu0 refer
  Estimate mu0;                // [1] mean of μ over the observed length
  bool mu0_is_bound;           // friction is indistinguishable from 0: mu0.high is the upper limit (95 %), mu0.low is 0
  double hidden_by_rig = 0;    // [1] the part of its error due to a soft rig
  Estimate drift;              // [1/L] dμ/dS, S between the contacts; 0 for a constant
  Estimate roughness;          // [1] standard deviation of μ about its mean; 0 for the paper's models
  Estimate length;             // [L] correlation length of the roughness; 0 for the paper's models
  Estimate bending_stiffness;  // [1] relative to the nominal one
  // Of mu0 and of ln bending_stiffness; empty for a constant.
  std::optional<Sensitivities> friction_by{}, log_stiffness_by{};
  std::vector<Correlation>
      correlations;                 // over all explanations, or over those with the detected wave; empty for a constant
  Estimate noise;                   // [EI/L^2] standard deviation of a force reading
  double noise_correlation;         // [1] of readings one row apart
  std::vector<WaveEstimate> waves;  // the most probable, largest first, detected or not
  double log_evidence_of_wave;      // ln(evidence with / without a wave); NaN for fixed waves
  bool wave_claimed;                // detected, and shorter than a quarter of the observed length; or fixed
  double shortest_wave;             // [L] shortest detectable wavelength; 0 for a constant
  std::vector<Explanation> explanations;  // most probable first
  std::vector<ScannedWave> scan;          // in order of λ
  ProfileBand band;
  RigCorrection correction;  // for the estimated errors of the rig
  FrictionTable mean;  // the mean of μ against the sliding length, for simulations at the estimated bending stiffness
  std::vector<FrictionTable> draws;    // 20 posterior samples of the profile
  std::vector<double> draw_stiffness;  // [1] relative bending stiffness of each sample
  std::vector<double> force;           // [EI/L^2] of each row of the record, simulated with `mean`
  double residual_rms;                 // [EI/L^2] of `force`, over the readings
  std::vector<double>
      innovations;  // [1] standardised prediction error of each reading from the previous ones; empty for a constant
  Marginal of_mu0, of_log_roughness, of_log_length;  // the latter two only for `roughness`

  // [L] The length between the contacts at a sliding length. Friction along the specimen is a
  // function of it.
  double between_contacts(double S) const { return along.length_at(along.at(S)); }
};

// The estimate of a mean friction, which is not negative. If it is near zero, an upper limit (95
// %).
struct MeanFriction {
  Estimate estimate;
  bool is_bound;
};
MeanFriction mean_friction(const NormalMixture& mixture);

// The total weight of the explanations without roughness; 0 for models without roughness.
double weight_without_roughness(const FrictionFit& fit);

// True if the fit determines a length along the specimen: a detected wave, or roughness with at
// least half of the weight.
bool determines_lengths(const FrictionFit& fit);

// Domain:     as usable_part.
// Fails:      too_few_points, not_explained. Longer records are thinned to 1200 points.
// Cost:       0.1 s at most for 200 points (bench/analyses).
FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options = {});

}  // namespace flexslip
