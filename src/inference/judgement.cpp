#include "inference/judgement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bending_test/critical_stiffness.h"
#include "bending_test/equilibrium.h"
#include "data/loading_stiffness.h"
#include "data/names.h"
#include "data/order.h"
#include "fibre/elementary.h"

namespace flexslip {
namespace {

constexpr double two_sided = 1.96, one_sided = 1.645;  // of 95 %

const LoadingStiffness* last_reload(const CyclicAnswer* cycles) {
  if (!cycles) return nullptr;
  for (std::size_t i = cycles->stiffness.size(); i-- > 1;)
    if (cycles->stiffness[i].status == LoadingStatus::ok) return &cycles->stiffness[i];
  return nullptr;
}

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

// Part of the fibre seen that it jumped over.
double jumped_part(const TestAnalysis& analysis) {
  double jumped = 0;
  for (const Slip& slip : analysis.slips)
    if (slip.verdict == SlipVerdict::possible && std::isfinite(slip.S_after)) jumped += slip.S_after - slip.S_before;
  return jumped / (analysis.fit.S_end - analysis.fit.S_begin);
}

bool has_few_rows(const TestAnalysis& analysis) {
  const auto& drops = analysis.drops.drops;
  constexpr std::size_t least_drops = 3;
  constexpr double least_rows = 5;  // at four, waves are missed
  if (drops.size() < least_drops) return false;
  std::vector<double> rows;
  for (std::size_t i = 1; i < drops.size(); ++i)
    rows.push_back(static_cast<double>(drops[i].before - drops[i - 1].after + 1));
  return median_of(rows) < least_rows;
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
  return std::min(elementary::exp(log_left + one_sided * std::sqrt(variance)), 1.0);
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

CrackVerdict verdict_on(const TestAnalysis& analysis, const LoadingStiffness* reload, double loss_needed) {
  const CrackVerdict by_rises = analysis.slip_or_crack.verdict;
  if (!reload) return by_rises;
  if (reload->verdict == DamageVerdict::damaged) return CrackVerdict::cracks;
  const double at_most =
      1 - reload->ratio.value + one_sided * elementary::length(reload->ratio.standard_error, reload->ratio_systematic);
  const bool slips = analysis.slip_or_crack.judged || impossible_drops(analysis) == 0;
  return slips && loss_needed > at_most ? CrackVerdict::not_by_cracks_alone : by_rises;
}

Standing standing_of(const std::vector<Doubt>& doubts, bool half_impossible) {
  if (doubts.empty()) return Standing::sound;
  if (doubts.front() <= Doubt::no_sliding) return Standing::untrusted;
  const bool suspect = std::any_of(doubts.begin(), doubts.end(), [&](Doubt doubt) {
    return doubt == Doubt::softer_reload || doubt == Doubt::cracks || doubt == Doubt::implausible_friction ||
           (doubt == Doubt::impossible_drops && half_impossible);
  });
  return suspect ? Standing::suspect : Standing::doubtful;
}

// What would settle the weightiest of the doubts that anything would.
NextStep step_for(const Judgement& judgement, bool on_edges) {
  for (const Doubt doubt : judgement.doubts) switch (doubt) {
      case Doubt::implausible_friction:
      case Doubt::falling_friction:
        return on_edges ? NextStep::state_radius : NextStep::image_length;
      case Doubt::impossible_drops:
        return NextStep::image_length;
      case Doubt::failed_check:
        return NextStep::see_checks;
      case Doubt::coarse_force:
        return NextStep::finer_force;
      case Doubt::settling_contact:
        return NextStep::find_contact;
      case Doubt::below_frictionless:
        return NextStep::measure_stiffness;
      default:
        break;
    }
  return judgement.standing == Standing::suspect ? NextStep::image_length : NextStep::none;
}

}  // namespace

std::string_view name_of(Doubt doubt) {
  return name_in_order<Doubt::unexpected_stiffness>(
      doubt, {"wrong_stiffness", "no_sliding", "softer_reload", "cracks", "impossible_drops", "implausible_friction",
              "failed_check", "falling_friction", "changed_reload", "coarse_force", "undecided_drops", "few_rows",
              "below_frictionless", "settling_contact", "unexpected_stiffness"});
}

std::string_view name_of(Standing standing) {
  return name_in_order<Standing::untrusted>(standing, {"sound", "doubtful", "suspect", "untrusted"});
}

std::string_view name_of(NextStep step) {
  return name_in_order<NextStep::see_checks>(
      step, {"none", "check_case", "reload", "finer_steps", "stiffer_rig", "image_length", "state_radius",
             "find_contact", "finer_force", "measure_stiffness", "see_checks"});
}

bool lost_stiffness(const Judgement& judgement) {
  return std::any_of(judgement.doubts.begin(), judgement.doubts.end(), [&](Doubt doubt) {
    return doubt == Doubt::softer_reload || doubt == Doubt::cracks ||
           (doubt == Doubt::changed_reload && judgement.loss > 0);
  });
}

Judgement judge(const TestAnalysis& analysis, const CyclicAnswer* cycles) {
  if (analysis.status != AnalysisStatus::ok) throw std::invalid_argument("a test without an answer is not judged");
  const LoadingStiffness* const reload = last_reload(cycles);
  const std::size_t drops = analysis.drops.drops.size(), impossible = impossible_drops(analysis);
  const FrictionFit& fit = analysis.fit;
  Judgement judgement{};
  if (reload) {
    judgement.loss_needed = 1 - left_by_cracks(analysis);
    judgement.loss = 1 - reload->ratio.value;
    judgement.loss_error = elementary::length(reload->ratio.standard_error, reload->ratio_systematic);
  }
  judgement.drops = verdict_on(analysis, reload, judgement.loss_needed);
  const auto doubt_if = [&](bool doubtful, Doubt doubt) {
    if (doubtful) judgement.doubts.push_back(doubt);
  };
  const bool softer = reload && reload->verdict == DamageVerdict::damaged;
  doubt_if(analysis.stiffness_implausible, Doubt::wrong_stiffness);
  doubt_if(analysis.model_implausible, Doubt::no_sliding);
  doubt_if(softer, Doubt::softer_reload);
  doubt_if(drops > 0 && !softer && judgement.drops == CrackVerdict::cracks, Doubt::cracks);
  doubt_if(impossible > 0, Doubt::impossible_drops);
  doubt_if(analysis.suspects.suspect || fit.mu0.low > std::min(analysis.suspects.limit, analysis.most_friction),
           Doubt::implausible_friction);
  doubt_if(std::any_of(analysis.checks.begin(), analysis.checks.end(),
                       [](const Check& check) {
                         return check.outcome == CheckOutcome::failed && check.kind != CheckKind::friction &&
                                check.kind != CheckKind::stiffness;
                       }),
           Doubt::failed_check);
  doubt_if(friction_falls(fit), Doubt::falling_friction);
  constexpr double relevant = 0.05;
  doubt_if(reload && !softer && std::abs(judgement.loss) > std::max(relevant, two_sided * judgement.loss_error),
           Doubt::changed_reload);
  doubt_if(analysis.drops.smallest_fall >
               relevant * *std::max_element(analysis.record.force.begin(), analysis.record.force.end()),
           Doubt::coarse_force);
  doubt_if(drops > 0 && judgement.drops == CrackVerdict::cannot_be_told, Doubt::undecided_drops);
  doubt_if(has_few_rows(analysis), Doubt::few_rows);
  doubt_if(analysis.friction_read.median < least_friction, Doubt::below_frictionless);
  doubt_if(analysis.contact.status == ContactStatus::found && analysis.contact.settles &&
               analysis.contact.offset.value > two_sided * analysis.contact.offset.standard_error,
           Doubt::settling_contact);
  doubt_if(std::any_of(analysis.checks.begin(), analysis.checks.end(),
                       [](const Check& check) {
                         return check.outcome == CheckOutcome::failed && check.kind == CheckKind::stiffness;
                       }),
           Doubt::unexpected_stiffness);
  judgement.standing = standing_of(judgement.doubts, 2 * impossible >= drops);

  const bool on_edges = analysis.rig.fibre.supports().radius == 0;
  const bool in_question = drops > 0 && judgement.drops != CrackVerdict::not_by_cracks_alone;
  constexpr double most_jumped = 0.5;
  const bool cracks_explain_it = judgement.drops == CrackVerdict::cracks && !analysis.stiffness_implausible;
  if (!is_trusted(judgement.standing) && !cracks_explain_it)
    judgement.next = NextStep::check_case;
  else if (in_question && !reload)
    judgement.next = NextStep::reload;
  else if (judgement.standing == Standing::doubtful && judgement.doubts.back() == Doubt::unexpected_stiffness)
    judgement.next = NextStep::measure_stiffness;
  else if (has_few_rows(analysis))
    judgement.next = NextStep::finer_steps;
  else if (const NextStep step = step_for(judgement, on_edges); step != NextStep::none)
    judgement.next = step;
  else if (drops > 0 && jumped_part(analysis) > most_jumped) {
    const double deflection = *std::max_element(analysis.reduced.deflection.begin(), analysis.reduced.deflection.end());
    judgement.stiffness_for_all =
        critical_stiffness(Friction::as_met(fit.mean), deflection, analysis.rig.fibre) * fit.bending_stiffness.value;
    if (std::isfinite(judgement.stiffness_for_all)) judgement.next = NextStep::stiffer_rig;
  }
  return judgement;
}

}  // namespace flexslip
