#include "design/design_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include <doctest/doctest.h>

#include "numerics/effort.h"
#include "tests/approximately.h"
#include "tests/design/some_design.h"

namespace flexslip {

TEST_CASE("design answer, limit: from displacement control a softer load train down to the critical one is offered") {
  Test input = loading_of(spicule);
  const auto soft = answer_of(input);
  set(input, "stiffness", std::numeric_limits<double>::infinity());
  const auto stiff = answer_of(input);
  CHECK(stiff.critical == soft.critical);  // the stiffness of the design itself does not count
  REQUIRE(stiff.outcome.snaps == 0);
  REQUIRE(stiff.changes.front().parameter == "stiffness");
  CHECK(stiff.changes.front().to == to(2e-4, stiff.scales.physical_stiffness(stiff.critical)));  // a hair softer
  CHECK(soft.changes.front().to == soft.scales.physical_stiffness(soft.critical));
  for (const double stiffness : {1e3, 1e5, 1e7}) {
    set(input, "stiffness", stiffness);
    CHECK(answer_of(input).changes.front().to == stiff.changes.front().to);
  }
}

TEST_CASE("design answer, limit: a parameter of 0 can be raised until the specimen snaps, but not just before") {
  for (const std::string_view parameter : {"mu0", "amplitude"}) {
    CAPTURE(parameter);
    Test input = loading_of(spicule);
    set(input, parameter, 0);
    const auto answer = answer_of(input);
    REQUIRE(answer.outcome.snaps == 0);
    const auto change = std::find_if(answer.changes.begin(), answer.changes.end(),
                                     [&](const DesignChange& found) { return found.parameter == parameter; });
    REQUIRE(change != answer.changes.end());
    set(input, parameter, change->to * (1 - 2e-4));  // twice what the search leaves
    CHECK(result_of(input).outcome->snaps == 0);
    set(input, parameter, change->to);
    CHECK(result_of(input).outcome->snaps > 0);
  }
}

TEST_CASE("design answer, identity: each change reverses the answer, but not just before") {
  const Test input = loading_of(spicule);
  const auto answer = answer_of(input);
  REQUIRE(answer.outcome.snaps > 0);
  REQUIRE(answer.changes.size() >= 8);
  for (const auto& change : answer.changes) {
    CAPTURE(change.parameter);
    CHECK(change.outcome.snaps == 0);
    Test before = input;
    set(before, change.parameter,
        change.to * (change.from > change.to ? 1 + 2e-4 : 1 - 2e-4));  // twice what the search leaves
    CHECK(outcome_of(design_of(before).design).snaps > 0);
  }
}

TEST_CASE("design answer, identity: the printed value of a change has few digits and also reverses the answer") {
  for (const double stiffness : {3.0, 15.0, 90.0, 500.0, 5e4}) {
    CAPTURE(stiffness);
    Test input = loading_of(with("40 um", "10.9 um"));
    set(input, "stiffness", stiffness);
    const auto answer = answer_of(input);
    const bool now = answer.outcome.snaps > 0;
    for (const auto& change : answer.changes) {
      CAPTURE(change.parameter);
      const auto snaps_at = [&](double value) {
        Test there = input;
        set(there, change.parameter, value);
        return result_of(there).outcome.value().snaps > 0;
      };
      CHECK(snaps_at(change.to) != now);
      CHECK(snaps_at(change.printed) != now);
      CHECK(change.printed == to(0.01, change.to));  // three digits
      if (change.and_beyond)
        for (const double farther : {1.3, 2.0, 4.0})
          CHECK(snaps_at(change.to > change.from ? change.to * farther : change.to / farther) != now);
    }
  }
}

TEST_CASE(
    "design answer, limit: below the critical stiffness, where it does not snap, it can be made to on either side") {
  Test input = loading_of(with("40 um", "10.9 um"));
  set(input, "stiffness", 0.5);
  const auto answer = answer_of(input);
  REQUIRE(answer.outcome.snaps == 0);
  REQUIRE(answer.critical > answer.design.rig.stiffness);
  CHECK(answer.changes.front().parameter == "stiffness");
  CHECK(answer.changes.front().to > 0.5);
}

TEST_CASE("design answer, limit: at the axis, stiffness, section and modulus change the same number") {
  const auto at_the_axis = [](std::string text) {
    return loading_of(text.replace(text.find("[rig]"), 5, "[rig]\nfriction_at = \"axis\""));
  };
  const auto answer = answer_of(at_the_axis(spicule));
  double stiffness = 0, diameter = 0, modulus = 0;
  for (const auto& change : answer.changes) {
    if (change.parameter == "stiffness") stiffness = change.to / change.from;
    if (change.parameter == "diameter") diameter = change.to / change.from;
    if (change.parameter == "modulus") modulus = change.to / change.from;
  }
  CHECK(modulus == to(1e-12, 1 / stiffness));  // k L^3/EI, I as the fourth power of the diameter
  CHECK(std::pow(diameter, 4) == to(1e-12, 1 / stiffness));

  double height = 0, width = 0;
  const auto flat = answer_of(at_the_axis(with("diameter = \"34.8 um\"", "width = \"40 um\"\nheight = \"30 um\"")));
  for (const auto& change : flat.changes) {
    if (change.parameter == "stiffness") stiffness = change.to / change.from;
    if (change.parameter == "height") height = change.to / change.from;
    if (change.parameter == "width") width = change.to / change.from;
  }
  CHECK(width == to(1e-12, 1 / stiffness));  // I = b h^3/12
  CHECK(std::pow(height, 3) == to(1e-12, 1 / stiffness));
}

TEST_CASE("design answer, identity: the study of phases is the same from the next phase") {
  Test input = loading_of(spicule);
  const auto usual = answer_of(input);
  const double own = usual.scales.physical_stiffness(usual.critical);
  const double worst = usual.scales.physical_stiffness(usual.phases.value().critical);
  REQUIRE(own < worst);
  for (const double stiffness : {0.5 * own, 0.5 * (own + worst), 1.001 * worst}) {  // all of them snap, some, none
    CAPTURE(stiffness);
    set(input, "stiffness", stiffness);
    const auto here = answer_of(input).phases.value();
    Test turned = input;
    set(turned, "phase", value_of(input, "phase").value() + 2 * std::numbers::pi / 24);
    const auto next = answer_of(turned).phases.value();
    CHECK(here.phases == 24);
    CHECK(here.snapping == next.snapping);
    CHECK((here.snapping == 24) == (stiffness < own));
    CHECK((here.snapping == 0) == (stiffness > worst));
    CHECK(here.min_drop == to(1e-6, next.min_drop));
    CHECK(here.largest_drop == to(1e-6, next.largest_drop));
    CHECK(here.critical == to(1e-6, next.critical));
  }
  set(input, "amplitude", 0);
  CHECK_FALSE(answer_of(input).phases);  // no waves, no phase
}

TEST_CASE(
    "design answer, effort: on pins that cut fine waves off, what would make it snap is found in some ten million "
    "states") {
  const Test input = loading_of(
      "[specimen]\ndiameter = \"4 mm\"\nmodulus = \"3 GPa\"\n[rig]\nspan = \"64 mm\"\nstiffness = \"5 N/mm\"\n"
      "rollers = \"pinned\"\nroller_radius = \"1 mm\"\npin_radius = \"0.2 mm\"\npin_friction = 2\n"
      "[friction]\nmodel = \"sinusoid\"\nmu0 = 0.4\namplitude = 0.15\nwavelength = \"0.08 mm\"\nphase = 0\n"
      "[stage]\nprogram = [\"0 mm\", \"20 mm\"]\nstep = \"0.02 mm\"\n");
  effort_spent.clear();
  const auto answer = answer_of(input);
  CHECK(answer.outcome.snaps == 0);
  REQUIRE(answer.changes.back().parameter == "travel");
  CHECK(answer.changes.back().outcome.first_snap);
  CHECK(effort_spent.spent() < 100'000'000);
}

}  // namespace flexslip
