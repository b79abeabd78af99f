#include "cases/problem.h"

#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "tests/cases/some_design.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

// The spicule with other friction.
std::string with_friction(const std::string& keys) {
  const std::size_t from = spicule.find("[friction]");
  return spicule.substr(0, from) + "[friction]\n" + keys + spicule.substr(spicule.find("[stage]"));
}

History simulated(const std::string& text) {
  const Case input = read_case(text, "case.toml");
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  const StageProgramme programme = programme_of(input);
  std::vector<double> stages;
  for (const double position : programme.positions) stages.push_back(scales.reduced_length(position));
  return follow_in_steps(bending_test_of(input, scales, scales.reduced_length(programme.farthest)), stages);
}

std::string refusal_of(const std::string& text) {
  return message_of([&] { simulated(text); });
}

bool begins(const std::string& text, std::string_view part) { return text.find(part) == 0; }

}  // namespace

TEST_CASE("table: friction beyond what is computed is refused with key, value, limit and remedy") {
  const auto drifting = [](const std::string& keys) { return with_friction("model = \"constant\"\n" + keys); };
  CHECK(refusal_of(drifting("mu0 = 21\n")) ==
        "case.toml:9: [friction] mu0: expected friction of at most 20, its waves and drift included, found 21; write a "
        "smaller one");
  // 700 um are 0.548 spans: the specimen is at most 1 + 2.4 0.548^2 = 1.72 spans long.
  CHECK(refusal_of(drifting("mu0 = 19\ndrift = \"40 1/mm\"\n")) ==
        "case.toml:10: [friction] drift: expected friction of at most 20, its waves and drift included, found 40 1/mm, "
        "which brings it from 19 at 1.278 mm to 55.8075 at 2.198 mm; check its unit, or go less far");
  CHECK(refusal_of(drifting("mu0 = 19\ndrift = \"-40 1/mm\"\n")) == "");
  CHECK(
      refusal_of(drifting("mu0 = 0.3\nstatic_excess = 19.8\n")) ==
      "case.toml:10: [friction] static_excess: expected static friction of at most 20, found 19.8, which brings it to "
      "20.1; write a smaller one");
  CHECK(begins(refusal_of(drifting("mu0 = 0.3\ndrift = \"1 1/mm\"\nstatic_excess = 19\n")),
               "case.toml:11: [friction] static_excess: expected static friction of at most 20"));
  CHECK(begins(
      refusal_of(with_friction("model = \"rough\"\nmu0 = 19\nrms = 1\ncorrelation_length = \"5 um\"\nseed = 1\n")),
      "case.toml:9: [friction] mu0: expected friction of at most 20, its roughness included"));
}

}  // namespace flexslip
