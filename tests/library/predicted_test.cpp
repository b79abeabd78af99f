// States, simulations and designs of the library against those of the inner rooms.
#include <cmath>
#include <cstddef>
#include <string>

#include <doctest/doctest.h>

#include "answers/design_fields.h"
#include "case/case_file.h"
#include "case/simulated_test.h"
#include "design/design_answer.h"
#include "design/design_result.h"
#include "fibre/elastica.h"
#include "flexslip/flexslip.h"
#include "report/answer_documents.h"
#include "result/table.h"
#include "tests/has.h"

namespace flexslip {
namespace {

const v1::Setup glass{.diameter = 34.8e-6, .modulus = {29.6e9, 0.9e9}, .span = 1278e-6, .load_train_stiffness = 90.65};
const v1::Friction wavy{.mu0 = 0.5, .waves = {{.amplitude = 0.15, .wavelength = 10.9e-6}}};
constexpr std::string_view as_case = R"(
[specimen]
diameter = "34.8 um"
modulus = { value = "29.6 GPa", uncertainty = "0.9 GPa" }
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoids"
mu0 = 0.5
waves = [{ amplitude = 0.15, wavelength = "10.9 um" }]
[stage]
program = ["0 um", "700 um"]
step = "2 um"
)";

// The message of the library, with the parts of its error.
template <class Call>
v1::Error error_of(const Call& call) {
  try {
    call();
  } catch (const v1::Error& error) {
    return error;
  }
  return {"", "", ""};
}

TEST_CASE("a state on edges is that of the elastica, in SI") {
  const v1::Setup slender{.bending_stiffness = 2e-9, .span = 1e-3};
  const FibreState inner = fibre_state(1.1, 0.3);
  const v1::State state = v1::state_at(slender, 1e-3 * inner.w, 0.3);
  const double error = 1e-11;  // of the header
  CHECK(state.force == doctest::Approx(inner.F * 2e-9 / 1e-6).epsilon(error));
  CHECK(state.length == doctest::Approx(1.1e-3).epsilon(error));
  CHECK(state.slope == doctest::Approx(inner.theta0).epsilon(error));
  CHECK(state.normal_force == doctest::Approx(inner.Pn * 2e-9 / 1e-6).epsilon(error));
  CHECK(state.energy == doctest::Approx(inner.U * 2e-9 / 1e-3).epsilon(error));
  CHECK(state.curvature == doctest::Approx(curvature_at_midspan(inner) / 1e-3).epsilon(error));
  const v1::State again = v1::state_from_force(slender, state.deflection, state.force);
  CHECK(again.friction == doctest::Approx(0.3).epsilon(1e-9));
}

TEST_CASE("a bending stiffness follows from modulus and section; at small deflection the force is 48 EI w/L^3") {
  const double EI = 29.6e9 * std::acos(-1) * std::pow(34.8e-6, 4) / 64, w = 1e-7;
  CHECK(v1::state_at(glass, w, 0).force == doctest::Approx(48 * EI * w / std::pow(1278e-6, 3)).epsilon(1e-5));
}

TEST_CASE("a simulation is that of the same case, bit for bit") {
  const Test test = read_case(as_case, "");
  const SimulatedTest inner = simulate(test, {.noise = 1e-5, .seed = 7});
  const v1::Simulation simulation =
      v1::simulate(glass, wavy, {.stages = {0, 700e-6}, .step = 2e-6, .force_noise = 1e-5, .seed = 7});
  REQUIRE(simulation.path.size() == inner.simulation.path.size());
  for (std::size_t i = 0; i < simulation.path.size(); ++i) {
    CHECK(simulation.path[i].stage == inner.simulation.path[i].stage);
    CHECK(simulation.path[i].force == inner.simulation.path[i].force);
    CHECK(simulation.path[i].motion == inner.simulation.path[i].motion);
  }
  REQUIRE(simulation.snaps.size() == inner.simulation.snaps.size());
  CHECK(simulation.snaps.front().force_before == inner.scales.physical_force(inner.simulation.snaps.front().before.F));
  CHECK(simulation.energies.friction == inner.scales.physical_energy(inner.simulation.energy.friction));
  const v1::Energies& energies = simulation.energies;
  CHECK(energies.stage_work ==
        doctest::Approx(energies.bending + energies.load_train + energies.friction + energies.snaps).epsilon(1e-9));
  CHECK(simulation.why_it_ends.empty());
}

TEST_CASE("friction as a list of points is what the same waves give") {
  v1::Friction listed;
  for (int i = 0; i <= 4000; ++i) {
    const double length = 1278e-6 + 0.25e-6 * i;
    listed.points.push_back({length, 0.5 * (1 + 0.15 * std::cos(std::acos(-1) * length / 10.9e-6))});
  }
  const v1::Programme loading{.stages = {0, 700e-6}, .step = 2e-6};
  const v1::Simulation waves = v1::simulate(glass, wavy, loading), points = v1::simulate(glass, listed, loading);
  CHECK(points.snaps.size() == waves.snaps.size());
  CHECK(points.energies.friction == doctest::Approx(waves.energies.friction).epsilon(1e-3));
}

TEST_CASE("a design is that of the same case") {
  const DesignAnswer inner = answer_of(one_loading_of(read_case(as_case, "")));
  const v1::Design design = v1::design(glass, wavy, 700e-6, 2e-6);
  CHECK(design.snaps == inner.outcome.snaps);
  CHECK(design.largest_drop == inner.scales.physical_force(inner.outcome.largest_drop));
  CHECK(design.critical_stiffness == inner.scales.physical_stiffness(inner.critical));
  CHECK(design.json == json_text(design_fields()({inner, design_in_short(inner), changes_in_words(inner)},
                                                 {inner.scales, inner.input.reduced})));
}

TEST_CASE("an error names the key, what is wrong and what to do") {
  const v1::Error missing = error_of([] { v1::simulate({.diameter = 1e-5, .modulus = 1e9}, wavy, {{0, 1e-4}, 1e-6}); });
  CHECK(missing.key == "rig.span");
  CHECK(has(missing.what(), "[rig] span: This value is missing"));
  CHECK(has(missing.remedy, "span"));
  CHECK(missing.line == 0);
  const v1::Error nan = error_of([] { v1::simulate(glass, wavy, {{0, v1::not_known}, 1e-6}); });
  CHECK(has(nan.key, "stage.program"));
  const v1::Error twice = error_of([] { v1::design(glass, {.mu0 = 0.5, .points = {{1e-3, 0.5}}}, 7e-4, 2e-6); });
  CHECK(twice.problem == "Friction is either mu0 with waves, or a list of points, not both");
  const v1::Error deep = error_of([] { v1::state_at(glass, 1278e-6, -15); });
  CHECK(has(deep.problem, "No state with a force exists at a deflection of 0.001278 m with a friction of -15"));
  CHECK(has(error_of([] { v1::state_at(glass, -1e-6, 0); }).problem, "The deflection is -1e-06 m, not from"));
  CHECK(has(error_of([] { v1::state_at(glass, 3e-4, v1::not_known); }).problem, "The friction is nan, not from -20"));
  CHECK(has(error_of([] { v1::state_from_force(glass, 3e-4, 1); }).problem, "No friction from -2 to 2 gives 1 N"));
}

}  // namespace
}  // namespace flexslip
