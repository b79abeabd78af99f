#include "inference/campaign.h"

#include <algorithm>
#include <array>
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
  if (weight_without_roughness(fit) > 0.5) return measured;  // probably no roughness, so no length
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

TestSummary summary_of(const std::string& name, const TestAnalysis& analysis) {
  if (analysis.status != AnalysisStatus::ok) throw std::invalid_argument("a test without a fit has no summary");
  const Scales& scales = analysis.scales;
  const FrictionFit& fit = analysis.fit;
  TestSummary summary{.name = name,
                      .category = analysis.category,
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
                      .friction_share_error = analysis.energy.friction_share_error,
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
  if (!determines_variation(fit))
    summary.roughness = summary.correlation_length = normal_estimate(not_a_number, not_a_number);
  if (!fit.waves.empty() && determines_variation(fit)) {
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
  summary.friction_share = summary.friction_share_error = summary.spacing = not_a_number;
  summary.amplitude = summary.wavelength = summary.phase = std::nullopt;
  summary.measured = {};
  return summary;
}

CauseShares cause_shares(std::span<const Causes> tests) {
  constexpr int steps = 50;
  std::vector<const Causes*> told;
  for (const Causes& test : tests)
    if (std::isfinite(test.slips)) told.push_back(&test);
  if (told.empty()) return {};
  std::vector<std::array<double, 4>> points;  // three shares and their log weight
  double greatest = -infinity;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double slips = (i + 1.0 / 3) / (steps + 1), cracks = (j + 1.0 / 3) / (steps + 1), both = 1 - slips - cracks;
      double log_weight = 0;
      for (const Causes* test : told)
        log_weight += elementary::log(slips * test->slips + cracks * test->cracks + both * test->both);
      points.push_back({slips, cracks, both, log_weight});
      greatest = std::max(greatest, log_weight);
    }
  for (auto& point : points) point[3] = elementary::exp(point[3] - greatest);
  const auto share_of = [&](std::size_t cause) {
    std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return a[cause] < b[cause]; });
    double total = 0;
    for (const auto& point : points) total += point[3];
    const auto below = [&](double probability) {
      double sum = 0;
      for (const auto& point : points)
        if ((sum += point[3]) >= probability * total) return point[cause];
      return 1.0;
    };
    return CauseShares::Share{.median = below(0.5), .low = below(0.025), .high = below(0.975)};
  };
  return {.tests = told.size(), .slips = share_of(0), .cracks = share_of(1), .both = share_of(2)};
}

Estimate mean_friction_share(std::span<const TestSummary> tests) {
  std::vector<double> shares, errors;
  for (const TestSummary& test : tests)
    if (!test.suspect && std::isfinite(test.friction_share)) {
      shares.push_back(test.friction_share);
      errors.push_back(test.friction_share_error);
    }
  const double mean = mean_of(shares), count = static_cast<double>(shares.size());
  double squares = 0;
  for (const double share : shares) squares += (share - mean) * (share - mean);
  const double scatter = count > 1 ? std::sqrt(squares / (count - 1) / count) : 0;
  Estimate share = normal_estimate(mean, elementary::length(scatter, mean_of(errors)));
  share.low = std::max(share.low, 0.0);
  share.high = std::min(share.high, 1.0);
  return share;
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
