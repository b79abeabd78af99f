// One measured test from its record to its answers: what friction, where along the specimen, how certainly, which drops are
// slips, and how much of the work was friction; and what is known without a fit: may it slide, how stiff is it. SI in, everything of the model in reduced variables with their Scales beside.
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

// Can a record be sliding with friction at all?

// Do four fifths of the points past the deflection min_judged_deflection have a friction of min_friction or more (profile.h), at the bending stiffness of
// the scales or one that differs from it by twice its error?
// Domain:     bending_stiffness_error >= 0 [1]; the stiffness of the rig is in units of the scales.
bool is_consistent_with_sliding(const Record& record, const Scales& scales, const Rig& rig,
                                double bending_stiffness_error);

// The force over that without friction at the same deflection, past the deflection min_judged_deflection.
struct FrictionlessForceRatio {
  double median = not_a_number, least = not_a_number;  // [1] NaN without such points
};

// Max error:  1e-4.
FrictionlessForceRatio frictionless_force_ratio(const ReducedRecord& record, const Fibre& fibre);

// The bending stiffness of a specimen, as far as it is known without a fit.

// Bending stiffness from the initial slope, F = 48 EI w/L^3.
struct StiffnessFromSlope {
  bool found = false;  // a first rise tells EI to max_stiffness_error; nothing else is valid without
  double value = 0;    // [N m^2] EI
  // [1] standard deviation: that of the slope, 3 % that friction and large deflection bend it, and 3 %; without that of contact and load train
  double relative_error = 0;
  double deflection = 0;  // [m] by which an error of the contact is divided in EI
};

// Domain:     stage and deflection counted from the contact; span [m] > 0.
// Method:     force over deflection by least squares, through the contact, over the points of the initial_line.
StiffnessFromSlope stiffness_from_slope(const Record& record, double span);

// The uncertainty of a bending stiffness that is stated without one [1]: a data sheet and a diameter to 0.5 % give no better.
inline constexpr double default_stiffness_error = 0.03;
// And of a modulus beside a section whose uncertainty is stated: what the diameter to 0.5 %, which is 2 % of EI, leaves of it.
inline constexpr double default_modulus_error = 0.022;

// What is known of a test besides its record.
struct TestDescription {
  double span;                  // [m]
  double load_train_stiffness;  // [N/m] with that of the supports, if they give way; infinite for displacement control
  double bending_stiffness;     // [N m^2] EI
  double bending_stiffness_error = default_stiffness_error;  // [1] standard deviation
  std::optional<double>
      contact_error{};  // [m] standard deviation of the contact point; not given: default_contact_error
  Fibre fibre{};        // on its supports
  Nose nose = Nose::holds;
  std::optional<SnapRest> snaps{};  // not given: as the record shows
  RigErrors rig_errors{};
  std::optional<PassesFit> passes{};  // of all passes of the record, where it has several
};

struct AnalysisOptions {
  FitOptions fit;
  DropOptions drops;
  double suspect_limit = 1.0;      // [1] friction above it is implausible
  double max_friction = infinity;  // [1] that the supports let act: rollers that turn on their pins
};

// How the curve looks, by a fixed rule on its drops (theory.md, "Categories").
enum class SawtoothCategory { clear, nominal, none };

// A test in energies, from contact to failure [EI/L]. As EnergyAccount, from the measured points, at the bending stiffness of the fit: friction = ∫ μ P_n dS while the
// fibre slides, snaps all that is lost in drops, where a test cannot tell friction from noise and vibration; that the account does not close
// tells how coarse the points are.
struct MeasuredEnergy {
  EnergyAccount account;    // without its imbalance
  double work_of_fracture;  // ∫ F dw0: what is read off a curve as toughness times area
  double friction_share;    // [1] (friction + snaps)/work_of_fracture; NaN where friction is only a limit, or cannot be
  // [1] Its standard deviation by all that the rig is off by; NaN without a share, and of smooth friction that is fitted as a constant.
  double friction_share_error = not_a_number;

  // [1] 95 % lie between low and high, none beyond 0 and 1; and the share that there is with a probability of 95 % at least.
  Estimate share() const;
  double least_share() const;
};

// The measured profile run forward as a table.
struct Replay {
  std::vector<double>
      force;  // [EI/L^2] at the points of the record past the deflection 0.05, on supports up to 1; NaN elsewhere
};

// Friction as read off the curve point by point at the bending stiffness of the fit: half of the points lie below the median, four
// fifths between the other two. NaN without points.
struct PointwiseFriction {
  double median = not_a_number, low80 = not_a_number, high80 = not_a_number;  // [1]
};

// Fewer do not tell the noise, and so no drops.
inline constexpr std::size_t min_fitted_points = 30;

enum class AnalysisStatus {
  ok,
  deflection_too_small,  // fewer than 20 readings lie past min_fit_deflection (first_passages.h): nothing from the fit on is valid
  not_explained,  // there are such points, but fewer than 20, or than two in three, that sliding with any friction gives: nothing from the fit on is valid
};

struct TestAnalysis {
  AnalysisStatus status;
  Scales scales;  // nominal
  Rig rig;
  double bending_stiffness_error;   // [1] as used
  double stiffness_to_slope_ratio;  // [1] bending stiffness used over that of the initial slope; NaN without a slope
  bool stiffness_implausible;       // they differ by more than 40 % and twice its error
  // The fit misses the record by more than a tenth of its greatest force, or it may not slide (is_consistent_with_sliding).
  bool model_implausible = false;
  FrictionlessForceRatio frictionless_force_ratio{};  // beforehand
  Record record;
  ReducedRecord reduced;
  double force_noise = not_a_number;  // [EI/L^2] of one reading
  MeasurementErrors errors{};         // as fitted with
  RigErrors rig_errors{};             // likewise
  Drops drops{};
  RecordStatistics statistics{};  // of the record and its drops
  FrictionProfile profile{};
  // Judged at the bending stiffness stated, told at that of the fit.
  std::vector<Slip> slips{};
  double max_friction = infinity;  // [1] as in the options
  SlipSummary slip_summary{};
  std::optional<PassesFit> passes{};  // as in the description
  DropFeatures drop_features{};       // whatever the status
  SuspectReport suspects{};
  FrictionFit fit{};
  FrictionProfile profile_at_fit{};        // at the bending stiffness of the fit, past the deflection 0.05
  PointwiseFriction pointwise_friction{};  // of it
  std::vector<Check> checks{};
  // The mean of the fit on the stage positions of the record, at the estimated bending stiffness: work and energies are in units of that.
  TestPath model{};
  Replay replay{};
  MeasuredEnergy energy{};
  std::optional<Sensitivities>
      work_share_sensitivities{};  // of energy.friction_share; none of a constant, and where there is none
  SawtoothCategory category = SawtoothCategory::none;
};

// Domain:     one loading up to the failure of at least min_fitted_points, counted from the contact, without faults (check_record); span and
//             stiffness positive; std::invalid_argument otherwise.
// Cost:       that of the fit: at most 200,000 states (numerics/effort.h) for each row fitted, at most 1200 of them, and for 100 more; 500 for each row of
//             the record; on supports 60 million besides, as 20 draws and the mean are run forward through up to 10,000 lengths each.
TestAnalysis analyse(const Record& record, const TestDescription& description, const AnalysisOptions& options = {});

// What is known of it without a fit: scales, rig, readings, drops and their features, slips, passes. Nothing else is valid.
// Domain:     as analyse.
TestAnalysis analyse_drops(const Record& record, const TestDescription& description,
                           const AnalysisOptions& options = {});

// Does the record need more friction than its supports let act, or than the suspect limit?
// Domain:     analysis.status is ok.
bool is_friction_implausible(const TestAnalysis& analysis);

// [1] By how much the friction read off a record, averaged over the length that slid, would be larger if that share of the bending stiffness had been lost by
// its middle, the half of its deepest deflection, evenly until there. A loss lowers the force, which reads as less friction.
// Domain:     analysis.status is ok; 0 <= loss < 1, std::invalid_argument otherwise. NaN where no point can be read off both ways.
double friction_underestimate(const TestAnalysis& analysis, double loss);

// What a figure of an analysis shows beside the record: curves of the same specimen on the same rig. Reduced variables of the nominal bending
// stiffness.

// Without friction up to the greatest deflection of the record or beyond, from the straight specimen on; at the bending stiffness of the fit, or,
// where there is no fit, that stated.
// Domain:     analysis.status is ok or not_explained.
std::vector<EquilibriumPoint> frictionless_curve(const TestAnalysis& analysis);

// The straight line of small deflections at that bending stiffness, [EI/L^2] at a deflection [L].
double euler_bernoulli_force(const TestAnalysis& analysis, double deflection);

// The mean of the fit run forward over all stage positions, not only those of the record.
// Domain:     analysis.status is ok.
TestPath simulated_mean_fit(const TestAnalysis& analysis);

// The waves that the fit claims, about its mean and drift, over what has been drawn in.
struct FittedFriction {
  double S, mu;  // [L], [1]
};
// Domain:     analysis.status is ok. Empty if no wave is claimed.
std::vector<FittedFriction> detected_waves(const TestAnalysis& analysis);

}  // namespace flexslip
