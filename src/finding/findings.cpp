#include "finding/findings.h"

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
#include "data/small_deflection.h"
#include "finding/clauses.h"
#include "finding/printed.h"
#include "finding/sensitivities.h"
#include "inference/first_passages.h"
#include "inference/process_mode.h"
#include "io/text.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;
using Found = std::optional<Finding>;

constexpr double max_deflection = 0.8;   // [L] no specimen reaches more over its supports
constexpr std::size_t enough_drops = 3;  // to determine the load train from drops
constexpr std::string_view image_of_supports =
    "Record images of a support: they show whether, and how far, the specimen slides.";

const Check* check_of(T test, CheckKind kind) {
  const auto& checks = test.analysis.checks;
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& check) { return check.kind == kind; });
  return found == checks.end() ? nullptr : &*found;
}

// True if the stated stiffness contradicts the initial slope and no earlier loss of stiffness
// explains it.
bool contradicts_slope(T test) {
  return test.analysis.stiffness_implausible && test.stiffness != StiffnessSource::initial_slope &&
         !(test.passes && !test.passes->is_followed && is_lost(*test.passes));
}

bool is_deflection_sufficient(T test) { return test.analysis.status != AnalysisStatus::deflection_too_small; }

double max_deflection_of(T test) {
  const auto& w = test.analysis.reduced.deflection;
  return w.empty() ? 0 : *std::max_element(w.begin(), w.end());
}

std::string load_train_in_words(T test) {
  const double stiffness = test.analysis.rig.stiffness;
  return std::isfinite(stiffness) ? Print(test).own(test.analysis.scales.physical_stiffness(stiffness), kind::stiffness)
                                  : "∞";
}

// Instructions in keys of a case, or in flags if the test was stated by flags (case/case_file.h).
std::string to_change(T test, KeyChange change) {
  return instruction_to_set(test.measurement.test, {std::move(change)});
}
std::string rig_keys(T test, const std::vector<std::string>& names) {
  return keys_in_words(test.measurement.test, "rig", names);
}

// Checks that assume sliding do not apply to an unusable fit or to a specimen that lost stiffness.
bool is_without_sliding_checks(T test) {
  return contradicts_slope(test) || test.analysis.model_implausible || !test.judgement.determines_friction;
}

Finding checked(T test, const Check& check, std::string passed, std::string failed, std::string short_form,
                std::string remedy) {
  Finding finding{.severity = check.outcome == CheckOutcome::passed ? Severity::passed : Severity::doubt,
                  .sentence = check.outcome == CheckOutcome::passed ? std::move(passed) : std::move(failed)};
  finding.is_check = true;
  if (finding.severity == Severity::doubt) {
    finding.short_form = std::move(short_form);
    finding.remedy = std::move(remedy);
  }
  for (const auto& [name, value, is_force] : check.numbers)
    finding.numbers.push_back(is_force ? FindingNumber{name, test.analysis.scales.physical_force(value), kind::force}
                                       : FindingNumber{name, value});
  return finding;
}

Finding unjudged(std::string sentence) { return {.severity = Severity::unjudged, .sentence = std::move(sentence)}; }

// A likely input error that explains this ratio of stiffnesses, to follow a sentence without its full stop.
std::string likely_unit_error(double times) {
  struct UnitError {
    double times;
    std::string_view words;
    double near = 1.5;  // friction and a guessed modulus change the ratio by less
  };
  constexpr std::array errors{UnitError{0.25, ". The ends may be clamped, which the model excludes", 1.2},
                              UnitError{1.0 / 16, ". Perhaps a radius for the diameter was stated"},
                              UnitError{16, ". Perhaps a diameter for the radius was stated"},
                              UnitError{1e-3, ". Perhaps a unit is wrong: N for mN, or MPa for GPa"},
                              UnitError{1e3, ". Perhaps a unit is wrong: mN for N, or GPa for MPa"},
                              UnitError{1e-6, ". Perhaps a unit of force or modulus is wrong"},
                              UnitError{1e6, ". Perhaps a unit of force or modulus is wrong"},
                              UnitError{1e-9, ". Perhaps the unit of the span is wrong: mm for um"},
                              UnitError{1e9, ". Perhaps the unit of the span is wrong: um for mm"}};
  for (const auto& error : errors)
    if (times < error.near * error.times && times > error.times / error.near) return std::string(error.words);
  return "";
}

// The difference between the record and sliding on any friction, as a sentence; empty if it is
// unknown.
std::string misfit_sentence(T test) {
  const TestAnalysis& analysis = test.analysis;
  const double below = 1 - analysis.frictionless_force_ratio.median,
               deepest = 1 - analysis.frictionless_force_ratio.least;
  constexpr double noticeable = 0.01;
  if (below > noticeable)
    return fmt::format(" Beyond a deflection of a tenth of the span, the force is {} below the frictionless curve.",
                       format_percent(below));
  if (deepest > noticeable)
    return fmt::format(" The force falls to {} below the frictionless curve.", format_percent(deepest));
  return is_fitted(test)
             ? fmt::format(" The best fit misses the force by {} of its maximum.",
                           format_share(analysis.fit.residual_rms, *std::max_element(analysis.reduced.force.begin(),
                                                                                     analysis.reduced.force.end())))
             : "";
}

// The force before contact is not constant, although the evaluation assumes so.
Found sloping_baseline(T test) {
  const Baseline& baseline = test.measurement.baseline;
  if (baseline.points == 0 || test.measurement.baseline_is_off) return std::nullopt;
  return Finding{
      .severity = Severity::doubt,
      .sentence = fmt::format("The force {} by {} before contact, {:.0f} times its standard error.",
                              baseline.settles_by != 0 ? "settles"
                              : baseline.change > 0    ? "drifts up"
                                                       : "drifts down",
                              readable(std::abs(baseline.change), baseline.error, Print(test).as(kind::force)),
                              std::abs(baseline.change) / baseline.error),
      .short_form = "the force drifts before contact",
      .remedy = capitalised(to_change(test, {"record", "zero", "\"slope\""})) + " to subtract it.",
      .numbers = {{"change", baseline.change, kind::force}, {"change_error", baseline.error, kind::force}}};
}

std::string to_find_contact(T test) { return to_change(test, {"record", "contact", "\"find\""}); }

// True if the contact found in the record differs from the one used.
bool has_other_contact(T test) {
  const Measurement& measurement = test.measurement;
  const auto& [value, error, low, high] = measurement.own_contact.offset;
  constexpr double errors = 2, noticeable = 0.0012;  // [1], [L] less changes friction by less than its interval
  return measurement.own_contact.status == ContactStatus::found && measurement.contact != ContactSource::found &&
         std::abs(value) > std::max(errors * error, noticeable * test.analysis.scales.span());
}

Found other_contact(T test) {
  if (!has_other_contact(test)) return std::nullopt;
  const Measurement& measurement = test.measurement;
  const auto& [value, error, low, high] = measurement.own_contact.offset;
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format(
                     "The loading starts {} {} {}{}.", readable(std::abs(value), error, Print(test).as(kind::length)),
                     value > 0 ? "after" : "before",
                     measurement.contact == ContactSource::stated ? "the stated contact" : "the zero of the file",
                     measurement.own_contact.settles ? ", once the contact has settled" : ""),
                 .short_form = fmt::format("starts {} {}", Print(test).own(std::abs(value), kind::length),
                                           value > 0 ? "late" : "early"),
                 .remedy = capitalised(to_find_contact(test)) + " to start there.",
                 .numbers = {{"offset", value, kind::length}, {"offset_error", error, kind::length}}};
}

// True if the record begins at a negative force: the load cell was not set to zero.
bool begins_below_zero(T test) {
  return test.measurement.test.record->zero == ForceZeroRule{} && test.measurement.begins_under < 0;
}

std::string to_set_zero(T test) {
  const std::string force = Print(test).own(test.measurement.begins_under, kind::force);
  return to_change(test, {"record", "zero", fmt::format("\"{}\"", force)});
}

// A preload that the specimen bears and a load cell that was not set to zero look alike.
Found begins_under_force(T test) {
  const Measurement& measurement = test.measurement;
  const double force = measurement.begins_under;
  const std::string printed = Print(test).own(force, kind::force);
  if (begins_below_zero(test))
    return Finding{
        .severity = Severity::doubt,
        .sentence = fmt::format("The record begins at a negative force of {}; no specimen pulls at the nose.", printed),
        .short_form = fmt::format("begins at {}", printed),
        .remedy = fmt::format("The load cell was not set to zero: {}.", to_set_zero(test)),
        .numbers = {{"force", force, kind::force}}};
  if (measurement.test.record->zero != ForceZeroRule{} || !(force > 0) || measurement.contact != ContactSource::found ||
      measurement.test.record->contact)
    return std::nullopt;
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("The record begins at {}, interpreted as a preload of the specimen.", printed),
                 .short_form = fmt::format("begins at {}", printed),
                 .remedy = fmt::format("If the load cell was not set to zero, {}; otherwise, {}.", to_set_zero(test),
                                       to_find_contact(test)),
                 .numbers = {{"force", force, kind::force}}};
}

// The remedy, after the more likely error at the beginning of the record, if there is one.
std::string find_contact_or_check(T test, const std::string& remedy) {
  if (begins_below_zero(test))
    return fmt::format("The load cell was not set to zero: {}; check {}", to_set_zero(test), remedy);
  return (has_other_contact(test) ? capitalised(to_find_contact(test)) + "; check " : "Check ") + remedy;
}

// ---- Why a record has no answer

// The readings cannot come from a specimen that bends over its supports.
Found not_bent(T test) {
  const auto& force = test.analysis.record.force;
  if (is_fitted(test) || force.empty()) return std::nullopt;
  if (!(*std::max_element(force.begin(), force.end()) > 0))
    return Finding{.severity = Severity::refusal,
                   .sentence = "The force is never above zero.",
                   .short_form = "no force above zero",
                   .remedy = "Check which column is the force, and its sign."};
  const double deepest = max_deflection_of(test);
  if (!(deepest > 0))
    return Finding{
        .severity = Severity::refusal,
        .sentence = "The displacement never reaches the contact point, so the specimen is not bent.",
        .short_form = "not bent",
        .remedy = fmt::format("Check the zero of the displacement and of the force; {}.", to_find_contact(test))};
  constexpr double slender = 1.0 / 400;  // [L] half the depth of a specimen whose deflection should suffice
  const bool explains_slope = test.analysis.rig.fibre.supports().half_depth <= slender || !contradicts_slope(test);
  if (is_deflection_sufficient(test) || deepest <= max_deflection || !explains_slope) return std::nullopt;
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("The deflection reaches {}, which is impossible. It is {:.2g} times the span of {}.",
                              Print(test).length(deepest), deepest, Print(test).length(1)),
      .short_form = "deflection beyond the span",
      .remedy = "Check the units and the zero of the displacement.",
      .numbers = {{"deflection_over_span", deepest}}};
}

// A stage moves evenly from row to row. The deflection jumps in each drop, because the load train
// relaxes.
Found deflection_for_stage(T test) {
  const TrainInDrops& train = test.analysis.statistics.train;
  if (!is_deflection_sufficient(test) || !test.measurement.is_derived || std::isinf(test.analysis.rig.stiffness) ||
      train.drops < enough_drops)
    return std::nullopt;
  constexpr double surely = 3, half = 0.5;
  if (!(train.leap - surely * train.leap_error > half)) return std::nullopt;
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("The column used as the stage holds the deflection. In each of the {} drops it jumps by "
                              "{:.2f} of the relaxation of the load train; a stage moves evenly.",
                              train.drops, train.leap),
      .short_form = "the stage jumps like a deflection",
      .remedy = "Name that column as the deflection, or the column of the stage.",
      .numbers = {{"leap", train.leap}}};
}

// In a drop the specimen bends by the relaxation of the load train. A force that lags shows it too
// late.
Found train_by_drops(T test) {
  const TrainInDrops& train = test.analysis.statistics.train;
  const std::size_t drops = test.analysis.drops.drops.size();
  if (train.misfits < enough_drops || 2 * train.misfits < drops || test.analysis.statistics.rounded.lag > 0 ||
      !(train.compliance > 0))
    return std::nullopt;
  const std::string as_on = format_roughly(1 / train.compliance, Print(test).as(kind::stiffness));
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format(
          "{} of {} drops contradict the stated load train ({}). While the force falls, the specimen bends as on {}.",
          train.misfits, drops, load_train_in_words(test), as_on),
      .short_form = fmt::format("load train as of {}", as_on),
      .remedy = fmt::format("State the stiffness of the load train ({}).", rig_keys(test, {"stiffness"})),
      .numbers = {{"misfits", static_cast<double>(train.misfits)},
                  {"load_train", 1 / train.compliance, kind::stiffness}}};
}

// If only the deflection was measured, the machine cannot have moved back while the force fell.
Found train_by_reckoned_stage(T test) {
  const std::optional<LeastTrain>& softest = test.measurement.least_train;
  if (!softest) return std::nullopt;
  const double train = softest->fall / softest->advance;
  const double stated = test.analysis.scales.physical_stiffness(test.analysis.rig.stiffness);
  const Print print(test);
  const std::string bound = format_roughly(train, print.as(kind::stiffness));
  return Finding{.severity = Severity::refusal,
                 .sentence = fmt::format(
                     "The load train is stiffer than stated ({}): stiffer than {}. After row {} the deflection "
                     "rises by only {} while the force falls by {}; on the stated load train the machine "
                     "would have moved back by {}.",
                     load_train_in_words(test), bound, file_row(test, softest->before),
                     format_roughly(softest->advance, print.as(kind::length)),
                     format_roughly(softest->fall, print.as(kind::force)),
                     format_roughly(softest->fall / stated - softest->advance, print.as(kind::length))),
                 .short_form = fmt::format("load train stiffer than {}", bound),
                 .remedy = fmt::format("State the stiffness of the load train ({}).", rig_keys(test, {"stiffness"})),
                 .numbers = {{"row", static_cast<double>(file_row(test, softest->before))},
                             {"least_load_train", train, kind::stiffness}}};
}

Found too_few_points(T test) {
  if (is_deflection_sufficient(test)) return std::nullopt;
  const std::size_t rows = test.analysis.record.force.size();
  const double deepest = max_deflection_of(test), from = min_fit_deflection(deepest, test.analysis.rig.fibre);
  return Finding{
      .severity = Severity::refusal,
      .sentence =
          fmt::format("Fewer than {} of {} lie beyond a deflection of {}, the minimum for determining friction. "
                      "The maximum deflection is {}, {} of the span of {}.",
                      min_readings, format_count(rows, "row", "rows"), Print(test).length(from),
                      Print(test).length(deepest), format_relative(deepest), Print(test).length(1)),
      .short_form = "deflection too small",
      .remedy =
          "Use flexslip modulus for stiffness and strength. To determine friction, bend farther, or bend a thinner "
          "specimen. If the deflection should be larger, check the units.",
      .numbers = {{"deflection_over_span", deepest}}};
}

// A test whose deflection is too small to determine friction.
Found force_sinks(T test) {
  if (!sinks(test.analysis)) return std::nullopt;
  const Sinking& sinking = test.analysis.statistics.sinking;
  const std::size_t row = file_row(test, sinking.from);
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("The force decreases by {} after row {} without a drop. The specimen yielded, "
                                         "relaxed or broke slowly: no elastic specimen does that at this deflection.",
                                         format_percent(sinking.share), row),
                 .short_form = fmt::format("the force decreases by {}", format_percent(sinking.share)),
                 .remedy = "Use flexslip modulus for stiffness and strength.",
                 .numbers = {{"sunk", sinking.share}, {"row", static_cast<double>(row)}}};
}

// If the deflection is taken from the stage, a compliant load train makes the specimen look too
// soft.
Found wrong_load_train(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (Found found = train_by_reckoned_stage(test)) return found;
  if (!is_deflection_sufficient(test)) return std::nullopt;
  if (Found found = train_by_drops(test)) return found;
  const double times = analysis.stiffness_to_slope_ratio;
  if (std::isfinite(analysis.rig.stiffness) || !contradicts_slope(test) || !(times > 1) ||
      !likely_unit_error(times).empty())
    return std::nullopt;
  const double train = analysis.scales.physical_stiffness(beam_stiffness / (times - 1));
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("The initial slope contradicts the stated load train (∞). With the stated bending "
                              "stiffness, the load train has about {}.",
                              format_roughly(train, Print(test).as(kind::stiffness))),
      .short_form = fmt::format("load train as of {}", format_roughly(train, Print(test).as(kind::stiffness))),
      .remedy = fmt::format("State the stiffness of the load train ({}). If it is rigid, check the modulus, the "
                            "section and the span.",
                            rig_keys(test, {"stiffness"})),
      .numbers = {{"load_train", train, kind::stiffness}, {"stated_over_slope", times}}};
}

Found wrong_stiffness(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (!contradicts_slope(test)) return std::nullopt;
  const double times = analysis.stiffness_to_slope_ratio;
  return Finding{.severity = Severity::refusal,
                 .sentence = fmt::format("The stated bending stiffness is {} times that of the initial slope{}.",
                                         format_roughly(times, kind::number), likely_unit_error(times)),
                 .short_form = fmt::format("stiffness {:.2f} times the slope's", times),
                 .remedy = fmt::format(
                     "Check the modulus, the section, the span, the load train, the columns and their units. To take "
                     "the stiffness from the record, {}.",
                     to_change(test, {"specimen", "modulus", "\"fit\""})),
                 .numbers = {{"stated_over_slope", times}}};
}

// [Pa] Young's modulus by the fit, or else by the initial slope or the case; NaN without a section.
double modulus_of(T test) {
  if (!test.section_moment) return std::numeric_limits<double>::quiet_NaN();
  const double fitted = is_fitted(test) ? test.analysis.fit.bending_stiffness.value : 1;
  return fitted * test.analysis.scales.bending_stiffness() / *test.section_moment;
}

// Wrong units, or a load train so soft that it takes the whole displacement, cause it.
Found impossible_modulus(T test) {
  const double modulus = modulus_of(test);
  if (!(modulus > max_material_modulus)) return std::nullopt;
  const auto in_words = [&](double pressure) { return format_roughly(pressure, Print(test).as(kind::pressure)); };
  return Finding{.severity = Severity::refusal,
                 .sentence = fmt::format("The modulus would be {}; no material exceeds {}.", in_words(modulus),
                                         in_words(max_material_modulus)),
                 .short_form = fmt::format("modulus {}", in_words(modulus)),
                 .remedy = "Check the section, the span, the load train, the columns and their units.",
                 .numbers = {{"modulus", modulus, kind::pressure}}};
}

Found not_explained(T test) {
  if (test.analysis.status != AnalysisStatus::not_explained && !test.analysis.model_implausible) return std::nullopt;
  const std::string damaged =
      is_fitted(test) ? " If they are right, the specimen yielded or was damaged: unload and load again." : "";
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("No friction explains this record.{}", misfit_sentence(test)),
      .short_form = "no friction explains it",
      .remedy = find_contact_or_check(test,
                                      "the columns (flexslip read FILE shows them), their units, the span, the "
                                      "section, the modulus, the supports and the load train." +
                                          damaged)};
}

// ---- Doubts about an answer

// "a third", after two loadings.
std::string next_ordinal(std::size_t loadings) {
  constexpr std::array words{"a second", "a third", "a fourth", "a fifth"};
  return loadings >= 1 && loadings <= words.size() ? words[loadings - 1] : "one more";
}

// Unloading and loading again distinguishes slips from cracks, if the specimen still exists.
std::string reload_remedy(T test) {
  const std::string force = unloading_force(test);
  const std::string how_far = force.empty() ? "" : fmt::format(" to {} or less", force);
  if (test.measurement.end == MeasurementEnd::failure || test.measurement.end == MeasurementEnd::until)
    return fmt::format("In the next test, unload{} before the specimen breaks, and load again.", how_far);
  if (is_reloaded(test.analysis))
    return fmt::format("Unload and reload the next specimen after every few drops: this one lost {} of its stiffness.",
                       loss_in_words(*test.analysis.passes));
  const auto& [loading, of] = test.measurement.loading;
  if (of == 1) return fmt::format("Unload{} and load again, to measure the loss of stiffness.", how_far);
  return fmt::format("Load {} time{}, to measure the loss in loading {}.", next_ordinal(of),
                     force.empty() ? "" : fmt::format(", from {} or less", force), loading);
}

Found cracks(T test) {
  if (test.judgement.conclusion != Conclusion::cracks || is_reloaded(test.analysis) || lost_before(test.analysis))
    return std::nullopt;
  const DropFeatures& features = test.analysis.drop_features;
  const std::string causes = causes_in_words(test);
  const bool by_drops = features.drops > 0 && loses_at_all(test.judgement.causes, false);
  return Finding{
      .severity = Severity::suspicion,
      .sentence = by_drops
                      ? fmt::format("The specimen lost stiffness in its drops. Probability of {}.", causes)
                      : "The force fell by more than friction can explain: the specimen lost stiffness or yielded.",
      .short_form = by_drops ? causes : "lost stiffness",
      .remedy = reload_remedy(test),
      .numbers = {{"loss_needed", features.loss_needed}, {"loss_recovered", features.loss_recovered}}};
}

// The change of the specimen up to the reload.
Found changed_reload(T test) {
  if (!test.passes || !test.passes->is_reloaded) return std::nullopt;
  const PassesFit& passes = *test.passes;
  const bool is_judged_lost = is_reloaded(test.analysis) && (test.judgement.conclusion == Conclusion::cracks ||
                                                             test.judgement.conclusion == Conclusion::slips_and_damage);
  const std::vector<FindingNumber> numbers{{"loss", passes.loss.value}, {"loss_error", passes.loss.standard_error}};
  if (is_gained(passes))
    return Finding{
        .severity = Severity::doubt,
        .sentence = fmt::format("On reloading, the specimen is {:.1f} ± {:.1f} % stiffer: the contact or the "
                                "bending stiffness is wrong.",
                                -100 * passes.loss.value, 100 * passes.loss.standard_error),
        .short_form = fmt::format("{:.0f} % stiffer on reloading", -100 * passes.loss.value),
        .remedy = "Check whether the contact or the rig has changed.",
        .numbers = numbers};
  if (is_settled(passes))
    return Finding{.severity = Severity::note,
                   .sentence = "The specimen or a support settled permanently, and no stiffness was lost.",
                   .short_form = "settled",
                   .remedy = "Check whether the specimen is crushed at the supports or under the nose.",
                   .numbers = {{"settled", passes.settled.value}}};
  if (!is_judged_lost && !is_lost(passes)) return std::nullopt;
  return Finding{.severity = Severity::note,
                 .sentence = fmt::format("The specimen lost {} of its stiffness.", loss_in_words(passes)),
                 .short_form = fmt::format("{} of the stiffness lost", format_percent(passes.loss.value)),
                 .remedy = "Unload the next specimen earlier, before it loses stiffness, and load it again.",
                 .numbers = numbers};
}

// Friction above the limit, or negative.
Found implausible_friction(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (!is_friction_implausible(analysis)) {
    if (!(analysis.pointwise_friction.median < min_friction)) return std::nullopt;
    return Finding{.severity = Severity::doubt,
                   .sentence = "The force lies below the frictionless curve.",
                   .short_form = "below the frictionless curve",
                   .remedy = find_contact_or_check(test, "the modulus, the section and the span.")};
  }
  const double limit = std::min(analysis.suspects.limit, analysis.max_friction);
  const std::string how =
      analysis.suspects.suspect
          ? fmt::format("above {:.3g} at {} of {} points beyond a tenth of the span", analysis.suspects.limit,
                        analysis.suspects.points.size(), analysis.suspects.points_judged)
          : fmt::format("at least {:.2f} on average (95 %)", analysis.fit.mu0.low);
  return Finding{
      .severity = Severity::suspicion,
      .sentence = fmt::format("Explaining the record requires implausible friction, {}.", how),
      .short_form = fmt::format("friction above {:.2g}", limit),
      .remedy = analysis.fit.mu0.low > analysis.max_friction
                    ? fmt::format("The rollers turn on their pins at a friction of {:.3g}: check whether "
                                  "they are stuck.",
                                  analysis.max_friction)
                : !test.measurement.test.rig->states_supports()
                    ? fmt::format("If the supports are rollers, state {}: treated as knife edges, they would "
                                  "look the same.",
                                  rig_keys(test, {"roller_radius"}))
                    : std::string(image_of_supports)};
}

Found misses_force(T test) {
  const Check* check = check_of(test, CheckKind::residuals);
  if (!check) return std::nullopt;
  const double share = number_of(*check, "residual_rms") / number_of(*check, "greatest_force");
  const std::string misses = fmt::format(
      "The simulated fit misses the force by {} of its maximum (limit {:g} %), over the {} of {} rows with information "
      "on friction.",
      format_relative(share), 100 * max_residual, test.analysis.fit.readings, test.analysis.record.force.size());
  return checked(test, *check, misses, misses, "the fit misses the force",
                 "Check the modulus, the section, the span and the units.");
}

Found drops_differ(T test) {
  const Check* check = check_of(test, CheckKind::drops);
  if (!check) return std::nullopt;
  if (is_without_sliding_checks(test))
    return unjudged("The fit cannot be used, so its drops are not compared with the record.");
  if (check->outcome == CheckOutcome::not_possible)
    return unjudged("The model has no samples of the profile whose drops could be counted.");
  const auto number = [&](std::string_view name) { return number_of(*check, name); };
  const double low = number("draws_low"), high = number("draws_high");
  const std::string sentence =
      fmt::format("Counted alike, the record has {:.0f} drops and simulations of the fit have {}{}.", number("record"),
                  low < high ? fmt::format("{:.0f} to {:.0f}", low, high) : fmt::format("{:.0f}", low),
                  check->outcome == CheckOutcome::passed ? "" : "; chance does not explain the difference");
  return checked(test, *check, sentence, sentence,
                 fmt::format("{:.0f} drops, fit {:.0f} to {:.0f}", number("record"), low, high),
                 "The table of drops in the full answer shows which can be cracks.");
}

Found coloured_noise(T test) {
  const Check* check = check_of(test, CheckKind::whiteness);
  if (!check) return std::nullopt;
  if (is_without_sliding_checks(test)) return unjudged("The fit cannot be used, so its residuals are not judged.");
  if (check->outcome == CheckOutcome::not_possible)
    return unjudged("A constant friction cannot predict the next reading.");
  const double p = number_of(*check, "p_value");
  const std::string probability =
      p < min_p_of_noise ? fmt::format("p < {:g}", min_p_of_noise) : fmt::format("p = {}", format_significant(p, 2));
  Finding finding = checked(
      test, *check,
      fmt::format("The residuals are consistent with white noise ({}; limit {:g}).", probability, min_p_of_noise),
      fmt::format("The residuals are not white noise ({}; limit {:g}).", probability, min_p_of_noise),
      "the residuals are not white noise", "");
  // The fit allows for correlated noise and slow deviations, so that other coloured noise changes
  // the answer little.
  if (finding.severity == Severity::doubt) finding.severity = Severity::note;
  return finding;
}

// The passes could not be compared, so the answer uses the evaluated loading alone.
Found passes_apart(T test) {
  if (!test.passes || test.passes->status == PassesStatus::ok) return std::nullopt;
  const bool is_too_short = test.passes->status == PassesStatus::not_sliding_out;
  const std::string force = unloading_force(test);
  return Finding{
      .severity = Severity::condition,
      .sentence =
          is_too_short
              ? fmt::format("Loading and unloading cannot be compared: the specimen slides outwards in {} only.",
                            format_count(test.passes->sliding_out, "row", "rows"))
              : "Loading and unloading cannot be compared: no friction and no loss of stiffness explain both.",
      .short_form = is_too_short ? "not unloaded far enough" : "passes not explained",
      .remedy = is_too_short ? force.empty() ? "Unload farther, and record more rows."
                                             : fmt::format("Unload to {} or less, and record more rows.", force)
                             : "Check the contact, the bending stiffness and the load train.",
      .numbers = {{"rows", static_cast<double>(test.passes->sliding_out)}}};
}

// The stage moves much farther than usual between two rows, and the record does not show what
// happened in between.
Found gap_in_stage(T test) {
  const WidestStep& widest = test.analysis.statistics.widest_step;
  constexpr double far = 20, part = 0.02;  // [typical step], [total travel]
  if (!is_deflection_sufficient(test) || !(widest.length > far * widest.usual && widest.share_of_travel > part))
    return std::nullopt;
  const std::size_t row = file_row(test, widest.behind);
  return Finding{
      .severity = Severity::doubt,
      .sentence = fmt::format("After row {} the stage moves by {} in one step: rows are missing, or the stage "
                              "is wrong after it. A wrong stage would change the friction.",
                              row, Print(test).own(widest.length, kind::length)),
      .short_form = fmt::format("a gap after row {}", row),
      .remedy = fmt::format("Compare with the friction before the gap: {}.",
                            to_change(test, {"record", "until", fmt::format("{}", row)})),
      .numbers = {{"step", widest.length, kind::length}, {"row", static_cast<double>(row)}}};
}

// A low-pass filter of the load cell or the machine delays the force; a symmetric filter of
// software spreads it.
Found filtered_force(T test) {
  const RoundedDrops& drops = test.analysis.statistics.rounded;
  if (!is_deflection_sufficient(test)) return std::nullopt;
  if (drops.lag > 0)
    return Finding{
        .severity = Severity::doubt,
        .sentence = fmt::format("The force lags by about {:.1f} rows, so recorded drops are smoothed and too "
                                "shallow.",
                                drops.lag),
        .short_form = fmt::format("the force lags by {:.1f} rows", drops.lag),
        .remedy = "Filter the force less, or record rows that are farther apart in time.",
        .numbers = {{"lag_in_rows", drops.lag}}};
  if (!(drops.spread > 0)) return std::nullopt;
  return Finding{
      .severity = Severity::doubt,
      .sentence = fmt::format("The force has been smoothed: each drop is spread over about {:.1f} rows and too "
                              "shallow.",
                              drops.spread),
      .short_form = "the force has been smoothed",
      .remedy = "Use the readings as they were recorded.",
      .numbers = {{"spread_in_rows", drops.spread}}};
}

Found undecided_drops(T test) {
  if (drops_of(test) == 0 || test.judgement.conclusion != Conclusion::undecided) return std::nullopt;
  const std::string causes = causes_in_words(test);
  const bool has_probability = !causes.empty();
  return Finding{
      .severity = Severity::condition,
      .sentence = has_probability
                      ? fmt::format("The drops can be slips or cracks. Probability of {}.", causes)
                      : "The drops are too small, or too near the contact, to distinguish slips from cracks.",
      .short_form = has_probability ? causes : "slips or cracks",
      .remedy = reload_remedy(test),
      .numbers = has_probability ? std::vector<FindingNumber>{{"cracks_alone", test.judgement.causes.cracks}}
                                 : std::vector<FindingNumber>{}};
}

// When a specimen is loaded again, the force does not drop where the specimen slipped or cracked
// before.
Found drops_elsewhere(T test) {
  const auto& [drops, rows] = test.drops_elsewhere;
  if (drops_of(test) > 0 || drops == 0) return std::nullopt;
  const std::string some = format_count(drops, "drop", "drops");
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("The evaluated loading has no force drop, but other loadings have {}.", some),
                 .short_form = fmt::format("{} in other loadings", some),
                 .remedy = fmt::format(
                     "Evaluate the loading with the drops: {}.",
                     instruction_to_set(test.measurement.test, {{"record", "first", fmt::format("{}", rows.first)},
                                                                {"record", "until", fmt::format("{}", rows.last)}})),
                 .numbers = {{"drops", static_cast<double>(drops)}}};
}

Found few_rows(T test) {
  constexpr double min_rows = 5;  // with four, waves are missed
  if (!(test.analysis.statistics.rows_between_drops < min_rows)) return std::nullopt;
  return Finding{
      .severity = Severity::doubt,
      .sentence = "Most rises between drops have fewer than five rows, so drops and waves of friction may be missed.",
      .short_form = "few rows between drops",
      .remedy = "Record more rows."};
}

// "1.5 % above"
std::string above_or_below(double ratio) {
  return fmt::format("{:.1f} % {}", 100 * std::abs(ratio - 1), ratio < 1 ? "below" : "above");
}

Found unexpected_stiffness(T test) {
  const Check* check = check_of(test, CheckKind::stiffness);
  if (!check) return std::nullopt;
  if (check->outcome == CheckOutcome::not_possible)
    return unjudged(test.analysis.bending_stiffness_error > 0
                        ? "With a constant friction, the bending stiffness is not fitted."
                        : "The bending stiffness is stated as exact and is not fitted.");
  const std::string sentence =
      fmt::format("The fitted bending stiffness is {} {}, {:.1f} times the error of the difference (limit {:g}).",
                  above_or_below(number_of(*check, "fitted_over_nominal")),
                  test.stiffness == StiffnessSource::initial_slope ? "that of the initial slope" : "the stated one",
                  number_of(*check, "errors"), max_stiffness_errors);
  return checked(
      test, *check, sentence, sentence,
      fmt::format("stiffness {} from the {}", signed_percent(number_of(*check, "fitted_over_nominal") - 1),
                  test.stiffness == StiffnessSource::initial_slope ? "slope" : "stated one"),
      find_contact_or_check(test, "the modulus, the section, the span, the units and the radius of the supports."));
}

// ---- Conditions

Found only_a_limit(T test) {
  const Check* check = check_of(test, CheckKind::friction);
  if (!check || is_without_sliding_checks(test)) return std::nullopt;
  Finding finding = checked(test, *check, "Friction can be distinguished from zero.",
                            fmt::format("Friction cannot be distinguished from zero; it is at most {} (95 %).",
                                        format_significant(number_of(*check, "mu0_high"), 2)),
                            "only a limit", "Bend farther, or state the bending stiffness more exactly.");
  if (finding.severity == Severity::doubt) finding.severity = Severity::condition;
  return finding;
}

// A small deflection or a record of few rows determines friction only roughly.
Found known_roughly(T test) {
  const Estimate& mu0 = test.analysis.fit.mu0;
  constexpr double rough = 0.2;  // [1] half of the interval; more than twice that of a clean test
  const double half = 0.5 * (mu0.high - mu0.low);
  if (test.analysis.fit.mu0_is_bound || !(half > rough) || !test.judgement.determines_friction) return std::nullopt;
  return Finding{.severity = Severity::condition,
                 .sentence = fmt::format("Friction is known only roughly, to ± {:.2f} (95 %).", half),
                 .remedy = "Bend farther, or state the bending stiffness more exactly.",
                 .numbers = {{"half_width", half}}};
}

// Drops may be cracks. Cracks too small to detect make the force uneven, as varying friction does.
Found no_reload(T test) {
  if (!may_have_lost_stiffness(test) || !test.judgement.determines_friction) return std::nullopt;
  const auto& [loading, of] = test.measurement.loading;
  const std::string reload = of > 1 ? fmt::format("a reload after loading {}", loading) : "a reload";
  return Finding{.severity = Severity::condition,
                 .sentence = drops_of(test) > 0
                                 ? fmt::format("Without {}, the loss of stiffness is unknown.", reload)
                                 : fmt::format("The force is uneven: friction varies, or there are cracks too small to "
                                               "detect. Without {}, the loss of stiffness is unknown.",
                                               reload),
                 .remedy = reload_remedy(test)};
}

Found supports_not_stated(T test) {
  if (!test.on_rollers) return std::nullopt;
  const TestAnalysis& rollers = test.on_rollers->analysis;
  Finding finding{
      .severity = friction_on_rollers(test) ? Severity::doubt : Severity::condition,
      .sentence = "No supports are stated; knife edges are assumed.",
      .short_form = "supports not stated",
      .remedy = fmt::format("State {}, or {}.", in_words(test.measurement.test, {"rig", "supports", "\"edges\""}),
                            rig_keys(test, {"roller_radius"}))};
  if (rollers.status == AnalysisStatus::deflection_too_small) {
    finding.sentence += fmt::format(" On {} the deflection is too small to determine friction.", usual_rollers(test));
    return finding;
  }
  if (!is_fitted(*test.on_rollers)) {
    finding.sentence += fmt::format(" On {} no friction explains the record.", usual_rollers(test));
    return finding;
  }
  const std::string friction = mean_friction(rollers.fit);
  finding.sentence += fmt::format(" On {} friction is {}.", usual_rollers(test), friction);
  finding.numbers = {
      {"roller_radius", rollers.scales.physical_length(rollers.rig.fibre.supports().radius), kind::length},
      {"mu0_on_rollers", rollers.fit.mu0.value},
      {"mu0_on_rollers_error", rollers.fit.mu0.standard_error}};
  return finding;
}

Found thickness_not_stated(T test) {
  const Test& input = test.measurement.test;
  if (test.analysis.rig.fibre.supports().half_depth > 0 || input.rig->friction_at == FrictionAt::axis ||
      !test.judgement.determines_friction)
    return std::nullopt;
  Finding finding{.severity = Severity::condition,
                  .sentence = "The thickness of the specimen is not stated.",
                  .remedy = fmt::format("State {}.", keys_in_words(input, "specimen", {"diameter", "height"}))};
  const auto& by = test.analysis.fit.friction_by;
  if (!by) return finding;
  constexpr double usual = 0.02;  // [L] of sponge spicules and many fibres
  const double more = usual * (*by)[StatedQuantity::thickness];
  finding.sentence +=
      fmt::format(" With a thickness of {}, friction would be {:.2f} {}.",
                  format_roughly(test.analysis.scales.physical_length(usual), Print(test).as(kind::length)),
                  std::abs(more), more < 0 ? "lower" : "higher");
  finding.numbers = {{"friction_moves", more}};
  return finding;
}

// Friction rarely drifts along a specimen by more than its error. A specimen that softens, relaxes
// or was loaded before looks the same.
Found changing_friction(T test) {
  const FrictionFit& fit = test.analysis.fit;
  if (test.judgement.friction_falls)
    return Finding{.severity = Severity::doubt,
                   .sentence =
                       "Friction decreases along the record. Lost stiffness, or rollers treated as knife edges, "
                       "would look the same.",
                   .short_form = "friction decreases",
                   .remedy = !test.measurement.test.rig->states_supports()
                                 ? fmt::format("If the supports are rollers, state {}; otherwise record images of a "
                                               "support.",
                                               rig_keys(test, {"roller_radius"}))
                                 : std::string(image_of_supports)};
  if (!(weight_without_roughness(fit) > 0.5) || !test.judgement.determines_friction) return std::nullopt;
  if (!(std::abs(fit.drift.value) > fit.drift.standard_error)) return std::nullopt;
  return Finding{
      .severity = Severity::condition,
      .sentence =
          "Friction drifts along the specimen by more than its error. A specimen that softens or relaxes, or a "
          "tared preload, would look the same.",
      .short_form = "friction drifts along the specimen",
      .remedy = reload_remedy(test)};
}

Found contradicts_file(T test) {
  const std::vector<std::string>& sentences = test.measurement.contradictions;
  if (sentences.empty()) return std::nullopt;
  return Finding{.severity = Severity::doubt,
                 .sentence = sentences.front(),
                 .short_form = "the file states other dimensions",
                 .remedy = "Correct the dimensions, or the file."};
}

Found relaxes(T test) {
  const auto& relaxation = test.measurement.relaxation;
  if (!relaxation) return std::nullopt;
  const Estimate& share = relaxation->share;
  const std::string lost = format_relative(relaxation->over_loading);
  return Finding{.severity = Severity::condition,
                 .sentence = fmt::format("The force decreases by {:.2f} ± {:.2f} % while the stage rests for {} at {}. "
                                         "At this rate the specimen or the "
                                         "rig relaxes by {} during the loading. The error of friction allows for {}.",
                                         100 * share.value, 100 * share.standard_error,
                                         format_count(relaxation->rows, "row", "rows"),
                                         format_count(relaxation->rests, "place", "places"), lost,
                                         format_relative(test.analysis.rig_errors.slow_force)),
                 .short_form = fmt::format("relaxes by {}", lost),
                 .remedy = "Load faster and without rests, and state the bending stiffness at that speed.",
                 .numbers = {{"relaxation", share.value},
                             {"relaxation_error", share.standard_error},
                             {"over_loading", relaxation->over_loading}}};
}

// A soft load train, widely spaced rows or noise hide short variations of friction: the specimen
// stops only on their crests.
Found hidden_waves(T test) {
  const FrictionFit& fit = test.analysis.fit;
  if (const double hidden = fit.hidden_by_rig; hidden > 0)
    return Finding{
        .severity = Severity::condition,
        .sentence = fmt::format("The load train is so soft that the specimen may slip unseen from one crest of "
                                "friction to the next; the mean would then be lower by up to {:.2f}.",
                                hidden),
        .short_form = "the soft load train may hide variations",
        .remedy = "Use a stiffer rig.",
        .numbers = {{"hidden", hidden, kind::number}}};
  if (!(weight_without_roughness(fit) > 0.5) || fit.wave_claimed || !test.judgement.determines_friction)
    return std::nullopt;
  if (std::isinf(test.analysis.rig.stiffness)) return std::nullopt;  // then it slides continuously
  constexpr double min_resolved_lengths = 20;
  const double seen = fit.share * (fit.S_end - fit.S_begin);  // [L] observed along the specimen
  if (!(min_resolved_lengths * fit.shortest_wave > seen)) return std::nullopt;
  const double shortest = test.analysis.scales.physical_length(fit.shortest_wave);
  const std::string length = format_roughly(shortest, Print(test).as(kind::length));
  return Finding{
      .severity = Severity::condition,
      .sentence = fmt::format("Variations of friction shorter than {} cannot be detected: the specimen would stop on "
                              "their crests, and the mean would be lower.",
                              length),
      .short_form = fmt::format("lower if it varies within less than {}", length),
      .remedy = "Use a stiffer rig, a quieter force or more rows to resolve shorter variations.",
      .numbers = {{"shortest_wave", shortest, kind::length}}};
}

// Groups of rules that exclude each other: only the first rule of a group that applies makes a
// finding.
enum class Group {
  alone,      // a rule without a group
  answer,     // why the test has no usable answer
  damage,     // of the specimen
  beginning,  // of the record
  reload,     // or another loading that would answer more
  certainty,  // of friction
};

// One rule and the code of its finding.
struct Rule {
  Group group;
  std::string_view code;
  Found (*find)(T test);
  bool needs_fit = true;
};

// The rules of a group are adjacent.
constexpr std::array rules{
    Rule{Group::answer, "not_bent", not_bent, false},
    Rule{Group::answer, "deflection_for_stage", deflection_for_stage, false},
    Rule{Group::answer, "wrong_load_train", wrong_load_train, false},
    Rule{Group::answer, "wrong_stiffness", wrong_stiffness, false},
    Rule{Group::answer, "impossible_modulus", impossible_modulus, false},
    Rule{Group::answer, "too_few_points", too_few_points, false},
    Rule{Group::answer, "not_explained", not_explained, false},
    Rule{Group::damage, "cracks", cracks, false},
    Rule{Group::damage, "changed_reload", changed_reload, false},
    Rule{Group::alone, "implausible_friction", implausible_friction},
    Rule{Group::beginning, "begins_under_force", begins_under_force, false},
    Rule{Group::beginning, "sloping_baseline", sloping_baseline},
    Rule{Group::beginning, "other_contact", other_contact},
    Rule{Group::alone, "misses_force", misses_force},
    Rule{Group::alone, "drops_differ", drops_differ},
    Rule{Group::alone, "coloured_noise", coloured_noise},
    Rule{Group::alone, "passes_apart", passes_apart, false},
    Rule{Group::alone, "filtered_force", filtered_force, false},
    Rule{Group::alone, "gap_in_stage", gap_in_stage, false},
    Rule{Group::alone, "few_rows", few_rows},
    Rule{Group::alone, "sinks", force_sinks, false},
    Rule{Group::alone, "unexpected_stiffness", unexpected_stiffness},
    Rule{Group::alone, "thickness_not_stated", thickness_not_stated},
    Rule{Group::reload, "drops_elsewhere", drops_elsewhere},
    Rule{Group::reload, "undecided_drops", undecided_drops, false},
    Rule{Group::reload, "no_reload", no_reload},
    Rule{Group::certainty, "only_a_limit", only_a_limit},
    Rule{Group::certainty, "known_roughly", known_roughly},
    Rule{Group::alone, "supports_not_stated", supports_not_stated},
    Rule{Group::alone, "changing_friction", changing_friction},
    Rule{Group::alone, "hidden_waves", hidden_waves},
    Rule{Group::alone, "contradicts_file", contradicts_file, false},
    Rule{Group::alone, "relaxes", relaxes},
};
static_assert(rules.size() <= 36);  // a new rule replaces an old one

// True if the rules of each group are adjacent in the table, as findings_of presumes.
constexpr bool groups_are_adjacent() {
  for (std::size_t i = 0; i < rules.size(); ++i)
    for (std::size_t j = i + 1; j < rules.size(); ++j)
      if (rules[i].group != Group::alone && rules[j].group == rules[i].group && rules[j - 1].group != rules[i].group)
        return false;
  return true;
}
static_assert(groups_are_adjacent());

}  // namespace

std::vector<Finding> findings_of(T test) {
  std::vector<Finding> findings;
  Group reported = Group::alone;
  for (const Rule& rule : rules) {
    if (rule.group != Group::alone && rule.group == reported) continue;
    if (rule.needs_fit && !is_fitted(test)) continue;
    Found found = rule.find(test);
    if (!found) continue;
    found->code = rule.code;
    if (found->severity < Severity::passed) reported = rule.group;
    findings.push_back(std::move(*found));
  }
  return findings;
}

std::vector<std::string_view> finding_codes() {
  std::vector<std::string_view> codes;
  for (const Rule& rule : rules) codes.push_back(rule.code);
  return codes;
}

}  // namespace flexslip
