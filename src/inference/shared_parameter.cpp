#include "inference/shared_parameter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace flexslip {
namespace {

constexpr double two_sided = 1.95996;  // standard deviations to either end of a 95 % interval

double weight(const OwnEstimate& own) {
  if (!(own.error > 0 && std::isfinite(own.error) && std::isfinite(own.value)))
    throw std::invalid_argument("an estimate needs a value and an error above 0, not " + std::to_string(own.value) +
                                " ± " + std::to_string(own.error));
  return 1 / (own.error * own.error);
}

}  // namespace

std::optional<OwnEstimate> of_the_record(const OwnEstimate& fitted, const OwnEstimate& stated) {
  constexpr double least_share = 0.1;
  const double told = weight(stated);
  const double left = weight(fitted) - told;
  if (!(left > least_share * told)) return std::nullopt;
  return OwnEstimate{(fitted.value * weight(fitted) - stated.value * told) / left, 1 / std::sqrt(left)};
}

SharedEstimate estimate_shared(std::span<const OwnEstimate> tests, const std::optional<OwnEstimate>& stated) {
  if (tests.size() < 2 && !stated) throw std::invalid_argument("a shared value needs two tests");
  double weights = 0;
  double sum = 0;
  for (const auto& test : tests) {
    weights += weight(test);
    sum += weight(test) * test.value;
  }
  double scatter = 0;
  if (tests.size() > 1) {
    double squares = 0;
    for (const auto& test : tests) squares += weight(test) * std::pow(test.value - sum / weights, 2);
    scatter = std::sqrt(squares / static_cast<double>(tests.size() - 1));
  }
  if (scatter > 1) {
    weights /= scatter * scatter;
    sum /= scatter * scatter;
  }
  if (stated) {
    weights += weight(*stated);
    sum += weight(*stated) * stated->value;
  }
  const double value = sum / weights;
  const double error = 1 / std::sqrt(weights);
  return {
      {.value = value, .standard_error = error, .low = value - two_sided * error, .high = value + two_sided * error},
      scatter};
}

}  // namespace flexslip
