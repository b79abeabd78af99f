#include "inference/correlations.h"

#include <algorithm>
#include <cmath>

namespace flexslip {

std::vector<Correlation> correlations_of(std::span<const JointPart> parts) {
  constexpr std::size_t n = JointPart::count;
  std::array<double, n> weight{}, mean{};
  for (const JointPart& part : parts)
    for (std::size_t i = 0; i < n; ++i) {
      if (std::isnan(part.value[i])) continue;
      weight[i] += part.weight;
      mean[i] += part.weight * part.value[i];
    }
  std::array<std::array<double, n>, n> covariance{};
  for (const JointPart& part : parts) {
    std::array<double, n> away{};
    for (std::size_t i = 0; i < n; ++i)
      if (!std::isnan(part.value[i])) away[i] = part.value[i] - mean[i] / weight[i];
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const bool is_told = i < JointPart::normal && j < JointPart::normal;
        covariance[i][j] += part.weight * (away[i] * away[j] + (is_told ? part.covariance[i][j] : 0));
      }
  }
  std::vector<Correlation> correlations;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double size = std::sqrt(covariance[i][i]) * std::sqrt(covariance[j][j]);
      if (size > 0)
        correlations.push_back({JointPart::parameter_names[i], JointPart::parameter_names[j],
                                std::clamp(covariance[i][j] / size, -1.0, 1.0)});
    }
  return correlations;
}

}  // namespace flexslip
