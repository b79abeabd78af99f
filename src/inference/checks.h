// What the program holds its own fit against. A fit that fails a check is still given, and says so.
#pragma once

#include <string_view>
#include <vector>

#include "data/drops.h"
#include "inference/fit.h"

namespace flexslip {

enum class CheckKind {
  residuals,  // the mean profile run forward gives the measured force back
  drops,      // profiles that explain the record as well show about as many drops as it does
  whiteness,  // what the readings add to those before them is noise
  friction,   // the record tells friction from none
  stiffness,  // the bending stiffness of the fit is that told beforehand
};

std::string_view name_of(CheckKind kind);

enum class CheckOutcome { passed, failed, not_possible };

// What a check passes up to.
inline constexpr double max_residual =
    0.1;  // of the greatest force; empirical: the authors' sound tests reach 0.03, cracked ones 0.5
inline constexpr double min_p_of_noise = 1e-4;     // a campaign of a hundred has one false alarm in a hundred
inline constexpr double max_stiffness_errors = 2;  // of the difference, see stiffness_errors

struct CheckNumber {
  std::string_view name;
  double value;  // [EI/L^2] of a force, [1] otherwise
  bool is_force;
};

struct Check {
  CheckKind kind;
  CheckOutcome outcome;
  std::vector<CheckNumber> numbers;  // those of a check that was not possible may be missing
};

// Domain:     the check has that number; std::invalid_argument otherwise.
double number_of(const Check& check, std::string_view name);

// Domain of all below: fit.status is ok, and the fit is that of the problem.

// Does a fit leave residuals of max_residual of a record's greatest force, or more? So does one that leaves none that could be told.
bool misses_force(const FrictionFit& fit, const ReducedRecord& record);

// Passes if the fit does not miss the force of the problem.
// Numbers:    residual_rms, greatest_force.
Check check_residuals(const FitProblem& problem, const FrictionFit& fit);

// Each of fit.draws is run forward over the stage positions of the record at its own bending stiffness, with noise such as the fit
// has found; drops are found as in the record. Those that fall by less than four standard deviations of the noise of a reading are
// not counted, neither here nor there. Passes if the number of the record's lies within the range of the draws', or 2 beyond.
// Numbers:    threshold; record, draws_low, draws_median, draws_high (numbers of drops); record_fall, draws_fall (mean falls).
// Fails:      not possible without draws (a constant), or with a record too short for drops.
Check check_drops(const FitProblem& problem, const FrictionFit& fit, const DropOptions& options = {});

// Ljung and Box's test of the innovations about their mean: the sum of the squares of their correlations over up to 20 readings. Passes if noise alone
// would give as much in one of ten thousand records.
// Numbers:    ljung_box, lags, p_value.
// Fails:      not possible for a constant.
Check check_whiteness(const FrictionFit& fit);

// Fails if the interval of mu0 has no lower end above 0. Numbers: mu0_high.
Check check_friction(const FrictionFit& fit);

// By how many standard errors what the record says of the bending stiffness lies off what is stated of it, to a relative error: told to s in the end
// and stated to p, a record that says m more says |ln m|/√(p² - s²). Never over less than 0.35 p: what tells nothing contradicts nothing.
// Domain:     told over the nominal value; stated > 0.
double stiffness_errors(const Estimate& told, double stated);

// Fails if the bending stiffness of the fit contradicts the nominal one by more than max_stiffness_errors.
// Domain:     its relative error >= 0.
// Numbers:    fitted_over_nominal, errors (stiffness_errors).
// Fails:      not possible for a constant, and for a stiffness that is exact.
Check check_bending_stiffness(const FrictionFit& fit, double error);

}  // namespace flexslip
