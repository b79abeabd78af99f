#include "report/check_words.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "answers/friction_fields.h"
#include "report/answer_words.h"
#include "report/digits.h"
#include "report/fit_print.h"
#include "report/printed.h"

namespace flexslip {

namespace {

// What a check of a fit is about, if it says nothing of one that is not to be used; empty if it says why that is so.
std::string_view presuming_sliding(CheckKind kind) {
  switch (kind) {
    case CheckKind::drops:
      return "drops of the fit";
    case CheckKind::whiteness:
      return "noise of the readings";
    case CheckKind::nesting:
      return "simpler explanations";
    case CheckKind::friction:
      return "friction told from zero";
    case CheckKind::stability:
      return "the ninth digit of the force";
    case CheckKind::residuals:
    case CheckKind::stiffness:
      break;
  }
  return "";
}

// Why a check says nothing of this fit; empty if it does.
std::string_view why_not(const FittedTest& test, CheckKind kind) {
  if (!is_trusted(test.judgement.value().standing) && !presuming_sliding(kind).empty())
    return "the fit is not to be used";
  return kind == CheckKind::friction && !caution_of(test).empty() ? "the specimen lost stiffness" : "";
}

struct Finding {
  std::string words;   // a clause
  std::string detail;  // a sentence; empty if there is none
};

Finding finding_of(const FittedTest& test, const Check& check) {
  if (const std::string_view why = why_not(test, check.kind); !why.empty())
    return {fmt::format("{}: {}", presuming_sliding(check.kind), why), ""};
  const Print print(test);
  const auto number = [&](std::string_view name) { return number_of(check, name); };
  const bool passed = check.outcome == CheckOutcome::passed, possible = check.outcome != CheckOutcome::not_possible;
  switch (check.kind) {
    case CheckKind::residuals:
      return {fmt::format("the mean of the fit, run forward, misses the force by {}; the limit is 10 %",
                          percent_of(number("residual_rms"), number("greatest_force"))),
              fmt::format("That is {} rms; the percentage is of the greatest force measured.",
                          print.force(number("residual_rms")))};
    case CheckKind::drops: {
      if (!possible) return {"drops of the fit: it has no profiles whose drops could be counted", ""};
      const double record_fall = number("record_fall"), draws_fall = number("draws_fall");
      std::string detail =
          fmt::format("Profiles drawn from the fit give a median of {:.0f}, counting falls of at least {}",
                      number("draws_median"), print.force(number("threshold")));
      if (std::isfinite(record_fall) && std::isfinite(draws_fall))
        detail += fmt::format("; their drops average {}, those of the record {}", print.force(draws_fall),
                              print.force(record_fall));
      return {fmt::format("drops of the fit: {}; of the record: {:.0f}",
                          number("draws_low") < number("draws_high")
                              ? fmt::format("{:.0f} to {:.0f}", number("draws_low"), number("draws_high"))
                              : fmt::format("{:.0f}", number("draws_low")),
                          number("record")),
              detail + "."};
    }
    case CheckKind::whiteness:
      if (!possible) return {"noise of the readings: one friction for all cannot predict the next reading", ""};
      return {fmt::format("what the fit leaves is {}noise (p {})", passed ? "" : "not ",
                          number("p_value") < 1e-4
                              ? "< 0.0001"
                              : fmt::format("= {}; the limit is 0.0001", significant(number("p_value"), 2))),
              fmt::format("Ljung and Box's test of what each reading adds to those before it, over {:.0f} readings.",
                          number("lags"))};
    case CheckKind::nesting:
      if (!possible) return {"simpler explanations: the likeliest one contains no other", ""};
      return {passed ? "no simpler explanation fits better" : "a simpler explanation fits better",
              fmt::format("The ln L of the likeliest explanation is at most {:.1f} below that of a simpler one.",
                          std::max(number("most_below"), 0.0))};
    case CheckKind::friction:
      return {passed ? "the record tells friction from zero"
                     : fmt::format("the record does not tell friction from zero: at most {} (95 %)",
                                   significant(number("mu0_high"), 2)),
              ""};
    case CheckKind::stiffness:
      if (!possible) return {"the bending stiffness is not fitted with a constant friction", ""};
      return {
          fmt::format("the bending stiffness of the fit is {} from that {}, {:.1f} times its error",
                      signed_percent(number("fitted_over_nominal") - 1), stiffness_beforehand(test), number("errors")),
          ""};
    case CheckKind::stability:
      break;
  }
  if (check.numbers.empty()) return {"with the force changed in its ninth digit there is no fit", ""};
  return {fmt::format("with the force changed in its ninth digit, the friction moves by {:.1g} of its error",
                      number("mu0_moved")),
          fmt::format("The likeliest explanation {}.", number("same_explanation") > 0 ? "stays" : "changes")};
}

std::string_view in_words(CheckOutcome outcome) {
  return outcome == CheckOutcome::passed ? "ok" : outcome == CheckOutcome::failed ? "warning" : "not possible";
}

// Domain: the record has drops.
CheckInWords slip_or_crack_in_words(const FittedTest& test) {
  const SlipOrCrack& rises = test.analysis.slip_or_crack;
  const CrackVerdict verdict = test.judgement->drops;
  if (test.analysis.stiffness_implausible)
    return {std::string(in_words(CheckOutcome::not_possible)),
            "slip or crack: not at a bending stiffness that is wrong", "", ""};
  const std::string by =
      rises.judged && rises.verdict == verdict ? fmt::format(" (D* = {:.1f})", rises.margin) : " (by the reload)";
  const std::string_view reload = test.cycles ? "" : "unload and load once more";
  const auto said = [](CheckOutcome outcome, std::string words, std::string_view remedy) {
    return CheckInWords{std::string(in_words(outcome)), "slip or crack: " + std::move(words), "", std::string(remedy)};
  };
  switch (verdict) {
    case CrackVerdict::not_by_cracks_alone:
      return said(CheckOutcome::passed, "cracks alone cannot give the drops" + by, "");
    case CrackVerdict::cracks:
      return said(CheckOutcome::failed, "the drops are those of a specimen that cracks" + by, reload);
    case CrackVerdict::cannot_be_told:
      break;
  }
  return rises.judged ? said(CheckOutcome::failed, "this record cannot tell" + by, reload)
                      : said(CheckOutcome::not_possible, "too few drops, or rises between them", reload);
}

}  // namespace

std::string rises_in_words(const SlipOrCrack& rises) {
  return fmt::format("D* = {:.1f}; {} of {} rises grow stiffer", rises.margin, rises.stiffer_rises, rises.rises);
}

CheckInWords check_in_words(const FittedTest& test, const Check& check) {
  auto [words, detail] = finding_of(test, check);
  const CheckOutcome outcome = !why_not(test, check.kind).empty() ? CheckOutcome::not_possible : check.outcome;
  return {.outcome = std::string(in_words(outcome)),
          .words = std::move(words),
          .detail = std::move(detail),
          .remedy = outcome == CheckOutcome::failed ? std::string(remedy_of(check)) : ""};
}

std::vector<CheckInWords> checks_in_words(const FittedTest& test) {
  std::vector<CheckInWords> all;
  if (!test.analysis.drops.drops.empty()) all.push_back(slip_or_crack_in_words(test));
  for (const Check& check : test.analysis.checks) all.push_back(check_in_words(test, check));
  return all;
}

}  // namespace flexslip
