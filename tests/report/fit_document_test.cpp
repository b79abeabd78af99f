#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "answers/fit_fields.h"
#include "campaign/campaign.h"
#include "inference/campaign.h"
#include "io/text.h"
#include "report/answer_documents.h"
#include "report/figures.h"
#include "report/page.h"
#include "tests/finding/situations.h"
#include "tests/has.h"

namespace flexslip {
namespace {

constexpr std::size_t one_line = 100'000;

// A text on one line, as a verdict has its evidence below its meaning.
std::string flattened(std::string text) {
  for (std::size_t at = text.find("\n  "); at != std::string::npos; at = text.find("\n  ", at))
    text.replace(at, 3, " ");
  return text;
}

std::string campaign_of_one(const FittedTest& test) {
  Campaign campaign{.tests = {campaign_test_of(test, "case.toml")}, .categories = {}, .notes = {}};
  if (campaign.tests[0].summary) campaign.categories = summarise(std::vector{*campaign.tests[0].summary});
  return in_html(document_of(campaign, with_error), [] { return std::string(); });
}

}  // namespace

TEST_CASE("every finding there is: screen, text, page, JSON and campaign print its very words") {
  // The verdict of the screen says these findings in other words; a campaign has the verdict.
  constexpr std::array told_by_rows{"cracks",        "undecided_drops", "sinks",
                                    "not_explained", "too_few_points",  "drops_elsewhere"};
  constexpr std::string_view told_by_friction = "supports_not_stated";  // the condition of the friction
  for (const Situation& each : situations()) {
    INFO(each.code);
    const Answer answer = answer_of(each.test);
    const Finding& finding = *found(answer, each.code);
    INFO(finding.sentence);
    const bool on_screen = each.severity <= Severity::doubt &&
                           std::find(told_by_rows.begin(), told_by_rows.end(), each.code) == told_by_rows.end();
    const std::string screen = flattened(fit_screen("test", answer, {.width = one_line}));
    const std::string clause = finding.sentence.substr(0, finding.sentence.size() - 1);  // a verdict goes on
    if (on_screen) CHECK(has(screen, each.code == told_by_friction ? " on knife edges, " : clause));
    CHECK(has(in_text(document_of(each.test), one_line), finding.sentence));
    const std::string page = in_html(document_of(each.test), [] { return std::string(); });
    CHECK(has(page, html_escaped(finding.sentence)));
    CHECK(has(page, html_escaped(finding.remedy)));
    const Json json = fit_json(each.test);
    CHECK(std::any_of(json.at("findings").begin(), json.at("findings").end(), [&](const Json& one) {
      return one.at("code") == each.code && one.at("sentence") == finding.sentence &&
             one.at("remedy") == finding.remedy;
    }));
    if (on_screen && each.code != "changed_reload")
      CHECK(has(campaign_of_one(each.test),
                html_escaped(is_fitted(each.test) || each.severity > Severity::refusal ? finding.short_form
                                                                                       : finding.sentence)));
  }
}

TEST_CASE("document: every test without a fit shows its curve if the curve rises") {
  for (const Situation& each : situations()) {
    if (is_fitted(each.test)) continue;
    INFO(each.code);
    const std::vector<Chapter> chapters = document_of(each.test);
    const bool rises = largest(each.test.analysis.record.force) > 0;
    REQUIRE(chapters.front().blocks.size() == (rises ? 1 : 0));
    if (!rises) continue;
    for (const Panel& panel : record_figure(each.test).panels) {
      CHECK(panel.x.from < panel.x.to);
      CHECK(panel.y.from < panel.y.to);
    }
  }
}

TEST_CASE(
    "document: all passes stand in one figure, each from the turn before it, those that do the same drawn alike") {
  FittedTest test = example("cyclic");
  const auto titles = [&] {
    std::vector<std::string> all;
    const Plot drawn = passes_figure(test);
    for (const Mark& mark : drawn.panels[0].marks) all.push_back(mark.title);
    return all;
  };
  const Plot plot = passes_figure(test);
  REQUIRE(plot.data.size() == 3);
  for (std::size_t i = 1; i < 3; ++i) CHECK(plot.data[i].rows.front() == plot.data[i - 1].rows.back());
  CHECK(titles() == std::vector<std::string>{"Pass 1: in", "Pass 2: out", "Pass 3: in again"});
  std::set<std::pair<std::string, double>> lines;
  for (const Mark& mark : plot.panels[0].marks) lines.emplace(mark.style.colour, mark.style.width);
  CHECK(lines.size() == 3);
  const Json passes = fit_json(test).at("passes").at("passes");
  for (std::size_t i = 0; i < 3; ++i)
    for (const char* column : {"deflection", "force"}) CHECK(passes[i].at(column).size() == plot.data[i].rows.size());

  test.passes->passes.push_back(test.passes->passes[1]);
  CHECK(titles() == std::vector<std::string>{"Pass 1: in", "Passes 2, 4: out", "", "Pass 3: in again"});
  const Plot boxes = boxes_figure(test);
  CHECK(std::count_if(boxes.panels[0].marks.begin(), boxes.panels[0].marks.end(),
                      [](const Mark& mark) { return mark.title == "Passes 2, 4: out"; }) == 1);
}

TEST_CASE(
    "document: a record of several passes lists the friction of each, one of a single loading has no such chapter") {
  const std::string several = in_text(document_of(example("cyclic")), one_line);
  const std::string heading = "Loading, unloading and loading again";
  CHECK(has(several, heading));
  for (const char* words : {"1–201", "202–399", "400–822", "0.508 ± 0.024"}) CHECK(has(several, words));
  CHECK_FALSE(has(in_text(document_of(slipping()), one_line), heading));
}

TEST_CASE("document: the rows of an answer and its doubts are printed by --full") {
  const Answer answer = answer_of(changed([](FittedTest& test) {
    test.judgement.friction_falls = true;
    test.analysis.statistics.rows_between_drops = 4;
  }));
  const Rows doubts = full_doubts(answer);
  REQUIRE(doubts.size() == 2);
  CHECK(doubts.front().label == "doubt");
  const std::string screen = fit_screen("test", answer, {.width = one_line, .is_full = true});
  for (const Rows& rows : {all_rows(answer), doubts})
    for (const AnswerRow& row : rows) CHECK(has(screen, row.words));
}

}  // namespace flexslip
