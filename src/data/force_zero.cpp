#include "data/force_zero.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "data/line.h"

namespace flexslip {
namespace {

constexpr double band = 4;                 // [noise] one row in 16,000 of a level force leaves it
constexpr std::size_t least_points = 10;   // before the contact: fewer tell neither an offset nor its error
constexpr double most_correlation = 0.95;  // of neighbouring rows: beyond it a mean tells no error

// The rows from the first on whose force stays within the band about the mean of those before.
std::size_t level_rows(std::span<const double> force, double noise) {
  double sum = force.front();
  for (std::size_t n = 1; n < force.size(); ++n) {
    const auto before = static_cast<double>(n);
    if (std::abs(force[n] - sum / before) > band * noise * std::sqrt(1 + 1 / before)) return n;
    sum += force[n];
  }
  return force.size();
}

}  // namespace

ForceZero find_force_zero(std::span<const double> displacement, std::span<const double> force, double noise) {
  if (displacement.size() != force.size())
    throw std::invalid_argument("columns of " + std::to_string(displacement.size()) + " and " +
                                std::to_string(force.size()) + " points");
  if (!(noise >= 0)) throw std::invalid_argument("noise = " + std::to_string(noise) + " N is negative");
  const ForceZero none{ForceZeroStatus::no_free_rows, 0, 0, 0};
  if (force.size() < least_points) return none;

  const std::size_t level = level_rows(force, noise);
  if (level < least_points || level == force.size()) return none;
  // The force that the way through the level rows would have raised, at the mean slope from there to the greatest force.
  const auto greatest = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  const double free_way = displacement[level - 1] - displacement.front();
  const double rising_way = displacement[greatest] - displacement[level - 1];
  if (!(greatest >= level && free_way > 0 && rising_way > 0)) return none;
  const double rise = (force[greatest] - force[level - 1]) * free_way / rising_way;
  if (!(rise > 2 * band * noise)) return none;

  const double half = displacement.front() + 0.5 * free_way;
  const auto points = std::max<std::size_t>(
      least_points / 2, static_cast<std::size_t>(
                            std::find_if(displacement.begin(), displacement.end(), [=](double x) { return x > half; }) -
                            displacement.begin()));
  const auto free = force.first(std::min(points, level));
  const auto n = static_cast<double>(free.size());
  const double mean = std::accumulate(free.begin(), free.end(), 0.0) / n;
  std::vector<double> residuals(free.begin(), free.end());
  for (double& residual : residuals) residual -= mean;
  const double scatter = effective_deviation(residuals, 1, 1 / n, most_correlation);
  return {ForceZeroStatus::found, mean, std::max(scatter, noise) / std::sqrt(n), free.size()};
}

bool is_significant(const ForceZero& zero) {
  return zero.status == ForceZeroStatus::found && std::abs(zero.offset) > 4 * zero.error;
}

}  // namespace flexslip
