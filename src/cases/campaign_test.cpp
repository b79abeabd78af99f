#include "cases/campaign_test.h"

#include <cmath>

#include <fmt/format.h>

namespace flexslip {
namespace {

CampaignCurves curves_of(const TestAnalysis& analysis) {
  const Scales& scales = analysis.scales;
  CampaignCurves curves{.span = scales.span(),
                        .bending_stiffness = scales.bending_stiffness(),
                        .load_train_stiffness = scales.physical_stiffness(analysis.rig.stiffness),
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

std::string reason_of(const std::string& status) {
  if (status == "too_few_points") return "fewer than 20 rows with a deflection beyond a twentieth of the span";
  if (status == "not_explained") return "no sliding with a friction of 0 to 2 gives this record";
  if (status == "no_initial_slope")
    return "the force does not rise where the record begins: state the bending stiffness";
  return "";
}

std::vector<std::string> remarks_of(const FittedTest& test) {
  std::vector<std::string> remarks;
  const auto& analysis = test.analysis;
  if (analysis.suspects.suspect)
    remarks.push_back(fmt::format("friction above {:g} in {} of {} points", analysis.suspects.limit,
                                  analysis.suspects.points.size(), analysis.suspects.points_judged));
  if (analysis.model_implausible) remarks.emplace_back("no sliding explains the record");
  if (analysis.stiffness_implausible)
    remarks.push_back(
        fmt::format("bending stiffness {:.2f} times that of the initial slope", analysis.stiffness_over_slope));
  if (analysis.fit.mu0_is_bound) remarks.emplace_back("the record does not tell friction from none");
  for (const auto& check : analysis.checks) {
    if (check.outcome != CheckOutcome::failed) continue;
    if (check.kind == CheckKind::drops)
      remarks.push_back(fmt::format("{:.0f} drops, where profiles drawn from the fit show {:.0f} to {:.0f}",
                                    number_of(check, "record"), number_of(check, "draws_low"),
                                    number_of(check, "draws_high")));
    if (check.kind == CheckKind::whiteness)
      remarks.emplace_back("what the readings add to those before them is not noise");
    if (check.kind == CheckKind::nesting)
      remarks.emplace_back("the likeliest explanation fits worse than one that it contains");
    if (check.kind == CheckKind::stability)
      remarks.emplace_back("the answer moves when the force changes in its ninth digit");
  }
  const auto& stiffness = analysis.fit.bending_stiffness;
  constexpr double surprising = 1.96;  // standard deviations of what was known beforehand
  if (std::abs(stiffness.value - 1) > surprising * analysis.bending_stiffness_error)
    remarks.push_back(fmt::format("bending stiffness {:+.1f} % from that {}", 100 * (stiffness.value - 1),
                                  analysis.stiffness_from_slope ? "of the initial slope" : "given"));
  if (test.measurement.end == MeasurementEnd::failure)
    remarks.push_back(fmt::format("fails after row {}", last_row(test)));
  return remarks;
}

}  // namespace

CampaignTest campaign_test_of(const FittedTest& test, const std::string& file) {
  const std::string status = status_of(test);
  CampaignTest kept{.name = test.name,
                    .status = status,
                    .reason = reason_of(status),
                    .file = file,
                    .summary = {},
                    .curves = {},
                    .remarks = {},
                    .section_moment = test.section_moment};
  if (test.analysis.status != AnalysisStatus::ok) return kept;
  kept.summary = summary_of(test.name, test.analysis);
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
          .section_moment = {}};
}

}  // namespace flexslip
