#include "inference/build_up_length.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/build_up.h"
#include "fibre/elementary.h"
#include "fibre/limits.h"

namespace flexslip {
namespace {

constexpr std::size_t least_points = 6;
constexpr double grid = 1.04, shortest = 1.0 / 3000;  // of the longest way seen

struct Reversal {
  std::vector<double> way, q;  // [L], [1]
};

std::vector<Reversal> reversals_of(std::span<const Leg> legs, std::span<const CyclicPoint> points) {
  std::vector<Reversal> found;
  for (std::size_t leg = 1; leg < legs.size(); ++leg) {
    const double direction = legs[leg].direction == Direction::loading ? 1 : -1;
    const auto turned =
        std::find_if(points.begin(), points.end(), [&](const CyclicPoint& point) { return point.leg == leg; });
    if (turned == points.end() || turned->index != legs[leg].first) continue;
    Reversal reversal;
    double S = not_a_number;
    for (auto point = turned + 1; point != points.end() && point->leg == leg; ++point) {
      if (reversal.q.empty()) S = point->S;
      reversal.way.push_back(direction * (point->S - S));
      reversal.q.push_back(point->q);
    }
    if (reversal.q.size() >= least_points) found.push_back(std::move(reversal));
  }
  return found;
}

// The squares that a + b exp(-way/σ) leaves.
double misfit(const Reversal& reversal, double sigma, double up_to) {
  double n = 0, e = 0, ee = 0, y = 0, ey = 0, yy = 0;
  for (std::size_t i = 0; i < reversal.q.size() && (i < least_points || reversal.way[i] <= up_to); ++i) {
    const double decay = elementary::exp(-std::max(reversal.way[i], 0.0) / sigma), q = reversal.q[i];
    n += 1;
    e += decay;
    ee += decay * decay;
    y += q;
    ey += decay * q;
    yy += q * q;
  }
  const double spread = ee - e * e / n, together = ey - e * y / n;
  const double gained = spread > 0 ? together * together / spread : 0;
  return std::max(yy - y * y / n - gained, 0.0);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// What is slid from one row to the next, and five times its noise: nothing shorter can be told.
double resolution(std::span<const Reversal> reversals, double up_to) {
  std::vector<double> steps, bends;
  for (const Reversal& reversal : reversals)
    for (std::size_t i = 1; i < reversal.way.size() && (i < least_points || reversal.way[i] <= up_to); ++i)
      if (i < least_points || reversal.way[i] > 0.5 * up_to)
        steps.push_back(std::abs(reversal.way[i] - reversal.way[i - 1]));
  for (const Reversal& reversal : reversals)
    for (std::size_t i = 2; i < reversal.way.size() && (i < least_points || reversal.way[i] <= up_to); ++i)
      bends.push_back(std::abs(reversal.way[i] - 2 * reversal.way[i - 1] + reversal.way[i - 2]));
  constexpr double to_deviation = 1.4826 / 2.4495;  // of a median; a second difference has √6 times that of a row
  return median(std::move(steps)) + 5 * to_deviation * median(std::move(bends));
}

struct Found {
  double length, window;
};

// The window grows until it is wide beside what is found in it.
Found best_length(std::span<const Reversal> reversals, double most) {
  constexpr double narrowest = 1.0 / 6, wide = 4;
  for (double window = narrowest * most;; window *= 2) {
    double found = 0, least = infinity;
    for (double sigma = shortest * most; sigma <= window; sigma *= grid) {
      double squares = 0;
      for (const Reversal& reversal : reversals) squares += misfit(reversal, sigma, window);
      if (squares < least) {
        least = squares;
        found = sigma;
      }
    }
    if (wide * found <= window || window >= most) return {found, window};
  }
}

}  // namespace

std::optional<BuildUpLength> measure_build_up(std::span<const Leg> legs, std::span<const CyclicPoint> points) {
  std::vector<Reversal> reversals = reversals_of(legs, points);
  if (reversals.empty()) return std::nullopt;
  double most = 0;
  for (const Reversal& reversal : reversals)
    most = std::max(most, *std::max_element(reversal.way.begin(), reversal.way.end()));
  if (!(most > 0)) return std::nullopt;
  const Found found = best_length(reversals, most);
  BuildUpLength result{normal_estimate(found.length, not_a_number), resolution(reversals, found.window),
                       reversals.size()};
  if (reversals.size() < 2) return result;
  // Jackknife.
  double sum = 0, squares = 0;
  const auto n = static_cast<double>(reversals.size());
  for (std::size_t i = 0; i < reversals.size(); ++i) {
    std::swap(reversals[i], reversals.back());
    const double without = best_length(std::span(reversals).first(reversals.size() - 1), most).length;
    std::swap(reversals[i], reversals.back());
    sum += without;
    squares += without * without;
  }
  const double between = std::max((n - 1) * (squares / n - sum * sum / (n * n)), 0.0);
  result.length = normal_estimate(found.length, std::sqrt(between + std::pow(0.5 * (grid - 1) * found.length, 2)));
  return result;
}

double share_read(const BuildUpLength& build_up, double wavelength) {
  return share_after_build_up(build_up.length.value, wavelength);
}

}  // namespace flexslip
