// Whether the same data give the same friction: bench/pairs KIND FIRST COUNT prints a line of CSV for each test.
//
// Each test is fitted as it is and again with every force changed by a thousandth of its noise, which is less than a thousandth of a step of any load cell
// that shows it. Kinds: those of bench/coverage, of which stick_slip has static friction above the kinetic one. Columns:
//   mean, covered                 [1] true mean friction; whether the first interval holds it
//   mu0, error, mu0_again, ...    [1] of both fits
//   apart                         [errors] the two differ by, over the smaller error
//   claims                        fits that claim a wave
//   ms                            of the first fit
// The last line, on the standard error, counts the pairs that agree within half of an error.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "bench/simulated_tests.h"
#include "inference/fit.h"

namespace flexslip {
namespace {

FitProblem moved(FitProblem problem, const Truth& truth, Random& random) {
  constexpr double by = 1e-3;  // of the noise
  for (std::size_t i = 0; i < problem.record.force.size(); ++i) {
    problem.record.force[i] += by * truth.noise * random.normal();
    problem.record.deflection[i] = problem.record.stage[i] - problem.record.force[i] / truth.k;
  }
  return problem;
}

int run(int count, char** arguments) {
  const auto asked = tests_asked(count, arguments);
  if (!asked) return 2;
  const auto& [kind, first, tests] = *asked;
  int fitted = 0, agree = 0, covered = 0;
  double ms = 0;
  std::printf("kind,test,k,mean,covered,mu0,error,mu0_again,error_again,apart,claims,ms\n");
  for (int test = first; test < first + tests; ++test) {
    Random random = random_of(kind, test);
    const Truth t = truth_of(kind, random);
    const FitProblem problem = simulated(t, random), other = moved(problem, t, random);
    const std::clock_t begin = std::clock();
    const FrictionFit fit = fit_friction(problem);
    const double took = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const FrictionFit again = fit_friction(other);
    if (fit.status != FrictionFitStatus::ok || again.status != FrictionFitStatus::ok) {
      std::printf("%s,%d,failed\n", kind.c_str(), test);
      continue;
    }
    constexpr int places = 2000;
    double mean = 0;
    for (int i = 0; i < places; ++i)
      mean += t.mu(fit.S_begin + (fit.S_end - fit.S_begin) * (i + 0.5) / places) / places;
    const bool holds = fit.mu0.low <= mean && mean <= fit.mu0.high;
    const double apart =
        std::abs(fit.mu0.value - again.mu0.value) / std::min(fit.mu0.standard_error, again.mu0.standard_error);
    std::printf("%s,%d,%.1f,%.4f,%d,%.4f,%.4f,%.4f,%.4f,%.3f,%d,%.0f\n", kind.c_str(), test, t.k, mean, holds,
                fit.mu0.value, fit.mu0.standard_error, again.mu0.value, again.mu0.standard_error, apart,
                fit.wave_claimed + again.wave_claimed, took);
    std::fflush(stdout);
    ++fitted;
    agree += apart < 0.5;
    covered += holds;
    ms += took;
  }
  std::fprintf(stderr, "%s: %d of %d pairs agree, %d covered, %.0f ms a fit\n", kind.c_str(), agree, fitted, covered,
               ms / std::max(fitted, 1));
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
