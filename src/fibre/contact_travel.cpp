#include "fibre/contact_travel.h"

#include <algorithm>
#include <cstddef>

namespace flexslip {

ContactTravel::ContactTravel(const Fibre& fibre, double q, double S_least, double S_most) : fibre_(fibre) {
  if (fibre.supports().radius == 0) return;
  constexpr int pieces = 128;
  first_ = fibre.way(S_least);
  step_ = (fibre.way(S_most) - first_) / pieces;
  for (int i = 0; i <= pieces; ++i) {
    const double sigma = first_ + step_ * i;
    const auto [length, length_S, length_q] = fibre.contact(fibre.length_at(sigma), q);
    if (!std::isfinite(length_S)) break;
    knots_.push_back({length, 2 * sigma * length_S});
    last_ = sigma;
  }
  if (knots_.size() < 2) knots_.clear();  // no states to follow the contacts along
  const auto grows = std::find_if(knots_.begin(), knots_.end(), [](const Value& knot) { return knot.slope > 0; });
  if (grows == knots_.begin()) return;
  double high = std::min(first_ + step_ * static_cast<double>(grows - knots_.begin()), last_), low = high - step_;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (value(middle).slope > 0 ? high : low) = middle;
  }
  turn_at_ = high;
  turn_ = value(high).length;
}

// A cubic between two knots.
ContactTravel::Value ContactTravel::value(double sigma) const {
  const double place = std::clamp((sigma - first_) / step_, 0.0, static_cast<double>(knots_.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(place), knots_.size() - 2);
  const double t = place - static_cast<double>(i), u = 1 - t;
  const Value &a = knots_[i], &b = knots_[i + 1];
  const double rise = b.length - a.length, a_slope = step_ * a.slope, b_slope = step_ * b.slope;
  const double length = a.length + t * t * (3 - 2 * t) * rise + t * u * (u * a_slope - t * b_slope);
  const double slope = (6 * t * u * rise + u * (1 - 3 * t) * a_slope + t * (3 * t - 2) * b_slope) / step_;
  const double beyond = sigma - std::clamp(sigma, first_, last_);
  return {length + slope * beyond, slope};
}

double ContactTravel::at(double S) const {
  if (knots_.empty()) return S;
  const double sigma = fibre_.way(S), length = value(sigma).length;
  return sigma < turn_at_ ? 2 * turn_ - length : length;
}

double ContactTravel::slope(double S) const {
  if (knots_.empty()) return 1;
  const double sigma = fibre_.way(S);
  return std::abs(value(sigma).slope) / (2 * sigma);
}

double ContactTravel::drawn_in_at(double travel) const {
  if (knots_.empty()) return travel;
  const bool rolls_back = travel < turn_;
  const double length = length_at(travel);
  for (const double end : {first_, last_}) {
    const Value there = value(end);
    const double beyond = (length - there.length) / there.slope;
    if ((end < turn_at_) == rolls_back && (end == first_ ? beyond <= 0 : beyond >= 0))
      return fibre_.length_at(std::max(end + beyond, 0.0));
  }
  double low = rolls_back ? first_ : std::max(turn_at_, first_), high = rolls_back ? turn_at_ : last_;
  double sigma = 0.5 * (low + high);
  for (int i = 0; i < 60 && low < high; ++i) {
    const Value here = value(sigma);
    const bool is_before = (here.length < length) != rolls_back;
    (is_before ? low : high) = sigma;
    const double newton = sigma - (here.length - length) / here.slope;
    constexpr double small = 1e-13;
    if (std::abs(newton - sigma) <= small) break;
    sigma = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return fibre_.length_at(sigma);
}

}  // namespace flexslip
