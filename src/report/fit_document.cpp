#include "report/fit_document.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answers/fit_fields.h"
#include "finding/answer.h"
#include "finding/printed.h"
#include "inference/process_search.h"
#include "io/text_table.h"
#include "report/cycles_document.h"
#include "report/fit_figures.h"
#include "report/modulus_document.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

Pictures picture(Plot (*drawn)(T), T test) {
  return {[drawn, &test] { return std::vector{drawn(test)}; }};
}

// ---- The screen

std::string_view colour_of(VerdictCode code) {
  switch (code) {
    case VerdictCode::slip:
    case VerdictCode::no_drops:
      return "\x1b[1;32m";
    case VerdictCode::undecided:
      return "\x1b[1;33m";
    default:
      return "\x1b[1;31m";
  }
}

std::string coloured(std::string line, const std::string& name, const Verdict& verdict) {
  constexpr std::string_view bold = "\x1b[1m", plain = "\x1b[0m";
  const std::string_view word = word_of(verdict.code);
  if (const auto at = line.find(word, name.size()); at != std::string::npos)
    line.replace(at, word.size(), fmt::format("{}{}{}", colour_of(verdict.code), word, plain));
  return fmt::format("{}{}{}{}", bold, name, plain, line.substr(name.size()));
}

std::string with_remedy(const Finding& finding) {
  return finding.sentence + (finding.remedy.empty() ? "" : " " + finding.remedy);
}

// ---- Parameters

class Parameters {
 public:
  explicit Parameters(T test) : print_(test) {}

  PrintedTable table{{"Parameter", "", "Value", "95 % interval", "Remark"}, {}};

  // An estimate in reduced variables.
  void add(std::string name, std::string meaning, const Estimate& estimate, double unit, const Kind& reduced_kind,
           std::string remark = "") {
    const Kind kind = print_.as(reduced_kind);
    std::string interval;
    if (std::isfinite(estimate.standard_error)) {
      const auto shown = best_unit(unit * std::max(std::abs(estimate.value), estimate.standard_error), kind);
      const MatchedDigits digits = matched_digits(estimate, shown.empty() ? unit : from_si(unit, parse_unit(shown)));
      if (!digits.low.empty())
        interval = fmt::format("{} to {}{}{}", digits.low, digits.high, shown.empty() ? "" : " ", typeset(shown));
    } else {
      remark = "error not known: the curve hardly depends on it";
    }
    table.rows.push_back({std::move(name), std::move(meaning),
                          readable(unit * estimate.value, unit * estimate.standard_error, kind), std::move(interval),
                          std::move(remark)});
  }

 private:
  Print print_;
};

void add_wave(Parameters& parameters, T test, std::size_t i) {
  const WaveEstimate& wave = test.analysis.fit.waves[i];
  const double span = test.analysis.scales.span();
  const std::string suffix = i == 0 ? "" : fmt::format("_{}", i + 1);
  const std::string which = i == 0 ? "" : fmt::format(" of wave {}", i + 1);
  const auto is_determined = [](const Estimate& phase) {  // else it turns with the wavelength
    return phase.high - phase.low <= 2 * std::numbers::pi;
  };
  parameters.add("amplitude" + suffix, "A, relative to μ₀" + which, wave.amplitude, 1, kind::number);
  parameters.add("wavelength" + suffix, "λ along the specimen" + which, wave.wavelength, span, kind::length);
  if (is_determined(wave.phase_at_middle))
    parameters.add("phase_at_middle" + suffix, "phase in the middle of the specimen seen" + which, wave.phase_at_middle,
                   1, kind::angle);
  if (is_determined(wave.phase))
    parameters.add("phase" + suffix, "φ at the length 0, equation (4.25)" + which, wave.phase, 1, kind::angle);
}

PrintedTable parameter_table(T test) {
  const auto& scales = test.analysis.scales;
  const auto& fit = test.analysis.fit;
  const bool is_constant = fit.model == ProfileModel::constant;
  const double EI = scales.bending_stiffness();
  Parameters parameters(test);
  auto& rows = parameters.table.rows;
  parameters.add("mu0", "μ₀, mean friction over the specimen seen", fit.mu0, 1, kind::number);
  if (fit.mu0_is_bound) {
    rows.back()[2] = mean_friction(fit);
    rows.back()[4] = "cannot be distinguished from zero";
  }
  if (!is_constant) {
    parameters.add("drift", "dμ/dS, slope of the mean along the length", fit.drift, 1 / scales.span(),
                   kind::inverse_length);
    rows.push_back({"reference", "length at which mu0 and drift hold", Print(test).length(fit.S_middle), "", ""});
  }
  if (fit.model == ProfileModel::roughness) {
    const double none = weight_without_roughness(fit);
    parameters.add("roughness", "σ, standard deviation of μ about its mean", fit.roughness, 1, kind::number,
                   none > 0.5 ? fmt::format("if there is any: the evidence favours none ({})", percent(none)) : "");
    parameters.add("correlation_length", "ℓ of the roughness along the specimen", fit.length, scales.span(),
                   kind::length);
  }
  if (fit.wave_claimed)
    for (std::size_t i = 0; i < fit.waves.size(); ++i) add_wave(parameters, test, i);
  parameters.add(
      "bending_stiffness", "EI of the specimen", fit.bending_stiffness, EI, kind::bending_stiffness,
      is_constant ? "not fitted: with constant friction, roughness would distort it"
                  : fmt::format("{} from that beforehand, ± {:.1f} %", signed_percent(fit.bending_stiffness.value - 1),
                                100 * test.analysis.bending_stiffness_error));
  if (test.section_moment && !test.reduced)
    parameters.add("modulus", "E, flexural modulus, EI/I", fit.bending_stiffness, EI / *test.section_moment,
                   kind::pressure);
  if (!is_constant)
    parameters.add("force_noise", "standard deviation of a force reading", fit.noise, scales.physical_force(1),
                   kind::force);
  return parameters.table;
}

// ---- Friction, and whether it repeats

// What a reader of numbers should know that are given all the same; empty where there is nothing.
std::string caution_of(T test, const Answer& answer) {
  if (lost_stiffness(*test.judgement))
    return "The numbers below assume that the specimen kept its stiffness; the record speaks against that.";
  return is_trusted(answer.standing)
             ? ""
             : "The fit is not to be used: it tells no friction. What is drawn of it shows where it fails.";
}

// Where μ₀ lies to what the literature gives.
std::string in_literature(T test) {
  const auto& [value, error, low, high] = test.analysis.fit.mu0;
  if (!test.materials) return "state [specimen] material and [rig] support_material to compare friction with it";
  const auto known = literature_of(test);
  if (!known) return fmt::format("nothing about {} on {}", test.materials->specimen, test.materials->support);
  const std::string range =
      known->low < known->high ? fmt::format("{:g} to {:g}", known->low, known->high) : fmt::format("{:g}", known->low);
  const std::string source = fmt::format("{} for {} on {} ({})", range, known->specimen, known->support, known->source);
  if (test.analysis.fit.mu0_is_bound) return source + (high < known->low ? "; friction is below it" : "");
  if (value >= known->low && value <= known->high) return source + "; friction is within it";
  const double away = value < known->low ? known->low - value : value - known->high;
  return fmt::format("{}; friction {} it{}", source,
                     low <= known->high && high >= known->low ? "agrees with"
                     : value < known->low                     ? "is below"
                                                              : "is above",
                     error > 0 ? fmt::format(", {:.1f} standard errors away", away / error) : "");
}

Chapter friction_chapter(T test, const Answer& answer) {
  const std::string caution = caution_of(test, answer);
  if (!is_trusted(answer.standing)) return {"Friction", {caution}};
  const TestAnalysis& analysis = test.analysis;
  const double curvature = greatest_curvature(analysis.profile_at_fit, analysis.rig.fibre);
  const bool has_stress = test.surface && std::isfinite(curvature) && !test.reduced;
  return {"Friction",
          {caution, parameter_table(test),
           Rows{{"model", analysis.fit.model == ProfileModel::roughness
                              ? "roughness: a mean, perhaps with a drift and a wave, plus a random process along the "
                                "specimen, averaged over how smooth it may be and which waves there may be"
                              : fmt::format("{}, the paper's", name_of(analysis.fit.model))},
                {"read off", fmt::format("median {:.2f}, point by point at the bending stiffness of the fit",
                                         analysis.friction_read.median)},
                {"literature", in_literature(test)},
                {"stress", has_stress ? fmt::format("up to {} at the surface, at the modulus of the fit",
                                                    Print(test).own(test.surface->stress(curvature), kind::pressure))
                                      : ""},
                {"nose", curvature > test.nose_curvature ? "friction is read as if it were sharp" : ""}}}};
}

std::string wave_in_words(T test) {
  const FrictionFit& fit = test.analysis.fit;
  if (fit.model == ProfileModel::constant || fit.model == ProfileModel::drift) return "the model has none";
  if (fit.model != ProfileModel::roughness)
    return "the model has no roughness; the model 'roughness' asks whether there is a wave at all";
  if (fit.waves.empty() || !std::isfinite(fit.log_evidence_of_wave)) return "none explains the record better than none";
  const WaveEstimate& wave = fit.waves.front();
  const double span = test.analysis.scales.span();
  return fmt::format(
      "{}, with an amplitude of {} of the mean: {}",
      readable(span * wave.wavelength.value, span * wave.wavelength.standard_error, Print(test).as(kind::length)),
      readable(wave.amplitude.value, wave.amplitude.standard_error, kind::number),
      fit.wave_claimed                           ? "claimed"
      : fit.log_evidence_of_wave > claiming_gain ? "longer than a quarter of the length that slid, "
                                                   "too few periods for a claim"
                                                 : "only indicative");
}

std::string one_side_in_words(T test) {
  std::string twice;
  for (const auto& [name, value] : lengths_of(test.analysis.fit))
    twice += fmt::format("{}a {} of {}", twice.empty() ? "" : ", ",
                         name == "wavelength" ? "wavelength" : "correlation length",
                         Print(test).length(one_side_at_a_time * value));
  if (twice.empty()) return "";
  return fmt::format(
      "up to twice these lengths ({}), and the friction of the weaker side, where the supports are not alike or "
      "friction "
      "falls; images of both supports tell, or the specimen tested again, turned end for end",
      twice);
}

// The surface that would explain the friction, and a trace that it was held against.
Rows surface_rows(T test) {
  if (!test.implied) return {};
  const ImpliedSurface& implied = *test.implied;
  const FrictionFit& fit = test.analysis.fit;
  const double unit = test.analysis.scales.span();
  const Kind length = Print(test).as(kind::length);
  const auto shown = [&](const Estimate& estimate, double factor, const Kind& kind) {
    return readable(factor * estimate.value, factor * estimate.standard_error, kind);
  };
  Rows rows;
  if (!fit.waves.empty()) {
    const WaveEstimate& wave = fit.waves.front();
    const WantedImage wanted = wanted_image(unit * wave.wavelength.value, 2 * unit * wave.height.value);
    rows.push_back({"surface wave", fmt::format("{} high (half of crest to trough) would explain the wave of friction; "
                                                "images with pixels of {} in a field of {} show it (the paper's rule: "
                                                "ten pixels from crest to trough, ten waves in the field)",
                                                shown(wave.height, unit, length), readable(wanted.pixel, length),
                                                readable(wanted.field, length))});
  }
  rows.push_back(
      {"surface", fmt::format("slopes of {} rms and heights of {} rms, of waves up to {}, would explain all "
                              "of the variation, on a friction of {} where it is flat{}",
                              shown(implied.rms_slope, 1, kind::number), shown(implied.rms_height, unit, length),
                              readable(unit * implied.longest, length), significant(implied.base, 3),
                              test.cycles ? "; slopes make friction high in one direction where it is low in "
                                            "the other"
                                          : "")});
  if (!test.held) return rows;
  const HeldSurface& held = *test.held;
  const Placement& placement = held.placement;
  constexpr double by_chance = 0.05;
  std::string seen = "only noise";
  if (!held.texture.drowned) {
    seen = fmt::format("slopes of {} rms over wavelengths of {} to {}", shown(held.texture.rms_slope, 1, kind::number),
                       readable(held.texture.shortest, length), readable(held.texture.longest, length));
    if (!held.texture.waves.empty())
      seen += fmt::format("; its highest wave is {} high and {} long",
                          shown(held.texture.waves.front().amplitude, 1, length),
                          shown(held.texture.waves.front().wavelength, 1, length));
    if (held.wave)
      seen += fmt::format("; a wave as long as that of friction shows from {} on",
                          readable(held.wave->least_by_spectrum, length));
    if (held.wave && held.pixel > 0)
      seen += fmt::format(", and by the paper's rule, with pixels of {}, from {} on", readable(held.pixel, length),
                          readable(held.wave->least_by_pixels, length));
  }
  rows.push_back({"trace", fmt::format("{}: {}", held.file, seen)});
  rows.push_back(
      {"place",
       fmt::format("{} (correlation {}, p = {} over {} places)",
                   placement.p_value > by_chance
                       ? "none along the trace fits the friction better than chance"
                       : fmt::format("the support stood at {} of the trace at first{}", readable(held.begin, length),
                                     placement.turned ? ", the trace reversed" : ""),
                   significant(placement.correlation, 2), significant(placement.p_value, 2), placement.places)});
  return rows;
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

// What the answer averages over, the likeliest first.
PrintedTable explanation_table(T test) {
  PrintedTable table{{"Roughness", "Wave", "Weight", "ln evidence minus the best"}, {}};
  const auto& explanations = test.analysis.fit.explanations;
  if (explanations.size() < 2) return table;
  for (std::size_t i = 0; i < std::min(listed_explanations, explanations.size()); ++i) {
    const auto& each = explanations[i];
    std::string waves;
    for (const double wavelength : each.wavelengths)
      waves += (waves.empty() ? "" : ", ") + Print(test).length(wavelength);
    table.rows.push_back({std::string(in_words(each.kernel)), waves.empty() ? "none" : waves,
                          each.weight < 0.0005 ? "< 0.1 %" : percent_of(each.weight, 1),
                          fmt::format("{:.1f}", each.log_evidence - explanations.front().log_evidence)});
  }
  return table;
}

Chapter wave_chapter(T test) {
  const double evidence = test.analysis.fit.log_evidence_of_wave;
  Rows rows{{"wave", wave_in_words(test)},
            {"evidence", std::isfinite(evidence)
                             ? fmt::format("ln B = {:.1f}; a wave is claimed above {}", evidence, claiming_gain)
                             : ""},
            {"one side", one_side_in_words(test)},
            {"build-up", smoothing_in_words(test)}};
  for (AnswerRow& row : surface_rows(test)) rows.push_back(std::move(row));
  Chapter chapter{"Does it repeat along the specimen?", {rows}};
  if (has_waves(test)) chapter.blocks.emplace_back(picture(wavelength_figure, test));
  chapter.blocks.emplace_back(explanation_table(test));
  return chapter;
}

// ---- Checks

Chapter checks_chapter(T test, const Answer& answer) {
  Rows rows;
  for (const Finding& finding : answer.findings)
    rows.push_back({std::string(name_of(finding.severity)), with_remedy(finding)});
  if (!is_fitted(test)) return {"What was checked", {rows}};
  const TestAnalysis& analysis = test.analysis;
  const auto& report = analysis.suspects;
  rows.push_back(
      {"too much", fmt::format("{} of {} past a deflection of a tenth of the span {} friction above {:g} at "
                               "the bending stiffness beforehand, {} of them by more than twice the "
                               "standard error; 5 % make a test suspect",
                               report.points.size(), counted(report.points_judged, "point", "points"),
                               report.points.size() == 1 ? "needs" : "need", report.limit, report.beyond_error)});
  rows.push_back({"above the line", fmt::format("{} above the Euler–Bernoulli line, the paper's criterion; friction "
                                                "alone lifts a sound curve above it, by 5 % at μ = 0.6",
                                                counted(report.above_euler_bernoulli, "point", "points"))});
  if (!is_trusted(answer.standing)) return {"What was checked", {rows}};
  constexpr double rounding = 1e-9;  // of the greatest force of some 10 EI/L^2
  const double rms = analysis.replay.residual_rms;
  const std::size_t drops = analysis.drops.drops.size();
  rows.push_back({"replay", fmt::format("the friction read off, run forward as a table, gives the force {}{}",
                                        rms < rounding ? "exactly" : fmt::format("to {} rms", Print(test).force(rms)),
                                        drops == 0 ? ""
                                                   : fmt::format(", and {} of {}", analysis.replay.drops_reproduced,
                                                                 counted(drops, "drop", "drops")))});
  return {"What was checked", {rows}};
}

// ---- Drops

PrintedTable drop_table(T test) {
  return shown(fit_fields(), test, frame_of(test), "drops",
               {{.heading = "Rows", .field = "row_before", .last = "row_after"},
                {"Stage", "stage"},
                {"Force before", "force_before"},
                {"Fall", "force_fall", 3},
                {"in noise (σ)", "significance", 3},
                {"Pulled in (both supports)", "pulled_in", 3},
                {"μ before", "mu_before", 3},
                {"μ after", "mu_after", 3},
                {"Reading", "reading"}});
}

Chapter drops_chapter(T test, const Answer& answer) {
  const TestAnalysis& analysis = test.analysis;
  const SlipSummary& slips = analysis.slip_summary;
  const SlipOrCrack& rises = analysis.slip_or_crack;
  const Print print(test);
  const auto spacing = [&](double value) {
    return roughly(analysis.scales.physical_length(value), print.as(kind::length));
  };
  Rows rows{
      {"limit", fmt::format("a fall of {} within one step counts as a drop (noise of a reading: {}); a test of "
                            "this length without slips would show {:g} such drops",
                            print.own(analysis.drops.smallest_fall, kind::force), print.force(analysis.force_noise),
                            test.provenance.options.drops.false_alarms_per_test)}};
  if (is_trusted(answer.standing) && slips.count > 0) {
    rows.push_back(
        {"fall", fmt::format("friction falls by {:.3f} in a slip (median of {})", slips.median_fall, slips.count)});
    if (slips.count >= 2)
      rows.push_back(
          {"spacing", fmt::format("{} of the specimen from the start of one slip to that of the next (median; "
                                  "mean {}), without a model of friction along it",
                                  spacing(slips.median_spacing), spacing(slips.mean_spacing))});
  }
  if (rises.judged)
    rows.push_back(
        {"cracks or slips", fmt::format("D* = {:.1f} (BIC of the best cracks less that of the best slips; cracks "
                                        "alone are ruled out above {:g} where most rises grow stiffer)",
                                        rises.margin, cracks_ruled_out)});
  return {"Drops", {rows, drop_table(test)}};
}

Chapter snaps_chapter(T test) {
  const std::size_t snaps = test.analysis.model.snaps.size(), drops = test.analysis.drops.drops.size();
  if (snaps + drops == 0) return {};
  return {"Snaps of the fit's mean",
          {Rows{{"snaps", fmt::format("{}, where the force drops {}{}", snaps,
                                      drops == 1 ? "once" : fmt::format("{} times", drops),
                                      snaps < drops ? ": not every drop is a snap, and a mean is smoother than any one "
                                                      "profile"
                                                    : "")}},
           shown(fit_fields(), test, frame_of(test), "snaps",
                 {{"Stage", "stage"},
                  {"Deflection before", "deflection_before"},
                  {"after", "deflection_after"},
                  {"Force before", "force_before"},
                  {"after", "force_after"},
                  {"Length before", "length_before"},
                  {"after", "length_after"}})}};
}

// ---- Stick or slide between the drops

// Friction that builds up looks like sliding of one that is there at once.
std::string slow_friction_in_words(T test, std::size_t sliding) {
  constexpr double recovered = 3;  // of its lengths, after which 95 % of a change are there
  if (sliding == 0) return "";
  const auto& build_up = test.cycles ? test.cycles->build_up : std::nullopt;
  if (!build_up)
    return "friction that builds up over a length of sliding also imitates sliding, in rises that pull in less than "
           "three such lengths; a reversal would show it";
  if (!build_up->is_told()) return "";
  const auto& teeth = test.analysis.teeth->teeth;
  const double least = recovered * build_up->length.value;
  const auto near = std::count_if(teeth.begin(), teeth.end(), [&](const Tooth& tooth) {
    return tooth.verdict == ToothVerdict::sliding && tooth.advance.value < least;
  });
  return fmt::format(
      "friction builds up after the reversals, and {} of the sliding rises pull in less than {} (three "
      "build-up lengths): they may only creep",
      near, roughly(test.analysis.scales.physical_length(least), Print(test).as(kind::length)));
}

// Supports that yield look like sliding, too.
std::string soft_supports_in_words(T test) {
  const Teeth& judged = *test.analysis.teeth;
  const SupportCompliance& compliance = judged.compliance;
  if (compliance.status != ComplianceStatus::ok) return "imitate sliding; these teeth do not show how much they yield";
  const double error = std::hypot(compliance.estimate.standard_error, compliance.systematic);
  const double unit = test.reduced ? 1 : 1 / test.analysis.scales.stiffness_unit();
  const auto rejected = std::count_if(judged.teeth.begin(), judged.teeth.end(),
                                      [](const Tooth& tooth) { return tooth.compliant_rejected; });
  const std::string p = compliance.p_value < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", compliance.p_value);
  return fmt::format(
      "imitate sliding: a stuck specimen on supports with one compliance of {} (both together) {} ({}; rejected by {} "
      "of {} at {:.4g} %)",
      readable(unit * compliance.estimate.value, unit * error,
               test.reduced ? kind::number : Print(test).as(kind::compliance)),
      compliance.p_value >= 1 - tooth_confidence ? "explains all rises; compare it with that of the rig"
                                                 : "does not explain the rises",
      p, rejected, judged.teeth.size(), 100 * tooth_confidence);
}

Chapter teeth_chapter(T test) {
  const std::string title = "Stick or slide";
  if (!test.analysis.teeth)
    return {title, {Rows{{"rises", "none to judge: fewer than two drops, or no load train is stated"}}}};
  const Teeth& judged = *test.analysis.teeth;
  const auto count = [&](ToothVerdict verdict) {
    return static_cast<std::size_t>(std::count_if(judged.teeth.begin(), judged.teeth.end(),
                                                  [&](const Tooth& tooth) { return tooth.verdict == verdict; }));
  };
  const std::size_t sliding = count(ToothVerdict::sliding);
  Rows rows{{"rises", fmt::format("{} between drops are judged; {} are too short, and no friction explains {}",
                                  judged.teeth.size(), judged.too_short, judged.unexplained)}};
  if (!judged.teeth.empty()) {
    rows.push_back({"verdicts", fmt::format("{} slide, {} are as if stuck, and {} are undecided, each at {:.4g} %; if "
                                            "all were stuck, up to {:.2g} would appear to slide by chance",
                                            sliding, count(ToothVerdict::as_if_stuck), count(ToothVerdict::undecided),
                                            100 * tooth_confidence,
                                            (1 - tooth_confidence) * static_cast<double>(judged.teeth.size()))});
    rows.push_back({"as if stuck", fmt::format("less than {:.0f} % of the stage's motion is pulled in (just after a "
                                               "reversal, where the specimen must stick, the authors' tests show 8 to "
                                               "35 %); it need not be stuck: sliding is as steep where friction rises "
                                               "steeply",
                                               100 * test.provenance.options.teeth.least_share)});
    rows.push_back({"soft supports", soft_supports_in_words(test)});
    rows.push_back({"slow friction", slow_friction_in_words(test, sliding)});
  }
  Chapter chapter{title, {rows}};
  if (has_judged_teeth(test)) chapter.blocks.emplace_back(picture(teeth_figure, test));
  chapter.blocks.emplace_back(shown(fit_fields(), test, frame_of(test), "teeth.teeth",
                                    {{.heading = "Rows", .field = "first_row", .last = "last_row"},
                                     {"Slope", "slope"},
                                     {"if stuck", "stick_slope"},
                                     {"if sliding", "slide_slope"},
                                     {"Position p", "position"},
                                     {"common error", "position_systematic", 2},
                                     {"Pulled in (both supports)", "advance", 3},
                                     {.heading = "Verdict",
                                      .field = "verdict",
                                      .in_words = {{"sliding", "slides"}, {"as_if_stuck", "as if stuck"}}}}));
  return chapter;
}

// ---- Work

Chapter energy_chapter(T test, const Answer& answer) {
  const auto& energy = test.analysis.energy;
  const auto& account = energy.account;
  const std::vector<std::pair<std::string, double>> entries{
      {"Work of the stage", account.stage_work},
      {"stored in bending when the record ends", account.bending},
      {"stored in the load train", account.load_train},
      {"friction while the specimen slides", account.friction},
      {"lost in drops: friction, sound, vibration", account.snaps},
      {"not accounted for: the coarseness of the points", account.imbalance},
      {"Work on the specimen, ∫ F dw", energy.work_of_fracture},
      {"of which friction and drops", account.friction + account.snaps}};
  NumberColumn joules{"", {}, Print(test).as(kind::energy)};
  for (const auto& [name, value] : entries) joules.values.push_back(test.analysis.scales.physical_energy(value));
  PrintedTable table = printed({joules});
  table.head = {"Energy", table.head[0], "share of the stage's work"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    table.rows[i].insert(table.rows[i].begin(), entries[i].first);
    table.rows[i].push_back(percent_of(entries[i].second, account.stage_work));
  }
  table.rows.back().back() = percent_of(entries.back().second, energy.work_of_fracture) + " of that";
  return {test.cycles ? "Where the work of the first loading went" : "Where the work went",
          {caution_of(test, answer), table}};
}

// ---- The record, and where it comes from

Chapter assumption_chapter(T test) {
  const TestAnalysis& analysis = test.analysis;
  const Supports& supports = analysis.rig.fibre.supports();
  const Contact& contact = analysis.contact;
  const Print print(test);
  const bool has_line = test.measurement.contact != ContactSource::found && contact.status == ContactStatus::found;
  return {"What was assumed",
          {Rows{{"beginning",
                 has_line ? fmt::format(
                                "a line through the first part of the curve meets zero force at {} from "
                                "the contact; nothing was corrected",
                                readable(contact.offset.value, contact.offset.standard_error, print.as(kind::length)))
                          : ""},
                {"readings",
                 analysis.fit.model == ProfileModel::constant
                     ? ""
                     : fmt::format("{} tell of friction; errors one row apart have a correlation of {:.2f}, as found",
                                   analysis.fit.readings, analysis.fit.noise_correlation)},
                {"specimen",
                 "slender, straight, elastic and inextensible; its section does not change along it, and it slides "
                 "over both supports alike"},
                {"supports",
                 fmt::format("{}; friction acts {}",
                             supports.radius > 0
                                 ? fmt::format("rollers of a radius of {}{}", print.length(supports.radius),
                                               test.measurement.test.rig->rollers == Rollers::pinned ? ", on pins" : "")
                                 : "sharp edges",
                             supports.half_depth > 0 ? fmt::format("at the surface of the specimen, {} from its axis",
                                                                   print.length(supports.half_depth))
                                                     : "at the axis of the specimen, as if it had no thickness")}}}};
}

Chapter preparation_chapter(T test) {
  return {"From the file to the record", {preparation_rows(test.measurement.preparation)}};
}

Chapter provenance_chapter(T test) {
  const Provenance& provenance = test.provenance;
  PrintedTable files{{"File", "Bytes", "SHA-256"}, {}};
  for (const InputFile& file : provenance.inputs)  // of standard input nothing is known
    files.rows.push_back({file.name, file.sha256.empty() ? "" : fmt::format("{}", file.bytes), file.sha256});
  return {"Provenance",
          {fmt::format("FlexSlip {}. Options: model {}; {:g} false alarms a test; friction suspect above {:g}.",
                       provenance.version, name_of(provenance.options.fit.model),
                       provenance.options.drops.false_alarms_per_test, provenance.options.suspect_limit),
           files, Verbatim{provenance.test}}};
}

}  // namespace

Rows rows_of(const Answer& answer) {
  Rows rows = answer.rows;
  for (const Finding& doubt : doubts_of(answer))
    rows.push_back({std::string(name_of(doubt.severity)), with_remedy(doubt)});
  return rows;
}

std::string last_line_of(const Answer& answer) {
  const std::string checks = checks_in_words(answer), next = next_in_words(answer);
  return checks + (checks.empty() || next.empty() ? "" : " ") + next;
}

std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style) {
  constexpr std::size_t most_doubts = 3;
  const std::string shown_name = printable(name);
  const std::string begin = fmt::format("{}  {}   ", shown_name, word_of(answer.verdict.code));
  const std::string title = wrapped(fmt::format("{}", fmt::join(answer.verdict.parts, " · ")),
                                    std::string(std::min<std::size_t>(width_of(begin), 12), ' '), begin, style.width);
  Rows rows = rows_of(answer);
  const std::size_t doubts = rows.size() - answer.rows.size(), left_out = doubts - std::min(doubts, most_doubts);
  rows.resize(rows.size() - left_out);
  std::string last = last_line_of(answer);
  if (left_out > 0) last = fmt::format("{}: --full. {}", counted(left_out, "more doubt", "more doubts"), last);
  return (style.colour ? coloured(title, shown_name, answer.verdict) : title) + "\n" +
         in_text({{"", {rows, last}}}, style.width);
}

std::vector<Chapter> document_of(const FittedTest& test) {
  const Answer answer = answer_of(test);
  if (!is_fitted(test)) {
    Chapter record{};
    if (test.analysis.status == AnalysisStatus::not_explained) record.blocks.emplace_back(picture(record_figure, test));
    return {record, checks_chapter(test, answer), preparation_chapter(test), provenance_chapter(test)};
  }
  const bool trusted = is_trusted(answer.standing);
  return {{"", {picture(force_figure, test), picture(profile_figure, test)}},
          friction_chapter(test, answer),
          trusted ? wave_chapter(test) : Chapter{},
          checks_chapter(test, answer),
          drops_chapter(test, answer),
          trusted ? snaps_chapter(test) : Chapter{},
          trusted ? teeth_chapter(test) : Chapter{},
          test.cycles ? cycles_chapter(test) : Chapter{},
          trusted ? energy_chapter(test, answer) : Chapter{},
          small_deflection_chapter(test),
          preparation_chapter(test),
          assumption_chapter(test),
          provenance_chapter(test)};
}

std::string fit_text(const FittedTest& test) {
  return fit_screen(test.name, answer_of(test)) + in_text(document_of(test));
}

std::string why_no_answer(const FittedTest& test) {
  if (is_fitted(test)) return "";
  const Answer answer = answer_of(test);
  return fmt::format("{}: {} {}", test.measurement.file, answer.findings.front().sentence, answer.next);
}

Rows preparation_rows(const Preparation& preparation) {
  Rows rows;
  for (const PreparationStep& step : preparation.steps) {
    std::vector<std::string> about;
    if (const auto& value = step.value)
      about.push_back(value->error ? readable(value->value, *value->error, value->kind)
                                   : readable(value->value, value->kind));
    if (step.rows) about.push_back(fmt::format("rows {} to {}", step.rows->first, step.rows->last));
    rows.push_back(
        {step.name, fmt::format("{}{}{}", step.done, about.empty() ? "" : fmt::format(" ({})", fmt::join(about, "; ")),
                                step.otherwise ? "; to change this: " + step.otherwise->in_case() : "")});
  }
  return rows;
}

std::optional<LiteratureFriction> literature_of(const FittedTest& test) {
  return test.materials ? friction_in_literature(*test.materials) : std::nullopt;
}

}  // namespace flexslip
