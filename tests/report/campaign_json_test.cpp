#include "report/campaign_json.h"

#include <doctest/doctest.h>

#include "tests/report/some_campaign.h"

using namespace flexslip;

TEST_CASE("outside: what JSON holds reads back, in the form of the design") {
  const Json json = Json::parse(campaign_json(some_campaign()).dump());
  REQUIRE(json["tests"].size() == 5);
  const auto& test = json["tests"][0];
  CHECK(test["name"] == awkward_name);
  CHECK(test["status"] == "ok");
  CHECK(test["category"] == "clear");
  CHECK(test["suspect"] == false);
  CHECK(test["parameters"]["wavelength"]["value"] == 10.9e-6);
  CHECK(test["parameters"]["wavelength"]["unit"] == "m");
  CHECK(test["parameters"]["mu0"]["interval95"] == Json({0.6 - 0.0241, 0.6 + 0.0241}));
  CHECK(json["tests"][3]["parameters"]["wavelength"].is_null());
  CHECK(json["categories"]["clear"]["mu0"] == Json({{"mean", 0.5}, {"min", 0.4}, {"max", 0.6}, {"n", 2}}));
  CHECK(json["categories"]["clear"]["with_suspects"]["mu0"]["max"] == 1.25);
  CHECK(json["categories"]["none"]["wavelength"]["mean"].is_null());
  CHECK(json["categories"]["all"]["with_suspects"]["tests"] == 5);
  REQUIRE(json["failures"].size() == 1);
  CHECK(json["failures"][0]["name"] == "SS99");
  CHECK(json["failures"][0]["reason"] == "99.csv: expected numbers, found <nothing> & \"nothing\"");
  CHECK(json["shared"][0]["name"] == "modulus");
  CHECK(json["shared"][0]["tests"] == 5);
  CHECK(json["units"]["length"] == "m");
}

TEST_CASE("limit: no tests, and none with an answer") {
  CHECK(campaign_json(no_tests())["tests"].empty());
  CHECK(campaign_json(no_tests())["categories"]["all"]["mu0"]["n"] == 0);
  CHECK(campaign_json(only_failures())["tests"].empty());
  CHECK(campaign_json(only_failures())["failures"].size() == 2);
}
