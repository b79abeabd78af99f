#include "finding/answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/names.h"
#include "finding/clauses.h"
#include "finding/findings.h"
#include "finding/printed.h"
#include "finding/sensitivities.h"
#include "io/text.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

// ---- The verdict

// The drops of the evaluated loading, by what each can be.
struct DropCounts {
  std::size_t all = 0;
  std::size_t possible = 0;    // can be slips
  std::size_t impossible = 0;  // cannot be slips; the others are too small to judge
};

DropCounts counts_of(T test) {
  DropCounts counts{.all = drops_of(test)};
  for (const Slip& slip : test.analysis.slips) {
    if (slip.verdict == SlipVerdict::possible)
      ++counts.possible;
    else if (slip.verdict != SlipVerdict::too_short)
      ++counts.impossible;
  }
  return counts;
}

// "35 force drops", "35 force drops of loading 2"
std::string force_drops(T test) {
  const auto& [number, of] = test.measurement.loading;
  return format_count(drops_of(test), "force drop", "force drops") +
         (of > 1 ? fmt::format(" of loading {}", number) : "");
}

std::string_view slips(std::size_t number) { return number == 1 ? "a slip" : "slips"; }

// "all 35 force drops can be slips over the supports"
std::string possible_slips(T test) {
  const auto& [all, possible, impossible] = counts_of(test);
  if (all == 1 && possible == 1) return "the force drop can be a slip over the supports";
  if (all == 1 && impossible == 1) return "the force drop cannot be a slip";
  if (possible == all) return fmt::format("all {} can be slips over the supports", force_drops(test));
  if (impossible == all) return fmt::format("none of the {} can be a slip", force_drops(test));
  if (impossible > 0) return fmt::format("{} of the {} cannot be {}", impossible, force_drops(test), slips(impossible));
  if (possible == 0) return fmt::format("the {} can be slips", force_drops(test));
  return fmt::format("{} of the {} can be slips and the others are too small to judge", possible, force_drops(test));
}

// "Probability that the drops are cracks only: 7 %."
std::string probability_of_causes(T test) {
  const std::string causes = causes_in_words(test);
  return causes.empty() ? "No probability: the drops are too small or too near the contact."
                        : fmt::format("Probability that the drops are {}.", causes);
}

// A verdict that rests on a finding says what the finding says: its first sentence, then the
// others.
Verdict verdict_by(VerdictCode code, const Finding& finding) {
  const std::size_t end = std::min(finding.sentence.find(". "), finding.sentence.size() - 1) + 1;
  return {code, finding.sentence.substr(0, end), finding.sentence.substr(std::min(end + 1, finding.sentence.size())),
          finding.code};
}

Verdict verdict_of_no_drops(T test, const std::vector<Finding>& findings) {
  if (const Finding* elsewhere = finding_in(findings, "drops_elsewhere"))
    return verdict_by(VerdictCode::undecided, *elsewhere);
  const std::string broke = test.measurement.end == MeasurementEnd::failure
                                ? fmt::format(" before the break after row {}", last_row(test))
                                : "";
  return {VerdictCode::no_drops, fmt::format("No force drop{}; one of {} would have been detected.", broke,
                                             Print(test).own(test.analysis.drops.smallest_fall, kind::force))};
}

Verdict verdict_of_slips(T test) {
  Verdict verdict{VerdictCode::slip,
                  counts_of(test).impossible > 0
                      ? fmt::format("The specimen slipped over the supports, but {}.", possible_slips(test))
                      : fmt::format("{}.", capitalised(possible_slips(test))),
                  probability_of_causes(test)};
  constexpr double noticeable = 0.03;  // [1] of a loss that the reload does not exclude
  if (is_reloaded(test.analysis) && test.passes->loss.high > noticeable)
    verdict.evidence += fmt::format(" Up to {} of the stiffness may be lost.", format_percent(test.passes->loss.high));
  return verdict;
}

Verdict verdict_of_cracks(T test) {
  const bool has_drops = test.analysis.drop_features.drops > 0;
  if (!is_reloaded(test.analysis) && !lost_before(test.analysis)) {
    if (!has_drops || !loses_at_all(test.judgement.causes, false))
      return {VerdictCode::crack, "The force fell by more than friction can explain.",
              "The specimen lost stiffness or yielded.", "cracks"};
    return {VerdictCode::crack,
            fmt::format("The specimen cracked or settled; its {} are not slips only.", force_drops(test)),
            probability_of_causes(test), "cracks"};
  }
  constexpr double surely = 0.95;
  return {VerdictCode::crack,
          fmt::format("The specimen lost {} of its stiffness{}.", loss_in_words(*test.passes),
                      has_drops ? "" : " without a visible force drop"),
          !has_drops ? ""
                     : probability_of_causes(test) +
                           (test.judgement.causes.cracks < surely ? " Some of the drops may be slips." : ""),
          "changed_reload"};
}

Verdict verdict_of_slips_and_damage(T test) {
  return {VerdictCode::slip_and_damage,
          fmt::format("The specimen slipped over the supports, and it lost {} of its stiffness.",
                      loss_in_words(*test.passes)),
          probability_of_causes(test) + (test.passes->loss_needed > 0
                                             ? fmt::format(" Cracks only would have cost {} of the stiffness.",
                                                           format_percent(test.passes->loss_needed))
                                             : ""),
          "changed_reload"};
}

Verdict verdict_of_settled(T test) {
  const Estimate& settled = test.passes->settled;
  const Scales& scales = test.analysis.scales;
  return {VerdictCode::settled,
          fmt::format("The specimen or a support settled by {}; no stiffness was lost.",
                      readable(scales.physical_length(settled.value), scales.physical_length(settled.standard_error),
                               Print(test).as(kind::length))),
          "", "changed_reload"};
}

Verdict verdict_of_undecided(T test, const std::vector<Finding>& findings) {
  if (drops_of(test) == 0) {  // the force decreases slowly
    const Finding* sinks = finding_in(findings, "sinks");
    return sinks ? verdict_by(VerdictCode::undecided, *sinks)
                 : Verdict{VerdictCode::undecided, "The force decreases slowly, without a drop."};
  }
  const Finding* open = finding_in(findings, "undecided_drops");
  const auto& [all, possible, impossible] = counts_of(test);
  const std::string_view doubt = impossible == all ? ", but cracks are not certain"
                                 : impossible > 0  ? "; the others can be slips or cracks"
                                                   : ", but cracks cannot be excluded";
  return {VerdictCode::undecided, fmt::format("{}{}.", capitalised(possible_slips(test)), doubt),
          probability_of_causes(test), open ? open->code : std::string_view()};
}

// Findings that an input of the user contradicts the record.
constexpr std::array wrong_inputs{"not_bent", "deflection_for_stage", "wrong_load_train", "wrong_stiffness",
                                  "impossible_modulus"};

Verdict verdict_of(T test, const std::vector<Finding>& findings) {
  const Finding* refusal = is_refused(findings) ? &findings.front() : nullptr;  // refusals are the first rules
  if (refusal && std::find(wrong_inputs.begin(), wrong_inputs.end(), refusal->code) != wrong_inputs.end())
    return verdict_by(VerdictCode::check_input, *refusal);
  // Where no friction explains the record, nothing but cracks does.
  if (refusal && refusal->code == "not_explained" && test.judgement.conclusion != Conclusion::cracks &&
      test.judgement.conclusion != Conclusion::slips_and_damage)
    return verdict_by(drops_of(test) == 0 ? VerdictCode::check_input : VerdictCode::undecided, *refusal);
  switch (test.judgement.conclusion) {
    case Conclusion::no_drops:
      return verdict_of_no_drops(test, findings);
    case Conclusion::slips:
      return verdict_of_slips(test);
    case Conclusion::cracks:
      return verdict_of_cracks(test);
    case Conclusion::slips_and_damage:
      return verdict_of_slips_and_damage(test);
    case Conclusion::settled:
      return verdict_of_settled(test);
    case Conclusion::undecided:
      break;
  }
  return verdict_of_undecided(test, findings);
}

// The verdict on supports that the case does not state: "SLIP on knife edges (friction 0.53 ±
// 0.05)".
std::string by_supports(T test, const Verdict& verdict, const std::string& supports) {
  const bool has_friction = verdict.code != VerdictCode::crack && verdict.code != VerdictCode::no_answer;
  return fmt::format("{} on {}{}", word_of(verdict.code), supports,
                     has_friction ? fmt::format(" (friction {})", mean_friction(test.analysis.fit)) : "");
}

// If the case states no supports and rollers lead to another verdict, neither verdict is given: the
// answer asks for the supports.
Verdict verdict_on_any_supports(T test, const std::vector<Finding>& findings) {
  Verdict on_edges = verdict_of(test, findings);
  const Finding* open = finding_in(findings, "supports_not_stated");
  if (!open || on_edges.code == VerdictCode::check_input) return on_edges;
  if (friction_on_rollers(test) && on_edges.finding.empty()) on_edges.finding = open->code;
  const std::vector<Finding> findings_on_rollers = findings_of(*test.on_rollers);
  const Verdict on_rollers = verdict_of(*test.on_rollers, findings_on_rollers);
  if (on_rollers.code == on_edges.code || is_refused(findings_on_rollers)) return on_edges;
  return {VerdictCode::undecided, "The verdict depends on the supports, which are not stated.",
          fmt::format("{}; {}.", by_supports(test, on_edges, "knife edges"),
                      by_supports(*test.on_rollers, on_rollers, usual_rollers(test))),
          open->code};
}

// ---- The rows: clauses, the most important first. The screen shows the clauses that fit on a line.

std::string in_clauses(const std::vector<std::string>& clauses) { return fmt::format("{}", fmt::join(clauses, "; ")); }

// " with no stiffness lost": the condition of friction if the loss of stiffness is unknown.
std::string no_loss(T test, std::string_view begin) {
  if (!may_have_lost_stiffness(test)) return "";
  return fmt::format("{} no {}stiffness lost", begin, lost_before(test.analysis) ? "more " : "");
}

std::string friction_in_words(T test, const Verdict& verdict) {
  if (test.analysis.status == AnalysisStatus::deflection_too_small)
    return "none: the deflection is too small to determine friction";
  if (!test.judgement.determines_friction) return "none: an unmeasured loss of stiffness hides it";
  const FrictionFit& fit = test.analysis.fit;
  const auto on_rollers = friction_on_rollers(test);
  const bool supposes_slips =
      verdict.code == VerdictCode::undecided && drops_of(test) > 0 && !is_reloaded(test.analysis);
  std::vector<std::string> clauses{fmt::format("{}{}{}{}{}", mean_friction(fit), fit.mu0_is_bound ? " (95 %)" : "",
                                               on_rollers ? " on knife edges" : "", supposes_slips ? " if slips" : "",
                                               no_loss(test, on_rollers ? "," : " with"))};
  if (on_rollers) clauses.push_back(*on_rollers);
  std::vector<std::string> if_lost;
  if (may_have_lost_stiffness(test) && !on_rollers)
    for (const auto& [loss, friction] : test.judgement.if_lost)
      if_lost.push_back(
          fmt::format("{:.2f} with {}{}", friction, format_percent(loss), if_lost.empty() ? " lost" : ""));
  if (!if_lost.empty()) clauses.push_back(fmt::format("{}", fmt::join(if_lost, ", ")));
  return in_clauses(clauses);
}

// "33 ± 2 %"
std::string share_in_words(T test) {
  const MeasuredEnergy& energy = test.analysis.energy;
  if (!std::isfinite(energy.friction_share_error)) return format_percent(energy.friction_share);
  const int digits = energy.friction_share_error < 0.005 ? 1 : 0;
  return fmt::format("{:.{}f} ± {:.{}f} %", 100 * energy.friction_share, digits, 100 * energy.friction_share_error,
                     digits);
}

std::string work_in_words(T test, const Verdict& verdict) {
  const MeasuredEnergy& energy = test.analysis.energy;
  const bool depends_on_supports = friction_on_rollers(test) || verdict.finding == "supports_not_stated";
  // Lost stiffness would leave a larger share of the work to friction.
  constexpr double noticeable = 0.005;
  const bool is_least = may_have_lost_stiffness(test) && std::isfinite(energy.friction_share_error) &&
                        !depends_on_supports && energy.least_share() > noticeable;
  const bool supposes_slips = drops_of(test) > 0 && !slips_at_all(test.judgement.causes);
  return fmt::format("friction took {} of {}{}{}{}; this is not toughness",
                     is_least ? "at least " + format_percent(energy.least_share()) : share_in_words(test),
                     Print(test).energy(energy.work_of_fracture), depends_on_supports ? " on knife edges" : "",
                     supposes_slips ? " if slips" : "", is_least ? "" : no_loss(test, ","));
}

std::string spacing_in_words(T test) {
  const TestAnalysis& analysis = test.analysis;
  constexpr std::size_t enough = 3;  // slips, for a median spacing
  const auto length = [&](double value) {
    return format_roughly(analysis.scales.physical_length(value), Print(test).as(kind::length));
  };
  const bool has_spacing = analysis.slip_summary.count >= enough;
  const bool has_wave = analysis.fit.wave_claimed && !analysis.fit.waves.empty();
  std::vector<std::string> clauses;
  const std::string spacing = has_spacing ? length(analysis.slip_summary.median_spacing) : "";
  if (has_spacing) clauses.push_back(fmt::format("one drop per {} of specimen", spacing));
  if (has_wave) {
    const std::string period = length(analysis.fit.waves.front().wavelength.value);
    clauses.push_back(period == spacing ? "friction varies along it with the same period"
                                        : fmt::format("friction varies with a period of {}", period));
  } else if (analysis.fit.model == ProfileModel::roughness && !analysis.fit.mu0_is_bound) {
    clauses.emplace_back("irregular");
  }
  return in_clauses(clauses);
}

// The result of the fit of all passes; empty for a record of one pass.
std::string reload_in_words(T test) {
  if (!test.passes) return "";
  const PassesFit& passes = *test.passes;
  if (passes.status != PassesStatus::ok)
    return passes.is_reloaded
               ? fmt::format("{} of the stiffness lost, from the forces of two loadings", loss_in_words(passes))
               : std::string();
  std::vector<std::string> clauses;
  if (passes.is_reloaded)
    clauses.push_back(loss_in_words(passes) + " of the stiffness lost" +
                      (passes.loss_needed > 0
                           ? fmt::format(" (cracks only would cost {})", format_percent(passes.loss_needed))
                           : ""));
  std::vector<std::string> frictions;
  constexpr std::size_t max_passes = 6;  // listed in the row
  for (const PassFriction& pass : passes.passes)
    if (std::isfinite(pass.friction.value) && frictions.size() < max_passes)
      frictions.push_back(
          fmt::format("{:.2f} {}", pass.friction.value, pass.rows.direction == Direction::loading ? "in" : "out"));
  if (!frictions.empty()) clauses.push_back(fmt::format("friction sliding {}", fmt::join(frictions, ", ")));
  if (passes.is_reloaded && passes.drops_again > 0)
    clauses.push_back(fmt::format("{} repeated", format_count(passes.drops_again, "drop", "drops")));
  return in_clauses(clauses);
}

std::string_view source_of(StiffnessSource source) {
  return name_in_order<StiffnessSource::initial_slope>(source, {"stated", "stated", "initial slope"});
}

std::string stiffness_in_words(T test, const Verdict& verdict, bool is_fitted_stiffness) {
  const TestAnalysis& analysis = test.analysis;
  const Print print(test);
  const double EI = analysis.scales.bending_stiffness();
  const Kind stiffness = print.as(kind::bending_stiffness);
  const std::string prior = readable(EI, EI * analysis.bending_stiffness_error, stiffness);
  if (!is_fitted_stiffness)
    return fmt::format("EI {} ({}){}", prior, source_of(test.stiffness),
                       verdict.finding == "cracks" && test.analysis.drop_features.drops > 0
                           ? fmt::format("; as cracks, the drops took {} of it", loss_by_drops_in_words(test))
                           : "");
  const Estimate& fitted = analysis.fit.bending_stiffness;
  std::string words = fmt::format("EI {} ({} {})", readable(EI * fitted.value, EI * fitted.standard_error, stiffness),
                                  source_of(test.stiffness), prior);
  if (test.section_moment)
    words +=
        fmt::format("; E {}", readable(EI * fitted.value / *test.section_moment,
                                       EI * fitted.standard_error / *test.section_moment, print.as(kind::pressure)));
  return words;
}

std::string assumed_in_words(T test) {
  const Supports& supports = test.analysis.rig.fibre.supports();
  const Measurement& measurement = test.measurement;
  const Print print(test);
  const bool is_at_zero = measurement.contact == ContactSource::first_point || measurement.contact_offset == 0;
  std::vector<std::string> clauses, errors, from_file;
  for (const PreparationStep& step : measurement.preparation)
    if (step.name == "metadata" && step.value && step.otherwise)
      from_file.push_back(fmt::format("{} {}",
                                      step.otherwise->name == "stiffness" ? "load train" : step.otherwise->name,
                                      print.own(step.value->value, step.value->kind)));
  if (!from_file.empty()) clauses.push_back(fmt::format("{} as in the file", fmt::join(from_file, ", ")));
  if (!measurement.test.rig->states_supports()) clauses.emplace_back("knife edges");
  if (supports.half_depth == 0) clauses.emplace_back("no thickness");
  std::string contact =
      is_at_zero ? "contact at the zero of the file"
                 : fmt::format("contact at {} ({})", with_minus(print.own(measurement.contact_offset, kind::length)),
                               measurement.contact == ContactSource::stated ? "stated" : "found");
  for (const auto& [what, error, kind] : assumed_errors(test)) {
    const std::string size =
        kind.name == kind::length.name ? format_roughly(error, print.as(kind::length)) : format_relative(error);
    if (what == "contact")
      contact += ", ± " + size;
    else
      errors.push_back(fmt::format("{} ± {}", what, size));
  }
  clauses.push_back(contact);
  if (!errors.empty()) clauses.push_back(fmt::format("{}", fmt::join(errors, ", ")));
  return in_clauses(clauses);
}

// The rows used, the readings left out, and why the record ends there.
std::string record_in_words(T test) {
  const Measurement& measurement = test.measurement;
  const std::size_t last = last_row(test);
  std::string rows = fmt::format("rows {}–{}", file_row(test, 0), last);
  if (last < measurement.rows) rows += fmt::format(" of {}", measurement.rows);
  const Sampling& sampling = measurement.sampling;
  std::vector<std::string> left_out;
  if (const std::size_t out = sampling.repeated + sampling.held + sampling.interpolated; out > 0)
    left_out.push_back(fmt::format("{} repeated or held", out));
  if (measurement.missing > 0) left_out.push_back(fmt::format("{} without a number", measurement.missing));
  if (sampling.at_rest > 0) left_out.push_back(fmt::format("{} with the stage at rest", sampling.at_rest));
  if (sampling.spikes > 0) left_out.push_back(format_count(sampling.spikes, "spike", "spikes"));
  if (!left_out.empty()) rows += fmt::format(" ({} left out)", fmt::join(left_out, ", "));
  if (sampling.stride > 1) rows += fmt::format(", one in {}", sampling.stride);
  if (const auto& [number, of] = measurement.loading; of > 1) rows += fmt::format(", loading {} of {}", number, of);
  if (measurement.end == MeasurementEnd::until) rows += " (until, as stated)";
  std::vector<std::string> clauses{rows};
  if (measurement.end == MeasurementEnd::failure)
    clauses.push_back(fmt::format("the specimen broke after row {}", last));
  if (measurement.end == MeasurementEnd::overload)
    clauses.push_back(fmt::format("the load cell was overloaded after row {}", last));
  if (measurement.end == MeasurementEnd::turn) clauses.emplace_back("then the stage turns back");
  if (const std::size_t after = measurement.drops_behind; after > 0)
    clauses.push_back(fmt::format("{} after {}", format_count(after, "more drop", "more drops"),
                                  measurement.end == MeasurementEnd::failure ? "the break" : "that row"));
  if (test.drops_elsewhere.drops > 0)
    clauses.push_back(
        fmt::format("{} in other loadings", format_count(test.drops_elsewhere.drops, "more drop", "more drops")));
  if (const std::size_t slow = test.analysis.drops.slow_falls.size(); slow > 0)
    clauses.push_back(fmt::format("{} too slow for a snap: sliding on decreasing friction, yielding or relaxation",
                                  format_count(slow, "fall is", "falls are")));
  return in_clauses(clauses);
}

// True if the program, not the user, left out rows.
bool is_cut(T test) {
  const Measurement& measurement = test.measurement;
  const Sampling& sampling = measurement.sampling;
  return measurement.end == MeasurementEnd::failure || measurement.end == MeasurementEnd::overload ||
         sampling.repeated + sampling.held + sampling.interpolated + sampling.at_rest + sampling.spikes +
                 measurement.missing >
             0;
}

// ---- Rows of the full answer only

std::string drops_in_words(T test) {
  const auto& drops = test.analysis.drops.drops;
  const Print print(test);
  if (drops.empty())
    return fmt::format("none; one of {} would have been detected",
                       print.own(test.analysis.drops.smallest_fall, kind::force));
  const auto deepest = std::max_element(drops.begin(), drops.end(),
                                        [](const Drop& a, const Drop& b) { return a.force_fall < b.force_fall; });
  constexpr double small = 0.1;
  const auto small_ones = static_cast<std::size_t>(std::count_if(
      drops.begin(), drops.end(), [&](const Drop& drop) { return drop.force_fall < small * deepest->force_fall; }));
  std::vector<std::string> clauses{
      fmt::format("{}, the largest {}", drops.size(), print.own(deepest->force_fall, kind::force))};
  if (2 * small_ones > drops.size())
    clauses.push_back(fmt::format("{} are smaller than a tenth of the largest", small_ones));
  if (const std::size_t impossible = counts_of(test).impossible; impossible > 0)
    clauses.push_back(fmt::format("{} cannot be {}", impossible, slips(impossible)));
  return in_clauses(clauses);
}

// The mean friction holds for the length that slid; along it friction varies.
std::string profile_in_words(T test, const std::vector<Finding>& findings) {
  const FrictionFit& fit = test.analysis.fit;
  if (fit.mu0_is_bound) return "friction cannot be distinguished from zero";
  const double slid = 0.5 * (fit.S_end - fit.S_begin);
  std::vector<std::string> clauses{
      fmt::format("mean over the {} that slid over each support",
                  format_roughly(test.analysis.scales.physical_length(slid), Print(test).as(kind::length)))};
  const PointwiseFriction& pointwise = test.analysis.pointwise_friction;
  if (std::isfinite(pointwise.median)) {
    const bool is_above = pointwise.low80 > fit.mu0.value, is_below = pointwise.high80 < fit.mu0.value;
    clauses.push_back(fmt::format("{:.2f} to {:.2f} {}", pointwise.low80, pointwise.high80,
                                  is_above   ? "where the specimen stopped, more than where it slipped"
                                  : is_below ? "where it can be inverted, less than elsewhere"
                                             : "along it"));
  }
  for (const std::string_view code : {"changing_friction", "hidden_waves"})
    if (const Finding* found = finding_in(findings, code); found && found->severity == Severity::condition)
      clauses.push_back(found->short_form);
  return in_clauses(clauses);
}

// The difference between the length seen in images of the supports and the length computed from the
// force.
std::string imaged_length_in_words(T test) {
  if (!test.imaged || test.imaged->points.empty()) return "";
  const ImagedLength& imaged = *test.imaged;
  const double unit = test.analysis.scales.span();
  const Kind length = Print(test).as(kind::length);
  return fmt::format("{} {} than the force shows (median of {}, scatter {})",
                     readable(std::abs(unit * imaged.offset.value), unit * imaged.offset.standard_error, length),
                     imaged.offset.value > 0 ? "less" : "more", format_count(imaged.points.size(), "point", "points"),
                     format_roughly(unit * imaged.scatter, length));
}

// The stiffness that the command modulus determines, if the fit started from the initial slope and
// the steepest part differs from it.
std::string steepest_part_in_words(T test) {
  const SmallDeflection& numbers = test.small_deflection;
  if (test.stiffness != StiffnessSource::initial_slope || test.measurement.straight_is_initial ||
      !numbers.bending_stiffness)
    return "";
  const double error = numbers.bending_stiffness->standard_error;
  const double EI = test.analysis.scales.bending_stiffness();
  constexpr double clearly = 2;
  if (std::abs(numbers.bending_stiffness->value - EI) <
      clearly * elementary::length(error, EI * test.analysis.bending_stiffness_error))
    return "";
  const RowRange rows = rows_of_first_curve(test.measurement, numbers.first, numbers.last);
  return fmt::format("rows {} to {}: EI {}; friction may have steepened it", rows.first, rows.last,
                     readable(numbers.bending_stiffness->value, error, Print(test).as(kind::bending_stiffness)));
}

double surface_strain(T test) {
  const double curvature = max_curvature(test.analysis.profile_at_fit, test.analysis.rig.fibre);
  return test.surface && std::isfinite(curvature) ? test.surface->strain(curvature) : not_a_number;
}

// True if the specimen should have broken.
bool is_beyond_break(T test) { return test.strain_at_break && surface_strain(test) > *test.strain_at_break; }

std::string strain_in_words(T test) {
  const double strain = surface_strain(test);
  if (!std::isfinite(strain)) return "";
  std::vector<std::string> clauses{fmt::format("up to {} at the surface", format_relative(strain))};
  if (is_beyond_break(test))
    clauses.push_back(fmt::format("above the strain at break of {}", format_relative(*test.strain_at_break)));
  if (max_curvature(test.analysis.profile_at_fit, test.analysis.rig.fibre) > test.nose_curvature)
    clauses.emplace_back("the specimen wrapped the nose");
  return in_clauses(clauses);
}

// The general assumptions of the model.
std::string model_in_words(T test) {
  std::vector<std::string> clauses{"a slender, straight, elastic beam", "its nose at midspan to 3 % of the span"};
  if (!test.measurement.relaxation)
    clauses.push_back(fmt::format("no relaxation during the test (slow deviations of the force up to {})",
                                  format_relative(test.analysis.rig_errors.slow_force)));
  if (test.analysis.fit.overshoots && !test.measurement.test.rig->snaps)
    clauses.emplace_back("snaps overshoot, as the record shows");
  return in_clauses(clauses);
}

// Adds the rows and the details, without empty ones.
void add_rows(Answer& answer, T test) {
  const Verdict& verdict = answer.verdict;
  const auto add = [&](std::string_view label, std::string words, bool is_detail = false) {
    if (!words.empty()) (is_detail ? answer.details : answer.rows).push_back({std::string(label), std::move(words)});
  };
  const bool has_answer = is_fitted(test) && (!is_refused(answer.findings) || verdict.code == VerdictCode::crack);
  const bool has_friction = has_answer && test.judgement.determines_friction;
  const bool has_work = has_answer && std::isfinite(test.analysis.energy.friction_share);
  const bool is_too_small = test.analysis.status == AnalysisStatus::deflection_too_small;
  constexpr bool is_detail = true;
  if (has_answer || (is_too_small && verdict.code != VerdictCode::check_input))
    add("friction", friction_in_words(test, verdict));
  if (has_work) add("work", work_in_words(test, verdict));
  if (has_friction) add("spacing", spacing_in_words(test));
  if (has_answer || is_too_small) add("reload", reload_in_words(test));
  add("stiffness", stiffness_in_words(test, verdict, has_friction));
  if (has_friction) add("strain", strain_in_words(test), !is_beyond_break(test));
  if (has_friction && test.analysis.fit.friction_by) add("sensitivity", sensitivities_in_words(test, has_work));
  add("assumed", assumed_in_words(test));
  add("record", record_in_words(test), !is_cut(test));
  add("drops", drops_in_words(test), is_detail);
  if (has_friction) add("profile", profile_in_words(test, answer.findings), is_detail);
  if (has_friction) add("imaged length", imaged_length_in_words(test), is_detail);
  add("steepest part", steepest_part_in_words(test), is_detail);
  add("model", model_in_words(test), is_detail);
}

// The action of the finding that the verdict rests on; otherwise of the most important note. Doubts
// carry their own actions.
std::string next_step(const Verdict& verdict, const std::vector<Finding>& findings) {
  if (const Finding* basis = finding_in(findings, verdict.finding); basis && !basis->remedy.empty())
    return basis->remedy;
  for (const Finding& finding : findings)
    if ((finding.severity == Severity::condition || finding.severity == Severity::note) && !finding.remedy.empty())
      return finding.remedy;
  return "";
}

}  // namespace

Answer answer_of(T test) {
  std::vector<Finding> findings = findings_of(test);
  Verdict verdict = verdict_on_any_supports(test, findings);
  std::string next = next_step(verdict, findings);
  Answer answer{.verdict = std::move(verdict),
                .rows = {},
                .details = {},
                .findings = std::move(findings),
                .next = std::move(next)};
  add_rows(answer, test);
  return answer;
}

}  // namespace flexslip
