#include "contact/over_rollers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// An upper bound of the growth of θ0 with √(Σ - Σ0): 3 w at small deflection, less beyond.
constexpr double slope_by_way = 1.94;

}  // namespace

OverRollers::OverRollers(Friction along, Fibre fibre, double direction, double S_max)
    : along_(std::move(along)), fibre_(std::move(fibre)), direction_(direction) {
  if (along_.two_supports()) throw std::invalid_argument("two supports that are not alike are edges, not rollers");
  if (S_max > 1 && !along_.knots().empty()) add_knots(S_max);
}

// The length between the contacts may be below the span, where a drift may raise friction.
double OverRollers::max_at_contacts(double S_max) const {
  const double least = 1 - std::numbers::pi * fibre_.supports().radius;
  return along_.max_up_to(S_max) + std::max(along_.drift() < 0 ? along_.drift() * (least - 1) : 0.0, 0.0);
}

FrictionPoint OverRollers::at(double S) const {
  const double max_mu = max_at_contacts(S + 1);
  FrictionPoint met{std::clamp(along_.at(S).mu, 0.0, max_mu), 0};
  const auto miss_at = [&](double mu) {
    const auto [length, length_S, length_q] = fibre_.contact(S, direction_ * mu);
    if (!std::isfinite(length_S)) return ValueAndSlope{0, 1};  // no state: keep the last friction
    const FrictionPoint there = along_.at(length);
    const double slope_in_mu = 1 - direction_ * there.slope * length_q;
    met = {mu, there.slope * length_S / slope_in_mu};
    return ValueAndSlope{mu - there.mu, slope_in_mu};
  };
  constexpr double small = 1e-13;
  zero_between(miss_at, 0, max_mu, met.mu, small, small);
  return met;
}

// Newton's method for all lengths at once; those that do not converge, as at a kink, individually.
FrictionArrays OverRollers::at(std::span<const double> S) const {
  constexpr double small = 1e-13;
  FrictionArrays met = along_.at(S);
  std::vector<double> max_mu;
  for (std::size_t i = 0; i < S.size(); ++i) {
    max_mu.push_back(max_at_contacts(S[i] + 1));
    met.mu[i] = std::clamp(met.mu[i], 0.0, max_mu[i]);
  }
  std::vector<std::size_t> sought(S.size());
  std::iota(sought.begin(), sought.end(), 0);
  std::vector<std::size_t> alone;
  constexpr int rounds = 6;
  for (int round = 0; round < rounds && !sought.empty(); ++round) {
    std::vector<double> lengths, q;
    for (const std::size_t i : sought) {
      lengths.push_back(S[i]);
      q.push_back(direction_ * met.mu[i]);
    }
    Fibre::ContactArrays contacts = fibre_.contacts({lengths, q});
    for (std::size_t j = 0; j < sought.size(); ++j)
      // no state: the NaN slopes pass it to at(S)
      if (!std::isfinite(contacts.length_S[j])) contacts.length[j] = 1;
    const FrictionArrays there = along_.at(contacts.length);
    std::size_t left = 0;
    for (std::size_t j = 0; j < sought.size(); ++j) {
      const std::size_t i = sought[j];
      const double slope_in_mu = 1 - direction_ * there.slope[j] * contacts.length_q[j];
      met.slope[i] = there.slope[j] * contacts.length_S[j] / slope_in_mu;
      const double next = met.mu[i] - (met.mu[i] - there.mu[j]) / slope_in_mu;
      if (std::isfinite(next) && std::abs(next - met.mu[i]) <= small * (1 + met.mu[i])) continue;
      if (next >= 0 && next <= max_mu[i]) {
        met.mu[i] = next;
        sought[left++] = i;
      } else {
        alone.push_back(i);
      }
    }
    sought.resize(left);
  }
  alone.insert(alone.end(), sought.begin(), sought.end());
  for (const std::size_t i : alone) {
    const auto [mu, slope] = at(S[i]);
    met.mu[i] = mu;
    met.slope[i] = slope;
  }
  return met;
}

// At most this many smooth scales of the length between the contacts: y² = Σ - Σ0 and S - Σ = -2 r
// θ0.
double OverRollers::end_of(double S, double scales, bool inwards) const {
  const double scale = scales * along_.smooth_scale();
  const double a = slope_by_way * fibre_.supports().radius, y = fibre_.sliding_coordinate(S);
  const double square = (y + a) * (y + a) + (inwards ? scale : -scale);
  const double end = std::sqrt(std::max(square, a * a)) - a;
  return std::isinf(scale) ? (inwards ? scale : 1.0) : std::max(fibre_.length_at(end), 1.0);
}

// Adds the sliding lengths at which knots touch: before and after the contacts turn inwards.
void OverRollers::add_knots(double S_max) {
  const auto knots = along_.knots();
  const double rolled = 2 * fibre_.supports().radius;
  struct Place {
    double length, slope, S;
  };
  const auto place = [&](double w, double mu) {
    const Fibre::DeflectionState at = fibre_.at_deflection(w, direction_ * mu);
    return Place{fibre_.length_between_contacts(at.state), at.S_w - rolled * at.theta0_w, at.state.S};
  };
  // The deflection at which the length between the contacts is smallest.
  const double turns = 1.25 * (fibre_.supports().radius + fibre_.supports().half_depth);
  for (const double side : {-1.0, 1.0}) {
    double begin = turns;
    for (const double knot : knots) {
      const double mu = along_.at(knot).mu;
      const double low = begin;
      double high = begin;
      double reach = 0.01;
      while (place(high, mu).length < knot && high > 0 && high < 1) {
        high = std::clamp(high + side * reach, 0.0, 1.0);
        reach *= 1.5;
      }
      if (!(place(low, mu).length < knot) || !(place(high, mu).length >= knot)) continue;
      const auto beyond_knot = [&](double w) {
        const Place at = place(w, mu);
        return ValueAndSlope{at.length - knot, at.slope};
      };
      constexpr double close = 1e-14;
      const double w = zero_between(beyond_knot, low, high, 0.5 * (low + high), close);
      const double S = place(w, mu).S;
      if (S > S_max) break;
      if (S > 1) knots_.push_back(S);
      begin = w;
    }
  }
  std::sort(knots_.begin(), knots_.end());
  knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());
}

double steepest_followed(const Fibre& fibre, double max_mu, double S_max) {
  if (fibre.on_edges()) return infinity;
  const double rolled = 2 * fibre.supports().radius;
  const double first = fibre.sliding_coordinate(1), last = fibre.sliding_coordinate(std::max(S_max, 1.0)),
               shallow = 3 * fibre.supports().half_depth;
  double moved = 0;
  // Samples a path at equal intervals.
  const auto sample = [&](int samples, const auto& place_at, const auto& by_friction) {
    std::vector<double> places, q;
    for (int i = 1; i <= samples; ++i)
      for (const double friction : {-max_mu, 0.0, max_mu}) {
        places.push_back(place_at(static_cast<double>(i) / samples));
        q.push_back(friction);
      }
    for (const double each : by_friction(places, q))
      if (std::isfinite(each)) moved = std::max(moved, std::abs(each));
  };
  if (rolled > 0)
    sample(
        48, [&](double part) { return fibre.length_at(first + part * (last - first)); },
        [&](const auto& S, const auto& q) {
          return fibre.contacts({S, q}).length_q;
        });
  if (!fibre.slides_inward_only())
    sample(
        6, [&](double part) { return part * shallow; },
        [&](const auto& w, const auto& q) { return fibre.length_friction_derivatives(w, q); });
  return 1 / moved;
}

Friction met(const Friction& along, const Fibre& fibre, double direction, double S_max) {
  if (fibre.supports().radius == 0 || along.is_met()) return along;
  return Friction::path_dependent(std::make_shared<const OverRollers>(along, fibre, direction, S_max));
}

std::optional<Friction> met_without_knots(const Friction& along, const Fibre& fibre, double direction) {
  if (fibre.supports().radius == 0 || along.is_met()) return std::nullopt;
  return met(along, fibre, direction, 1);
}

OnSlopes::OnSlopes(Friction in, Friction out) : direction_(1) {
  if (in.is_path_dependent() || out.is_path_dependent())
    throw std::invalid_argument("the friction of a slope has two ways by itself");
  ways_ = std::make_shared<const Ways>(Ways{std::move(in), std::move(out)});
}

std::shared_ptr<const PathDependentFriction> OnSlopes::from(double /*S*/, double /*q*/, double direction) const {
  return std::shared_ptr<const OnSlopes>(new OnSlopes(ways_, direction));
}

namespace {

class Capped final : public PathDependentFriction {
 public:
  Capped(Friction friction, double cap, double S_max) : friction_(std::move(friction)), cap_(cap) {
    if (friction_.is_path_dependent() || friction_.is_met() || !(cap >= 0))
      throw std::invalid_argument("only friction of the points of a specimen can be capped, at 0 or more");
    const auto own = friction_.knots();
    constexpr double least = 0.3;  // shortest length between rollers
    std::vector<double> ends{least};
    std::copy_if(own.begin(), own.end(), std::back_inserter(ends), [&](double S) { return S > least && S < S_max; });
    ends.push_back(S_max);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      knots_.push_back(ends[i - 1]);
      add_crossings(ends[i - 1], ends[i]);
    }
    knots_.push_back(S_max);
  }

  FrictionPoint at(double S) const override {
    const FrictionPoint own = friction_.at(S);
    return own.mu <= cap_ ? own : FrictionPoint{cap_, 0};
  }
  double smooth_scale() const override { return friction_.smooth_scale(); }
  double max_up_to(double S_max) const override { return std::min(friction_.max_up_to(S_max), cap_); }
  std::span<const double> knots() const override { return knots_; }
  std::shared_ptr<const PathDependentFriction> scaled(double factor) const override {
    return std::make_shared<const Capped>(friction_.scaled(factor), cap_, knots_.back());
  }

 private:
  bool is_capped(double S) const { return friction_.at(S).mu > cap_; }

  void add_crossings(double from, double to) {
    constexpr double samples_a_scale = 4, min_samples = 8;
    const double samples = std::max(min_samples, std::ceil(samples_a_scale * (to - from) / friction_.smooth_scale()));
    double low = from;
    for (double i = 1; i <= samples; ++i) {
      const double high = i < samples ? from + (to - from) * i / samples : to;
      const bool at_first = is_capped(low);
      if (is_capped(high) != at_first)
        knots_.push_back(first_where(low, high, [&](double S) { return is_capped(S) != at_first; }));
      low = high;
    }
  }

  Friction friction_;
  double cap_;
  std::vector<double> knots_;
};

}  // namespace

Friction capped(const Friction& friction, double cap, double S_max) {
  return Friction::path_dependent(std::make_shared<const Capped>(friction, cap, S_max));
}

double friction_of_pins(double pin_friction, double pin_radius, double radius) {
  const double m = pin_friction * pin_radius / radius;
  if (!(m >= 0 && m < 1)) throw std::invalid_argument("pins that hold their rollers fast turn with no friction");
  return m / std::sqrt(1 - m * m);
}

}  // namespace flexslip
