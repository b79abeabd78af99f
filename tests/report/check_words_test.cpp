#include "report/check_words.h"

#include <doctest/doctest.h>

#include "case/case_file.h"
#include "tests/has.h"

using namespace flexslip;

namespace {

// The shipped example, said to stand so.
FittedTest judged(Standing standing) {
  static const FittedTest example = fit_test(read_case(FLEXSLIP_SOURCE_DIR "/examples/cracked/case.toml"), {});
  FittedTest test = example;
  test.judgement->standing = standing;
  test.judgement->doubts.clear();
  return test;
}

Check check_of(CheckKind kind, CheckOutcome outcome) {
  return {.kind = kind,
          .outcome = outcome,
          .numbers = {{"residual_rms", 0.1, true},
                      {"greatest_force", 1, true},
                      {"record", 13, false},
                      {"draws_low", 0, false},
                      {"draws_high", 1, false},
                      {"draws_median", 0, false},
                      {"record_fall", 0.2, true},
                      {"draws_fall", 0.1, true},
                      {"threshold", 0.01, true},
                      {"p_value", 0.5, false},
                      {"lags", 20, false},
                      {"most_below", -1, false},
                      {"mu0_high", 0.013, false},
                      {"fitted_over_nominal", 1.02, false},
                      {"errors", 0.7, false},
                      {"mu0_moved", 0.001, false},
                      {"same_explanation", 1, false}}};
}

}  // namespace

TEST_CASE(
    "check words, every kind and outcome: a clause without a full stop, a sentence with one, what to do only of a "
    "warning") {
  const FittedTest test = judged(Standing::sound);
  for (const CheckKind kind : {CheckKind::residuals, CheckKind::drops, CheckKind::whiteness, CheckKind::nesting,
                               CheckKind::friction, CheckKind::stiffness, CheckKind::stability})
    for (const CheckOutcome outcome : {CheckOutcome::passed, CheckOutcome::failed, CheckOutcome::not_possible}) {
      const CheckInWords said = check_in_words(test, check_of(kind, outcome));
      INFO(said.outcome, ": ", said.words, " | ", said.detail, " | ", said.remedy);
      CHECK(!said.words.empty());
      CHECK(said.words.back() != '.');
      CHECK((said.detail.empty() || said.detail.back() == '.'));
      CHECK(said.remedy.empty() == (outcome != CheckOutcome::failed));
      CHECK(said.outcome == (outcome == CheckOutcome::passed   ? "ok"
                             : outcome == CheckOutcome::failed ? "warning"
                                                               : "not possible"));
    }
}

TEST_CASE("check words: of a fit that is not to be used, only what says so is told") {
  const FittedTest test = judged(Standing::untrusted);
  for (const CheckKind kind :
       {CheckKind::drops, CheckKind::whiteness, CheckKind::nesting, CheckKind::friction, CheckKind::stability})
    for (const CheckOutcome outcome : {CheckOutcome::passed, CheckOutcome::failed}) {
      const CheckInWords said = check_in_words(test, check_of(kind, outcome));
      CHECK(said.outcome == "not possible");
      CHECK(said.remedy.empty());
      CHECK(has(said.words, "the fit is not to be used"));
    }
  for (const CheckKind kind : {CheckKind::residuals, CheckKind::stiffness})
    CHECK(check_in_words(test, check_of(kind, CheckOutcome::failed)).outcome == "warning");
}

TEST_CASE("check words: slip or crack comes first, with its remedy; nothing of it without drops") {
  FittedTest test = judged(Standing::suspect);
  const auto first = [&](CrackVerdict verdict) {
    test.judgement->drops = test.analysis.slip_or_crack.verdict = verdict;
    return checks_in_words(test).front();
  };
  const CheckInWords cracks = first(CrackVerdict::cracks), slips = first(CrackVerdict::not_by_cracks_alone);
  CHECK(cracks.outcome == "warning");
  CHECK(has(cracks.words, "slip or crack: the drops are those of a specimen that cracks (D* = -15.2)"));
  CHECK(has(cracks.remedy, "unload and load once more"));
  CHECK(slips.outcome == "ok");
  CHECK(slips.remedy.empty());
  CHECK(has(first(CrackVerdict::cannot_be_told).words, "this record cannot tell"));
  test.analysis.slip_or_crack.judged = false;
  CHECK(first(CrackVerdict::cannot_be_told).outcome == "not possible");
  test.analysis.drops.drops.clear();
  CHECK(!has(checks_in_words(test).front().words, "slip or crack"));
}
