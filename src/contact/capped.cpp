#include "contact/capped.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

namespace flexslip {
namespace {

class Capped final : public FrictionOnAWay {
 public:
  Capped(Friction friction, double cap, double S_most) : friction_(std::move(friction)), cap_(cap) {
    if (friction_.depends_on_way() || friction_.is_met() || !(cap >= 0))
      throw std::invalid_argument("only friction of the points of a specimen can be capped, at 0 or more");
    const auto own = friction_.knots();
    constexpr double least = 0.3;  // that may lie between rollers
    std::vector<double> ends{least};
    std::copy_if(own.begin(), own.end(), std::back_inserter(ends), [&](double S) { return S > least && S < S_most; });
    ends.push_back(S_most);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      knots_.push_back(ends[i - 1]);
      add_crossings(ends[i - 1], ends[i]);
    }
    knots_.push_back(S_most);
  }

  FrictionPoint at(double S) const override {
    const FrictionPoint own = friction_.at(S);
    return own.mu <= cap_ ? own : FrictionPoint{cap_, 0};
  }
  double smooth_scale() const override { return friction_.smooth_scale(); }
  double most_up_to(double S_max) const override { return std::min(friction_.most_up_to(S_max), cap_); }
  std::span<const double> knots() const override { return knots_; }

 private:
  bool is_capped(double S) const { return friction_.at(S).mu > cap_; }

  void add_crossings(double from, double to) {
    constexpr double samples_a_scale = 4, least_samples = 8;
    const double samples = std::max(least_samples, std::ceil(samples_a_scale * (to - from) / friction_.smooth_scale()));
    double low = from;
    for (double i = 1; i <= samples; ++i) {
      const double high = i < samples ? from + (to - from) * i / samples : to;
      if (is_capped(low) != is_capped(high)) {
        double a = low, b = high;
        for (double middle = 0.5 * (a + b); a < middle && middle < b; middle = 0.5 * (a + b))
          (is_capped(middle) == is_capped(low) ? a : b) = middle;
        knots_.push_back(b);
      }
      low = high;
    }
  }

  Friction friction_;
  double cap_;
  std::vector<double> knots_;
};

}  // namespace

Friction capped(const Friction& friction, double cap, double S_most) {
  return Friction::on_a_way(std::make_shared<const Capped>(friction, cap, S_most));
}

double friction_of_pins(double pin_friction, double pin_radius, double radius) {
  const double m = pin_friction * pin_radius / radius;
  if (!(m >= 0 && m < 1)) throw std::invalid_argument("pins that hold their rollers fast turn with no friction");
  return m / std::sqrt(1 - m * m);
}

}  // namespace flexslip
