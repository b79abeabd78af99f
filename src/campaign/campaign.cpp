#include "campaign/campaign.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bending_test/portrait.h"

namespace flexslip {
namespace {

CampaignCurves curves_of(const TestAnalysis& analysis) {
  const Scales& scales = analysis.scales;
  CampaignCurves curves{.span = scales.span(),
                        .bending_stiffness = scales.bending_stiffness(),
                        .load_train_stiffness = scales.physical_stiffness(analysis.rig.stiffness),
                        .supports = analysis.rig.fibre.supports(),
                        .stage = analysis.record.stage,
                        .deflection = analysis.record.deflection,
                        .force = analysis.record.force,
                        .model_deflection = {},
                        .model_force = {},
                        .drops = {}};
  for (const auto& point : analysis.model.path) {
    curves.model_deflection.push_back(scales.physical_length(point.w));
    curves.model_force.push_back(scales.physical_force(point.F));
  }
  for (const auto& drop : analysis.drops.drops) curves.drops.push_back(drop.before);
  return curves;
}

std::string failed_checks_in_words(const TestAnalysis& analysis) {
  std::string words;
  for (const auto& check : analysis.checks) {
    if (check.outcome != CheckOutcome::failed || check.kind == CheckKind::friction ||
        check.kind == CheckKind::stiffness)
      continue;
    if (!words.empty()) words += "; ";
    switch (check.kind) {
      case CheckKind::residuals:
        words += "the mean of the fit misses the force";
        break;
      case CheckKind::drops:
        words += fmt::format("{:.0f} drops, where profiles drawn from the fit show {:.0f} to {:.0f}",
                             number_of(check, "record"), number_of(check, "draws_low"), number_of(check, "draws_high"));
        break;
      case CheckKind::whiteness:
        words += "what the readings add to those before them is not noise";
        break;
      case CheckKind::nesting:
        words += "the likeliest explanation fits worse than one that it contains";
        break;
      case CheckKind::friction:
      case CheckKind::stiffness:
        break;
      case CheckKind::stability:
        words += "the answer moves when the force changes in its ninth digit";
        break;
    }
  }
  return words;
}

std::string remark_on(Doubt doubt, const FittedTest& test) {
  const auto& analysis = test.analysis;
  switch (doubt) {
    case Doubt::wrong_stiffness:
      return fmt::format("bending stiffness {:.2f} times that of the initial slope", analysis.stiffness_over_slope);
    case Doubt::no_sliding:
      return "no sliding explains the record";
    case Doubt::softer_reload:
      return fmt::format("a reload is {:.0f} % softer", 100 * test.judgement->loss);
    case Doubt::cracks:
      return "the drops are those of cracks";
    case Doubt::impossible_drops:
      return "drops that no slip explains";
    case Doubt::implausible_friction:
      return fmt::format("friction above {:g} in {} of {} points", analysis.suspects.limit,
                         analysis.suspects.points.size(), analysis.suspects.points_judged);
    case Doubt::failed_check:
      return failed_checks_in_words(analysis);
    case Doubt::falling_friction:
      return "friction falls away along the record";
    case Doubt::changed_reload:
      return fmt::format("a reload is {:.0f} % {}", 100 * std::abs(test.judgement->loss),
                         test.judgement->loss > 0 ? "softer" : "stiffer");
    case Doubt::coarse_force:
      return "the force is too coarse to show small drops";
    case Doubt::undecided_drops:
      return "slips or cracks: cannot be told";
    case Doubt::few_rows:
      return "fewer than five rows on most rises";
    case Doubt::below_frictionless:
      return "the force lies below that without friction";
    case Doubt::settling_contact:
      return "the contact settles";
    case Doubt::unexpected_stiffness:
      break;
  }
  return fmt::format("bending stiffness {} from that {}", signed_percent(analysis.fit.bending_stiffness.value - 1),
                     analysis.stiffness_from_slope ? "of the initial slope" : "given");
}

std::vector<std::string> remarks_of(const FittedTest& test) {
  std::vector<std::string> remarks;
  const auto& analysis = test.analysis;
  for (const Doubt doubt : test.judgement->doubts) remarks.push_back(remark_on(doubt, test));
  if (analysis.fit.mu0_is_bound && is_trusted(test.judgement->standing))
    remarks.emplace_back("the record does not tell friction from zero");
  if (test.measurement.end == MeasurementEnd::failure)
    remarks.push_back(fmt::format("fails after row {}", last_row(test)));
  return remarks;
}

}  // namespace

ForceCurve frictionless_curve(const CampaignCurves& curves, double bending_stiffness) {
  ForceCurve curve;
  if (curves.deflection.empty()) return curve;
  const double deepest = *std::max_element(curves.deflection.begin(), curves.deflection.end());
  if (!(deepest > 0)) return curve;
  constexpr int points = 60;
  const Scales scales(curves.span, bending_stiffness);
  for (const auto& point : frictionless_up_to(scales.reduced_length(deepest), points, Fibre(curves.supports))) {
    curve.deflection.push_back(scales.physical_length(point.w));
    curve.force.push_back(scales.physical_force(point.F));
  }
  return curve;
}

CampaignTest campaign_test_of(const FittedTest& test, const std::string& file) {
  CampaignTest kept{.name = test.name,
                    .status = std::string(status_of(test)),
                    .reason = reason_of(test.analysis.status),
                    .file = file,
                    .summary = {},
                    .curves = {},
                    .remarks = {},
                    .section_moment = test.section_moment,
                    .materials = test.materials};
  if (test.analysis.status != AnalysisStatus::ok) return kept;
  kept.summary = summary_of(test.name, test.analysis, test.judgement.value());
  kept.curves = curves_of(test.analysis);
  kept.remarks = remarks_of(test);
  return kept;
}

CampaignTest failed_test(const std::string& name, const std::string& file, const std::string& reason) {
  return {.name = name,
          .status = "failed",
          .reason = reason,
          .file = file,
          .summary = {},
          .curves = {},
          .remarks = {},
          .section_moment = {},
          .materials = {}};
}

}  // namespace flexslip
