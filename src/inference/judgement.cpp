#include "inference/judgement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bending_test/equilibrium.h"
#include "data/loading_stiffness.h"
#include "inference/checks.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

// Neither possible nor too short to judge.
bool is_no_slip(SlipVerdict verdict) { return verdict != SlipVerdict::possible && verdict != SlipVerdict::too_short; }

constexpr double one_sided_95 = 1.645;

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

// Has the force at a drop left the window in which loadings are compared? A crack before that is in the reference, too.
bool is_compared(const TestAnalysis& analysis, const Drop& drop) {
  const auto& force = analysis.record.force;
  return force[drop.before] > loading_window_up_to * *std::max_element(force.begin(), force.end());
}

// [1] Of the bending stiffness, that would be left if every drop were a crack at the mean friction of the fit; at most, for the noise of the force.
double left_by_drops(const TestAnalysis& analysis) {
  const ReducedRecord& record = analysis.reduced;
  constexpr int enough = 200;  // of the force, to 1e-4
  const double deepest = *std::max_element(record.deflection.begin(), record.deflection.end());
  const auto uncracked = sliding_up_to(deepest, std::max(analysis.fit.mu0.value, 0.0), enough, analysis.rig.fibre);
  double log_left = 0, variance = 0;
  for (const Drop& drop : analysis.drops.drops) {
    if (!is_compared(analysis, drop)) continue;
    const auto apparent = [&](std::size_t row) {
      return record.force[row] / force_at(uncracked, record.deflection[row]);
    };
    const double ratio = apparent(drop.after) / apparent(drop.before);
    if (!(ratio < 1)) continue;
    constexpr double nothing = 1e-6;  // of a specimen that broke
    log_left += elementary::log(std::max(ratio, nothing));
    variance += 2 * std::pow(analysis.force_noise / record.force[drop.before], 2);
  }
  return std::min(elementary::exp(log_left + one_sided_95 * std::sqrt(variance)), 1.0);
}

// What all cracks together would leave that the reload can have seen: by the rises between the drops or, where these are too few or some drop
// comes before the loadings are compared, by the drops themselves.
double left_by_cracks(const TestAnalysis& analysis) {
  const SlipOrCrack& rises = analysis.slip_or_crack;
  const auto& drops = analysis.drops.drops;
  const bool all_compared =
      std::all_of(drops.begin(), drops.end(), [&](const Drop& drop) { return is_compared(analysis, drop); });
  return rises.judged && all_compared
             ? std::max({rises.cracks.left, rises.cracks_constant.left, rises.cracks_running.left})
             : left_by_drops(analysis);
}

// None where most drops are impossible or the bending stiffness is off, unless they are cracks, which make both so.
double cracks_alone(const TestAnalysis& analysis, const ReloadChange& reload, const Judgement& judgement) {
  double probability = analysis.slip_or_crack.cracks_alone;
  if (reload.comes_after)
    probability = with_reload(probability, {judgement.loss_needed, reload.loss, reload.loss_error});
  const bool outside =
      most_are_impossible(judgement.impossible, analysis.drops.drops.size()) || stiffness_is_off(analysis);
  return outside && verdict_of(probability) != CrackVerdict::cracks ? not_a_number : probability;
}

// [1] Of stiffness, at 95 %.
double most_lost(const ReloadChange& reload) { return reload.loss + one_sided_95 * reload.loss_error; }

CrackVerdict verdict_on(const Judgement& judgement, const ReloadChange& reload) {
  if (lost_stiffness(reload)) return CrackVerdict::cracks;
  if (std::isfinite(judgement.cracks_alone)) return verdict_of(judgement.cracks_alone);
  return judgement.impossible == 0 && judgement.loss_needed > most_lost(reload) ? CrackVerdict::not_by_cracks_alone
                                                                                : CrackVerdict::cannot_be_told;
}

std::vector<FrictionIfLost> friction_if_lost(const TestAnalysis& analysis, const ReloadChange& reload) {
  std::vector<double> losses{0.1, 0.2};
  if (reload.comes_after) losses = {std::clamp(most_lost(reload), 0.0, losses.back())};
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

Judgement judge(const TestAnalysis& analysis, const ReloadChange& reload) {
  if (analysis.status != AnalysisStatus::ok) throw std::invalid_argument("a test without an answer is not judged");
  Judgement judgement{.drops = CrackVerdict::cannot_be_told,
                      .impossible = impossible_drops(analysis),
                      .friction_falls = friction_falls(analysis.fit)};
  if (reload.comes_after) judgement.loss_needed = 1 - left_by_cracks(analysis);
  judgement.cracks_alone = cracks_alone(analysis, reload, judgement);
  judgement.drops = verdict_on(judgement, reload);
  judgement.drops_are_cracks =
      !analysis.drops.drops.empty() && !lost_stiffness(reload) && judgement.drops == CrackVerdict::cracks;
  judgement.lost_stiffness = lost_stiffness(reload) || judgement.drops_are_cracks;
  if (!judgement.lost_stiffness) judgement.if_lost = friction_if_lost(analysis, reload);
  return judgement;
}

}  // namespace flexslip
