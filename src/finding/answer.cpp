#include "finding/answer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "finding/digits.h"
#include "finding/fit_findings.h"
#include "finding/printed.h"
#include "inference/process_mode.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

const Finding* finding_in(const std::vector<Finding>& findings, std::string_view code) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& each) { return each.code == code; });
  return found == findings.end() ? nullptr : &*found;
}

std::size_t drops_of(T test) { return test.analysis.drops.drops.size(); }

bool may_be_cracks(T test) { return drops_of(test) > 0 && test.judgement->drops != CrackVerdict::not_by_cracks_alone; }

bool has_reload(T test) { return test.judgement && std::isfinite(test.judgement->loss); }

// [1] Of the bending stiffness, what the rises say is lost; NaN where they are not judged.
double lost_by_rises(const SlipOrCrack& rises) {
  if (!rises.judged) return NAN;
  const auto& best = std::min({rises.cracks, rises.cracks_constant, rises.cracks_running},
                              [](const auto& a, const auto& b) { return a.bic < b.bic; });
  return 1 - best.left;
}

// ---- The verdict

std::string work_in_short(T test) {
  const double share = test.analysis.energy.friction_share;
  constexpr double worth_saying = 0.005;
  if (test.analysis.fit.mu0_is_bound || !(share > worth_saying)) return "";
  return fmt::format("{} of the work was friction, not toughness", percent(share));
}

Verdict verdict_of(T test, const std::vector<Finding>& findings) {
  if (const Finding* wrong = finding_in(findings, "wrong_stiffness"))
    return {VerdictCode::check_input, {wrong->sentence}, wrong->code};
  if (!is_fitted(test)) {
    const Finding& reason = findings.front();
    return {VerdictCode::no_answer, {reason.sentence}, reason.code};
  }
  const Judgement& judgement = *test.judgement;
  const std::string drops = counted(drops_of(test), "drop", "drops");
  if (lost_stiffness(judgement)) {
    const Finding* softer = finding_in(findings, "softer_reload");
    if (!softer) softer = finding_in(findings, "changed_reload");
    if (softer) return {VerdictCode::crack, {softer->sentence, "no friction can be read off"}, softer->code};
    std::vector<std::string> parts{judgement.impossible == 0 ? drops
                                   : judgement.impossible == drops_of(test)
                                       ? fmt::format("{}, none of them a slip", drops)
                                       : fmt::format("{}, {} of them no slip", drops, judgement.impossible)};
    constexpr double worth_saying = 0.03;
    if (const double lost = lost_by_rises(test.analysis.slip_or_crack); lost > worth_saying)
      parts.push_back(fmt::format("the stiffness falls by about {}", percent(lost)));
    parts.emplace_back("no friction can be read off");
    return {VerdictCode::crack, parts, "cracks"};
  }
  if (const Finding* impossible = finding_in(findings, "most_drops_impossible"))
    return {VerdictCode::check_input, {impossible->sentence}, impossible->code};
  if (const Finding* none = finding_in(findings, "no_sliding"))
    return {VerdictCode::no_answer, {none->sentence}, none->code};
  const FrictionFit& fit = test.analysis.fit;
  const std::string friction = fmt::format("friction {}{}", mean_friction(fit), fit.mu0_is_bound ? " (95 %)" : "");
  const std::string work = work_in_short(test);
  Verdict verdict{VerdictCode::undecided, {}};
  if (drops_of(test) == 0) {
    verdict = {VerdictCode::no_drops, {friction}};
  } else if (judgement.drops == CrackVerdict::not_by_cracks_alone && judgement.impossible == 0) {
    verdict = {VerdictCode::slip, {friction}};
  } else {
    const Finding* undecided = finding_in(findings, "undecided_drops");
    return {VerdictCode::undecided,
            {friction + " if the drops are slips", drops},
            undecided ? undecided->code : std::string_view()};
  }
  if (!work.empty()) verdict.parts.push_back(work);
  return verdict;
}

// ---- The rows

// What was done to the record: rows used, where the specimen broke, readings left out.
std::string rows_in_words(T test) {
  const Measurement& measurement = test.measurement;
  const std::size_t last = last_row(test);
  std::string words = fmt::format("rows {}–{}", file_row(test, 0), last);
  if (last < measurement.rows) words += fmt::format(" of {}", measurement.rows);
  const Sampling& sampling = measurement.sampling;
  if (const std::size_t out = sampling.repeated + sampling.held + sampling.interpolated; out > 0)
    words += fmt::format(" ({} repeated or held left out)", out);
  if (sampling.stride > 1) words += fmt::format(", one in {}", sampling.stride);
  switch (measurement.end) {
    case MeasurementEnd::failure:
      return words + fmt::format("; it broke after row {}", last);
    case MeasurementEnd::until:
      return words + " (until, as stated)";
    case MeasurementEnd::turn:
      return words + "; then the stage turns back";
    case MeasurementEnd::last_row:
      break;
  }
  return words;
}

std::string drops_in_words(T test) {
  const TestAnalysis& analysis = test.analysis;
  const std::string rows = rows_in_words(test);
  const bool was_sought = is_fitted(test) || analysis.status == AnalysisStatus::not_explained;
  if (!was_sought) return fmt::format("not looked for in {}", rows);
  const std::size_t semicolon = std::min(rows.find(';'), rows.size());
  const std::string used = rows.substr(0, semicolon), end = rows.substr(semicolon);
  if (drops_of(test) == 0)
    return fmt::format("none in {}; one of {} would have been seen{}", used,
                       Print(test).own(analysis.drops.smallest_fall, kind::force), end);
  const SlipSummary& slips = analysis.slip_summary;
  constexpr std::size_t enough = 3;  // to speak of a spacing
  const bool has_spacing = is_fitted(test) && slips.count >= enough && !lost_stiffness(*test.judgement);
  return fmt::format(
      "{} in {}, the largest {}{}{}", drops_of(test), used, Print(test).own(largest_drop(analysis), kind::force),
      has_spacing
          ? fmt::format(", one per {} of the specimen",
                        roughly(analysis.scales.physical_length(slips.median_spacing), Print(test).as(kind::length)))
          : "",
      end);
}

std::string slip_or_crack_in_words(T test) {
  const TestAnalysis& analysis = test.analysis;
  const Judgement& judgement = *test.judgement;
  const SlipOrCrack& rises = analysis.slip_or_crack;
  const std::size_t drops = drops_of(test), possible = drops - judgement.impossible;
  const std::string slips = judgement.impossible == 0
                                ? (drops == 1   ? std::string("the drop can be a slip")
                                   : drops == 2 ? std::string("both drops can be slips")
                                                : fmt::format("all {} drops can be slips", drops))
                                : fmt::format("{} of {} drops can be slips",
                                              possible == 0 ? std::string("none") : fmt::format("{}", possible), drops);
  const std::string stiffer = fmt::format("{} of {} rises between them grow stiffer", rises.stiffer_rises, rises.rises);
  switch (judgement.drops) {
    case CrackVerdict::not_by_cracks_alone:
      return rises.verdict == CrackVerdict::not_by_cracks_alone
                 ? fmt::format("cracks alone cannot make these drops: {}; {}", stiffer, slips)
                 : fmt::format("cracks alone would need {} of the stiffness, and the reload lost {:.1f} ± {:.1f} %; {}",
                               percent(judgement.loss_needed), 100 * judgement.loss, 100 * judgement.loss_error, slips);
    case CrackVerdict::cracks: {
      const double lost = lost_by_rises(rises);
      return fmt::format("{}{}; {}",
                         judgement.softer_reload ? "a reload shows lost stiffness"
                                                 : "the force rises between the drops as that of cracks",
                         lost > 0 ? fmt::format(", which take about {} of the stiffness", percent(lost)) : "", slips);
    }
    case CrackVerdict::cannot_be_told:
      break;
  }
  return rises.judged
             ? fmt::format("how the force rises between the drops does not tell: {} of {} rises grow stiffer; {}",
                           rises.stiffer_rises, rises.rises, slips)
             : fmt::format("too few drops, or rows between them, to tell; {}", slips);
}

std::string friction_in_words(T test) {
  const FrictionFit& fit = test.analysis.fit;
  if (lost_stiffness(*test.judgement)) return "none can be read off a specimen that loses stiffness";
  if (fit.mu0_is_bound) return fmt::format("{} (95 %); it cannot be distinguished from zero", mean_friction(fit));
  const double slid = 0.5 * (fit.S_end - fit.S_begin);
  std::string words = fmt::format("{} averaged over the {} that slid over each support", mean_friction(fit),
                                  roughly(test.analysis.scales.physical_length(slid), Print(test).as(kind::length)));
  if (drops_of(test) > 0 && !has_reload(test)) words += ", if no stiffness was lost";
  const FrictionRead& read = test.analysis.friction_read;
  if (std::isfinite(read.median)) words += fmt::format("; {:.2f} to {:.2f} along it", read.low80, read.high80);
  const bool has_wave = fit.wave_claimed && !fit.waves.empty();
  if (has_wave)
    words += fmt::format("; it repeats every {}",
                         roughly(test.analysis.scales.physical_length(fit.waves.front().wavelength.value),
                                 Print(test).as(kind::length)));
  else if (fit.model == ProfileModel::roughness)
    words += "; no regular spacing";
  return words;
}

std::string work_in_words(T test) {
  const MeasuredEnergy& energy = test.analysis.energy;
  const Print print(test);
  return fmt::format("{} of {} ({}) went into friction{}", print.energy(energy.account.friction + energy.account.snaps),
                     print.energy(energy.work_of_fracture), percent(energy.friction_share),
                     may_be_cracks(test) ? " if the drops are slips" : "");
}

std::string_view source_of(StiffnessSource source) {
  switch (source) {
    case StiffnessSource::initial_slope:
      return "initial slope";
    case StiffnessSource::mirror:
      return "loops";
    default:
      return "stated";
  }
}

std::string stiffness_in_words(T test, bool tells) {
  const TestAnalysis& analysis = test.analysis;
  const Print print(test);
  const double EI = analysis.scales.bending_stiffness();
  const Kind stiffness = print.as(kind::bending_stiffness);
  const std::string beforehand =
      fmt::format("{}: {}", source_of(test.stiffness), readable(EI, EI * analysis.bending_stiffness_error, stiffness));
  if (!tells) return "EI " + beforehand;
  const Estimate& fitted = analysis.fit.bending_stiffness;
  std::string words =
      fmt::format("EI {} ({})", readable(EI * fitted.value, EI * fitted.standard_error, stiffness), beforehand);
  if (test.section_moment)
    words +=
        fmt::format(", E {}", readable(EI * fitted.value / *test.section_moment,
                                       EI * fitted.standard_error / *test.section_moment, print.as(kind::pressure)));
  const double curvature = greatest_curvature(analysis.profile_at_fit, analysis.rig.fibre);
  if (test.surface && std::isfinite(curvature)) {
    const double strain = test.surface->strain(curvature);
    words += fmt::format("; strain up to {:.2g} %", 100 * strain);
    if (test.strain_at_break && strain > *test.strain_at_break)
      words += fmt::format(", beyond the {:.2g} % at which it should break", 100 * *test.strain_at_break);
    if (curvature > test.nose_curvature) words += "; it wrapped the nose";
  }
  return words;
}

// What a reload and the loops say beside the first loading; empty where the specimen was loaded once.
std::string reload_in_words(T test) {
  if (!test.cycles) return "";
  const CyclicFriction& friction = test.cycles->friction;
  std::vector<std::string> parts;
  if (friction.status == CyclesStatus::ok) {
    const auto [in, out, rms] = direction_means(friction);
    parts.push_back(fmt::format("friction {:.2g} sliding in and {:.2g} sliding out{}", in, out,
                                is_beyond_friction(friction) ? ", which differ by more than friction can" : ""));
  }
  if (has_reload(test))
    parts.push_back(fmt::format("the last reload is {:.1f} ± {:.1f} % {}", 100 * std::abs(test.judgement->loss),
                                100 * test.judgement->loss_error, test.judgement->loss > 0 ? "softer" : "stiffer"));
  return fmt::format("{}{}{}", counted(test.cycles->stiffness.size(), "loading", "loadings"), parts.empty() ? "" : ": ",
                     fmt::join(parts, "; "));
}

std::string assumed_in_words(T test) {
  const Supports& supports = test.analysis.rig.fibre.supports();
  const Measurement& measurement = test.measurement;
  const Print print(test);
  std::vector<std::string> parts{supports.radius > 0 ? "rollers of radius " + print.length(supports.radius)
                                                     : "knife edges"};
  if (supports.half_depth == 0) parts.emplace_back("no thickness");
  if (test.stiffness != StiffnessSource::stated)
    parts.push_back(fmt::format("EI to {:.2g} %", 100 * test.analysis.bending_stiffness_error));
  parts.push_back(measurement.contact == ContactSource::first_point
                      ? "contact at the zero of the file"
                      : fmt::format("contact at {}, as {}", print.own(measurement.contact_offset, kind::length),
                                    measurement.contact == ContactSource::stated ? "stated" : "found"));
  parts.emplace_back("a slender, straight, elastic beam");
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::vector<AnswerRow> rows_of(T test, Standing standing) {
  std::vector<AnswerRow> rows{{"drops", drops_in_words(test)}};
  const bool tells = is_fitted(test) && (is_trusted(standing) || lost_stiffness(*test.judgement));
  if (tells) {
    if (drops_of(test) > 0) rows.push_back({"slip or crack", slip_or_crack_in_words(test)});
    rows.push_back({"friction", friction_in_words(test)});
    if (!lost_stiffness(*test.judgement) && !test.analysis.fit.mu0_is_bound)
      rows.push_back({"work", work_in_words(test)});
    if (const std::string reload = reload_in_words(test); !reload.empty()) rows.push_back({"reload", reload});
  }
  rows.push_back({"stiffness", stiffness_in_words(test, tells && !lost_stiffness(*test.judgement))});
  rows.push_back({"assumed", assumed_in_words(test)});
  return rows;
}

// The remedy of what the verdict rests on; else of the weightiest note. What speaks against an answer has its remedy beside it.
std::string next_step(const Verdict& verdict, const std::vector<Finding>& findings) {
  if (const Finding* told = finding_in(findings, verdict.finding); told && !told->remedy.empty()) return told->remedy;
  for (const Finding& finding : findings)
    if (finding.severity == Severity::note && !finding.remedy.empty()) return finding.remedy;
  return "";
}

}  // namespace

std::string mean_friction(const FrictionFit& fit) {
  return fit.mu0_is_bound ? fmt::format("at most {}", significant(fit.mu0.high, 2))
                          : readable(fit.mu0.value, fit.mu0.standard_error, kind::number);
}

double largest_drop(const TestAnalysis& analysis) {
  double largest = 0;
  for (const Drop& drop : analysis.drops.drops) largest = std::max(largest, drop.force_fall);
  return largest;
}

Answer answer_of(T test) {
  std::vector<Finding> findings = findings_of(test);
  Verdict verdict = verdict_of(test, findings);
  const Standing standing = standing_of(findings);
  std::string next = next_step(verdict, findings);
  return {std::move(verdict), standing, rows_of(test, standing), std::move(findings), std::move(next)};
}

}  // namespace flexslip
