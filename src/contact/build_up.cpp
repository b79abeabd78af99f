#include "contact/build_up.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/quadrature.h"

namespace flexslip {
namespace {

// Friction that has followed another one, sliding on and on: p, dp/dS and d²p/dS² at nodes.
class Trail final : public PathDependentFriction {
 public:
  Trail(Friction followed, double direction, double length, double S_most) : followed_(std::move(followed)) {
    constexpr double min_nodes = 1e6;
    constexpr double nodes_per_length = 16, nodes_per_scale = 25;
    const double step = std::min(length / nodes_per_length, followed_.smooth_scale() / nodes_per_scale);
    if (!((S_most - 1) / step < min_nodes))
      throw std::invalid_argument(
          "friction builds up over too short a length, or is too fine, beside how far it is slid");
    const auto among = followed_.knots();
    std::vector<double> ends{1};
    std::copy_if(among.begin(), among.end(), std::back_inserter(ends), [&](double S) { return S > 1 && S < S_most; });
    ends.push_back(S_most);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double from = ends[i - 1], to = ends[i];
      const int parts = static_cast<int>(std::ceil((to - from) / std::min(step, 0.5 * (to - from))));
      for (int j = 0; j < parts; ++j) S_.push_back(from + (to - from) * j / parts);
    }
    S_.push_back(S_most);
    follow(direction, length);
  }

  FrictionPoint at(double S) const override {
    if (S <= S_.front()) return {nodes_.front().value, 0};
    if (S >= S_.back()) return {nodes_.back().value, 0};
    const auto i = static_cast<std::size_t>(std::upper_bound(S_.begin(), S_.end(), S) - S_.begin()) - 1;
    const Node &a = nodes_[i], &b = nodes_[i + 1];
    const double h = S_[i + 1] - S_[i], t = (S - S_[i]) / h;
    // Hermite's quintic, from the left node on: what its parabola leaves of value, slope and bend at the right one.
    const double c1 = h * a.slope, c2 = 0.5 * h * h * a.bend;
    const double value = b.value - (a.value + c1 + c2);
    const double slope = h * b.slope - (c1 + 2 * c2);
    const double bend = h * h * b.bend - 2 * c2;
    const double c3 = 10 * value - 4 * slope + 0.5 * bend;
    const double c4 = -15 * value + 7 * slope - bend;
    const double c5 = 6 * value - 3 * slope + 0.5 * bend;
    return {a.value + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * c5)))),
            (c1 + t * (2 * c2 + t * (3 * c3 + t * (4 * c4 + t * 5 * c5)))) / h};
  }
  double smooth_scale() const override { return followed_.smooth_scale(); }
  double max_up_to(double S_max) const override { return followed_.max_up_to(S_max); }
  std::span<const double> knots() const override { return followed_.knots(); }

 private:
  struct Node {
    double value, slope, bend;
  };

  void follow(double direction, double length) {
    nodes_.resize(S_.size());
    const bool inwards = direction > 0;
    const std::size_t last = S_.size() - 1;
    double p = followed_.at(inwards ? 1.0 : S_.back()).mu;
    for (std::size_t n = 0; n <= last; ++n) {
      const std::size_t i = inwards ? n : last - n;
      if (n > 0) p = after(p, S_[inwards ? i - 1 : i + 1], S_[i], length);
      const auto [mu, mu_slope] = followed_.at(S_[i]);
      const double rate = direction / length, slope = rate * (mu - p);
      nodes_[i] = {p, slope, rate * (mu_slope - slope)};
    }
  }

  // p' = (μ - p)/σ from one node to the next, by Gauss' three points.
  double after(double p, double from, double to, double length) const {
    const double h = std::abs(to - from) / length;
    const double gained = integral(gauss_3, 0, 1, [&](double t) {
      return followed_.at(from + t * (to - from)).mu * elementary::exp(-(1 - t) * h);
    });
    return p * elementary::exp(-h) + h * gained;
  }

  Friction followed_;
  std::vector<double> S_;
  std::vector<Node> nodes_;
};

// Up to a length, no drift carries it to zero.
bool stays_above_zero(const Friction& friction, const FrictionWaves& waves, double S_most) {
  if (!friction.may_be_held()) return true;
  double least = waves.mu0;
  for (const Sinusoid& term : waves.terms) least -= waves.mu0 * term.amplitude;
  return std::min(least + waves.drift * (1 - waves.S_reference), least + waves.drift * (S_most - waves.S_reference)) >=
         0;
}

Friction trailing(const Friction& friction, double direction, double length, double S_most) {
  const auto* waves = std::get_if<FrictionWaves>(&friction.form());
  if (!waves || !stays_above_zero(friction, *waves, S_most))
    return Friction::path_dependent(std::make_shared<const Trail>(friction, direction, length, S_most));
  FrictionWaves smoothed = *waves;
  smoothed.S_reference += direction * length;
  for (Sinusoid& term : smoothed.terms) {
    term.amplitude *= share_after_build_up(length, term.wavelength);
    term.phase -= direction * elementary::angle(std::numbers::pi * length / term.wavelength, 1);
  }
  return Friction::waves(std::move(smoothed));
}

}  // namespace

double share_after_build_up(double length, double wavelength) {
  return 1 / elementary::length(1, std::numbers::pi * length / wavelength);
}

BuildUp::BuildUp(Friction specimen, double length, double S_most)
    : trails_([&] {
        if (!(length > 0 && std::isfinite(length)))
          throw std::invalid_argument("the length over which friction builds up must be finite and > 0");
        if (!(S_most > 1)) throw std::invalid_argument("a fibre that slides gets beyond its span");
        if (specimen.depends_on_way() || specimen.is_met())
          throw std::invalid_argument("friction builds up on edges that are alike");
        Friction in = trailing(specimen, 1, length, S_most), out = trailing(specimen, -1, length, S_most);
        return std::make_shared<const Trails>(Trails{std::move(specimen), std::move(in), std::move(out), length});
      }()),
      S_(1),
      p_(trails_->specimen.at(1).mu),
      direction_(1),
      lag_(p_ - trail().at(S_).mu) {
  add_knots();
}

BuildUp::BuildUp(const std::shared_ptr<const Trails>& trails, double S, double p, double direction)
    : trails_(trails), S_(S), p_(p), direction_(direction), lag_(p - trail().at(S).mu) {
  add_knots();
}

void BuildUp::add_knots() {
  // In these multiples of its length the lag dies away, smoothly between them.
  for (const double lengths :
       {0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 26.0, 34.0}) {
    const double knot = S_ + direction_ * lengths * trails_->length;
    if (knot >= 1) knots_.push_back(knot);
  }
  const auto among = trail().knots();
  knots_.insert(knots_.end(), among.begin(), among.end());
  std::sort(knots_.begin(), knots_.end());
  knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());
}

FrictionPoint BuildUp::at(double S) const {
  const double way = direction_ * (S - S_);
  if (way < 0) return {p_, 0};
  const auto [mu, slope] = trail().at(S);
  const double left = lag_ * elementary::exp(-way / trails_->length);
  return {mu + left, slope - direction_ * left / trails_->length};
}

double BuildUp::max_up_to(double S_max) const { return std::max(std::abs(p_), trails_->specimen.max_up_to(S_max)); }

std::shared_ptr<const PathDependentFriction> BuildUp::from(double S, double q, double direction) const {
  return std::shared_ptr<const BuildUp>(new BuildUp(trails_, S, direction * q, direction));
}

}  // namespace flexslip
