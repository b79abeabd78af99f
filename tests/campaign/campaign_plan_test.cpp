#include "campaign/campaign_plan.h"

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

constexpr std::string_view a_case = R"([rig]
span = "1 mm"
stiffness = "90 N/m"
[record]
file = "a.csv"
stage = "w [mm]"
force = "F [N]"
)";

const Test& case_in(const PlannedTest& test) { return std::get<Test>(test.input); }
std::string error_in(const PlannedTest& test) { return std::get<InputError>(test.input).what(); }

TEST_CASE("table: a folder gives its case files by path, unreadable ones with the reason, with unique names") {
  const TemporaryFolder folder;
  folder.file("b.toml", a_case);
  folder.file("a/case.toml", a_case);
  folder.file("z/b.toml", a_case);
  folder.file("broken.toml", "[rig]\nspan = 12\n");
  folder.file("simulate.toml", "[rig]\nspan = \"1 mm\"\n");  // no [record]: no measured test
  folder.file(".hidden/c.toml", a_case);
  folder.file("a.csv", "w [mm],F [N]\n");
  const auto plan = plan_campaign(folder.path().string(), std::nullopt).tests;
  REQUIRE(plan.size() == 4);
  CHECK(plan[0].name == "a");
  CHECK(case_in(plan[0]).record.value().file == (folder.path() / "a" / "a.csv").string());
  CHECK(plan[1].name == "b");
  CHECK(plan[2].name == "broken");
  CHECK(error_in(plan[2]).find("broken.toml:2: [rig] span: ") != std::string::npos);
  CHECK(plan[3].name == "b-2");
}

TEST_CASE("table: with a common case, a folder gives its data files") {
  const TemporaryFolder folder;
  const auto common = folder.file("common.toml", R"([rig]
span = "1 mm"
stiffness = "90 N/m"
[record]
stage = "w [mm]"
force = "F [N]"
)");
  folder.file("two.CSV", "w [mm],F [N]\n");
  folder.file("one.dat", "");
  folder.file("below/three.csv", "");
  folder.file("notes.md", "");
  const auto plan = plan_campaign(folder.path().string(), common).tests;
  REQUIRE(plan.size() == 2);
  CHECK(plan[0].name == "one");
  CHECK(case_in(plan[0]).record.value().file == (folder.path() / "one.dat").string());
  CHECK(case_in(plan[0]).rig.value().span == 1e-3);
  CHECK(plan[1].name == "two");
}

TEST_CASE("table: results and copies with extra columns are no tests; a repeated record is one test") {
  const TemporaryFolder folder;
  const auto common =
      folder.file("common.toml",
                  "[rig]\nspan = \"1 mm\"\nstiffness = \"90 N/m\"\n[record]\nstage = \"w [mm]\"\nforce = \"F [N]\"\n");
  const std::string record = "w [mm],F [N]\n0,0\n1,2\n2,4\n";
  folder.file("a.csv", record);
  folder.file("a_dS.csv", "w [mm],F [N],dS [mm]\n0,0,0\n1,2,0.1\n2,4,0.2\n");
  folder.file("a_again.csv", "w [mm],F [N]\n0,0\n1,3\n2,5\n");  // another loading of the same specimen
  folder.file("b.csv", record);
  folder.file("profile.csv", "row,w_s [m],w [m],F [N],S [m],drawn_in [m]\n1,0,0,0,0,0\n");
  const CampaignPlan plan = plan_campaign(folder.path().string(), common);
  REQUIRE(plan.tests.size() == 2);
  CHECK(plan.tests[0].name == "a");
  CHECK(plan.tests[1].name == "a_again");
  REQUIRE(plan.notes.size() == 4);
  CHECK(plan.notes[0] == "omitted, because they are results of flexslip: 'profile.csv'");
  CHECK(has(plan.notes[1], "'a_dS.csv'"));
  CHECK(plan.notes[2] == "'b' is omitted: its record is identical to the record of 'a'");
  CHECK(has(plan.notes[3], "no section is stated for any specimen"));
}

TEST_CASE("table: the same record under another case is another test, and a note says so") {
  const TemporaryFolder folder;
  folder.file("a.csv", "w [mm],F [N]\n0,0\n1,2\n2,4\n");
  const auto table = folder.file("tests.csv",
                                 "name,file,span,stiffness [N/m],stage,force\none,a.csv,1 mm,90,w [mm],F [N]\n"
                                 "two,a.csv,1 mm,90,w [mm],F [N]\nthree,a.csv,1 mm,80,w [mm],F [N]\n"
                                 "four,a.csv,1 mm,80,w [mm],F [N]\n");
  const CampaignPlan plan = plan_campaign(table, std::nullopt);
  REQUIRE(plan.tests.size() == 2);
  REQUIRE(plan.notes.size() == 4);
  CHECK(plan.tests[1].name == "three");
  CHECK(has(plan.notes[0], "'two' is omitted: its record is identical"));
  CHECK(has(plan.notes[1], "'three' has the same record as 'one'"));
  CHECK(has(plan.notes[1], "counts as another specimen"));
  CHECK(has(plan.notes[2], "'four' is omitted: its record is identical to the record of 'three'"));
}

TEST_CASE("table: units in titles of a table as in those of a record") {
  const TemporaryFolder folder;
  folder.file("a.csv", "w [mm],F [N]\n0,0\n");
  const auto table =
      folder.file("cases.csv",
                  "file,span_mm,diameter (um),modulus_uncertainty_GPa,modulus [GPa],stiffness [N/m],stage,force\n"
                  "a.csv,1.278,34.8,1.5,29.6,90,w [mm],F [N]\n");
  const auto plan = plan_campaign(table, std::nullopt).tests;
  REQUIRE(plan.size() == 1);
  const Test& test = case_in(plan[0]);
  CHECK(test.rig.value().span == 1.278e-3);
  CHECK(test.specimen.value().diameter == 34.8e-6);
  CHECK(std::get<Known>(test.specimen->modulus.value()).uncertainty == 1.5e9);
}

TEST_CASE("table: a row is a test with short or full keys, units in titles or cells, and overrides the common case") {
  const TemporaryFolder folder;
  const auto common =
      folder.file("common.toml",
                  "[rig]\nspan = \"1 mm\"\nstiffness = \"90 N/m\"\n[record]\nstage = \"w [mm]\"\nforce = \"F [N]\"\n");
  const auto table = folder.file(
      "cases.csv",
      "file,diameter [um],modulus,modulus uncertainty [GPa],rig.span,span uncertainty [um],until,#operator\n"
      "a.csv,34.8,29.6 GPa,1.5,1278 um,2.5,267,Jo\n"
      "sub/b.csv,40,fit,,,,,\n");
  const auto plan = plan_campaign(table, common).tests;
  REQUIRE(plan.size() == 2);
  CHECK(plan[0].name == "a");
  CHECK(plan[0].file == table + ":2");
  const Test& first = case_in(plan[0]);
  CHECK(first.specimen.value().diameter == 34.8e-6);
  const auto& modulus = std::get<Known>(first.specimen->modulus.value());
  CHECK(modulus.value == 29.6e9);
  CHECK(modulus.uncertainty == 1.5e9);
  CHECK(first.rig.value().span == Known{1278e-6, 2.5e-6});
  CHECK(first.record.value().until == PlaceInRecord(AtRow{267}));
  CHECK(first.record->file == (folder.path() / "a.csv").string());
  const Test& second = case_in(plan[1]);
  CHECK(second.rig.value().span == 1e-3);
  CHECK(!second.record.value().until);
  CHECK(second.specimen.value().modulus == StatedStiffness{ToFit{}});
}

TEST_CASE("table: friction with a drift and its reference in columns") {
  const TemporaryFolder folder;
  const auto table = folder.file("cases.csv",
                                 "file,span,stage,force,friction.model,friction.mu0,friction.drift [1/mm],"
                                 "friction.reference [mm]\n"
                                 "a.csv,1 mm,w [mm],F [N],drift,0.3,0.8,1.4\n");
  const auto plan = plan_campaign(table, std::nullopt).tests;
  REQUIRE(plan.size() == 1);
  CHECK(case_in(plan[0]).friction ==
        FrictionInput{.model = FrictionModel::drift, .mu0 = 0.3, .drift = 800, .reference = 1.4e-3});
}

TEST_CASE("table: a bad cell fails its test, named by line and column; a column that is no key fails the table") {
  const TemporaryFolder folder;
  const std::string head = "file,span,stiffness,stage,force";
  const auto bad_cell =
      folder.file("cells.csv", head + "\na.csv,12,90 N/m,w [mm],F [N]\nb.csv,1 mm,90 N/m,w [mm],F [N]\n");
  const auto plan = plan_campaign(bad_cell, std::nullopt).tests;
  REQUIRE(plan.size() == 2);
  CHECK(error_in(plan[0]).find("cells.csv:2: column 'span': The number '12' has no unit") != std::string::npos);
  CHECK(std::holds_alternative<Test>(plan[1].input));

  const auto bad_column = folder.file("columns.csv", head + ",diametr\na.csv,1 mm,90 N/m,w [mm],F [N],1 um\n");
  const auto message = message_of([&] { plan_campaign(bad_column, std::nullopt); });
  CHECK(message.find("columns.csv:1: column 'diametr'") != std::string::npos);
  const auto empty = folder.file("empty.csv", head + "\n");
  CHECK(message_of([&] {
          plan_campaign(empty, std::nullopt);
        }).find("The table has a header only, and no row for a test") != std::string::npos);
}

TEST_CASE("table: names are unchanged; their folders are valid, and differ also if upper and lower case are equal") {
  const TemporaryFolder folder;
  const std::string longest(150, 'n');
  const auto table =
      folder.file("cases.csv",
                  "name,file,span,stiffness,stage,force\n"
                  "../a/b,x.csv,1 mm,9 N/m,w [mm],F [N]\n"
                  "Test,x.csv,1 mm,9 N/m,w [mm],F [N]\n"
                  "test,x.csv,1 mm,9 N/m,w [mm],F [N]\n"
                  "_.._A_b,x.csv,1 mm,9 N/m,w [mm],F [N]\n" +
                      longest + ",x.csv,1 mm,9 N/m,w [mm],F [N]\n" + longest + ",x.csv,1 mm,9 N/m,w [mm],F [N]\n");
  const auto plan = plan_campaign(table, std::nullopt).tests;
  REQUIRE(plan.size() == 6);
  CHECK(plan[0].name == "../a/b");
  CHECK(folder_name(plan[0].name) == "_.._a_b");
  CHECK(plan[1].name == "Test");
  CHECK(plan[2].name == "test-2");
  CHECK(plan[3].name == "_.._A_b-2");
  CHECK(plan[4].name == longest);
  CHECK(plan[5].name == longest + "-2");
  CHECK(folder_name(plan[5].name) != folder_name(plan[4].name));
  CHECK(folder_name(plan[5].name).size() <= 110);
}

TEST_CASE("table: a reduced case fails, as the tables and figures of a campaign are physical") {
  const TemporaryFolder folder;
  folder.file("a.toml",
              "reduced = true\n[rig]\nstiffness = 90\n[record]\nfile = \"a.csv\"\nstage = \"w\"\nforce = \"F\"\n");
  const auto plan = plan_campaign(folder.path().string(), std::nullopt).tests;
  CHECK(error_in(plan.at(0)).find("a.toml:1: reduced: The test is reduced") != std::string::npos);
}

TEST_CASE("table: a folder without tests says what to do") {
  const TemporaryFolder folder;
  CHECK(message_of([&] { plan_campaign(folder.path().string(), std::nullopt); }).find("--common") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
