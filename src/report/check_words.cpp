#include "report/check_words.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "answers/friction_fields.h"
#include "report/digits.h"
#include "report/printed.h"

namespace flexslip {

namespace {

bool is_without_sliding(const FittedTest& test, const Check& check) {
  return check.kind == CheckKind::friction && test.judgement && test.judgement->standing == Standing::untrusted;
}

CheckOutcome outcome_of(const FittedTest& test, const Check& check) {
  return is_without_sliding(test, check) ? CheckOutcome::not_possible : check.outcome;
}

}  // namespace

std::string finding_in_words(const FittedTest& test, const Check& check) {
  const Print print(test);
  const auto number = [&](std::string_view name) { return number_of(check, name); };
  switch (check.kind) {
    case CheckKind::residuals:
      return fmt::format("the mean of the fit, run forward, misses the measured force by {} rms, {} of the greatest.",
                         print.force(number("residual_rms")),
                         percent_of(number("residual_rms"), number("greatest_force")));
    case CheckKind::drops: {
      if (check.outcome == CheckOutcome::not_possible) return "no profiles were drawn whose drops could be counted.";
      const double record_fall = number("record_fall"), draws_fall = number("draws_fall");
      std::string words = fmt::format(
          "profiles drawn from the fit and run forward give {:.0f} to {:.0f} drops (median {:.0f}), the record has "
          "{:.0f}",
          number("draws_low"), number("draws_high"), number("draws_median"), number("record"));
      if (std::isfinite(record_fall) && std::isfinite(draws_fall))
        words += fmt::format("; their drops average {}, those of the record {}", print.force(draws_fall),
                             print.force(record_fall));
      return words + fmt::format(" (counting drops of at least {}).", print.force(number("threshold")));
    }
    case CheckKind::whiteness:
      if (check.outcome == CheckOutcome::not_possible)
        return "one friction for the whole fibre predicts no reading from the one before.";
      return fmt::format(
          "what each reading adds to those before it {} (Ljung and Box over {:.0f} readings: p {}).",
          check.outcome == CheckOutcome::passed ? "is noise"
                                                : "is not noise: something in the record is not in the model",
          number("lags"), number("p_value") < 1e-4 ? "< 0.0001" : "= " + significant(number("p_value"), 2));
    case CheckKind::nesting:
      if (check.outcome == CheckOutcome::not_possible) return "the likeliest explanation contains no other.";
      return fmt::format(
          "{} (its ln L is at most {:.1f} lower).",
          check.outcome == CheckOutcome::passed
              ? "the likeliest explanation fits no worse than the simpler ones it contains"
              : "the likeliest explanation fits worse than a simpler one it contains, so its best fit was not found",
          std::max(number("most_below"), 0.0));
    case CheckKind::friction:
      if (is_without_sliding(test, check)) return "no sliding explains this record, so that it tells no friction.";
      return check.outcome == CheckOutcome::passed
                 ? "the record tells friction from zero."
                 : fmt::format("the record does not tell friction from zero; friction is at most {} (95 %).",
                               significant(number("mu0_high"), 2));
    case CheckKind::stiffness:
      if (check.outcome == CheckOutcome::not_possible)
        return "with a constant friction the bending stiffness is not fitted.";
      return fmt::format("the bending stiffness of the fit is {} from that {}, {:.1f} times its error.",
                         signed_percent(number("fitted_over_nominal") - 1),
                         test.analysis.stiffness_from_slope ? "of the initial slope" : "stated", number("errors"));
    case CheckKind::stability:
      break;
  }
  if (check.numbers.empty()) return "with the force changed in its ninth digit there is no fit.";
  return fmt::format(
      "with the force changed in its ninth digit, μ₀ moves by {:.1g} of its standard error, and the likeliest "
      "explanation {}.",
      number("mu0_moved"), number("same_explanation") > 0 ? "stays" : "changes");
}

std::string check_in_words(const FittedTest& test, const Check& check) {
  const CheckOutcome outcome = outcome_of(test, check);
  return fmt::format("{}: {}",
                     outcome == CheckOutcome::passed   ? "Passed"
                     : outcome == CheckOutcome::failed ? "Failed"
                                                       : "Not possible",
                     finding_in_words(test, check));
}

CheckInShort check_in_short(const FittedTest& test, const Check& check) {
  if (is_without_sliding(test, check))
    return {"not possible", "friction told from zero: no sliding explains this record", ""};
  const auto number = [&](std::string_view name) { return number_of(check, name); };
  const bool passed = check.outcome == CheckOutcome::passed;
  CheckInShort said{passed ? "ok" : check.outcome == CheckOutcome::failed ? "warning" : "not possible", "", ""};
  const auto say = [&](std::string words) {
    said.words = std::move(words);
    said.remedy = remedy_of(check);
    return said;
  };
  const bool possible = check.outcome != CheckOutcome::not_possible;
  switch (check.kind) {
    case CheckKind::residuals:
      return say(fmt::format("the fit, run forward, misses the force by {}; the limit is 10 %",
                             percent_of(number("residual_rms"), number("greatest_force"))));
    case CheckKind::drops:
      if (!possible) return say("drops of the fit: it has no profiles whose drops could be counted");
      return say(fmt::format("the fit drops {} times, the record {:.0f}",
                             number("draws_low") < number("draws_high")
                                 ? fmt::format("{:.0f} to {:.0f}", number("draws_low"), number("draws_high"))
                                 : fmt::format("{:.0f}", number("draws_low")),
                             number("record")));
    case CheckKind::whiteness:
      if (!possible) return say("noise of the readings: one friction for all cannot predict the next reading");
      return say(fmt::format("what the fit leaves is {}noise (p {})", passed ? "" : "not ",
                             number("p_value") < 1e-4
                                 ? "< 0.0001"
                                 : fmt::format("= {}; the limit is 0.0001", significant(number("p_value"), 2))));
    case CheckKind::nesting:
      if (!possible) return say("simpler explanations: the likeliest one contains no other");
      return say(passed ? "no simpler explanation fits better" : "a simpler explanation fits better");
    case CheckKind::friction:
      return say(passed ? "the record tells friction from zero"
                        : fmt::format("the record does not tell friction from zero: at most {}",
                                      significant(number("mu0_high"), 2)));
    case CheckKind::stiffness:
      if (!possible) return say("the bending stiffness is not fitted with a constant friction");
      return say(fmt::format("the bending stiffness of the fit is {} from that {}, {:.1f} times its error",
                             signed_percent(number("fitted_over_nominal") - 1),
                             test.analysis.stiffness_from_slope ? "of the initial slope" : "stated", number("errors")));
    case CheckKind::stability:
      break;
  }
  if (check.numbers.empty()) return say("with the force changed in its ninth digit there is no fit");
  return say(fmt::format("with the force changed in its ninth digit, the friction moves by {:.1g} of its error",
                         number("mu0_moved")));
}

}  // namespace flexslip
