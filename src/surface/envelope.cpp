#include "surface/envelope.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace flexslip {
namespace {

// Of two circles of one radius the one that stands farther on is the higher from where they cross. So the sample that is touched does not fall along
// the trace, and is looked for between those of the neighbours: halves, of halves, of halves.
class Dilation {
 public:
  Dilation(std::span<const double> height, double step, double radius)
      : z_(height), path_(height.begin(), height.end()) {
    const double reach = std::floor(radius / step);
    const auto all = static_cast<double>(height.size());
    const auto most = static_cast<std::ptrdiff_t>(std::min(reach, all));
    for (std::ptrdiff_t k = 0; k <= most; ++k) {
      const double x = step * static_cast<double>(k);
      // √(r² - x²) - r without the difference of two large numbers
      drop_.push_back(-x * x / (radius + std::sqrt(std::max((radius - x) * (radius + x), 0.0))));
    }
    if (most > 0)
      solve(0, static_cast<std::ptrdiff_t>(height.size()) - 1, 0, static_cast<std::ptrdiff_t>(height.size()) - 1);
  }

  std::vector<double> path() && { return std::move(path_); }

 private:
  void solve(std::ptrdiff_t first, std::ptrdiff_t last, std::ptrdiff_t least, std::ptrdiff_t greatest) {
    if (first > last) return;
    const std::ptrdiff_t middle = (first + last) / 2, reach = static_cast<std::ptrdiff_t>(drop_.size()) - 1;
    std::ptrdiff_t touched = middle;
    double highest = z_[static_cast<std::size_t>(middle)];
    for (std::ptrdiff_t j = std::max(least, middle - reach); j <= std::min(greatest, middle + reach); ++j) {
      const double there = z_[static_cast<std::size_t>(j)] + drop_[static_cast<std::size_t>(std::abs(j - middle))];
      if (there <= highest) continue;
      highest = there;
      touched = j;
    }
    path_[static_cast<std::size_t>(middle)] = highest;
    solve(first, middle - 1, least, touched);
    solve(middle + 1, last, touched, greatest);
  }

  std::span<const double> z_;
  std::vector<double> drop_, path_;
};

}  // namespace

std::vector<double> path_of_edge(std::span<const double> height, double step, double radius) {
  if (!(step > 0) || !(radius >= 0) || !std::isfinite(radius))
    throw std::invalid_argument("an edge of radius " + std::to_string(radius) + " on heights at a distance of " +
                                std::to_string(step));
  if (radius < step) return {height.begin(), height.end()};
  return Dilation(height, step, radius).path();
}

std::vector<double> envelope(std::span<const double> height, double step, double radius) {
  std::vector<double> path = path_of_edge(height, step, radius);
  for (double& each : path) each = -each;
  path = path_of_edge(path, step, radius);
  for (double& each : path) each = -each;
  return path;
}

}  // namespace flexslip
