#include "answers/design_fields.h"

#include <limits>
#include <string>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "tests/design/some_design.h"

namespace flexslip {
namespace {

Json json_of_design(const DesignAnswer& answer) {
  return design_fields()({answer, "", std::vector<std::string>(answer.changes.size())}, {});
}

}  // namespace

TEST_CASE("design JSON, identity: every outcome and every parameter of the case, under its name") {
  const Test input = loading_of(spicule);
  const auto answer = answer_of(input);
  const Json json = json_of_design(answer);
  CHECK(json.at("largest_drop") == answer.scales.physical_force(answer.outcome.largest_drop));
  CHECK(json.at("snaps") == answer.outcome.snaps);
  CHECK(json.at("work") == answer.scales.physical_energy(answer.outcome.work));
  for (const auto& outcome : outcome_fields()) CHECK(json.contains(std::string(outcome.what.name)));
  for (const DesignParameter& known : design_parameters())
    CHECK(json.at("parameters").contains(std::string(known.name)) == value_of(input, known.name).has_value());
  CHECK(json.at("changes").size() == answer.changes.size());
  CHECK(json.at("phases").at("count") == 24);
}

TEST_CASE(
    "design JSON, identity: the plans of a second loading in the units of the case, null where none are asked for") {
  Test input = loading_of(with("40 um", "10.9 um"));
  set(input, "travel", 560e-6);
  auto answer = answer_of(input);
  CHECK(json_of_design(answer).at("reload").is_null());
  answer.reload = reload_study(input, {});
  const Json json = Json::parse(json_of_design(answer).dump()).at("reload");
  CHECK(json.at("plans").size() == answer.reload->plans.size());
  CHECK(json.at("planned").at("force") == answer.reload->of_travel().force);
  CHECK(json.at("least").at("chance_if_cracks") == answer.reload->least().value().chances.cracks);
  CHECK(json.at("plans").at(0).at("loss_needed").is_null());  // no drops so early
  CHECK(json.at("changes").empty());
}

TEST_CASE("design JSON, limit: infinite and undefined values are null") {
  Test input = loading_of(with("[rig]", "[rig]  # stiff"));
  set(input, "mu0", 0);
  set(input, "amplitude", 0);
  set(input, "stiffness", std::numeric_limits<double>::infinity());
  const Json json = Json::parse(json_of_design(answer_of(input)).dump());
  CHECK(json.at("first_snap_stage").is_null());
  CHECK(json.at("parameters").at("stiffness").is_null());
  CHECK(json.at("phases").is_null());
  CHECK(json.at("critical_stiffness") == 0);
}

TEST_CASE("design map JSON, limit: an impossible test has only its status and its parameters") {
  const Test input = loading_of(spicule);
  const std::vector<DesignAxis> axes{map_axis(input, "diameter=100 um:300 um:2", 2)};
  const auto points = design_map(input, axes, 1);
  const Json json = design_map_fields(axes)(points, {});
  const Json& designs = json.at("designs");
  CHECK(designs.at(0).at("status") == "ok");
  CHECK(designs.at(0).contains("stiffness_margin"));
  CHECK(designs.at(1) == Json{{"diameter", 300e-6}, {"status", "impossible"}});
}

}  // namespace flexslip
