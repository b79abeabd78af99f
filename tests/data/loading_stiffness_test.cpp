#include "data/loading_stiffness.h"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

constexpr double load_train = 90;  // [N/m]

struct Truth {
  std::vector<double> stiffness;  // [N/m] of each loading
  double noise = 5e-6;            // [N] of the authors' tests
  double rho = 0;                 // correlation of the noise from row to row
  double bend = 0;                // [1/m] relative change of the slope with deflection
  unsigned seed = 1;
};

struct Loadings {
  Record record;
  std::vector<LoadingRange> ranges;
};

// Loadings to 3 mN in steps of 1 µm, each with its own contact offset: F = s d (1 - bend d/2), d = w0 - offset, w_s = w0 + F/k_c.
Loadings simulated(const Truth& truth) {
  std::mt19937_64 generator(truth.seed);
  std::normal_distribution<double> normal;
  Loadings result;
  double error = 0;
  for (std::size_t leg = 0; leg < truth.stiffness.size(); ++leg) {
    const std::size_t first = result.record.force.size();
    const double s = truth.stiffness[leg];
    const double offset = 7e-6 * static_cast<double>(leg);
    for (int row = -20; row < 400; ++row) {
      const double stage = 1e-6 * row + offset;
      const double d = std::max(0.0, (stage - offset) / (1 + s / load_train));
      error = truth.rho * error + truth.noise * std::sqrt(1 - truth.rho * truth.rho) * normal(generator);
      const double bent = s * d * (1 - 0.5 * truth.bend * d);
      if (bent > 3e-3) break;
      const double at = stage + (bent - s * d) / load_train;  // keeps w_s = w0 + F/k_c for the bent curve
      result.record.stage.push_back(at);
      result.record.force.push_back(bent + error);
      result.record.deflection.push_back(at - (bent + error) / load_train);
    }
    result.ranges.push_back({first, result.record.force.size()});
  }
  return result;
}

std::vector<LoadingStiffness> compared(const Truth& truth) {
  const Loadings loadings = simulated(truth);
  return compare_loadings(loadings.record, loadings.ranges);
}

TEST_CASE(
    "loading stiffness: intervals of the ratio cover the truth, white and correlated noise (simulation, 400 seeds)") {
  for (const double rho : {0.0, 0.5}) {
    int covered = 0;
    const int tests = 400;
    for (int seed = 0; seed < tests; ++seed) {
      const auto result = compared({.stiffness = {13, 12.35}, .rho = rho, .seed = static_cast<unsigned>(seed)});
      REQUIRE(result[1].status == LoadingStatus::ok);
      covered += std::abs(result[1].ratio.value - 0.95) <= 1.96 * result[1].ratio.standard_error;
    }
    MESSAGE("rho " << rho << ": " << 100.0 * covered / tests << " % covered");
    CHECK(covered >= (0.95 - 0.03 - 3 * std::sqrt(0.05 * 0.95 / tests)) *
                         tests);  // header's promise, less three deviations of a count
  }
}

TEST_CASE(
    "loading stiffness: wrong verdicts at the very edge are no more frequent than stated (simulation, 400 seeds)") {
  for (const double rho : {0.0, 0.5}) {
    int damaged = 0, not_damaged = 0;
    const int tests = 400;
    for (int seed = 0; seed < tests; ++seed) {
      const auto verdict =
          compared({.stiffness = {13, 11.7}, .noise = 2e-5, .rho = rho, .seed = static_cast<unsigned>(seed)})[1]
              .verdict;
      damaged += verdict == DamageVerdict::damaged;
      not_damaged += verdict == DamageVerdict::not_damaged;
    }
    MESSAGE("rho " << rho << ", loss of just the relevant 10 %: damaged " << damaged << ", not damaged " << not_damaged
                   << " of " << tests);
    const double most = (0.05 + 3 * std::sqrt(0.05 * 0.95 / tests)) * tests;  // three deviations of a count
    CHECK(damaged <= most);
    CHECK(not_damaged <= most);
  }
}

TEST_CASE("loading stiffness: equal loadings are not damaged, a loss of 20 % is damage (simulation, 200 seeds)") {
  int right = 0;
  const int tests = 200;
  for (int seed = 0; seed < tests; ++seed) {
    const auto result =
        compared({.stiffness = {13, 13, 10.4}, .rho = 0.5, .bend = 500, .seed = static_cast<unsigned>(seed)});
    right += result[1].verdict == DamageVerdict::not_damaged && result[2].verdict == DamageVerdict::damaged;
  }
  MESSAGE("right: " << right << " of " << tests);
  CHECK(right >= 0.95 * tests);  // the effects are ten standard errors
}

TEST_CASE("loading stiffness: without noise the slope is exact, and a common bend cancels (identity)") {
  const auto straight = compared({.stiffness = {13, 12}, .noise = 0});
  CHECK(straight[0].slope.value == doctest::Approx(13).epsilon(1e-10));  // rounding of the record's sums
  CHECK(straight[1].ratio.value == doctest::Approx(12.0 / 13).epsilon(1e-10));
  const auto bent = compared({.stiffness = {13, 13}, .noise = 0, .bend = 500});
  CHECK(bent[0].slope.value < 12.8);
  CHECK(bent[1].ratio.value == doctest::Approx(1).epsilon(1e-10));
}

TEST_CASE("loading stiffness: a reload that lost most of its stiffness is bent far, and damaged (limit)") {
  for (const double left : {0.45, 0.3}) {
    const auto result = compared({.stiffness = {13, 13 * left}, .noise = 0});
    CHECK(result[1].status == LoadingStatus::ok);
    CHECK(result[1].ratio.value == doctest::Approx(left).epsilon(1e-9));
    CHECK(result[1].verdict == DamageVerdict::damaged);
  }
}

TEST_CASE("loading stiffness: what cannot be compared says so (limit)") {
  Loadings loadings = simulated({.stiffness = {13, 13}});
  CHECK(compare_loadings(loadings.record, {}).empty());
  loadings.ranges[1].first += 100;  // as if unloaded to 1 mN only
  CHECK(compare_loadings(loadings.record, loadings.ranges)[1].status == LoadingStatus::window_not_covered);
  loadings = simulated({.stiffness = {13, 20}});
  for (std::size_t i = loadings.ranges[1].first; i < loadings.ranges[1].last; ++i)
    loadings.record.deflection[i] += 1e-3;
  CHECK(compare_loadings(loadings.record, loadings.ranges)[1].status == LoadingStatus::still_drawn_in);
  std::swap(loadings.ranges[0], loadings.ranges[1]);
  CHECK_THROWS_AS(compare_loadings(loadings.record, loadings.ranges), std::invalid_argument);
  loadings = simulated({.stiffness = {13, 13}});
  loadings.ranges[0].first += 100;
  const auto result = compare_loadings(loadings.record, loadings.ranges);
  CHECK(result[0].status == LoadingStatus::window_not_covered);
  CHECK(result[1].status == LoadingStatus::no_reference);
}

// Of two loadings, the second so much as stiff as the first.
std::vector<LoadingStiffness> two_loadings(double ratio, double error) {
  LoadingStiffness first{};
  first.status = LoadingStatus::ok;
  first.ratio.value = 1;
  LoadingStiffness second = first;
  second.ratio.value = ratio;
  second.ratio.standard_error = error;
  return {first, second};
}

TEST_CASE("reload: a change counts beyond its error and a twentieth, a loss beyond a tenth for sure (table)") {
  struct Row {
    double ratio, error;
    StiffnessChange change;
  };
  for (const auto& [ratio, error, change] :
       {Row{0.74, 0.02, StiffnessChange::softer}, Row{0.88, 0.02, StiffnessChange::slightly_softer},
        Row{0.93, 0.01, StiffnessChange::slightly_softer}, Row{0.93, 0.05, StiffnessChange::none},
        Row{0.96, 0.01, StiffnessChange::none}, Row{1.5, 0.02, StiffnessChange::stiffer}}) {
    CAPTURE(ratio);
    const auto reload = reload_change(two_loadings(ratio, error), 0);
    CHECK(reload.change == change);
    CHECK(reload.loss == doctest::Approx(1 - ratio));
    CHECK(reload.loss_error == doctest::Approx(error));
    CHECK(lost_stiffness(reload) == (change == StiffnessChange::softer));
  }
}

TEST_CASE("reload: it comes after the loading evaluated, or else that one is held against the first") {
  const auto softer = two_loadings(0.74, 0.02);
  CHECK(reload_change(softer, 0).comes_after);
  CHECK(!reload_change(softer, 1).comes_after);
  CHECK(lost_stiffness(reload_change(softer, 1)));
  CHECK(std::isnan(reload_change({}, 0).loss));
}

}  // namespace
