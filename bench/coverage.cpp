// How often 95 % intervals hold the truth, on simulated tests: bench/coverage KIND FIRST COUNT prints a line of CSV for each test.
// Kinds: independent, correlated, exponential, squared_exponential, roughness, two_waves, constant, soft, quiet, measured, smooth, overshoot.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/simulated_tests.h"
#include "inference/checks.h"
#include "inference/fit.h"

namespace flexslip {
namespace {

int covers(const Estimate& e, double truth) { return e.low <= truth && truth <= e.high; }

int run(int count, char** arguments) {
  const auto asked = tests_asked(count, arguments);
  if (!asked) return 2;
  const auto& [kind, first, tests] = *asked;
  std::printf(
      "kind,test,mean,mean_covered,mean_estimate,mean_error,stiffness_covered,stiffness_z,roughness_covered,length_"
      "covered,noise_covered,"
      "waves,log_evidence,claimed,wavelength,wavelength_estimate,wavelength_error,wavelength_covered,amplitude,"
      "amplitude_estimate,amplitude_covered,phase_covered,"
      "k,noise,whiteness_p,ms\n");
  for (int test = first; test < first + tests; ++test) {
    Random random = random_of(kind, test);
    const Truth t = truth_of(kind, random);
    const FitProblem problem = simulated(t, random);
    const auto begin = std::chrono::steady_clock::now();
    const FrictionFit fit = fit_friction(problem);
    const double ms = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (fit.status != FrictionFitStatus::ok) {
      std::printf("%s,%d,failed\n", kind.c_str(), test);
      continue;
    }
    double mean = 0;
    constexpr int places = 2000;
    for (int i = 0; i < places; ++i)
      mean += t.mu(fit.S_begin + (fit.S_end - fit.S_begin) * (i + 0.5) / places) / places;
    std::printf("%s,%d,%.4f,%d,%.4f,%.4f,%d,%.3f,", kind.c_str(), test, mean, covers(fit.mu0, mean), fit.mu0.value,
                fit.mu0.standard_error, covers(fit.bending_stiffness, t.stiffening),
                (fit.bending_stiffness.value - t.stiffening) / fit.bending_stiffness.standard_error);
    std::printf("%d,%d,%d,%zu,%.2f,%d,", covers(fit.roughness, t.roughness), covers(fit.length, t.length / span),
                covers(fit.noise, t.noise), t.waves.size(), fit.log_evidence_of_wave, fit.wave_claimed);
    if (t.waves.empty() || fit.waves.empty()) {
      std::printf("0,%.3f,0,0,0,0,0,0,", fit.waves.empty() ? 0 : fit.waves[0].wavelength.value * span);
    } else {
      // The wave found that is nearest the first of the truth.
      const auto& wave = t.waves[0];
      const auto& found = *std::min_element(fit.waves.begin(), fit.waves.end(), [&](const auto& a, const auto& b) {
        const auto away = [&](const WaveEstimate& each) {
          return std::abs(std::log(each.wavelength.value * span / wave.wavelength));
        };
        return away(a) < away(b);
      });
      const double phase = pi * fit.S_middle * span / wave.wavelength + wave.phase;
      const double turned = phase + 2 * pi * std::round((found.phase_at_middle.value - phase) / (2 * pi));
      std::printf("%.3f,%.3f,%.4f,%d,%.4f,%.4f,%d,%d,", wave.wavelength, found.wavelength.value * span,
                  found.wavelength.standard_error * span, covers(found.wavelength, wave.wavelength / span),
                  wave.amplitude / mean, found.amplitude.value, covers(found.amplitude, wave.amplitude / mean),
                  covers(found.phase_at_middle, turned));
    }
    std::printf("%.2f,%.4f,%.2g,%.1f\n", t.k, t.noise, number_of(check_whiteness(fit), "p_value"), ms);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
