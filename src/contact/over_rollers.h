// Friction of a specimen that slides over rollers: evaluated at the contact point, which differs
// from the sliding length; on sloping surfaces; and limited by rollers that turn.
//
// The axis between the contacts is shorter than the sliding length by the part that lies on the
// rollers. This part depends on friction through the slope of the specimen. The friction at a
// sliding length Σ therefore solves q = μ(S(Σ, q)) and differs between sliding in and out
// (theory.md, "Rollers and thickness").
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

class OverRollers final : public PathDependentFriction {
 public:
  // Friction for sliding in (direction = 1) or out (-1), with its knots up to S_max.
  // Domain:     friction at points of the specimen, on rollers; std::invalid_argument otherwise.
  OverRollers(Friction along, Fibre fibre, double direction, double S_max);

  // Domain:     a sliding length S = Σ >= 1.
  // Max error:  1e-12 of the friction, plus the error of the tables of fibre.h. Constant without a
  //             state.
  FrictionPoint at(double S) const override;
  FrictionArrays at(std::span<const double> S) const override;
  double smooth_scale() const override { return along_.smooth_scale(); }
  double end_of(double S, double scales, bool inwards) const override;
  double max_up_to(double S_max) const override { return max_at_contacts(S_max); }
  std::span<const double> knots() const override { return knots_; }
  bool is_met() const override { return true; }

 private:
  void add_knots(double S_max);
  double max_at_contacts(double S_max) const;

  Friction along_;
  Fibre fibre_;
  double direction_;
  std::vector<double> knots_;  // [L] Σ, rising
};

// [1/L] The largest slope |dμ/dS| for which the friction of a sliding length is unique, up to
// S_max and a friction of max_mu. The contact point moves with friction; for steeper profiles
// several frictions match one length. Infinite on knife edges without a thickness.
// Method:     sampled at 48 lengths and, before the surface slides in, at 6 deflections, of which
//             the last decides.
double steepest_followed(const Fibre& fibre, double max_mu, double S_max);

// The friction along the specimen as a function of the sliding length; unchanged on knife edges.
Friction met(const Friction& along, const Fibre& fibre, double direction, double S_max);

// The same without computing the positions of knots. Empty on knife edges.
std::optional<Friction> met_without_knots(const Friction& along, const Fibre& fibre, double direction);

// Friction on a sloping surface, which differs between sliding in and out.
//
// On a slope tan α it is tan(atan μ + α) for sliding in and tan(atan μ - α) for sliding out
// (theory.md, "A surface and its friction").

class OnSlopes final : public PathDependentFriction {
 public:
  // Starts with sliding in.
  // Domain:     path-independent profiles; std::invalid_argument otherwise.
  OnSlopes(Friction in, Friction out);

  using PathDependentFriction::at;
  FrictionPoint at(double S) const override { return way().at(S); }
  double smooth_scale() const override { return way().smooth_scale(); }
  double max_up_to(double S_max) const override { return way().max_up_to(S_max); }
  std::span<const double> knots() const override { return way().knots(); }
  bool continues(double /*S*/, double direction) const override { return direction == direction_; }
  std::shared_ptr<const PathDependentFriction> from(double S, double q, double direction) const override;
  bool is_path_dependent() const override { return true; }

 private:
  struct Ways {
    Friction in, out;
  };
  OnSlopes(std::shared_ptr<const Ways> ways, double direction) : ways_(std::move(ways)), direction_(direction) {}
  const Friction& way() const { return direction_ > 0 ? ways_->in : ways_->out; }

  std::shared_ptr<const Ways> ways_;
  double direction_;
};

// Friction with an upper limit. A roller on a pin turns once the friction torque of the specimen
// exceeds the torque of the pin.

// The smaller of the specimen's friction and a cap, at lengths up to S_max.
// Domain:     the friction of one support at points of the specimen; cap >= 0;
//             std::invalid_argument otherwise.
// Tolerance:  crossings of the cap are bisected to rounding, between samples at a sixteenth of the
//             shortest period.
Friction capped(const Friction& friction, double cap, double S_max);

// [1] The friction at which a roller turns on its pin: m/√(1 - m²), with m = pin_friction
// pin_radius/radius.
// Domain:     m < 1.
double friction_of_pins(double pin_friction, double pin_radius, double radius);

}  // namespace flexslip
