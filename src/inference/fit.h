// Which friction along the fibre explains a measured curve, and how certainly.
//
// Friction is a mean, perhaps with a drift and a wave, and a random roughness about it (process_mode.h). The record tells of it through first
// passages; every answer is an average over how smooth the roughness may be and over the waves that may be there. The paper's own models,
// without roughness, are fitted on the same likelihood. Reduced variables of the nominal bending stiffness.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "contact/friction.h"
#include "data/estimate.h"
#include "fibre/contact_travel.h"
#include "inference/explanation.h"
#include "inference/fit_problem.h"

namespace flexslip {

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
};

enum class FrictionFitStatus {
  ok,
  too_few_points,  // fewer than 20 readings are deep enough to tell of friction: nothing else is valid
  not_explained,  // fewer than 20 of them, or than two in three, are such as friction between 0 and 2 gives, or the fibre passes nothing: nothing else is valid
};

// A record tells how much of the fibre lies between the supports, and lengths along it as if it slid over both at once. Where it slides over one
// at a time they are up to so many times as long (theory.md, "Two supports").
inline constexpr double one_side_at_a_time = 2;

struct FrictionFit {
  FrictionFitStatus status;
  ProfileModel model;
  std::size_t readings;   // that tell of friction
  double S_begin, S_end;  // [L] the fibre seen, by what has been drawn in
  ContactTravel along;    // where its contacts were then
  double S_middle;     // [L] between the contacts midway: where phase_at_middle is meant, and mu0 with drift and wave
  Estimate mu0;        // [1] mean of μ over the fibre seen
  bool mu0_is_bound;   // the record does not tell it from 0: mu0.high is an upper limit of 95 %, mu0.low is 0
  Estimate drift;      // [1/L] dμ/dS, S between the contacts; 0 of a constant
  Estimate roughness;  // [1] standard deviation of μ about its mean; 0 of the paper's models
  Estimate length;     // [L] correlation length of it along the fibre; likewise
  Estimate bending_stiffness;       // [1] relative to the nominal one
  Estimate noise;                   // [EI/L^2] standard deviation of a force reading
  double noise_correlation;         // [1] of readings one row apart
  std::vector<WaveEstimate> waves;  // the likeliest, the largest first, claimed or not
  double
      log_evidence_of_wave;  // ln of the evidence with a wave over that without; NaN of models that have a wave or cannot
  bool
      wave_claimed;  // it exceeds 3, and the wave is shorter than a quarter of the fibre seen; true of models that have one
  std::vector<Explanation> explanations;  // likeliest first
  std::vector<ScannedWave> scan;          // λ rising
  ProfileBand band;
  FrictionTable mean;  // the mean of μ over what is drawn in, for runs forward: at the estimated bending stiffness
  std::vector<FrictionTable> draws;    // profiles that explain the record as well, drawn at random (20), likewise
  std::vector<double> draw_stiffness;  // [1] relative bending stiffness of each
  std::vector<double> force;           // [EI/L^2] at each stage position of the record, `mean` run forward
  double residual_rms;                 // [EI/L^2] of it, over the readings that tell of friction
  std::vector<double>
      innovations;  // [1] what each reading adds to what those before it tell, over its standard deviation; empty of a constant
  Marginal of_mu0, of_log_stiffness, of_log_roughness, of_log_length;  // the latter two only of `roughness`

  // [L] Between the contacts, of the fibre drawn in to a length: what friction along the specimen is a function of.
  double between_contacts(double S) const { return along.length_at(along.at(S)); }
};

// The weight of the explanations without roughness; 0 of a model that has none by itself.
double weight_without_roughness(const FrictionFit& fit);

// A length along the fibre that a fit tells.
struct FittedLength {
  std::string_view name;  // "wavelength" or "correlation_length"
  double value;           // [L]
};
// Of each wave that is claimed, and of roughness where there is some: a fit whose explanations have none by more than half tells none.
std::vector<FittedLength> lengths_of(const FrictionFit& fit);

// Domain:     a record without faults, stage not falling; rig.stiffness > 0; errors >= 0, that of EI at most 0.3; std::invalid_argument otherwise.
// Fails:      too_few_points, not_explained. Of more than 1200 points every so many are fitted.
// Cost:       0.1 s at most for 200 points (bench/analyses).
FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options = {});

}  // namespace flexslip
