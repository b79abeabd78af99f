// The analysis of one measured test: its friction along the specimen with errors, its drops, and
// the work of friction. Inputs are in SI units, results in reduced variables with their Scales.
//
// An evaluation calls find_contact, fit_passes if the record reloads, analyse and judge.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "bending_test/rig.h"
#include "data/drops.h"
#include "data/record.h"
#include "data/record_statistics.h"
#include "data/scales.h"
#include "inference/checks.h"
#include "inference/drop_features.h"
#include "inference/fit.h"
#include "inference/passes.h"
#include "inference/profile.h"
#include "numerics/elementary.h"

namespace flexslip {
// ---- Before a fit

// True if sliding with non-negative friction can explain the record: at least four fifths of the
// points beyond min_judged_deflection have a friction of min_friction or more (profile.h). The
// bending stiffness may differ from that of the scales by two standard errors.
// Domain:     bending_stiffness_error >= 0 [1]; rig.stiffness in units of the scales.
bool is_consistent_with_sliding(const Record& record, const Scales& scales, const Rig& rig,
                                double bending_stiffness_error);

// Measured force / frictionless force at the same deflection, beyond min_judged_deflection.
struct FrictionlessForceRatio {
  double median = not_a_number, least = not_a_number;  // [1] NaN without points
};

// Max error:  1e-4.
FrictionlessForceRatio frictionless_force_ratio(const ReducedRecord& record, const Fibre& fibre);

// The bending stiffness from the initial slope, EI = (F/w) L^3/48.
struct StiffnessFromSlope {
  bool found = false;  // to max_stiffness_error or better; if not, nothing else is valid
  double value = 0;    // [N m^2] EI
  // [1] standard deviation, with 3 % for friction and large deflection; without contact and load train
  double relative_error = 0;
  double deflection = 0;  // [m] an error of the contact divided by it is the relative error of EI
};

// Domain:     stage and deflection measured from the contact point; span [m] > 0.
// Method:     least squares of force against deflection, over the points of initial_line.
StiffnessFromSlope stiffness_from_slope(const Record& record, double span);

// [1] The default error of a bending stiffness, from a data sheet and a diameter known to 0.5 %.
inline constexpr double default_stiffness_error = 0.03;
// [1] The default error of a modulus whose section has a stated error: no 2 % from the diameter.
inline constexpr double default_modulus_error = 0.022;

// A test, apart from its readings.
struct TestDescription {
  double span;                  // [m]
  double load_train_stiffness;  // [N/m] including compliant supports; infinite for displacement control
  double bending_stiffness;     // [N m^2] EI
  double bending_stiffness_error = default_stiffness_error;  // [1] standard deviation
  std::optional<double> contact_error{};                     // [m] standard deviation; default: default_contact_error
  Fibre fibre{};                                             // the specimen on its supports
  Nose nose = Nose::holds;
  std::optional<SnapRest> snaps{};  // default: as the record shows
  RigErrors rig_errors{};
  std::optional<PassesFit> passes{};  // the fit of all passes, if the record has several
};

struct AnalysisOptions {
  FitOptions fit;
  DropOptions drops;
  double suspect_limit = 1.0;      // [1] friction above this is implausible
  double max_friction = infinity;  // [1] limit set by the supports, such as rollers that turn on their pins
};

// How clear the sawtooth is, by a fixed rule on the drops (theory.md, "Categories").
enum class SawtoothCategory { clear, nominal, none };

// The energy account of the measured test from contact to failure, at the fitted EI [EI/L].
// friction = ∫ μ P_n dS while sliding, snaps = all energy lost in drops, by the measured points.
struct MeasuredEnergy {
  EnergyAccount account;    // its imbalance is not set
  double work_of_fracture;  // ∫ F dw0, the area under the curve, commonly reported as toughness
  double friction_share;    // [1] (friction + snaps)/work_of_fracture; NaN if friction is only a limit
  // [1] Standard deviation due to errors of the rig; NaN without a share or for a constant friction.
  double friction_share_error = not_a_number;

  // [1] The share with its 95 % interval within [0, 1], and its one-sided lower limit of 95 %.
  Estimate share() const;
  double least_share() const;
};

// The measured friction profile used as a table in a simulation of the test.
struct Replay {
  std::vector<double> force;  // [EI/L^2] per point; NaN for w <= 0.05 and, on rollers, w > 1
};

// Friction inverted point by point at the fitted EI: median and range of the middle 80 %.
struct PointwiseFriction {
  double median = not_a_number, low80 = not_a_number, high80 = not_a_number;  // [1]
};

// With fewer points the noise, and therefore the drops, cannot be determined.
inline constexpr std::size_t min_fitted_points = 30;

enum class AnalysisStatus {
  ok,
  // Fewer than 20 readings beyond min_fit_deflection. Nothing from the fit on is valid.
  deflection_too_small,
  // Sliding explains fewer than 20 of them, or fewer than two thirds. Nothing from the fit on is valid.
  not_explained,
};

struct TestAnalysis {
  AnalysisStatus status;
  Scales scales;  // from the nominal bending stiffness
  Rig rig;
  double bending_stiffness_error;   // [1] as used
  double stiffness_to_slope_ratio;  // [1] bending stiffness used / from the initial slope; NaN without a slope
  bool stiffness_implausible;       // the two differ by more than 40 % and by more than two standard errors
  // The fit misses the force by a tenth of its maximum, or is_consistent_with_sliding is false.
  bool model_implausible = false;
  FrictionlessForceRatio frictionless_force_ratio{};  // at the nominal bending stiffness
  Record record;
  ReducedRecord reduced;
  double force_noise = not_a_number;  // [EI/L^2] standard deviation of one reading
  MeasurementErrors errors{};         // as used in the fit
  RigErrors rig_errors{};             // as used in the fit
  Drops drops{};
  RecordStatistics statistics{};  // of the record and its drops
  FrictionProfile profile{};
  // The verdicts hold at the stated bending stiffness; lengths and frictions at the fitted one.
  std::vector<Slip> slips{};
  double max_friction = infinity;  // [1] as in the options
  SlipSummary slip_summary{};
  std::optional<PassesFit> passes{};  // as in the description
  DropFeatures drop_features{};       // for any status
  SuspectReport suspects{};
  FrictionFit fit{};
  FrictionProfile profile_at_fit{};        // at the fitted bending stiffness, for w > 0.05
  PointwiseFriction pointwise_friction{};  // of profile_at_fit
  std::vector<Check> checks{};
  // The mean of the fit, simulated at the stages of the record, in units of the fitted EI.
  TestPath model{};
  Replay replay{};
  MeasuredEnergy energy{};
  std::optional<Sensitivities> work_share_sensitivities{};  // of energy.friction_share, if it exists
  SawtoothCategory category = SawtoothCategory::none;
};

// Domain:     one loading up to failure, measured from the contact point, of min_fitted_points or
//             more, without faults (check_record); span and stiffness positive;
//             std::invalid_argument otherwise.
// Cost:       at most 200,000 states (numerics/effort.h) for each of 1300 rows, and 500 for each row
//             of the record; on rollers or with a thickness 60 million more, for simulations.
TestAnalysis analyse(const Record& record, const TestDescription& description, const AnalysisOptions& options = {});

// The analysis without a fit. Only scales, rig, readings, drops, their features, slips and passes are
// valid.
TestAnalysis analyse_drops(const Record& record, const TestDescription& description,
                           const AnalysisOptions& options = {});

// True if the record requires more friction than the supports allow or than the suspect limit.
// Domain:     analysis.status is ok.
bool is_friction_implausible(const TestAnalysis& analysis);

// [1] By how much a loss of this share of the bending stiffness hides the mean friction. The loss
// grows evenly up to half of the largest deflection.
// Domain:     analysis.status is ok; 0 <= loss < 1; std::invalid_argument otherwise.
// Fails:      NaN if no point can be inverted both with and without the loss.
double friction_underestimate(const TestAnalysis& analysis, double loss);

// ---- Curves for figures, in reduced variables of the nominal bending stiffness

// The frictionless curve up to the largest deflection or beyond, at the fitted (else stated) EI.
// Domain:     analysis.status is ok or not_explained.
std::vector<EquilibriumPoint> frictionless_curve(const TestAnalysis& analysis);

// [EI/L^2] The force of linear beam theory at a deflection [L], at the same bending stiffness.
double euler_bernoulli_force(const TestAnalysis& analysis, double deflection);

// The mean of the fit, simulated with a continuously moving stage.
// Domain:     analysis.status is ok.
TestPath simulated_mean_fit(const TestAnalysis& analysis);

// The detected waves of friction about its mean and trend, against the sliding length. Empty if no
// wave was detected.
// Domain:     analysis.status is ok.
struct FittedFriction {
  double S, mu;  // [L], [1]
};
std::vector<FittedFriction> detected_waves(const TestAnalysis& analysis);

}  // namespace flexslip
