#include "report/campaign_words.h"

#include <string>

#include <doctest/doctest.h>

#include "report/campaign_surface_words.h"
#include "tests/report/some_campaign.h"

using namespace flexslip;

TEST_CASE("table: the answer of a campaign counted by hand") {
  CHECK(answer_of(some_campaign()) ==
        "6 tests: 4 slip, 0 undecided, 0 crack, 1 without drops, 1 without an answer. Friction at the supports is "
        "0.51 on average of 4 tests, from 0.30 to 0.75, without the suspect test. The mean lies within the range 0.5 "
        "to 0.721 "
        "that the literature gives for glass on steel, and 1 of the 4 tests agrees with it. 25 % of the work was "
        "friction "
        "(25 % to 25 %). SS8 is suspect; the doubts say why. "
        "SS99 could not be evaluated.");
  auto of_maize = some_campaign();
  of_maize.tests.front().materials = Materials{"maize", "steel"};
  CHECK(answer_of(of_maize).find("literature") == std::string::npos);
  CHECK(answer_of(campaign_of({some_test("SS1", SawtoothCategory::none, 0.3, {})})) ==
        "1 test: 0 slip, 0 undecided, 0 crack, 1 without drops. Friction at the supports is 0.30. It lies below the "
        "range 0.5 to 0.721 that the literature gives for glass on steel. 25 % of the work was friction. No test is "
        "suspect.");
}

TEST_CASE("table: what surface would explain the waves of a campaign, and what would settle it") {
  const std::string words = surfaces_in_words(some_campaign());
  CHECK(words.find("waves 110 nm high (half of crest to trough; 110 nm to 110 nm) would do") != std::string::npos);
  CHECK(words.find("images with pixels of 22 nm show those of the mean height") != std::string::npos);  // 2 h/10
  CHECK(surfaces_in_words(no_tests()).empty());
  CHECK(surfaces_in_words(campaign_of({some_test("SS1", SawtoothCategory::none, 0.3, {})})).empty());
  CampaignTest indicative = some_test("SS2", SawtoothCategory::clear, 0.5, 11e-6);
  indicative.summary->wave_claimed = false;  // no reason to image anything
  CHECK(surfaces_in_words(campaign_of({indicative})).empty());
}

TEST_CASE("limit: no tests, none with an answer, all suspect") {
  CHECK(answer_of(no_tests()) == "No tests.");
  CHECK(answer_of(only_failures()) == "No answer: none of the 2 tests could be evaluated.");
  const std::string suspect = answer_of(campaign_of({some_test("SS8", SawtoothCategory::clear, 1.25, 20e-6)}));
  CHECK(suspect.find("Friction at the supports is 1.25. It lies above") != std::string::npos);
  CHECK(test_rows(no_tests(), with_error).rows.empty());
  CHECK(failure_rows(only_failures()).rows.size() == 2);
}

TEST_CASE("table: rows for people, each with as many cells as the head") {
  const Campaign campaign = some_campaign();
  for (const auto& table :
       {test_rows(campaign, with_error), category_rows(campaign), failure_rows(campaign), shared_rows(campaign)})
    for (const auto& row : table.rows) CHECK(row.size() == table.head.size());
  const auto tests = test_rows(campaign, with_interval);
  CHECK(tests.head[9] == "λ (µm)");
  CHECK(tests.rows[0][4] == "0.600 (0.576 to 0.624)");
  CHECK(tests.rows[0][9] == "10.90 (10.50 to 11.30)");
  CHECK(tests.rows[0][10] == "0.110 (0.050 to 0.170)");
  CHECK(tests.rows[0][11] == "0.050 (0.030 to 0.070)");
  CHECK(tests.rows[3][9].empty());
  CHECK(category_rows(campaign).rows[1][3] == "0.750 (0.400 to 1.250)");
  CHECK(shared_rows(campaign).rows[0][1] == "29.6 ± 1.2");
  CHECK(shared_rows(campaign).rows[0][3] == "GPa");
}
