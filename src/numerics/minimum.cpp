#include "numerics/minimum.h"

#include <memory>
#include <type_traits>

#include <nlopt.h>

namespace flexslip {

Least least_from(const FunctionOfNumbers& f, std::span<const std::vector<double>> starts, const LeastOptions& options) {
  Least best;
  const auto call = [](unsigned n, const double* x, double*, void* data) {
    return (*static_cast<const FunctionOfNumbers*>(data))(std::span(x, n));
  };
  for (const auto& start : starts) {
    std::vector<double> x = start;
    double value = std::numeric_limits<double>::infinity();
    const std::unique_ptr<std::remove_pointer_t<nlopt_opt>, void (*)(nlopt_opt)> optimiser(
        nlopt_create(NLOPT_LN_NELDERMEAD, static_cast<unsigned>(x.size())), nlopt_destroy);
    nlopt_set_min_objective(optimiser.get(), call, const_cast<FunctionOfNumbers*>(&f));  // NOLINT: a C interface
    nlopt_set_initial_step(optimiser.get(), options.steps.data());
    nlopt_set_ftol_abs(optimiser.get(), options.close_in_value);
    nlopt_set_xtol_abs1(optimiser.get(), options.close_in_numbers);
    nlopt_set_maxeval(optimiser.get(), options.max_calls);
    nlopt_optimize(optimiser.get(), x.data(), &value);
    if (best.at.empty() || value < best.value || std::isnan(best.value)) best = {x, value};
  }
  return best;
}

}  // namespace flexslip
