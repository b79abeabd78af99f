#include "report/fit_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "io/quantity.h"
#include "report/cycles_words.h"
#include "report/printed.h"

namespace flexslip {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// A drop that the specimen's sliding explains: length is drawn in, and friction stays between nothing and what is plausible.
bool is_explained(const Slip& slip, double limit) {
  return slip.S_after > slip.S_before && slip.mu_after >= 0 && slip.mu_before <= limit;
}

std::size_t explained_drops(const FittedTest& test) {
  const auto& slips = test.analysis.slips;
  return static_cast<std::size_t>(std::count_if(
      slips.begin(), slips.end(), [&](const Slip& slip) { return is_explained(slip, test.analysis.suspects.limit); }));
}

// The fit holds friction at a bound a little above 0.
constexpr double no_friction = 1e-6;

std::string friction_in_words(const ParameterEstimate& mu0) {
  return readable(mu0.value <= no_friction ? 0 : mu0.value, mu0.standard_error, kind::number);
}

std::string drops_in_words(const FittedTest& test) {
  const auto& summary = test.analysis.slip_summary;
  constexpr std::size_t enough = 3;  // to speak of a spacing
  const std::string spacing = summary.count < enough
                                  ? ""
                                  : fmt::format(", every {} of the specimen",
                                                roughly(test.analysis.scales.physical_length(summary.median_spacing),
                                                        Print(test).as(kind::length)));
  const std::size_t drops = test.analysis.drops.drops.size();
  const std::size_t slips = explained_drops(test);
  if (drops == 0) return "the force never drops by more than its noise";
  if (drops == 1)
    return slips == 1 ? "the force drops once, and a slip over the supports explains it"
                      : "the force drops once, and no plausible slip over the supports explains it";
  if (slips == drops)
    return fmt::format("the force drops {} times{}, and slips over the supports explain every drop", drops, spacing);
  if (slips == 0)
    return fmt::format("the force drops {} times, and no plausible slip over the supports explains a drop", drops);
  return fmt::format("the force drops {} times{}; plausible slips over the supports explain {} of the drops", drops,
                     spacing, slips);
}

ParameterRow row_of(std::string name, std::string symbol, std::string meaning, const ParameterEstimate& estimate,
                    double factor, const Kind& kind) {
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

std::string percent_of(double part, double whole) {
  return whole > 0 ? fmt::format("{:.1f} %", 100 * part / whole) : "";
}

}  // namespace

std::string answer_of(const FittedTest& test) {
  const auto& analysis = test.analysis;
  if (analysis.status == AnalysisStatus::no_initial_slope)
    return "No answer: the force does not rise where the record begins, so that the bending stiffness cannot be told.";
  if (analysis.status == AnalysisStatus::too_few_points)
    return "No answer: too few points lie beyond a deflection of a twentieth of the span, where friction shows.";
  const auto sawtooth = [&] {
    switch (analysis.category) {
      case SawtoothCategory::clear:
        return "A clear sawtooth";
      case SawtoothCategory::nominal:
        return "A faint sawtooth";
      case SawtoothCategory::none:
        return analysis.drops.drops.empty() ? "No sawtooth" : "Hardly a sawtooth";
    }
    return "";
  };
  const auto& mu0 = chosen_model(test).mu0;
  std::string answer =
      fmt::format("{}: {}. Friction at the supports is {}", sawtooth(), drops_in_words(test), friction_in_words(mu0));
  if (analysis.stiffness_implausible)
    return fmt::format(
               "No answer to trust: the bending stiffness stated is {:.2g} times that of the record's initial slope. "
               "Check the modulus, the "
               "section, the span, the columns and the unit of the force. ",
               analysis.stiffness_over_slope) +
           answer + ", if it is right.";
  if (analysis.model_implausible)
    return "No answer to trust: no sliding with friction gives this record. Check the columns, their units, the span "
           "and the section. " +
           answer + ", if it is right.";
  const double share = analysis.energy.friction_share;
  if (share > 0.005)
    answer += fmt::format("; it took {} of the work done on the specimen, which is no toughness", percent(share));
  else
    answer += ", too little to take a measurable part of the work";
  answer += analysis.suspects.suspect ? ". The test is suspect: it needs more friction than is plausible."
                                      : ". Nothing about it is suspect.";
  return test.cycles ? answer + " " + cycles_in_short(test) : answer;
}

std::vector<ParameterRow> parameter_rows(const FittedTest& test) {
  const auto& scales = test.analysis.scales;
  const auto& model = chosen_model(test);
  const Print print(test);
  std::vector<ParameterRow> rows;
  rows.push_back(row_of("mu0", "μ₀", "mean friction in the middle of the data", model.mu0, 1, kind::number));
  rows.back().value = friction_in_words(model.mu0);
  if (model.mu0.value <= no_friction) rows.back().remark = "at its bound: friction cannot be negative";
  std::string suffix;
  int number = 1;
  for (const auto& wave : waves_by_size(model)) {
    const std::string which = number == 1 ? "" : fmt::format(", wave {}", number);
    const auto symbol = [&](const char* letter) { return number == 1 ? std::string(letter) : ""; };
    rows.push_back(row_of("amplitude" + suffix, symbol("A"), "of the friction, relative to μ₀" + which, wave.amplitude,
                          1, kind::number));
    rows.push_back(row_of("wavelength" + suffix, symbol("λ"), "along the specimen" + which, wave.wavelength,
                          scales.span(), print.as(kind::length)));
    for (const auto& other : wave.other_wavelengths)
      rows.back().remark += fmt::format("{}{} to {}", rows.back().remark.empty() ? "or " : ", or ",
                                        print.length(other.low), print.length(other.high));
    rows.push_back(row_of("phase_at_middle" + suffix, "", "in the middle of the data" + which, wave.phase_at_middle, 1,
                          print.as(kind::angle)));
    rows.push_back(row_of("phase" + suffix, symbol("φ"), "of (4.25), at the length 0" + which, wave.phase, 1,
                          print.as(kind::angle)));
    if (wave.phase.high - wave.phase.low > 2 * std::numbers::pi)
      rows.back().remark = "not determined: it turns with λ, by more than a full turn within its interval";
    suffix = fmt::format("_{}", ++number);
  }
  if (model.model != ProfileModel::constant)
    rows.push_back(row_of("drift", "dμ/dS", "of the mean along the length", model.drift, 1 / scales.span(),
                          print.as(kind::inverse_length)));
  rows.push_back(row_of("bending_stiffness", "EI", "of the specimen", model.bending_stiffness,
                        scales.bending_stiffness(), print.as(kind::bending_stiffness)));
  rows.back().remark = model.model == ProfileModel::constant
                           ? "not fitted: a constant friction would bend it to the roughness"
                           : fmt::format("{:+.1f} % from {}, ± {:.1f} %", 100 * (model.bending_stiffness.value - 1),
                                         test.stiffness == StiffnessSource::initial_slope ? "the initial slope"
                                         : test.stiffness == StiffnessSource::mirror      ? "that of the loops"
                                                                                          : "that given",
                                         100 * test.analysis.bending_stiffness_error);
  if (test.section_moment && !test.reduced)
    rows.push_back(row_of("modulus", "E", "flexural modulus, EI/I", model.bending_stiffness,
                          scales.bending_stiffness() / *test.section_moment, kind::pressure));
  return rows;
}

PrintedTable model_table(const FittedTest& test) {
  PrintedTable table{
      {"Model", "Parameters", "BIC", "above the best", "log-likelihood", "residual rms", "correlation", "μ₀"}, {}};
  const Print print(test);
  const auto& fit = test.analysis.fit;
  for (std::size_t i = 0; i < fit.models.size(); ++i) {
    const auto& model = fit.models[i];
    const std::string name = std::string(name_of(model.model)) + (i == fit.chosen ? " (chosen)" : "");
    if (model.status == FitStatus::not_found) {
      table.rows.push_back({name, "", "no wave found", "", "", "", "", ""});
      continue;
    }
    table.rows.push_back({name, fmt::format("{}", model.parameters), fmt::format("{:.1f}", model.bic),
                          fmt::format("{:.1f}", model.bic - fit.models[fit.chosen].bic),
                          fmt::format("{:.1f}", model.log_likelihood), print.force(model.residual_rms),
                          fmt::format("{:.2f}", model.correlation), friction_in_words(model.mu0)});
  }
  return table;
}

PrintedTable drop_table(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const Print print(test);
  const auto length = print.as(kind::length);
  const auto force = print.as(kind::force);
  NumberColumn stage{"Stage", {}, length}, before{"Force before", {}, force}, fall{"Fall", {}, force, 3},
      drawn_in{"Drawn in, both sides", {}, length, 3}, mu_before{"μ before", {}, kind::number, 3},
      mu_after{"μ after", {}, kind::number, 3};
  std::vector<std::string> rows, significance, reading;
  auto slip = analysis.slips.begin();
  for (const auto& drop : analysis.drops.drops) {
    while (slip != analysis.slips.end() && slip->drop.before < drop.before) ++slip;
    const bool has_slip = slip != analysis.slips.end() && slip->drop.before == drop.before;
    rows.push_back(fmt::format("{}–{}", file_row(test, drop.before), file_row(test, drop.after)));
    stage.values.push_back(analysis.record.stage[drop.before]);
    before.values.push_back(analysis.record.force[drop.before]);
    fall.values.push_back(drop.force_fall);
    significance.push_back(fmt::format("{:.1f}", drop.significance));
    drawn_in.values.push_back(has_slip ? analysis.scales.physical_length(slip->S_after - slip->S_before)
                                       : not_a_number);
    mu_before.values.push_back(has_slip ? slip->mu_before : not_a_number);
    mu_after.values.push_back(has_slip ? slip->mu_after : not_a_number);
    reading.emplace_back(!has_slip                                      ? "no friction explains it"
                         : is_explained(*slip, analysis.suspects.limit) ? "slip"
                                                                        : "no plausible slip");
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
  return table;
}

PrintedTable wavelength_table(const FittedTest& test) {
  const Print print(test);
  NumberColumn wavelength{"Wavelength", {}, print.as(kind::length)}, amplitude{"Amplitude in μ", {}, kind::number, 2};
  for (const auto& candidate : test.analysis.fit.scan.candidates) {
    wavelength.values.push_back(test.analysis.scales.physical_length(candidate.wavelength));
    amplitude.values.push_back(std::hypot(candidate.cosine, candidate.sine));
  }
  PrintedTable table = printed({wavelength, amplitude});
  table.head.emplace_back("Gain of log-likelihood");
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.rows[i].push_back(fmt::format("{:.1f}", test.analysis.fit.scan.candidates[i].log_likelihood_gain));
  return table;
}

PrintedTable runner_up_table(const FittedTest& test) {
  const Print print(test);
  const auto& scales = test.analysis.scales;
  NumberColumn wavelength{"Wavelength", {}, print.as(kind::length)}, amplitude{"A", {}, kind::number, 3},
      rms{"Residual rms", {}, print.as(kind::force)};
  const auto& runners_up = chosen_model(test).runners_up;
  for (const auto& other : runners_up) {
    wavelength.values.push_back(scales.physical_length(other.wavelength));
    amplitude.values.push_back(other.amplitude);
    rms.values.push_back(scales.physical_force(other.residual_rms));
  }
  PrintedTable table = printed({wavelength, amplitude, rms});
  table.head.emplace_back("Log-likelihood, less the best");
  for (std::size_t i = 0; i < runners_up.size(); ++i)
    table.rows[i].push_back(fmt::format("{:.1f}", runners_up[i].delta_log_likelihood));
  return table;
}

std::vector<std::size_t> order_by_size(const ModelFit& model) {
  std::vector<std::size_t> order(model.waves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return model.waves[a].amplitude.value > model.waves[b].amplitude.value; });
  return order;
}

PrintedTable bootstrap_table(const FittedTest& test) {
  PrintedTable table{{"Bootstrap", "value", "95 % interval"}, {}};
  if (!test.analysis.bootstrap) return table;
  const auto& bootstrap = *test.analysis.bootstrap;
  const auto& scales = test.analysis.scales;
  const auto& model = chosen_model(test);
  const Print print(test);
  const auto add = [&](const std::string& name, double value, const BootstrapEstimate& spread, double factor,
                       const Kind& kind) {
    const auto row = row_of(name, "", "", {value, spread.standard_error, spread.low, spread.high}, factor, kind);
    table.rows.push_back({row.name, row.value, row.interval});
  };
  add("mu0", model.mu0.value, bootstrap.mu0, 1, kind::number);
  std::string suffix;
  int number = 1;
  for (const auto i : order_by_size(model)) {
    const auto& wave = model.waves[i];
    const auto& spread = bootstrap.waves[i];
    add("amplitude" + suffix, wave.amplitude.value, spread.amplitude, 1, kind::number);
    add("wavelength" + suffix, wave.wavelength.value, spread.wavelength, scales.span(), print.as(kind::length));
    add("phase" + suffix, wave.phase.value, spread.phase, 1, print.as(kind::angle));
    suffix = fmt::format("_{}", ++number);
  }
  add("bending_stiffness", model.bending_stiffness.value, bootstrap.bending_stiffness, scales.bending_stiffness(),
      print.as(kind::bending_stiffness));
  return table;
}

std::string friction_in_literature(const FittedTest& test) {
  const auto& mu0 = chosen_model(test).mu0;
  const auto [low, high] = glass_on_steel;
  const std::string value = friction_in_words(mu0);
  const std::string range =
      fmt::format("the range {:g} to {:g} that the literature gives for glass on steel", low, high);
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
  std::string words =
      snaps == 0 ? "The chosen model never snaps"
                 : fmt::format("The chosen model snaps {}", snaps == 1 ? "once" : fmt::format("{} times", snaps));
  words += fmt::format(", where the measured force drops {}.", drops == 1 ? "once" : fmt::format("{} times", drops));
  if (snaps < drops)
    words += " A few waves do not follow every tooth of a rough specimen; the measured profile does, see below.";
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
  const auto& model = chosen_model(test);
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
  if (measurement.rows_per_point > 1)
    list.push_back(fmt::format("The file has {0} rows, of which every {1}th is used.", measurement.rows,
                               measurement.rows_per_point));
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
  list.push_back(
      fmt::format("Residuals of neighbouring points are correlated ({:.2f}), because no model follows the roughness "
                  "exactly: {} points are worth {:.0f} "
                  "independent ones. Standard errors, intervals and BIC allow for it.",
                  model.correlation, model.force.size(), model.effective_points));
  if (model.model != ProfileModel::constant)
    list.emplace_back(
        "Of neighbouring maxima of the likelihood in the wavelength the greatest was taken. The others are listed, and "
        "their intervals where the record does not exclude them.");
  list.emplace_back(
      "The specimen is a slender, straight, elastic, inextensible beam that slides over both supports alike; its "
      "section does not change along it.");
  return list;
}

}  // namespace flexslip
