#include "report/fit_screen.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "inference/profile.h"
#include "io/text_table.h"
#include "report/answer_words.h"
#include "report/check_words.h"
#include "report/digits.h"
#include "report/fit_print.h"
#include "report/plain_text.h"
#include "report/preparation_words.h"

namespace flexslip {
namespace {

constexpr std::size_t label_width = 12;

// Words beside a label, in lines of their own.
std::string line_of_screen(std::string_view label, const std::string& words) {
  constexpr std::size_t width = 3 + label_width + 2;
  const std::string text = wrapped(std::string(width, '.') + words, std::string(width, ' '));
  return fmt::format("   {}  {}", padded_right(label, label_width), text.substr(width));
}

// Does the answer claim a friction?
bool claims_friction(const FittedTest& test) {
  return is_trusted(test.judgement.value().standing) && !test.analysis.fit.mu0_is_bound && caution_of(test).empty();
}

std::string friction_on_screen(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const auto& read = test.analysis.friction_read;
  if (!is_trusted(test.judgement.value().standing) || !caution_of(test).empty())
    return "cannot be read off this record";
  if (fit.mu0_is_bound) return mean_friction(fit) + ": the record does not tell it from zero";
  const std::string model = mean_friction(fit) + " on average, by the fit";
  if (!std::isfinite(read.median)) return model;
  return fmt::format("{:.2f} read off the curve, four fifths of it between {:.2f} and {:.2f}; {}", read.median,
                     read.low80, read.high80, model);
}

std::string stiffness_on_screen(const FittedTest& test) {
  std::string words;
  for (const ParameterRow& row : parameter_rows(test)) {
    if (row.name == "bending_stiffness") words = fmt::format("EI = {}, {}", row.value, row.remark);
    if (row.name == "modulus") words += fmt::format("; E = {}, of the fit", row.value);
  }
  if (!is_trusted(test.judgement.value().standing)) words += "; not to be used";
  return words;
}

std::string assumed_in_short(const FittedTest& test) {
  const auto& measurement = test.measurement;
  const Supports& supports = test.analysis.rig.fibre.supports();
  const Print print(test);
  return fmt::format(
      "{}; friction at the {}; the contact {}; a slender, straight, elastic beam",
      supports.radius > 0 ? fmt::format("rollers of a radius of {}", print.length(supports.radius)) : "sharp edges",
      supports.half_depth > 0 ? "surface of the specimen"
      : test.surface          ? "axis of the specimen"
                              : "axis of the specimen, as its section is not stated",
      measurement.contact == ContactSource::first_point
          ? "at the zero of the file"
          : fmt::format("at {}, as {}", print.own(measurement.contact_offset, kind::length),
                        measurement.contact == ContactSource::stated ? "stated" : "found"));
}

std::string strain_in_short(const FittedTest& test) {
  const double curvature = greatest_curvature(test.analysis.profile_at_fit, test.analysis.rig.fibre);
  if (!test.surface || !std::isfinite(curvature)) return "";
  std::string words = fmt::format("up to {:.2g} % at its surface", 100 * test.surface->strain(curvature));
  if (!test.reduced)
    words +=
        fmt::format(", {} at the modulus fitted", Print(test).own(test.surface->stress(curvature), kind::pressure));
  if (test.strain_at_break && test.surface->strain(curvature) > *test.strain_at_break)
    words += fmt::format(", beyond the {:.2g} % at which it should break", 100 * *test.strain_at_break);
  if (curvature > test.nose_curvature) words += "; it wrapped the nose, which is taken as sharp";
  return words;
}

std::string variation_in_short(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const double unit = test.analysis.scales.span();
  const Kind length = Print(test).as(kind::length);
  const bool is_rough = !(weight_without_roughness(fit) > 0.5);
  const std::string rough = is_rough
                                ? fmt::format("at random by {} (standard deviation), over some {} of the specimen",
                                              readable(fit.roughness.value, fit.roughness.standard_error, kind::number),
                                              roughly(unit * fit.length.value, length))
                                : "no roughness";
  if (!fit.wave_claimed) return fmt::format("{}; no periodicity is claimed", rough);
  const WaveEstimate& wave = fit.waves.front();
  return fmt::format("every {} by {} of its mean (ln B = {:.0f}); beside that {}",
                     readable(unit * wave.wavelength.value, unit * wave.wavelength.standard_error, length),
                     readable(wave.amplitude.value, wave.amplitude.standard_error, kind::number),
                     fit.log_evidence_of_wave, rough);
}

std::string energy_in_short(const FittedTest& test) {
  const MeasuredEnergy& energy = test.analysis.energy;
  const Print print(test);
  return fmt::format("{} of the work on the specimen, {} of {}, went into friction and drops",
                     percent(energy.friction_share), print.energy(energy.account.friction + energy.account.snaps),
                     print.energy(energy.work_of_fracture));
}

std::string checks_in_short(const FittedTest& test) {
  std::string text;
  for (const CheckInWords& said : checks_in_words(test))
    text += line_of_screen(said.outcome, said.words + (said.remedy.empty() ? "" : "; " + said.remedy));
  return text;
}

}  // namespace

std::string record_in_words(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& slips = analysis.slip_summary;
  const auto& w = analysis.reduced.deflection;
  std::string words = fmt::format("{}, to a deflection of {}, {} of the span", counted(w.size(), "row", "rows"),
                                  Print(test).length(w.back()), percent(w.back()));
  const std::size_t drops = analysis.drops.drops.size();
  if (drops > 0)
    words += fmt::format("; {}, the largest by {}", counted(drops, "drop", "drops"), [&] {
      double largest = 0;
      for (const Drop& drop : analysis.drops.drops) largest = std::max(largest, drop.force_fall);
      return Print(test).own(largest, kind::force);
    }());
  if (slips.count > 1 && claims_friction(test))
    words += fmt::format("; {} apart on the specimen; friction falls by {} in each (medians)",
                         roughly(analysis.scales.physical_length(slips.median_spacing), Print(test).as(kind::length)),
                         significant(slips.median_fall, 2));
  return words;
}

std::string fit_screen(const FittedTest& test) {
  std::string text = wrapped(fmt::format("{}: {}", printable(test.name), answer_of(test)), "");
  if (test.analysis.status != AnalysisStatus::ok) {
    text += "\n";
    for (const auto& sentence : preparation_in_words(test.measurement.preparation))
      text += wrapped(sentence, "   ", " - ");
    return text;
  }
  text += "\n" + line_of_screen("record", record_in_words(test)) + line_of_screen("friction", friction_on_screen(test));
  if (claims_friction(test)) {
    if (test.analysis.fit.model == ProfileModel::roughness)
      text += line_of_screen("along it", variation_in_short(test));
    text += line_of_screen("energy", energy_in_short(test));
  }
  text += line_of_screen("stiffness", stiffness_on_screen(test));
  if (const std::string strain = strain_in_short(test); !strain.empty() && is_trusted(test.judgement->standing))
    text += line_of_screen("strain", strain);
  text += "Checks\n" + checks_in_short(test);
  text += line_of_screen("assumed", assumed_in_short(test));
  text += line_of_screen("more", "--full: every table; --report FOLDER: figures; docs/reading-your-report.md");
  return text;
}

}  // namespace flexslip
