#include "inference/judgement.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

// True if friction certainly decreases along the observed length, by a third of its mean or more.
bool friction_falls(const FrictionFit& fit) {
  constexpr double much = 1.0 / 3;
  const double passed = fit.between_contacts(fit.S_end) - fit.between_contacts(fit.S_begin);
  const bool surely = passed > 0 ? fit.drift.high < 0 : fit.drift.low > 0;
  return surely && -fit.drift.value * passed > much * fit.mu0.value;
}

// [1] Additional error of a reload: passes of sound specimens differ by this much.
constexpr double usual_difference = 0.02;

bool are_fitted(const std::optional<PassesFit>& passes) { return passes && passes->status == PassesStatus::ok; }

double log_loss_of(const PassesFit& passes) { return -elementary::log(1 - passes.loss.value); }

Causes causes_of(const TestAnalysis& analysis) {
  const DropFeatures& features = analysis.drop_features;
  const Causes by_one_loading = features.drops > 0 ? flexslip::causes_of(features, analysis.rig.stiffness) : Causes{};
  if (!is_reloaded(analysis) || !(analysis.passes->loss_needed > 0)) return by_one_loading;
  return flexslip::causes_of(by_one_loading, {.log_loss = log_loss_of(*analysis.passes),
                                              .error = log_loss_error(*analysis.passes),
                                              .log_needed = -elementary::log(1 - analysis.passes->loss_needed),
                                              .drops_again = analysis.passes->drops_again > 0});
}

Conclusion conclusion_by_reload(const TestAnalysis& analysis, const Causes& causes) {
  const PassesFit& passes = *analysis.passes;
  if (is_settled(passes)) return Conclusion::settled;
  const bool has_drops = !analysis.drops.drops.empty();
  if (!has_drops || std::isnan(causes.slips))
    return is_lost(passes) ? Conclusion::cracks : has_drops ? Conclusion::undecided : Conclusion::no_drops;
  if (loses_at_all(causes, true) || is_lost(passes))
    return slips_at_all(causes) ? Conclusion::slips_and_damage : Conclusion::cracks;
  return slips_at_all(causes) ? Conclusion::slips : Conclusion::undecided;
}

Conclusion conclusion_by_one_loading(const TestAnalysis& analysis, const Causes& causes) {
  constexpr double crests =
      0.9;  // [1] below this friction required by cracks only, slips and cracks cannot be distinguished
  const DropFeatures& features = analysis.drop_features;
  if (loses_at_all(causes, false) || is_loss_without_friction(features)) return Conclusion::cracks;
  const bool has_slipped = slips_at_all(causes) && features.needed_at_end > crests;
  if (lost_before(analysis)) return has_slipped ? Conclusion::slips_and_damage : Conclusion::cracks;
  if (analysis.drops.drops.empty()) return sinks(analysis) ? Conclusion::undecided : Conclusion::no_drops;
  return has_slipped ? Conclusion::slips : Conclusion::undecided;
}

std::vector<FrictionIfLost> friction_if_lost(const TestAnalysis& analysis) {
  const std::vector<double> losses{0.1, 0.2};
  const Estimate& told = analysis.fit.mu0;
  std::vector<FrictionIfLost> all;
  for (const double loss : losses) {
    const double friction =
        (analysis.fit.mu0_is_bound ? told.high : told.value) + friction_underestimate(analysis, loss);
    if (std::isfinite(friction)) all.push_back({loss, friction});
  }
  return all;
}

}  // namespace

double log_loss_error(const PassesFit& passes) {
  return elementary::length(passes.loss.standard_error / (1 - passes.loss.value), usual_difference);
}

bool lost_before(const TestAnalysis& analysis) {
  return analysis.passes && !is_reloaded(analysis) && is_lost(*analysis.passes);
}

bool sinks(const TestAnalysis& analysis) {
  constexpr double worth_saying = 0.1;
  return analysis.status == AnalysisStatus::deflection_too_small && analysis.statistics.sinking.share > worth_saying;
}

bool is_reloaded(const TestAnalysis& analysis) { return analysis.passes && analysis.passes->is_followed; }

bool allows_for_losses(const TestAnalysis& analysis) { return is_reloaded(analysis) && are_fitted(analysis.passes); }

bool is_lost(const PassesFit& passes) {
  return passes.is_reloaded && is_loss(log_loss_of(passes), log_loss_error(passes));
}

bool is_gained(const PassesFit& passes) {
  constexpr double errors = 2;
  return passes.is_reloaded && log_loss_of(passes) < -errors * log_loss_error(passes);
}

bool is_settled(const PassesFit& passes) {
  constexpr double errors = 3, noticeable = 0.0005, errors_of_loss = 2;  // [1], [L], [1]
  const Estimate& settled = passes.settled;
  return passes.is_reloaded && settled.value > errors * elementary::length(settled.standard_error, noticeable) &&
         log_loss_of(passes) < errors_of_loss * log_loss_error(passes);
}

Judgement judge(const TestAnalysis& analysis) {
  Judgement judgement{.causes = causes_of(analysis)};
  judgement.conclusion = is_reloaded(analysis) ? conclusion_by_reload(analysis, judgement.causes)
                                               : conclusion_by_one_loading(analysis, judgement.causes);
  if (analysis.status != AnalysisStatus::ok) return judgement;
  const bool has_lost =
      judgement.conclusion == Conclusion::cracks || judgement.conclusion == Conclusion::slips_and_damage;
  judgement.determines_friction = !has_lost || are_fitted(analysis.passes);
  judgement.friction_falls = friction_falls(analysis.fit);
  if (judgement.determines_friction && !allows_for_losses(analysis)) judgement.if_lost = friction_if_lost(analysis);
  return judgement;
}

}  // namespace flexslip
