#include "inference/imaged_length.h"

#include <cmath>

#include "data/order.h"
#include "fibre/limits.h"

namespace flexslip {

ImagedLength compare_with_images(const FrictionProfile& profile, std::span<const double> pulled_in) {
  constexpr double none = not_a_number;
  ImagedLength compared{{}, normal_estimate(none, none), none};
  std::vector<double> differences;
  for (const auto& point : profile.points) {
    if (!(point.index < pulled_in.size()) || !std::isfinite(pulled_in[point.index])) continue;
    compared.points.push_back({point.index, point.imaged - 1, pulled_in[point.index]});
    differences.push_back(point.imaged - 1 - pulled_in[point.index]);
  }
  if (differences.empty()) return compared;
  const double offset = median_of(differences);
  for (double& difference : differences) difference = std::abs(difference - offset);
  constexpr double of_median = 1.4826;  // standard deviation over median absolute deviation
  compared.scatter = of_median * median_of(differences);
  constexpr double of_a_median = 1.2533;  // its standard error over that of a mean
  compared.offset =
      normal_estimate(offset, of_a_median * compared.scatter / std::sqrt(static_cast<double>(differences.size())));
  return compared;
}

}  // namespace flexslip
