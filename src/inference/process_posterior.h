// The posterior of friction along the specimen from all modes: mixtures, a band, and samples.
#pragma once

#include <span>
#include <vector>

#include "inference/fit.h"
#include "inference/process_search.h"

namespace flexslip {

struct WeightedDraw {
  double value, weight;
};

// A posterior sample of a wave and the parameters correlated with it.
struct WaveDraw {
  double weight;
  double log_wavelength;
  double cosine, sine;  // [1] of 2πx/λ, x from the middle of the observed length
  double mean;          // [1] of μ over the observed length
  JointPart beside;     // the other parameters, without a covariance
};

struct WavePosterior {
  double log_wavelength;  // of the most probable mode
  std::vector<WaveDraw> draws;
};

struct ProcessPosterior {
  double S_begin, S_end;                        // [L] the observed length, by the most probable mode
  NormalMixture mean;                           // [1] of μ over the observed length
  NormalMixture drift;                          // [1/L] dμ/dS
  Sensitivities friction_by, log_stiffness_by;  // of the mean, and of ln EI
  NormalMixture log_roughness, log_length, log_stiffness, log_noise;
  std::vector<JointPart> joint;  // without waves
  std::vector<double> rig;       // errors of the rig over their standard deviations, as Passages::rig_errors
  double noise_correlation;
  std::vector<WavePosterior> waves;  // of the modes with the most probable waves, one entry per wave
  double log_evidence_of_wave;       // of the evidence ratio with and without a wave
  double carried_by_readings;        // upper limit of log_evidence_of_wave
  std::vector<Explanation> explanations;
  std::vector<double> innovations;  // [1] of the readings, by the most probable mode
  ProfileBand band;
  FrictionTable profile;             // the mean of the band, not negative
  std::vector<FrictionTable> draws;  // 20
  std::vector<double> draw_stiffness;
};

// Domain:     components not empty, the most probable first.
// Method:     each relevant component is Gaussian about its mode. Samples come from a generator
//             with a fixed seed.
ProcessPosterior posterior_of(const FrictionProcess& process, std::span<const Component> components);

}  // namespace flexslip
