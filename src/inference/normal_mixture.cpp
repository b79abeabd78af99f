#include "inference/normal_mixture.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fibre/elementary.h"
#include "fibre/limits.h"

namespace flexslip {

double mean_of(const NormalMixture& mixture) {
  double weight = 0, sum = 0;
  for (const auto& part : mixture) {
    weight += part.weight;
    sum += part.weight * part.mean;
  }
  return sum / weight;
}

double deviation_of(const NormalMixture& mixture) {
  const double mean = mean_of(mixture);
  double weight = 0, sum = 0;
  for (const auto& part : mixture) {
    weight += part.weight;
    sum += part.weight * (part.deviation * part.deviation + (part.mean - mean) * (part.mean - mean));
  }
  return std::sqrt(sum / weight);
}

double probability_below(const NormalMixture& mixture, double x) {
  double weight = 0, sum = 0;
  for (const auto& part : mixture) {
    weight += part.weight;
    const double away = x - part.mean;
    const double below = part.deviation > 0
                             ? elementary::exp(elementary::gaussian_below(away / part.deviation).log_probability)
                             : (away > 0 ? 1.0 : 0.0);
    sum += part.weight * below;
  }
  return sum / weight;
}

double quantile_of(const NormalMixture& mixture, double probability) {
  constexpr double reach = 12;  // deviations, beyond which nothing is
  double low = infinity, high = -low;
  for (const auto& part : mixture) {
    low = std::min(low, part.mean - reach * part.deviation);
    high = std::max(high, part.mean + reach * part.deviation);
  }
  for (int i = 0; i < 50; ++i) {
    const double middle = std::midpoint(low, high);
    (probability_below(mixture, middle) < probability ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

NormalMixture merged(const NormalMixture& mixture) {
  constexpr double near =
      0.7;  // deviations between means: two such parts alike and their one differ by 0.002 of a probability
  constexpr double alike = 1.3;  // ratio of deviations
  NormalMixture result;
  for (const auto& part : mixture) {
    const auto same = std::find_if(result.begin(), result.end(), [&](const NormalPart& other) {
      const auto [narrow, wide] = std::minmax(part.deviation, other.deviation);
      return std::abs(part.mean - other.mean) <= near * narrow && wide <= alike * narrow;
    });
    if (same == result.end()) {
      result.push_back(part);
      continue;
    }
    const NormalMixture two{*same, part};
    *same = {same->weight + part.weight, mean_of(two), deviation_of(two)};
  }
  return result;
}

}  // namespace flexslip
