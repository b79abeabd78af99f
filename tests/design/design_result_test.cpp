#include "design/design_result.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/rig.h"
#include "case/mechanics.h"
#include "numerics/effort.h"
#include "tests/approximately.h"
#include "tests/design/some_design.h"
#include "tests/generators.h"
#include "tests/has.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

std::string refusal_of(const std::string& text) {
  return message_of([&] { loading_of(text); });
}

}  // namespace

TEST_CASE("one loading, identity: unchanged, it is the test that the case describes") {
  const Test input = read_case(spicule, "case.toml");
  const Design design = design_of(one_loading_of(input)).design;
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  CHECK(design.rig.stiffness == rig_of(input, scales).stiffness);
  CHECK(design.travel == scales.reduced_length(700e-6));
  CHECK(design.step == scales.reduced_length(2e-6));
  const Friction friction = friction_of(input, Fibre(), scales, 2);
  for (const double S : {1.0, 1.1, 1.37}) CHECK(design.friction.at(S).mu == friction.at(S).mu);
}

TEST_CASE("one loading, identity: a parameter that is set equals one that is read") {
  Test varied = loading_of(spicule);
  set(varied, "span", 1500e-6);
  set(varied, "diameter", 40e-6);
  set(varied, "wavelength", 20e-6);
  std::string text = with("1278 um", "1500 um");
  text.replace(text.find("34.8 um"), 7, "40 um");
  text.replace(text.find("\"40 um\"\nphase"), 7, "\"20 um\"");
  const Design a = design_of(varied).design;
  const Design b = design_of(loading_of(text)).design;
  CHECK(a.rig.stiffness == b.rig.stiffness);
  CHECK(a.travel == b.travel);
  for (const double S : {1.0, 1.1, 1.37}) CHECK(a.friction.at(S).mu == b.friction.at(S).mu);
}

TEST_CASE("one loading, identity: a flat specimen set to another section equals one read with it") {
  const auto flat = [](const std::string& section) { return loading_of(with("diameter = \"34.8 um\"", section)); };
  Test varied = flat("width = \"40 um\"\nheight = \"30 um\"");
  set(varied, "width", 50e-6);
  set(varied, "height", 25e-6);
  const auto read = design_of(flat("width = \"50 um\"\nheight = \"25 um\""));
  CHECK(design_of(varied).units.scales.bending_stiffness() == read.units.scales.bending_stiffness());
  set(varied, "height", 300e-6);
  CHECK(has(message_of([&] { design_of(varied); }), "height: The specimen is "));
}

TEST_CASE("one loading, limit: it has the parameters that its kind of case can vary") {
  CHECK(value_of(loading_of(spicule), "diameter").has_value());
  const Test flat = loading_of(with("diameter = \"34.8 um\"", "width = \"40 um\"\nheight = \"30 um\""));
  CHECK_FALSE(value_of(flat, "diameter").has_value());
  CHECK(value_of(flat, "height").value() == 30e-6);
  CHECK(value_of(flat, "width").value() == 40e-6);
  CHECK(value_of(flat, "modulus").has_value());
  const Test reduced = loading_of(
      "reduced = true\n[rig]\nstiffness = 30\n[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\nprogram = [0, "
      "0.6]\n");
  CHECK_FALSE(value_of(reduced, "span").has_value());
  CHECK_FALSE(value_of(reduced, "wavelength").has_value());
  CHECK(value_of(reduced, "step").value() == 0);  // continuous
}

TEST_CASE("one loading, identity: friction drifts from its reference, which can be varied") {
  const std::string drifting = with("phase = 1.0", "phase = 1.0\ndrift = \"0.8 1/mm\"\nreference = \"1.4 mm\"");
  const Test input = read_case(drifting, "case.toml");
  Test design(input);
  const Friction friction = friction_of(input, Fibre(), scales_of(input, bending_stiffness_of(input)), 2);
  for (const double S : {1.0, 1.1, 1.37}) CHECK(design_of(design).design.friction.at(S).mu == friction.at(S).mu);

  set(design, "reference", 1.5e-3);
  std::string text = drifting;
  const Test read = loading_of(text.replace(text.find("1.4 mm"), 6, "1.5 mm"));
  for (const double S : {1.0, 1.1, 1.37})
    CHECK(design_of(design).design.friction.at(S).mu == design_of(read).design.friction.at(S).mu);

  // Not stated it is the span, whatever that is.
  const auto at_span = [](const std::string& more) {
    return loading_of(with("phase = 1.0", "drift = \"0.8 1/mm\"\n" + more));
  };
  CHECK_FALSE(value_of(at_span(""), "reference").has_value());
  Test wider = at_span("");
  set(wider, "span", 1500e-6);
  Test stated = at_span("reference = \"1.5 mm\"");
  set(stated, "span", 1500e-6);
  CHECK(design_of(wider).design.friction.at(1.3).mu == design_of(stated).design.friction.at(1.3).mu);
}

TEST_CASE(
    "one loading, limit: a span beyond the reference, and friction beyond its limit with its drift, are refused by "
    "name") {
  Test design = loading_of(with("phase = 1.0", "drift = \"0.8 1/mm\"\nreference = \"1.4 mm\""));
  set(design, "span", 2e-3);
  CHECK(message_of([&] { design_of(design); }) ==
        "case.toml:13: [friction] reference: The reference length of 1.4 mm is not between the span of 2 mm and 100 "
        "spans. Check its unit.");
  Test steep = loading_of(with("phase = 1.0", "drift = \"1 1/mm\""));
  CHECK(message_of([&] { design_of(steep); }) == "");
  set(steep, "mu0", 1.5);
  CHECK(has(message_of([&] { design_of(steep); }), "drift: The drift of "));
}

TEST_CASE("one loading, contract: a case that is no single loading is refused at its line") {
  CHECK(refusal_of(with("\"700 um\"", "\"700 um\", \"100 um\", \"900 um\"")).find("case.toml:14: [stage] program[3]") ==
        0);
  CHECK(refusal_of(with("\"0 um\"", "\"1 um\"")).find("case.toml:14: [stage] program[1]") == 0);
  CHECK(refusal_of(with("step = \"2 um\"", "snaps = \"overshoot\"")).find("flexslip simulate") != std::string::npos);
  CHECK(refusal_of(with("phase = 1.0", "static_excess = 0.1")).find("[friction] static_excess") != std::string::npos);
  CHECK(refusal_of(with("stiffness = \"90.65 N/m\"", "")).find("[rig] stiffness") != std::string::npos);
}

TEST_CASE("one loading, contract: a parameter out of range is refused with its name") {
  Test input = loading_of(spicule);
  CHECK(message_of([&] { set(input, "amplitude", 1.5); }).find("amplitude: 1.5 is not ") == 0);
  CHECK(message_of([&] { set(input, "stiffness", 0); }).find("stiffness: 0") == 0);
  set(input, "diameter", 300e-6);
  CHECK(has(message_of([&] { design_of(input); }), "diameter: The specimen is "));
}

TEST_CASE("design result, table: impossible tests differ from tests beyond the limits of FlexSlip") {
  const auto status_with = [](std::string_view parameter, double value) {
    Test input = loading_of(spicule);
    set(input, parameter, value);
    return result_of(input).status;
  };
  CHECK(status_with("step", 3e-6) == ResultStatus::ok);
  CHECK(status_with("diameter", 300e-6) == ResultStatus::impossible);
  CHECK(status_with("stiffness", 1e-6) == ResultStatus::impossible);
  CHECK(status_with("wavelength", 1e-12) == ResultStatus::not_computable);
  CHECK(status_with("mu0", 19) == ResultStatus::not_computable);  // the wave goes beyond 20
  CHECK(status_with("step", 1e-30) == ResultStatus::not_computable);
  CHECK(status_with("travel", 1) == ResultStatus::not_computable);
  CHECK(status_with("modulus", 1e308) == ResultStatus::impossible);  // the rig is too soft for it
}

TEST_CASE("design result, contract: any parameters are computed or refused with a status") {
  CHECK(rc::check([] {
    Test input = loading_of(spicule);
    for (const auto& known : design_parameters()) {
      if (!value_of(input, known.name).has_value() || *whole(0, 2) > 0) continue;
      const double value = *whole(0, 4) == 0 ? std::pow(10, *between(-300, 300))
                                             : value_of(input, known.name).value() * std::pow(10, *between(-3, 3));
      if (is_within(known, value)) set(input, known.name, value);
    }
    std::optional<Design> planned;
    try {
      planned = design_of(input).design;
    } catch (const InputError&) {  // finds all that cannot be computed
    }
    // Millions of periods take their time.
    const bool is_quick = !planned || longest_at_stage(planned->travel) - 1 < 1e4 * planned->friction.smooth_scale();
    RC_PRE(is_quick);
    const auto result = result_of(input);
    RC_ASSERT(result.outcome.has_value() == planned.has_value());
    if (planned) RC_ASSERT(!std::isnan(stiffness_margin(*planned, *result.outcome)));
  }));
}

TEST_CASE("design map, identity: its points are the outcomes at its values") {
  const Test input = loading_of(spicule);
  const std::vector<DesignAxis> axes{map_axis(input, "stiffness=20 N/m:400 N/m:4", 10),
                                     map_axis(input, "mu0=0:0.6", 3)};
  CHECK(std::get<AxisRange>(axes[0].values).spacing == Spacing::logarithmic);
  const auto points = design_map(input, axes, 2);
  REQUIRE(points.size() == 12);
  for (const auto& point : points) {
    Test there = input;
    set(there, "stiffness", point.values[0]);
    set(there, "mu0", point.values[1]);
    CHECK(point.result.outcome->snaps == outcome_of(design_of(there).design).snaps);
  }
  for (const std::size_t i : {0, 1, 2}) CHECK(points[i].values[1] == std::vector{0.0, 0.3, 0.6}[i]);
}

TEST_CASE("limit: a design or a map that is stopped gives nothing, on any thread") {
  const Test input = loading_of(spicule);
  const std::atomic<bool> stop = true;
  const std::vector axes{map_axis(input, "mu0=0:0.6", 3)};
  const Stoppable stoppable(&stop);
  CHECK_THROWS_AS(design_map(input, axes, 2), Stopped);
  CHECK_THROWS_AS(outcome_of(design_of(input).design), Stopped);
}

TEST_CASE("design map, contract: a range that makes no sense is refused with a remedy") {
  const Test input = loading_of(spicule);
  CHECK(message_of([&] { map_axis(input, "stiffnes=1 N/m:2 N/m", 5); }).find("Did you mean 'stiffness'?") !=
        std::string::npos);
  CHECK(message_of([&] { map_axis(input, "stiffness=1:2", 5); }).find("unit") != std::string::npos);
  CHECK(grid_inputs({map_axis(input, "phase=0:90 deg", 5)}, 4)[0] == to(1e-15, std::numbers::pi / 2));
  CHECK(grid_inputs({map_axis(input, "phase=0:6.25", 5)}, 4)[0] == 6.25);  // radians
  CHECK(message_of([&] { map_axis(input, "mu0=0:1:1", 5); }).find("points") != std::string::npos);
  CHECK(message_of([&] { map_axis(input, "mu0", 5); }).find("Write it as") != std::string::npos);
}

}  // namespace flexslip
