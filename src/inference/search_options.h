// The parts and the thresholds of the search for friction along a fibre, each with its unit, default and reason.
//
// bench/ablation switches off one part at a time and tries each threshold at half and at double; docs/design.md has what that showed. The priors of
// the model are in theory.md. Tolerances of single equations, and limits of what can be solved, stand where these are solved.
#pragma once

namespace flexslip {

// The length of an optimisation.
struct Schedule {
  int rounds;       // of moving the hyperparameters uphill, each followed by Gauss-Newton steps
  int steps;        // Gauss-Newton steps at most
  double fraction;  // [1] of a full step, which overshoots where several gaps and readings depend on the same friction
};

// The parts of the search that can be switched off.
struct SearchParts {
  bool rises = true;                  // begin at the rises of the record; without: at the states as read, in order
  bool gaps = true;                   // use the bounds of friction in the gaps that the fibre jumped over
  bool raw_scan = true;               // scan once more from the rises, where noise blurs the places of readings
  bool trials_from_rises = true;      // try waves from the rises, too, where noise blurs the places of readings
  bool trials_forward = true;         // try the two best waves from their own simulated loading, too
  bool smooth_forward = true;         // start waves without roughness from their own simulated loading, too
  bool polish_plain = true;           // optimise the mode without a wave as long as those with one
  bool plain_from_wave = true;        // seek the mode without a wave where that with one is, too
  bool anneal = true;                 // start jerky friction from noise that hides it, at several EI
  bool exponential_kernel = true;     // compare roughness without a slope, of Matérn 1/2
  bool smooth_kernel = true;          // compare smooth roughness, of Matérn 9/2
  bool no_kernel = true;              // compare friction without roughness
  bool waves_of_kernels = true;       // continue waves to all kernels
  bool second_wave = true;            // seek a second wave where one is detected
  bool converge = true;               // linearise likely modes until they agree with themselves
  bool valley_width = true;           // widen the error of a wavelength along the valley that it shares with the rig
  bool valley_move = true;            // move waves along that valley
  bool fall_curvature = true;         // measure the error of a wavelength where the posterior has fallen by a factor e
  bool scatter = true;                // add the spread of a wavelength between modes to its error
  bool rig_score_correction = true;   // correct for what readings of rough friction seem to say of the rig
  bool rig_cost = true;               // give the evidence no gain by errors of the rig where they were not linearised
  bool hyperparameter_points = true;  // average over eight points of the hyperparameters; without: their mode alone
  bool hidden_by_rig = true;          // widen the error of friction on soft rigs
};

struct SearchOptions {
  SearchParts parts{};

  // Readings.
  double max_rig_errors = 9;      // combined errors of the rig that are estimated; the readings determine no more
  double min_rig_signal = 1;      // [noise variances] less, of all readings together, shows nothing of a combined error
  double rig_places = 100;        // at which errors of the rig are calculated; between them they change little
  double beyond_seen = 0.2;       // [range of lengths as read] fitted states lie no farther outside it
  double min_force_slope = 0.02;  // [L^2/EI] least dμ/dF at a stage: near the straight fibre readings are rounded
  double min_fold = 0.05;         // [1] least G'/G_S in the noise of a reading: at 0, a fold, noise would be infinite

  // Rises, the first guess of where the fibre was.
  double rises_noise = 0.002;     // [EI/L^2] least noise of the force: exact records have rises, too
  double rises_deviation = 3e-5;  // [L] least error of a length, likewise
  double rise_cost = 1.5;         // [ln n] a rise more: half of the three numbers that it has, as BIC counts them

  // Gaps, which the fibre jumped over.
  double gap_advances = 2.5;    // [advances at constant friction] and
  double gap_noise = 3;         // [errors of a length] a step of the fibre that exceeds both together is a jump
  double gap_spacing = 40;      // [per range] places where the bound is applied, in a gap
  double min_gap_places = 3;    // in a gap: fewer miss its middle
  double max_gap_places = 8;    // in a gap: more say the same
  double gap_margin = 1.5;      // [errors of a length] no bound so near the far end of a gap, where the reading may be
  double gap_fraction = 0.5;    // [1] of a step of expectation propagation: gaps depend on the same friction
  double gap_accuracy = 0.002;  // [ln evidence] it has converged

  // Gauss-Newton steps.
  double stiffness_errors = 10;  // [prior errors] farther EI does not go
  double stiffness_step = 0.01;  // [ln EI] longest step: the linearisation holds near where it was made
  double rig_step = 0.25;        // [prior errors] longest step of an error of the rig, likewise
  double noise_reach = 4;        // [standard deviations] by which noise moves a reading at most

  // Hyperparameters.
  double min_noise_seen = 0.2;    // [noise of second differences] least σ: roughness must not explain noise
  double min_noise = 0.0005;      // [EI/L^2] least σ, of exact records
  double theta_step = 1;          // longest step of a logarithm of a hyperparameter
  double theta_spread = 0.05;     // variance of a hyperparameter before any is known, which sets the first step
  double wave_step = 0.3;         // [λ/range] longest step of ln λ: a third of what tells two waves apart
  double wave_spread = 0.01;      // [squares of wave_step] variance of ln λ before any is known
  double wave_box = 0.15;         // [1] ln λ stays so near its start: another wave is another start's
  double theta_iterations = 8;    // of BFGS a round
  double theta_accuracy = 0.003;  // [ln posterior] a round has converged
  double polish_accuracy = 0.05;  // [ln posterior] rounds have converged

  // Annealing, the start of jerky friction.
  double anneal_roughness = 0.1;  // [1] σ_g
  double anneal_length = 0.003;   // [range] ℓ: friction that jumps where the specimen stuck

  // Waves.
  double min_wave_advances = 4;  // [advances of a reading, in the median] shortest wave
  double min_wave_circles = 1;   // [2π of what noise moves a place by] shortest wave: noise makes shorter ones
  double max_wave_share = 2.2;   // [range over λ] longest wave: two periods and a little are seen
  double scan_steps = 8;         // [per 1/range] of frequency: a peak is about 1/range wide
  double blur = 1000;  // [per range] noise that moves places by more blurs their order, and peaks of the scan with it
  double smooth_roughness = 0.03;  // [1] σ_g where a wave is tried: that found without a wave explains the wave
  double scan_length = 5;          // [per range] ℓ in the scan from the rises
  double trial_length = 10;        // [per range] ℓ where a wave is tried, its prior median
  double scan_peaks = 2;           // of each scan that are tried
  double peak_apart = 0.5;         // [λ/range] nearer peaks of two scans are the same

  // Which modes are followed.
  double out_of_question = -2;  // [ln evidence] a wave that loses more is not continued to the other kernels
  double far_below = 3;         // [ln evidence] modes farther below the most probable are not followed as far
  double ran_away = 12;         // [ln posterior] steps that lose more are taken back
  double much_better = 5;       // [ln posterior] states that steps must gain to replace the start

  // Evidence.
  double difference_step = 0.02;  // of hyperparameters in the curvature of the posterior, beside rounding
  double last_fall = 0.1;         // [1] of ln λ, where its error is sought last
  double min_eigenvalue = 0.003;  // two waves stretch together by twenty errors of either alone
  double valley_step = 2;         // [errors of ln λ] to both sides along the valley
  double widest_valley = 5;       // [errors of ln λ] beyond, a parabola says nothing

  // Simulated loadings of a mode.
  double forward_noise = 3;  // [σ] residuals beyond count by their size, not its square: they are on another tooth

  // What is reported.
  double weighs_nothing = 4;  // [ln evidence] explanations farther below, of 2 % of the weight, are left out

  // The correction by rig_score_correction.
  double pull_farthest = 1.5;    // [prior errors of EI] a mode that moves farther ran away
  double pull_most = 3;          // [prior errors of EI] by which the correction moves it at most
  double pull_most_step = 0.02;  // [ln EI] of the difference: curvature

  // Lengths of optimisations. The states alone are settled first, in twice the steps of a round.
  Schedule from_rises{3, 4, 0.3};      // of the mode without a wave, which only leads to waves
  Schedule trial{1, 3, 0.5};           // of a wave that is tried: most trials are given up
  Schedule trial_forward{1, 4, 0.3};   // of one that is tried from its own simulated loading
  Schedule plain{6, 10, 0.3};          // of the mode without a wave, which is compared with the best wave
  Schedule wave{4, 8, 0.2};            // of the best wave
  Schedule follow{2, 6, 0.3};          // of a mode after a change of its kernel or of its start
  Schedule smooth_forward{3, 6, 0.3};  // of a wave without roughness, from its own simulated loading
  Schedule pull{3, 6, 0.5};            // of a mode at another EI, for rig_score_correction
  Schedule anneal{
      1, 48, 0.3};  // of jerky friction, while the noise falls: in a third of the steps, answers depend on rounding
  Schedule annealed{4, 6, 0.3};  // thereafter
  Schedule settle{1, 12, 0.5};   // of states alone, to agree with their hyperparameters
};

}  // namespace flexslip
