// The parts and the thresholds of the search for friction along the specimen, each with its unit,
// default and reason.
//
// bench/ablation switches off one part at a time, and halves and doubles each threshold;
// docs/design.md has the results. theory.md has the priors. Tolerances of single equations are in
// the files that solve them.
#pragma once

namespace flexslip {

// The length of an optimisation.
struct Schedule {
  int rounds;       // of optimising the hyperparameters, each followed by Gauss-Newton steps
  int steps;        // Gauss-Newton steps at most
  double fraction;  // [1] of a full step, which overshoots if several gaps depend on the same friction
};

// The parts of the search that can be switched off.
struct SearchParts {
  bool rises = true;                  // start at the rises of the record; without: at the inverted states, sorted
  bool gaps = true;                   // use the bounds of friction in the segments that the specimen skipped
  bool raw_scan = true;               // scan again from the rises if noise blurs the places of readings
  bool trials_from_rises = true;      // also try waves from the rises if noise blurs the places of readings
  bool trials_forward = true;         // also try the two best waves from their simulated loading
  bool smooth_forward = true;         // also start waves without roughness from their simulated loading
  bool polish_plain = true;           // optimise the mode without a wave as long as those with one
  bool plain_from_wave = true;        // also seek the mode without a wave near the mode with one
  bool anneal = true;                 // start jerky friction from noise that hides it, at several EI
  bool exponential_kernel = true;     // compare roughness without a slope, of Matérn 1/2
  bool smooth_kernel = true;          // compare smooth roughness, of Matérn 9/2
  bool no_kernel = true;              // compare friction without roughness
  bool waves_of_kernels = true;       // continue waves to all kernels
  bool second_wave = true;            // seek a second wave if one is detected
  bool converge = true;               // linearise relevant modes until consistent
  bool valley_width = true;           // widen the error of a wavelength along the valley that it shares with the rig
  bool valley_move = true;            // move waves along that valley
  bool fall_curvature = true;         // measure the error of a wavelength where the posterior has fallen by a factor e
  bool scatter = true;                // add the spread of a wavelength between modes to its error
  bool rig_score_correction = true;   // correct for the apparent information of rough friction on the rig
  bool rig_cost = true;               // remove gains of evidence by errors of the rig outside the linearisation
  bool hyperparameter_points = true;  // average over eight points of the hyperparameters; without: their mode alone
  bool hidden_by_rig = true;          // widen the error of friction on soft rigs
};

struct SearchOptions {
  SearchParts parts{};

  // Readings.
  double max_rig_errors = 9;  // combined errors of the rig to estimate; the readings determine no more
  double min_rig_signal = 1;  // [noise variances] a smaller signal of all readings does not determine a combined error
  double rig_places = 100;    // at which errors of the rig are calculated, with interpolation between them
  double beyond_seen = 0.2;   // [inverted range of lengths] limit of fitted states outside it
  double min_force_slope = 0.02;  // [L^2/EI] minimum of dμ/dF: near the straight specimen readings are rounded
  double min_fold = 0.05;  // [1] minimum of G'/G_S in the noise of a reading: at a fold, 0, noise would be infinite

  // Rises, the first guess of the states.
  double rises_noise = 0.002;     // [EI/L^2] minimum noise of the force, for exact records
  double rises_deviation = 3e-5;  // [L] minimum error of a length, for exact records
  double rise_cost = 1.5;         // [ln n] per rise: half of its three parameters, as in BIC

  // Gaps: segments that the specimen skipped.
  double gap_advances = 2.5;    // [advances at constant friction] and
  double gap_noise = 3;         // [errors of a length] a step that exceeds the sum of both is a jump
  double gap_spacing = 40;      // [per range] places where the bound is applied, in a gap
  double min_gap_places = 3;    // per gap: fewer miss its middle
  double max_gap_places = 8;    // per gap: more add nothing
  double gap_margin = 1.5;      // [errors of a length] distance of bounds from the far end of a gap
  double gap_fraction = 0.5;    // [1] of a step of expectation propagation: gaps depend on the same friction
  double gap_accuracy = 0.002;  // [ln evidence] of convergence

  // Gauss-Newton steps.
  double stiffness_errors = 10;  // [prior errors] limit of EI
  double stiffness_step = 0.01;  // [ln EI] longest step within which the linearisation holds
  double rig_step = 0.25;        // [prior errors] longest step of an error of the rig
  double noise_reach = 4;        // [standard deviations] limit of the shift of a reading by noise

  // Hyperparameters.
  double min_noise_seen = 0.2;    // [noise of second differences] minimum of σ: roughness must not explain noise
  double min_noise = 0.0005;      // [EI/L^2] minimum of σ, for exact records
  double theta_step = 1;          // longest step of a logarithm of a hyperparameter
  double theta_spread = 0.05;     // initial variance of a hyperparameter, which sets the first step
  double wave_step = 0.3;         // [λ/range] longest step of ln λ: a third of the resolution
  double wave_spread = 0.01;      // [squares of wave_step] initial variance of ln λ
  double wave_box = 0.15;         // [1] limit of the change of ln λ: other waves have other starts
  double theta_iterations = 8;    // of BFGS per round
  double theta_accuracy = 0.003;  // [ln posterior] of convergence of a round
  double polish_accuracy = 0.05;  // [ln posterior] of convergence of the rounds

  // Annealing, the start of jerky friction.
  double anneal_roughness = 0.1;  // [1] σ_g
  double anneal_length = 0.003;   // [range] ℓ: friction that jumps at stops

  // Waves.
  double min_wave_advances = 4;    // [median advances of a reading] shortest wave
  double min_wave_circles = 1;     // [2π errors of a place] shortest wave: noise makes shorter ones
  double max_wave_share = 2.2;     // [range/λ] longest wave: slightly more than two periods are observed
  double scan_steps = 8;           // [per 1/range] of frequency: a peak is about 1/range wide
  double blur = 1000;              // [per range] larger errors of places blur their order and the peaks of the scan
  double smooth_roughness = 0.03;  // [1] σ_g of a trial with a wave: without a wave, roughness explains it
  double scan_length = 5;          // [per range] ℓ in the scan from the rises
  double trial_length = 10;        // [per range] ℓ of a trial with a wave: its prior median
  double scan_peaks = 2;           // of each scan to try
  double peak_apart = 0.5;         // [λ/range] closer peaks of two scans count as one

  // Selection of modes.
  double out_of_question = -2;  // [ln evidence] loss beyond which a wave is not continued to other kernels
  double far_below = 3;         // [ln evidence] distance from the most probable mode beyond which less is calculated
  double ran_away = 12;         // [ln posterior] loss beyond which steps are reverted
  double much_better = 5;       // [ln posterior] gain that replaces the start

  // Evidence.
  double difference_step = 0.02;  // of hyperparameters, for the curvature of the posterior
  double last_fall = 0.1;         // [1] of ln λ, last step in the search for its error
  double min_eigenvalue = 0.003;  // limits the common stretching of two waves to twenty errors
  double valley_step = 2;         // [errors of ln λ] first step to either side of the valley

  // Simulated loadings of a mode.
  double forward_noise = 3;  // [σ] larger residuals count linearly: they belong to another tooth

  // What is reported.
  double weighs_nothing = 4;  // [ln evidence] less probable explanations (weight 2 %) are left out

  // The correction by rig_score_correction.
  double pull_farthest = 1.5;    // [prior errors of EI] limit of the shift of a mode
  double pull_most = 3;          // [prior errors of EI] limit of the correction
  double pull_most_step = 0.02;  // [ln EI] of the difference, limited by curvature

  // Lengths of optimisations. The states alone are settled first, with twice the steps of a round.
  Schedule from_rises{3, 4, 0.3};      // the mode without a wave, as a start for waves
  Schedule trial{1, 3, 0.5};           // a trial of a wave; most are abandoned
  Schedule trial_forward{1, 4, 0.3};   // a trial from its simulated loading
  Schedule plain{6, 10, 0.3};          // the mode without a wave, for comparison with the best wave
  Schedule wave{4, 8, 0.2};            // the best wave
  Schedule follow{2, 6, 0.3};          // a mode after a change of its kernel or start
  Schedule smooth_forward{3, 6, 0.3};  // a wave without roughness, from its simulated loading
  Schedule pull{3, 6, 0.5};            // a mode at another EI, for rig_score_correction
  Schedule anneal{1, 48, 0.3};   // jerky friction with decreasing noise; with fewer steps, answers depend on rounding
  Schedule annealed{4, 6, 0.3};  // after annealing
  Schedule settle{1, 12, 0.5};   // the states alone
};

}  // namespace flexslip
