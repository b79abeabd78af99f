#include "inference/drop_features.h"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/root.h"
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

// [EI/L^2] At a fixed deflection.
double force_by_friction(double S, double q) {
  const double w = fibre_state(S, q).w, step = 1e-3;
  const auto force_at = [&](double friction) {
    const auto is_beyond = [&](double each) { return fibre_state(each, friction).w > w; };
    return fibre_state(halved(60, {S - 0.01, S + 0.01}, is_beyond).high, friction).F;
  };
  return (force_at(q + step) - force_at(q - step)) / (2 * step);
}

// Rows of states that are written down one by one.
struct WrittenRecord {
  double k;
  ReducedRecord rows{};
  std::vector<Drop> drops{};

  void add(double S, double q) {
    const FibreState at = fibre_state(S, q);
    rows.stage.push_back(at.w + at.F / k);
    rows.deflection.push_back(at.w);
    rows.force.push_back(at.F);
  }

  void slide(double from, double to, double q, int steps) {
    for (int i = 0; i <= steps; ++i) add(from + (to - from) * i / steps, q);
  }

  // Draws in what the length of the snap says, which becomes S.
  void snap(double& S, double q, double to) {
    const std::size_t before = rows.stage.size() - 1;
    const double middle = std::midpoint(q, to);
    S += snap_length({}, fibre_state(S, middle).w, middle, k) * (q - to);
    add(S, to);
    drops.push_back({.before = before,
                     .after = before + 1,
                     .force_fall = rows.force[before] - rows.force[before + 1],
                     .advance = rows.deflection[before + 1] - rows.deflection[before],
                     .significance = 100});
  }

  // At friction .5, then to .4. Returns S.
  double slide_and_snap() {
    double S = 1.06;
    slide(1.02, S, 0.5, 80);
    snap(S, 0.5, 0.4);
    return S;
  }

  DropFeatures features() const { return drop_features(rows, {k}, {1e-4, 0.03}, drops); }
};

TEST_CASE("table: a snap from friction .5 to .4 on a soft and on a stiff load train") {
  struct Row {
    double k, w, advance;
  };
  const double S = fibre_state_from_force(0.2, 8.15814147).S;
  for (const auto& [k, w, advance] : {Row{30, 0.2066441, 0.006123}, Row{3000, 0.2001043, 1.85501e-4}}) {
    WrittenRecord record{k};
    record.add(S, 0.5);
    double after = S;
    record.snap(after, 0.5, 0.4);
    CHECK(after - S == doctest::Approx(advance).epsilon(0.02));
    CHECK(record.rows.deflection.back() == doctest::Approx(w).epsilon(3e-4));
    CHECK(record.rows.stage.back() == doctest::Approx(record.rows.stage.front()).epsilon(2e-3));
  }
}

TEST_CASE("table: features of a drop after which friction stays low, as after a crack that is read as friction") {
  for (const double k : {30.0, 3000.0}) {
    CAPTURE(k);
    WrittenRecord record{k};
    double S = record.slide_and_snap();
    const double drawn_in = S - 1.06;
    record.slide(S + 5e-4, 1.14, 0.4, 160);
    const DropFeatures features = record.features();
    CHECK(features.drops == 1);
    for (const double none : {features.max_steepness, features.recovery_near, features.recovery_far,
                              features.stiffness_recovery, features.roughness})
      CHECK(std::abs(none) < 0.01);
    CHECK(features.slid_in == doctest::Approx(drawn_in / (1.14 - 1.0208)).epsilon(0.1));
    CHECK(features.least_after_drop ==
          doctest::Approx(0.4 / std::hypot(0.03 * record.rows.force[81] / force_by_friction(S, 0.4), 0.05))
              .epsilon(0.02));
  }
}

TEST_CASE("table: features of a drop after which the specimen sticks until friction is back, as after a slip") {
  for (const double k : {30.0, 3000.0}) {
    CAPTURE(k);
    WrittenRecord record{k};
    double S = record.slide_and_snap();
    for (int i = 1; i <= 20; ++i) record.add(S, 0.4 + 0.005 * i);
    record.snap(S, 0.5, 0.4);
    for (int i = 1; i <= 20; ++i) record.add(S, 0.4 + 0.005 * i);
    const DropFeatures features = record.features();
    CHECK(features.drops == 2);
    for (const double whole :
         {features.max_steepness, features.recovery_near, features.recovery_far, features.stiffness_recovery})
      CHECK(whole == doctest::Approx(1).epsilon(0.06));
    CHECK(features.follows_drops < 0.3);  // two drops hardly move it from its prior of .5
    CHECK(features.needed_at_end > 0.65);
  }
}

TEST_CASE(
    "table: the loss that cracks need, of states that lost a tenth and a fifth of the stiffness at constant friction") {
  for (const double k : {30.0, 3000.0}) {
    CAPTURE(k);
    WrittenRecord record{k};
    const auto add = [&](double S, double left) {
      const FibreState at = fibre_state(S, 0.5);
      record.rows.stage.push_back(at.w + left * at.F / k);
      record.rows.deflection.push_back(at.w);
      record.rows.force.push_back(left * at.F);
    };
    double S = 1.02, left = 1;
    for (const double next : {0.9, 0.72, 0.0}) {
      for (int i = 0; i < 60; ++i) add(S += 5e-4, left);
      if (next == 0) break;
      const std::size_t before = record.rows.stage.size() - 1;
      const double stage = record.rows.stage.back();
      left = next;
      const auto is_beyond = [&](double each) {
        const FibreState at = fibre_state(each, 0.5);
        return at.w + left * at.F / k > stage;
      };
      add(S = halved(60, {S, S + 0.05}, is_beyond).high, left);
      record.drops.push_back({.before = before,
                              .after = before + 1,
                              .force_fall = record.rows.force[before] - record.rows.force[before + 1],
                              .advance = record.rows.deflection[before + 1] - record.rows.deflection[before],
                              .significance = 100});
    }
    const DropFeatures features = record.features();
    CHECK(features.drops == 2);
    CHECK(features.loss_needed == doctest::Approx(0.28).epsilon(0.02));
    CHECK(features.needed_at_end == doctest::Approx(0.5).epsilon(0.05));
    CHECK(features.follows_drops == doctest::Approx(1).epsilon(0.1));
    CHECK(features.recovery_far < 0.2);
  }
}

TEST_CASE("identity: slips give back what they take, and rises are steep; cracks do neither") {
  const DropFeatures slips = features_of(a_slipping_record(), train), cracks = features_of(a_cracking_record(), train);
  CHECK(slips.drops > 10);
  CHECK(std::abs(slips.follows_drops) < 0.2);
  CHECK(slips.stiffness_recovery > 0.8);
  CHECK(slips.max_steepness > 0.5);
  CHECK(slips.least_after_drop > 2);
  CHECK(cracks.drops == six_cracks.size());
  CHECK(std::abs(cracks.follows_drops - 1) < 0.3);
  CHECK(cracks.max_steepness < 0.3);
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
