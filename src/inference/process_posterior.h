// What all modes together say of friction along the fibre: mixtures, a band, and draws.
#pragma once

#include <cstddef>
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
};

struct WavePosterior {
  double log_wavelength;  // of the likeliest mode
  std::vector<WaveDraw> draws;
};

struct ProcessPosterior {
  double S_begin, S_end;  // [L] the fibre seen, by the likeliest mode
  NormalMixture mean;     // [1] of μ over it
  NormalMixture drift;    // [1/L] dμ/dS
  NormalMixture log_roughness, log_length, log_stiffness, log_noise;
  double noise_correlation;
  std::vector<WavePosterior> waves;  // of the modes with the likeliest waves, wave by wave
  double log_evidence_of_wave;       // with over without
  std::vector<Explanation> explanations;
  std::vector<double> innovations;  // [1] of the readings, by the likeliest mode
  ProfileBand band;
  FrictionTable profile;             // the mean of the band, not negative
  std::vector<FrictionTable> draws;  // 20
  std::vector<double> draw_stiffness;
};

// Domain:     components not empty, likeliest first.
// Method:     Each component that weighs anything is taken at eight points of its hyperparameters, by their merit; between these all is
//             Gaussian. Draws come from a generator with a stated seed.
ProcessPosterior posterior_of(const FrictionProcess& process, std::span<const Component> components);

// The force at stage positions, each beyond the last, that friction along the fibre gives.
// Domain:     table of at least two lengths.
std::vector<double> forces_of(const FrictionTable& friction, const Rig& rig, std::span<const double> stages);

}  // namespace flexslip
