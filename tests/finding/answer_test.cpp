#include "finding/answer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include <doctest/doctest.h>

#include "answers/fit_fields.h"
#include "bending_test/history.h"
#include "case/mechanics.h"
#include "finding/sensitivities.h"
#include "tests/finding/situations.h"
#include "tests/has.h"

namespace flexslip {
namespace {

bool is_sentence(const std::string& text) {
  return !text.empty() && text.back() == '.' && !std::islower(static_cast<unsigned char>(text.front()));
}

// Empty if the answer has no such row.
std::string row_of(const Answer& answer, std::string_view label) {
  const std::vector<AnswerRow> rows = all_rows(answer);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const AnswerRow& each) { return each.label == label; });
  return row == rows.end() ? "" : row->words;
}

bool softened(const FittedTest& test) { return is_fitted(test) && !test.judgement.determines_friction; }

}  // namespace

TEST_CASE("findings, every one there is: it is found where it holds, as whole sentences, and weighs what it should") {
  std::set<std::string_view> tried;
  for (const Situation& each : situations()) {
    const std::string_view code = each.code;
    const Severity severity = each.severity;
    const FittedTest& test = each.test;
    INFO(code);
    const Answer answer = answer_of(test);
    const Finding* finding = found(answer, code);
    REQUIRE(finding);
    INFO(finding->sentence, " | ", finding->remedy);
    CHECK(finding->severity == severity);
    CHECK(is_sentence(finding->sentence));
    CHECK((finding->remedy.empty() || is_sentence(finding->remedy)));
    CHECK((severity >= Severity::condition || !finding->short_form.empty()));
    CHECK(finding->short_form.size() < 45);
    CHECK(is_sentence(answer.verdict.meaning));
    CHECK((answer.verdict.evidence.empty() || is_sentence(answer.verdict.evidence)));
    for (const Finding& doubt : doubts_of(answer)) CHECK(doubt.code != answer.verdict.finding);
    for (const AnswerRow& row : answer.rows) CHECK(!row.words.empty());
    tried.insert(code);
  }
  for (const std::string_view code : finding_codes()) {
    INFO(code);
    CHECK(tried.count(code) == 1);
  }
}

TEST_CASE("verdict: each of the six, by what it rests on") {
  const auto verdict = [](const FittedTest& test) { return answer_of(test).verdict.code; };
  CHECK(verdict(slipping()) == VerdictCode::slip);
  for (const Situation& each : situations()) {
    const std::string_view code = each.code;
    const Severity severity = each.severity;
    const FittedTest& test = each.test;
    INFO(code);
    const VerdictCode expected = code == "not_bent" || code == "deflection_for_stage" || code == "wrong_load_train" ||
                                         code == "wrong_stiffness" || code == "impossible_modulus"
                                     ? VerdictCode::check_input
                                 : code == "cracks" ? VerdictCode::crack
                                 : code == "changed_reload" && severity == Severity::note
                                     ? (is_settled(*test.passes) ? VerdictCode::settled : VerdictCode::slip_and_damage)
                                 : code == "sinks" || code == "undecided_drops" || code == "too_few_points" ||
                                         code == "not_explained" || code == "drops_elsewhere"
                                     ? VerdictCode::undecided
                                     : VerdictCode::slip;
    CHECK(verdict(test) == expected);
  }
  CHECK(verdict(changed([](FittedTest& test) {  // bent too little to tell friction, without a drop
          test.analysis.status = AnalysisStatus::deflection_too_small;
          test.analysis.rig.fibre = Fibre({.radius = 0, .half_depth = 0.05});
          test.analysis.drops.drops.clear();
          test.judgement.conclusion = Conclusion::no_drops;
        })) == VerdictCode::no_drops);
  CHECK(verdict(changed([](FittedTest& test) {
          test.analysis.drops.drops.clear();
          test.analysis.slips.clear();
          test.judgement.conclusion = Conclusion::no_drops;
        })) == VerdictCode::no_drops);
  CHECK(verdict(changed([](FittedTest& test) {  // nothing explains it, and no drop says why
          test.analysis.status = AnalysisStatus::not_explained;
          test.analysis.drops.drops.clear();
          test.judgement.conclusion = Conclusion::no_drops;
        })) == VerdictCode::check_input);
}

TEST_CASE("verdict: no friction is told of a specimen that lost stiffness, nor where there is no answer") {
  for (const Situation& each : situations()) {
    const std::string_view code = each.code;
    const Severity severity = each.severity;
    const FittedTest& test = each.test;
    const Answer answer = answer_of(test);
    const bool tells = severity > Severity::refusal && is_fitted(test) && !softened(test);
    INFO(code);
    const std::string friction = row_of(answer, "friction");
    CHECK(friction.starts_with(code == "only_a_limit" ? "at most 0." : "0.") == tells);
    CHECK(has(friction, "±") == (tells && code != "only_a_limit"));
  }
}

TEST_CASE("verdict: the word, then whole sentences; the first line of the screen is true when quoted alone") {
  for (const Situation& each : situations()) {
    const Verdict verdict = answer_of(each.test).verdict;
    const std::string sentence = sentence_of(verdict);
    INFO(sentence);
    CHECK(sentence.starts_with(std::string(word_of(verdict.code)) + ". " + verdict.meaning));
    CHECK(sentence.ends_with('.'));
    for (const char* never : {"..", ".;", "  ", "nan"}) CHECK(!has(sentence, never));
    CHECK(!has(verdict.meaning, "friction 0"));  // a friction stands beside its condition
  }
}

TEST_CASE("answer: a bending stiffness that is exact has no check that could fail") {
  const FittedTest exact = changed([](FittedTest& test) {
    test.analysis.bending_stiffness_error = 0;
    Check& check = check_of(test, CheckKind::stiffness);
    check = check_bending_stiffness(test.analysis.fit, 0);
  });
  const Finding* finding = found(answer_of(exact), "unexpected_stiffness");
  REQUIRE(finding);
  CHECK(finding->severity == Severity::unjudged);
  CHECK(has(finding->sentence, "exact"));
}

TEST_CASE("checks: those that failed are counted, whatever became of them") {
  CHECK(checks_in_words(answer_of(slipping())).starts_with("All "));
  const Answer one_failed =
      answer_of(changed([](FittedTest& test) { check_of(test, CheckKind::whiteness).outcome = CheckOutcome::failed; }));
  CHECK(has(checks_in_words(one_failed), " of "));
  auto doubted = answer_of(slipping());
  doubted.findings.push_back({.code = "few_rows", .severity = Severity::doubt, .sentence = "Few."});
  CHECK(checks_in_words(doubted).starts_with("All "));
  auto unjudged = answer_of(slipping());
  for (Finding& finding : unjudged.findings)
    if (finding.is_check) {
      finding.severity = Severity::unjudged;
      break;
    }
  CHECK(has(checks_in_words(unjudged), ", 1 not possible."));
  const Answer cracked = answer_of(changed([](FittedTest& test) {
    test.judgement = {.conclusion = Conclusion::cracks, .causes = {.slips = 0.01, .cracks = 0.78, .both = 0.21}};
    check_of(test, CheckKind::residuals).outcome = CheckOutcome::failed;
  }));
  CHECK(has(checks_in_words(cracked), ", as expected of a cracked specimen."));
}

TEST_CASE("answer: rows have one order for every test, and the next step is that of the verdict") {
  const std::vector<std::string_view> order{"friction", "work",          "spacing",       "reload", "stiffness",
                                            "strain",   "sensitivity",   "assumed",       "record", "drops",
                                            "profile",  "imaged length", "steepest part", "model"};
  for (const Situation& each : situations()) {
    const Answer answer = answer_of(each.test);
    for (const auto& rows : {answer.rows, answer.details}) {
      std::size_t last = 0;
      for (const AnswerRow& row : rows) {
        const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), row.label) - order.begin());
        REQUIRE(at < order.size());
        CHECK(at + 1 > last);
        last = at + 1;
      }
    }
  }
  const Answer undecided =
      answer_of(changed([](FittedTest& test) { test.judgement.conclusion = Conclusion::undecided; }));
  CHECK(has(undecided.next, "load again"));
  CHECK(
      sentence_of(undecided.verdict).starts_with("UNDECIDED. All 35 force drops can be slips over the supports, but "));
  CHECK(has(row_of(undecided, "friction"), " if slips with no stiffness lost; "));
}

TEST_CASE("reading: each drop says what it can be") {
  const auto reading = [](SlipVerdict verdict, bool can_be_crack) {
    Slip slip{};
    slip.verdict = verdict;
    slip.can_be_crack = can_be_crack;
    return reading_of(slip);
  };
  CHECK(reading(SlipVerdict::possible, true) == "slip or crack");
  CHECK(reading(SlipVerdict::possible, false) == "slip");
  CHECK(reading(SlipVerdict::negative, true) == "crack; a slip would need negative friction");
  CHECK(reading(SlipVerdict::unexplained, false) == "neither slip nor crack; no friction explains a slip");
}

TEST_CASE("suspect: by the findings that an answer, or its conclusion, does not survive") {
  for (const Situation& each : situations()) {
    INFO(each.code);
    const std::vector<Finding> findings = findings_of(each.test);
    const bool has_none = each.severity == Severity::refusal || !is_fitted(each.test);
    CHECK(is_refused(findings) == has_none);
    CHECK(is_suspect(findings) == (has_none || each.severity == Severity::suspicion));
  }
}

TEST_CASE("rules: a finding stands alone in its group, and a refusal is said first") {
  for (const Situation& each : situations()) {
    INFO(each.code);
    const std::vector<Finding> findings = findings_of(each.test);
    const auto refusals = std::count_if(findings.begin(), findings.end(),
                                        [](const Finding& finding) { return finding.severity == Severity::refusal; });
    CHECK(refusals <= 1);
    if (refusals == 1) CHECK(findings.front().severity == Severity::refusal);
    const auto said = [&](std::initializer_list<std::string_view> codes) {
      return std::count_if(codes.begin(), codes.end(), [&](std::string_view code) {
        const Finding* found = finding_in(findings, code);
        return found && found->severity < Severity::passed;
      });
    };
    CHECK(said({"cracks", "changed_reload"}) <= 1);
    CHECK(said({"begins_under_force", "sloping_baseline", "other_contact"}) <= 1);
    CHECK(said({"drops_elsewhere", "undecided_drops", "no_reload"}) <= 1);
    CHECK(said({"only_a_limit", "known_roughly"}) <= 1);
  }
  CHECK(finding_codes().size() <= 35);
}

TEST_CASE("no reload: asked for without drops, too, where cracks too small to be seen could be in an uneven force") {
  const auto without_drops = [](Kernel kernel) {
    return answer_of(changed([&](FittedTest& test) {
      test.analysis.drops.drops.clear();
      test.analysis.slips.clear();
      test.judgement.conclusion = Conclusion::no_drops;
      test.analysis.fit.drift = normal_estimate(0, 1);
      test.analysis.fit.mu0 = normal_estimate(0.5, 0.05);
      test.analysis.fit.shortest_wave = 0;
      for (auto& each : test.analysis.fit.explanations) each.kernel = kernel;
    }));
  };
  const Answer uneven = without_drops(Kernel::matern_3_2);
  REQUIRE(found(uneven, "no_reload"));
  CHECK(has(found(uneven, "no_reload")->sentence, "too small to detect"));
  const Answer even = without_drops(Kernel::none);
  for (const Finding& finding : even.findings) CHECK(finding.severity >= Severity::note);
}

TEST_CASE("wrong load train: named before the bending stiffness, with that which the record is as on") {
  const auto train_of = [](const Answer& answer) {
    CHECK(answer.verdict.code == VerdictCode::check_input);
    CHECK(answer.verdict.finding == "wrong_load_train");
    CHECK_FALSE(found(answer, "wrong_stiffness"));
    return found(answer, "wrong_load_train")->numbers.at(1).name == "load_train"
               ? found(answer, "wrong_load_train")->numbers.at(1).value
               : found(answer, "wrong_load_train")->numbers.at(0).value;
  };
  constexpr double stiffness = 90.65;  // [N/m] of the example
  // The stage for the deflection: the initial slope is that of specimen and load train, and friction steepens it.
  const Test stiff =
      read_case(FLEXSLIP_SOURCE_DIR "/examples/simulated/case.toml", std::vector<std::string>{"rig.stiffness=\"inf\""});
  const Answer by_slope = answer_of(fit_test(stiff, {}));
  CHECK(train_of(by_slope) == doctest::Approx(stiffness).epsilon(0.1));
  CHECK(has(sentence_of(by_slope.verdict), "CHECK INPUT. The initial slope contradicts the stated load train (∞)."));
  // The deflection for the stage: it jumps in every drop, by what the load train gives back.
  const Answer by_drops = answer_of(changed([](FittedTest& test) {
    test.analysis.rig.stiffness = std::numeric_limits<double>::infinity();
    test.analysis.record.stage = test.analysis.record.deflection;
    test.analysis.statistics = statistics_of(test.analysis.record, test.analysis.drops.drops, infinity);
  }));
  CHECK(train_of(by_drops) == doctest::Approx(stiffness).epsilon(0.02));
  CHECK(has(sentence_of(by_drops.verdict), "of 35 drops contradict the stated load train (∞)."));
  CHECK(has(sentence_of(by_drops.verdict), "as on 91 N/m."));
}

TEST_CASE("remedies: in keys of a case, or in flags for who states the test by these") {
  std::size_t told = 0;
  for (Situation& each : situations()) {
    const auto remedy_of = [&] { return found(answer_of(each.test), each.code)->remedy; };
    const std::string by_case = remedy_of();
    each.test.measurement.test.by_flags = true;
    const std::string by_flags = remedy_of();
    INFO(each.code, ": ", by_case, " | ", by_flags);
    CHECK(!has(by_case, "--"));
    for (const char* key : {"[record]", "[rig]", "[specimen]"}) CHECK(!has(by_flags, key));
    told += by_case != by_flags;
  }
  CHECK(told >= 5);
  const FittedTest late = changed([](FittedTest& test) {
    test.measurement.own_contact = {.status = ContactStatus::found, .offset = normal_estimate(4e-6, 4e-7)};
  });
  CHECK(found(answer_of(late), "other_contact")->remedy == "Write contact = \"find\" into [record] to start there.");
}

TEST_CASE("contact: at the zero of the file, also where that is stated") {
  const auto assumed = [](ContactSource source, double offset) {
    return row_of(answer_of(changed([=](FittedTest& test) {
                    test.measurement.contact = source;
                    test.measurement.contact_offset = offset;
                  })),
                  "assumed");
  };
  CHECK(has(assumed(ContactSource::stated, 0), "contact at the zero of the file"));
  CHECK(has(assumed(ContactSource::found, 0), "contact at the zero of the file"));
  CHECK(has(assumed(ContactSource::stated, 2e-6), "contact at 2 µm (stated)"));
}

TEST_CASE("work: no share of it is claimed where the analysis tells none") {
  const auto claims = [](const FittedTest& test) {
    const Answer answer = answer_of(test);
    return has(sentence_of(answer.verdict), "of the work") || !row_of(answer, "work").empty();
  };
  const auto without_drops = [](FittedTest& test) {
    test.analysis.drops.drops.clear();
    test.analysis.slips.clear();
    test.judgement.conclusion = Conclusion::no_drops;
  };
  CHECK(claims(slipping()));
  CHECK(claims(changed(without_drops)));
  CHECK_FALSE(claims(changed([&](FittedTest& test) {
    without_drops(test);
    test.analysis.energy.friction_share = not_a_number;
  })));
  CHECK_FALSE(claims(changed([](FittedTest& test) { test.analysis.energy.friction_share = not_a_number; })));
}

TEST_CASE("supports that are not stated: friction is given for both, and there is no verdict that depends on them") {
  const Answer slips = answer_of(
      on_unknown_supports([](FittedTest& rollers) { rollers.analysis.fit.mu0 = normal_estimate(0.09, 0.02); }));
  CHECK(slips.verdict.code == VerdictCode::slip);
  CHECK(has(found(slips, "supports_not_stated")->sentence, "On rollers of 63.9 µm friction is 0.090 ± 0.020."));
  CHECK(has(row_of(slips, "friction"), " on knife edges, no stiffness lost; 0.090 ± 0.020 on rollers of 63.9 µm"));
  CHECK(has(row_of(slips, "work"), " on knife edges, no stiffness lost;"));
  for (const AnswerRow& row : slips.rows) CHECK_FALSE(has(row.words, "at least"));
  CHECK(slips.verdict.finding == "supports_not_stated");

  const Answer same = answer_of(on_unknown_supports([](FittedTest&) {}));
  CHECK(has(found(same, "supports_not_stated")->sentence, "On rollers of 63.9 µm friction is 0."));
  CHECK_FALSE(has(row_of(same, "friction"), "rollers"));
  CHECK(has(row_of(same, "work"), "at least"));

  const Answer cracks = answer_of(on_unknown_supports([](FittedTest& rollers) {
    rollers.judgement = {.conclusion = Conclusion::cracks, .causes = {.slips = 0, .cracks = 0.99, .both = 0.01}};
  }));
  CHECK(cracks.verdict.code == VerdictCode::undecided);
  CHECK(cracks.verdict.finding == "supports_not_stated");
  CHECK(has(sentence_of(cracks.verdict),
            "UNDECIDED. The verdict depends on the supports, which are not stated. SLIP on knife edges (friction 0."));
  CHECK(has(sentence_of(cracks.verdict), "; CRACK on rollers of 63.9 µm."));
  CHECK(cracks.next == "State [rig] supports = \"edges\", or [rig] roller_radius.");

  // Rollers that explain nothing take no verdict away.
  const Answer edges =
      answer_of(on_unknown_supports([](FittedTest& rollers) { rollers.analysis.model_implausible = true; }));
  CHECK(edges.verdict.code == VerdictCode::slip);
}

TEST_CASE("supports that are not stated: a bar is fitted on the rollers of ISO 178, too") {
  Test bar = read_case(R"([specimen]
width = "10 mm"
height = "2 mm"
modulus = "3 GPa"
[rig]
span = "64 mm"
stiffness = "20 N/mm"
[record]
file = "bar.csv"
stage = "stage [mm]"
force = "force [N]"
)",
                       "");
  const Scales of_bar = scales_of(bar);
  const Rig rollers{of_bar.reduced_stiffness(20e3),
                    Fibre({.radius = of_bar.reduced_length(2e-3), .half_depth = of_bar.reduced_length(1e-3)})};
  std::vector<double> stages;
  for (int i = 1; i <= 300; ++i) stages.push_back(0.001 * i);
  const History history = follow_in_steps({Friction::constant(0.3), rollers}, stages);
  Table table{.source = "bar.csv", .columns = {{"stage [mm]", {}}, {"force [N]", {}}}, .lines = {}};
  for (const PathPoint& point : history.path) {
    table.columns[0].values.push_back(of_bar.physical_length(point.stage));
    table.columns[1].values.push_back(of_bar.physical_force(point.F));
  }
  bar.record->given = std::make_shared<const Table>(std::move(table));
  const FittedTest test = fit_test(bar, {});
  REQUIRE(is_fitted(test));
  REQUIRE(test.on_rollers);
  CHECK(test.on_rollers->analysis.rig.fibre.supports().radius == doctest::Approx(2.0 / 64));
  CHECK_FALSE(test.on_rollers->on_rollers);
  bar.rig->roller_radius = 2e-3;
  const FittedTest stated = fit_test(bar, {});
  CHECK_FALSE(stated.on_rollers);
  const Estimate &with = stated.analysis.fit.mu0, &without = test.on_rollers->analysis.fit.mu0;
  CHECK(std::abs(with.value - without.value) < 0.1 * with.standard_error);  // the contact is as certain as on edges
  CHECK(has(found(answer_of(test), "supports_not_stated")->sentence, "On rollers of 2 mm friction is "));
  CHECK_FALSE(slipping().on_rollers);
}

TEST_CASE("sensitivities: the largest effect on friction comes first, and the share of the work moves with it") {
  const std::vector<Sensitivity> all = sensitivities_of(slipping());
  REQUIRE(all.size() >= 6);
  std::set<std::string_view> named;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Sensitivity& each = all[i];
    CAPTURE(each.quantity);
    named.insert(each.quantity);
    if (i > 0 && each.is_supposed == all[i - 1].is_supposed)
      CHECK(std::abs(each.friction_moves) <= std::abs(all[i - 1].friction_moves));
    if (i > 0) CHECK(each.is_supposed >= all[i - 1].is_supposed);
    CHECK(std::isfinite(each.work_moves));
    CHECK(!each.stated.empty());
  }
  CHECK(named.size() == all.size());
  const auto of = [](const std::vector<Sensitivity>& list, std::string_view quantity) {
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const Sensitivity& each) { return each.quantity == quantity; });
    return at == list.end() ? std::nullopt : std::optional(*at);
  };
  CHECK(of(all, "span")->stated == "1.278 mm");
  CHECK(!of(all, "preload"));  // the case says that there was none
  CHECK(of(all, "support_radius")->stated == "edges");
  CHECK(of(all, "support_radius")->may_be_off == "say 1.3 µm");
  const std::vector<Sensitivity> open =
      sensitivities_of(changed([](FittedTest& test) { test.measurement.test.rig->supports = std::nullopt; }));
  CHECK(!of(open, "support_radius"));  // the fit on rollers tells more
  const std::vector<Sensitivity> limit =
      sensitivities_of(changed([](FittedTest& test) { test.analysis.work_share_sensitivities.reset(); }));
  CHECK(std::isnan(limit.front().work_moves));
}

// As the page is fed them (studio/tests/words_test.mjs): every one there is, as `fit --json` tells it. FLEXSLIP_FREEZE=1 writes them anew.
TEST_CASE("findings in JSON are those that the page's test is fed") {
  const std::string path = FLEXSLIP_SOURCE_DIR "/tests/outside/golden/findings.json";
  Json all = Json::array();
  for (const Situation& each : situations()) {
    const Json fit = fit_json(each.test);
    Json findings = Json::array();
    for (Json finding : fit["findings"]) {
      finding.erase("numbers");  // the page shows none of them
      findings.push_back(finding);
    }
    all.push_back({{"found", each.code},
                   {"verdict", fit["verdict"]},
                   {"answer", fit["answer"]},
                   {"findings", findings},
                   {"next", fit["next"]}});
  }
  const std::string now = all.dump(1) + "\n";
  if (std::getenv("FLEXSLIP_FREEZE")) std::ofstream(path) << now;
  std::stringstream frozen;
  frozen << std::ifstream(path).rdbuf();
  CHECK(frozen.str() == now);
}

}  // namespace flexslip
