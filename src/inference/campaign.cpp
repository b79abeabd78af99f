#include "inference/campaign.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/elementary.h"

namespace flexslip {
namespace {

class Gathered {
 public:
  void add(double value) {
    spread_ = spread_.count == 0 ? Spread{0, 0, value, value} : spread_;
    ++spread_.count;
    spread_.mean += (value - spread_.mean) / static_cast<double>(spread_.count);
    spread_.min = std::min(spread_.min, value);
    spread_.max = std::max(spread_.max, value);
  }
  Spread spread() const { return spread_; }

 private:
  Spread spread_{};
};

template <class Predicate>
CategorySpread spread_over(std::span<const TestSummary> tests, Predicate belongs) {
  CategorySpread over{};
  Gathered mu0, mu0_limit, amplitude, wavelength;
  for (const auto& test : tests) {
    if (!belongs(test)) continue;
    ++over.tests;
    if (std::isnan(test.mu0.value)) continue;
    if (test.mu0_is_bound) {
      mu0_limit.add(test.mu0.high);
    } else {
      mu0.add(test.mu0.value);
    }
    if (test.category == SawtoothCategory::none || !test.wavelength) continue;
    over.waves_claimed += test.wave_claimed;
    amplitude.add(test.amplitude.value().value);
    wavelength.add(test.wavelength->value);
  }
  over.mu0 = mu0.spread();
  over.mu0_limit = mu0_limit.spread();
  over.amplitude = amplitude.spread();
  over.wavelength = wavelength.spread();
  return over;
}

MeasuredFriction measured_friction(const FrictionFit& fit, const Scales& scales) {
  MeasuredFriction measured{measured_by_record(fit.of_mu0), measured_by_record(fit.of_log_roughness), {}};
  if (weight_without_roughness(fit) > 0.5) return measured;  // what is likely not there has no length
  measured.log_length = measured_by_record(fit.of_log_length);
  if (measured.log_length) measured.log_length->value += elementary::log(scales.span());
  return measured;
}

std::optional<Population> between_specimens(const std::vector<const TestSummary*>& tests,
                                            std::optional<Measured> MeasuredFriction::*parameter) {
  std::vector<Measured> measured;
  for (const TestSummary* test : tests)
    if (const auto& of_test = test->measured.*parameter) measured.push_back(*of_test);
  if (measured.size() < min_tests_of_population) return std::nullopt;
  return population_of(measured);
}

std::optional<Population> not_negative(std::optional<Population> population) {
  if (!population || population->typical.high < 0) return std::nullopt;
  population->typical.value = std::max(population->typical.value, 0.0);
  population->typical.low = std::max(population->typical.low, 0.0);
  return population;
}

}  // namespace

TestSummary summary_of(const std::string& name, const TestAnalysis& analysis, const Judgement& judgement) {
  if (analysis.status != AnalysisStatus::ok) throw std::invalid_argument("a test without a fit has no summary");
  const Scales& scales = analysis.scales;
  const FrictionFit& fit = analysis.fit;
  TestSummary summary{.name = name,
                      .category = analysis.category,
                      .drops_verdict = judgement.drops,
                      .cracks_alone = judgement.cracks_alone(),
                      .model = fit.model,
                      .mu0 = fit.mu0,
                      .mu0_is_bound = fit.mu0_is_bound,
                      .roughness = fit.roughness,
                      .correlation_length = scaled(fit.length, scales.span()),
                      .wave_claimed = fit.wave_claimed,
                      .bending_stiffness = scaled(fit.bending_stiffness, scales.bending_stiffness()),
                      .residual_rms = scales.physical_force(fit.residual_rms),
                      .drops = analysis.drops.drops.size(),
                      .spacing = scales.physical_length(analysis.slip_summary.median_spacing),
                      .friction_share = analysis.energy.friction_share,
                      .work_of_fracture = scales.physical_energy(analysis.energy.work_of_fracture),
                      .measured = measured_friction(fit, scales)};
  if (is_reloaded(analysis))
    summary.loss =
        LostStiffness{analysis.passes->loss.value, analysis.passes->loss.standard_error, analysis.passes->loss_needed};
  if (const auto& by = fit.friction_by) {
    summary.mu0_by_load_train = (*by)[StatedQuantity::load_train] * analysis.rig_errors.load_train;
    summary.mu0_by_span = (*by)[StatedQuantity::span] * analysis.rig_errors.span;
    summary.mu0_by_gain = (*by)[StatedQuantity::force_gain] * analysis.rig_errors.force_gain;
  }
  const bool tells_variation = !fit.mu0_is_bound || fit.wave_claimed;
  if (!fit.waves.empty() && tells_variation) {
    const WaveEstimate& wave = fit.waves.front();
    summary.amplitude = wave.amplitude;
    summary.wavelength = scaled(wave.wavelength, scales.span());
    summary.phase = wave.phase;
  }
  return summary;
}

TestSummary without_friction(TestSummary summary) {
  const Estimate unknown = normal_estimate(not_a_number, not_a_number);
  summary.mu0 = summary.roughness = summary.correlation_length = unknown;
  summary.mu0_is_bound = summary.wave_claimed = false;
  summary.friction_share = summary.spacing = not_a_number;
  summary.amplitude = summary.wavelength = summary.phase = std::nullopt;
  summary.measured = {};
  return summary;
}

CracksTogether cracks_together(std::span<const TestSummary> tests) {
  CracksTogether together{.log_odds = 0};
  constexpr std::size_t steps = 1000;
  std::vector<double> log_weight(steps + 1, 0);
  for (const TestSummary& test : tests) {
    const double p = std::clamp(test.cracks_alone, 1e-6, 1 - 1e-6);
    if (!std::isfinite(p)) continue;
    ++together.tests;
    together.log_odds += elementary::log(p / (1 - p));
    for (std::size_t i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      log_weight[i] += elementary::log(share * p + (1 - share) * (1 - p));
    }
  }
  if (together.tests == 0) return {};
  const double greatest = *std::max_element(log_weight.begin(), log_weight.end());
  double total = 0;
  for (double& weight : log_weight) total += weight = elementary::exp(weight - greatest);
  const auto below = [&](double probability) {
    double sum = 0;
    for (std::size_t i = 0; i <= steps; ++i)
      if ((sum += log_weight[i]) >= probability * total) return static_cast<double>(i) / steps;
    return 1.0;
  };
  together.share = below(0.5);
  together.share_low = below(0.05);
  together.share_high = below(0.95);
  return together;
}

double shared_error_of(std::span<const TestSummary> tests) {
  double by_load_train = 0, by_span = 0, by_gain = 0;
  std::size_t count = 0;
  for (const TestSummary& test : tests) {
    if (test.suspect || test.mu0_is_bound || !std::isfinite(test.mu0.value)) continue;
    ++count;
    by_load_train += test.mu0_by_load_train;
    by_span += test.mu0_by_span;
    by_gain += test.mu0_by_gain;
  }
  return count == 0
             ? 0
             : elementary::length(elementary::length(by_load_train, by_span), by_gain) / static_cast<double>(count);
}

std::vector<CategorySummary> summarise(std::span<const TestSummary> tests) {
  const auto summary = [&](std::optional<SawtoothCategory> category) {
    const auto belongs = [&](const TestSummary& test) { return !category || test.category == *category; };
    const auto trusted = [&](const TestSummary& test) { return belongs(test) && !test.suspect; };
    std::vector<const TestSummary*> of_specimens;
    for (const auto& test : tests)
      if (trusted(test)) of_specimens.push_back(&test);
    return CategorySummary{category,
                           spread_over(tests, trusted),
                           spread_over(tests, belongs),
                           not_negative(between_specimens(of_specimens, &MeasuredFriction::mu0)),
                           between_specimens(of_specimens, &MeasuredFriction::log_roughness),
                           between_specimens(of_specimens, &MeasuredFriction::log_length)};
  };
  return {summary(SawtoothCategory::clear), summary(SawtoothCategory::nominal), summary(SawtoothCategory::none),
          summary(std::nullopt)};
}

}  // namespace flexslip
