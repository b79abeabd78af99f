#include "cases/design_case.h"

#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "cases/design_answer.h"
#include "cases/design_map.h"
#include "cases/problem.h"
#include "tests/approximately.h"
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
  const Design design = DesignCase(input).design();
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
  const Design a = varied.design();
  const Design b = design_of(text).design();
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
  CHECK(message_of([&] { input.set(DesignParameter::amplitude, 1.5); }).find("amplitude: expected") == 0);
  CHECK(message_of([&] { input.set(DesignParameter::stiffness, 0); }).find("stiffness: expected") == 0);
  input.set(DesignParameter::diameter, 300e-6);
  CHECK(message_of([&] { input.design(); }).find("diameter: expected less than a fifth of the span") == 0);
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
    CHECK(outcome_of(before.design()).snaps > 0);
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

TEST_CASE("design answer, oracle: the margin vanishes where the specimen begins to snap") {
  DesignCase input = design_of(spicule);
  const auto answer = answer_of(input);
  input.set(DesignParameter::stiffness, answer.changes.front().to);
  CHECK(std::abs(stiffness_margin(input.design())) <
        0.03);  // the range is known to 1 %, the stiffness goes as its square
}

TEST_CASE("design map, identity: its points are the outcomes at its values") {
  const DesignCase input = design_of(spicule);
  const std::vector<MapAxis> axes{map_axis(input, "stiffness=20 N/m:400 N/m:4", 10), map_axis(input, "mu0=0:0.6", 3)};
  CHECK(axes[0].logarithmic);
  CHECK(axes[1].values == std::vector{0.0, 0.3, 0.6});
  const auto points = design_map(input, axes);
  REQUIRE(points.size() == 12);
  for (const auto& point : points) {
    DesignCase there = input;
    there.set(DesignParameter::stiffness, point.values[0]);
    there.set(DesignParameter::mu0, point.values[1]);
    CHECK(point.outcome->snaps == outcome_of(there.design()).snaps);
  }
}

TEST_CASE("design map, contract: a range that makes no sense is refused with a remedy") {
  const DesignCase input = design_of(spicule);
  CHECK(message_of([&] { map_axis(input, "stiffnes=1 N/m:2 N/m", 5); }).find("did you mean 'stiffness'?") !=
        std::string::npos);
  CHECK(message_of([&] { map_axis(input, "stiffness=1:2", 5); }).find("unit") != std::string::npos);
  CHECK(message_of([&] { map_axis(input, "mu0=0:1:1", 5); }).find("points") != std::string::npos);
  CHECK(message_of([&] { map_axis(input, "mu0", 5); }).find("write it as") != std::string::npos);
}

}  // namespace flexslip
