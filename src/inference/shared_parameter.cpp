#include "inference/shared_parameter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace flexslip {
namespace {

constexpr double fall = 1.9207;  // of the log likelihood at the ends of a 95 % interval: half of chi^2 with one freedom
constexpr double two_sided = 1.95996;  // standard deviations to either end of a normal one
constexpr int rounds = 4;              // each closes in eight times: 1/4096 of the first step
constexpr std::size_t grid = 9;

struct Point {
  double value;
  double log_likelihood;
};

std::vector<double> evenly(double from, double to, std::size_t points) {
  std::vector<double> values;
  values.reserve(points);
  for (std::size_t i = 0; i < points; ++i)
    values.push_back(from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(points - 1)));
  values.back() = to;
  return values;
}

class Search {
 public:
  Search(const SharedRange& range, const JointLikelihood& log_likelihood) : log_likelihood_(log_likelihood) {
    look(evenly(range.low, range.high, range.points));
    for (int round = 0; round < rounds; ++round) {
      const std::size_t best = at_best();
      look(evenly(points_[best > 0 ? best - 1 : best].value, points_[std::min(best + 1, points_.size() - 1)].value,
                  grid));
    }
  }

  Point best() const { return points_[at_best()]; }

  // Where the likelihood has fallen off on one side of the best; the end of the range if it has not.
  double end(int side) {
    const double level = best().log_likelihood - fall;
    for (int round = 0; round < rounds; ++round) {
      const auto [inside, outside] = crossing(side, level);
      if (inside.value == outside.value) return inside.value;
      look(evenly(std::min(inside.value, outside.value), std::max(inside.value, outside.value), grid));
    }
    const auto [inside, outside] = crossing(side, level);
    if (!std::isfinite(outside.log_likelihood)) return inside.value;
    const double part = (inside.log_likelihood - level) / (inside.log_likelihood - outside.log_likelihood);
    return inside.value + part * (outside.value - inside.value);
  }

 private:
  struct Crossing {
    Point inside, outside;
  };

  std::size_t at_best() const {
    const auto best = std::max_element(points_.begin(), points_.end(), [](const Point& a, const Point& b) {
      return a.log_likelihood < b.log_likelihood;
    });
    return static_cast<std::size_t>(best - points_.begin());
  }

  // The outermost neighbours between which the likelihood crosses the level: an interval that has gaps is given whole.
  Crossing crossing(int side, double level) const {
    const auto inside = [&](const Point& point) { return point.log_likelihood >= level; };
    if (side < 0) {
      const auto first = std::find_if(points_.begin(), points_.end(), inside);
      return {*first, first == points_.begin() ? *first : *(first - 1)};
    }
    const auto last = std::find_if(points_.rbegin(), points_.rend(), inside);
    return {*last, last == points_.rbegin() ? *last : *(last - 1)};
  }

  void look(const std::vector<double>& values) {
    const auto likelihoods = log_likelihood_(values);
    for (std::size_t i = 0; i < values.size(); ++i) points_.push_back({values[i], likelihoods[i]});
    std::sort(points_.begin(), points_.end(), [](const Point& a, const Point& b) { return a.value < b.value; });
    points_.erase(
        std::unique(points_.begin(), points_.end(), [](const Point& a, const Point& b) { return a.value == b.value; }),
        points_.end());
  }

  const JointLikelihood& log_likelihood_;
  std::vector<Point> points_;  // by value
};

}  // namespace

SharedEstimate estimate_shared(const SharedRange& range, const JointLikelihood& log_likelihood) {
  if (!(range.low > 0 && range.low < range.high) || range.points < 5)
    throw std::invalid_argument("a range from " + std::to_string(range.low) + " to " + std::to_string(range.high) +
                                " in " + std::to_string(range.points) + " points: 0 < low < high and 5 are needed");
  Search search(range, log_likelihood);
  const double low = search.end(-1);
  const double high = search.end(+1);
  const Point best = search.best();
  if (!std::isfinite(best.log_likelihood)) throw std::invalid_argument("no value in the range is possible");
  const bool at_bound = low <= range.low || high >= range.high;
  return {at_bound ? SharedStatus::at_bound : SharedStatus::ok,
          {.value = best.value, .standard_error = (high - low) / (2 * two_sided), .low = low, .high = high}};
}

}  // namespace flexslip
