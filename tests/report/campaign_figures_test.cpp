#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "io/text_file.h"
#include "report/draw.h"
#include "report/figures.h"
#include "tests/report/some_campaign.h"
#include "tests/temporary_folder.h"

using namespace flexslip;
namespace fs = std::filesystem;

TEST_CASE("paper: Fig. 9 shows the wavelengths of tests with a sawtooth, and the friction of all tests") {
  const Plot figure = distribution_figure(some_campaign());
  REQUIRE(figure.data.size() == 1);
  const auto& rows = figure.data[0].rows;
  REQUIRE(rows.size() == 5);
  CHECK(rows[0][1] == 1);                                     // the first test of the campaign is clear
  CHECK(rows[0][6] == doctest::Approx(10.9).epsilon(1e-15));  // one rounding, to micrometres
  CHECK(rows[0][5] == 0.6 + 0.0241);                          // the upper end of its interval
  const auto row_of_test = [&](double number) {
    return *std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row[1] == number; });
  };
  CHECK(std::isnan(row_of_test(4)[6]));  // no sawtooth
  CHECK(row_of_test(5)[2] == 1);         // suspect
  const Mark& literature = figure.panels.back().marks.front();
  CHECK(literature.kind == Mark::area);
  CHECK(literature.at == std::vector<double>{-edge, 0.5, edge, 0.721});
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i][0] >= rows[i - 1][0] + 1);  // sorted, each at its place
}

TEST_CASE("limit: the axes follow the data with their errors, so that tests that hardly differ do so to the eye") {
  std::vector<CampaignTest> tests;
  for (const double more : {0.0, 0.02}) {
    tests.push_back(some_test(more > 0 ? "B" : "A", SawtoothCategory::clear, 0.7 + more, (10 + more) * 1e-6));
    tests.back().materials = {};
  }
  const Plot figure = distribution_figure(campaign_of(tests));
  REQUIRE(figure.panels.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const double low = i == 0 ? 9.6 : 0.7 - 0.0241, high = i == 0 ? 10.42 : 0.72 + 0.0241;  // ends of the intervals
    const Axis& axis = figure.panels[i].y;
    CHECK(axis.from < low);
    CHECK(axis.to > high);
    CHECK(axis.to - axis.from < 2 * (high - low));
  }
}

TEST_CASE("limit: a figure of few tests is as wide as a column, and each name has its place up to the width") {
  std::vector<CampaignTest> tests;
  for (int i = 0; i < 30; ++i) tests.push_back(some_test(std::to_string(i), SawtoothCategory::clear, 0.4, 8e-6));
  for (const Panel& panel : laid_out(distribution_figure(campaign_of(tests))).panels)
    for (const Tick& tick : panel.x.ticks) CHECK(!tick.text.empty());
  CHECK(distribution_figure(campaign_of(tests), one_column).width == one_column);
  tests.resize(6);
  CHECK(distribution_figure(campaign_of(tests)).width == one_column);
}

TEST_CASE("labels: the words that all names share are left out, the rest stays different") {
  CHECK(labels_of({"SS1", "SS10"}) == std::vector<std::string>{"SS1", "SS10"});
  CHECK(labels_of({"sponge of 2019, specimen 1, wet", "sponge of 2019, specimen 12, dry"}) ==
        std::vector<std::string>{"1, wet", "12, dry"});
  CHECK(labels_of({"1 of the sponge", "2 of the sponge"}) == std::vector<std::string>{"1", "2"});
  CHECK(labels_of({"a", "a"}) == std::vector<std::string>{"1: a", "2: a"});
  CHECK(labels_of({"a \x1b b"}) == std::vector<std::string>{"a   b"});
  CHECK(labels_of({}).empty());
  const auto longer = labels_of({"äöüäöüäöüäöüäöüäöüäöü1", "äöüäöüäöüäöüäöüäöüäöü2", "x"});
  CHECK(longer[0] == "äöüäöüäöü…äöüäöüäöü1");
  CHECK(longer[0] != longer[1]);
}

TEST_CASE(
    "outside: tests that are counted have their names along the axis, and the key has no more than what is drawn") {
  const Plot figure = laid_out(distribution_figure(some_campaign()));
  for (const Panel& panel : figure.panels) {
    REQUIRE(panel.x.from == figure.panels.front().x.from);
    std::vector<std::string> names;
    for (const Tick& tick : panel.x.ticks) names.push_back(tick.text);
    std::vector<std::string> tests;
    for (const CampaignTest& test : some_campaign().tests)
      if (test.summary) tests.push_back(as_it_is(test.name));
    CHECK(std::set<std::string>(names.begin(), names.end()) == std::set<std::string>(tests.begin(), tests.end()));
  }
  const auto has_entry = [](const Plot& plot, std::string_view title) {
    return std::any_of(plot.panels.begin(), plot.panels.end(), [&](const Panel& panel) {
      return std::any_of(panel.marks.begin(), panel.marks.end(), [&](const Mark& mark) { return mark.title == title; });
    });
  };
  CHECK(has_entry(figure, "Suspect"));
  const Plot one = distribution_figure(campaign_of({some_test("SS13", SawtoothCategory::none, 0.3, {})}));
  CHECK(!has_entry(one, "Suspect"));
  CHECK(has_entry(one, "95 %"));
}

TEST_CASE("limit: a category without tests has no range, and without waves there is no panel of wavelengths") {
  const Plot figure = distribution_figure(campaign_of({some_test("SS13", SawtoothCategory::none, 0.3, {})}));
  REQUIRE(figure.panels.size() == 1);
  const auto& marks = figure.panels[0].marks;
  CHECK(std::any_of(marks.begin(), marks.end(), [](const Mark& mark) {
    return mark.kind == Mark::label && mark.title.find("almost no sawtooth") == 0;
  }));
}

TEST_CASE("limit: a legend has entries only for marks that are drawn") {
  const auto entry = [](const Plot& figure, std::string_view title) {
    const auto& marks = figure.panels.front().marks;
    return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.title.find(title) == 0; });
  };
  CHECK(entry(distribution_figure(some_campaign()), "Suspect"));
  CHECK(entry(distribution_figure(some_campaign()), "Mean of all"));
  CampaignTest limit = some_test("SS4", SawtoothCategory::none, 1.25, {});
  limit.summary->mu0_is_bound = true;  // a suspect whose friction is only a limit: a line without a mark
  const Plot bare = distribution_figure(campaign_of({limit}));
  for (const char* title : {"Suspect", "Mean of all", "Mean, suspects left out", "Wave not detected"})
    CHECK(!entry(bare, title));
  // Of one category the mean is the mean of all.
  CHECK(!entry(distribution_figure(campaign_of({some_test("SS4", SawtoothCategory::none, 0.4, {})})), "Mean of all"));
}

TEST_CASE("limit: the atlas draws no model of a specimen that cracked") {
  CampaignTest cracked = some_test("K12", SawtoothCategory::clear, 0.4, 5.5e-6);
  cracked.verdict = "CRACK";
  cracked.summary = without_friction(*cracked.summary);
  const auto models = [](const std::vector<CampaignTest>& tests) {
    const Plot page = atlas_pages(campaign_of(tests)).at(0);
    std::size_t drawn = 0;
    for (const Panel& panel : page.panels)
      for (const Mark& mark : panel.marks) drawn += mark.table == "model" || mark.title == "Model";
    return drawn;
  };
  CHECK(models({cracked}) == 0);
  CHECK(models({cracked, some_test("SS4", SawtoothCategory::clear, 0.4, 5.5e-6)}) == 2);  // a line, and its entry
}

TEST_CASE("limit: a campaign without friction has no distribution, and a test without friction no place in it") {
  CampaignTest cracked = some_test("K12", SawtoothCategory::clear, 0.4, 5.5e-6);
  cracked.summary = without_friction(*cracked.summary);
  for (const Campaign& campaign : {no_tests(), only_failures(), campaign_of({cracked})}) {
    CHECK_THROWS_AS(distribution_figure(campaign), std::invalid_argument);
    CHECK(comparison_figures(campaign).empty());
  }
  const Plot figure = distribution_figure(campaign_of({cracked, some_test("SS4", SawtoothCategory::clear, 0.4, 5e-6)}));
  CHECK(figure.data[0].rows.size() == 1);
  CHECK(atlas_pages(no_tests()).empty());
  CHECK(atlas_pages(only_failures()).empty());
}

TEST_CASE("paper: Figs. 10 to 13 have one panel per test, 20 per page, and suspect tests again at the end") {
  std::vector<CampaignTest> tests;
  for (char c = 'A'; c <= 'U'; ++c) tests.push_back(some_test(std::string(1, c), SawtoothCategory::nominal, 0.5, 9e-6));
  tests.push_back(some_test("a suspect", SawtoothCategory::clear, 1.25, 20e-6));
  const auto pages = atlas_pages(campaign_of(tests));
  REQUIRE(pages.size() == 4);
  CHECK(pages[0].name == "atlas-clear-1");
  CHECK(pages[1].name == "atlas-nominal-1");
  CHECK(pages[2].name == "atlas-nominal-2");
  CHECK(pages[3].name == "atlas-suspect-1");
  CHECK(pages[1].height <= 277);  // A4 less margins of 10 mm
  CHECK(pages[1].width <= 190);
  CHECK(pages[1].panels.size() == 20);
  CHECK(pages[2].panels.size() == 1);
  for (const Plot& page : atlas_pages(campaign_of(tests), one_column)) {
    CHECK(in_width(page, one_column).width <= one_column);
    CHECK(page.height <= 277);
    CHECK(page.columns <= 2);
  }
}

TEST_CASE("limit: load lines have the slope of the load train, reference curves the small-deflection slope") {
  const auto pages = atlas_pages(campaign_of({some_test("SS4", SawtoothCategory::clear, 0.4, 5.5e-6)}));
  REQUIRE(pages.size() == 1);
  const auto& drops = table_of(pages[0], "drops").rows;
  REQUIRE(drops.size() == 6);                                                      // two lines and what parts them
  const double slope = (drops[1][2] - drops[0][2]) / (drops[1][1] - drops[0][1]);  // [mN/µm]
  CHECK(slope == doctest::Approx(-90.6e-3).epsilon(1e-9));                         // differences of the decimals kept
  const double initial = 48 * 2.13e-9 / std::pow(1278e-6, 3) * 1e-3;               // [mN/µm]
  const auto& beam = table_of(pages[0], "beam").rows[1];
  CHECK(beam[2] / beam[1] == doctest::Approx(initial).epsilon(1e-12));  // a few roundings
  const auto& smooth = table_of(pages[0], "frictionless").rows[1];
  CHECK(smooth[2] / smooth[1] == doctest::Approx(initial).epsilon(1e-2));  // F = 48 w (1 - O(w²)), w = 0.005 there
}

TEST_CASE("identity: the atlas draws the curve without friction on the supports of the test") {
  // [EI/L^2] at a deflection of 0.3 spans, as `flexslip state --w 0.3 --q 0` prints it.
  for (const auto& [supports, force] :
       {std::pair{Supports{0, 0}, 6.33}, std::pair{Supports{0, 0.5 * 34.8 / 1278}, 6.58},
        std::pair{Supports{0.08, 0}, 8.01}}) {
    CampaignTest test = some_test("SS4", SawtoothCategory::clear, 0.4, 5.5e-6);
    test.curves->supports = supports;
    const auto pages = atlas_pages(campaign_of({test}));
    const auto& rows = table_of(pages.at(0), "frictionless").rows;
    const double w = 0.3 * 1278, per_force = 1e3 * 2.13e-9 / std::pow(1278e-6, 2);  // [µm], [mN]
    std::size_t i = 1;
    while (rows.at(i)[1] < w) ++i;
    const double at_w = std::lerp(rows[i - 1][2], rows[i][2], (w - rows[i - 1][1]) / (rows[i][1] - rows[i - 1][1]));
    CHECK(at_w / per_force == doctest::Approx(force).epsilon(0.003));  // three digits, and straight between the points
  }
}

TEST_CASE("outside: gnuplot draws every figure with any names") {
  const TemporaryFolder folder;
  Campaign campaign = some_campaign();
  campaign.tests.push_back(some_test("it's {/=50 big}^2 \\n @x ~ `id` $(id)", SawtoothCategory::clear, 0.4, 300e-6));
  campaign.tests.push_back(some_test("\xff\n", SawtoothCategory::nominal, 0.4, 1e-6));
  auto figures = atlas_pages(campaign);
  figures.push_back(distribution_figure(campaign));
  for (const auto& figure : figures) {
    INFO(figure.name);
    if (!draw(figure, folder.path(), {"svg", "pdf"}).is_done()) return;
    CHECK(fs::file_size(folder.path() / (figure.name + ".pdf")) > 5000);
  }
  const std::string svg = bytes_of(folder.path() / "atlas-clear-1.svg");
  CHECK(svg.find("A &lt;b> &amp; 50%_ü") != std::string::npos);
  CHECK(svg.find("it's {/=5…") != std::string::npos);
}

TEST_CASE("losses: a reloaded test with drops is drawn at its measured and its required loss") {
  Campaign campaign = some_campaign();
  CHECK(!has_losses(campaign));
  CHECK_THROWS_AS(losses_figure(campaign), std::invalid_argument);
  const auto with_summary = std::find_if(campaign.tests.begin(), campaign.tests.end(),
                                         [](const CampaignTest& test) { return test.summary.has_value(); });
  REQUIRE(with_summary != campaign.tests.end());
  with_summary->summary->loss = LostStiffness{.lost = 0.1, .error = 0.02, .needed = 0.3};
  REQUIRE(has_losses(campaign));
  const Plot figure = losses_figure(campaign);
  REQUIRE(figure.data[0].rows.size() == 1);
  CHECK(figure.data[0].rows[0][0] == doctest::Approx(30));
  CHECK(figure.data[0].rows[0][1] == doctest::Approx(10));
  with_summary->summary->loss->lost = -0.07;  // a gain is seen whole
  with_summary->summary->loss->error = 0.04;
  CHECK(losses_figure(campaign).panels[0].y.from < 100 * (-0.07 - 1.96 * 0.04));
}
