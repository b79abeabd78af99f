// Goodness-of-fit checks. A fit that fails a check is still returned, with the failure reported.
#pragma once

#include <string_view>
#include <vector>

#include "data/drops.h"
#include "inference/fit.h"

namespace flexslip {

enum class CheckKind {
  residuals,  // the simulated mean profile reproduces the measured force
  drops,      // simulated posterior samples have about as many drops as the record
  whiteness,  // the prediction errors of the readings are white noise
  friction,   // friction can be distinguished from zero
  stiffness,  // the fitted bending stiffness agrees with the stated one
};

std::string_view name_of(CheckKind kind);

enum class CheckOutcome { passed, failed, not_possible };

// Limits up to which a check passes.
inline constexpr double max_residual = 0.1;     // [maximum force] the authors' sound tests reach 0.03, cracked ones 0.5
inline constexpr double min_p_of_noise = 1e-4;  // one false alarm in a hundred campaigns of a hundred tests
inline constexpr double max_stiffness_errors = 2;  // see stiffness_errors

struct CheckNumber {
  std::string_view name;
  double value;  // [EI/L^2] of a force, [1] otherwise
  bool is_force;
};

struct Check {
  CheckKind kind;
  CheckOutcome outcome;
  std::vector<CheckNumber> numbers;  // may be incomplete if the check was not possible
};

// Domain:     the check has that number; std::invalid_argument otherwise.
double number_of(const Check& check, std::string_view name);

// Domain of all functions below: fit.status is ok, and the fit belongs to the problem.

// True if the residuals reach max_residual of the maximum force, or cannot be calculated.
bool misses_force(const FrictionFit& fit, const ReducedRecord& record);

// Passes if the fit does not miss the force of the problem.
// Numbers:    residual_rms, greatest_force.
Check check_residuals(const FitProblem& problem, const FrictionFit& fit);

// Each of fit.draws is simulated at the stage positions of the record, at its own bending stiffness
// and with the fitted noise; drops are detected as in the record. Drops below four standard
// deviations of the noise are not counted. Passes if the number in the record lies within the range
// of the samples, or at most 2 outside.
// Numbers:    threshold; record, draws_low, draws_median, draws_high (numbers of drops);
//             record_fall, draws_fall (mean falls).
// Fails:      not possible without draws (a constant), or with a record too short for drops.
Check check_drops(const FitProblem& problem, const FrictionFit& fit, const DropOptions& options = {});

// Ljung and Box's test of the innovations: the sum of the squares of their correlations over up to
// 20 readings. Passes unless noise alone would reach it in fewer than one of ten thousand records.
// Numbers:    ljung_box, lags, p_value.
// Fails:      not possible for a constant.
Check check_whiteness(const FrictionFit& fit);

// Fails unless the lower limit of mu0 is above 0.
// Numbers:    mu0_high.
Check check_friction(const FrictionFit& fit);

// The difference between the fitted and the stated bending stiffness in standard errors: |ln
// m|/√(p² - s²), with m their ratio and p and s the stated and fitted relative errors. The root is
// at least 0.35 p, because an uninformative record contradicts nothing.
// Domain:     fitted relative to the nominal value; stated > 0.
double stiffness_errors(const Estimate& fitted, double stated);

// Fails if the fitted bending stiffness differs from the nominal one by more than
// max_stiffness_errors.
// Domain:     its relative error >= 0.
// Numbers:    fitted_over_nominal, errors (stiffness_errors).
// Fails:      not possible for a constant friction, and for an exact stiffness.
Check check_bending_stiffness(const FrictionFit& fit, double error);

}  // namespace flexslip
