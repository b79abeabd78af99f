#include "report/fit_print.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "answers/fit_fields.h"
#include "finding/answer.h"
#include "finding/digits.h"
#include "io/quantity.h"
#include "report/field_table.h"

namespace flexslip {
namespace {

ParameterRow row_of(std::string name, std::string symbol, std::string meaning, const Estimate& estimate, double factor,
                    const Kind& kind) {
  const bool known = std::isfinite(estimate.standard_error);
  ParameterRow row{std::move(name),
                   std::move(symbol),
                   std::move(meaning),
                   readable(estimate.value * factor, estimate.standard_error * factor, kind),
                   "",
                   ""};
  if (known) {
    const std::string_view unit = best_unit(factor * std::max(std::abs(estimate.value), estimate.standard_error), kind);
    const MatchedDigits digits = matched_digits(estimate, unit.empty() ? factor : from_si(factor, parse_unit(unit)));
    if (!digits.low.empty())
      row.interval = fmt::format("{} to {}{}{}", digits.low, digits.high, unit.empty() ? "" : " ", typeset(unit));
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

}  // namespace

std::string_view stiffness_beforehand(const FittedTest& test) {
  switch (test.stiffness) {
    case StiffnessSource::initial_slope:
      return "of the initial slope";
    case StiffnessSource::mirror:
      return "of the loops";
    default:
      return "stated";
  }
}

std::vector<ParameterRow> parameter_rows(const FittedTest& test) {
  const auto& scales = test.analysis.scales;
  const auto& fit = test.analysis.fit;
  const Print print(test);
  std::vector<ParameterRow> rows;
  rows.push_back(row_of("mu0", "μ₀", "mean friction over the specimen seen", fit.mu0, 1, kind::number));
  if (fit.mu0_is_bound) {
    rows.back().value = mean_friction(fit);
    rows.back().remark = "cannot be distinguished from zero";
  }
  if (fit.model != ProfileModel::constant) {
    rows.push_back(row_of("drift", "dμ/dS", "slope of the mean along the length", fit.drift, 1 / scales.span(),
                          print.as(kind::inverse_length)));
    rows.push_back({"reference", "", "length at which mu0 and drift hold", print.length(fit.S_middle), "", ""});
  }
  if (fit.model == ProfileModel::roughness) {
    rows.push_back(row_of("roughness", "σ", "standard deviation of μ about its mean", fit.roughness, 1, kind::number));
    if (const double none = weight_without_roughness(fit); none > 0.5)
      rows.back().remark = fmt::format("if there is any: the evidence favours none ({})", percent(none));
    rows.push_back(row_of("correlation_length", "ℓ", "correlation length of the roughness along the specimen",
                          fit.length, scales.span(), print.as(kind::length)));
  }
  if (fit.wave_claimed)
    for (std::size_t i = 0; i < fit.waves.size(); ++i) {
      const auto& wave = fit.waves[i];
      const std::string suffix = i == 0 ? "" : fmt::format("_{}", i + 1);
      const std::string which = i == 0 ? "" : fmt::format(", wave {}", i + 1);
      const auto symbol = [&](const char* letter) { return i == 0 ? std::string(letter) : ""; };
      rows.push_back(row_of("amplitude" + suffix, symbol("A"), "amplitude of the wave, relative to μ₀" + which,
                            wave.amplitude, 1, kind::number));
      rows.push_back(row_of("wavelength" + suffix, symbol("λ"), "wavelength along the specimen" + which,
                            wave.wavelength, scales.span(), print.as(kind::length)));
      const auto add_phase = [&](const std::string& name, const std::string& letter, const std::string& meaning,
                                 const Estimate& phase) {
        const bool is_determined = phase.high - phase.low <= 2 * std::numbers::pi;  // else it turns with λ
        if (is_determined)
          rows.push_back(row_of(name + suffix, letter, meaning + which, phase, 1, print.as(kind::angle)));
      };
      add_phase("phase_at_middle", "", "phase in the middle of the specimen seen", wave.phase_at_middle);
      add_phase("phase", symbol("φ"), "phase of the wave at the length 0, equation (4.25)", wave.phase);
    }
  rows.push_back(row_of("bending_stiffness", "EI", "bending stiffness of the specimen", fit.bending_stiffness,
                        scales.bending_stiffness(), print.as(kind::bending_stiffness)));
  rows.back().remark = fit.model == ProfileModel::constant
                           ? "not fitted: with constant friction, roughness would distort it"
                           : fmt::format("{} from that {}, ± {:.1f} %", signed_percent(fit.bending_stiffness.value - 1),
                                         stiffness_beforehand(test), 100 * test.analysis.bending_stiffness_error);
  if (test.section_moment && !test.reduced)
    rows.push_back(row_of("modulus", "E", "flexural modulus, EI/I", fit.bending_stiffness,
                          scales.bending_stiffness() / *test.section_moment, print.as(kind::pressure)));
  if (fit.model != ProfileModel::constant)
    rows.push_back(row_of("force_noise", "", "standard deviation of a force reading", fit.noise,
                          scales.physical_force(1), print.as(kind::force)));
  return rows;
}

PrintedTable explanation_table(const FittedTest& test) {
  PrintedTable table{{"Roughness", "Wave", "Weight", "ln evidence minus the best"}, {}};
  const Print print(test);
  const auto& explanations = test.analysis.fit.explanations;
  for (std::size_t i = 0; i < std::min(listed_explanations, explanations.size()); ++i) {
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

PrintedTable snap_table(const FittedTest& test) {
  return shown(fit_fields(), test, frame_of(test), "snaps",
               {{"Stage", "stage"},
                {"Deflection before", "deflection_before"},
                {"after", "deflection_after"},
                {"Force before", "force_before"},
                {"after", "force_after"},
                {"Length before", "length_before"},
                {"after", "length_after"}});
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
      {"of which friction and drops", account.friction + account.snaps}};
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

}  // namespace flexslip
