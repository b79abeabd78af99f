// Which friction along the fibre explains a measured curve, and how certainly.
//
// The models are fitted to F(w_s), the force at the stage position that the experiment controls, on the curve that a test
// measures, jumps included. The bending stiffness is unknown within its prior and estimated along. Residuals of real tests are
// correlated from point to point, because no model follows the roughness exactly; they are taken as an AR(1) process whose
// correlation is estimated, in the likelihood, in BIC and in the standard errors alike (theory.md, "Residuals").
#pragma once

#include <string_view>
#include <vector>

#include "contact/friction.h"
#include "inference/fit_problem.h"
#include "inference/wavelength_scan.h"

namespace flexslip {

enum class ProfileModel {
  constant,   // μ0
  drift,      // μ0 and a slope along the fibre
  sinusoid,   // (4.25) on a drifting mean
  sinusoids,  // two or three waves on a drifting mean
};

std::string_view name_of(ProfileModel model);

struct FitOptions {
  std::vector<ProfileModel> models = {ProfileModel::constant, ProfileModel::drift, ProfileModel::sinusoid,
                                      ProfileModel::sinusoids};
  HeldValues held{};
};

struct ParameterEstimate {
  double value;
  double standard_error;
  double low, high;  // 95 % interval
};

struct Interval {
  double low, high;
};

struct WaveEstimate {
  ParameterEstimate amplitude;                // [1] A, relative to mu0
  ParameterEstimate wavelength;               // [L] λ
  ParameterEstimate phase;                    // [rad] φ of (4.25), at S = 0: strongly correlated with λ
  ParameterEstimate phase_at_middle;          // [rad] π S_middle/λ + φ, which is not
  std::vector<Interval> other_wavelengths{};  // [L] apart from that interval, what 95 % do not exclude either
};

// Another local maximum of the likelihood in the wavelength of a model's last wave.
struct RunnerUp {
  double wavelength;            // [L]
  double amplitude;             // [1]
  double phase;                 // [rad] at S = 0
  double delta_log_likelihood;  // [1] less than the best by; negative
  double residual_rms;          // [EI/L^2]
};

enum class FitStatus {
  ok,
  not_converged,  // the last step still changed the fit: the values are those reached
  not_found,      // no wave fits often enough into the slip seen: only model and status are valid
};

struct ModelFit {
  ProfileModel model;
  FitStatus status;
  FrictionWaves friction;   // ready for forward calculation
  ParameterEstimate mu0;    // [1] mean friction in the middle of the data
  ParameterEstimate drift;  // [1/L] dμ/dS of the mean
  std::vector<WaveEstimate> waves;
  std::vector<RunnerUp> runners_up;     // best first, at most five, of the chosen model and of one wave
  ParameterEstimate bending_stiffness;  // [1] relative to the nominal one
  std::vector<double> force;            // [EI/L^2] at each stage position of the record
  double residual_rms;                  // [EI/L^2]
  double correlation;                   // [1] of neighbouring residuals
  double innovation;                    // [EI/L^2] standard deviation of what is left without the correlation
  double effective_points;              // [1] independent observations that the residuals are worth
  int parameters;                       // without the bending stiffness, which has a prior
  double log_likelihood, aic, bic;
};

enum class FrictionFitStatus {
  ok,
  too_few_points,  // fewer than 20 points with a deflection above 0.05: nothing else is valid
};

struct FrictionFit {
  FrictionFitStatus status;
  double S_middle;               // [L] where mu0 and phase_at_middle are meant
  std::vector<ModelFit> models;  // in the order asked for
  std::size_t chosen;            // the one of least BIC
  WavelengthScan scan;           // of the profile; runner-up wavelengths among its candidates
};

// Domain:     a record without faults, stage not falling; rig.stiffness > 0; errors >= 0, that of EI at most 0.3; std::invalid_argument otherwise.
// Fails:      too_few_points. Deflections beyond 0.8 are left out; of more than 600 points every so many are fitted.
// Method:     the constant by least squares in F at the measured deflections, bending stiffness nominal (its error is carried
//             into the interval: a constant would bend the stiffness to suit the roughness). The others: wavelengths from
//             scan_wavelengths, each refined on F(w_s) by Levenberg-Marquardt from several starts, with a loss that first caps the
//             residuals, because they jump where a drop shifts past a point; then searches along the axes of the error ellipsoid.
// Cost:       less than 0.1 s for 300 points.
FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options = {});

}  // namespace flexslip
