// The plan of a second loading: how far to load and unload so that it shows whether the drops are
// slips or cracks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "case/test.h"
#include "inference/judgement.h"

namespace flexslip {

// Options that are not part of a case. Units: as in the case.
struct ReloadOptions {
  // [N] standard deviation of a force reading; default: usual_noise of the maximum force
  std::optional<double> noise{};
  std::uint64_t seed = 1;         // for the noise of the simulated records
  unsigned threads = 1;           // plans run in parallel
  double required_chance = 0.95;  // [1] required probability of finding the true cause
};

inline constexpr double usual_noise = 0.001;  // [maximum force] of a typical load cell

// Loading to a stage position, unloading to a force, and loading to the same position again, with
// the expected result.
struct ReloadPlan {
  double travel;      // [m] stage position
  double unload_to;   // [m] stage position at the end of the unloading
  double force;       // [N] at that position
  std::size_t drops;  // detected in the first loading
  // [1] The stiffness loss that the drops require if they are cracks only, and the standard error
  // of the measured loss; NaN if undetermined.
  double loss_needed, loss_error;
  CauseChances chances;
};

// A change that makes the plan sufficient.
struct ReloadChange {
  std::string_view parameter;  // "travel", "stiffness", "step" (design_axis.h) or "noise"
  double from, to;             // [units of the case]
  ReloadPlan plan;
};

struct ReloadStudy {
  double noise;            // [N] as used
  bool noise_is_usual;     // no noise was stated
  double step;             // [m] of the stage, as used; default: 1/300 of the travel
  double required_chance;  // [1] as in the options
  // The number of drops that `fit` would detect in the planned loading: snaps, and smooth decreases
  // that are as steep. If 0, there is nothing to decide, and `plans` and `changes` are empty.
  std::size_t drops;
  // to 0.3, 0.4 ... 1 of the travel, each with five unloadings, the deepest last
  std::vector<ReloadPlan> plans;
  std::vector<ReloadChange> changes;  // each sufficient alone; empty if a plan suffices

  bool suffices(const ReloadPlan& plan) const { return plan.chances.least() >= required_chance; }
  // The shallowest sufficient unloading from the planned travel, or else the most reliable one.
  // Domain:     plans is not empty.
  const ReloadPlan& of_travel() const;
  // The shallowest sufficient unloading from the smallest sufficient travel; empty if no plan
  // suffices.
  std::optional<ReloadPlan> least() const;
};

// Domain:     a test as one_loading_of (design_result.h) returns it; 0 < required_chance < 1;
//             noise > 0; std::invalid_argument otherwise.
// Max error:  measured on 240 records of four plans with random errors of the rig. Where the
//             predicted probability of the right verdict was 1.00, the observed share was 0.93 to
//             1.00. For a plan with two drops, predicted 0.81 was observed as 0.83 (cracks), and
//             predicted 0.70 as 1.00 (slips) (bench/causes/decide.py --records 30).
// Fails:      throws InputError as simulate (case/simulated_test.h). A specimen that breaks or
//             slips through is loaded to 95 % of that stage position.
// Method:     each plan is simulated with noise of one seed, then prepared and fitted like a record
//             (fit_passes_of, case/fitted.h). Only the error of the loss and the loss required by
//             the drops are used, not the fitted loss. Errors of the rig are stated in the case, or
//             default.
// Cost:       up to 40 fits of about 0.1 s, and four more if no plan suffices.
ReloadStudy reload_study(const Test& loading, const ReloadOptions& options);

}  // namespace flexslip
