#include "inference/drop_features.h"

#include <array>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

constexpr double train = 60;

DropFeatures features_of(const ReducedRecord& record, double stiffness, const Fibre& fibre = {}) {
  const Record physical = to_physical(record, Scales(1, 1));
  return drop_features(record, {stiffness, fibre}, {force_noise(physical), 0.03}, find_drops(physical).drops);
}

ReducedRecord a_slipping_record() {
  return simulated_record(
      {.friction = Friction::sinusoid(0.6, 0.25, 14.0 / 1278, 1.0), .stiffness = train, .noise = 0.01, .seed = 5});
}

ReducedRecord a_cracking_record() {
  return simulated_record({.friction = Friction::constant(0.5), .stiffness = train, .noise = 0.01}, six_cracks);
}

TEST_CASE("table: the length that a snap draws in, on soft and on stiff load trains") {
  constexpr std::array w{0.02, 0.05, 0.1, 0.2, 0.3};
  struct Row {
    double k;
    std::array<double, 5> c;
  };
  for (const auto& [k, c] : {Row{3, {8.36351e-5, 1.25399e-3, 0.0101625, 0.119755, 4.87256}},
                             Row{30, {5.5659e-5, 8.35338e-4, 6.51024e-3, 0.0561055, 0.221431}},
                             Row{300, {1.35131e-5, 2.03197e-4, 1.50113e-3, 9.59123e-3, 0.0235102}},
                             Row{3000, {2.50163e-6, 3.77522e-5, 2.80054e-4, 1.82726e-3, 4.8492e-3}},
                             Row{infinity, {1.07552e-6, 1.63167e-5, 1.24385e-4, 9.05896e-4, 2.78771e-3}}})
    for (std::size_t i = 0; i < w.size(); ++i) {
      CAPTURE(k);
      CAPTURE(w[i]);
      CHECK(snap_length({}, w[i], 0.5, k) == doctest::Approx(c[i]).epsilon(2e-5));
    }
}

TEST_CASE("oracle: a snap followed state by state draws in what its length says") {
  for (const double k : {30.0, 3000.0}) {
    const FibreState before = fibre_state_from_force(0.2, fibre_state(1.0924, 0.5).F);
    const double stage = before.w + before.F / k;
    double S = before.S;
    const double q = before.q - 1e-3;
    for (int i = 0; i < 50; ++i) {  // along the line of the load train
      const double miss = fibre_state(S, q).w + fibre_state(S, q).F / k - stage;
      const double slope = (fibre_state(S + 1e-7, q).w + fibre_state(S + 1e-7, q).F / k - fibre_state(S, q).w -
                            fibre_state(S, q).F / k) /
                           1e-7;
      S -= miss / slope;
    }
    CHECK((S - before.S) / 1e-3 == doctest::Approx(snap_length({}, 0.2, before.q, k)).epsilon(0.01));
  }
}

TEST_CASE("limit: a thin specimen on fine rollers snaps as one on edges") {
  const Fibre fine({.radius = 1e-4, .half_depth = 1e-4});
  for (const double w : {0.05, 0.2})
    CHECK(snap_length(fine, w, 0.5, 100) == doctest::Approx(snap_length({}, w, 0.5, 100)).epsilon(0.02));
}

TEST_CASE("identity: slips give back what they take, and rises are steep; cracks do neither") {
  const DropFeatures slips = features_of(a_slipping_record(), train), cracks = features_of(a_cracking_record(), train);
  CHECK(slips.drops > 10);
  CHECK(std::abs(slips.follows_drops) < 0.2);
  CHECK(slips.given_back > 0.8);
  CHECK(slips.steepness > 0.3);
  CHECK(slips.least_after_drop > 2);
  CHECK(cracks.drops == six_cracks.size());
  CHECK(std::abs(cracks.follows_drops - 1) < 0.3);
  CHECK(cracks.steepness < 0.15);
  CHECK(cracks.loss_needed == doctest::Approx(0.4).epsilon(0.08));
  CHECK(cracks.needed_at_end == doctest::Approx(0.5).epsilon(0.25));
  CHECK(slips.needed_at_end > 1.3);
}

TEST_CASE("identity: without drops nothing but what holds of all rows is told") {
  const DropFeatures smooth =
      features_of(simulated_record({.friction = Friction::constant(0.5), .stiffness = train, .noise = 0.01}), train);
  CHECK(smooth.drops == 0);
  CHECK(smooth.follows_drops == 0);
  CHECK_FALSE(is_loss_without_friction(smooth));
}

TEST_CASE("identity: a force that falls below any friction is a loss, however slowly it falls") {
  constexpr double stiff = 1000;
  ReducedRecord record = simulated_record(
      {.friction = Friction::constant(0.4), .stiffness = stiff, .noise = 0.001, .step = 2e-4, .deflection = 0.1});
  const std::size_t from = record.force.size() / 2, over = record.force.size() / 12;
  for (std::size_t i = from; i < record.force.size(); ++i) {
    const double part = std::min(1.0, static_cast<double>(i - from) / static_cast<double>(over));
    record.force[i] *= 1 - 0.3 * part;
    record.deflection[i] = record.stage[i] - record.force[i] / stiff;
  }
  const DropFeatures features = features_of(record, stiff);
  CHECK(features.drops == 0);
  CHECK(is_loss_without_friction(features));
}

TEST_CASE("limit: rows below the contact, rows that no friction explains and deep rows are no obstacle") {
  ReducedRecord record = a_slipping_record();
  for (double& force : record.force) force *= 3;
  CHECK(std::isfinite(features_of(record, train).needed_at_end));
  for (double& force : record.force) force *= -1;
  CHECK(features_of(record, train).drops == 0);
  ReducedRecord shallow{{1e-4, 2e-4}, {1e-4, 2e-4}, {0.1, 0.2}};
  CHECK(drop_features(shallow, {train}, {0.01, 0.03}, {}).drops == 0);
}

}  // namespace
}  // namespace flexslip
