#include "contact/two_supports.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// Crests closer in height are equal, as crests of one wave are, so that rounding does not choose a
// side.
constexpr double alike = 1e-12;

// The friction at a point of the specimen, and its slope there.
FrictionPoint at_point(const Friction& side, double x) {
  const auto [mu, slope] = side.at(1 + 2 * x);
  return {mu, 2 * slope};
}

// The lengths between two others at which the friction begins or ceases to be limited at zero.
std::vector<double> kinks_between(const Friction& side, double from, double to) {
  std::vector<double> kinks;
  if (!side.may_reach_zero() || !(to > from)) return kinks;
  const auto is_held = [&](double S) { return side.without_limit(S) < 0; };
  const double sample = std::min(0.25 * side.smooth_scale(), to - from);
  const auto samples = static_cast<std::size_t>(std::ceil((to - from) / sample));
  for (std::size_t k = 0; k < samples; ++k) {
    const double S = from + static_cast<double>(k) * sample, next = std::min(S + sample, to);
    if (const bool then = is_held(next); then != is_held(S))
      kinks.push_back(first_where(S, next, [&](double at) { return is_held(at) == then; }));
  }
  return kinks;
}

void sort_and_merge(std::vector<double>& knots) {
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
}

}  // namespace

MeanOfSides::MeanOfSides(Friction left, Friction right, double S_max)
    : left_(std::move(left)), right_(std::move(right)), S_most_(S_max) {
  for (const Friction* side : {&left_, &right_}) {
    const auto own = side->knots();
    const auto kinks = kinks_between(*side, 1, S_max);
    knots_.insert(knots_.end(), own.begin(), own.end());
    knots_.insert(knots_.end(), kinks.begin(), kinks.end());
  }
  sort_and_merge(knots_);
}

FrictionPoint MeanOfSides::at(double S) const {
  const FrictionPoint left = left_.at(S), right = right_.at(S);
  return {0.5 * (left.mu + right.mu), 0.5 * (left.slope + right.slope)};
}

// Follows one path, in or out; y is the length that a side has travelled.
class TwoSupportPath::Tracer {
 public:
  Tracer(const std::array<Friction, 2>& sides, ContactPoints from, double direction, double max_travel)
      : sides_(sides), from_{from.left, from.right}, direction_(direction), max_travel_(max_travel) {}

  // The pieces in the order of the path.
  std::vector<Piece> run() {
    std::vector<Piece> pieces;
    const double mu[2] = {at(0, 0).mu, at(1, 0).mu};
    bool level = std::abs(mu[0] - mu[1]) <= alike * mu[0];
    std::size_t weaker = mu[1] < mu[0] ? 1 : 0;
    while (!arrived_ && gone() < max_travel_) {
      const std::array<double, 2> begin = y_;
      Slides slides = weaker == 0 ? Slides::left : Slides::right;
      if (level && rises(0) && rises(1)) {
        slides = Slides::both;
        weaker = slide_both();
      } else {
        if (level) weaker = first_to_fall();
        slides = weaker == 0 ? Slides::left : Slides::right;
        level = slide_alone(weaker);
        crest_[weaker] = false;
      }
      pieces.push_back(piece(begin, slides));
    }
    return pieces;
  }

 private:
  FrictionPoint at(std::size_t side, double y) const {
    const auto [mu, slope] = at_point(sides_[side], from_[side] + direction_ * y);
    return {mu, direction_ * slope};
  }
  double gone() const { return y_[0] + y_[1]; }
  bool rises(std::size_t side) const { return !crest_[side] && at(side, y_[side]).slope > 0; }

  // Chooses between two sides of equal friction: the side on a crest, otherwise the one with the
  // smaller slope.
  std::size_t first_to_fall() const {
    if (crest_[0] != crest_[1]) return crest_[1] ? 1 : 0;
    const double slope[2] = {at(0, y_[0]).slope, at(1, y_[1]).slope};
    return slope[1] < slope[0] - alike * std::abs(slope[0]) ? 1 : 0;
  }

  // The next sample of a side.
  double next_after(std::size_t side, double y) const {
    constexpr double samples = 0.25;  // in smooth scales of S, each a quarter of a period
    double next = y + 0.5 * samples * sides_[side].smooth_scale();
    const auto knots = sides_[side].knots();
    const double S = 1 + 2 * (from_[side] + direction_ * y);
    const double rounding = 4e-16 * S;
    const auto y_of = [&](double knot) { return direction_ * (0.5 * (knot - 1) - from_[side]); };
    if (direction_ > 0) {
      const auto knot = std::upper_bound(knots.begin(), knots.end(), S + rounding);
      if (knot != knots.end()) next = std::min(next, y_of(*knot));
    } else {
      const auto knot = std::lower_bound(knots.begin(), knots.end(), S - rounding);
      if (knot != knots.begin()) next = std::min(next, y_of(*(knot - 1)));
    }
    return next;
  }

  // Slides one side until its friction reaches the other friction; false at the end of the path.
  bool slide_alone(std::size_t side) {
    const double level = at(1 - side, y_[1 - side]).mu;
    const double last = max_travel_ - y_[1 - side];
    double y = y_[side];
    bool below = at(side, y).mu < level;
    while (y < last) {
      const double next = std::min(next_after(side, y), last);
      // A valley or a crest in between, or the end.
      const bool falls = at(side, y).slope < 0, falls_after = at(side, next).slope < 0;
      double turn = next;
      if (falls != falls_after)
        turn = first_where(y, next, [&](double at_y) { return (at(side, at_y).slope < 0) == falls_after; });
      for (const double to : {turn, next}) {
        if (below && at(side, to).mu > level * (1 + alike)) {
          y_[side] = first_where(y, to, [&](double at_y) { return at(side, at_y).mu >= level; });
          return true;
        }
        below = below || at(side, to).mu < level;
        y = to;
      }
      if (!below && at(side, next).mu > level * (1 + alike)) return false_start(side, next, level);
    }
    y_[side] = std::max(last, y_[side]);
    arrived_ = true;
    return false;
  }

  // A side that rises at once from the level was mistaken for the weaker one by rounding.
  bool false_start(std::size_t side, double next, double level) {
    y_[side] = first_where(y_[side], next, [&](double y) { return at(side, y).mu > level; });
    return true;
  }

  // Slides both sides to the first crest of either and returns that side, or to the end of the
  // path.
  std::size_t slide_both() {
    const double crest[2] = {crest_after(0), crest_after(1)};
    const double height[2] = {at(0, crest[0]).mu, at(1, crest[1]).mu};
    const std::size_t first = height[1] < height[0] * (1 - alike) ? 1 : 0, other = 1 - first;
    // The point at which the other, rising side reaches the same height.
    const auto reached = [&](double height_there) {
      if (at(other, y_[other]).mu >= height_there) return y_[other];
      return first_where(y_[other], crest[other], [&](double y) { return at(other, y).mu >= height_there; });
    };
    const double end = reached(height[first]);
    if (crest[first] + end <= max_travel_) {
      y_[first] = crest[first];
      y_[other] = end;
      crest_[first] = true;
      return first;
    }
    const double y_end =
        first_where(y_[first], crest[first], [&](double y) { return y + reached(at(first, y).mu) >= max_travel_; });
    y_[first] = y_end;
    y_[other] = max_travel_ - y_end;
    arrived_ = true;
    return first;
  }

  // The point at which a rising side reaches its crest.
  double crest_after(std::size_t side) const {
    double y = y_[side];
    while (y < max_travel_) {
      const double next = std::min(next_after(side, y), max_travel_);
      if (!(at(side, next).slope > 0)) {
        return first_where(y, next, [&](double at_y) { return !(at(side, at_y).slope > 0); });
      }
      y = next;
    }
    return y;
  }

  Piece piece(const std::array<double, 2>& begin, Slides slides) const {
    const auto points = [&](const std::array<double, 2>& y) {
      return ContactPoints{from_[0] + direction_ * y[0], from_[1] + direction_ * y[1]};
    };
    ContactPoints low = points(begin), high = points(y_);
    if (direction_ < 0) std::swap(low, high);
    return {1 + low.left + low.right, 1 + high.left + high.right, low, high, slides};
  }

  const std::array<Friction, 2>& sides_;
  std::array<double, 2> from_;
  double direction_;
  double max_travel_;                        // [L] limit for both sides together
  std::array<double, 2> y_{0, 0};            // [L] travelled
  std::array<bool, 2> crest_{false, false};  // true on a crest, from which the side falls
  bool arrived_ = false;
};

TwoSupportPath::TwoSupportPath(Friction left, Friction right, ContactPoints from, double S_max)
    : TwoSupportPath({std::move(left), std::move(right)}, from, 1 + from.left + from.right, S_max) {}

TwoSupportPath::TwoSupportPath(std::array<Friction, 2> sides, ContactPoints from, double origin, double S_max)
    : sides_(std::move(sides)), origin_(origin) {
  for (const Friction& side : sides_)
    if (side.two_supports()) throw std::invalid_argument("the friction of a side is that of two supports");
  if (!(origin_ >= 1 && S_max >= origin_ && S_max < infinity))
    throw std::invalid_argument("a path from the length " + std::to_string(origin_) + " to " + std::to_string(S_max));
  pieces_ = Tracer(sides_, from, -1, origin_ - 1).run();
  std::reverse(pieces_.begin(), pieces_.end());
  if (!pieces_.empty()) pieces_.front().from = 1;
  const bool left_is_weaker = !(at_point(sides_[1], from.right).mu < at_point(sides_[0], from.left).mu);
  pieces_.push_back({origin_, origin_, from, from, left_is_weaker ? Slides::left : Slides::right});
  const auto inwards = Tracer(sides_, from, 1, S_max - origin_).run();
  pieces_.insert(pieces_.end(), inwards.begin(), inwards.end());
  pieces_.back().to = S_max;
  for (std::size_t i = 1; i < pieces_.size(); ++i) pieces_[i].from = pieces_[i - 1].to;
  for (const Piece& piece : pieces_) add_knots(piece);
  sort_and_merge(knots_);
}

// Adds the start of the piece, knots of the sliding sides, and the ends of limitation at zero.
void TwoSupportPath::add_knots(const Piece& piece) {
  knots_.push_back(piece.from);
  for (const bool of_left : {true, false}) {
    if (piece.slides == (of_left ? Slides::right : Slides::left)) continue;
    const Friction& side = sides_[of_left ? 0 : 1];
    const double begin = of_left ? piece.begin.left : piece.begin.right;
    const double end = of_left ? piece.end.left : piece.end.right;
    const auto add = [&](double x) {
      knots_.push_back(first_where(piece.from, piece.to, [&](double S) {
        const ContactPoints points = points_in(piece, S);
        return (of_left ? points.left : points.right) >= x;
      }));
    };
    const auto knots = side.knots();
    const auto last = std::lower_bound(knots.begin(), knots.end(), 1 + 2 * end);
    for (auto knot = std::upper_bound(knots.begin(), knots.end(), 1 + 2 * begin); knot < last; ++knot)
      add(0.5 * (*knot - 1));
    for (const double kink : kinks_between(side, 1 + 2 * begin, 1 + 2 * end)) add(0.5 * (kink - 1));
  }
}

const TwoSupportPath::Piece& TwoSupportPath::piece_at(double S) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), S,
                                      [](double length, const Piece& piece) { return length < piece.from; });
  return after == pieces_.begin() ? pieces_.front() : *(after - 1);
}

ContactPoints TwoSupportPath::points_in(const Piece& piece, double S) const {
  const double from_begin = std::clamp(S, piece.from, piece.to) - piece.from;
  const auto [left, right] = piece.begin;
  if (piece.slides == Slides::left) return {left + from_begin, right};
  if (piece.slides == Slides::right) return {left, right + from_begin};
  const double both = left + right + from_begin;
  const double low = std::max(left, both - piece.end.right), high = std::min(piece.end.left, both - right);
  if (!(low < high)) return {high, both - high};
  // f(left) - g(both - left) is monotone.
  const auto difference = [&](double x) {
    const auto a = at_point(sides_[0], x), b = at_point(sides_[1], both - x);
    return FrictionPoint{a.mu - b.mu, a.slope + b.slope};
  };
  const bool rises = at_point(sides_[0], piece.end.left).mu >= at_point(sides_[0], left).mu;
  constexpr double rounding = 2e-16;  // relative to half a span and to x
  const double x =
      zero_between(difference, rises ? low : high, rises ? high : low, 0.5 * (low + high), rounding, rounding);
  return {x, both - x};
}

ContactPoints TwoSupportPath::points_at(double S) const { return points_in(piece_at(S), S); }

FrictionPoint TwoSupportPath::at(double S) const {
  const Piece& piece = piece_at(S);
  const auto [left, right] = points_in(piece, S);
  const bool is_beyond = S < pieces_.front().from || S > pieces_.back().to;
  const auto met = [&](FrictionPoint point) { return FrictionPoint{point.mu, is_beyond ? 0 : point.slope}; };
  if (piece.slides == Slides::left) return met(at_point(sides_[0], left));
  if (piece.slides == Slides::right) return met(at_point(sides_[1], right));
  const auto a = at_point(sides_[0], left), b = at_point(sides_[1], right);
  const double sum = a.slope + b.slope;
  return met({0.5 * (a.mu + b.mu), sum != 0 ? a.slope * b.slope / sum : 0});
}

double TwoSupportPath::smooth_scale() const {
  return 0.5 * std::min(sides_[0].smooth_scale(), sides_[1].smooth_scale());
}

double TwoSupportPath::max_up_to(double S_max) const {
  const double one_side = 1 + 2 * (S_max - 1);
  return std::max(sides_[0].max_up_to(one_side), sides_[1].max_up_to(one_side));
}

}  // namespace flexslip
