#include "inference/checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "data/names.h"
#include "inference/chain.h"
#include "inference/prior_draws.h"
#include "inference/process_forward.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

struct Falls {
  double number, mean;  // [1]; force unit of the record, NaN without drops
};

Falls falls_beyond(double threshold, std::span<const Drop> drops) {
  double number = 0, sum = 0;
  for (const auto& drop : drops)
    if (drop.force_fall >= threshold) {
      ++number;
      sum += drop.force_fall;
    }
  return {number, sum / number};
}

CheckOutcome passed_if(bool passed) { return passed ? CheckOutcome::passed : CheckOutcome::failed; }

}  // namespace

std::string_view name_of(CheckKind kind) {
  return name_in_order<CheckKind::stiffness>(kind, {"residuals", "drops", "whiteness", "friction", "stiffness"});
}

double number_of(const Check& check, std::string_view name) {
  const auto found =
      std::find_if(check.numbers.begin(), check.numbers.end(), [&](const auto& number) { return number.name == name; });
  if (found == check.numbers.end())
    throw std::invalid_argument("the check '" + std::string(name_of(check.kind)) + "' has no number '" +
                                std::string(name) + "'");
  return found->value;
}

namespace {

double greatest_force(const ReducedRecord& record) {
  return *std::max_element(record.force.begin(), record.force.end());
}

}  // namespace

bool misses_force(const FrictionFit& fit, const ReducedRecord& record) {
  return !(fit.residual_rms < max_residual * greatest_force(record));
}

Check check_residuals(const FitProblem& problem, const FrictionFit& fit) {
  const double greatest = greatest_force(problem.record);
  return {CheckKind::residuals,
          passed_if(!misses_force(fit, problem.record)),
          {{"residual_rms", fit.residual_rms, true}, {"greatest_force", greatest, true}}};
}

Check check_drops(const FitProblem& problem, const FrictionFit& fit, const DropOptions& options) {
  // find_drops expects SI; with unit scales its numbers are reduced.
  const Scales unit(1, 1);
  const auto drops_of = [&](const ReducedRecord& record) { return find_drops(to_physical(record, unit), options); };
  const Drops measured = drops_of(problem.record);
  if (fit.draws.empty() || measured.status != DropStatus::ok) return {CheckKind::drops, CheckOutcome::not_possible, {}};
  constexpr double beyond_noise = 4;
  const double threshold = std::max(beyond_noise * problem.errors.force, measured.smallest_fall);
  const Falls record = falls_beyond(threshold, measured.drops);

  const auto stages = advancing(problem.record.stage);
  const double rho = fit.noise_correlation;
  const double fresh = fit.noise.value * std::sqrt(1 - rho * rho);
  NormalSource normal(20211113);
  std::vector<double> numbers, means;
  for (std::size_t k = 0; k < fit.draws.size(); ++k) {
    const double stiffening = fit.draw_stiffness[k];
    ReducedRecord drawn{stages, {}, forces_of(fit.draws[k], problem.rig.in_units_of(stiffening), stages)};
    double error = fit.noise.value * normal();
    for (std::size_t i = 0; i < stages.size(); ++i) {
      drawn.force[i] = stiffening * drawn.force[i] + error;
      drawn.deflection.push_back(stages[i] - drawn.force[i] / problem.rig.stiffness);
      error = rho * error + fresh * normal();
    }
    // A simulated test ends when its specimen slips through.
    const auto end = std::find_if(drawn.force.begin(), drawn.force.end(), [](double F) { return !std::isfinite(F); });
    const auto held = static_cast<std::size_t>(end - drawn.force.begin());
    for (auto* column : {&drawn.stage, &drawn.deflection, &drawn.force}) column->resize(held);
    const Falls falls = falls_beyond(threshold, drops_of(drawn).drops);
    numbers.push_back(falls.number);
    if (falls.number > 0) means.push_back(falls.mean);
  }
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  constexpr double beyond = 2;  // drops outside the range of 20 samples
  return {CheckKind::drops,
          passed_if(record.number >= *low - beyond && record.number <= *high + beyond),
          {{"threshold", threshold, true},
           {"record", record.number, false},
           {"draws_low", *low, false},
           {"draws_median", median_of(numbers), false},
           {"draws_high", *high, false},
           {"record_fall", record.mean, true},
           {"draws_fall", means.empty() ? std::nan("") : median_of(means), true}}};
}

Check check_whiteness(const FrictionFit& fit) {
  if (fit.innovations.empty()) return {CheckKind::whiteness, CheckOutcome::not_possible, {}};
  // Subtract the mean, which is positive: the specimen sticks where friction is high and skips
  // where it is low.
  auto r = fit.innovations;
  const double mean = mean_of(r);
  for (double& value : r) value -= mean;
  const std::size_t n = r.size(), lags = std::min<std::size_t>(20, n / 5);
  double squares = 0, sum = 0;
  for (const double value : r) squares += value * value;
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    double products = 0;
    for (std::size_t i = lag; i < n; ++i) products += r[i] * r[i - lag];
    const double correlation = products / squares;
    sum += correlation * correlation / static_cast<double>(n - lag);
  }
  const double statistic = static_cast<double>(n) * static_cast<double>(n + 2) * sum;
  const double p_value =
      chi_squared_beyond(statistic, static_cast<double>(lags - 1));  // one degree of freedom is used by ρ
  return {CheckKind::whiteness,
          passed_if(p_value > min_p_of_noise),
          {{"ljung_box", statistic, false}, {"lags", static_cast<double>(lags), false}, {"p_value", p_value, false}}};
}

Check check_friction(const FrictionFit& fit) {
  return {CheckKind::friction, passed_if(!fit.mu0_is_bound), {{"mu0_high", fit.mu0.high, false}}};
}

double stiffness_errors(const Estimate& fitted, double stated) {
  constexpr double min_share = 0.35;  // of the stated error: an uninformative record contradicts nothing
  const double by_record = std::sqrt(std::max(stated * stated - fitted.standard_error * fitted.standard_error, 0.0));
  return std::abs(elementary::log(fitted.value)) / std::max(by_record, min_share * stated);
}

Check check_bending_stiffness(const FrictionFit& fit, double error) {
  const bool is_fitted = fit.model != ProfileModel::constant && error > 0;
  if (!is_fitted) return {CheckKind::stiffness, CheckOutcome::not_possible, {}};
  const double errors = stiffness_errors(fit.bending_stiffness, error);
  return {CheckKind::stiffness,
          passed_if(errors <= max_stiffness_errors),
          {{"fitted_over_nominal", fit.bending_stiffness.value, false}, {"errors", errors, false}}};
}

}  // namespace flexslip
