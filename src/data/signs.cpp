#include "data/signs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace flexslip {

Signs find_signs(std::span<const double> displacement, std::span<const double> force) {
  if (displacement.size() != force.size())
    throw std::invalid_argument("columns of " + std::to_string(displacement.size()) + " and " +
                                std::to_string(force.size()) + " points");
  if (force.empty()) return {1, 1};

  const auto by_magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto greatest = std::max_element(force.begin(), force.end(), by_magnitude);
  const int force_sign = *greatest < 0 ? -1 : 1;
  const auto by_compression = [=](double a, double b) { return force_sign * a < force_sign * b; };
  const auto least = greatest == force.begin() ? std::min_element(greatest, force.end(), by_compression)
                                               : std::min_element(force.begin(), greatest, by_compression);
  const auto at = [&](auto row) { return displacement[static_cast<std::size_t>(row - force.begin())]; };
  return {at(greatest) < at(least) ? -1 : 1, force_sign};
}

}  // namespace flexslip
