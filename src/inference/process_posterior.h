// What all modes together say of friction along the fibre: mixtures, a band, and draws.
#pragma once

#include <span>
#include <vector>

#include "inference/fit.h"
#include "inference/process_search.h"

namespace flexslip {

struct WeightedDraw {
  double value, weight;
};

// A wave of a mode with what goes with it, drawn at random.
struct WaveDraw {
  double weight;
  double log_wavelength;
  double cosine, sine;  // [1] of 2πx/λ, x from the middle of the fibre seen
  double mean;          // [1] of μ over the fibre seen
  JointPart beside;     // all but the wave; without a covariance
};

struct WavePosterior {
  double log_wavelength;  // of the likeliest mode
  std::vector<WaveDraw> draws;
};

struct ProcessPosterior {
  double S_begin, S_end;                        // [L] the fibre seen, by the likeliest mode
  NormalMixture mean;                           // [1] of μ over it
  NormalMixture drift;                          // [1/L] dμ/dS
  Sensitivities friction_by, log_stiffness_by;  // of the mean; of ln EI
  NormalMixture log_roughness, log_length, log_stiffness, log_noise;
  std::vector<JointPart> joint;  // all but waves
  std::vector<double> rig;       // its errors, each over its standard deviation: Passages::rig_errors
  double noise_correlation;
  std::vector<WavePosterior> waves;  // of the modes with the likeliest waves, wave by wave
  double log_evidence_of_wave;       // with over without
  double carried_by_readings;        // the most it can be
  std::vector<Explanation> explanations;
  std::vector<double> innovations;  // [1] of the readings, by the likeliest mode
  ProfileBand band;
  FrictionTable profile;             // the mean of the band, not negative
  std::vector<FrictionTable> draws;  // 20
  std::vector<double> draw_stiffness;
};

// Domain:     components not empty, likeliest first.
// Method:     Each component that weighs anything is Gaussian about its mode. Draws come from a generator with a stated seed.
ProcessPosterior posterior_of(const FrictionProcess& process, std::span<const Component> components);

}  // namespace flexslip
