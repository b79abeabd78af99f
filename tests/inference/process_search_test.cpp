#include "inference/process_search.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

FrictionProcess process_of(const Friction& friction) {
  return FrictionProcess(passages_of({.record = simulated_record({.friction = friction, .noise = 0.02}),
                                      .rig = {90},
                                      .errors = {.force = 0.02, .bending_stiffness = 0.03, .contact = 0},
                                      .rig_errors = {.preload = 0.001}}));
}

FrictionProcess wavy_process() { return process_of(Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4)); }

TEST_CASE("identity: the likeliest mode has the wave of the record, and is the first of all") {
  const auto process = wavy_process();
  const auto found = search(process, {});
  const Mode& likeliest = found.components.front().mode;
  REQUIRE(likeliest.theta.waves >= 1);
  CHECK(std::exp(likeliest.theta.log_wavelength(0)) == doctest::Approx(20.0 / 1278).scale(0).epsilon(0.01));
  for (std::size_t i = 1; i < found.components.size(); ++i)
    CHECK(found.components[i].log_evidence <= found.components[i - 1].log_evidence);
  REQUIRE(!found.scan.empty());
  CHECK(found.scan.front().wavelength >= 0.99 * process.min_wavelength());
  CHECK(found.scan.back().wavelength <= 1.01 * process.max_wavelength());
  for (std::size_t i = 1; i < found.scan.size(); ++i) CHECK(found.scan[i].wavelength > found.scan[i - 1].wavelength);
}

TEST_CASE("limit: modes have as many waves as are asked for, and kernels that are allowed") {
  const auto process = wavy_process();
  for (const std::size_t waves : {0, 1, 2})
    for (const auto& component :
         search(process, {.kernels = {Kernel::none, Kernel::matern_9_2}, .waves = waves}).components) {
      CHECK(component.mode.theta.waves == waves);
      CHECK((component.mode.kernel == Kernel::none || component.mode.kernel == Kernel::matern_9_2));
    }
}

TEST_CASE("identity: a part of the search that is switched off is not used") {
  SearchOptions options;
  options.parts.exponential_kernel = options.parts.smooth_kernel = options.parts.no_kernel = options.parts.gaps = false;
  const FitProblem problem{
      .record = simulated_record({.friction = Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4), .noise = 0.02}),
      .rig = {90},
      .errors = {.force = 0.02, .bending_stiffness = 0.03, .contact = 0}};
  const auto modes_of = [&](const SearchOptions& by) {
    return search(FrictionProcess(passages_of(problem, by)), {}).components;
  };
  const auto is_rough_without_gaps = [](const Component& each) {
    return each.mode.kernel == Kernel::matern_3_2 && each.mode.sites.empty();
  };
  const auto with_all = modes_of({}), without = modes_of(options);
  CHECK(!with_all.empty());
  CHECK(std::none_of(with_all.begin(), with_all.end(), is_rough_without_gaps));
  CHECK(!without.empty());
  CHECK(std::all_of(without.begin(), without.end(), is_rough_without_gaps));
}

TEST_CASE("oracle: the evidence of a mode is the sum of its merit over a grid of noise and correlation") {
  const auto process = process_of(Friction::constant(0.5));
  const auto found = search(process, {.kernels = {Kernel::none}, .waves = 0});
  REQUIRE(found.components.size() == 1);
  const Mode& mode = found.components[0].mode;
  Observations observations = process.observations_of(mode);
  constexpr double step = 0.05, correlation_step = 0.1;
  double sum = 0;
  for (int i = -12; i <= 12; ++i)
    for (int j = -80; j <= 80; ++j) {
      Theta theta = mode.theta;
      theta.values[Theta::log_noise] += step * i;
      theta.values[Theta::logit_correlation] += correlation_step * j;
      sum +=
          std::exp(process.objective(mode, observations, theta).value - mode.log_posterior) * step * correlation_step;
    }
  const double expected = mode.log_posterior + std::log(sum) + process.prior_of_theta().log_scale(Kernel::none);
  // Laplace takes ρ, which white noise leaves open on one side, for a bell.
  CHECK(std::abs(found.components[0].log_evidence - expected) < 0.7);
}

}  // namespace
}  // namespace flexslip
