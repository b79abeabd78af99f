// What all modes together say of friction along the fibre: mixtures, a band, and draws.
#pragma once

#include <span>
#include <vector>

#include "inference/fit.h"
#include "inference/process_mode.h"

namespace flexslip {

// A loading run forward over the readings of a record: which states a friction along the fibre makes them pass.
//
// Modes are found by linearising at states; only states that friction itself lets the fibre visit are worth linearising at, and near a fold,
// where a reading tells almost nothing of the place, that has to be seen to.

struct ForwardStates {
  std::vector<double> S, mu, slope;  // [L], [1], [1/L] dμ/dS at each reading
  std::vector<double> force;         // [EI/L^2] in units of the nominal bending stiffness
};

// Friction on a ladder of lengths around the fibre seen.
class ForwardRun {
 public:
  explicit ForwardRun(const Passages& passages);

  std::span<const double> lengths() const { return S_; }  // [L]
  // Domain:     a value of μ for each length; those outside [0, 2] count as the nearest bound. Stage positions [L] that hardly fall.
  // Max error:  of S a hundredth of the distance of two lengths, away from folds.
  ForwardStates states(std::span<const double> mu, double eta, std::span<const double> stage) const;

 private:
  const Passages& passages_;
  std::vector<double> S_;
};

// A mode with waves linearised where its mean and waves alone make the readings pass, their size, phase and level changed so that the run
// comes closest to the record: a wave read off noisy states is too small, because its crests are folds.
Mode fitted_forward(const FrictionProcess& process, const ForwardRun& run, const Mode& mode);

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
