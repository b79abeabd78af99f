#include "inference/analysis_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bending_test/history.h"

namespace flexslip {
namespace {

double stiffening_of(const TestAnalysis& analysis) {
  return analysis.status == AnalysisStatus::ok ? analysis.fit.bending_stiffness.value : 1;
}

}  // namespace

std::vector<EquilibriumPoint> frictionless_curve(const TestAnalysis& analysis) {
  constexpr int points = 200;
  const auto& deflection = analysis.record.deflection;
  const double deepest = analysis.scales.reduced_length(*std::max_element(deflection.begin(), deflection.end()));
  std::vector<EquilibriumPoint> curve = frictionless_up_to(deepest, points, analysis.rig.fibre);
  for (EquilibriumPoint& point : curve) point.F *= stiffening_of(analysis);
  return curve;
}

double euler_bernoulli_force(const TestAnalysis& analysis, double deflection) {
  return 48 * stiffening_of(analysis) * deflection;
}

History mean_run_forward(const TestAnalysis& analysis) {
  constexpr int points = 1000;  // on each stretch: a figure thins them out
  const auto& stage = analysis.reduced.stage;
  const double farthest = *std::max_element(stage.begin(), stage.end()), stiffening = stiffening_of(analysis);
  History history = follow_continuously({Friction::as_met(analysis.fit.mean), analysis.rig.in_units_of(stiffening)},
                                        {&farthest, 1}, points);
  for (auto& point : history.path) point.F *= stiffening;
  return history;
}

std::vector<FittedFriction> claimed_waves(const TestAnalysis& analysis) {
  const FrictionFit& fit = analysis.fit;
  std::vector<FittedFriction> waves;
  if (!fit.wave_claimed) return waves;
  constexpr double points_a_period = 24;
  const double seen = fit.S_end - fit.S_begin;
  double shortest = seen;
  for (const auto& each : fit.waves) shortest = std::min(shortest, 2 * each.wavelength.value);  // a period in S
  const int points = static_cast<int>(std::clamp(points_a_period * seen / shortest, 100.0, 20000.0));
  for (int i = 0; i <= points; ++i) {
    const double S = fit.S_begin + seen * i / points;
    const double away = fit.between_contacts(S) - fit.S_middle;
    double mu = fit.mu0.value + fit.drift.value * away;
    for (const auto& each : fit.waves)
      mu += fit.mu0.value * each.amplitude.value *
            std::cos(std::numbers::pi * away / each.wavelength.value + each.phase_at_middle.value);
    waves.push_back({S, mu});
  }
  return waves;
}

}  // namespace flexslip
