#include "inference/process_forward.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

SimulatedTruth wavy_truth() {
  return {.friction = Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4), .step = 4.0 / 1278};
}

Passages passages_seen(const SimulatedTruth& truth) {
  return passages_of({.record = simulated_record(truth),
                      .rig = {truth.stiffness},
                      .errors = {.force = 0.02, .bending_stiffness = 0.03, .contact = 0}});
}

TEST_CASE("oracle: states of a run are those of the exact forward calculation") {
  const auto truth = wavy_truth();
  const auto passages = passages_seen(truth);
  const ForwardRun run(passages);
  const auto mu = truth.friction.at(run.lengths()).mu;
  const auto states = run.states(mu, 0, passages.stage);
  const auto exact = follow_in_steps({truth.friction, {truth.stiffness}}, passages.stage);
  std::vector<double> apart;
  for (std::size_t i = 0; i < passages.size(); ++i) apart.push_back(std::abs(states.S[i] - exact.path[i].S));
  std::sort(apart.begin(), apart.end());
  const double ladder = run.lengths()[1] - run.lengths()[0];
  CHECK(apart[apart.size() * 9 / 10] < 0.02 * ladder);  // a tenth may lie at folds
  CHECK(apart.back() < 2 * ladder);
}

TEST_CASE("identity: a mode at the states of its own friction stays when its mean and waves alone are run forward") {
  const auto truth = wavy_truth();
  const FrictionProcess process(passages_seen(truth));
  const ForwardRun run(process.passages());
  const std::vector<double> lambdas{std::log(20.0 / 1278)};
  Theta theta = process.prior_of_theta().usual(lambdas);
  theta.values[Theta::log_noise] = std::log(0.005);
  Mode mode = process.start(Kernel::none, theta, rises_of(process.passages()));
  process.burst(mode, 60, 0.3);
  const Mode forward = fitted_forward(process, run, mode);
  std::vector<double> apart;
  for (std::size_t i = 0; i < process.passages().size(); ++i) apart.push_back(std::abs(forward.at.S[i] - mode.at.S[i]));
  std::sort(apart.begin(), apart.end());
  CHECK(apart[apart.size() / 2] < 5e-4);  // a third of a µm of 1278, where readings are 4 µm apart
}

}  // namespace
}  // namespace flexslip
