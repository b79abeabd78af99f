#include "inference/checks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "data/order.h"
#include "inference/chain.h"
#include "inference/process_posterior.h"

namespace flexslip {
namespace {

struct Falls {
  double number, mean;  // [1]; force unit of the record, NaN without falls
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

// Stage positions of which none lies behind the one before: readings of the stage jitter.
std::vector<double> advancing(std::span<const double> stage) {
  std::vector<double> stages;
  for (const double position : stage) stages.push_back(std::max(position, stages.empty() ? 0.0 : stages.back()));
  return stages;
}

CheckOutcome passed_if(bool passed) { return passed ? CheckOutcome::passed : CheckOutcome::failed; }

}  // namespace

std::string_view name_of(CheckKind kind) {
  switch (kind) {
    case CheckKind::residuals:
      return "residuals";
    case CheckKind::drops:
      return "drops";
    case CheckKind::friction:
      return "friction";
    case CheckKind::stability:
      break;
  }
  return "stability";
}

double number_of(const Check& check, std::string_view name) {
  const auto found =
      std::find_if(check.numbers.begin(), check.numbers.end(), [&](const auto& number) { return number.name == name; });
  if (found == check.numbers.end())
    throw std::invalid_argument("the check '" + std::string(name_of(check.kind)) + "' has no number '" +
                                std::string(name) + "'");
  return found->value;
}

Check check_residuals(const FitProblem& problem, const FrictionFit& fit) {
  const double greatest = *std::max_element(problem.record.force.begin(), problem.record.force.end());
  constexpr double small = 0.1;  // empirical: the authors' sound tests reach 0.03, and cracked ones 0.5
  return {CheckKind::residuals,
          passed_if(fit.residual_rms < small * greatest),
          {{"residual_rms", fit.residual_rms, true}, {"greatest_force", greatest, true}}};
}

Check check_drops(const FitProblem& problem, const FrictionFit& fit, const DropOptions& options) {
  // find_drops knows SI alone; with a unit scale its numbers are those of the model.
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
    ReducedRecord drawn{stages, {}, forces_of(fit.draws[k], problem.rig.stiffness / stiffening, stages)};
    double error = fit.noise.value * normal();
    for (std::size_t i = 0; i < stages.size(); ++i) {
      drawn.force[i] = stiffening * drawn.force[i] + error;
      drawn.deflection.push_back(stages[i] - drawn.force[i] / problem.rig.stiffness);
      error = rho * error + fresh * normal();
    }
    const Falls falls = falls_beyond(threshold, drops_of(drawn).drops);
    numbers.push_back(falls.number);
    if (falls.number > 0) means.push_back(falls.mean);
  }
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  constexpr double beyond = 2;  // drops: 20 draws do not reach the ends of their distribution
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

Check check_friction(const FrictionFit& fit) {
  return {CheckKind::friction, passed_if(!fit.mu0_is_bound), {{"mu0_high", fit.mu0.high, false}}};
}

Check check_stability(const FitProblem& problem, const FrictionFit& fit, const FitOptions& options) {
  FitProblem moved = problem;
  NormalSource normal(20210829);
  constexpr double ninth_digit = 1e-9;
  for (double& force : moved.record.force) force *= 1 + ninth_digit * normal();
  const FrictionFit again = fit_friction(moved, options);
  if (again.status != FrictionFitStatus::ok) return {CheckKind::stability, CheckOutcome::failed, {}};
  const double steps = std::abs(again.mu0.value - fit.mu0.value) / fit.mu0.standard_error;
  const auto leading = [](const FrictionFit& of) {
    return of.explanations.empty() ? Kernel::none : of.explanations.front().kernel;
  };
  const bool same = leading(again) == leading(fit) && again.wave_claimed == fit.wave_claimed;
  constexpr double most = 0.01;  // standard errors
  return {CheckKind::stability,
          passed_if(steps < most && same),
          {{"mu0_moved", steps, false}, {"same_explanation", same ? 1.0 : 0.0, false}}};
}

}  // namespace flexslip
