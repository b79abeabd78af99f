#include "design/design_case.h"

#include <string>
#include <variant>

#include <doctest/doctest.h>

#include "case/problem.h"
#include "tests/approximately.h"
#include "tests/design/some_design.h"
#include "tests/refusal.h"

namespace flexslip {

namespace {

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
  const Friction friction = friction_of(input, Fibre(), scales, 2);
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

TEST_CASE("design case, identity: a flat specimen set to another section is the same as one read with it") {
  const auto flat = [](const std::string& section) { return design_of(with("diameter = \"34.8 um\"", section)); };
  DesignCase varied = flat("width = \"40 um\"\nheight = \"30 um\"");
  varied.set(DesignParameter::width, 50e-6);
  varied.set(DesignParameter::height, 25e-6);
  const auto read = flat("width = \"50 um\"\nheight = \"25 um\"").planned();
  CHECK(varied.planned().units.scales.bending_stiffness() == read.units.scales.bending_stiffness());
  varied.set(DesignParameter::height, 300e-6);
  CHECK(message_of([&] { varied.planned(); }).find("height: expected less than a fifth of the span") == 0);
}

TEST_CASE("design case, limit: it has the parameters that its kind of case can vary") {
  CHECK(design_of(spicule).has(DesignParameter::diameter));
  const DesignCase flat = design_of(with("diameter = \"34.8 um\"", "width = \"40 um\"\nheight = \"30 um\""));
  CHECK_FALSE(flat.has(DesignParameter::diameter));
  CHECK(flat.value(DesignParameter::height) == 30e-6);
  CHECK(flat.value(DesignParameter::width) == 40e-6);
  CHECK(flat.has(DesignParameter::modulus));
  const DesignCase reduced = design_of(
      "reduced = true\n[rig]\nstiffness = 30\n[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\nprogram = [0, "
      "0.6]\n");
  CHECK_FALSE(reduced.has(DesignParameter::span));
  CHECK_FALSE(reduced.has(DesignParameter::wavelength));
  CHECK(reduced.value(DesignParameter::step) == 0);  // continuous
}

TEST_CASE("design case, identity: friction drifts from its reference, which can be varied") {
  const std::string drifting = with("phase = 1.0", "phase = 1.0\ndrift = \"0.8 1/mm\"\nreference = \"1.4 mm\"");
  const Case input = read_case(drifting, "case.toml");
  DesignCase design(input);
  const Friction friction = friction_of(input, Fibre(), scales_of(input, bending_stiffness_of(input)), 2);
  for (const double S : {1.0, 1.1, 1.37}) CHECK(design.planned().design.friction.at(S).mu == friction.at(S).mu);

  design.set(DesignParameter::reference, 1.5e-3);
  std::string text = drifting;
  const DesignCase read = design_of(text.replace(text.find("1.4 mm"), 6, "1.5 mm"));
  for (const double S : {1.0, 1.1, 1.37})
    CHECK(design.planned().design.friction.at(S).mu == read.planned().design.friction.at(S).mu);

  // Not stated it is the span, whatever that is.
  const auto at_span = [](const std::string& more) {
    return design_of(with("phase = 1.0", "drift = \"0.8 1/mm\"\n" + more));
  };
  CHECK_FALSE(at_span("").has(DesignParameter::reference));
  DesignCase wider = at_span("");
  wider.set(DesignParameter::span, 1500e-6);
  DesignCase stated = at_span("reference = \"1.5 mm\"");
  stated.set(DesignParameter::span, 1500e-6);
  CHECK(wider.planned().design.friction.at(1.3).mu == stated.planned().design.friction.at(1.3).mu);
}

TEST_CASE(
    "design case, limit: a span beyond the reference, and friction beyond its limit with its drift, are refused by "
    "name") {
  DesignCase design = design_of(with("phase = 1.0", "drift = \"0.8 1/mm\"\nreference = \"1.4 mm\""));
  design.set(DesignParameter::span, 2e-3);
  CHECK(
      message_of([&] { design.planned(); }) ==
      "reference: expected a length between the supports, from the span of 2 mm to 100 spans, found 1.4 mm; check its "
      "unit");
  DesignCase steep = design_of(with("phase = 1.0", "drift = \"1 1/mm\""));
  CHECK(message_of([&] { steep.planned(); }) == "");
  steep.set(DesignParameter::mu0, 1.5);
  CHECK(message_of([&] { steep.planned(); }).find("drift: expected friction of at most 2 at the surface") == 0);
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

}  // namespace flexslip
