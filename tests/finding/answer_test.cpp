#include "finding/answer.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include <doctest/doctest.h>

#include "case/case_file.h"
#include "finding/fit_findings.h"
#include "tests/has.h"

namespace flexslip {
namespace {

FittedTest example(const std::string& name) {
  return fit_test(read_case(FLEXSLIP_SOURCE_DIR "/examples/" + name + "/case.toml"), {});
}

const FittedTest& slipping() {
  static const FittedTest test = example("simulated");
  return test;
}

// The example that slips, changed so.
template <class Change>
FittedTest changed(const Change& change) {
  FittedTest test = slipping();
  change(test);
  return test;
}

Check& check_of(FittedTest& test, CheckKind kind) {
  return *std::find_if(test.analysis.checks.begin(), test.analysis.checks.end(),
                       [&](const Check& check) { return check.kind == kind; });
}

const Finding* found(const Answer& answer, std::string_view code) {
  const auto at = std::find_if(answer.findings.begin(), answer.findings.end(),
                               [&](const Finding& finding) { return finding.code == code; });
  return at == answer.findings.end() ? nullptr : &*at;
}

// Each a test of which that is found which it is named by.
struct Situation {
  std::string_view code;
  Severity severity;
  FittedTest test;
};

std::vector<Situation> situations() {
  std::vector<Situation> all;
  const auto add = [&](std::string_view code, Severity severity, const auto& change) {
    all.push_back({code, severity, changed(change)});
  };
  add("no_force", Severity::refusal, [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::too_few_points;
    for (double& force : test.analysis.record.force) force = -1;
  });
  add("no_initial_slope", Severity::refusal,
      [](FittedTest& test) { test.analysis.status = AnalysisStatus::no_initial_slope; });
  add("too_deep", Severity::refusal, [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::too_few_points;
    test.analysis.reduced.deflection.back() = 3.9;
  });
  add("too_few_rows", Severity::refusal, [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::too_few_points;
    test.analysis.record.force.resize(12);
  });
  add("too_few_points", Severity::refusal,
      [](FittedTest& test) { test.analysis.status = AnalysisStatus::too_few_points; });
  add("wrong_stiffness", Severity::refusal, [](FittedTest& test) {
    test.analysis.stiffness_implausible = true;
    test.analysis.stiffness_over_slope = 16;
  });
  add("not_explained", Severity::refusal,
      [](FittedTest& test) { test.analysis.status = AnalysisStatus::not_explained; });
  add("softer_reload", Severity::suspicion, [](FittedTest& test) {
    test.judgement->softer_reload = true;
    test.judgement->loss = 0.2;
    test.judgement->loss_error = 0.01;
  });
  add("cracks", Severity::suspicion, [](FittedTest& test) {
    test.judgement->drops_are_cracks = true;
    test.judgement->drops = CrackVerdict::cracks;
  });
  add("most_drops_impossible", Severity::refusal, [](FittedTest& test) { test.judgement->impossible = 30; });
  add("no_sliding", Severity::refusal, [](FittedTest& test) { test.analysis.model_implausible = true; });
  add("impossible_drops", Severity::doubt, [](FittedTest& test) { test.judgement->impossible = 2; });
  add("implausible_friction", Severity::suspicion, [](FittedTest& test) { test.analysis.fit.mu0.low = 1.01; });
  for (const auto& [code, kind] :
       {std::pair{"misses_force", CheckKind::residuals}, std::pair{"drops_differ", CheckKind::drops},
        std::pair{"coloured_noise", CheckKind::whiteness}, std::pair{"simpler_fits_better", CheckKind::nesting},
        std::pair{"unexpected_stiffness", CheckKind::stiffness}})
    add(code, Severity::doubt,
        [kind = kind](FittedTest& test) { check_of(test, kind).outcome = CheckOutcome::failed; });
  add("unstable", Severity::doubt, [](FittedTest& test) {
    test.analysis.checks.push_back(
        {CheckKind::stability, CheckOutcome::failed, {{"mu0_moved", 0.5, false}, {"same_explanation", 0, false}}});
  });
  add("falling_friction", Severity::doubt, [](FittedTest& test) { test.judgement->friction_falls = true; });
  add("changed_reload", Severity::doubt, [](FittedTest& test) {
    test.judgement->changed_reload = true;
    test.judgement->loss = -0.2;
    test.judgement->loss_error = 0.01;
  });
  add("coarse_force", Severity::doubt,
      [](FittedTest& test) { test.analysis.drops.smallest_fall = 0.1 * test.analysis.record.force.back(); });
  add("undecided_drops", Severity::doubt,
      [](FittedTest& test) { test.judgement->drops = CrackVerdict::cannot_be_told; });
  add("few_rows", Severity::doubt, [](FittedTest& test) { test.judgement->few_rows = true; });
  add("below_frictionless", Severity::doubt, [](FittedTest& test) { test.analysis.friction_read.median = -0.3; });
  add("settling_contact", Severity::doubt, [](FittedTest& test) {
    test.analysis.contact.status = ContactStatus::found;
    test.analysis.contact.settles = true;
    test.analysis.contact.offset = normal_estimate(2e-6, 1e-7);
  });
  add("only_a_limit", Severity::note, [](FittedTest& test) {
    check_of(test, CheckKind::friction).outcome = CheckOutcome::failed;
    test.analysis.fit.mu0_is_bound = true;
  });
  add("no_reload", Severity::note, [](FittedTest&) {});
  add("jumps", Severity::note, [](FittedTest& test) {
    test.judgement->jumped = 0.6;
    test.judgement->stiffness_for_all = 300;
  });
  add("imaged_length", Severity::note, [](FittedTest& test) {
    test.imaged = ImagedLength{.points = {{}, {}}, .offset = normal_estimate(0.001, 0.0001), .scatter = 0.002};
  });
  return all;
}

bool is_sentence(const std::string& text) {
  return !text.empty() && text.back() == '.' && !std::islower(static_cast<unsigned char>(text.front()));
}

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
    CHECK((severity >= Severity::note || !finding->short_form.empty()));
    CHECK(finding->short_form.size() < 45);
    CHECK(!answer.verdict.parts.empty());
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
    const VerdictCode expected = code == "wrong_stiffness" || code == "most_drops_impossible" ? VerdictCode::check_input
                                 : code == "softer_reload" || code == "cracks"                ? VerdictCode::crack
                                 : severity == Severity::refusal                              ? VerdictCode::no_answer
                                 : code == "undecided_drops" || code == "impossible_drops"    ? VerdictCode::undecided
                                                                                              : VerdictCode::slip;
    CHECK(verdict(test) == expected);
  }
  CHECK(verdict(changed([](FittedTest& test) {
          test.analysis.drops.drops.clear();
          test.analysis.slips.clear();
        })) == VerdictCode::no_drops);
}

TEST_CASE("verdict: no friction is told of a specimen that lost stiffness, nor where there is no answer") {
  for (const Situation& each : situations()) {
    const std::string_view code = each.code;
    const Severity severity = each.severity;
    const FittedTest& test = each.test;
    const Answer answer = answer_of(test);
    const bool tells = severity > Severity::refusal && code != "cracks" && code != "softer_reload";
    INFO(code);
    CHECK(has(sentence_of(answer.verdict), code == "only_a_limit" ? "friction at most" : "friction 0.4") == tells);
    const auto friction = std::find_if(answer.rows.begin(), answer.rows.end(),
                                       [](const AnswerRow& row) { return row.label == "friction"; });
    CHECK((friction != answer.rows.end() && has(friction->words, "±")) == (tells && code != "only_a_limit"));
  }
}

TEST_CASE("answer: rows have one order for every test, and the next step is that of the verdict") {
  const std::vector<std::string_view> order{"drops",  "slip or crack", "friction", "work",
                                            "reload", "stiffness",     "assumed"};
  for (const Situation& each : situations()) {
    std::size_t last = 0;
    for (const AnswerRow& row : answer_of(each.test).rows) {
      const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), row.label) - order.begin());
      REQUIRE(at < order.size());
      CHECK(at + 1 > last);
      last = at + 1;
    }
  }
  const Answer undecided =
      answer_of(changed([](FittedTest& test) { test.judgement->drops = CrackVerdict::cannot_be_told; }));
  CHECK(has(undecided.next, "oad once more"));
  CHECK(has(sentence_of(undecided.verdict), "UNDECIDED: friction 0.4"));
  CHECK(has(sentence_of(undecided.verdict), "if the drops are slips"));
}

TEST_CASE("standing: by the weightiest finding") {
  for (const Situation& each : situations()) {
    const std::string_view code = each.code;
    const Severity severity = each.severity;
    const FittedTest& test = each.test;
    INFO(code);
    CHECK(standing_of(findings_of(test)) == (severity == Severity::refusal     ? Standing::untrusted
                                             : severity == Severity::suspicion ? Standing::suspect
                                             : severity == Severity::doubt     ? Standing::doubtful
                                                                               : Standing::sound));
  }
}

}  // namespace flexslip
