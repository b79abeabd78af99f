#include "report/fit_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// What the rises between the drops, and a reload, say of slips and cracks; a clause that follows the drops.
std::string cause_in_words(const FittedTest& test) {
  const SlipOrCrack& rises = test.analysis.slip_or_crack;
  const std::string margin =
      fmt::format("D* = {:.1f}; {} of {} rises grow stiffer", rises.margin, rises.stiffer_rises, rises.rises);
  switch (test.judgement->drops) {
    case CrackVerdict::not_by_cracks_alone:
      return rises.verdict == CrackVerdict::not_by_cracks_alone
                 ? fmt::format("and cracks alone cannot ({})", margin)
                 : "and cracks alone cannot: the reload lost less stiffness than they would need";
    case CrackVerdict::cracks:
      return rises.judged && rises.verdict == CrackVerdict::cracks
                 ? fmt::format("but the rises between them are those of a specimen that cracks (D* = {:.1f})",
                               rises.margin)
                 : "but the specimen lost stiffness";
    case CrackVerdict::cannot_be_told:
      break;
  }
  return rises.judged ? fmt::format("but cracks may do so too: this record cannot tell ({})", margin)
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
  if (slips == 0)
    return fmt::format("the force drops {}, and no plausible slip over the supports explains {}", times,
                       drops == 1 ? "it" : "a drop");
  const std::string which = drops == 1 ? "it" : slips == drops ? "every drop" : fmt::format("{} of the drops", slips);
  return fmt::format("the force drops {}{}; slips over the supports can explain {}, {}", times, spacing, which,
                     cause_in_words(test));
}

ParameterRow row_of(std::string name, std::string symbol, std::string meaning, const Estimate& estimate, double factor,
                    const Kind& kind) {
  const bool known = std::isfinite(estimate.standard_error);
  const double low = estimate.low * factor;
  const double high = estimate.high * factor;
  ParameterRow row{std::move(name),
                   std::move(symbol),
                   std::move(meaning),
                   readable(estimate.value * factor, estimate.standard_error * factor, kind),
                   "",
                   ""};
  if (known) {
    // Both ends in the unit of the larger one.
    const std::string_view unit = best_unit(std::max(std::abs(low), std::abs(high)), kind);
    const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
    const double spread = from_si(estimate.standard_error * factor, scale);
    const int decimals = spread > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(spread))), 0, 12) : 4;
    row.interval = fmt::format("{:.{}f} to {:.{}f}{}{}", from_si(low, scale), decimals, from_si(high, scale), decimals,
                               unit.empty() ? "" : " ", typeset(unit));
  } else {
    row.remark = "error not known: the curve hardly depends on it";
  }
  return row;
}

std::string_view in_words(Kernel kernel) {
  switch (kernel) {
    case Kernel::exponential:
      return "exponential";
    case Kernel::matern_3_2:
      return "Matérn 3/2";
    case Kernel::matern_5_2:
      return "Matérn 5/2";
    case Kernel::none:
      break;
  }
  return "none";
}

std::string_view in_words(SlipVerdict verdict) {
  switch (verdict) {
    case SlipVerdict::possible:
      return "can be a slip";
    case SlipVerdict::unexplained:
      return "no slip: no friction explains it";
    case SlipVerdict::implausible:
      return "no slip: too much friction before";
    case SlipVerdict::negative:
      return "no slip: friction below none after";
    case SlipVerdict::moves_out:
      return "no slip: length would be let out";
    case SlipVerdict::too_short:
      break;
  }
  return "too short to judge";
}

// "the range 0.5 to 0.721", or "the 0.7".
std::string ranged(double low, double high) {
  return low < high ? fmt::format("the range {:g} to {:g}", low, high) : fmt::format("the {:g}", low);
}

// Does a reload, or the rises between the drops, show that the specimen lost stiffness on the way?
bool lost_stiffness(const FittedTest& test) {
  const Judgement& judgement = test.judgement.value();
  return std::any_of(judgement.doubts.begin(), judgement.doubts.end(), [&](Doubt doubt) {
    return doubt == Doubt::softer_reload || doubt == Doubt::cracks ||
           (doubt == Doubt::changed_reload && judgement.loss > 0);
  });
}

// The friction of the specimen as tested, and whether it repeats.
std::string friction_in_short(const FittedTest& test) {
  if (lost_stiffness(test)) return "Friction is not to be read off the record of a specimen that loses stiffness.";
  const auto& fit = test.analysis.fit;
  std::string words =
      fit.mu0_is_bound
          ? fmt::format("Friction at the supports is {} (95 %): the record does not tell it from none.",
                        mean_friction(fit))
          : fmt::format("Friction at the supports is {} on average over the fibre seen.", mean_friction(fit));
  if (fit.mu0_is_bound) return words;
  if (fit.wave_claimed && fit.model == ProfileModel::roughness)
    words += fmt::format(" It repeats every {} of the specimen.",
                         roughly(test.analysis.scales.physical_length(fit.waves.front().wavelength.value),
                                 Print(test).as(kind::length)));
  else if (fit.model == ProfileModel::roughness)
    words += std::isfinite(fit.log_evidence_of_wave)
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

// A sentence of the answer; empty for a doubt that the words on the drops tell.
std::string doubt_in_words(Doubt doubt, const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  switch (doubt) {
    case Doubt::wrong_stiffness:
      return fmt::format("the bending stiffness stated is {:.2g} times that of the record's initial slope.",
                         analysis.stiffness_over_slope);
    case Doubt::no_sliding:
      return test.judgement->doubts.front() == Doubt::no_sliding
                 ? "no sliding with a friction of 0 to 2 gives this record."
                 : "Nor does any sliding with a friction of 0 to 2 give this record.";
    case Doubt::softer_reload:
      return fmt::format("The specimen lost stiffness: loaded again it is {:.0f} ± {:.0f} % softer.",
                         100 * test.judgement->loss, 100 * test.judgement->loss_error);
    case Doubt::cracks:
      return test.judgement->standing == Standing::untrusted
                 ? "The drops are those of a specimen that cracks."
                 : "The drops are those of a specimen that cracks; what is said of friction takes them for slips.";
    case Doubt::impossible_drops: {
      const auto impossible = std::count_if(analysis.slips.begin(), analysis.slips.end(),
                                            [](const Slip& slip) { return is_no_slip(slip.verdict); });
      return analysis.slips.size() == 1
                 ? "The drop can be no slip."
                 : fmt::format("{} of the {} drops can be no slip.", impossible, analysis.slips.size());
    }
    case Doubt::implausible_friction:
      if (!analysis.suspects.suspect)
        return fmt::format("It needs more friction than is plausible: at least {:.2f} on average, with 95 %.",
                           analysis.fit.mu0.low);
      return fmt::format(
          "It needs more friction than is plausible: above {:g} in {} of {} points past a tenth of the "
          "span.",
          analysis.suspects.limit, analysis.suspects.points.size(), analysis.suspects.points_judged);
    case Doubt::failed_check: {
      std::string words;
      for (const auto& check : analysis.checks) {
        if (check.outcome != CheckOutcome::failed || check.kind == CheckKind::friction) continue;
        const std::string found = check_in_words(test, check);  // "Failed: …"
        words += (words.empty() ? "A check failed" : " A check failed") + found.substr(found.find(':'));
      }
      return words;
    }
    case Doubt::falling_friction:
      return "Friction falls away along the record, as the force of a specimen would that loses stiffness, or supports "
             "whose radius is not stated ([rig] roller_radius).";
    case Doubt::changed_reload:
      return fmt::format("Loaded again the specimen is {:.0f} ± {:.0f} % {} than at first.",
                         100 * std::abs(test.judgement->loss), 100 * test.judgement->loss_error,
                         test.judgement->loss > 0 ? "softer" : "stiffer (contact or rig have changed)");
    case Doubt::coarse_force:
      return fmt::format("The force is coarse: a drop of less than {} could not be seen.",
                         Print(test).own(analysis.drops.smallest_fall, kind::force));
    case Doubt::undecided_drops:
      return "";
    case Doubt::few_rows:
      return "Most rises between drops have fewer than five rows: waves of friction may be missed, and drops.";
    case Doubt::settling_contact:
      return fmt::format(
          "The curve bends where it begins: the contact may lie {} farther, and contact = \"find\" would "
          "take that off.",
          readable(analysis.contact.offset, analysis.contact.offset_error, Print(test).as(kind::length)));
    case Doubt::unexpected_stiffness:
      break;
  }
  return fmt::format("The bending stiffness that fits is {} from that {}, {:.1f} times its error.",
                     signed_percent(fit.bending_stiffness.value - 1),
                     analysis.stiffness_from_slope ? "of the initial slope" : "stated",
                     std::abs(std::log(fit.bending_stiffness.value)) / analysis.bending_stiffness_error);
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
      "The length pulled in as imaged is {} {} than the force says (median of {}), and scatters by {} about that.",
      readable(std::abs(unit * imaged.offset), unit * imaged.error, Print(test).as(kind::length)),
      imaged.offset > 0 ? "less" : "more", counted(imaged.points.size(), "point", "points"),
      roughly(unit * imaged.scatter, Print(test).as(kind::length)));
}

std::string_view standing_in_words(Standing standing) {
  switch (standing) {
    case Standing::sound:
      return "No check speaks against this.";
    case Standing::doubtful:
      return "This is open to doubt.";
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
      return "Next: check the modulus, the section, the span, the columns and their units, and whether the specimen "
             "cracks.";
    case NextStep::reload:
      if (test.cycles && test.cycles->stiffness.size() > 1)
        return "Next: unload to almost no force and load once more, as far as at first; the loadings of this record "
               "cannot be "
               "compared.";
      if (test.cycles) return "Next: load once more; a reload bounds the stiffness that cracks can have taken.";
      return "Next: unload and load once more; a reload bounds the stiffness that cracks can have taken.";
    case NextStep::finer_steps:
      return "Next: record more rows; most rises between drops have fewer than five.";
    case NextStep::stiffer_rig:
      return fmt::format(
          "Next: a stiffer rig; the fibre jumps over more than half of what it passes. From {} on, mean friction such "
          "as this does not snap.",
          Print(test).own(test.analysis.scales.physical_stiffness(judgement.stiffness_for_all), kind::stiffness));
    case NextStep::image_length:
      break;
  }
  return "Next: image the supports; the length drawn in tells sliding from what is not.";
}

}  // namespace

std::string mean_friction(const FrictionFit& fit) {
  return fit.mu0_is_bound ? fmt::format("at most {}", significant(fit.mu0.high, 2))
                          : readable(fit.mu0.value, fit.mu0.standard_error, kind::number);
}

std::string answer_of(const FittedTest& test) {
  const auto& analysis = test.analysis;
  if (analysis.status == AnalysisStatus::no_initial_slope)
    return "No answer: the force does not rise where the record begins, so that the bending stiffness cannot be told.";
  if (analysis.status == AnalysisStatus::too_few_points)
    return greatest_deflection(analysis) > farthest_deflection
               ? fmt::format(
                     "No answer: the deflection gets to {}, {:.2g} times the span of {}, farther than a specimen "
                     "bends over its supports. Check their units, and where the displacement counts from.",
                     Print(test).length(greatest_deflection(analysis)), greatest_deflection(analysis),
                     Print(test).length(1))
               : fmt::format(
                     "No answer: too few points lie beyond a deflection of {}, a twentieth of the span and twice the "
                     "specimen's thickness, where friction shows. The greatest deflection is {}, {:.2g} % of the span "
                     "of {}: if it should be more, check their units; else bend a thinner specimen, or farther.",
                     Print(test).length(friction_told_from(analysis.rig.fibre)),
                     Print(test).length(greatest_deflection(analysis)), 100 * greatest_deflection(analysis),
                     Print(test).length(1));
  if (analysis.status == AnalysisStatus::not_explained) {
    std::string answer =
        "No answer: no sliding with a friction of 0 to 2 gives this record. Check the columns, their units, the span "
        "and the section.";
    if (analysis.stiffness_implausible)
      answer += fmt::format(" The bending stiffness stated is {:.2g} times that of the record's initial slope.",
                            analysis.stiffness_over_slope);
    return answer;
  }
  const Judgement& judgement = test.judgement.value();
  const bool trusted = judgement.standing != Standing::untrusted;
  std::string answer = trusted ? "" : "No answer to trust: ";
  for (const Doubt doubt : judgement.doubts) {
    // What follows from a wrong stiffness, or from no sliding, is no doubt of its own.
    if (!trusted && doubt > Doubt::cracks) continue;
    const std::string words = doubt_in_words(doubt, test);
    if (!words.empty()) answer += words + " ";
  }
  if (!trusted)
    return fmt::format("{}{}: {}. {}", answer, sawtooth_in_words(analysis), drops_in_words(test),
                       next_step_in_words(test));
  answer += fmt::format("{}: {}. {}", sawtooth_in_words(analysis), drops_in_words(test), friction_in_short(test));
  const double share = analysis.energy.friction_share;
  const bool is_told = !analysis.fit.mu0_is_bound && !lost_stiffness(test);
  if (share > 0.005 && judgement.standing < Standing::suspect && is_told)
    answer += analysis.drops.drops.empty() || judgement.drops == CrackVerdict::not_by_cracks_alone
                  ? fmt::format(
                        " {} of the work on the specimen went into friction and should not be counted as "
                        "toughness.",
                        percent(share))
                  : fmt::format(
                        " If the drops are slips, {} of the work on the specimen went into friction and should "
                        "not be counted as toughness.",
                        percent(share));
  if (const std::string imaged = imaged_in_words(test); !imaged.empty()) answer += " " + imaged;
  if (test.cycles) answer += " " + cycles_in_short(test);
  answer += fmt::format(" {}", standing_in_words(judgement.standing));
  if (const std::string next = next_step_in_words(test); !next.empty()) answer += " " + next;
  return answer;
}

std::string caution_of(const FittedTest& test) {
  return lost_stiffness(test)
             ? "The numbers below assume that the specimen kept its stiffness; the record speaks against that."
             : "";
}

std::vector<ParameterRow> parameter_rows(const FittedTest& test) {
  const auto& scales = test.analysis.scales;
  const auto& fit = test.analysis.fit;
  const Print print(test);
  std::vector<ParameterRow> rows;
  rows.push_back(row_of("mu0", "μ₀", "mean friction over the fibre seen", fit.mu0, 1, kind::number));
  if (fit.mu0_is_bound) {
    rows.back().value = mean_friction(fit);
    rows.back().remark = "the record does not tell it from none";
  }
  if (fit.model != ProfileModel::constant) {
    rows.push_back(row_of("drift", "dμ/dS", "of the mean along the length", fit.drift, 1 / scales.span(),
                          print.as(kind::inverse_length)));
    rows.push_back({"reference", "", "where mu0 and drift hold", print.length(fit.S_middle), "", ""});
  }
  if (fit.model == ProfileModel::roughness) {
    rows.push_back(row_of("roughness", "σ", "standard deviation of μ about its mean", fit.roughness, 1, kind::number));
    if (const double none = weight_without_roughness(fit); none > 0.5)
      rows.back().remark = fmt::format("if there is any: the evidence is for none, by {}", percent(none));
    rows.push_back(row_of("correlation_length", "ℓ", "of the roughness along the fibre", fit.length, scales.span(),
                          print.as(kind::length)));
  }
  if (fit.wave_claimed)
    for (std::size_t i = 0; i < fit.waves.size(); ++i) {
      const auto& wave = fit.waves[i];
      const std::string suffix = i == 0 ? "" : fmt::format("_{}", i + 1);
      const std::string which = i == 0 ? "" : fmt::format(", wave {}", i + 1);
      const auto symbol = [&](const char* letter) { return i == 0 ? std::string(letter) : ""; };
      rows.push_back(row_of("amplitude" + suffix, symbol("A"), "of the wave, relative to μ₀" + which, wave.amplitude, 1,
                            kind::number));
      rows.push_back(row_of("wavelength" + suffix, symbol("λ"), "along the specimen" + which, wave.wavelength,
                            scales.span(), print.as(kind::length)));
      const auto add_phase = [&](const std::string& name, const std::string& letter, const std::string& meaning,
                                 const Estimate& phase) {
        const bool is_determined = phase.high - phase.low <= 2 * std::numbers::pi;  // else it turns with λ
        if (is_determined)
          rows.push_back(row_of(name + suffix, letter, meaning + which, phase, 1, print.as(kind::angle)));
      };
      add_phase("phase_at_middle", "", "in the middle of the fibre seen", wave.phase_at_middle);
      add_phase("phase", symbol("φ"), "of (4.25), at the length 0", wave.phase);
    }
  rows.push_back(row_of("bending_stiffness", "EI", "of the specimen", fit.bending_stiffness, scales.bending_stiffness(),
                        print.as(kind::bending_stiffness)));
  rows.back().remark = fit.model == ProfileModel::constant
                           ? "not fitted: a constant friction would bend it to the roughness"
                           : fmt::format("{} from {}, ± {:.1f} %", signed_percent(fit.bending_stiffness.value - 1),
                                         test.stiffness == StiffnessSource::initial_slope ? "the initial slope"
                                         : test.stiffness == StiffnessSource::mirror      ? "that of the loops"
                                                                                          : "that given",
                                         100 * test.analysis.bending_stiffness_error);
  if (test.section_moment && !test.reduced)
    rows.push_back(row_of("modulus", "E", "flexural modulus, EI/I", fit.bending_stiffness,
                          scales.bending_stiffness() / *test.section_moment, kind::pressure));
  if (fit.model != ProfileModel::constant)
    rows.push_back(row_of("force_noise", "", "standard deviation of a force reading", fit.noise,
                          scales.physical_force(1), print.as(kind::force)));
  return rows;
}

std::string model_in_words(ProfileModel model) {
  return model == ProfileModel::roughness ? "roughness" : fmt::format("'{}', the paper's", name_of(model));
}

PrintedTable explanation_table(const FittedTest& test) {
  PrintedTable table{{"Roughness", "Wave", "Weight", "ln evidence, less the best"}, {}};
  const Print print(test);
  const auto& explanations = test.analysis.fit.explanations;
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, explanations.size()); ++i) {
    const auto& each = explanations[i];
    std::string waves;
    for (const double wavelength : each.wavelengths) waves += (waves.empty() ? "" : ", ") + print.length(wavelength);
    table.rows.push_back({std::string(in_words(each.kernel)), waves.empty() ? "none" : waves,
                          each.weight < 0.0005 ? "< 0.1 %" : percent_of(each.weight, 1),
                          fmt::format("{:.1f}", each.log_evidence - explanations.front().log_evidence)});
  }
  return table;
}

PrintedTable drop_table(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const Print print(test);
  const auto length = print.as(kind::length);
  const auto force = print.as(kind::force);
  NumberColumn stage{"Stage", {}, length}, before{"Force before", {}, force}, fall{"Fall", {}, force, 3},
      drawn_in{"Pulled in (both supports)", {}, length, 3}, mu_before{"μ before", {}, kind::number, 3},
      mu_after{"μ after", {}, kind::number, 3};
  std::vector<std::string> rows, significance, reading;
  for (const auto& slip : analysis.slips) {
    const Drop& drop = slip.drop;
    rows.push_back(fmt::format("{}–{}", file_row(test, drop.before), file_row(test, drop.after)));
    stage.values.push_back(analysis.record.stage[drop.before]);
    before.values.push_back(analysis.record.force[drop.before]);
    fall.values.push_back(drop.force_fall);
    significance.push_back(fmt::format("{:.1f}", drop.significance));
    drawn_in.values.push_back(analysis.scales.physical_length(slip.S_after - slip.S_before));
    mu_before.values.push_back(slip.mu_before);
    mu_after.values.push_back(slip.mu_after);
    reading.emplace_back(in_words(slip.verdict));
  }
  PrintedTable table = printed({stage, before, fall, drawn_in, mu_before, mu_after});
  table.head.insert(table.head.begin(), "Rows");
  table.head.insert(table.head.begin() + 4, "in noise (σ)");
  table.head.emplace_back("Reading");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    auto& row = table.rows[i];
    row.insert(row.begin(), rows[i]);
    row.insert(row.begin() + 4, significance[i]);
    row.push_back(reading[i]);
  }
  return table;
}

PrintedTable snap_table(const FittedTest& test) {
  const auto& scales = test.analysis.scales;
  const Print print(test);
  const auto length = print.as(kind::length);
  const auto force = print.as(kind::force);
  NumberColumn stage{"Stage", {}, length}, w_before{"Deflection before", {}, length}, w_after{"after", {}, length},
      F_before{"Force before", {}, force}, F_after{"after", {}, force}, S_before{"Length before", {}, length},
      S_after{"after", {}, length};
  for (const auto& snap : test.analysis.model.snaps) {
    stage.values.push_back(scales.physical_length(snap.stage));
    w_before.values.push_back(scales.physical_length(snap.before.w));
    w_after.values.push_back(scales.physical_length(snap.after.w));
    F_before.values.push_back(scales.physical_force(snap.before.F));
    F_after.values.push_back(scales.physical_force(snap.after.F));
    S_before.values.push_back(scales.physical_length(snap.before.S));
    S_after.values.push_back(scales.physical_length(snap.after.S));
  }
  return printed({stage, w_before, w_after, F_before, F_after, S_before, S_after});
}

PrintedTable energy_table(const FittedTest& test) {
  const auto& energy = test.analysis.energy;
  const auto& account = energy.account;
  const Print print(test);
  const std::vector<std::pair<std::string, double>> entries{
      {"Work of the stage", account.stage_work},
      {"stored in bending when the record ends", account.bending},
      {"stored in the load train", account.load_train},
      {"friction while the specimen slides", account.friction},
      {"lost in drops: friction, sound, vibration", account.snaps},
      {"not accounted for: the coarseness of the points", account.imbalance},
      {"Work on the specimen, ∫ F dw", energy.work_of_fracture},
      {"of it, friction and drops", account.friction + account.snaps}};
  NumberColumn joules{"", {}, print.as(kind::energy)};
  for (const auto& [name, value] : entries) joules.values.push_back(test.analysis.scales.physical_energy(value));
  PrintedTable table = printed({joules});
  table.head = {"Energy", table.head[0], "share of the stage's work"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    table.rows[i].insert(table.rows[i].begin(), entries[i].first);
    table.rows[i].push_back(percent_of(entries[i].second, account.stage_work));
  }
  table.rows.back().back() = percent_of(entries.back().second, energy.work_of_fracture) + " of that";
  return table;
}

std::string friction_in_words(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  std::string words =
      fit.mu0_is_bound
          ? fmt::format("The friction of the specimen as tested is {} (95 %): the record does not tell it from none.",
                        mean_friction(fit))
          : fmt::format(
                "The friction of the specimen as tested, its mean over the fibre seen, is {} (95 %: {:.3f} to "
                "{:.3f}).",
                mean_friction(fit), fit.mu0.low, fit.mu0.high);
  const auto& read = analysis.friction_read;
  words += fmt::format(
      " Read off the curve point by point, at the bending stiffness fitted, its median is {:.2f}, and four fifths of "
      "it "
      "lie between {:.2f} and {:.2f}.",
      read.median, read.low80, read.high80);
  if (weight_without_roughness(fit) > 0.5)
    words += " Beside that, it shows no roughness.";
  else if (fit.model == ProfileModel::roughness)
    words += fmt::format(
        " Along the specimen it varies at random by {} (standard deviation), over a correlation length of {}.",
        readable(fit.roughness.value, fit.roughness.standard_error, kind::number),
        roughly(analysis.scales.physical_length(fit.length.value), Print(test).as(kind::length)));
  return words;
}

std::string wave_in_words(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  if (fit.model == ProfileModel::constant || fit.model == ProfileModel::drift)
    return fmt::format("The model {} has no wave.", model_in_words(fit.model));
  if (fit.model != ProfileModel::roughness)
    return fmt::format(
        "The model {} has waves and no roughness. Whether there is a wave at all is asked by the model 'roughness'.",
        model_in_words(fit.model));
  if (fit.waves.empty() || !std::isfinite(fit.log_evidence_of_wave))
    return "There is no periodicity beyond roughness: no wave explains more than none.";
  const auto& wave = fit.waves.front();
  const std::string evidence =
      fmt::format("ln B = {:.1f}, where {} makes a claim", fit.log_evidence_of_wave, claiming_gain);
  const double unit = test.analysis.scales.span();
  const std::string wavelength =
      readable(unit * wave.wavelength.value, unit * wave.wavelength.standard_error, Print(test).as(kind::length));
  const std::string amplitude = readable(wave.amplitude.value, wave.amplitude.standard_error, kind::number);
  if (fit.wave_claimed)
    return fmt::format("Friction repeats along the specimen every {}, rising and falling by {} of its mean ({}).",
                       wavelength, amplitude, evidence);
  if (fit.log_evidence_of_wave > claiming_gain)
    return fmt::format(
        "There is no periodicity beyond roughness. The likeliest wave ({}), {} long, is longer than a quarter of the "
        "fibre "
        "seen: too few periods for a claim.",
        evidence, wavelength);
  return fmt::format(
      "There is no periodicity beyond roughness ({}). The likeliest wave, {} long with an amplitude of {} of the mean, "
      "is "
      "only indicative.",
      evidence, wavelength, amplitude);
}

std::string sides_in_words(const FittedTest& test) {
  std::string twice;
  for (const auto& [name, value] : lengths_of(test.analysis.fit))
    twice += fmt::format("{}a {} of {}", twice.empty() ? "" : ", ",
                         name == "wavelength" ? "wavelength" : "correlation length",
                         Print(test).length(one_side_at_a_time * value));
  if (twice.empty()) return "";
  return fmt::format(
      "These lengths hold if the specimen slides over both supports at once. If it slides over one at a time, as it "
      "does where the supports are not alike or friction falls, they are up to twice as long: {}. Force and stage "
      "do not tell which; images of both supports do.",
      twice);
}

std::vector<std::string> checks_in_words(const FittedTest& test) {
  std::vector<std::string> all;
  for (const auto& check : test.analysis.checks) all.push_back(check_in_words(test, check));
  return all;
}

std::optional<LiteratureFriction> literature_of(const FittedTest& test) {
  return test.materials ? friction_in_literature(*test.materials) : std::nullopt;
}

std::string strain_in_words(const FittedTest& test) {
  const double curvature = greatest_curvature(test.analysis.profile_at_fit, test.analysis.rig.fibre);
  if (!std::isfinite(curvature)) return "";
  const std::string wraps = curvature > test.nose_curvature
                                ? "The specimen was bent more sharply than the nose, and wrapped it: what is read "
                                  "there is read as of a sharp one."
                                : "";
  if (!test.surface) return wraps;
  const double strain = test.surface->strain(curvature);
  std::string words = fmt::format("Bending strained its surface at midspan by up to {:.2g} %", 100 * strain);
  if (!test.reduced)
    words += fmt::format(", a stress of {} at the modulus fitted",
                         Print(test).own(test.surface->stress(curvature), kind::pressure));
  words += ".";
  if (test.strain_at_break && strain > *test.strain_at_break)
    words += fmt::format(" That is beyond the {:.2g} % at which it should break.", 100 * *test.strain_at_break);
  return wraps.empty() ? words : words + " " + wraps;
}

std::string friction_in_literature(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const auto& mu0 = fit.mu0;
  const auto literature = literature_of(test);
  if (!test.materials)
    return "Friction is held against the literature where the case states [specimen] material and [rig] "
           "support_material.";
  if (!literature)
    return fmt::format("Of {} on {} the table of friction in the literature says nothing.", test.materials->specimen,
                       test.materials->support);
  const double low = literature->low, high = literature->high;
  const std::string range = fmt::format("{} that the literature gives for {} on {} ({})", ranged(low, high),
                                        literature->specimen, literature->support, literature->source);
  if (fit.mu0_is_bound)
    return fmt::format("μ₀ is {}; {} {} above that.", mean_friction(fit), range,
                       mu0.high < low ? "lies" : "begins or lies in part");
  const std::string value = mean_friction(fit);
  if (mu0.value >= low && mu0.value <= high) return fmt::format("μ₀ = {} lies within {}.", value, range);
  const double away = mu0.value < low ? low - mu0.value : mu0.value - high;
  std::string words = fmt::format("μ₀ = {} lies {} {}", value, mu0.value < low ? "below" : "above", range);
  if (mu0.standard_error > 0)
    words += fmt::format("; the nearer end is {:.1f} standard errors away", away / mu0.standard_error);
  return words + ".";
}

std::string slips_in_words(const FittedTest& test) {
  const auto& summary = test.analysis.slip_summary;
  const Print print(test);
  if (summary.count == 0) return "No drop of the force, so no slip to measure a spacing from.";
  std::string words =
      fmt::format("Friction falls by {:.3f} in a slip (median of {})", summary.median_fall, summary.count);
  if (summary.count >= 2)
    words += fmt::format(
        "; from the beginning of a slip to that of the next, {} of the specimen pass over a support (median; mean {})",
        roughly(test.analysis.scales.physical_length(summary.median_spacing), print.as(kind::length)),
        roughly(test.analysis.scales.physical_length(summary.mean_spacing), print.as(kind::length)));
  return words +
         ". These need no model: they are the counterparts of amplitude and wavelength, taken at the bending stiffness "
         "given.";
}

std::string snaps_in_words(const FittedTest& test) {
  const std::size_t snaps = test.analysis.model.snaps.size();
  const std::size_t drops = test.analysis.drops.drops.size();
  std::string words = snaps == 0 ? "The mean of the fit, run forward, never snaps"
                                 : fmt::format("The mean of the fit, run forward, snaps {}",
                                               snaps == 1 ? "once" : fmt::format("{} times", snaps));
  words += fmt::format(", where the measured force drops {}.", drops == 1 ? "once" : fmt::format("{} times", drops));
  if (snaps < drops)
    words +=
        " Not every fall of the force is a snap, and a mean is smoother than any one profile: profiles drawn from the "
        "fit are compared "
        "among the checks.";
  return words;
}

std::string suspicion_in_words(const FittedTest& test) {
  const auto& report = test.analysis.suspects;
  const std::size_t above = report.points.size();
  const std::string judged =
      fmt::format("{} past a deflection of a tenth of the span", counted(report.points_judged, "point", "points"));
  std::string words =
      above == 0
          ? fmt::format("None of the {} needs friction above {:g}.", judged, report.limit)
          : fmt::format("Of the {}, {} friction above {:g}, {} of them by more than twice the standard error.", judged,
                        above == 1 ? "1 needs" : fmt::format("{} need", above), report.limit, report.beyond_error);
  words += report.suspect ? " That is more than 5 %: the test is suspect."
           : above == 0   ? ""
                          : " That is at most 5 %: the test is not suspect.";
  return words + fmt::format(
                     " By the paper's criterion, a force above the Euler–Bernoulli line, {} suspect; but friction "
                     "alone lifts a sound "
                     "curve above that line, by 5 % at μ = 0.6.",
                     report.above_euler_bernoulli == 0   ? "none is"
                     : report.above_euler_bernoulli == 1 ? "1 is"
                                                         : fmt::format("{} are", report.above_euler_bernoulli));
}

std::string replay_in_words(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const Print print(test);
  const std::size_t drops = analysis.drops.drops.size();
  constexpr double rounding = 1e-9;  // of the greatest force of some 10 EI/L^2
  const double rms = analysis.replay.residual_rms;
  return fmt::format("The measured friction profile, run forward as a table, gives the measured force back {}{}.",
                     rms < rounding ? "exactly" : fmt::format("to {} rms", print.force(rms)),
                     drops == 0 ? ""
                                : fmt::format(", and {} of its {}", analysis.replay.drops_reproduced,
                                              counted(drops, "drop", "drops")));
}

std::vector<std::string> assumptions_of(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& measurement = test.measurement;
  const auto& fit = analysis.fit;
  const Print print(test);
  std::vector<std::string> list;
  const std::string error = fmt::format("{:.1f} %", 100 * analysis.bending_stiffness_error);
  switch (test.stiffness) {
    case StiffnessSource::stated:
      list.push_back(fmt::format(
          "The bending stiffness is known to {} (standard deviation), as stated; within that it is fitted.", error));
      break;
    case StiffnessSource::assumed_error:
      list.push_back(
          fmt::format("The bending stiffness is stated without an uncertainty; {} (standard deviation) is assumed, and "
                      "within that it is fitted.",
                      error));
      break;
    case StiffnessSource::mirror:
      list.push_back(fmt::format(
          "The bending stiffness is that at which friction is the same in loading and unloading, known to {} "
          "(standard deviation); within that it is fitted.",
          error));
      break;
    case StiffnessSource::initial_slope:
      list.push_back(
          fmt::format("The bending stiffness is that of the initial slope, known to {} (standard deviation); within "
                      "that it is fitted.",
                      error));
      break;
  }
  switch (measurement.contact) {
    case ContactSource::stated:
      list.push_back(fmt::format("The contact is at {}, as stated; stage and deflection count from there.",
                                 print.own(measurement.contact_offset, kind::length)));
      break;
    case ContactSource::found:
      list.push_back(fmt::format(
          "The record begins before the contact, which was found at {}; stage and deflection count from there.",
          readable(measurement.contact_offset, measurement.contact_error, print.as(kind::length))));
      break;
    case ContactSource::first_point:
      list.emplace_back("The contact is at the origin of the displacement in the file; nothing was taken off.");
      break;
  }
  if (measurement.contact != ContactSource::found && analysis.contact.status == ContactStatus::found)
    list.push_back(
        fmt::format("A line through the first part of the curve meets zero force at {} from there; this is reported, "
                    "not corrected.",
                    readable(analysis.contact.offset, analysis.contact.offset_error, print.as(kind::length))));
  const std::size_t last = last_row(test);
  switch (measurement.end) {
    case MeasurementEnd::until:
      list.push_back(fmt::format("The record ends with row {}, as stated.", last));
      break;
    case MeasurementEnd::failure:
      list.push_back(fmt::format("The specimen fails after row {}, as found; what follows is left out.", last));
      break;
    case MeasurementEnd::turn:
      list.push_back(fmt::format(
          "The stage turns back after row {}: what is said of the loading holds for the rows before.", last));
      break;
    case MeasurementEnd::last_row:
      list.push_back(fmt::format("No failure was found: all rows to the last, {}, are used.", last));
      break;
  }
  list.push_back(
      fmt::format("The noise of one force reading is {}; a fall within one step counts as a drop from {} on, at which "
                  "a test of this length "
                  "without slips would show {:g} drops on average.",
                  print.force(analysis.force_noise), print.own(analysis.drops.smallest_fall, kind::force),
                  test.provenance.options.drops.false_alarms_per_test));
  if (fit.model != ProfileModel::constant)
    list.push_back(
        fmt::format("{} tell of friction. Readings one row apart err with a correlation of {:.2f}, as found.",
                    counted(fit.readings, "reading", "readings"), fit.noise_correlation));
  if (fit.model == ProfileModel::roughness)
    list.emplace_back(
        "Friction is a mean, perhaps with a drift and a wave, and a random process along the fibre about it. The "
        "answer "
        "is an average over how smooth that process may be and over the waves that may be there, by their evidence.");
  list.emplace_back(
      "The specimen is a slender, straight, elastic, inextensible beam that slides over both supports alike; its "
      "section does not change along it.");
  const Supports& supports = analysis.rig.fibre.supports();
  list.push_back(fmt::format(
      "The supports are {}, and friction acts {}.",
      supports.radius > 0 ? fmt::format("rollers of a radius of {}", print.length(supports.radius)) : "sharp edges",
      supports.half_depth > 0
          ? fmt::format("at the surface of the specimen, {} from its axis", print.length(supports.half_depth))
          : "at the axis of the specimen, as if it had no thickness"));
  return list;
}

}  // namespace flexslip
