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
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

// "the largest 850 mN", and how many are small beside it, where that is most: "the largest 850 mN, 8 of them below a tenth of that".
std::string sizes_in_words(T test) {
  const auto& drops = test.analysis.drops.drops;
  const auto deepest = std::max_element(drops.begin(), drops.end(),
                                        [](const Drop& a, const Drop& b) { return a.force_fall < b.force_fall; });
  constexpr double small = 0.1;
  const auto small_ones = static_cast<std::size_t>(std::count_if(
      drops.begin(), drops.end(), [&](const Drop& drop) { return drop.force_fall < small * deepest->force_fall; }));
  return fmt::format(
      "the largest {}{}", Print(test).own(deepest->force_fall, kind::force),
      2 * small_ones > drops.size() ? fmt::format(", {} of them below a tenth of that", small_ones) : "");
}

// ---- The verdict

bool tells_work(T test) { return std::isfinite(test.analysis.energy.friction_share); }

// "33 ± 2 %"
std::string share_in_words(T test) {
  const MeasuredEnergy& energy = test.analysis.energy;
  if (!std::isfinite(energy.friction_share_error)) return format_percent(energy.friction_share);
  const int digits = energy.friction_share_error < 0.005 ? 1 : 0;
  return fmt::format("{:.{}f} ± {:.{}f} %", 100 * energy.friction_share, digits, 100 * energy.friction_share_error,
                     digits);
}

// Lost stiffness leaves more of the work to friction than is told.
bool has_least_share(T test) {
  return may_have_lost_stiffness(test) && std::isfinite(test.analysis.energy.friction_share_error);
}

std::string work_in_short(T test) {
  const double share = test.analysis.energy.friction_share;
  constexpr double worth_saying = 0.005;
  if (!(share > worth_saying) || friction_on_rollers(test)) return "";
  if (!has_least_share(test)) return fmt::format("{} of the work was friction, not toughness", share_in_words(test));
  const double least = test.analysis.energy.least_share();
  return least > worth_saying
             ? fmt::format("at least {} of the work was friction, not toughness", format_percent(least))
             : "";
}

std::string count_of_drops(T test) { return format_count(drops_of(test), "drop", "drops"); }

// "friction 0.47 ± 0.06 if the supports are knife edges and no stiffness was lost, 0.21 ± 0.05 on rollers of 5 mm", or that none is told.
std::string friction_in_short(T test, std::vector<std::string> conditions = {}) {
  if (!is_fitted(test))
    return test.analysis.status == AnalysisStatus::deflection_too_small
               ? "friction cannot be told at so small a deflection"
               : "no friction can be read off";
  if (!test.judgement.tells_friction) return "no friction can be read off";
  const FrictionFit& fit = test.analysis.fit;
  const auto on_rollers = friction_on_rollers(test);
  if (on_rollers) conditions.insert(conditions.begin(), "the supports are knife edges");
  return fmt::format("friction {}{}{}{}{}", mean_friction(fit), fit.mu0_is_bound ? " (95 %)" : "",
                     conditions.empty() ? "" : " if ", in_words(conditions, "and"),
                     on_rollers ? ", " + *on_rollers : "");
}

// "the drops would need 28 % if they were cracks only"
std::string need_in_words(const PassesFit& passes) {
  return fmt::format("the drops would need {} if they were cracks only", format_percent(passes.loss_needed));
}

void add(std::vector<std::string>& parts, std::string part) {
  if (!part.empty()) parts.push_back(std::move(part));
}

// What friction is told under of a test in which nobody knows what stiffness was lost.
std::vector<std::string> losses_apart(T test) {
  if (!may_have_lost_stiffness(test)) return {};
  return {lost_before(test.analysis) ? "no more stiffness was lost" : "no stiffness was lost"};
}

Verdict verdict_of_no_drops(T test, const std::vector<Finding>& findings) {
  const std::vector<std::string> condition = losses_apart(test);
  if (const Finding* elsewhere = finding_in(findings, "drops_elsewhere"))
    return {VerdictCode::undecided, {friction_in_short(test, condition), elsewhere->short_form}, elsewhere->code};
  Verdict verdict{VerdictCode::no_drops, {}};
  if (test.measurement.end == MeasurementEnd::failure)
    verdict.parts.push_back(fmt::format("the specimen broke after row {}", last_row(test)));
  verdict.parts.push_back(friction_in_short(test, condition));
  add(verdict.parts, work_in_short(test));
  return verdict;
}

Verdict verdict_of_slips(T test) {
  Verdict verdict{VerdictCode::slip, {friction_in_short(test, losses_apart(test))}};
  add(verdict.parts, work_in_short(test));
  add(verdict.parts, causes_in_words(test));
  constexpr double worth_saying = 0.03;  // [1] of a loss that the reload leaves open
  if (is_reloaded(test.analysis) && test.passes->loss.high > worth_saying)
    verdict.parts.push_back(
        fmt::format("it may have lost up to {} of its stiffness", format_percent(test.passes->loss.high)));
  return verdict;
}

Verdict verdict_of_cracks(T test) {
  const bool has_drops = test.analysis.drop_features.drops > 0;
  if (!is_reloaded(test.analysis) && !lost_before(test.analysis)) {
    Verdict verdict{VerdictCode::crack, {}, "cracks"};
    if (has_drops && loses_at_all(test.judgement.causes, false))
      verdict.parts = {count_of_drops(test),
                       fmt::format("the specimen lost {} of its stiffness if they are cracks, or settled",
                                   loss_by_drops_in_words(test)),
                       causes_in_words(test)};
    else
      verdict.parts = {"the force fell by more than any friction can hold"};
    verdict.parts.push_back(friction_in_short(test));
    return verdict;
  }
  Verdict verdict{VerdictCode::crack, {loss_in_words(*test.passes) + " of the stiffness was lost"}, "changed_reload"};
  if (!has_drops) verdict.parts.emplace_back("without a drop to be seen");
  if (has_drops && test.judgement.causes.cracks < 0.95) verdict.parts.emplace_back("some of the drops may be slips");
  verdict.parts.push_back(friction_in_short(test, losses_apart(test)));
  return verdict;
}

Verdict verdict_of_slips_and_damage(T test) {
  return {VerdictCode::slip_and_damage,
          {loss_in_words(*test.passes) + " of the stiffness was lost", need_in_words(*test.passes),
           friction_in_short(test, losses_apart(test))},
          "changed_reload"};
}

Verdict verdict_of_settled(T test) {
  const Estimate& settled = test.passes->settled;
  const Scales& scales = test.analysis.scales;
  return {VerdictCode::settled,
          {fmt::format("the specimen or a support gave way by {} for good; no stiffness was lost",
                       readable(scales.physical_length(settled.value), scales.physical_length(settled.standard_error),
                                Print(test).as(kind::length))),
           friction_in_short(test)},
          "changed_reload"};
}

Verdict verdict_of_undecided(T test, const std::vector<Finding>& findings) {
  if (drops_of(test) == 0) {  // it sinks slowly
    const Finding* sinks = finding_in(findings, "sinks");
    return {VerdictCode::undecided,
            {(sinks ? sinks->short_form : "the force sinks") + " without a drop", friction_in_short(test)},
            sinks ? sinks->code : std::string_view()};
  }
  const Finding* open = finding_in(findings, "undecided_drops");
  Verdict verdict{
      VerdictCode::undecided,
      {friction_in_short(test, is_reloaded(test.analysis)
                                   ? std::vector<std::string>()
                                   : std::vector<std::string>{"the drops are slips", "no stiffness was lost"}),
       count_of_drops(test)},
      open ? open->code : std::string_view()};
  add(verdict.parts, causes_in_words(test));
  return verdict;
}

// What a test comes to that is not what was stated of it.
constexpr std::array wrong_inputs{"not_bent", "deflection_for_stage", "wrong_load_train", "wrong_stiffness",
                                  "impossible_modulus"};

Verdict verdict_of(T test, const std::vector<Finding>& findings) {
  const Finding* refusal = is_refused(findings) ? &findings.front() : nullptr;  // the rules begin with those
  if (refusal && std::find(wrong_inputs.begin(), wrong_inputs.end(), refusal->code) != wrong_inputs.end())
    return {VerdictCode::check_input, {refusal->sentence}, refusal->code};
  // Where no friction explains the record, nothing but cracks does.
  if (refusal && refusal->code == "not_explained" && test.judgement.conclusion != Conclusion::cracks &&
      test.judgement.conclusion != Conclusion::slips_and_damage) {
    if (drops_of(test) == 0) return {VerdictCode::check_input, {refusal->sentence}, refusal->code};
    Verdict verdict{VerdictCode::undecided, {refusal->short_form, count_of_drops(test)}, refusal->code};
    add(verdict.parts, causes_in_words(test));
    return verdict;
  }
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

// What the test comes to on supports that nobody states: "slip on edges (friction 0.53 ± 0.05)".
std::string by_supports(T test, const Verdict& verdict, const std::string& supports) {
  const bool tells = verdict.code != VerdictCode::crack && verdict.code != VerdictCode::no_answer;
  std::string word(name_of(verdict.code));
  std::replace(word.begin(), word.end(), '_', ' ');
  return fmt::format("{} on {}{}", word, supports,
                     tells ? fmt::format(" (friction {})", mean_friction(test.analysis.fit)) : "");
}

// Where the supports are not stated, and rollers make another verdict, neither is told: the supports are asked for. Where they make another friction,
// that is told, too.
Verdict verdict_whatever_the_supports(T test, const std::vector<Finding>& findings) {
  Verdict on_edges = verdict_of(test, findings);
  const Finding* open = finding_in(findings, "supports_not_stated");
  if (!open || on_edges.code == VerdictCode::check_input) return on_edges;
  if (friction_on_rollers(test) && on_edges.finding.empty()) on_edges.finding = open->code;
  const std::vector<Finding> findings_on_rollers = findings_of(*test.on_rollers);
  const Verdict on_rollers = verdict_of(*test.on_rollers, findings_on_rollers);
  if (on_rollers.code == on_edges.code || is_refused(findings_on_rollers)) return on_edges;
  return {VerdictCode::undecided,
          {by_supports(test, on_edges, "edges"), by_supports(*test.on_rollers, on_rollers, usual_rollers(test)),
           "which supports?"},
          open->code};
}

// ---- The rows

// What was done to the record: rows used, where the specimen broke, readings left out.
std::string rows_in_words(T test) {
  const Measurement& measurement = test.measurement;
  const std::size_t last = last_row(test);
  std::string words = fmt::format("rows {}–{}", file_row(test, 0), last);
  if (last < measurement.rows) words += fmt::format(" of {}", measurement.rows);
  const Sampling& sampling = measurement.sampling;
  std::vector<std::string> left_out;
  if (const std::size_t out = sampling.repeated + sampling.held + sampling.interpolated; out > 0)
    left_out.push_back(fmt::format("{} repeated or held", out));
  if (measurement.missing > 0) left_out.push_back(fmt::format("{} without a number", measurement.missing));
  if (sampling.at_rest > 0) left_out.push_back(fmt::format("{} while the stage halted", sampling.at_rest));
  if (sampling.spikes > 0) left_out.push_back(format_count(sampling.spikes, "spike", "spikes"));
  if (!left_out.empty()) words += fmt::format(" ({} left out)", fmt::join(left_out, ", "));
  if (sampling.stride > 1) words += fmt::format(", one in {}", sampling.stride);
  if (const auto& [number, of] = measurement.loading; of > 1) words += fmt::format(", loading {} of {}", number, of);
  switch (measurement.end) {
    case MeasurementEnd::failure:
      return words + fmt::format("; it broke after row {}", last);
    case MeasurementEnd::until:
      return words + " (until, as stated)";
    case MeasurementEnd::overload:
      return words + fmt::format("; the load cell is at its end after row {}", last);
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
  const std::size_t semicolon = std::min(rows.find(';'), rows.size());
  const std::string used = rows.substr(0, semicolon);
  const std::size_t behind = test.measurement.drops_behind;
  const std::string end =
      rows.substr(semicolon) +
      (behind > 0 ? fmt::format("; {} behind {}", format_count(behind, "more drop", "more drops"),
                                test.measurement.end == MeasurementEnd::failure ? "the break" : "that row")
                  : "") +
      (test.drops_elsewhere.drops > 0 ? fmt::format("; {} more in other loadings", test.drops_elsewhere.drops) : "");
  const std::size_t slow = analysis.drops.slow_falls.size();
  const std::string slowly =
      slow > 0 ? fmt::format("; {} too slow for a snap: sliding on falling friction, yielding or relaxation",
                             format_count(slow, "fall is", "falls are"))
               : "";
  if (drops_of(test) == 0)
    return fmt::format("none in {}; one of {} would have been seen{}{}", used,
                       Print(test).own(analysis.drops.smallest_fall, kind::force), slowly, end);
  const SlipSummary& slips = analysis.slip_summary;
  constexpr std::size_t enough = 3;  // to speak of a spacing
  const bool has_spacing = is_fitted(test) && slips.count >= enough && test.judgement.tells_friction;
  return fmt::format("{} in {}, {}{}{}", drops_of(test), used, sizes_in_words(test),
                     has_spacing ? fmt::format(", one per {} of the specimen",
                                               format_roughly(analysis.scales.physical_length(slips.median_spacing),
                                                              Print(test).as(kind::length)))
                                 : "",
                     slowly + end);
}

std::string slip_or_crack_in_words(T test) {
  const std::vector<Slip>& slips = test.analysis.slips;
  const auto impossible = static_cast<std::size_t>(std::count_if(slips.begin(), slips.end(), [](const Slip& slip) {
    return slip.verdict != SlipVerdict::possible && slip.verdict != SlipVerdict::too_short;
  }));
  std::string words = causes_in_words(test);
  if (words.empty()) words = "the drops are too small, or too near the contact, for a probability";
  if (impossible > 0) words += fmt::format("; {} of {} cannot be slips", impossible, drops_of(test));
  if (test.judgement.conclusion == Conclusion::cracks && !is_reloaded(test.analysis) &&
      test.analysis.drop_features.drops > 0)
    words += fmt::format("; {} of the stiffness lost if they are cracks", loss_by_drops_in_words(test));
  return words;
}

std::string if_lost_in_words(T test) {
  std::vector<std::string> parts;
  for (const auto& [loss, friction] : test.judgement.if_lost) {
    constexpr double tenth = 0.1;
    if (may_have_lost_stiffness(test))
      parts.push_back(fmt::format("{:.2f} if a {} was", friction, loss > tenth ? "fifth" : "tenth"));
  }
  const std::vector<std::string> condition = losses_apart(test);
  return fmt::format("{}{}", condition.empty() ? "" : ", if " + condition.front(),
                     parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, ", ")));
}

// How the length seen in images of the supports differs from the length that the force shows.
std::string imaged_length_in_words(T test) {
  if (!test.imaged || test.imaged->points.empty()) return "";
  const ImagedLength& imaged = *test.imaged;
  const double unit = test.analysis.scales.span();
  const Kind length = Print(test).as(kind::length);
  return fmt::format("; the imaged length is {} {} than the force shows (median of {}, scatter {})",
                     readable(std::abs(unit * imaged.offset.value), unit * imaged.offset.standard_error, length),
                     imaged.offset.value > 0 ? "less" : "more", format_count(imaged.points.size(), "point", "points"),
                     format_roughly(unit * imaged.scatter, length));
}

std::string friction_in_words(T test, const std::vector<Finding>& findings) {
  const FrictionFit& fit = test.analysis.fit;
  if (!test.judgement.tells_friction) return "none can be read off a specimen that loses stiffness";
  if (fit.mu0_is_bound)
    return fmt::format("{} (95 %){}; it cannot be distinguished from zero", mean_friction(fit), if_lost_in_words(test));
  const double slid = 0.5 * (fit.S_end - fit.S_begin);
  const auto on_rollers = friction_on_rollers(test);
  std::string words = fmt::format(
      "{}{} averaged over the {} that slid over each support", mean_friction(fit), on_rollers ? " on knife edges," : "",
      format_roughly(test.analysis.scales.physical_length(slid), Print(test).as(kind::length)));
  words += if_lost_in_words(test);
  if (on_rollers) words += "; " + *on_rollers;
  const PointwiseFriction& read = test.analysis.pointwise_friction;
  if (std::isfinite(read.median)) {
    const bool above = read.low80 > fit.mu0.value, below = read.high80 < fit.mu0.value;
    words += fmt::format("; {:.2f} to {:.2f} {}", read.low80, read.high80,
                         above   ? "where the specimen came to rest, more than where it slipped"
                         : below ? "where the specimen was read, less than beside it"
                                 : "along it");
  }
  words += imaged_length_in_words(test);
  const bool has_wave = fit.wave_claimed && !fit.waves.empty();
  if (has_wave)
    words += fmt::format("; it repeats every {}",
                         format_roughly(test.analysis.scales.physical_length(fit.waves.front().wavelength.value),
                                        Print(test).as(kind::length)));
  else if (fit.model == ProfileModel::roughness)
    words += "; no regular spacing";
  for (const std::string_view code : {"changing_friction", "hidden_waves"})
    if (const Finding* found = finding_in(findings, code); found && found->severity == Severity::condition)
      words += "; " + found->short_form;
  return words;
}

std::string work_in_words(T test, const Verdict& verdict) {
  const MeasuredEnergy& energy = test.analysis.energy;
  const Print print(test);
  const bool depends_on_supports = friction_on_rollers(test) || verdict.finding == "supports_not_stated";
  const std::string whole = print.energy(energy.work_of_fracture);
  const bool is_least = has_least_share(test) && !depends_on_supports;
  const std::string part =
      is_least ? fmt::format("at least {} of {} ({})", print.energy(energy.least_share() * energy.work_of_fracture),
                             whole, format_percent(energy.least_share()))
               : fmt::format("{} of {} ({})", print.energy(energy.account.friction + energy.account.snaps), whole,
                             share_in_words(test));
  return fmt::format("{} went into friction{}{}", part, depends_on_supports ? " if the supports are knife edges" : "",
                     drops_of(test) == 0 || slips_at_all(test.judgement.causes) ? ""
                     : depends_on_supports                                      ? " and the drops are slips"
                                                                                : " if the drops are slips");
}

std::string_view source_of(StiffnessSource source) {
  return name_in_order<StiffnessSource::initial_slope>(source, {"stated", "stated", "initial slope"});
}

// What modulus would say where the beginning, which friction bends least, is not as steep; empty unless the stiffness is the beginning's.
std::string straight_part_in_words(T test) {
  const SmallDeflection& numbers = test.small_deflection;
  if (test.stiffness != StiffnessSource::initial_slope || test.measurement.straight_is_initial ||
      !numbers.bending_stiffness)
    return "";
  const double error = *numbers.bending_stiffness * numbers.stiffness.standard_error / numbers.stiffness.value;
  const double EI = test.analysis.scales.bending_stiffness();
  constexpr double clearly = 2;
  if (std::abs(*numbers.bending_stiffness - EI) <
      clearly * elementary::length(error, EI * test.analysis.bending_stiffness_error))
    return "";
  return fmt::format("; the steepest part, rows {} to {}, which friction may have steepened: {}",
                     file_row(test, numbers.first), last_file_row(test.measurement, numbers.last - 1),
                     readable(*numbers.bending_stiffness, error, Print(test).as(kind::bending_stiffness)));
}

std::string stiffness_in_words(T test, bool tells) {
  const TestAnalysis& analysis = test.analysis;
  const Print print(test);
  const double EI = analysis.scales.bending_stiffness();
  const Kind stiffness = print.as(kind::bending_stiffness);
  const std::string beforehand =
      fmt::format("{}: {}", source_of(test.stiffness), readable(EI, EI * analysis.bending_stiffness_error, stiffness));
  if (!tells) return "EI " + beforehand + straight_part_in_words(test);
  const Estimate& fitted = analysis.fit.bending_stiffness;
  std::string words = fmt::format("EI {} ({}{})", readable(EI * fitted.value, EI * fitted.standard_error, stiffness),
                                  beforehand, straight_part_in_words(test));
  if (test.section_moment)
    words +=
        fmt::format(", E {}", readable(EI * fitted.value / *test.section_moment,
                                       EI * fitted.standard_error / *test.section_moment, print.as(kind::pressure)));
  const double curvature = greatest_curvature(analysis.profile_at_fit, analysis.rig.fibre);
  if (test.surface && std::isfinite(curvature)) {
    const double strain = test.surface->strain(curvature);
    words += fmt::format("; strain up to {}", format_relative(strain));
    if (test.strain_at_break && strain > *test.strain_at_break)
      words += fmt::format(", beyond the {} at which it should break", format_relative(*test.strain_at_break));
    if (curvature > test.nose_curvature) words += "; it wrapped the nose";
  }
  return words;
}

std::string assumed_in_words(T test) {
  const Supports& supports = test.analysis.rig.fibre.supports();
  const Measurement& measurement = test.measurement;
  const Print print(test);
  std::vector<std::string> parts;
  if (!measurement.test.rig->states_supports()) parts.emplace_back("knife edges");
  if (supports.half_depth == 0) parts.emplace_back("no thickness");
  parts.push_back(measurement.contact == ContactSource::first_point || measurement.contact_offset == 0
                      ? "contact at the zero of the file"
                      : fmt::format("contact at {}, as {}", print.own(measurement.contact_offset, kind::length),
                                    measurement.contact == ContactSource::stated ? "stated" : "found"));
  parts.emplace_back("a slender, straight, elastic beam, its nose at midspan to 3 % of the span");
  if (!measurement.relaxation)
    parts.push_back(fmt::format("a stiffness that does not relax during the test (slow deviations of the force to {})",
                                format_relative(test.analysis.rig_errors.slow_force)));
  if (test.analysis.fit.overshoots && !measurement.test.rig->snaps)
    parts.emplace_back("snaps that overshoot, as the record shows");
  std::vector<std::string> errors;
  for (const auto& [what, error, kind] : assumed_errors(test))
    errors.push_back(fmt::format(
        "{} to {}", what,
        kind.name == kind::length.name ? format_roughly(error, print.as(kind::length)) : format_relative(error)));
  if (!errors.empty()) parts.push_back(fmt::format("{}: state yours and the error shrinks", fmt::join(errors, ", ")));
  return fmt::format("{}", fmt::join(parts, "; "));
}

// What the passes of a record say together; empty of a record of one.
std::string reload_in_words(T test) {
  if (!test.passes) return "";
  const PassesFit& passes = *test.passes;
  if (passes.status != PassesStatus::ok)
    return passes.is_reloaded
               ? fmt::format("{} of the stiffness lost, by the forces of two loadings", loss_in_words(passes))
               : std::string();
  std::vector<std::string> frictions;
  constexpr std::size_t most = 6;  // passes in a row of the screen
  for (const PassFriction& pass : passes.passes)
    if (std::isfinite(pass.friction.value) && frictions.size() < most)
      frictions.push_back(fmt::format("{:.2f} sliding {}", pass.friction.value,
                                      pass.rows.direction == Direction::loading ? "in" : "out"));
  std::string words =
      fmt::format("{}: friction {}", format_count(passes.passes.size(), "pass", "passes"), fmt::join(frictions, ", "));
  if (!passes.is_reloaded) return words;
  words += fmt::format("; {} of the stiffness lost", loss_in_words(passes));
  if (passes.loss_needed > 0) words += "; " + need_in_words(passes);
  if (passes.drops_again > 0)
    words += fmt::format("; {} came again", format_count(passes.drops_again, "drop", "drops"));
  return words;
}

std::vector<AnswerRow> rows_of(T test, const std::vector<Finding>& findings, const Verdict& verdict) {
  std::vector<AnswerRow> rows{{"drops", drops_in_words(test)}};
  const bool tells = is_fitted(test) && (!is_refused(findings) || verdict.code == VerdictCode::crack);
  if (drops_of(test) > 0) rows.push_back({"slip or crack", slip_or_crack_in_words(test)});
  if (tells) {
    rows.push_back({"friction", friction_in_words(test, findings)});
    if (tells_work(test)) rows.push_back({"work", work_in_words(test, verdict)});
  }
  const bool is_bent_little = test.analysis.status == AnalysisStatus::deflection_too_small;
  if (const std::string reload = reload_in_words(test); (tells || is_bent_little) && !reload.empty())
    rows.push_back({"reload", reload});
  const bool tells_friction = tells && test.judgement.tells_friction;
  rows.push_back({"stiffness", stiffness_in_words(test, tells_friction)});
  if (tells_friction && test.analysis.fit.friction_by)
    rows.push_back({"hangs on", sensitivities_in_words(test, tells_work(test))});
  rows.push_back({"assumed", assumed_in_words(test)});
  return rows;
}

// The remedy of what the verdict rests on; else of the weightiest note. What speaks against an answer has its remedy beside it.
std::string next_step(const Verdict& verdict, const std::vector<Finding>& findings) {
  if (const Finding* told = finding_in(findings, verdict.finding); told && !told->remedy.empty()) return told->remedy;
  for (const Finding& finding : findings)
    if ((finding.severity == Severity::condition || finding.severity == Severity::note) && !finding.remedy.empty())
      return finding.remedy;
  return "";
}

}  // namespace

Answer answer_of(T test) {
  std::vector<Finding> findings = findings_of(test);
  Verdict verdict = verdict_whatever_the_supports(test, findings);
  std::vector<AnswerRow> rows = rows_of(test, findings, verdict);
  std::string next = next_step(verdict, findings);
  return {std::move(verdict), std::move(rows), std::move(findings), std::move(next)};
}

}  // namespace flexslip
