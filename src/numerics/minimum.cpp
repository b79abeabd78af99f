#include "numerics/minimum.h"

#include <nlopt.h>

namespace flexslip {

Least least_from(const FunctionOfNumbers& f, std::span<const std::vector<double>> starts, const LeastOptions& options) {
  Least best;
  const auto call = [](unsigned n, const double* x, double*, void* data) {
    return (*static_cast<const FunctionOfNumbers*>(data))(std::span(x, n));
  };
  for (const auto& start : starts) {
    std::vector<double> x = start;
    double value = f(x);
    nlopt_opt optimiser = nlopt_create(NLOPT_LN_NELDERMEAD, static_cast<unsigned>(x.size()));
    nlopt_set_min_objective(optimiser, call, const_cast<FunctionOfNumbers*>(&f));  // NOLINT: a C interface
    nlopt_set_initial_step(optimiser, options.steps.data());
    nlopt_set_ftol_abs(optimiser, options.close_in_value);
    nlopt_set_xtol_abs1(optimiser, options.close_in_numbers);
    nlopt_set_maxeval(optimiser, options.max_calls);
    nlopt_optimize(optimiser, x.data(), &value);
    nlopt_destroy(optimiser);
    if (best.at.empty() || value < best.value) best = {x, value};  // also where none is a number
  }
  return best;
}

}  // namespace flexslip
