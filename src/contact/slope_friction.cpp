#include "contact/slope_friction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/effort.h"

namespace flexslip {

double friction_on_slope(double mu, double slope) {
  if (!(mu * slope < 1))
    throw std::invalid_argument("a contact of friction " + std::to_string(mu) + " on a slope of " +
                                std::to_string(slope) + " holds whatever pulls");
  return (mu + slope) / (1 - mu * slope);
}

double slope_of_friction(double apparent, double mu) { return (apparent - mu) / (1 + apparent * mu); }

double friction_on_the_way_back(double apparent, double mu) {
  const double slope = slope_of_friction(apparent, mu);
  return slope < mu ? std::max((mu - slope) / (1 + mu * slope), 0.0) : 0;
}

std::optional<TooSteep> too_steep(std::span<const double> path, double step, double mu, double max_mu) {
  const double steepest_up = slope_of_friction(max_mu, mu), steepest_down = mu;
  std::optional<TooSteep> found;
  double worst = 1;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double slope = (path[i + 1] - path[i]) / step;
    const double excess = slope > 0 ? slope / steepest_up : -slope / steepest_down;
    // A friction of exactly 0 is also too small.
    if (excess > worst || (!found && excess == 1 && slope < 0)) {
      worst = std::max(worst, excess);
      found = TooSteep{i, slope};
    }
  }
  return found;
}

std::vector<double> friction_of_heights(std::span<const double> path, double step, double mu) {
  if (!(step > 0) || path.size() < 2 || !(mu >= 0))
    throw std::invalid_argument("friction on slopes needs two heights and a friction >= 0");
  std::vector<double> shown;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double slope = (path[i + 1] - path[i]) / step;
    shown.push_back(friction_on_slope(mu, slope));
    if (!(shown.back() >= 0))
      throw std::invalid_argument("on a slope of " + std::to_string(slope) + " a contact of friction " +
                                  std::to_string(mu) + " slides by itself");
  }
  return shown;
}

namespace {

// Of two equal circles, the farther one is higher beyond their intersection. The index of the
// touched sample therefore never decreases, and bisection finds it between the neighbours.
class Dilation {
 public:
  Dilation(std::span<const double> height, double step, double radius)
      : z_(height), path_(height.begin(), height.end()) {
    const double reach = std::floor(radius / step);
    const auto all = static_cast<double>(height.size());
    const auto max_k = static_cast<std::ptrdiff_t>(std::min(reach, all));
    for (std::ptrdiff_t k = 0; k <= max_k; ++k) {
      const double x = step * static_cast<double>(k);
      // √(r² - x²) - r without cancellation
      drop_.push_back(-x * x / (radius + std::sqrt(std::max((radius - x) * (radius + x), 0.0))));
    }
    if (max_k > 0)
      solve(0, static_cast<std::ptrdiff_t>(height.size()) - 1, 0, static_cast<std::ptrdiff_t>(height.size()) - 1);
  }

  std::vector<double> path() && { return std::move(path_); }

 private:
  void solve(std::ptrdiff_t first, std::ptrdiff_t last, std::ptrdiff_t least, std::ptrdiff_t greatest) {
    if (first > last) return;
    effort_spent += static_cast<std::uint64_t>(greatest - least + 1);
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

}  // namespace flexslip
