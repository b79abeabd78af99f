#include "finding/clauses.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "finding/printed.h"

namespace flexslip {

std::size_t drops_of(const FittedTest& test) { return test.analysis.drops.drops.size(); }

bool may_have_lost_stiffness(const FittedTest& test) {
  if (!is_fitted(test) || allows_for_losses(test.analysis)) return false;
  const bool is_smooth = weight_without_roughness(test.analysis.fit) > 0.5;
  return drops_of(test) > 0 || test.drops_elsewhere.drops > 0 || !is_smooth;
}

std::string mean_friction(const FrictionFit& fit) {
  return fit.mu0_is_bound ? fmt::format("at most {}", format_significant(fit.mu0.high, 2))
                          : readable(fit.mu0.value, fit.mu0.standard_error, kind::number);
}

std::string loss_in_words(const PassesFit& passes) {
  const Estimate& loss = passes.loss;
  if (loss.high > 0 && loss.value < loss.standard_error) return fmt::format("at most {:.1f} %", 100 * loss.high);
  return fmt::format("{:.1f} ± {:.1f} %", 100 * loss.value, 100 * loss.standard_error);
}

std::string unloading_force(const FittedTest& test) {
  if (!is_fitted(test)) return "";
  const FrictionFit& fit = test.analysis.fit;
  const double half_way = 0.5 * (1 + fit.S_end), EI = fit.bending_stiffness.value;
  const double force = EI * sliding_out_force(test.analysis.rig.fibre, half_way, std::max(fit.mu0.value, 0.0));
  return force > 0 ? format_roughly(test.analysis.scales.physical_force(force), Print(test).as(kind::force)) : "";
}

namespace {

// "cracks only: below 1 %"
std::string probability_in_words(std::string_view cause, double probability) {
  const double percent = 100 * probability;
  constexpr double min_shown = 1, max_shown = 99;  // the calibration on simulated tests resolves no more
  constexpr double threshold = 5;                  // the verdict changes here and at 100 - 5
  const double from_threshold = std::abs(std::abs(percent - 50) - (50 - threshold));
  if (from_threshold < 0.5) return fmt::format("{} only: {:.{}f} %", cause, percent, from_threshold < 0.05 ? 2 : 1);
  return percent < min_shown   ? fmt::format("{} only: below {} %", cause, min_shown)
         : percent > max_shown ? fmt::format("{} only: above {} %", cause, max_shown)
                               : fmt::format("{} only: {:.0f} %", cause, percent);
}

}  // namespace

std::string causes_in_words(const FittedTest& test) {
  const Causes& causes = test.judgement.causes;
  if (std::isnan(causes.cracks)) return "";
  const std::string cracks = probability_in_words("cracks", causes.cracks);
  constexpr double reliable = 0.5;  // above, one loading cannot distinguish slips only from slips and cracks
  return causes.slips < reliable || is_reloaded(test.analysis)
             ? cracks + ", " + probability_in_words("slips", causes.slips)
             : cracks;
}

std::string loss_by_drops_in_words(const FittedTest& test) {
  const DropFeatures& features = test.analysis.drop_features;
  const std::string low = format_percent(features.loss_needed - features.loss_recovered);
  const std::string high = format_percent(features.loss_needed);
  return low == high ? high : fmt::format("{} to {}", low.substr(0, low.find(' ')), high);
}

std::string usual_rollers(const FittedTest& test) {
  return "rollers of " + Print(*test.on_rollers).length(test.on_rollers->analysis.rig.fibre.supports().radius);
}

std::optional<std::string> friction_on_rollers(const FittedTest& test) {
  if (!test.on_rollers || !test.judgement.determines_friction) return std::nullopt;
  if (test.on_rollers->analysis.status == AnalysisStatus::deflection_too_small)
    return fmt::format("undetermined on {}", usual_rollers(test));
  if (!is_fitted(*test.on_rollers)) return std::nullopt;
  const FrictionFit &edges = test.analysis.fit, &rollers = test.on_rollers->analysis.fit;
  const double difference = std::abs(edges.mu0.value - rollers.mu0.value);
  if (!(difference > std::max(edges.mu0.standard_error, rollers.mu0.standard_error))) return std::nullopt;
  return fmt::format("{} on {}", mean_friction(rollers), usual_rollers(test));
}

}  // namespace flexslip
