#include "cases/design_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <variant>

#include <doctest/doctest.h>

#include "bending_test/rig.h"
#include "cases/design_answer.h"
#include "cases/design_map.h"
#include "cases/problem.h"
#include "tests/approximately.h"
#include "tests/generators.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

const std::string spicule = R"([specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.15
wavelength = "40 um"
phase = 1.0
[stage]
program = ["0 um", "700 um"]
step = "2 um"
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = spicule;
  text.replace(text.find(from), from.size(), to);
  return text;
}

DesignCase design_of(const std::string& text) { return DesignCase(read_case(text, "case.toml")); }
std::string refusal_of(const std::string& text) {
  return message_of([&] { design_of(text); });
}

}  // namespace

TEST_CASE("design case, identity: unchanged, it is the test that the case describes") {
  const Case input = read_case(spicule, "case.toml");
  const Design design = DesignCase(input).planned().design;
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  CHECK(design.rig.stiffness == rig_of(input, scales).stiffness);
  CHECK(design.travel == scales.reduced_length(700e-6));
  CHECK(design.step == scales.reduced_length(2e-6));
  const Friction friction = friction_of(input, scales, 2);
  for (const double S : {1.0, 1.1, 1.37}) CHECK(design.friction.at(S).mu == friction.at(S).mu);
}

TEST_CASE("design case, identity: a number set is the same as one read") {
  DesignCase varied = design_of(spicule);
  varied.set(DesignParameter::span, 1500e-6);
  varied.set(DesignParameter::diameter, 40e-6);
  varied.set(DesignParameter::wavelength, 20e-6);
  std::string text = with("1278 um", "1500 um");
  text.replace(text.find("34.8 um"), 7, "40 um");
  text.replace(text.find("\"40 um\"\nphase"), 7, "\"20 um\"");
  const Design a = varied.planned().design;
  const Design b = design_of(text).planned().design;
  CHECK(a.rig.stiffness == b.rig.stiffness);
  CHECK(a.travel == b.travel);
  for (const double S : {1.0, 1.1, 1.37}) CHECK(a.friction.at(S).mu == b.friction.at(S).mu);
}

TEST_CASE("design case, limit: it has the parameters that its kind of case can vary") {
  CHECK(design_of(spicule).has(DesignParameter::diameter));
  const DesignCase flat = design_of(with("diameter = \"34.8 um\"", "width = \"40 um\"\nheight = \"30 um\""));
  CHECK_FALSE(flat.has(DesignParameter::diameter));
  CHECK(flat.has(DesignParameter::modulus));
  const DesignCase reduced = design_of(
      "reduced = true\n[rig]\nstiffness = 30\n[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\nprogram = [0, "
      "0.6]\n");
  CHECK_FALSE(reduced.has(DesignParameter::span));
  CHECK_FALSE(reduced.has(DesignParameter::wavelength));
  CHECK(reduced.value(DesignParameter::step) == 0);  // continuous
}

TEST_CASE("design case, contract: what cannot be loaded once is refused at its line") {
  CHECK(refusal_of(with("\"700 um\"", "\"700 um\", \"100 um\", \"900 um\"")).find("case.toml:14: [stage] program[3]") ==
        0);
  CHECK(refusal_of(with("\"0 um\"", "\"1 um\"")).find("case.toml:14: [stage] program[1]") == 0);
  CHECK(refusal_of(with("step = \"2 um\"", "snaps = \"overshoot\"")).find("flexslip simulate") != std::string::npos);
  CHECK(refusal_of(with("phase = 1.0", "static_excess = 0.1")).find("[friction] static_excess") != std::string::npos);
  CHECK(refusal_of(with("stiffness = \"90.65 N/m\"", "")).find("[rig] stiffness") != std::string::npos);
}

TEST_CASE("design case, contract: a number out of its range is refused with its name") {
  DesignCase input = design_of(spicule);
  CHECK(message_of([&] {
          input.set(DesignParameter::amplitude, 1.5);
        }).find("amplitude: expected a number of at least 0 and at most 1") == 0);
  CHECK(message_of([&] { input.set(DesignParameter::stiffness, 0); }).find("stiffness: expected") == 0);
  input.set(DesignParameter::diameter, 300e-6);
  CHECK(message_of([&] {
          static_cast<void>(input.planned());
        }).find("diameter: expected less than a fifth of the span") == 0);
}

TEST_CASE("design result, table: what is no test, and what is beyond FlexSlip, are told apart") {
  const auto status_with = [](DesignParameter parameter, double value) {
    DesignCase input = design_of(spicule);
    input.set(parameter, value);
    return result_of(input).status;
  };
  CHECK(status_with(DesignParameter::step, 3e-6) == ResultStatus::ok);
  CHECK(status_with(DesignParameter::diameter, 300e-6) == ResultStatus::impossible);
  CHECK(status_with(DesignParameter::stiffness, 1e-6) == ResultStatus::impossible);
  CHECK(status_with(DesignParameter::wavelength, 1e-12) == ResultStatus::not_computable);
  CHECK(status_with(DesignParameter::mu0, 19) == ResultStatus::not_computable);  // the wave goes beyond 20
  CHECK(status_with(DesignParameter::step, 1e-30) == ResultStatus::not_computable);
  CHECK(status_with(DesignParameter::travel, 1) == ResultStatus::not_computable);
  CHECK(status_with(DesignParameter::modulus, 1e308) == ResultStatus::impossible);  // the rig is too soft for it
}

TEST_CASE("design result, contract: whatever the numbers, it is computed or refused with a word") {
  CHECK(rc::check([] {
    DesignCase input = design_of(spicule);
    for (const auto& known : design_parameters()) {
      if (*whole(0, 2) > 0) continue;
      const double value = *whole(0, 4) == 0 ? std::pow(10, *between(-300, 300))
                                             : input.value(known.parameter) * std::pow(10, *between(-3, 3));
      if (is_within(known, value)) input.set(known.parameter, value);
    }
    const auto plan = input.plan();
    const auto* planned = std::get_if<PlannedDesign>(&plan);
    // Millions of periods take their time.
    const bool is_quick =
        !planned || longest_at_stage(planned->design.travel) - 1 < 1e4 * planned->design.friction.smooth_scale();
    RC_PRE(is_quick);
    const auto result = result_of(input);
    RC_ASSERT(result.outcome.has_value() == (planned != nullptr));
    if (planned) RC_ASSERT(!std::isnan(stiffness_margin(planned->design, *result.outcome)));
  }));
}

TEST_CASE("design answer, limit: from displacement control a softer load train down to the critical one is offered") {
  DesignCase input = design_of(spicule);
  const auto soft = answer_of(input);
  input.set(DesignParameter::stiffness, std::numeric_limits<double>::infinity());
  const auto stiff = answer_of(input);
  CHECK(stiff.critical == soft.critical);  // the stiffness of the design itself does not count
  REQUIRE(stiff.outcome.snaps == 0);
  REQUIRE(stiff.changes.front().parameter == DesignParameter::stiffness);
  CHECK(stiff.changes.front().to == to(2e-4, stiff.scales.physical_stiffness(stiff.critical)));  // a hair softer
  CHECK(soft.changes.front().to == soft.scales.physical_stiffness(soft.critical));
  for (const double stiffness : {1e3, 1e5, 1e7}) {
    input.set(DesignParameter::stiffness, stiffness);
    CHECK(answer_of(input).changes.front().to == stiff.changes.front().to);
  }
}

TEST_CASE("design answer, limit: what is 0 can be raised to where the specimen snaps, and a hair before it does not") {
  for (const auto parameter : {DesignParameter::mu0, DesignParameter::amplitude}) {
    CAPTURE(described(parameter).name);
    DesignCase input = design_of(spicule);
    input.set(parameter, 0);
    const auto answer = answer_of(input);
    REQUIRE(answer.outcome.snaps == 0);
    const auto change = std::find_if(answer.changes.begin(), answer.changes.end(),
                                     [&](const DesignChange& found) { return found.parameter == parameter; });
    REQUIRE(change != answer.changes.end());
    input.set(parameter, change->to * (1 - 2e-4));  // twice what the search leaves
    CHECK(result_of(input).outcome->snaps == 0);
    input.set(parameter, change->to);
    CHECK(result_of(input).outcome->snaps > 0);
  }
}

TEST_CASE("design answer, identity: each change makes it otherwise, and a hair before it nothing has changed") {
  const DesignCase input = design_of(spicule);
  const auto answer = answer_of(input);
  REQUIRE(answer.outcome.snaps > 0);
  REQUIRE(answer.changes.size() == 8);
  for (const auto& change : answer.changes) {
    CAPTURE(described(change.parameter).name);
    CHECK(change.outcome.snaps == 0);
    DesignCase before = input;
    before.set(change.parameter,
               change.to * (change.from > change.to ? 1 + 2e-4 : 1 - 2e-4));  // twice what the search leaves
    CHECK(outcome_of(before.planned().design).snaps > 0);
  }
}

TEST_CASE("design answer, limit: stiffness, diameter and modulus change the same number") {
  const auto answer = answer_of(design_of(spicule));
  double stiffness = 0, diameter = 0, modulus = 0;
  for (const auto& [parameter, from, to, outcome] : answer.changes) {
    if (parameter == DesignParameter::stiffness) stiffness = to / from;
    if (parameter == DesignParameter::diameter) diameter = to / from;
    if (parameter == DesignParameter::modulus) modulus = to / from;
  }
  CHECK(modulus == to(1e-12, 1 / stiffness));  // k L^3/EI, I as the fourth power of the diameter
  CHECK(std::pow(diameter, 4) == to(1e-12, 1 / stiffness));
}

TEST_CASE("design answer, identity: the study of phases is the same from the next of them") {
  DesignCase input = design_of(spicule);
  const auto usual = answer_of(input);
  const double own = usual.scales.physical_stiffness(usual.critical);
  const double worst = usual.scales.physical_stiffness(usual.phases.value().critical);
  REQUIRE(own < worst);
  for (const double stiffness : {0.5 * own, 0.5 * (own + worst), 1.001 * worst}) {  // all of them snap, some, none
    CAPTURE(stiffness);
    input.set(DesignParameter::stiffness, stiffness);
    const auto here = answer_of(input).phases.value();
    DesignCase turned = input;
    turned.set(DesignParameter::phase, input.value(DesignParameter::phase) + 2 * std::numbers::pi / 24);
    const auto next = answer_of(turned).phases.value();
    CHECK(here.phases == 24);
    CHECK(here.snapping == next.snapping);
    CHECK((here.snapping == 24) == (stiffness < own));
    CHECK((here.snapping == 0) == (stiffness > worst));
    CHECK(here.least_drop == to(1e-6, next.least_drop));
    CHECK(here.largest_drop == to(1e-6, next.largest_drop));
    CHECK(here.critical == to(1e-6, next.critical));
  }
  input.set(DesignParameter::amplitude, 0);
  CHECK_FALSE(answer_of(input).phases);  // no waves, no phase
}

TEST_CASE("design map, identity: its points are the outcomes at its values") {
  const DesignCase input = design_of(spicule);
  const std::vector<MapAxis> axes{map_axis(input, "stiffness=20 N/m:400 N/m:4", 10), map_axis(input, "mu0=0:0.6", 3)};
  CHECK(axes[0].logarithmic);
  CHECK(axes[1].values == std::vector{0.0, 0.3, 0.6});
  const auto points = design_map(input, axes, 2);
  REQUIRE(points.size() == 12);
  for (const auto& point : points) {
    DesignCase there = input;
    there.set(DesignParameter::stiffness, point.values[0]);
    there.set(DesignParameter::mu0, point.values[1]);
    CHECK(point.result.outcome->snaps == outcome_of(there.planned().design).snaps);
  }
}

TEST_CASE("design map, contract: a range that makes no sense is refused with a remedy") {
  const DesignCase input = design_of(spicule);
  CHECK(message_of([&] { map_axis(input, "stiffnes=1 N/m:2 N/m", 5); }).find("did you mean 'stiffness'?") !=
        std::string::npos);
  CHECK(message_of([&] { map_axis(input, "stiffness=1:2", 5); }).find("unit") != std::string::npos);
  CHECK(map_axis(input, "phase=0:90 deg", 5).values.back() == to(1e-15, std::numbers::pi / 2));
  CHECK(map_axis(input, "phase=0:6.25", 5).values.back() == 6.25);  // radians
  CHECK(message_of([&] { map_axis(input, "mu0=0:1:1", 5); }).find("points") != std::string::npos);
  CHECK(message_of([&] { map_axis(input, "mu0", 5); }).find("write it as") != std::string::npos);
}

}  // namespace flexslip
