#include "report/track_arrows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace flexslip {
namespace {

double distance(const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Spot between(const Spot& a, const Spot& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// Places arrows on a track, each not too near to another of the same direction of the stage.
class Arrows {
 public:
  Arrows(std::vector<Spot> spots) : spots_(std::move(spots)) {}

  // With its tip in the piece that ends with point i, as far along it as `share` says.
  void place(std::size_t first, std::size_t i, double share) {
    constexpr double length = 0.03;  // [width of the panel]
    constexpr double nearest = 0.2;  // likewise, of another arrow
    const Spot tip = between(spots_[i - 1], spots_[i], share);
    std::size_t back = i - 1;
    while (back > first && distance(spots_[back], tip) < length) --back;
    const double way = distance(spots_[back], tip);
    if (!(way > 0) || std::any_of(arrows_.begin(), arrows_.end(),
                                  [&](const Arrow& other) { return distance(other.to, tip) < nearest; }))
      return;
    arrows_.push_back({between(tip, spots_[back], std::min(1.0, length / way)), tip});
  }

  const Spot& spot(std::size_t i) const { return spots_[i]; }
  const std::vector<Arrow>& placed() const { return arrows_; }

 private:
  std::vector<Spot> spots_;
  std::vector<Arrow> arrows_;
};

constexpr double arrow_at = 0.55;        // of a way
constexpr double shortest_marked = 0.2;  // [width of the panel] way that has an arrow

// On a leg from point `first` to `last`, where the fibre has gone half its way.
void mark_leg(Arrows& arrows, std::size_t first, std::size_t last) {
  const double way = arrows.spot(last).x - arrows.spot(first).x;
  if (std::abs(way) < shortest_marked) return;
  const double target = arrows.spot(first).x + arrow_at * way;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double to = arrows.spot(i).x;
    if ((to - target) * way < 0) continue;
    const double from = arrows.spot(i - 1).x;
    return arrows.place(first, i, to == from ? 1 : (target - from) / (to - from));
  }
}

// On a stretch of sticking from point `first` to `last`.
void mark_sticking(Arrows& arrows, std::size_t first, std::size_t last) {
  const double way = distance(arrows.spot(first), arrows.spot(last));  // it is almost straight
  if (way < shortest_marked) return;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double to = distance(arrows.spot(first), arrows.spot(i));
    if (to < arrow_at * way) continue;
    const double from = distance(arrows.spot(first), arrows.spot(i - 1));
    return arrows.place(first, i, (arrow_at * way - from) / (to - from));
  }
}

}  // namespace

std::vector<TrackPoint> track_of(const History& history, std::span<const Leg> legs) {
  std::vector<TrackPoint> track;
  track.reserve(history.path.size());
  for (const Leg& leg : legs)
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      const PathPoint& p = history.path[i];
      track.push_back({p.w, p.F, p.S, p.q, p.motion, leg.direction});
    }
  return track;
}

Spot in_force(const TrackPoint& point, const Panel& panel) {
  return {point.w / panel.x, point.F / panel.y * panel.aspect};
}
Spot in_friction(const TrackPoint& point, const Panel& panel) {
  return {point.S / panel.x, point.q / panel.y * panel.aspect};
}

std::vector<Arrow> arrows_on(const std::vector<TrackPoint>& track, Projection projection, const Panel& panel,
                             Direction direction) {
  std::vector<Spot> spots;
  spots.reserve(track.size());
  for (const TrackPoint& point : track) spots.push_back(projection(point, panel));
  Arrows arrows(std::move(spots));
  const auto belongs = [&](std::size_t i) { return track[i].direction == direction; };
  const auto sticks = [&](std::size_t i) { return belongs(i) && is_sticking(track[i]); };
  const auto mark = [&](const auto& is_part, const auto& mark_part) {
    for (std::size_t i = 1; i < track.size(); ++i) {
      if (!is_part(i)) continue;
      const std::size_t first = i - 1;
      while (i + 1 < track.size() && is_part(i + 1)) ++i;
      mark_part(arrows, first, i);
    }
  };
  mark(belongs, mark_leg);
  mark(sticks, mark_sticking);
  return arrows.placed();
}

}  // namespace flexslip
