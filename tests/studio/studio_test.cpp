#include "studio/studio.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "case/mechanics.h"
#include "case/simulated_test.h"
#include "fibre/elastica.h"
#include "io/input_error.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

studio::RigInput rig_with(FrictionTable friction, double stiffness = 90.65, double roller_radius = 0,
                          double depth = 0) {
  return {.span = 1278e-6,
          .depth = depth,
          .bending_stiffness = 2.13e-9,
          .stiffness = stiffness,
          .roller_radius = roller_radius,
          .friction = std::move(friction)};
}

// From lengths that rollers leave between the contacts to beyond those that are drawn in.
template <class Profile>
FrictionTable table_of(double step, const Profile& mu) {
  FrictionTable table;
  for (double S = 1.1e-3; S < 2.6e-3; S += step) {
    table.S.push_back(S);
    table.mu.push_back(mu(S));
  }
  return table;
}

FrictionTable sinusoid(double amplitude, double wavelength = 11e-6) {
  return table_of(wavelength / 8,
                  [&](double S) { return 0.5 * (1 + amplitude * std::cos(3.141592653589793 * S / wavelength + 0.7)); });
}

const FrictionTable rough = [] {
  const Friction reduced = Friction::rough(0.4, 0.15, 8e-6 / 1278e-6, 7, 2.1);
  return table_of(2e-6, [&](double S) { return reduced.at(S / 1278e-6).mu; });
}();

// The test that says the same.
Test test_of(const studio::RigInput& rig, const std::vector<double>& programme, std::optional<double> step) {
  Test test;
  test.specimen = SpecimenInput{.bending_stiffness = Known{rig.bending_stiffness, 0}};
  if (rig.depth > 0) test.specimen->diameter = rig.depth;
  test.rig = RigInput{.span = rig.span, .stiffness = rig.stiffness, .roller_radius = rig.roller_radius};
  test.friction = FrictionInput{.model = FrictionModel::table,
                                .file = "friction.csv",
                                .points = std::make_shared<const FrictionTable>(rig.friction)};
  test.stage = StageInput{.program = programme, .step = step};
  return test;
}

Simulation simulated_by(const Test& input) {
  const Scales scales = scales_of(input);
  const StageProgramme programme = programme_of(input);
  const BendingTest test = bending_test_of(input, scales, scales.reduced_length(programme.farthest));
  std::vector<double> stages;
  for (const double position : programme.positions) stages.push_back(scales.reduced_length(position));
  const History history = programme.in_steps ? follow_in_steps(test, stages) : follow_continuously(test, stages, 200);
  return simulated(input, history, test.rig.fibre, scales, {1e-9});
}

struct Asked {
  std::string name;
  studio::RigInput rig;
};

const std::vector<Asked> many{{"wave", rig_with(sinusoid(0.15))},
                              {"rough", rig_with(rough)},
                              {"on rollers, thick", rig_with(sinusoid(0.02), 400, 60e-6, 34.8e-6)},
                              {"displacement controlled", rig_with(sinusoid(0.15), infinity)}};

void check_same(const studio::Loading& loading, const Simulation& test, bool in_steps) {
  REQUIRE(loading.force.size() == test.path.size());
  REQUIRE(loading.status == test.status);
  REQUIRE(loading.snaps.size() == test.snaps.size());
  for (std::size_t i = 0; i < test.path.size(); ++i) {
    CAPTURE(i);
    if (!in_steps) CHECK(loading.stage[i] == test.path[i].stage);
    CHECK(loading.deflection[i] == test.path[i].deflection);
    CHECK(loading.force[i] == test.path[i].force);
    CHECK(loading.drawn[i] == test.path[i].drawn_in);
    CHECK(loading.friction[i] == test.path[i].q);
  }
}

}  // namespace

TEST_CASE("studio: a loading has the same bits as the equivalent case (oracle: the program)") {
  const std::vector<double> programme{0, 5e-4, 2e-4, 6e-4};
  for (const Asked& asked : many) {
    CAPTURE(asked.name);
    const auto stepped = studio::simulate(asked.rig, programme, 2e-6, 0);
    check_same(stepped, simulated_by(test_of(asked.rig, programme, 2e-6)), true);
    CHECK(stepped.stage == stage_steps(programme, 2e-6));
    const auto continuous = studio::simulate(asked.rig, programme, std::nullopt, 200);
    check_same(continuous, simulated_by(test_of(asked.rig, programme, std::nullopt)), false);
  }
}

TEST_CASE(
    "studio: a sketch is the loading to a thousandth of its greatest force, but for a step beside each snap (oracle: "
    "simulate)") {
  const FrictionTable sparse{{1278e-6, 1290e-6, 1320e-6, 1400e-6, 1700e-6, 2600e-6}, {0.4, 0.5, 0.3, 0.45, 0.4, 0.5}};
  constexpr double farthest = 560e-6;
  constexpr int steps = 800;
  for (const auto& rig :
       {rig_with(sinusoid(0.15)), rig_with(sinusoid(0.3), 90.65, 0, 34.8e-6), rig_with(sinusoid(0.3), infinity),
        rig_with(rough), rig_with(sparse, 90.65, 50e-6, 34.8e-6), rig_with(sparse, 30)}) {
    const studio::Loading exact = studio::simulate(rig, std::vector{0.0, farthest}, farthest / steps, 0);
    const studio::Loading sketch = studio::sketch(rig, farthest, steps);
    REQUIRE(sketch.stage.size() == steps + 1);
    const std::size_t before = exact.stage.front() == 0 ? 0 : 1;  // whether the straight fibre is among the steps
    REQUIRE(exact.stage.size() + before == sketch.stage.size());
    const double most = *std::max_element(exact.force.begin(), exact.force.end());
    std::size_t off = 0;
    for (std::size_t i = 0; i < exact.stage.size(); ++i) {
      const std::size_t j = i + before;
      CHECK(sketch.stage[j] == doctest::Approx(exact.stage[i]));
      off += std::abs(sketch.force[j] - exact.force[i]) > 1e-3 * most;
      off += std::abs(sketch.deflection[j] - exact.deflection[i]) >
             1e-3 * most / std::min(rig.stiffness, 1e3) + 1e-7 * 1278e-6;
    }
    CAPTURE(exact.snaps.size());
    CHECK(off <= 4 * exact.snaps.size());
    CHECK(sketch.drawn.back() == doctest::Approx(exact.drawn.back()).epsilon(0.01));
  }
  CHECK_THROWS_AS(studio::sketch(rig_with(sinusoid(0.15)), 5e-3, steps), std::invalid_argument);
}

TEST_CASE("studio: the equilibrium curve passes through every sliding state of a stiff rig") {
  const auto rig = rig_with(sinusoid(0.05), infinity);
  const auto curve = studio::equilibrium(rig, 1.2 * rig.span, 50);
  REQUIRE(curve.status == "ok");
  const std::vector<double> programme{0, curve.deflection[20], curve.deflection[40]};
  const auto loading = studio::simulate(rig, programme, 1.0, 0);
  for (const std::size_t i : {1U, 2U}) CHECK(loading.force[i] == doctest::Approx(curve.force[20 * i]).epsilon(1e-12));
}

TEST_CASE(
    "studio: the shape ends level at midspan, bent by the deflection (identity), and is the elastica's on edges "
    "(oracle: fibre_shape)") {
  for (const double depth : {0.0, 34.8e-6})
    for (const double radius : {0.0, 80e-6})
      for (const double friction : {-0.3, 0.0, 0.5})
        for (const double deflection : {0.02, 0.2, 0.5}) {
          CAPTURE(depth);
          CAPTURE(radius);
          CAPTURE(friction);
          CAPTURE(deflection);
          auto rig = rig_with(sinusoid(0), infinity, radius, depth);
          const studio::Shape shape = studio::shape(rig, deflection * rig.span, friction, 100, 4e-4);
          const std::size_t middle = shape.axis.size() / 2;
          CHECK(std::abs(shape.axis[middle].x) < 1e-6 * rig.span);
          CHECK(std::abs(-shape.axis[middle].y / rig.span - deflection) < 1e-6);
          // The force that this deflection and friction have, by the equilibrium of the forces at the supports.
          CHECK(shape.force ==
                doctest::Approx(2 * (shape.normal * std::cos(shape.slope) + shape.tangential * std::sin(shape.slope)))
                    .epsilon(1e-9));
          CHECK(shape.axis[middle - 1].y - shape.axis[middle].y < 1e-3 * rig.span);
          if (depth == 0 && radius == 0) {
            const FibreState state = fibre_state(1 + shape.slid / rig.span, friction);
            CHECK(std::abs(state.w - deflection) < 1e-9);
            for (std::size_t i = 1; i <= 101; ++i) {
              const ShapePoint exact = fibre_shape(state, static_cast<double>(i - 1) / 100);
              CHECK(std::abs(shape.axis[i].x / rig.span + 0.5 - exact.x) < 1e-6);
              CHECK(std::abs(shape.axis[i].y / rig.span + exact.y) < 1e-6);
            }
          }
        }
}

// A thick bar on rollers has two states of one length between its contacts: the shape is that of its deflection.
TEST_CASE("studio: the forces at the rollers of a thick bar carry the force at midspan (identity)") {
  studio::RigInput rig = rig_with(sinusoid(0), infinity, 5e-3, 4e-3);
  rig.span = 64e-3;
  double before = -infinity;
  for (const double deflection : {1e-3, 5.3e-3, 18.8e-3}) {
    const studio::Shape shape = studio::shape(rig, deflection, 0.75, 100, 20e-3);
    CHECK(shape.force ==
          doctest::Approx(2 * (shape.normal * std::cos(shape.slope) + shape.tangential * std::sin(shape.slope))));
    CHECK(-shape.axis[shape.axis.size() / 2].y == doctest::Approx(deflection).epsilon(1e-4));
    CHECK(shape.slid > before);
    before = shape.slid;
  }
}

TEST_CASE("studio: Euler and Bernoulli are the limit of a small deflection without friction") {
  const auto rig = rig_with({{1e-3, 2e-3}, {0, 0}}, infinity);
  const std::vector<double> programme{0, 1e-4 * rig.span};
  const auto loading = studio::simulate(rig, programme, 1.0, 0);
  CHECK(loading.force.back() == doctest::Approx(studio::euler_bernoulli(rig, 1e-4 * rig.span)).epsilon(1e-6));
}

TEST_CASE("identity: studio: earlier calls change no bit of an answer") {
  const std::vector<double> programme{0, 4e-4, 1e-4};
  const auto asked = rig_with(sinusoid(0.15), 90.65, 0, 34.8e-6);
  const auto first = studio::simulate(asked, programme, 2e-6, 0);
  for (const auto& [radius, depth] : {std::pair{0.0, 30e-6}, {20e-6, 34.8e-6}, {0.0, 0.0}}) {
    studio::simulate(rig_with(sinusoid(0.3), 40, radius, depth), programme, 1e-6, 0);
    studio::shape(rig_with(sinusoid(0.3), 40, 0, 34.8e-6), 1e-4, 0.7, 20, 0);
    const auto again = studio::simulate(asked, programme, 2e-6, 0);
    CHECK(again.force == first.force);
    CHECK(again.drawn == first.drawn);
  }
}

TEST_CASE("studio: a box accepts the same text as the program, and refuses other text with the reason") {
  const auto sentence = [](std::string_view words, std::string_view kind) -> std::string {
    try {
      studio::quantity(words, kind);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(studio::quantity("1278 um", "a length") == 1278e-6);
  CHECK(studio::quantity("90.65 N/m", "a stiffness") == 90.65);
  CHECK(studio::quantity("inf", "a stiffness") == infinity);
  CHECK(studio::quantity("29.6 GPa", "a modulus") == 29.6e9);
  CHECK(studio::unit("mN", "a force") == 1e-3);
  CHECK(sentence("1278 N", "a length") != "");
  CHECK(sentence("90.65 GPa", "a stiffness") != "");
  CHECK(sentence("1278", "a length") != "");
  CHECK(sentence("-3 mm", "a length") != "");
  CHECK(sentence("inf", "a length") != "");
  CHECK_THROWS_AS(studio::unit("mm", "a force"), InputError);
}

TEST_CASE("studio: a test that cannot be computed is refused with a sentence") {
  CHECK_THROWS_AS(studio::simulate(rig_with(sinusoid(0.1)), {}, 1e-6, 0), std::invalid_argument);
  const std::vector<double> programme{0, 5e-4};
  CHECK_THROWS_AS(studio::simulate(rig_with(sinusoid(0.1)), programme, -1e-6, 0), std::invalid_argument);
  CHECK_THROWS_AS(studio::simulate(rig_with(sinusoid(1.5)), programme, 1e-6, 0), std::invalid_argument);
  CHECK_THROWS_AS(studio::simulate(rig_with(sinusoid(0.1), 90, 0.6e-3), programme, 1e-6, 0), std::invalid_argument);
  CHECK_THROWS_AS(studio::shape(rig_with(sinusoid(0.1)), 1, -5, 10, 0), std::invalid_argument);
}

}  // namespace flexslip
