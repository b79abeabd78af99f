#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "report/answer_documents.h"
#include "tests/has.h"
#include "tests/report/some_campaign.h"

using namespace flexslip;

namespace {

// The table whose first columns are these; empty where the document has none.
PrintedTable table_with(const std::vector<Chapter>& chapters, const std::string& first, const std::string& second) {
  for (const Chapter& chapter : chapters)
    for (const Block& block : chapter.blocks)
      if (const auto* table = std::get_if<PrintedTable>(&block);
          table && table->head.size() > 1 && table->head[0] == first && table->head[1] == second)
        return *table;
  return {};
}

std::string row_of(const Campaign& campaign, const std::string& label) {
  for (const AnswerRow& row : rows_of(campaign))
    if (row.label == label) return row.words;
  return "";
}

std::string on_one_line(const Campaign& campaign) { return in_text(document_of(campaign, with_error), 10'000); }

}  // namespace

TEST_CASE("table: the answer of a campaign counted by hand") {
  CHECK(campaign_in_short(some_campaign()) == "6 tests: 4 SLIP, 1 NO DROPS, 1 NO ANSWER.");
  CHECK(row_of(some_campaign(), "friction") == "mean 0.51 of 4 specimens, from 0.30 to 0.75, with no stiffness lost");
  CHECK(row_of(some_campaign(), "work") == "on average friction took 25 ± 3 % of the work; this is not toughness");
  CHECK(row_of(some_campaign(), "suspect") == "SS8, not in the means");
  CHECK(has(on_one_line(some_campaign()),
            "0.5 to 0.721 for glass on steel; the mean is within it, and 1 of 4 tests agree with it"));
  auto of_maize = some_campaign();
  of_maize.tests.front().materials = Materials{"maize", "steel"};
  CHECK_FALSE(has(on_one_line(of_maize), "literature"));
  const Campaign one = campaign_of({some_test("SS1", SawtoothCategory::none, 0.3, {})});
  CHECK(campaign_in_short(one) == "1 test: 1 NO DROPS.");
  CHECK(row_of(one, "friction") == "0.30, of one specimen, with no stiffness lost");
  CHECK(row_of(one, "work") == "friction took 25 ± 3 % of the work; this is not toughness");
}

TEST_CASE("limit: no tests, none with an answer, all suspect") {
  CHECK(campaign_in_short(no_tests()) == "No tests.");
  CHECK(campaign_text(no_tests()) == "No tests.\n");
  CHECK(campaign_in_short(only_failures()) == "2 tests: 2 NO ANSWER.");
  for (const AnswerRow& row : rows_of(only_failures())) CHECK(row.words.empty());
  CHECK(has(campaign_text(only_failures()), "   SS1                 a.csv:17: column 'F_N': '12,5' is not a number"));
  CHECK(has(campaign_screen(only_failures()), "  no answer       SS1: a.csv:17: column 'F_N': '12,5' is not a number"));
  const Campaign suspect = campaign_of({some_test("SS8", SawtoothCategory::clear, 1.25, 20e-6)});
  CHECK(row_of(suspect, "friction") == "1.25, of one specimen, all tests are suspect, with no stiffness lost");
  CHECK(row_of(suspect, "suspect").empty());
}

TEST_CASE("by hand: the mean friction carries each condition under which it holds") {
  Campaign campaign = some_campaign();
  campaign.tests[0].verdict = "UNDECIDED";
  campaign.tests[1].summary->on_assumed_edges = true;
  CHECK(campaign_in_short(campaign) == "6 tests: 3 SLIP, 1 UNDECIDED, 1 NO DROPS, 1 NO ANSWER.");
  CHECK(has(row_of(campaign, "friction"),
            ", with no stiffness lost, counting 1 undecided test as slips, on knife edges (not stated)"));
  campaign.tests[4].verdict = "UNDECIDED";  // suspect, so not in the mean
  CHECK(has(row_of(campaign, "friction"), "counting 1 undecided test as slips"));
  const std::string narrow = campaign_screen(campaign, {.width = 60});
  CHECK_MESSAGE(has(narrow, "not stated"), narrow);  // no width cuts a condition off
}

TEST_CASE("by hand: a screen of 12 lines has the tests with doubts, and counts the others") {
  std::vector<CampaignTest> tests;
  for (int i = 0; i < 40; ++i) {
    tests.push_back(some_test(fmt::format("T{}", i), SawtoothCategory::clear, 0.4, 8e-6));
    tests.back().remarks = i == 30 ? std::vector<std::string>{"friction decreases"} : std::vector<std::string>{};
  }
  const std::string screen = campaign_screen(campaign_of(tests));
  CHECK_MESSAGE(std::count(screen.begin(), screen.end(), '\n') == 12, screen);
  const std::size_t doubted = screen.find("  T30 "), first = screen.find("  T0 ");
  CHECK(doubted < first);
  CHECK(first < screen.size());
  CHECK_MESSAGE(has(screen, " more tests. ± is one standard error. More: --full\n"), screen);
  for (int i = 0; i < 40; ++i) CHECK(has(campaign_text(campaign_of(tests)), fmt::format("\n   T{} ", i)));
}

TEST_CASE("table: rows for people, each with as many cells as the head") {
  const auto chapters = document_of(some_campaign(), with_interval);
  for (const Chapter& chapter : chapters)
    for (const Block& block : chapter.blocks)
      if (const auto* table = std::get_if<PrintedTable>(&block))
        for (const auto& row : table->rows) CHECK(row.size() == table->head.size());
  const PrintedTable tests = table_with(chapters, "Test", "Verdict");
  const PrintedTable variation = table_with(chapters, "Test", "σ");
  REQUIRE(variation.rows.size() == 5);
  CHECK(variation.head[4] == "λ (µm)");
  CHECK(tests.rows[0][2] == "0.600 (0.576 to 0.624)");
  CHECK(variation.rows[0][4] == "10.90 (10.50 to 11.30)");
  CHECK(variation.rows[3][4].empty());
  const PrintedTable specimens = table_with(chapters, "Sawtooth", "Parameter");
  REQUIRE(specimens.rows.size() == 3);  // of all tests: no category has three to be trusted
  CHECK(specimens.rows[0][0] == "all");
  CHECK(specimens.rows[0][2] == "4");
  CHECK(specimens.rows[0][3].starts_with("0.51"));
  CHECK(specimens.rows[0][4].starts_with("± 0.20 ("));
  CHECK(specimens.rows[2][3].starts_with("4.1"));  // exp(-12.4) m
  CHECK(specimens.rows[2][3].ends_with(" µm"));
  CHECK(specimens.rows[2][4].ends_with(" at most"));  // alike by chance
}

TEST_CASE("by hand: categories have the values of their tests, and rows of their own only for others") {
  const auto rows_of_categories = [](const Campaign& campaign) {
    std::vector<std::string> rows;
    for (const auto& row : table_with(document_of(campaign, with_interval), "Sawtooth", "Tests").rows)
      rows.push_back(fmt::format("{} {} {}", row[0], row[1], row[2]));
    return rows;
  };
  CHECK(rows_of_categories(some_campaign()) ==
        std::vector<std::string>{"clear 2 0.50 (0.40 to 0.60)", "clear, with suspects 3 0.75 (0.40 to 1.25)",
                                 "nominal 1 0.75", "none 1 0.30", "all 4 0.51 (0.30 to 0.75)",
                                 "all, with suspects 5 0.66 (0.30 to 1.25)"});
  CampaignTest cracked = some_test("K1", SawtoothCategory::nominal, 1.25, 5.5e-6);  // has no friction
  cracked.summary = without_friction(*cracked.summary);
  CHECK(rows_of_categories(campaign_of({some_test("SS1", SawtoothCategory::clear, 0.3, 8e-6), cracked})) ==
        std::vector<std::string>{"clear 1 0.30", "all 1 0.30"});
  CHECK(rows_of_categories(campaign_of({some_test("SS1", SawtoothCategory::clear, 0.3, 8e-6)})) ==
        std::vector<std::string>{"clear 1 0.30"});
}

TEST_CASE("by hand: each test has a row, also without an answer, and no column is empty") {
  const PrintedTable tests = table_with(document_of(some_campaign(), with_error), "Test", "Verdict");
  REQUIRE(tests.rows.size() == 6);
  CHECK(tests.rows[5] == std::vector<std::string>{"SS99", "NO ANSWER", "", "", "", "",
                                                  "99.csv: <nothing> & \"nothing\" is not a number"});
  CampaignTest cracked = some_test("K1", SawtoothCategory::clear, 1.25, 5.5e-6);
  cracked.summary = without_friction(*cracked.summary);
  cracked.remarks = {};
  const std::string text = campaign_text(campaign_of({cracked}));
  for (const char* heading : {"Friction", "Doubts", "Modulus", "Strength"})
    CHECK_MESSAGE(!has(text.substr(0, text.find("Meaning of the columns")), heading), text);
  const std::string screen = campaign_screen(some_campaign());
  CHECK_MESSAGE(screen.find("SS99") == screen.rfind("SS99"), screen);  // with its reason, and not again as a row
}

TEST_CASE("by hand: long names are short, so that rows have room for answers, and listed once") {
  const std::string beginning = "2024-05-10, sponge of the deep sea, specimen ";
  std::vector<CampaignTest> tests;
  for (const char* end : {"1", "2"}) tests.push_back(some_test(beginning + end, SawtoothCategory::clear, 0.4, 8e-6));
  tests.push_back(failed_test(beginning + "3", "3.csv", "3.csv: no numbers."));
  const std::string screen = campaign_screen(campaign_of(tests));
  CHECK_MESSAGE(has(screen, "  no answer       3: 3.csv: no numbers.\n"), screen);
  CHECK_MESSAGE(has(screen, "\n   1     SLIP"), screen);
  CHECK(has(campaign_text(campaign_of(tests)), "Names of the tests\n   1               " + beginning + "1\n"));
  CHECK_FALSE(has(campaign_text(some_campaign()), "Names of the tests"));
}

TEST_CASE("by hand: a page opens with the tests and the figures that compare them, and folds all else") {
  const Campaign campaign = some_campaign();
  const auto chapters = document_of(campaign, with_interval);
  REQUIRE(chapters.front().blocks.size() == 2);
  CHECK(std::holds_alternative<PrintedTable>(chapters.front().blocks[0]));
  CHECK(std::get<Pictures>(chapters.front().blocks[1]).plots(two_columns).size() == 1);
  for (std::size_t i = 0; i < chapters.size(); ++i) CHECK((chapters[i].folding == Folding::always) == (i > 0));
}

TEST_CASE("by hand: one line per test on a screen, with its warnings cut at the end of the line, and all by --full") {
  Campaign campaign = some_campaign();
  campaign.tests[1].remarks = {"friction decreases", "10 drops, fit 2 to 5", "residuals are not noise", "few rows"};
  std::string text = campaign_screen(campaign);
  for (auto at = text.find("  "); at != std::string::npos; at = text.find("  ", at)) text.erase(at, 1);
  CHECK_MESSAGE(has(text, "\n Test Verdict Friction Spacing (µm) Work (%) Doubts\n"), text);
  CHECK_MESSAGE(has(text, "\n SS4 SLIP 0.400 ± 0.012 8.0 25 friction decreases; 10 …\n"), text);
  CHECK(has(campaign_text(campaign), "few rows\n"));
}
