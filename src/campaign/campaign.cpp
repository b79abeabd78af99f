#include "campaign/campaign.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "bending_test/history.h"
#include "data/names.h"
#include "finding/answer.h"
#include "inference/population.h"
#include "numerics/elementary.h"

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

// A few words for each finding against a test that its verdict does not tell, the weightiest first; and why there is no answer, where it is none.
std::vector<std::string> remarks_of(const Answer& answer) {
  std::vector<std::string> remarks;
  for (const Finding& finding : answer.findings)
    if (finding.severity == Severity::refusal && finding.code == answer.verdict.finding)
      remarks.push_back(finding.short_form);
  for (const Finding& doubt : doubts_of(answer)) remarks.push_back(doubt.short_form);
  return remarks;
}

std::optional<StandardSummary> standard_of(const FittedTest& test) {
  const auto modulus = standard_modulus(test.small_deflection);
  if (!modulus) return std::nullopt;
  return StandardSummary{.modulus = *modulus,
                         .strength = *test.small_deflection.greatest.stress,
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
                    .summary = {},
                    .curves = {},
                    .remarks = remarks_of(answer),
                    .section_moment = test.section_moment,
                    .materials = test.materials,
                    .standard = standard_of(test)};
  if (!is_fitted(test)) {
    kept.reason = is_answered(answer.verdict.code)
                      ? sentence_of(answer.verdict)
                      : fmt::format("{} {}", answer.findings.front().sentence, answer.next);
    return kept;
  }
  kept.summary = summary_of(test.name, test.analysis, test.judgement.value(), answer.standing);
  kept.curves = curves_of(test.analysis);
  return kept;
}

CampaignTest failed_test(const std::string& name, const std::string& file, const std::string& reason) {
  return {.name = name,
          .status = "failed",
          .reason = reason,
          .file = file,
          .verdict = std::string(word_of(VerdictCode::no_answer)),
          .summary = {},
          .curves = {},
          .remarks = {},
          .section_moment = {},
          .materials = {},
          .standard = {}};
}

namespace {

constexpr std::array shareables{Shareable::modulus,   Shareable::bending_stiffness,  Shareable::wavelength,
                                Shareable::roughness, Shareable::correlation_length, Shareable::mu0};

std::string unit_of(Shareable parameter) {
  switch (parameter) {
    case Shareable::modulus:
      return "Pa";
    case Shareable::bending_stiffness:
      return "N m^2";
    case Shareable::wavelength:
    case Shareable::correlation_length:
      return "m";
    case Shareable::roughness:
    case Shareable::mu0:
      break;
  }
  return "1";
}

// What a test says of a parameter [SI], or of its logarithm.
std::optional<Marginal> marginal_of(const CampaignTest& test, Shareable parameter) {
  if (!test.summary || test.summary->suspect) return std::nullopt;
  const TestMarginals& known = test.summary->known;
  switch (parameter) {
    case Shareable::modulus:
      if (!test.section_moment) return std::nullopt;
      return shifted(known.log_stiffness, -elementary::log(*test.section_moment));
    case Shareable::bending_stiffness:
      return known.log_stiffness;
    case Shareable::wavelength:
      return known.log_wavelength;
    case Shareable::roughness:
      return known.log_roughness;
    case Shareable::correlation_length:
      return known.log_length;
    case Shareable::mu0:
      break;
  }
  return known.mu0;
}

SharedParameter shared_by(std::span<const CampaignTest> tests, Shareable parameter) {
  std::vector<Marginal> marginals;
  for (const auto& test : tests)
    if (const auto marginal = marginal_of(test, parameter); marginal && tells(*marginal))
      marginals.push_back(*marginal);
  if (marginals.size() < 2) {
    constexpr double untold = not_a_number;
    return {name_of(parameter), unit_of(parameter), {untold, untold, untold, untold}, marginals.size(), untold, untold};
  }
  const SharedValue shared = share(marginals, prior_told_to(marginals));
  return {name_of(parameter),
          unit_of(parameter),
          parameter == Shareable::mu0 ? shared.estimate : exponential(shared.estimate),
          shared.telling,
          shared.chi_squared,
          shared.agreement};
}

}  // namespace

std::vector<std::string> shareable_names() {
  std::vector<std::string> names;
  names.reserve(shareables.size());
  for (const auto parameter : shareables) names.push_back(name_of(parameter));
  return names;
}

std::vector<Shareable> shareables_named(const std::vector<std::string>& names) {
  std::vector<Shareable> found;
  for (const auto& name : names)
    for (const auto parameter : shareables)
      if (name_of(parameter) == name) found.push_back(parameter);
  return found;
}

std::string_view needed_for(Shareable parameter) {
  if (parameter == Shareable::modulus) return "state the section of each";
  if (parameter == Shareable::wavelength) return "only waves that the evidence claims can be shared";
  return "the others say less than was known beforehand";
}

std::string name_of(Shareable parameter) {
  return std::string(name_in_order<Shareable::mu0>(
      parameter, {"modulus", "bending_stiffness", "wavelength", "roughness", "correlation_length", "mu0"}));
}

std::vector<SharedParameter> share_parameters(std::span<const CampaignTest> tests,
                                              const std::vector<Shareable>& parameters) {
  std::vector<SharedParameter> shared;
  for (const Shareable parameter : parameters) {
    if (std::count(parameters.begin(), parameters.end(), parameter) > 1)
      throw std::invalid_argument("--share " + name_of(parameter) + ": once is enough");
    shared.push_back(shared_by(tests, parameter));
  }
  return shared;
}

}  // namespace flexslip
