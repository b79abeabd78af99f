#include "campaign/campaign.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "bending_test/history.h"
#include "finding/answer.h"
#include "finding/clauses.h"

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

// A short phrase for each objection to a test that its one-word verdict does not express, most
// serious first; and the reason for NO ANSWER.
std::vector<std::string> remarks_of(const Answer& answer) {
  std::vector<std::string> remarks;
  for (const Finding& finding : answer.findings)
    if ((finding.severity == Severity::refusal || finding.severity == Severity::doubt) &&
        finding.code == answer.verdict.finding)
      remarks.push_back(finding.short_form);
  for (const Finding& doubt : doubts_of(answer)) remarks.push_back(doubt.short_form);
  return remarks;
}

std::optional<StandardSummary> standard_of(const FittedTest& test) {
  const auto modulus = standard_modulus(test.small_deflection);
  if (!modulus) return std::nullopt;
  return StandardSummary{.modulus = *modulus,
                         .strength = test.measurement.end == MeasurementEnd::failure
                                         ? *test.small_deflection.greatest.stress
                                         : not_a_number,
                         .friction = supports_gain(test.measurement, test.small_deflection).friction};
}

}  // namespace

std::vector<EquilibriumPoint> frictionless_curve(const CampaignCurves& curves, double bending_stiffness) {
  const double deepest =
      curves.deflection.empty() ? 0 : *std::max_element(curves.deflection.begin(), curves.deflection.end());
  if (!(deepest > 0)) return {};
  constexpr int points = 60;
  const Scales scales(curves.span, bending_stiffness);
  auto curve = frictionless_up_to(scales.reduced_length(deepest), points, Fibre(curves.supports));
  for (EquilibriumPoint& point : curve) {
    point.w = scales.physical_length(point.w);
    point.F = scales.physical_force(point.F);
  }
  return curve;
}

bool determines_friction(const CampaignTest& test) { return test.summary && std::isfinite(test.summary->mu0.value); }

bool is_excluded(const CampaignTest& test) { return determines_friction(test) && test.summary->suspect; }

bool is_answered(const CampaignTest& test) {
  return test.verdict != word_of(VerdictCode::check_input) && test.verdict != word_of(VerdictCode::no_answer);
}

CampaignTest campaign_test_of(const FittedTest& test, const std::string& file) {
  const Answer answer = answer_of(test);
  CampaignTest kept{.name = test.name,
                    .status = std::string(status_of(test)),
                    .reason = {},
                    .file = file,
                    .verdict = std::string(word_of(answer.verdict.code)),
                    .causes = test.judgement.causes,
                    .summary = {},
                    .curves = {},
                    .remarks = remarks_of(answer),
                    .materials = test.materials,
                    .standard = standard_of(test)};
  if (!is_fitted(test)) {
    kept.reason = is_answered(answer.verdict.code)
                      ? sentence_of(answer.verdict)
                      : fmt::format("{} {}", answer.findings.front().sentence, answer.next);
    return kept;
  }
  TestSummary summary = summary_of(test.name, test.analysis);
  summary.suspect = is_suspect(answer.findings);
  summary.on_assumed_edges = friction_on_rollers(test).has_value();
  const bool tells_friction = !is_refused(answer.findings) && test.judgement.determines_friction;
  kept.summary = tells_friction ? std::move(summary) : without_friction(std::move(summary));
  kept.curves = curves_of(test.analysis);
  return kept;
}

CampaignTest failed_test(const std::string& name, const std::string& file, const std::string& reason) {
  return {.name = name,
          .status = "failed",
          .reason = reason,
          .file = file,
          .verdict = std::string(word_of(VerdictCode::no_answer)),
          .causes = {},
          .summary = {},
          .curves = {},
          .remarks = {},
          .materials = {},
          .standard = {}};
}

}  // namespace flexslip
