// Before a test: how far to load and to unload a specimen for a second loading to tell whether its drops are slips or cracks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "case/test.h"
#include "inference/judgement.h"

namespace flexslip {

// What of a test to plan is no part of its case. Units: those of the case.
struct ReloadOptions {
  std::optional<double> noise{};  // [N] standard deviation of a force reading; none: usual_noise of the greatest force
  std::uint64_t seed = 1;         // of the noise of the records
  unsigned threads = 1;           // on which plans are tried
  double least_chance = 0.95;     // [1] of finding the true cause, with which a plan suffices
};

inline constexpr double usual_noise = 0.001;  // [greatest force] of a load cell

// Loading to a stage position, unloading to a force, and loading to the same position again; and what FlexSlip would find of it.
struct ReloadPlan {
  double travel;      // [m] stage position
  double unload_to;   // [m] stage position where the unloading ends
  double force;       // [N] there
  std::size_t drops;  // that are found in the first loading
  // [1] of the stiffness that the drops need if they are cracks only, and that of the error of the loss told; NaN where it tells none
  double loss_needed, loss_error;
  CauseChances chances;
};

// A change of the plan with which it suffices.
struct ReloadChange {
  std::string_view parameter;  // "travel", "stiffness", "step" (design_axis.h) or "noise"
  double from, to;             // [units of the case]
  ReloadPlan plan;
};

struct ReloadStudy {
  double noise;         // [N] as used
  bool noise_is_usual;  // as none is stated
  double step;          // [m] of the stage, as used: 1/300 of the travel of a case without one
  double least_chance;  // [1] as in the options
  std::size_t
      drops;  // that `fit` would find in the planned loading: snaps, and smooth falls as steep. Without any there is nothing to decide,
              // and nothing below
  std::vector<ReloadPlan> plans;      // to 0.3, 0.4 ... 1 of the travel, each with five unloadings, the deepest last
  std::vector<ReloadChange> changes;  // any one of which suffices, if no plan does

  bool suffices(const ReloadPlan& plan) const { return plan.chances.least() >= least_chance; }
  // Of the planned travel, the shallowest unloading that suffices, or else the surest one.
  // Domain: there are plans.
  const ReloadPlan& of_travel() const;
  // Of the least travel that suffices, the shallowest unloading that does; none if none does.
  std::optional<ReloadPlan> least() const;
};

// Domain:     a test as one_loading_of (design_result.h) gives it; 0 < least_chance < 1, noise > 0; std::invalid_argument otherwise.
// Max error:  of 240 records of four plans, made with errors of the rig drawn anew, the share with the right verdict: told 1.00, 0.93 to 1.00; of a
//             plan with two drops told 0.81, 0.83 (cracks), and told 0.70, 1.00 (slips) (bench/causes/decide.py --records 30).
// Fails:      InputError as simulate (case/simulated_test.h). A specimen that breaks or slips through is loaded to 95 % of the stage position.
// Method:     each plan is simulated with the noise of one seed, prepared and fitted as a record (fit_passes_of, case/fitted.h). Of the fit only the
//             error of the loss and the loss that the drops need count, not the loss told. Errors of the rig are those that the case states, or the usual ones.
// Cost:       up to 40 fits of about 0.1 s, and four more where none suffices.
ReloadStudy reload_study(const Test& loading, const ReloadOptions& options);

}  // namespace flexslip
