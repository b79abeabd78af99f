// The analysis of measured tests: bench/analyses [--starts N] CASE... prints a line of CSV for each: the processor time of one analysis,
// the least of three, and how its optimum without a wave (Matérn 3/2) compares with those that N random starts reach.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string_view>
#include <vector>

#include "case/case_file.h"
#include "case/fitted.h"
#include "inference/chain.h"
#include "inference/prior_draws.h"
#include "inference/process_search.h"

namespace flexslip {
namespace {

struct Optimum {
  double log_posterior, mean;  // ln p; [1] μ0
};

// From hyperparameters drawn from what is expected beforehand.
Optimum optimum_from(const FrictionProcess& process, const Linearisation& rises, NormalSource& normal) {
  const ThetaPrior& prior = process.prior_of_theta();
  Theta theta = prior.usual();
  for (std::size_t i = 0; i < 4; ++i) theta.values[i] = prior.mean[i] + prior.deviation[i] * normal();
  prior.bound(theta);
  Mode mode = process.start(Kernel::matern_3_2, theta, rises);
  process.polish(mode, {20, 10, 0.3});
  const Observations observations = process.observations_of(mode);
  return {mode.log_posterior,
          FrictionProcess::mean_friction +
              Chain(observations, mode.kernel, hyperparameters_of(mode.theta)).mean()[process.columns().mean]};
}

int run(int count, char** arguments) {
  int starts = 0, first = 1;
  if (count > 2 && std::string_view(arguments[1]) == "--starts") {
    starts = std::atoi(arguments[2]);
    first = 3;
  }
  std::printf("case,readings,ms,mu0,mu0_error,starts,starts_at_the_optimum,spread_of_mu0,below_the_best\n");
  for (int i = first; i < count; ++i) {
    const Test asked = read_case(arguments[i]);
    FittedTest test = fit_test(asked, {});  // the first builds tables for all
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 3; ++round) {
      const std::clock_t begin = std::clock();
      test = fit_test(asked, {});
      least = std::min(least, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    const TestAnalysis& analysis = test.analysis;
    const FrictionProcess process(passages_of(thinned(usable_part({analysis.reduced, analysis.rig, analysis.errors}))));
    const Linearisation rises = rises_of(process.passages());
    NormalSource normal(1);
    std::vector<Optimum> optima;
    optima.reserve(static_cast<std::size_t>(starts));
    for (int k = 0; k < starts; ++k) optima.push_back(optimum_from(process, rises, normal));
    double own = -std::numeric_limits<double>::infinity();
    for (const auto& component : search(process, {}).components)
      if (component.mode.theta.waves == 0 && component.mode.kernel == Kernel::matern_3_2)
        own = component.mode.log_posterior;
    double best = -std::numeric_limits<double>::infinity(), low = -best, high = best;
    for (const auto& each : optima) best = std::max(best, each.log_posterior);
    constexpr double same = 0.5;  // of ln p
    int reached = 0;
    for (const auto& each : optima) {
      if (each.log_posterior < best - same) continue;
      ++reached;
      low = std::min(low, each.mean);
      high = std::max(high, each.mean);
    }
    std::printf("%s,%zu,%.1f,%.4f,%.4f,%d,%d,%.4f,%.2f\n", arguments[i], analysis.fit.readings, least,
                analysis.fit.mu0.value, analysis.fit.mu0.standard_error, starts, reached,
                reached > 0 ? high - low : 0.0, best - own);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
