#include <algorithm>
#include <string>

#include <doctest/doctest.h>

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

std::string on_one_line(const Campaign& campaign) { return in_text(document_of(campaign, with_error), 10'000); }

}  // namespace

TEST_CASE("table: the answer of a campaign counted by hand") {
  CHECK(campaign_in_short(some_campaign()) ==
        "6 tests: 4 slip, 0 undecided, 0 crack, 1 without drops. Friction 0.51 averaged over 4 "
        "specimens, 0.30 to 0.75 between them; 25 % of the work went into friction (19 to 31 %, 95 %). SS8 is suspect. "
        "SS99 "
        "could not be "
        "evaluated.");
  CHECK(has(on_one_line(some_campaign()),
            "0.5 to 0.721 for glass on steel; the mean is within it, and 1 of 4 tests agree with it"));
  auto of_maize = some_campaign();
  of_maize.tests.front().materials = Materials{"maize", "steel"};
  CHECK_FALSE(has(on_one_line(of_maize), "literature"));
  CHECK(campaign_in_short(campaign_of({some_test("SS1", SawtoothCategory::none, 0.3, {})})) ==
        "1 test: 0 slip, 0 undecided, 0 crack, 1 without drops. Friction 0.30; 25 % of the work went into friction (19 "
        "to 31 %, 95 %).");
}

TEST_CASE("limit: no tests, none with an answer, all suspect") {
  CHECK(campaign_in_short(no_tests()) == "No tests.");
  CHECK(campaign_text(no_tests()) == "No tests.\n");
  CHECK(campaign_in_short(only_failures()) == "No answer: none of the 2 tests could be evaluated.");
  CHECK(has(campaign_text(only_failures()), "   SS1                 a.csv:17: column 'F_N': '12,5' is not a number."));
  const std::string suspect = campaign_in_short(campaign_of({some_test("SS8", SawtoothCategory::clear, 1.25, 20e-6)}));
  CHECK(has(suspect, " Friction 1.25. SS8 is suspect."));
}

TEST_CASE("table: rows for people, each with as many cells as the head") {
  const auto chapters = document_of(some_campaign(), with_interval);
  for (const Chapter& chapter : chapters)
    for (const Block& block : chapter.blocks)
      if (const auto* table = std::get_if<PrintedTable>(&block))
        for (const auto& row : table->rows) CHECK(row.size() == table->head.size());
  const PrintedTable tests = table_with(chapters, "Test", "Verdict");
  CHECK(tests.head[8] == "λ (µm)");
  CHECK(tests.rows[0][3] == "0.600 (0.576 to 0.624)");
  CHECK(tests.rows[0][8] == "10.90 (10.50 to 11.30)");
  CHECK(tests.rows[3][8].empty());
  CHECK(table_with(chapters, "Sawtooth", "Suspects").rows[1][3] == "0.750 (0.400 to 1.250)");
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

TEST_CASE("by hand: one line per test on a terminal, with its warnings cut at the end of the line") {
  Campaign campaign = some_campaign();
  campaign.tests[1].remarks = {"friction decreases", "10 drops, fit 2 to 5", "residuals are not noise", "few rows"};
  std::string text = campaign_text(campaign);
  for (auto at = text.find("  "); at != std::string::npos; at = text.find("  ", at)) text.erase(at, 1);
  CHECK_MESSAGE(has(text, "\n Test Verdict Friction Spacing (µm) Work (%) Doubts\n"), text);
  CHECK_MESSAGE(has(text, "\n SS4 SLIP 0.400 ± 0.012 8.0 25 friction decreases; 10 …\n"), text);
}
