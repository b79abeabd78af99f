#include "inference/likelihood_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <doctest/doctest.h>

#include "inference/fit.h"
#include "inference/fitted_point.h"
#include "inference/restricted_likelihood.h"
#include "inference/wave_search.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// Friction without teeth, in which the force is nearly linear over the errors of its parameters.
FitProblem smooth_problem() {
  const SimulatedTruth truth{.friction = Friction::waves({.mu0 = 0.5, .drift = 0.4, .terms = {}, .S_reference = 1}),
                             .stiffening = 1.02,
                             .noise = 0.02};
  return {simulated_record(truth), {truth.stiffness}, {truth.noise, 0.03, 0}};
}

TEST_CASE("oracle: where the force is linear, the region is the ellipsoid of weighted least squares") {
  const ForceModel model = model_of(smooth_problem());
  const auto region = likelihood_region(model, fit_mean(model, true, {}));
  const auto& best = region.best;
  Eigen::MatrixXd J(model.measured_force().size(), best.p.size());
  for (Eigen::Index i = 0; i < best.p.size(); ++i) {
    constexpr double h = 1e-4;  // the force is smooth in each on a scale of 1
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(best.p.size(), i);
    J.col(i) = (model.force(best.layout, best.p + step) - model.force(best.layout, best.p - step)) / (2 * h);
  }
  J = whitened(J, best.noise.correlation);
  Eigen::MatrixXd H = J.transpose() * J / best.noise.variance;
  H(2, 2) += 1 / (0.03 * 0.03);
  const Eigen::MatrixXd errors = H.inverse();
  for (Eigen::Index i = 0; i < best.p.size(); ++i) {
    CAPTURE(i);
    const double reach = 1.96 * std::sqrt(errors(i, i));
    const auto& range = region.ranges[static_cast<std::size_t>(i)];
    // 5 %: the change of the slopes over the interval, and 1.97 for 1.96
    CHECK(range.high - best.p[i] == doctest::Approx(reach).scale(0).epsilon(0.05));
    CHECK(best.p[i] - range.low == doctest::Approx(reach).scale(0).epsilon(0.05));
    CHECK(!range.open);
  }
}

TEST_CASE("oracle: the ranges are those of all points of a grid that are likely enough") {
  const ForceModel model = model_of(smooth_problem());
  const auto region = likelihood_region(model, fit_mean(model, true, {}));
  const auto& best = region.best;
  const RestrictedLikelihood likelihood(model, best, best.noise);
  const Eigen::VectorXd reach = 2.6 * region.covariance.diagonal().cwiseSqrt();
  const Eigen::MatrixXd root = region.covariance.llt().matrixL();
  constexpr int half = 13;
  std::array<double, 3> low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  // In the axes of the Cholesky factor: a cube that holds the ellipsoid.
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j)
      for (int k = -half; k <= half; ++k) {
        const Eigen::Vector3d u(static_cast<double>(i) / half, static_cast<double>(j) / half,
                                static_cast<double>(k) / half);
        const Eigen::VectorXd p = best.p + 2.6 * (root * u);
        if (likelihood.deviance(p) > region.deviance + region.rise95) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          low[c] = std::min(low[c], p[static_cast<Eigen::Index>(c)]);
          high[c] = std::max(high[c], p[static_cast<Eigen::Index>(c)]);
        }
      }
  for (std::size_t c = 0; c < 3; ++c) {
    const double spacing = reach[static_cast<Eigen::Index>(c)] / half;  // the grid stops up to one short of the edge
    CHECK(region.ranges[c].low <= low[c] + 0.1 * spacing);              // ends are interpolated
    CHECK(region.ranges[c].low >= low[c] - 1.5 * spacing);
    CHECK(region.ranges[c].high >= high[c] - 0.1 * spacing);
    CHECK(region.ranges[c].high <= high[c] + 1.5 * spacing);
  }
}

TEST_CASE("limit: the restricted noise of white residuals is white, of an AR(1) process its own") {
  for (const double correlation : {0.0, 0.7}) {
    CAPTURE(correlation);
    const SimulatedTruth truth{.friction = Friction::sinusoid(0.5, 0.2, 0.02, 1), .noise = 0.0};
    FitProblem problem{simulated_record(truth), {truth.stiffness}, {0.02, 0.03, 0}};
    double mean = 0;
    constexpr int tests = 10;
    for (int test = 0; test < tests; ++test) {
      auto noisy = problem;
      const double sigma = 0.02;
      std::mt19937_64 generator(static_cast<std::uint64_t>(test) + 1);
      const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
      double error = 0;
      for (std::size_t i = 0; i < noisy.record.force.size(); ++i) {
        const double radius = std::sqrt(-2 * std::log(uniform()));
        const double normal = radius * std::cos(2 * std::numbers::pi * uniform());
        error = correlation * error + std::sqrt(1 - correlation * correlation) * sigma * normal;
        noisy.record.force[i] += error;
        noisy.record.deflection[i] -= error / truth.stiffness;
      }
      const auto fit = fit_friction(noisy, {.models = {ProfileModel::sinusoid}});
      mean += fit.models.front().correlation / tests;
    }
    // one estimate scatters by 1/√260 = 0.06, the mean by 0.02; at 0 it cannot be negative and lies 0.025 above
    CHECK(mean == doctest::Approx(correlation).epsilon(0.06));
  }
}

}  // namespace
}  // namespace flexslip
