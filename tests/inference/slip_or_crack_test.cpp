#include "inference/slip_or_crack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "data/scales.h"
#include "fibre/elastica.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

constexpr double soft_train = 60;

std::vector<Drop> drops_of(const ReducedRecord& record) { return find_drops(to_physical(record, Scales(1, 1))).drops; }

SlipOrCrack judged(const ReducedRecord& record) { return slip_or_crack(record, {soft_train}, drops_of(record)); }

ReducedRecord slipping(std::uint64_t seed) {
  return simulated_record({.friction = Friction::sinusoid(0.6, 0.25, 14.0 / 1278, 1.0),
                           .stiffness = soft_train,
                           .noise = 0.01,
                           .seed = seed});
}

ReducedRecord cracking(std::uint64_t seed) {
  return simulated_record({.friction = Friction::constant(0.5), .stiffness = soft_train, .noise = 0.01, .seed = seed},
                          six_cracks);
}

// The force at a deflection with friction q, by bisection of the length.
double force_at(double w, double q) {
  double low = 1, high = 1 + 4 * w * w;
  for (int i = 0; i < 80; ++i) {
    const double S = 0.5 * (low + high);
    (fibre_state(S, q).w < w ? low : high) = S;
  }
  return fibre_state(low, q).F;
}

}  // namespace

TEST_CASE("identity: rises of a fibre that slips are not those of cracks alone") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto found = judged(slipping(seed));
    REQUIRE(found.judged);
    CHECK(found.verdict == CrackVerdict::not_by_cracks_alone);
    CHECK(found.cracks_alone < 0.02);
    CHECK(found.features.given_back > 0.7);
    CHECK(found.features.friction_needed > 0.7);
  }
}

TEST_CASE("identity: rises of a fibre that cracks are not those of slips, and what is left of it is found") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto found = judged(cracking(seed));
    REQUIRE(found.judged);
    CHECK(found.verdict == CrackVerdict::cracks);
    CHECK(found.cracks_alone > 0.95);
    CHECK(std::abs(found.features.given_back) < 0.2);
    CHECK(found.features.friction_needed == doctest::Approx(0.5).scale(0).epsilon(0.2));
    CHECK(found.cracks_constant.left == doctest::Approx(0.6).scale(0).epsilon(0.05));
  }
}

TEST_CASE("limit: fewer than three drops, or three rises, tell nothing") {
  const auto record = slipping(1);
  const auto drops = drops_of(record);
  for (const std::size_t count : {0U, 1U, 2U}) {
    const auto found = slip_or_crack(record, {soft_train}, std::span(drops).first(count));
    CHECK(!found.judged);
    CHECK(found.verdict == CrackVerdict::cannot_be_told);
    CHECK(std::isnan(found.cracks_alone));
  }
}

TEST_CASE("limit: a record unlike those simulated has no probability") {
  const auto record = slipping(1);
  const auto found = slip_or_crack(record, {1e4}, drops_of(record));
  CHECK(found.judged);
  CHECK(std::isnan(found.cracks_alone));
  CHECK(found.verdict == CrackVerdict::cannot_be_told);
  ReducedRecord coarse;
  for (std::size_t i = 0; i < record.force.size(); i += 8) {
    coarse.stage.push_back(record.stage[i]);
    coarse.deflection.push_back(record.deflection[i]);
    coarse.force.push_back(record.force[i]);
  }
  REQUIRE(coarse.force.size() < 60);
  CHECK(std::isnan(judged(coarse).cracks_alone));
}

TEST_CASE(
    "identity: the probability falls as rises give back more, as cracks need more friction and as they explain them "
    "worse, and is surer with more rises") {
  const RiseFeatures middle{.rises = 9, .given_back = 0.3, .friction_needed = 0.7, .margin = 2, .loss_margin = 0};
  double before_given = 1, before_friction = 1, before_margin = 1, before_loss = 0;
  for (int i = -20; i <= 40; ++i) {
    RiseFeatures given = middle, friction = middle, margin = middle, loss = middle;
    given.given_back = 0.05 * i;
    friction.friction_needed = 0.7 + 0.02 * i;
    margin.margin = 2.0 * i;
    loss.loss_margin = i;
    const double by_given = cracks_alone(given), by_friction = cracks_alone(friction), by_margin = cracks_alone(margin),
                 by_loss = cracks_alone(loss);
    CHECK(by_given < before_given);
    CHECK(by_friction < before_friction);
    CHECK(by_margin < before_margin);
    CHECK(by_loss > before_loss);
    before_given = by_given, before_friction = by_friction, before_margin = by_margin, before_loss = by_loss;
  }
  for (const double given_back : {0.0, 0.9}) {
    double sureness = 0;
    for (const std::size_t rises : {3U, 5U, 8U, 16U}) {
      const double p = cracks_alone(
          {.rises = rises, .given_back = given_back, .friction_needed = 0.7, .margin = 0, .loss_margin = 0});
      CHECK(std::abs(p - 0.5) > sureness);
      sureness = std::abs(p - 0.5);
    }
    CHECK(std::abs(cracks_alone({100, given_back, 0.7, 0, 0}) - cracks_alone({16, given_back, 0.7, 0, 0})) == 0);
  }
}

TEST_CASE("table: probabilities of some features, by the formula of theory.md") {
  struct Case {
    RiseFeatures features;
    double probability;
  };
  for (const auto& [features, probability] :
       {Case{{3, 0, 0.3, 0, 0}, 0.943528}, Case{{5, 0.95, 0.9, 20, -4}, 0.015796},
        Case{{12, 0.9, 1.2, 12, -4}, 0.001095}, Case{{9, 0.45, 1, 0, -2}, 0.067570},
        Case{{16, -0.05, 0.5, -12, 9}, 0.999597}, Case{{30, 0.3, 0.3, -2, 3}, 0.903183},
        Case{{4, 2, 0.6, 100, -5}, 0.035446}})
    CHECK(cracks_alone(features) ==
          doctest::Approx(probability).scale(0).epsilon(2e-4));  // as many digits as are written
}

TEST_CASE("identity: verdicts are by a probability of 5 and 95 %") {
  CHECK(verdict_of(0.04) == CrackVerdict::not_by_cracks_alone);
  CHECK(verdict_of(0.06) == CrackVerdict::cannot_be_told);
  CHECK(verdict_of(0.94) == CrackVerdict::cannot_be_told);
  CHECK(verdict_of(0.96) == CrackVerdict::cracks);
  CHECK(verdict_of(NAN) == CrackVerdict::cannot_be_told);
}

TEST_CASE("identity: the same record gives the same bits") {
  const auto record = cracking(1);
  const auto a = judged(record), b = judged(record);
  CHECK(a.features.margin == b.features.margin);
  CHECK(a.cracks_alone == b.cracks_alone);
  CHECK(a.slip_and_cracks.left == b.slip_and_cracks.left);
}

// Friction and correlation on a grid, forces from the elastica itself, levels by trying every way to pool neighbours.
TEST_CASE("oracle: cracks with constant friction on a grid, levels pooled every way there is") {
  const auto record = cracking(1);
  const auto all = drops_of(record);
  const auto drops = std::span(all).first(3);
  const auto found = slip_or_crack(record, {soft_train}, drops);
  REQUIRE(found.features.rises == 4);
  struct Row {
    double w, F, to_stage;
    std::size_t rise;
  };
  std::vector<Row> rows;
  for (std::size_t c = 0; c <= drops.size(); ++c) {
    const std::size_t first = c > 0 ? drops[c - 1].after : drops[0].before - 14;
    const std::size_t last = c < drops.size() ? drops[c].before : drops[c - 1].after + 14;
    for (std::size_t i = first; i <= last; ++i) {
      const double w = record.deflection[i], F = record.force[i];
      const double q = std::clamp(fibre_state_from_force(w, F).q, 0.0, 1.2), h = 1e-5;
      const double tangent = (force_at(w + h, q) - force_at(w - h, q)) / (2 * h);
      rows.push_back({w, F, 1 / (1 + std::max(tangent, -0.5 * soft_train) / soft_train), c});
    }
  }
  const auto n = static_cast<double>(rows.size());
  double squares_at_best = 0;
  const auto minus_log_likelihood = [&](const std::vector<double>& forces, double rho, double variance) {
    std::vector<double> x, z;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double own_x = forces[i] * rows[i].to_stage, own_z = rows[i].F * rows[i].to_stage;
      const bool first = i == 0 || rows[i].rise != rows[i - 1].rise;
      if (first) {
        x.push_back(own_x * std::sqrt(1 - rho * rho));
        z.push_back(own_z * std::sqrt(1 - rho * rho));
      } else {
        x.push_back(own_x - rho * forces[i - 1] * rows[i - 1].to_stage);
        z.push_back(own_z - rho * rows[i - 1].F * rows[i - 1].to_stage);
      }
    }
    double best = std::numeric_limits<double>::infinity();
    for (int pooled = 0; pooled < 8; ++pooled) {  // a bit for each pair of neighbours
      double e[4], product = 0, square = 0, total = 0;
      bool falls = true;
      for (std::size_t j = 0, begin = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < rows.size(); ++i)
          if (rows[i].rise == j) product += x[i] * z[i], square += x[i] * x[i];
        if (j == 0) product += variance / 0.0025, square += variance / 0.0025;
        if (j < 3 && (pooled >> j & 1) != 0) continue;
        for (std::size_t l = begin; l <= j; ++l) e[l] = product / square;
        falls = falls && (begin == 0 || e[begin] <= e[begin - 1]);
        begin = j + 1;
        product = square = 0;
      }
      if (!falls) continue;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const double off = z[i] - e[rows[i].rise] * x[i];
        total += off * off;
      }
      const double away = (e[0] - 1) / 0.05;
      const double value = 0.5 * n * (std::log(total / n) + 1) - 0.5 * 4 * std::log(1 - rho * rho) + 0.5 * away * away;
      if (value < best) best = value, squares_at_best = total;
    }
    return best;
  };
  const auto forces_with = [&](double mu) {
    std::vector<double> forces;
    for (const Row& row : rows) forces.push_back(force_at(row.w, mu));
    return forces;
  };
  // The variance that the prior of e0 is weighed against is that of the residuals.
  static_cast<void>(minus_log_likelihood(forces_with(0.5), 0.05, 1e-4));
  const double variance = squares_at_best / n;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 40; ++i) {
    const auto forces = forces_with(0.4 + 0.005 * i);
    for (int j = 0; j <= 20; ++j) least = std::min(least, minus_log_likelihood(forces, 0.02 * j, variance));
  }
  constexpr double of_the_grid = 0.1;
  CHECK(std::abs(found.cracks_constant.bic - (2 * least + 7 * std::log(n))) < of_the_grid);
}

}  // namespace flexslip
