#include "report/track_arrows.h"

#include <algorithm>
#include <cmath>

namespace flexslip {
namespace {

constexpr double length = 0.035;         // of an arrow, of the panel
constexpr double straight = 0.003;       // how far the line may be from it
constexpr double least_distance = 0.16;  // to another arrow
constexpr double shortest = 0.1;         // line that has one

double distance(const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Spot between(const Spot& a, const Spot& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

double distance_from_line(const Spot& spot, const Spot& from, const Spot& to) {
  return std::abs((to.x - from.x) * (spot.y - from.y) - (to.y - from.y) * (spot.x - from.x)) / distance(from, to);
}

}  // namespace

std::optional<Arrow> arrow_on(std::span<const Spot> line, std::size_t first, std::size_t last,
                              const std::vector<Arrow>& others) {
  std::vector<double> way{0};  // from the first spot
  for (std::size_t i = first + 1; i <= last; ++i) way.push_back(way.back() + distance(line[i - 1], line[i]));
  if (way.back() < shortest) return std::nullopt;
  const auto spot_at = [&](double along) {
    const auto after = std::upper_bound(way.begin() + 1, way.end() - 1, along);
    const auto i = static_cast<std::size_t>(after - way.begin());
    const double step = way[i] - way[i - 1];
    return between(line[first + i - 1], line[first + i], step > 0 ? (along - way[i - 1]) / step : 0);
  };
  // The line is straight from `before` the arrow to `after` it.
  const auto is_straight = [&](const Arrow& arrow, double before, double after) {
    for (std::size_t k = 0; k < way.size(); ++k)
      if (way[k] > before && way[k] < after && distance_from_line(line[first + k], arrow.from, arrow.to) > straight)
        return false;
    return true;
  };
  constexpr int places = 40;
  for (const double around : {1.0, 0.0})  // [lengths] first where it is straight around the arrow as well
    for (int i = 0; i <= places; ++i) {
      // From the middle outwards, on both sides in turn.
      const double share = 0.5 + (i % 2 == 0 ? 0.45 : -0.45) * ((i + 1) / 2) / (places / 2.0);
      const double tip = share * way.back() + length / 2, back = tip - length;
      if (back < 0 || tip > way.back()) continue;
      const Arrow arrow{spot_at(back), spot_at(tip)};
      if (distance(arrow.from, arrow.to) > 0.9 * length &&
          is_straight(arrow, back - around * length, tip + around * length) &&
          std::none_of(others.begin(), others.end(),
                       [&](const Arrow& other) { return distance(other.to, arrow.to) < least_distance; }))
        return arrow;
    }
  return std::nullopt;
}

}  // namespace flexslip
