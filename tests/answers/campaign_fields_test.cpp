#include "answers/campaign_fields.h"

#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "io/table.h"
#include "io/text_file.h"
#include "tests/report/some_campaign.h"
#include "tests/temporary_folder.h"

using namespace flexslip;
namespace fs = std::filesystem;

TEST_CASE("outside: the table of tests restores the same bits with any names") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "tests.csv";
  const auto answered = campaign_of({some_test(awkward_name, SawtoothCategory::clear, 0.6, 10.9e-6),
                                     some_test("a,b\n\"c\"", SawtoothCategory::clear, 1.0 / 3, 5.5e-6)});
  write_csv(path, test_table(answered));
  const Table read = read_table(path, {{"mu0", kind::number},
                                       {"wavelength [m]", kind::length},
                                       {"bending_stiffness_standard_error [N m^2]", kind::bending_stiffness},
                                       {"work_of_fracture [J]", kind::energy},
                                       {"drops", kind::number}});
  REQUIRE(read.rows() == 2);
  CHECK(read.columns[0].values[1] == 1.0 / 3);
  CHECK(read.columns[1].values[0] == 10.9e-6);
  CHECK(read.columns[2].values[0] == 6.4e-11);
  CHECK(read.columns[3].values[0] == 3.4e-6);
  CHECK(read.columns[4].values[0] == 7);
  CHECK(bytes_of(path).find("\"A <b> & 50%_ü \"\"x\"\"\",ok,SLIP,0.02,0.9,clear,no,roughness,0.6,") !=
        std::string::npos);
}

TEST_CASE("outside: no name is a formula, and each name is restored when the table is read") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "tests.csv";
  const std::vector<std::string> names{"=cmd|' /C calc'!A1", "+1", "-1", "@x", "'=quoted", "12'' rod"};
  Campaign campaign;
  for (const auto& name : names) campaign.tests.push_back(some_test(name, SawtoothCategory::clear, 0.5, 10.9e-6));
  ResultTable table = test_table(campaign);
  table.rows[0][7] = -0.5;
  write_csv(path, table);
  const TextTable read = read_text_table(path);
  REQUIRE(read.rows.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(read.rows[i].cells[0] == names[i]);
  const std::string text = bytes_of(path);
  CHECK(text.find("\n'=cmd") != std::string::npos);
  for (const char* begins : {"\n=", "\n+", "\n-", "\n@", "\n\"="}) CHECK(text.find(begins) == std::string::npos);
  CHECK(text.find(",-0.5,") != std::string::npos);  // numbers stay numbers
}

TEST_CASE("outside: categories with suspects and without, by hand") {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "categories.csv";
  write_csv(path, category_table(some_campaign()));
  const std::string text = bytes_of(path);
  CHECK(text.starts_with("category,suspects,tests,mu0_mean,mu0_min,mu0_max,mu0_n,mu0_limit_mean,mu0_limit_min,"));
  CHECK(text.find("\nclear,without,2,0.5,0.4,0.6,2,") != std::string::npos);
  CHECK(text.find("\nclear,with,3,0.75,0.4,1.25,3,") != std::string::npos);
  CHECK(text.find("\nnone,without,1,0.3,0.3,0.3,1,nan,nan,nan,0,nan,nan,nan,0,nan,nan,nan,0,0\n") != std::string::npos);
  CHECK(text.find("\nall,with,5,") != std::string::npos);
}

TEST_CASE("limit: no tests, and none with an answer") {
  CHECK(test_table(no_tests()).rows.empty());
  CHECK(category_table(no_tests()).rows.size() == 8);
  const auto failures = failure_table(only_failures());
  REQUIRE(failures.rows.size() == 2);
  CHECK(std::get<std::string>(failures.rows[1][0]) == awkward_name);
  CHECK(std::get<std::string>(failures.rows[1][3]) == "b & c.csv: <no> numbers_ in 100 %");
  const auto tests = test_table(only_failures());
  CHECK(tests.rows.size() == 2);
  CHECK(std::get<std::string>(tests.rows[0][5]).empty());
}

TEST_CASE("identity: a quantity has one unit, chosen for the median test") {
  const auto table = in_best_units(test_table(some_campaign()));
  std::size_t found = 0;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].quantity == "wavelength") {
      CHECK(table.columns[i].unit == "um");
      if (++found == 1)
        CHECK(std::get<double>(table.rows[0][i]) == doctest::Approx(10.9).epsilon(1e-15));  // one rounding
    }
  CHECK(found == 4);
}

TEST_CASE("outside: JSON restores its content, in the documented form") {
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
  CHECK(json["failures"][0]["reason"] == "99.csv: <nothing> & \"nothing\" is not a number.");
  const auto& between = json["categories"]["all"]["between_specimens"]["mu0"];
  CHECK(between["tests"] == 4);
  const double typical = between["typical"]["value"];
  CHECK(typical == doctest::Approx((0.6 + 0.4 + 0.75 + 0.3) / 4));  // errors far below the differences
  CHECK(between["spread"] == doctest::Approx(std::sqrt(0.121875 / 3)).epsilon(0.01));
  CHECK(between["spread_low"] < between["spread"]);
  CHECK(json["units"]["length"] == "m");
}

TEST_CASE("limit: JSON of no tests, and of none with an answer") {
  CHECK(campaign_json(no_tests())["tests"].empty());
  CHECK(campaign_json(no_tests())["categories"]["all"]["mu0"]["n"] == 0);
  CHECK(campaign_json(only_failures())["tests"].empty());
  CHECK(campaign_json(only_failures())["failures"].size() == 2);
}
