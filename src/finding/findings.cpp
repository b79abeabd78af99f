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

constexpr double max_deflection = 0.8;   // [L] the greatest that a specimen reaches over its supports
constexpr std::size_t enough_drops = 3;  // to tell the load train by
constexpr std::string_view image_of_supports =
    "Image the supports: the length pulled in shows whether the specimen slides.";
constexpr std::string_view reload_bounds = "that bounds what stiffness was lost";

const Check* check_of(T test, CheckKind kind) {
  const auto& checks = test.analysis.checks;
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& check) { return check.kind == kind; });
  return found == checks.end() ? nullptr : &*found;
}

// A stiffness that was stated is not that of the initial slope, of a specimen that had lost none before.
bool contradicts_slope(T test) {
  return test.analysis.stiffness_implausible && test.stiffness != StiffnessSource::initial_slope &&
         !(test.passes && !test.passes->is_followed && is_lost(*test.passes));
}

bool is_bent_enough(T test) { return test.analysis.status != AnalysisStatus::deflection_too_small; }

double greatest_deflection(T test) {
  const auto& w = test.analysis.reduced.deflection;
  return w.empty() ? 0 : *std::max_element(w.begin(), w.end());
}

std::string load_train_in_words(T test) {
  const double stiffness = test.analysis.rig.stiffness;
  return std::isfinite(stiffness) ? Print(test).own(test.analysis.scales.physical_stiffness(stiffness), kind::stiffness)
                                  : "∞";
}

// In the words of who states the test (case/case_file.h).
std::string to_change(T test, KeyChange change) {
  return instruction_to_set(test.measurement.test, {std::move(change)});
}
std::string rig_keys(T test, const std::vector<std::string>& names) {
  return keys_in_words(test.measurement.test, "rig", names);
}

// A check that presumes sliding says nothing of a fit that is not to be used, or of a specimen that lost stiffness.
bool presumes_too_much(T test) {
  return contradicts_slope(test) || test.analysis.model_implausible || !test.judgement.tells_friction;
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

// What would make a bending stiffness so many times too large or too small; a clause.
std::string likely_unit_error(double times) {
  struct Slip {
    double times;
    std::string_view words;
    double near = 1.5;  // friction and a guess of the modulus move the ratio by less
  };
  constexpr std::array slips{Slip{0.25, ", about 1/4: perhaps the ends are clamped, which no support here is", 1.2},
                             Slip{1.0 / 16, ", about 1/16: perhaps a radius for the diameter"},
                             Slip{16, ", about 16: perhaps a diameter for the radius"},
                             Slip{1e-3, ", about 1/1000: perhaps a unit of force or modulus, N for mN or MPa for GPa"},
                             Slip{1e3, ", about 1000: perhaps a unit of force or modulus, mN for N or GPa for MPa"},
                             Slip{1e-6, ", about a millionth: perhaps a unit of force or modulus"},
                             Slip{1e6, ", about a million: perhaps a unit of force or modulus"},
                             Slip{1e-9, ", about a billionth: perhaps the unit of the span, mm for um"},
                             Slip{1e9, ", about a billion: perhaps the unit of the span, um for mm"}};
  for (const auto& slip : slips)
    if (times < slip.near * slip.times && times > slip.times / slip.near) return std::string(slip.words);
  return "";
}

// By how much a record misses what sliding gives; a clause.
std::string misfit_clause(T test) {
  const TestAnalysis& analysis = test.analysis;
  const double below = 1 - analysis.frictionless_force_ratio.median,
               deepest = 1 - analysis.frictionless_force_ratio.least;
  constexpr double noticeable = 0.01;
  if (below > noticeable)
    return fmt::format(": past a tenth of the span its force lies {} below the frictionless curve",
                       format_percent(below));
  if (deepest > noticeable)
    return fmt::format(": its force falls to {} below the frictionless curve", format_percent(deepest));
  return is_fitted(test)
             ? fmt::format(": the best fit misses the force by {} of its greatest",
                           format_share(analysis.fit.residual_rms, *std::max_element(analysis.reduced.force.begin(),
                                                                                     analysis.reduced.force.end())))
             : "";
}

// The force is not level before the contact, and was taken to be.
Found sloping_baseline(T test) {
  const Baseline& baseline = test.measurement.baseline;
  if (baseline.points == 0 || test.measurement.baseline_is_off) return std::nullopt;
  return Finding{
      .severity = Severity::doubt,
      .sentence = fmt::format("The force {} by {} before the contact, {:.0f} times its error.",
                              baseline.settles_by != 0 ? "settles"
                              : baseline.change > 0    ? "drifts up"
                                                       : "drifts down",
                              readable(std::abs(baseline.change), baseline.error, Print(test).as(kind::force)),
                              std::abs(baseline.change) / baseline.error),
      .short_form = "the force drifts before contact",
      .remedy = capitalised(to_change(test, {"record", "zero", "\"slope\""})) + " to take it off.",
      .numbers = {{"change", baseline.change, kind::force}, {"change_error", baseline.error, kind::force}}};
}

std::string to_find_contact(T test) { return to_change(test, {"record", "contact", "\"find\""}); }

// Is the record's own contact another than that taken off?
bool has_other_contact(T test) {
  const Measurement& measurement = test.measurement;
  const auto& [value, error, low, high] = measurement.own_contact.offset;
  constexpr double errors = 2, least = 0.0012;  // [1], [L] less moves friction by less than its interval
  return measurement.own_contact.status == ContactStatus::found && measurement.contact != ContactSource::found &&
         std::abs(value) > std::max(errors * error, least * test.analysis.scales.span());
}

Found other_contact(T test) {
  if (!has_other_contact(test)) return std::nullopt;
  const Measurement& measurement = test.measurement;
  const auto& [value, error, low, high] = measurement.own_contact.offset;
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format(
                     "The record itself begins {} {} {}{}.",
                     readable(std::abs(value), error, Print(test).as(kind::length)), value > 0 ? "behind" : "before",
                     measurement.contact == ContactSource::stated ? "the contact stated" : "the zero of the file",
                     measurement.own_contact.settles ? ", once its contact has settled" : ""),
                 .short_form = fmt::format("begins {} {}", Print(test).own(std::abs(value), kind::length),
                                           value > 0 ? "late" : "early"),
                 .remedy = capitalised(to_find_contact(test)) + " to count from there.",
                 .numbers = {{"offset", value, kind::length}, {"offset_error", error, kind::length}}};
}

// Does the record begin at a force that no specimen makes, as that of a load cell that was not set to zero?
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
    return Finding{.severity = Severity::doubt,
                   .sentence = fmt::format("The record begins at a force of {}, as no specimen makes it.", printed),
                   .short_form = fmt::format("begins at {}", printed),
                   .remedy = fmt::format("The load cell was not set to zero: {}.", to_set_zero(test)),
                   .numbers = {{"force", force, kind::force}}};
  if (measurement.test.record->zero != ForceZeroRule{} || !(force > 0) || measurement.contact != ContactSource::found ||
      measurement.test.record->contact)
    return std::nullopt;
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format(
                     "The record begins under a force of {}, which is taken as borne by the specimen.", printed),
                 .short_form = fmt::format("begins under {}", printed),
                 .remedy = fmt::format("If the load cell was not set to zero, {}; if it was, {}.", to_set_zero(test),
                                       to_find_contact(test)),
                 .numbers = {{"force", force, kind::force}}};
}

// What is most likely off where the record begins comes first.
std::string find_contact_or_check(T test, const std::string& remedy) {
  if (begins_below_zero(test))
    return fmt::format("The load cell was not set to zero: {}; check {}", to_set_zero(test), remedy);
  return (has_other_contact(test) ? capitalised(to_find_contact(test)) + "; check " : "Check ") + remedy;
}

// ---- Why a record has no answer

// The readings are not those of a specimen bent over its supports.
Found not_bent(T test) {
  const auto& force = test.analysis.record.force;
  if (is_fitted(test) || force.empty()) return std::nullopt;
  if (!(*std::max_element(force.begin(), force.end()) > 0))
    return Finding{.severity = Severity::refusal,
                   .sentence = "The force is nowhere above zero.",
                   .short_form = "no force above zero",
                   .remedy = "Check which column is the force, and its sign."};
  const double deepest = greatest_deflection(test);
  if (!(deepest > 0))
    return Finding{.severity = Severity::refusal,
                   .sentence = "The displacement stays before the contact: the specimen is nowhere bent.",
                   .short_form = "nowhere bent",
                   .remedy = fmt::format("Check where the displacement counts from and the zero of the force; {}.",
                                         to_find_contact(test))};
  constexpr double slender =
      1.0 / 400;  // [L] of half of its depth: a span or a unit is wrong where it is bent too little
  const bool explains_slope = test.analysis.rig.fibre.supports().half_depth <= slender || !contradicts_slope(test);
  if (is_bent_enough(test) || deepest <= max_deflection || !explains_slope) return std::nullopt;
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format(
          "The deflection reaches {}, {:.2g} times the span of {}. No specimen bends so far over its supports.",
          Print(test).length(deepest), deepest, Print(test).length(1)),
      .short_form = "deflection beyond the span",
      .remedy = "Check the units, and where the displacement counts from.",
      .numbers = {{"deflection_over_span", deepest}}};
}

// A stage moves evenly from row to row; a deflection leaps in each drop by what the load train gives back.
Found deflection_for_stage(T test) {
  const TrainInDrops& train = test.analysis.statistics.train;
  if (!is_bent_enough(test) || !test.measurement.is_derived || std::isinf(test.analysis.rig.stiffness) ||
      train.drops < enough_drops)
    return std::nullopt;
  constexpr double surely = 3, half = 0.5;
  if (!(train.leap - surely * train.leap_error > half)) return std::nullopt;
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("In each of the {} drops the column taken for the stage leaps ahead, by {:.2f} of what "
                              "the load train gives back; a stage moves evenly. It holds the deflection.",
                              train.drops, train.leap),
      .short_form = "the stage leaps as a deflection does",
      .remedy = "Name that column as the deflection, or the column of the stage.",
      .numbers = {{"leap", train.leap}}};
}

// What the specimen bends in a drop beyond the rows before it is what the load train gives back. A force that lags behind shows it too late.
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
          "{} of {} drops do not fit the load train stated ({}): while the force falls, the specimen bends as on {}.",
          train.misfits, drops, load_train_in_words(test), as_on),
      .short_form = fmt::format("load train as of {}", as_on),
      .remedy = fmt::format("State the stiffness of the load train ({}).", rig_keys(test, {"stiffness"})),
      .numbers = {{"misfits", static_cast<double>(train.misfits)},
                  {"load_train", 1 / train.compliance, kind::stiffness}}};
}

// Where only the deflection was measured, the machine cannot have gone back while the force fell.
Found train_by_reckoned_stage(T test) {
  const std::optional<LeastTrain>& least = test.measurement.least_train;
  if (!least) return std::nullopt;
  const double train = least->fall / least->advance;
  const double stated = test.analysis.scales.physical_stiffness(test.analysis.rig.stiffness);
  const Print print(test);
  const std::string bound = format_roughly(train, print.as(kind::stiffness));
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("Behind row {} the deflection rises by only {} while the force falls by {}: on the load "
                              "train stated ({}) the machine would have gone back by {}. The load train is stiffer "
                              "than {}.",
                              file_row(test, least->before), format_roughly(least->advance, print.as(kind::length)),
                              format_roughly(least->fall, print.as(kind::force)), load_train_in_words(test),
                              format_roughly(least->fall / stated - least->advance, print.as(kind::length)), bound),
      .short_form = fmt::format("load train stiffer than {}", bound),
      .remedy = fmt::format("State the stiffness of the load train ({}).", rig_keys(test, {"stiffness"})),
      .numbers = {{"row", static_cast<double>(file_row(test, least->before))},
                  {"least_load_train", train, kind::stiffness}}};
}

Found too_few_points(T test) {
  if (is_bent_enough(test)) return std::nullopt;
  const std::size_t rows = test.analysis.record.force.size();
  const double deepest = greatest_deflection(test), from = min_fit_deflection(deepest, test.analysis.rig.fibre);
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("Fewer than {} of {} lie beyond a deflection of {}, from which on friction is judged. "
                              "The greatest deflection is {}, {} of the span of {}.",
                              min_readings, format_count(rows, "row", "rows"), Print(test).length(from),
                              Print(test).length(deepest), format_relative(deepest), Print(test).length(1)),
      .short_form = "bent too little",
      .remedy =
          "If the deflection should be larger, check the units; if not, bend a thinner specimen, or bend farther; "
          "flexslip modulus evaluates the record without friction.",
      .numbers = {{"deflection_over_span", deepest}}};
}

// Of a test that is bent too little to tell friction.
Found force_sinks(T test) {
  if (!sinks(test.analysis)) return std::nullopt;
  const Sinking& sinking = test.analysis.statistics.sinking;
  const std::size_t row = file_row(test, sinking.from);
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("From row {} on the force sinks by {} without a drop, as no elastic specimen "
                                         "does at so small a deflection: it yielded, relaxed or gave way slowly.",
                                         row, format_percent(sinking.share)),
                 .short_form = fmt::format("the force sinks by {}", format_percent(sinking.share)),
                 .remedy = "Use flexslip modulus for stiffness and strength.",
                 .numbers = {{"sunk", sinking.share}, {"row", static_cast<double>(row)}}};
}

// Where the deflection is that of the stage, a load train that gives makes the specimen look too soft.
Found wrong_load_train(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (Found found = train_by_reckoned_stage(test)) return found;
  if (!is_bent_enough(test)) return std::nullopt;
  if (Found found = train_by_drops(test)) return found;
  const double times = analysis.stiffness_to_slope_ratio;
  if (std::isfinite(analysis.rig.stiffness) || !contradicts_slope(test) || !(times > 1) ||
      !likely_unit_error(times).empty())
    return std::nullopt;
  const double train = analysis.scales.physical_stiffness(beam_stiffness / (times - 1));
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("The initial slope does not fit the load train stated (∞): it is as on {}, if "
                              "the {} is right.",
                              format_roughly(train, Print(test).as(kind::stiffness)), "bending stiffness stated"),
      .short_form = fmt::format("load train as of {}", format_roughly(train, Print(test).as(kind::stiffness))),
      .remedy = fmt::format("State the stiffness of the load train ({}); if nothing gives, check the modulus, the "
                            "section and the span.",
                            rig_keys(test, {"stiffness"})),
      .numbers = {{"load_train", train, kind::stiffness}, {"stated_over_slope", times}}};
}

Found wrong_stiffness(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (!contradicts_slope(test)) return std::nullopt;
  const double times = analysis.stiffness_to_slope_ratio;
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("The {} is {} times that of the record's initial slope{}.", "bending stiffness stated",
                              format_roughly(times, kind::number), likely_unit_error(times)),
      .short_form = fmt::format("stiffness {:.2f} times the slope's", times),
      .remedy =
          fmt::format("Check the modulus, the section, the span, the load train, the columns and their units; to take "
                      "the stiffness from the record, {}.",
                      to_change(test, {"specimen", "modulus", "\"fit\""})),
      .numbers = {{"stated_over_slope", times}}};
}

// [Pa] Young's modulus as the record has it; NaN without a section.
double modulus_found(T test) {
  if (!test.section_moment) return std::numeric_limits<double>::quiet_NaN();
  const double fitted = is_fitted(test) ? test.analysis.fit.bending_stiffness.value : 1;
  return fitted * test.analysis.scales.bending_stiffness() / *test.section_moment;
}

// Of a slope in wrong units, or of a load train that gives as much as all of the displacement.
Found impossible_modulus(T test) {
  const double modulus = modulus_found(test);
  if (!(modulus > max_material_modulus)) return std::nullopt;
  const auto in_words = [&](double pressure) { return format_roughly(pressure, Print(test).as(kind::pressure)); };
  return Finding{.severity = Severity::refusal,
                 .sentence = fmt::format("The modulus would be {}, and no material exceeds {}.", in_words(modulus),
                                         in_words(max_material_modulus)),
                 .short_form = fmt::format("modulus {}", in_words(modulus)),
                 .remedy = "Check the section, the span, the load train, the columns and their units.",
                 .numbers = {{"modulus", modulus, kind::pressure}}};
}

// No friction gives the record, or the best fit misses it.
Found not_explained(T test) {
  if (test.analysis.status != AnalysisStatus::not_explained && !test.analysis.model_implausible) return std::nullopt;
  const std::string gave_way =
      is_fitted(test) ? " If they are right, the specimen gave way: unload and load once more." : "";
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("No friction explains this record{}.", misfit_clause(test)),
      .short_form = "no friction explains it",
      .remedy = find_contact_or_check(test,
                                      "the columns (flexslip read FILE shows them), their units, the span, the "
                                      "section, the modulus, the supports and the load train." +
                                          gave_way)};
}

// ---- What stands against an answer

// Unloading once more tells slips from cracks, wherever that can still be done.
std::string reload_remedy(T test) {
  const std::string force = unloading_force(test);
  const std::string how_far = force.empty() ? "" : fmt::format(" to {} or less", force);
  if (test.measurement.end == MeasurementEnd::failure || test.measurement.end == MeasurementEnd::until)
    return fmt::format("In the next test unload{} before the specimen breaks, and load once more; {}.", how_far,
                       reload_bounds);
  if (is_reloaded(test.analysis))
    return fmt::format("Unload and load the next specimen again after every few drops: this reload tells a loss of {}.",
                       loss_in_words(*test.analysis.passes));
  const auto& [loading, of] = test.measurement.loading;
  return fmt::format(
      "Unload{} and load once more; {}{}.", how_far, reload_bounds,
      of > 1 ? fmt::format(" (no loading that can be compared comes after loading {}, which is evaluated)", loading)
             : "");
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
                      ? fmt::format("The specimen lost stiffness in its drops ({}).", causes)
                      : "The force fell by more than any friction can hold: the specimen lost stiffness or yielded.",
      .short_form = by_drops ? causes : "lost stiffness",
      .remedy = reload_remedy(test),
      .numbers = {{"loss_needed", features.loss_needed}, {"loss_recovered", features.loss_recovered}}};
}

// What became of the specimen until it was loaded again.
Found changed_reload(T test) {
  if (!test.passes || !test.passes->is_reloaded) return std::nullopt;
  const PassesFit& passes = *test.passes;
  const bool is_judged_lost = is_reloaded(test.analysis) && (test.judgement.conclusion == Conclusion::cracks ||
                                                             test.judgement.conclusion == Conclusion::slips_and_damage);
  const std::vector<FindingNumber> numbers{{"loss", passes.loss.value}, {"loss_error", passes.loss.standard_error}};
  if (is_gained(passes))
    return Finding{
        .severity = Severity::doubt,
        .sentence = fmt::format("Loaded again, the specimen is {:.1f} ± {:.1f} % stiffer: the contact or the "
                                "bending stiffness is wrong.",
                                -100 * passes.loss.value, 100 * passes.loss.standard_error),
        .short_form = fmt::format("{:.0f} % stiffer when reloaded", -100 * passes.loss.value),
        .remedy = "See whether the contact or the rig has changed.",
        .numbers = numbers};
  if (is_settled(passes))
    return Finding{.severity = Severity::note,
                   .sentence = "The specimen or a support gave way for good, and no stiffness was lost.",
                   .short_form = "settled",
                   .remedy = "See whether the specimen is crushed at the supports or under the nose.",
                   .numbers = {{"settled", passes.settled.value}}};
  if (!is_judged_lost && !is_lost(passes)) return std::nullopt;
  return Finding{.severity = Severity::note,
                 .sentence = fmt::format("The specimen lost {} of its stiffness.", loss_in_words(passes)),
                 .short_form = fmt::format("{} of the stiffness lost", format_percent(passes.loss.value)),
                 .remedy = "Unload the next specimen earlier, before it loses stiffness, and load it once more.",
                 .numbers = numbers};
}

// Above the limit, or below none.
Found implausible_friction(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (!is_friction_implausible(analysis)) {
    if (!(analysis.pointwise_friction.median < min_friction)) return std::nullopt;
    return Finding{.severity = Severity::doubt,
                   .sentence = "The force lies below the frictionless curve.",
                   .short_form = "below the frictionless curve",
                   .remedy = find_contact_or_check(test, "the modulus, the section and the span.")};
  }
  const double most = std::min(analysis.suspects.limit, analysis.max_friction);
  const std::string how =
      analysis.suspects.suspect
          ? fmt::format("above {:.3g} at {} of {} points past a tenth of the span", analysis.suspects.limit,
                        analysis.suspects.points.size(), analysis.suspects.points_judged)
          : fmt::format("at least {:.2f} on average (95 %)", analysis.fit.mu0.low);
  return Finding{.severity = Severity::suspicion,
                 .sentence = fmt::format("The record needs implausible friction, {}.", how),
                 .short_form = fmt::format("friction above {:.2g}", most),
                 .remedy = analysis.fit.mu0.low > analysis.max_friction
                               ? fmt::format("The rollers turn on their pins at a friction of {:.3g}: check whether "
                                             "they are stuck.",
                                             analysis.max_friction)
                           : !test.measurement.test.rig->states_supports()
                               ? fmt::format("If the supports are not edges, state {}: rollers taken for edges read "
                                             "so.",
                                             rig_keys(test, {"roller_radius"}))
                               : std::string(image_of_supports)};
}

Found misses_force(T test) {
  const Check* check = check_of(test, CheckKind::residuals);
  if (!check) return std::nullopt;
  const double share = number_of(*check, "residual_rms") / number_of(*check, "greatest_force");
  const std::string misses = fmt::format(
      "The fit, run forward, misses the force by {} of its greatest (limit {:g} %), over the {} of {} rows that tell "
      "of friction.",
      format_relative(share), 100 * max_residual, test.analysis.fit.readings, test.analysis.record.force.size());
  return checked(test, *check, misses, misses, "the fit misses the force",
                 "Check the modulus, the section, the span and the units.");
}

Found drops_differ(T test) {
  const Check* check = check_of(test, CheckKind::drops);
  if (!check) return std::nullopt;
  if (presumes_too_much(test))
    return unjudged("The fit cannot be used, so its drops are not compared with those of the record.");
  if (check->outcome == CheckOutcome::not_possible)
    return unjudged("The model has no profiles whose drops could be counted.");
  const auto number = [&](std::string_view name) { return number_of(*check, name); };
  const double low = number("draws_low"), high = number("draws_high");
  const std::string sentence =
      fmt::format("Profiles drawn from the fit show {} drops, the record {:.0f}{}.",
                  low < high ? fmt::format("{:.0f} to {:.0f}", low, high) : fmt::format("{:.0f}", low),
                  number("record"), check->outcome == CheckOutcome::passed ? "" : ", more than chance allows");
  return checked(test, *check, sentence, sentence,
                 fmt::format("{:.0f} drops, fit {:.0f} to {:.0f}", number("record"), low, high),
                 "See in the table of drops which ones can be cracks.");
}

Found coloured_noise(T test) {
  const Check* check = check_of(test, CheckKind::whiteness);
  if (!check) return std::nullopt;
  if (presumes_too_much(test)) return unjudged("The fit cannot be used, so what it leaves is not judged.");
  if (check->outcome == CheckOutcome::not_possible)
    return unjudged("A constant friction cannot predict the next reading.");
  const double p = number_of(*check, "p_value");
  const std::string probability =
      p < min_p_of_noise ? fmt::format("p < {:g}", min_p_of_noise) : fmt::format("p = {}", format_significant(p, 2));
  Finding finding = checked(
      test, *check,
      fmt::format("What the fit leaves is consistent with noise ({}; limit {:g}).", probability, min_p_of_noise),
      fmt::format("What the fit leaves is more than noise ({}; limit {:g}).", probability, min_p_of_noise),
      "the fit leaves more than noise", "");
  // The noise fitted is correlated, and a slow deviation is part of the fit: another colour moves the answer by little.
  if (finding.severity == Severity::doubt) finding.severity = Severity::note;
  return finding;
}

// The passes could not be compared, so that the evaluated loading stands alone.
Found passes_apart(T test) {
  if (!test.passes || test.passes->status == PassesStatus::ok) return std::nullopt;
  const bool is_too_short = test.passes->status == PassesStatus::not_sliding_out;
  const std::string force = unloading_force(test);
  return Finding{
      .severity = Severity::condition,
      .sentence = is_too_short
                      ? fmt::format("The passes cannot be compared: the specimen slides outwards in {} only.",
                                    format_count(test.passes->sliding_out, "row", "rows"))
                      : "The passes cannot be compared: no friction and no loss of stiffness explain all of them.",
      .short_form = is_too_short ? "not unloaded far enough" : "passes not explained",
      .remedy = is_too_short ? force.empty() ? "Unload farther, and record more rows."
                                             : fmt::format("Unload to {} or less, and record more rows.", force)
                             : "Check the contact, the bending stiffness and the load train.",
      .numbers = {{"rows", static_cast<double>(test.passes->sliding_out)}}};
}

// Where the stage moves much farther than usual from one row to the next, what happened in between is not seen.
Found gap_in_stage(T test) {
  const WidestStep& widest = test.analysis.statistics.widest_step;
  constexpr double far = 20, part = 0.02;  // [usual step], of all travel
  if (!is_bent_enough(test) || !(widest.length > far * widest.usual && widest.share_of_travel > part))
    return std::nullopt;
  const std::size_t row = file_row(test, widest.behind);
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("Behind row {} the stage moves by {} at once: rows are missing, or it counts "
                                         "wrongly from there on, which reads as another friction.",
                                         row, Print(test).own(widest.length, kind::length)),
                 .short_form = fmt::format("a gap behind row {}", row),
                 .remedy = fmt::format("Compare with the friction before it: {}.",
                                       to_change(test, {"record", "until", fmt::format("{}", row)})),
                 .numbers = {{"step", widest.length, kind::length}, {"row", static_cast<double>(row)}}};
}

// By a low-pass, which a load cell or a loop of the machine has; or by a filter that looks both ways, which only software has.
Found filtered_force(T test) {
  const RoundedDrops& drops = test.analysis.statistics.rounded;
  if (!is_bent_enough(test)) return std::nullopt;
  if (drops.lag > 0)
    return Finding{.severity = Severity::doubt,
                   .sentence = fmt::format("The force lags behind by about {:.1f} rows: the drops recorded are "
                                           "rounded, and shallower than the real ones.",
                                           drops.lag),
                   .short_form = fmt::format("the force lags by {:.1f} rows", drops.lag),
                   .remedy = "Filter the force less, or record rows that are farther apart in time.",
                   .numbers = {{"lag_in_rows", drops.lag}}};
  if (!(drops.spread > 0)) return std::nullopt;
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("The force has been smoothed: each drop is spread over about {:.1f} rows, and "
                                         "shallower than the real one.",
                                         drops.spread),
                 .short_form = "the force has been smoothed",
                 .remedy = "Give the readings as they were recorded.",
                 .numbers = {{"spread_in_rows", drops.spread}}};
}

Found undecided_drops(T test) {
  if (drops_of(test) == 0 || test.judgement.conclusion != Conclusion::undecided) return std::nullopt;
  const std::string causes = causes_in_words(test);
  const bool tells = !causes.empty();
  return Finding{.severity = Severity::condition,
                 .sentence = tells ? fmt::format("Slips and cracks can both have made the drops ({}).", causes)
                                   : "The drops are too small, or too near the contact, to tell slips from cracks.",
                 .short_form = tells ? causes : "slips or cracks",
                 .remedy = reload_remedy(test),
                 .numbers = tells ? std::vector<FindingNumber>{{"cracks_alone", test.judgement.causes.cracks}}
                                  : std::vector<FindingNumber>{}};
}

// Of a specimen that is loaded again nothing drops where it slipped or cracked before.
Found drops_elsewhere(T test) {
  const auto& [drops, rows] = test.drops_elsewhere;
  if (drops_of(test) > 0 || drops == 0) return std::nullopt;
  const std::string some = format_count(drops, "drop", "drops");
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("{} in other loadings {} not judged: that evaluated has none.",
                                         capitalised(some), drops == 1 ? "is" : "are"),
                 .short_form = fmt::format("{} in other loadings", some),
                 .remedy = fmt::format(
                     "Evaluate the loading that has them: {}.",
                     instruction_to_set(test.measurement.test, {{"record", "first", fmt::format("{}", rows.first)},
                                                                {"record", "until", fmt::format("{}", rows.last)}})),
                 .numbers = {{"drops", static_cast<double>(drops)}}};
}

Found few_rows(T test) {
  constexpr double min_rows = 5;  // at four, waves are missed
  if (!(test.analysis.statistics.rows_between_drops < min_rows)) return std::nullopt;
  return Finding{
      .severity = Severity::doubt,
      .sentence = "Most rises between drops have fewer than five rows: drops and waves of friction may be missed.",
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
                        ? "The bending stiffness is not fitted with a constant friction."
                        : "The bending stiffness is stated as exact, and is not fitted.");
  const std::string sentence = fmt::format(
      "The bending stiffness of the fit is {} that {}, {:.1f} times the error of the difference (limit {:g}).",
      above_or_below(number_of(*check, "fitted_over_nominal")),
      test.stiffness == StiffnessSource::initial_slope ? "of the initial slope" : "stated", number_of(*check, "errors"),
      max_stiffness_errors);
  return checked(
      test, *check, sentence, sentence,
      fmt::format("stiffness {} from that {}", signed_percent(number_of(*check, "fitted_over_nominal") - 1),
                  test.stiffness == StiffnessSource::initial_slope ? "of the slope" : "stated"),
      find_contact_or_check(test, "the modulus, the section, the span, the units and the radius of the supports."));
}

// ---- What is worth knowing, and casts no doubt

Found only_a_limit(T test) {
  const Check* check = check_of(test, CheckKind::friction);
  if (!check || presumes_too_much(test)) return std::nullopt;
  Finding finding = checked(test, *check, "Friction can be distinguished from zero.",
                            fmt::format("Friction cannot be distinguished from zero; it is at most {} (95 %).",
                                        format_significant(number_of(*check, "mu0_high"), 2)),
                            "only a limit", "Bend farther, or state the bending stiffness more exactly.");
  if (finding.severity == Severity::doubt) finding.severity = Severity::condition;
  return finding;
}

// Of few rows, or a specimen hardly bent, friction is told, but no more than roughly.
Found known_roughly(T test) {
  const Estimate& mu0 = test.analysis.fit.mu0;
  constexpr double rough = 0.2;  // [1] half of its interval: more than twice that of a clean test
  const double half = 0.5 * (mu0.high - mu0.low);
  if (test.analysis.fit.mu0_is_bound || !(half > rough) || !test.judgement.tells_friction) return std::nullopt;
  return Finding{.severity = Severity::condition,
                 .sentence = fmt::format("Friction is known only roughly, to ± {:.2f} (95 %).", half),
                 .remedy = "Bend farther, or state the bending stiffness more exactly.",
                 .numbers = {{"half_width", half}}};
}

// Drops may be cracks, and so may what is too small to be seen as one: a force as rough as friction that varies makes it.
Found no_reload(T test) {
  if (!may_have_lost_stiffness(test) || !test.judgement.tells_friction) return std::nullopt;
  const auto& [loading, of] = test.measurement.loading;
  const std::string reload =
      of > 1 ? fmt::format("a reload after loading {}, which is evaluated,", loading) : "a reload";
  return Finding{.severity = Severity::condition,
                 .sentence = drops_of(test) > 0
                                 ? fmt::format("Without {} nobody knows how much stiffness was lost.", reload)
                                 : fmt::format("The force is uneven, as friction that varies makes it, or cracks too "
                                               "small to be seen: without {} nobody knows how much stiffness was lost.",
                                               reload),
                 .remedy = reload_remedy(test)};
}

Found supports_not_stated(T test) {
  if (!test.on_rollers) return std::nullopt;
  const TestAnalysis& rollers = test.on_rollers->analysis;
  Finding finding{
      .severity = friction_on_rollers(test) ? Severity::doubt : Severity::condition,
      .sentence = "The supports are not stated, and edges are assumed.",
      .short_form = "supports not stated",
      .remedy = fmt::format("State {}, or {}.", in_words(test.measurement.test, {"rig", "supports", "\"edges\""}),
                            rig_keys(test, {"roller_radius"}))};
  if (rollers.status == AnalysisStatus::deflection_too_small) {
    finding.sentence += fmt::format(" On {} the deflection is too small to tell friction.", usual_rollers(test));
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
      !test.judgement.tells_friction)
    return std::nullopt;
  Finding finding{.severity = Severity::condition,
                  .sentence = "No section says how thick the specimen is.",
                  .remedy = fmt::format("State {}.", keys_in_words(input, "specimen", {"diameter", "height"}))};
  const auto& by = test.analysis.fit.friction_by;
  if (!by) return finding;
  constexpr double usual = 0.02;  // [L] of the authors' spicules, and of many a fibre
  const double more = usual * (*by)[StatedQuantity::thickness];
  finding.sentence +=
      fmt::format(" If it is {} thick, friction reads {:.2f} {}.",
                  format_roughly(test.analysis.scales.physical_length(usual), Print(test).as(kind::length)),
                  std::abs(more), more < 0 ? "lower" : "higher");
  finding.numbers = {{"friction_moves", more}};
  return finding;
}

// Smooth friction is hardly ever steeper along a specimen than its error: what softens, relaxes or was loaded before looks so.
Found changing_friction(T test) {
  const FrictionFit& fit = test.analysis.fit;
  if (test.judgement.friction_falls)
    return Finding{.severity = Severity::doubt,
                   .sentence =
                       "Friction decreases along the record, as it would if stiffness were lost or if rollers "
                       "were taken for edges.",
                   .short_form = "friction decreases",
                   .remedy = !test.measurement.test.rig->states_supports()
                                 ? fmt::format("State {} if the supports are not edges; if they are, an image of the "
                                               "supports tells.",
                                               rig_keys(test, {"roller_radius"}))
                                 : std::string(image_of_supports)};
  if (!(weight_without_roughness(fit) > 0.5) || !test.judgement.tells_friction) return std::nullopt;
  if (!(std::abs(fit.drift.value) > fit.drift.standard_error)) return std::nullopt;
  return Finding{.severity = Severity::condition,
                 .sentence =
                     "Friction changes steadily along the specimen, by more than its error: a specimen that softens or "
                     "relaxes, or a preload that was tared, reads so.",
                 .short_form = "it changes steadily, as softening reads",
                 .remedy = reload_remedy(test)};
}

// The force falls while the stage rests.
Found relaxes(T test) {
  const auto& relaxation = test.measurement.relaxation;
  if (!relaxation) return std::nullopt;
  const Estimate& share = relaxation->share;
  const std::string lost = format_relative(relaxation->over_loading);
  return Finding{
      .severity = Severity::condition,
      .sentence = fmt::format(
          "The force falls by {:.2f} ± {:.2f} % while the stage rests for {} at {}. At this rate the specimen or the "
          "rig relaxes by {} during the loading. The error of friction allows for {}.",
          100 * share.value, 100 * share.standard_error, format_count(relaxation->rows, "row", "rows"),
          format_count(relaxation->rests, "place", "places"), lost,
          format_relative(test.analysis.rig_errors.slow_force)),
      .short_form = fmt::format("relaxes by {}", lost),
      .remedy = "Load faster and without rests, and state the bending stiffness at that speed.",
      .numbers = {{"relaxation", share.value},
                  {"relaxation_error", share.standard_error},
                  {"over_loading", relaxation->over_loading}}};
}

// On a soft load train, or where rows are far apart, or noise moves their places by much, short variation hides: the specimen rests on its crests, and
// friction reads smooth.
Found hidden_waves(T test) {
  const FrictionFit& fit = test.analysis.fit;
  if (const double hidden = fit.hidden_by_rig; hidden > 0)
    return Finding{.severity = Severity::condition,
                   .sentence = fmt::format("The load train is so soft that the specimen may slip from crest to crest "
                                           "of its friction unseen: the mean may be off by {:.2f}.",
                                           hidden),
                   .short_form = "a load train so soft hides some of it",
                   .remedy = "A stiffer rig tells friction better.",
                   .numbers = {{"hidden", hidden, kind::number}}};
  if (!(weight_without_roughness(fit) > 0.5) || fit.wave_claimed || !test.judgement.tells_friction) return std::nullopt;
  if (std::isinf(test.analysis.rig.stiffness)) return std::nullopt;  // it slides over all places alike
  constexpr double lengths_told_apart = 20;
  const double seen = fit.share * (fit.S_end - fit.S_begin);  // of places on the specimen
  if (!(lengths_told_apart * fit.shortest_wave > seen)) return std::nullopt;
  const double shortest = test.analysis.scales.physical_length(fit.shortest_wave);
  const std::string length = format_roughly(shortest, Print(test).as(kind::length));
  return Finding{
      .severity = Severity::condition,
      .sentence = fmt::format("Friction that varies over less than {} along the specimen would not show: the "
                              "specimen would rest on its crests, and the mean be lower.",
                              length),
      .short_form = fmt::format("lower if it varies over less than {}", length),
      .remedy = "A stiffer rig, less noise of the force or more rows show shorter variation.",
      .numbers = {{"shortest_wave", shortest, kind::length}}};
}

// Rules that exclude each other: of a group the first that applies is said, and those after it are not.
enum class Group {
  alone,      // none: said whatever else is
  answer,     // why there is none, or none to use
  damage,     // did the specimen lose stiffness?
  beginning,  // of the record
  reload,     // what it, or another loading, would tell
  certainty,  // of friction
};

// A rule, under the code of what it finds; does it presume an answer of the analysis?
struct Rule {
  Group group;
  std::string_view code;
  Found (*find)(T test);
  bool presumes_an_answer = true;
};

// Rules of a group stand together. None calls another.
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
    Rule{Group::reload, "drops_elsewhere", drops_elsewhere},
    Rule{Group::reload, "undecided_drops", undecided_drops, false},
    Rule{Group::reload, "no_reload", no_reload},
    Rule{Group::certainty, "only_a_limit", only_a_limit},
    Rule{Group::certainty, "known_roughly", known_roughly},
    Rule{Group::alone, "supports_not_stated", supports_not_stated},
    Rule{Group::alone, "thickness_not_stated", thickness_not_stated},
    Rule{Group::alone, "changing_friction", changing_friction},
    Rule{Group::alone, "hidden_waves", hidden_waves},
    Rule{Group::alone, "relaxes", relaxes},
};
static_assert(rules.size() <= 35);  // A new rule replaces one.

// True if the rules of each group are adjacent in the table, as findings_of presumes.
constexpr bool groups_stand_together() {
  for (std::size_t i = 0; i < rules.size(); ++i)
    for (std::size_t j = i + 1; j < rules.size(); ++j)
      if (rules[i].group != Group::alone && rules[j].group == rules[i].group && rules[j - 1].group != rules[i].group)
        return false;
  return true;
}
static_assert(groups_stand_together());

}  // namespace

std::vector<Finding> findings_of(T test) {
  std::vector<Finding> findings;
  Group said = Group::alone;
  for (const Rule& rule : rules) {
    if (rule.group != Group::alone && rule.group == said) continue;
    if (rule.presumes_an_answer && !is_fitted(test)) continue;
    Found found = rule.find(test);
    if (!found) continue;
    found->code = rule.code;
    if (found->severity < Severity::passed) said = rule.group;
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
