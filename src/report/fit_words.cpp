#include "report/fit_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "finding/answer.h"
#include "finding/digits.h"
#include "finding/printed.h"
#include "inference/process_mode.h"
#include "io/quantity.h"
#include "report/cycles_words.h"

namespace flexslip {
namespace {

// "the range 0.5 to 0.721", or "the 0.7".
std::string ranged(double low, double high) {
  return low < high ? fmt::format("the range {:g} to {:g}", low, high) : fmt::format("the {:g}", low);
}

}  // namespace

std::string why_no_answer(const FittedTest& test) {
  if (is_fitted(test)) return "";
  const Answer answer = answer_of(test);
  return fmt::format("{}: {} {}", test.measurement.file, answer.findings.front().sentence, answer.next);
}

std::string model_in_words(ProfileModel model) {
  return model == ProfileModel::roughness ? "roughness" : fmt::format("'{}', the paper's", name_of(model));
}

std::string friction_in_words(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  std::string words =
      fit.mu0_is_bound
          ? fmt::format("Friction at the supports is {} (95 %); it cannot be distinguished from zero.",
                        mean_friction(fit))
          : fmt::format("Friction at the supports is {}, averaged over the length that slid (95 %: {:.3f} to {:.3f}).",
                        mean_friction(fit), fit.mu0.low, fit.mu0.high);
  const auto& read = analysis.friction_read;
  words += fmt::format(
      " Read off the curve point by point, at the fitted bending stiffness, friction has a median of {:.2f}; four "
      "fifths of the values lie between {:.2f} and {:.2f}.",
      read.median, read.low80, read.high80);
  if (weight_without_roughness(fit) > 0.5)
    words += " Beyond its mean, friction shows no random variation.";
  else if (fit.model == ProfileModel::roughness)
    words += fmt::format(
        " Along the specimen friction varies at random by {} (standard deviation), over a correlation length of {}.",
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
        "The model {} has waves and no roughness. The model 'roughness' asks whether there is a wave at all.",
        model_in_words(fit.model));
  if (fit.waves.empty() || !std::isfinite(fit.log_evidence_of_wave))
    return "There is no periodicity beyond roughness: no wave explains the record better than none.";
  const auto& wave = fit.waves.front();
  const std::string evidence =
      fmt::format("ln B = {:.1f}; a wave is claimed above {}", fit.log_evidence_of_wave, claiming_gain);
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
        "length that slid: too few periods for a claim.",
        evidence, wavelength);
  return fmt::format(
      "There is no periodicity beyond roughness ({}). The likeliest wave, {} long with an amplitude of {} of the mean, "
      "is only indicative.",
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
      "These lengths hold if the specimen slides over both supports at once. It slides over one at a time where the "
      "supports are not alike or friction falls; the lengths are then up to twice as long: {}, and friction is "
      "that of the weaker side, which slides. Force and stage do not tell which is the case; images of both supports "
      "do, and the same specimen tested again, turned end for end.",
      twice);
}

std::optional<LiteratureFriction> literature_of(const FittedTest& test) {
  return test.materials ? friction_in_literature(*test.materials) : std::nullopt;
}

std::string strain_in_words(const FittedTest& test) {
  const double curvature = greatest_curvature(test.analysis.profile_at_fit, test.analysis.rig.fibre);
  if (!std::isfinite(curvature)) return "";
  const std::string wraps = curvature > test.nose_curvature
                                ? "The specimen was bent more sharply than the nose and wrapped it; friction there is "
                                  "read as if the nose were sharp."
                                : "";
  if (!test.surface) return wraps;
  const double strain = test.surface->strain(curvature);
  std::string words = fmt::format("Bending strained the surface at midspan by up to {:.2g} %", 100 * strain);
  if (!test.reduced)
    words += fmt::format(", a stress of {} at the modulus fitted",
                         Print(test).own(test.surface->stress(curvature), kind::pressure));
  words += ".";
  if (test.strain_at_break && strain > *test.strain_at_break)
    words +=
        fmt::format(" That is beyond the {:.2g} % at which the specimen should break.", 100 * *test.strain_at_break);
  return wraps.empty() ? words : words + " " + wraps;
}

std::string friction_in_literature(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const auto& mu0 = fit.mu0;
  const auto literature = literature_of(test);
  if (!test.materials)
    return "To compare friction with the literature, state [specimen] material and [rig] support_material in the case.";
  if (!literature)
    return fmt::format("The table of friction in the literature says nothing about {} on {}.", test.materials->specimen,
                       test.materials->support);
  const double low = literature->low, high = literature->high;
  const std::string range = fmt::format("{} that the literature gives for {} on {} ({})", ranged(low, high),
                                        literature->specimen, literature->support, literature->source);
  if (fit.mu0_is_bound)
    return fmt::format("μ₀ is {}; {} {} above that.", mean_friction(fit), range,
                       mu0.high < low ? "lies wholly" : "does not lie wholly");
  const std::string value = mean_friction(fit);
  if (mu0.value >= low && mu0.value <= high) return fmt::format("μ₀ = {} lies within {}.", value, range);
  const double away = mu0.value < low ? low - mu0.value : mu0.value - high;
  const bool agrees = mu0.low <= high && mu0.high >= low;
  std::string words = fmt::format("μ₀ = {} {} {}", value,
                                  agrees            ? "agrees with"
                                  : mu0.value < low ? "lies below"
                                                    : "lies above",
                                  range);
  if (mu0.standard_error > 0)
    words +=
        fmt::format("{} the nearer end is {:.1f} standard errors away", agrees ? ":" : ";", away / mu0.standard_error);
  return words + ".";
}

std::string slips_in_words(const FittedTest& test) {
  const auto& summary = test.analysis.slip_summary;
  const Print print(test);
  if (summary.count == 0) return "No drop of the force can be read as a slip, so there is no spacing to measure.";
  std::string words =
      fmt::format("Friction falls by {:.3f} in a slip (median of {})", summary.median_fall, summary.count);
  if (summary.count >= 2)
    words += fmt::format(
        "; {} of the specimen pass over a support from the start of one slip to the start of the next (median; mean "
        "{})",
        roughly(test.analysis.scales.physical_length(summary.median_spacing), print.as(kind::length)),
        roughly(test.analysis.scales.physical_length(summary.mean_spacing), print.as(kind::length)));
  return words +
         ". These numbers need no model of friction along the specimen: they are the counterparts of amplitude and "
         "wavelength, read at the bending stiffness of the fit.";
}

std::string snaps_in_words(const FittedTest& test) {
  const std::size_t snaps = test.analysis.model.snaps.size();
  const std::size_t drops = test.analysis.drops.drops.size();
  std::string words = snaps == 0 ? "The mean of the fit, run forward, never snaps"
                                 : fmt::format("The mean of the fit, run forward, snaps {}",
                                               snaps == 1 ? "once" : fmt::format("{} times", snaps));
  words += fmt::format(", while the measured force drops {}.", drops == 1 ? "once" : fmt::format("{} times", drops));
  if (snaps < drops)
    words +=
        " Not every fall of the force is a snap, and a mean is smoother than any one profile. The checks compare "
        "profiles drawn from the fit.";
  return words;
}

std::string suspicion_in_words(const FittedTest& test) {
  const auto& report = test.analysis.suspects;
  const std::size_t above = report.points.size();
  const std::string judged =
      fmt::format("{} past a deflection of a tenth of the span", counted(report.points_judged, "point", "points"));
  std::string words =
      above == 0
          ? fmt::format("None of the {} needs friction above {:g} at the bending stiffness beforehand.", judged,
                        report.limit)
          : fmt::format(
                "Of the {}, {} friction above {:g} at the bending stiffness beforehand, {} of them by more than twice "
                "the standard error.",
                judged, above == 1 ? "1 needs" : fmt::format("{} need", above), report.limit, report.beyond_error);
  words += report.suspect ? " That is more than 5 %, and so it is at that of the fit: the test is suspect."
           : above == 0   ? ""
                          : " That, or what is left of it at that of the fit, is at most 5 %: the test is not suspect.";
  return words + fmt::format(
                     " By the paper's criterion (a force above the Euler–Bernoulli line), {} suspect; but friction "
                     "alone lifts a sound curve above that line, by 5 % at μ = 0.6.",
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
  return fmt::format("The measured friction profile, run forward as a table, reproduces the measured force {}{}.",
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
          "The bending stiffness is known to {} (standard deviation), as stated; it is fitted within that.", error));
      break;
    case StiffnessSource::assumed_error:
      list.push_back(
          fmt::format("The bending stiffness is stated without an uncertainty; {} (standard deviation) is assumed, and "
                      "it is fitted within that.",
                      error));
      break;
    case StiffnessSource::mirror:
      list.push_back(
          fmt::format("The bending stiffness is that at which friction is the same in loading and unloading, known to "
                      "{} (standard deviation); it is fitted within that.",
                      error));
      break;
    case StiffnessSource::initial_slope:
      list.push_back(
          fmt::format("The bending stiffness is that of the initial slope, known to {} (standard deviation); it is "
                      "fitted within that.",
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
    list.push_back(fmt::format(
        "A line through the first part of the curve meets zero force at {} from that contact; this is "
        "reported, not corrected.",
        readable(analysis.contact.offset.value, analysis.contact.offset.standard_error, print.as(kind::length))));
  const std::size_t last = last_row(test);
  switch (measurement.end) {
    case MeasurementEnd::until:
      list.push_back(fmt::format("The record ends with row {}, as stated.", last));
      break;
    case MeasurementEnd::failure:
      list.push_back(fmt::format("A failure was found after row {}; the rows after it are left out.", last));
      break;
    case MeasurementEnd::turn:
      list.push_back(fmt::format(
          "The stage turns back after row {}; what is said of the loading holds for the rows before that.", last));
      break;
    case MeasurementEnd::last_row:
      list.push_back(fmt::format("No failure was found: all rows to the last, {}, are used.", last));
      break;
  }
  list.push_back(
      fmt::format("The noise of one force reading is {}. A fall within one step counts as a drop if it is {} or more; "
                  "with that limit, a test of this length without slips would show {:g} drops on average.",
                  print.force(analysis.force_noise), print.own(analysis.drops.smallest_fall, kind::force),
                  test.provenance.options.drops.false_alarms_per_test));
  if (fit.model != ProfileModel::constant)
    list.push_back(
        fmt::format("{} tell of friction. The errors of readings one row apart have a correlation of {:.2f}, as found.",
                    counted(fit.readings, "reading", "readings"), fit.noise_correlation));
  if (fit.model == ProfileModel::roughness)
    list.emplace_back(
        "Friction is a mean, perhaps with a drift and a wave, plus a random process along the specimen. The answer "
        "averages over how smooth that process may be and which waves may be there, weighted by their evidence.");
  list.emplace_back(
      "The specimen is a slender, straight, elastic, inextensible beam that slides over both supports alike; its "
      "section does not change along it.");
  const Supports& supports = analysis.rig.fibre.supports();
  list.push_back(fmt::format(
      "The supports are {}, and friction acts {}.",
      supports.radius > 0 ? fmt::format("rollers of a radius of {}{}", print.length(supports.radius),
                                        measurement.test.rig->rollers == Rollers::pinned ? ", on pins" : "")
                          : "sharp edges",
      supports.half_depth > 0
          ? fmt::format("at the surface of the specimen, {} from its axis", print.length(supports.half_depth))
          : "at the axis of the specimen, as if it had no thickness"));
  return list;
}

}  // namespace flexslip
