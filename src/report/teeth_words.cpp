#include "report/teeth_words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "answers/fit_fields.h"
#include "io/quantity.h"
#include "report/field_table.h"

namespace flexslip {
namespace {

std::string compliance_in_words(const SupportCompliance& compliance, const FittedTest& test) {
  const double error = std::hypot(compliance.estimate.standard_error, compliance.systematic);
  if (test.reduced) return readable(compliance.estimate.value, error, kind::number);
  const double unit = 1 / test.analysis.scales.stiffness_unit();
  return readable(compliance.estimate.value * unit, error * unit, Print(test).as(kind::compliance));
}

// Friction that builds up looks like sliding of one that is there at once.
std::string build_up_in_words(const FittedTest& test, std::size_t sliding) {
  constexpr double recovered = 3;  // of its lengths, after which 95 % of a change are there
  if (sliding == 0) return "";
  const auto& build_up = test.cycles ? test.cycles->build_up : std::nullopt;
  if (!build_up)
    return " Friction that builds up over a length of sliding also imitates sliding, in rises that pull in less than "
           "three such lengths. Unload once: a reversal shows whether friction builds up.";
  if (!build_up->is_told()) return "";
  const auto& teeth = test.analysis.teeth->teeth;
  const double least = recovered * build_up->length.value;
  const auto near = std::count_if(teeth.begin(), teeth.end(), [&](const Tooth& tooth) {
    return tooth.verdict == ToothVerdict::sliding && tooth.advance.value < least;
  });
  return fmt::format(
      " Friction builds up after the reversals of this record, which also imitates sliding: {} of the sliding rises "
      "pull "
      "in less than {} (three build-up lengths) and may only creep.",
      near, roughly(test.analysis.scales.physical_length(least), Print(test).as(kind::length)));
}

std::string compliant_supports(const FittedTest& test, std::size_t sliding) {
  const Teeth& judged = *test.analysis.teeth;
  const auto& compliance = judged.compliance;
  if (compliance.status != ComplianceStatus::ok)
    return " Supports that yield imitate sliding; these teeth do not show how much the supports yield.";
  const auto rejected = static_cast<std::size_t>(std::count_if(
      judged.teeth.begin(), judged.teeth.end(), [](const Tooth& tooth) { return tooth.compliant_rejected; }));
  const std::string fitted = fmt::format(
      " Supports that yield imitate sliding. A stuck specimen on supports with one compliance of {} (both "
      "together) ",
      compliance_in_words(compliance, test));
  if (compliance.p_value >= 1 - tooth_confidence)
    return fitted +
           fmt::format("explains all teeth (p = {:.2f}){}", compliance.p_value,
                       sliding > 0
                           ? ", so the teeth alone do not prove sliding. Compare this compliance with that of the rig."
                           : ".");
  const std::string beyond = compliance.p_value < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", compliance.p_value);
  if (rejected == 0)
    return fitted + fmt::format("does not explain all teeth together ({}), though no single tooth rejects it.", beyond);
  return fitted +
         fmt::format(
             "does not explain the teeth ({}): this explanation is rejected on {} of {}, each at {:.4g} % confidence.",
             beyond, rejected, judged.teeth.size(), 100 * tooth_confidence);
}

}  // namespace

std::string teeth_in_words(const FittedTest& test) {
  if (!test.analysis.teeth)
    return "There are no teeth to judge: the record has fewer than two drops, or no load train is stated.";
  const Teeth& judged = *test.analysis.teeth;
  const ToothOptions& options = test.provenance.options.teeth;
  const auto count = [&](ToothVerdict verdict) {
    return static_cast<std::size_t>(std::count_if(judged.teeth.begin(), judged.teeth.end(),
                                                  [&](const Tooth& tooth) { return tooth.verdict == verdict; }));
  };
  std::string left_out;
  if (judged.too_short > 0)
    left_out += fmt::format(" {} too short to judge.",
                            judged.too_short == 1 ? "1 rise is" : fmt::format("{} rises are", judged.too_short));
  if (judged.unexplained > 0)
    left_out += fmt::format(" No friction explains {}.", counted(judged.unexplained, "rise", "rises"));
  if (judged.teeth.empty()) return "No rise between two drops can be judged." + left_out;
  const std::size_t sliding = count(ToothVerdict::sliding);
  const std::size_t sticking = count(ToothVerdict::as_if_stuck);
  const auto n = static_cast<double>(judged.teeth.size());
  const std::size_t open = count(ToothVerdict::undecided);
  std::string words = fmt::format(
      "Of {} between drops, {} sticking, {} cannot be distinguished from sticking, and {} undecided, each at {:.4g} % "
      "confidence. If all were stuck, up to {:.2g} would appear to slide by chance.",
      counted(judged.teeth.size(), "rise", "rises"), sliding == 1 ? "1 rejects" : fmt::format("{} reject", sliding),
      sticking, open == 1 ? "1 is" : fmt::format("{} are", open), 100 * tooth_confidence, (1 - tooth_confidence) * n);
  words += left_out;
  words += fmt::format(
      " We call a specimen stuck when less than {:.0f} % of the stage's motion is pulled in. The limit is empirical: "
      "even just after a reversal, where the specimen must stick, the authors' tests show 8 to 35 %.",
      100 * options.least_share);
  if (sticking > 0)
    words +=
        " A rise that cannot be distinguished from sticking need not be stuck: sliding is as steep where friction "
        "rises "
        "steeply.";
  return words + compliant_supports(test, sliding) + build_up_in_words(test, sliding);
}

PrintedTable tooth_table(const FittedTest& test) {
  return shown(fit_fields(), test, frame_of(test), "teeth.teeth",
               {{.heading = "Rows", .field = "first_row", .last = "last_row"},
                {"Slope", "slope"},
                {"if stuck", "stick_slope"},
                {"if sliding", "slide_slope"},
                {"Position p", "position"},
                {"common error", "position_systematic", 2},
                {"Pulled in (both supports)", "advance", 3},
                {.heading = "Verdict",
                 .field = "verdict",
                 .in_words = {{"sliding", "slides"}, {"as_if_stuck", "as if stuck"}}}});
}

}  // namespace flexslip
