#include "inference/judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "inference/cause_coefficients.h"
#include "inference/checks.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

// Neither possible nor too short to judge.
bool is_no_slip(SlipVerdict verdict) { return verdict != SlipVerdict::possible && verdict != SlipVerdict::too_short; }

std::size_t impossible_drops(const TestAnalysis& analysis) {
  return static_cast<std::size_t>(std::count_if(analysis.slips.begin(), analysis.slips.end(),
                                                [](const Slip& slip) { return is_no_slip(slip.verdict); }));
}

// Along all that is seen, by a third of its mean or more, and surely.
bool friction_falls(const FrictionFit& fit) {
  constexpr double much = 1.0 / 3;
  const double passed = fit.between_contacts(fit.S_end) - fit.between_contacts(fit.S_begin);
  const bool surely = passed > 0 ? fit.drift.high < 0 : fit.drift.low > 0;
  return surely && -fit.drift.value * passed > much * fit.mu0.value;
}

// None where most drops are impossible or the bending stiffness is off, unless they are cracks, which make both so.
double by_one_loading(const TestAnalysis& analysis, std::size_t impossible) {
  const double probability = analysis.slip_or_crack.cracks_alone;
  const bool outside = most_are_impossible(impossible, analysis.drops.drops.size()) || stiffness_is_off(analysis);
  return outside && verdict_of(probability) != CrackVerdict::cracks ? not_a_number : probability;
}

// [1] Of a reload, besides its own errors: passes of sound specimens differ by as much.
constexpr double usual_difference = 0.02;

double log_loss_of(const PassesFit& passes) { return -elementary::log(1 - passes.loss.value); }

constexpr double improbable = 0.05;  // [1] a cause that is less probable is none
constexpr double of_needed = 0.12;   // [1] of what the drops need, by which that is uncertain

Causes causes_by_reload(const TestAnalysis& analysis) {
  const PassesFit& passes = *analysis.passes;
  return causes_of({.log_loss = log_loss_of(passes),
                    .error = log_loss_error(passes),
                    .log_needed = -elementary::log(1 - passes.loss_needed),
                    .cracks_alone = analysis.slip_or_crack.cracks_alone});
}

std::vector<FrictionIfLost> friction_if_lost(const TestAnalysis& analysis) {
  const std::vector<double> losses{0.1, 0.2};
  const Estimate& told = analysis.fit.mu0;
  std::vector<FrictionIfLost> all;
  for (const double loss : losses) {
    const double friction = (analysis.fit.mu0_is_bound ? told.high : told.value) + friction_hidden_by(analysis, loss);
    if (std::isfinite(friction)) all.push_back({loss, friction});
  }
  return all;
}

}  // namespace

bool stiffness_is_off(const TestAnalysis& analysis) {
  const double stated = analysis.bending_stiffness_error;
  return stated > 0 && stiffness_errors(analysis.fit.bending_stiffness, stated) > max_stiffness_errors;
}

bool most_are_impossible(std::size_t impossible, std::size_t drops) {
  constexpr std::size_t enough = 3;
  return drops >= enough && 2 * impossible >= drops;
}

Causes causes_of(const DropsAndLoss& features) {
  namespace fitted = cause_coefficients;
  const double z = features.log_loss / features.error;
  const double c =
      (features.log_needed - features.log_loss) / elementary::length(features.error, of_needed * features.log_needed);
  const auto squashed = [](double x) { return 1 - 2 / (1 + elementary::exp(2 * x)); };  // tanh
  constexpr double surest = 0.98;                                                       // one loading is no surer
  const double alone = std::isnan(features.cracks_alone) ? 0.5 : std::clamp(features.cracks_alone, 1 - surest, surest);
  const std::array inputs{1.0,
                          squashed(z / 3),
                          squashed(z / 8),
                          squashed(c / 3),
                          squashed(c / 8),
                          squashed((z * z - c * c) / 12),
                          elementary::log(alone / (1 - alone))};
  const auto weight = [&](const std::array<double, inputs.size()>& of) {
    double sum = 0;
    for (std::size_t i = 0; i < of.size(); ++i) sum += of[i] * inputs[i];
    return elementary::exp(sum);
  };
  const double cracks = weight(fitted::cracks), both = weight(fitted::both), all = 1 + cracks + both;
  return {.slips = 1 / all, .cracks = cracks / all, .both = both / all};
}

CauseChances chances_of_causes(double log_needed, double error, double cracks_alone) {
  constexpr int points = 2001;
  constexpr double farthest = 5;  // [standard deviations]
  double weights = 0, slips = 0, cracks = 0;
  const double error_if_cracks = elementary::length(error, of_needed * log_needed);
  const auto told = [&](double log_loss, double alone) {
    return causes_of({.log_loss = log_loss, .error = error, .log_needed = log_needed, .cracks_alone = alone});
  };
  for (int i = 0; i < points; ++i) {
    const double x = farthest * (2.0 * i / (points - 1) - 1), weight = elementary::exp(-0.5 * x * x);
    const Causes if_slips = told(x * error, cracks_alone);
    const Causes if_cracks = told(log_needed + x * error_if_cracks, not_a_number);
    weights += weight;
    if (if_slips.cracks < improbable && !(if_slips.slips < improbable)) slips += weight;
    if (if_cracks.slips < improbable && !(if_cracks.cracks < improbable)) cracks += weight;
  }
  return {slips / weights, cracks / weights};
}

double log_loss_error(const PassesFit& passes) {
  return elementary::length(passes.loss.standard_error / (1 - passes.loss.value), usual_difference);
}

bool is_reloaded(const TestAnalysis& analysis) { return analysis.passes && analysis.passes->is_followed; }

bool allows_for_losses(const TestAnalysis& analysis) {
  return is_reloaded(analysis) && analysis.passes->status == PassesStatus::ok;
}

bool is_lost(const PassesFit& passes) {
  constexpr double errors = 3;
  return passes.is_reloaded && log_loss_of(passes) > errors * log_loss_error(passes);
}

bool is_gained(const PassesFit& passes) {
  constexpr double errors = 2;
  return passes.is_reloaded && log_loss_of(passes) < -errors * log_loss_error(passes);
}

bool is_settled(const PassesFit& passes) {
  constexpr double errors = 3, least = 0.0005, errors_of_loss = 2;  // [1], [L], [1]
  const Estimate& settled = passes.settled;
  return passes.is_reloaded && settled.value > errors * elementary::length(settled.standard_error, least) &&
         log_loss_of(passes) < errors_of_loss * log_loss_error(passes);
}

Judgement judge(const TestAnalysis& analysis) {
  if (analysis.status != AnalysisStatus::ok) throw std::invalid_argument("a test without an answer is not judged");
  Judgement judgement{.drops = CrackVerdict::cannot_be_told,
                      .causes = {},
                      .impossible = impossible_drops(analysis),
                      .friction_falls = friction_falls(analysis.fit)};
  const bool has_drops = !analysis.drops.drops.empty();
  if (is_reloaded(analysis)) {
    const PassesFit& passes = *analysis.passes;
    if (has_drops && passes.loss_needed > 0) judgement.causes = causes_by_reload(analysis);
    const bool lost = std::isfinite(judgement.causes.slips) ? judgement.causes.slips < improbable : is_lost(passes);
    judgement.damage = is_settled(passes) ? Damage::settled : lost ? Damage::lost : Damage::not_told;
  } else {
    judgement.causes.cracks = by_one_loading(analysis, judgement.impossible);
  }
  judgement.drops = verdict_of(judgement.causes.cracks);
  judgement.drops_are_cracks = has_drops && !is_reloaded(analysis) && judgement.drops == CrackVerdict::cracks;
  judgement.friction_undetermined =
      judgement.drops_are_cracks || (judgement.damage == Damage::lost && !allows_for_losses(analysis));
  if (!judgement.friction_undetermined && !allows_for_losses(analysis)) judgement.if_lost = friction_if_lost(analysis);
  return judgement;
}

}  // namespace flexslip
