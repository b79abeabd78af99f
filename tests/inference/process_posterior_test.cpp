#include "inference/process_posterior.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

const FrictionProcess& rough_process() {
  static const FrictionProcess process(passages_of(
      {.record = simulated_record({.friction = Friction::rough(0.5, 0.2, 20.0 / 1278, 3, 1.6), .noise = 0.02}),
       .rig = {90},
       .errors = {.force = 0.02, .bending_stiffness = 0.03, .contact = 0}}));
  return process;
}

ProcessPosterior rough_posterior() {
  return posterior_of(rough_process(),
                      search(rough_process(), {.kernels = {Kernel::matern_3_2}, .waves = 0}).components);
}

TEST_CASE("oracle: the mean over the fibre seen is that of the band") {
  const auto posterior = rough_posterior();
  const auto& band = posterior.band;
  double sum = 0;
  for (std::size_t i = 1; i < band.S.size(); ++i)
    sum += 0.5 * (band.mean[i] + band.mean[i - 1]) * (band.S[i] - band.S[i - 1]);
  // The band is at the mode, the mean at eight points about it: a quarter of its error apart at most.
  CHECK(std::abs(sum / (posterior.S_end - posterior.S_begin) - quantile_of(posterior.mean, 0.5)) <
        0.25 * deviation_of(posterior.mean));
}

TEST_CASE("oracle: profiles drawn lie about the band as far as it is wide") {
  const auto posterior = rough_posterior();
  const auto& band = posterior.band;
  REQUIRE(posterior.draws.size() == 20);
  REQUIRE(posterior.draw_stiffness.size() == 20);
  double squares = 0, count = 0;
  for (const auto& draw : posterior.draws) {
    REQUIRE(draw.S == band.S);
    for (std::size_t i = 0; i < band.S.size(); ++i) {
      const double away = (draw.mu[i] - band.mean[i]) / band.deviation[i];
      squares += away * away;
      ++count;
    }
  }
  // Lengths of a draw go together, about ten of them independent: 200 squares of mean 1, deviation 0.1.
  CHECK(std::abs(squares / count - 1) < 0.4);
}

TEST_CASE("identity: weights of the explanations add up to one, and what readings add has variance one") {
  const auto posterior = posterior_of(rough_process(), search(rough_process(), {}).components);
  double total = 0;
  for (const auto& each : posterior.explanations) total += each.weight;
  CHECK(std::abs(total - 1) < 1e-12);
  double squares = 0;
  for (const double value : posterior.innovations) squares += value * value;
  const auto n = static_cast<double>(posterior.innovations.size());
  CHECK(posterior.innovations.size() == rough_process().passages().size());
  CHECK(std::abs(squares / n - 1) < 4 * std::sqrt(2 / n));
}

}  // namespace
}  // namespace flexslip
