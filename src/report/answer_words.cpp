#include "report/answer_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "inference/process_search.h"
#include "io/quantity.h"
#include "report/check_words.h"
#include "report/cycles_words.h"
#include "report/digits.h"
#include "report/printed.h"

namespace flexslip {
namespace {

// What would make a bending stiffness so many times too large or too small.
std::string likely_slip_of_units(double times) {
  struct Slip {
    double times;
    std::string_view words;
  };
  constexpr std::array slips{Slip{1.0 / 16, ", about 1/16: perhaps a radius for the diameter"},
                             Slip{16, ", about 16: perhaps a diameter for the radius"},
                             Slip{1e-3, ", about 1/1000: perhaps a unit of force or modulus, N for mN or MPa for GPa"},
                             Slip{1e3, ", about 1000: perhaps a unit of force or modulus, mN for N or GPa for MPa"},
                             Slip{1e-6, ", about a millionth: perhaps a unit of force or modulus"},
                             Slip{1e6, ", about a million: perhaps a unit of force or modulus"}};
  constexpr double near = 1.5;  // friction and a guess of the modulus move the ratio by less
  for (const auto& slip : slips)
    if (times < near * slip.times && times > slip.times / near) return std::string(slip.words);
  return "";
}

// "0.5 ± 0.7 %"
std::string loss_in_words(const Judgement& judgement) {
  return fmt::format("{:.1f} ± {:.1f} %", 100 * judgement.loss, 100 * judgement.loss_error);
}

// What the rises between the drops, and a reload, say of slips and cracks; a clause that follows the drops.
std::string cause_in_words(const FittedTest& test) {
  const SlipOrCrack& rises = test.analysis.slip_or_crack;
  const std::string margin = rises_in_words(rises);
  switch (test.judgement->drops) {
    case CrackVerdict::not_by_cracks_alone:
      return rises.verdict == CrackVerdict::not_by_cracks_alone
                 ? fmt::format("and cracks alone cannot ({})", margin)
                 : fmt::format(
                       "and cracks alone cannot: they would need to take {} of the stiffness, and the reload lost {}",
                       percent(test.judgement->loss_needed), loss_in_words(*test.judgement));
    case CrackVerdict::cracks:
      return rises.judged && rises.verdict == CrackVerdict::cracks
                 ? fmt::format("but the rises between them are those of a specimen that cracks (D* = {:.1f})",
                               rises.margin)
                 : "but the specimen lost stiffness";
    case CrackVerdict::cannot_be_told:
      break;
  }
  return rises.judged ? fmt::format("but cracks may do so too: this record cannot tell ({}; {} would)", margin,
                                    rises.margin > cracks_ruled_out ? "more than half of the rises growing stiffer"
                                                                    : fmt::format("D* above {:g}", cracks_ruled_out))
                      : "but cracks may do so too: there are too few drops, or rises between them, to tell";
}

std::string drops_in_words(const FittedTest& test) {
  const auto& summary = test.analysis.slip_summary;
  constexpr std::size_t enough = 3;  // to speak of a spacing
  const std::string spacing = summary.count < enough
                                  ? ""
                                  : fmt::format(", one drop for every {} drawn over each support",
                                                roughly(test.analysis.scales.physical_length(summary.median_spacing),
                                                        Print(test).as(kind::length)));
  const std::size_t drops = test.analysis.drops.drops.size();
  const std::size_t slips = summary.count;
  if (drops == 0) return "the force never drops by more than its noise";
  const std::string times = drops == 1 ? "once" : drops == 2 ? "twice" : fmt::format("{} times", drops);
  const Judgement& judgement = test.judgement.value();
  if (!is_trusted(judgement.standing)) return fmt::format("the force drops {}", times);
  if (slips == 0)
    return fmt::format("the force drops {}, and no plausible slip over the supports explains {}", times,
                       drops == 1 ? "it" : "any");
  const std::string which = drops == 1 ? "it" : slips == drops ? "every drop" : fmt::format("{} of the drops", slips);
  return fmt::format("the force drops {}{}; slips over the supports can explain {}, {}", times, spacing, which,
                     cause_in_words(test));
}

// Drops that nothing says to be slips.
bool may_have_cracked(const FittedTest& test) {
  return !test.analysis.drops.drops.empty() && test.judgement.value().drops != CrackVerdict::not_by_cracks_alone;
}

// The friction of the specimen as tested, and whether it repeats.
std::string friction_in_short(const FittedTest& test) {
  if (lost_stiffness(test.judgement.value()))
    return "No friction can be read off the record of a specimen that loses stiffness.";
  const auto& fit = test.analysis.fit;
  std::string words = fmt::format(
      "{} at the supports is {}{}", may_have_cracked(test) ? "If nothing cracked, friction" : "Friction",
      mean_friction(fit),
      fit.mu0_is_bound ? " (95 %): the record does not tell it from zero." : " on average over the fibre seen.");
  if (fit.mu0_is_bound) return words;
  if (fit.wave_claimed && fit.model == ProfileModel::roughness)
    words += fmt::format(" It repeats every {} along the fibre.",
                         roughly(test.analysis.scales.physical_length(fit.waves.front().wavelength.value),
                                 Print(test).as(kind::length)));
  else if (fit.model == ProfileModel::roughness)
    words += fit.log_evidence_of_wave <= claiming_gain
                 ? fmt::format(" It shows no periodicity beyond roughness (ln B = {:.1f}).", fit.log_evidence_of_wave)
                 : " It shows no periodicity beyond roughness.";
  return words;
}

constexpr double farthest_deflection = 0.8;  // [span]

std::string_view sawtooth_in_words(const TestAnalysis& analysis) {
  switch (analysis.category) {
    case SawtoothCategory::clear:
      return "A clear sawtooth";
    case SawtoothCategory::nominal:
      return "A faint sawtooth";
    case SawtoothCategory::none:
      break;
  }
  return analysis.drops.drops.empty() ? "No sawtooth" : "Hardly a sawtooth";
}

// How a record misses what sliding gives; a clause.
std::string by_how_much(const TestAnalysis& analysis) {
  const double below = 1 - analysis.over_frictionless.median, deepest = 1 - analysis.over_frictionless.least;
  constexpr double noticeable = 0.01;
  if (below > noticeable)
    return fmt::format(": past a tenth of the span its force lies {} below that without friction", percent(below));
  if (deepest > noticeable) return fmt::format(": its force falls to {} below that without friction", percent(deepest));
  return analysis.status == AnalysisStatus::ok
             ? fmt::format(": the best fit misses the force by {} of its greatest",
                           percent_of(analysis.fit.residual_rms,
                                      *std::max_element(analysis.reduced.force.begin(), analysis.reduced.force.end())))
             : "";
}

// Where the curve seems to begin later than the contact is taken to be; else empty.
std::string late_beginning_in_words(const FittedTest& test) {
  const Contact& contact = test.analysis.contact;
  const Estimate& toe = contact.offset;
  if (contact.status != ContactStatus::found || !(toe.value > 2 * toe.standard_error)) return "";
  return fmt::format(
      " A line through the first part of the curve meets zero force {} behind the contact: see what contact = "
      "\"find\" under [record] makes of it.",
      readable(toe.value, toe.standard_error, Print(test).as(kind::length)));
}

// A sentence of the answer; empty for a doubt that the words on the drops tell.
std::string doubt_in_words(Doubt doubt, const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  switch (doubt) {
    case Doubt::wrong_stiffness:
      return fmt::format("the bending stiffness stated is {} times that of the record's initial slope{}.",
                         roughly(analysis.stiffness_over_slope, kind::number),
                         likely_slip_of_units(analysis.stiffness_over_slope));
    case Doubt::no_sliding:
      return test.judgement->doubts.front() == Doubt::no_sliding
                 ? "no sliding with a friction of 0 to 2 gives this record" + by_how_much(analysis) + "."
                 : "No sliding with a friction of 0 to 2 gives this record, either.";
    case Doubt::softer_reload:
      return fmt::format("The specimen lost stiffness: loaded again it is {:.0f} ± {:.0f} % softer.",
                         100 * test.judgement->loss, 100 * test.judgement->loss_error);
    case Doubt::cracks:
      return is_trusted(test.judgement->standing)
                 ? "The drops are those of a specimen that cracks; the friction given takes them for slips."
                 : "The drops are those of a specimen that cracks.";
    case Doubt::impossible_drops: {
      const auto impossible = std::count_if(analysis.slips.begin(), analysis.slips.end(),
                                            [](const Slip& slip) { return is_no_slip(slip.verdict); });
      return analysis.slips.size() == 1
                 ? "The drop cannot be a slip."
                 : fmt::format("{} of the {} drops cannot be slips.", impossible, analysis.slips.size());
    }
    case Doubt::implausible_friction:
      return (analysis.suspects.suspect
                  ? fmt::format(
                        "The record needs implausible friction: at the bending stiffness {}, above {:.3g} in {} "
                        "of {} points past a tenth of the span.",
                        analysis.stiffness_from_slope ? "of the initial slope" : "stated", analysis.suspects.limit,
                        analysis.suspects.points.size(), analysis.suspects.points_judged)
                  : fmt::format("The record needs implausible friction: at least {:.2f} on average (95 %).",
                                analysis.fit.mu0.low)) +
             (analysis.fit.mu0.low > analysis.most_friction
                  ? fmt::format(
                        " The rollers turn on their pins at {:.3g}: they may be stuck, or what is stated of them "
                        "is wrong.",
                        analysis.most_friction)
              : analysis.rig.fibre.supports().radius > 0
                  ? ""
                  : " Rollers taken for edges would need it, too: state [rig] roller_radius.");
    case Doubt::failed_check: {
      std::string words;
      for (const auto& check : analysis.checks) {
        if (check.outcome != CheckOutcome::failed || check.kind == CheckKind::friction ||
            check.kind == CheckKind::stiffness)
          continue;
        words += fmt::format("{}A check failed: {}.", words.empty() ? "" : " ", check_in_words(test, check).words);
      }
      return words;
    }
    case Doubt::falling_friction:
      return "Friction falls away along the record. Lost stiffness would look the same, and so would supports whose "
             "radius is not stated ([rig] roller_radius).";
    case Doubt::changed_reload:
      return fmt::format(
          "Loaded again, the specimen is {:.0f} ± {:.0f} % {}.", 100 * std::abs(test.judgement->loss),
          100 * test.judgement->loss_error,
          test.judgement->loss > 0 ? "softer than at first" : "stiffer than at first: contact or rig have changed");
    case Doubt::coarse_force:
      return fmt::format("The force is coarse: a drop of less than {} could not be seen.",
                         Print(test).own(analysis.drops.smallest_fall, kind::force));
    case Doubt::undecided_drops:
      return "";  // what the drops may be is told with them
    case Doubt::few_rows:
      return "Most rises between drops have fewer than five rows: drops and waves of friction may be missed.";
    case Doubt::below_frictionless:
      return "The force lies below that without friction: the bending stiffness stated is too large, or the contact "
             "lies farther." +
             late_beginning_in_words(test);
    case Doubt::settling_contact:
      return fmt::format(
          "The curve bends where it begins: the contact may lie {} farther; contact = \"find\" takes that off.",
          readable(analysis.contact.offset.value, analysis.contact.offset.standard_error,
                   Print(test).as(kind::length)));
    case Doubt::unexpected_stiffness:
      break;
  }
  return fmt::format("The fitted bending stiffness is {} from that {}, {:.1f} times its error.{}",
                     signed_percent(fit.bending_stiffness.value - 1),
                     analysis.stiffness_from_slope ? "of the initial slope" : "stated",
                     std::abs(std::log(fit.bending_stiffness.value)) / analysis.bending_stiffness_error,
                     late_beginning_in_words(test));
}

double greatest_deflection(const TestAnalysis& analysis) {
  const auto& w = analysis.reduced.deflection;
  return w.empty() ? 0 : *std::max_element(w.begin(), w.end());
}

// What a camera saw of the length pulled in; empty if there was none.
std::string imaged_in_words(const FittedTest& test) {
  if (!test.imaged || test.imaged->points.empty()) return "";
  const ImagedLength& imaged = *test.imaged;
  const double unit = test.analysis.scales.span();
  return fmt::format(
      "The imaged length pulled in is {} {} than the force says (median of {}), with a scatter of {}.",
      readable(std::abs(unit * imaged.offset.value), unit * imaged.offset.standard_error, Print(test).as(kind::length)),
      imaged.offset.value > 0 ? "less" : "more", counted(imaged.points.size(), "point", "points"),
      roughly(unit * imaged.scatter, Print(test).as(kind::length)));
}

std::string_view standing_in_words(Standing standing, std::span<const Doubt> doubts, bool tells_friction) {
  switch (standing) {
    case Standing::sound:
      return tells_friction ? "No check speaks against this." : "Nothing else speaks against this.";
    case Standing::doubtful:
      return std::any_of(doubts.begin(), doubts.end(), [](Doubt doubt) { return doubt != Doubt::undecided_drops; })
                 ? "This is open to doubt."
                 : "This is open to doubt, as the drops may be cracks.";
    case Standing::suspect:
      return "The test is suspect.";
    case Standing::untrusted:
      break;
  }
  return "None of this is to be trusted.";
}

std::string next_step_in_words(const FittedTest& test) {
  const Judgement& judgement = test.judgement.value();
  switch (judgement.next) {
    case NextStep::none:
      return "";
    case NextStep::check_case:
      return test.analysis.stiffness_implausible
                 ? "Next: check the modulus, the section, the span, the load train, the columns and their units, and "
                   "whether the specimen cracks."
             : test.analysis.drops.drops.empty()
                 ? "Next: check the modulus, the section, the span, the contact, the load train, the columns and their "
                   "units. If all "
                   "are right, the specimen gives way: unload and load once more."
                 : "Next: find out whether the specimen cracks: unload and load once more. If it does not, check the "
                   "modulus, the section, the span, the load train, the columns and their units.";
    case NextStep::reload:
      if (test.measurement.end == MeasurementEnd::failure || test.measurement.end == MeasurementEnd::until)
        return "Next: in the next test unload before the specimen breaks, and load once more; a reload bounds any "
               "stiffness lost to cracks.";
      if (test.cycles && test.cycles->stiffness.size() > 1)
        return "Next: unload to almost no force and load once more, as far as at first; the loadings of this record "
               "cannot be compared.";
      if (test.cycles) return "Next: load once more; a reload bounds any stiffness lost to cracks.";
      return "Next: unload and load once more; a reload bounds any stiffness lost to cracks.";
    case NextStep::finer_steps:
      return "Next: record more rows; most rises between drops have fewer than five.";
    case NextStep::stiffer_rig:
      return fmt::format(
          "Next: a stiffer rig; more than half of the fibre seen passes in jumps. At {} or more, the force falls only "
          "smoothly with mean friction like this.",
          Print(test).own(test.analysis.scales.physical_stiffness(judgement.stiffness_for_all), kind::stiffness));
    case NextStep::state_radius:
      return "Next: state [rig] roller_radius, if the supports are not edges; if they are, image them: the length "
             "drawn "
             "in shows whether the fibre slides.";
    case NextStep::find_contact:
      return "Next: see whether the answer stays with contact = \"find\" under [record].";
    case NextStep::finer_force:
      return "Next: record the force more finely; falls smaller than that cannot be seen.";
    case NextStep::measure_stiffness:
      return "Next: check the modulus, the section, the span and the contact.";
    case NextStep::see_checks:
      return "Next: see what the checks advise.";
    case NextStep::image_length:
      break;
  }
  return "Next: image the supports; the length drawn in shows whether the fibre slides.";
}

}  // namespace

std::string mean_friction(const FrictionFit& fit) {
  return fit.mu0_is_bound ? fmt::format("at most {}", significant(fit.mu0.high, 2))
                          : readable(fit.mu0.value, fit.mu0.standard_error, kind::number);
}

std::string answer_of(const FittedTest& test) {
  const auto& analysis = test.analysis;
  if (analysis.status == AnalysisStatus::no_initial_slope)
    return "No answer: the force does not rise where the record begins, so the bending stiffness cannot be told.";
  const auto& force = analysis.record.force;
  if (!force.empty() && *std::max_element(force.begin(), force.end()) <= 0)
    return "No answer: the force is nowhere above zero. Check the column of force, and its sign.";
  if (analysis.status == AnalysisStatus::too_few_points)
    return greatest_deflection(analysis) > farthest_deflection
               ? fmt::format(
                     "No answer: the deflection gets to {}, {:.2g} times the span of {}. No specimen bends so far over "
                     "its supports. Check the units, and where the displacement counts from.",
                     Print(test).length(greatest_deflection(analysis)), greatest_deflection(analysis),
                     Print(test).length(1))
               : fmt::format(
                     "No answer: too few points lie beyond a deflection of {}, the larger of a twentieth of the span "
                     "and twice the thickness; friction shows only there. The greatest deflection is {}, {:.2g} % of "
                     "the span of {}: if it should be more, check the units; if not, bend a thinner specimen, or "
                     "farther.",
                     Print(test).length(friction_told_from(analysis.rig.fibre)),
                     Print(test).length(greatest_deflection(analysis)), 100 * greatest_deflection(analysis),
                     Print(test).length(1));
  if (analysis.status == AnalysisStatus::not_explained) {
    std::string answer =
        "No answer: no sliding with a friction of 0 to 2 gives this record" + by_how_much(analysis) +
        ". Check the columns, their units, the span, the section, the modulus and the stiffness of the load train.";
    if (analysis.stiffness_implausible)
      return answer + fmt::format(
                          " The bending stiffness stated is {} times that of the record's initial slope{}. Next: "
                          "see what modulus = \"fit\", which takes it from the record, makes of it.",
                          roughly(analysis.stiffness_over_slope, kind::number),
                          likely_slip_of_units(analysis.stiffness_over_slope));
    return answer +
           " Next: see what flexslip read makes of the file; docs/reading-your-report.md has symptoms and remedies.";
  }
  const Judgement& judgement = test.judgement.value();
  const bool trusted = is_trusted(judgement.standing);
  std::string answer = trusted ? "" : "No answer to trust: ";
  for (const Doubt doubt : judgement.doubts) {
    // What follows from a wrong stiffness, or from no sliding, is no doubt of its own.
    if (!trusted && doubt > Doubt::cracks) continue;
    const std::string words = doubt_in_words(doubt, test);
    if (!words.empty()) answer += words + " ";
  }
  if (!trusted)
    return fmt::format("{}{}: {}.{} {}", answer, sawtooth_in_words(analysis), drops_in_words(test),
                       late_beginning_in_words(test), next_step_in_words(test));
  answer += fmt::format("{}: {}. {}", sawtooth_in_words(analysis), drops_in_words(test), friction_in_short(test));
  const double share = analysis.energy.friction_share;
  const bool is_told = !analysis.fit.mu0_is_bound && !lost_stiffness(test.judgement.value());
  if (share > 0.005 && judgement.standing < Standing::suspect && is_told)
    answer +=
        !may_have_cracked(test)
            ? fmt::format(" {} of the work on the specimen went into friction and should not be counted as toughness.",
                          percent(share))
            : fmt::format(
                  " If the drops are slips, {} of the work on the specimen went into friction and should not be "
                  "counted as toughness.",
                  percent(share));
  if (const std::string imaged = imaged_in_words(test); !imaged.empty()) answer += " " + imaged;
  if (test.cycles && !lost_stiffness(judgement)) answer += " " + cycles_in_short(test);
  answer += fmt::format(" {}", standing_in_words(judgement.standing, judgement.doubts, !analysis.fit.mu0_is_bound));
  if (const std::string next = next_step_in_words(test); !next.empty()) answer += " " + next;
  return answer;
}

std::string caution_of(const FittedTest& test) {
  if (!is_trusted(test.judgement.value().standing))
    return "The fit is not to be used: it tells no friction. What is drawn of it shows where it fails.";
  return lost_stiffness(test.judgement.value())
             ? "The numbers below assume that the specimen kept its stiffness; the record speaks against that."
             : "";
}

}  // namespace flexslip
