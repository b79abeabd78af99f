// Friction as a fibre meets it that slides over rollers: of the point that touches, which is not the length that has slid; on slopes;
// and capped by what else gives way.
//
// The axis between the contacts is shorter than what has been drawn in by what lies on the rollers, and that depends on friction through the
// slope of the fibre. So friction met at a length is the solution of q = μ(S(Σ, q)), another one drawn in than let out (theory.md, "Rollers and
// thickness").
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
  // Drawn in, direction = 1, or let out, -1; with the knots met up to S_most.
  // Domain: a friction of the specimen's points, on rollers (std::invalid_argument otherwise).
  OverRollers(Friction along, Fibre fibre, double direction, double S_most);

  // Of a length Σ >= 1. Max error: 1e-12 of the friction, and as the tables of fibre.h. Constant where the fibre has no state.
  FrictionPoint at(double S) const override;
  FrictionArrays at(std::span<const double> S) const override;
  double smooth_scale() const override { return along_.smooth_scale(); }
  double end_of(double S, double scales, bool inwards) const override;
  double max_up_to(double S_max) const override { return max_at_contacts(S_max); }
  std::span<const double> knots() const override { return knots_; }
  bool is_met() const override { return true; }

 private:
  void add_knots(double S_most);
  double max_at_contacts(double S_max) const;

  Friction along_;
  Fibre fibre_;
  double direction_;
  std::vector<double> knots_;  // [L] Σ rising
};

// [1/L] How steep friction may be along the specimen, |dμ/dS|, for its fibre to be drawn in by up to S_most under friction of up to `most`: the
// point that touches moves with friction, and where friction changes faster than that, several frictions agree with one length. Infinite on
// edges of a specimen without thickness.
// Method:     sampled, at 48 lengths and, before the surface slides in, at 6 deflections, of which it is the last that counts.
double steepest_followed(const Fibre& fibre, double most, double S_most);

// The friction of the specimen as its fibre meets it: on edges that of its points.
Friction met(const Friction& along, const Fibre& fibre, double direction, double S_most);

// Likewise, none on edges, without the work of finding where its knots touch.
std::optional<Friction> met_without_knots(const Friction& along, const Fibre& fibre, double direction);

// Friction of a surface that a support climbs on one way and comes down on the other: on slopes the friction of both ways differs.
//
// On a slope tan α it is tan(atan μ + α) on the way in and tan(atan μ - α) on the way out (theory.md, "A surface and its friction").

class OnSlopes final : public PathDependentFriction {
 public:
  // Begins on the way in.
  // Domain:     profiles that depend on no way; std::invalid_argument otherwise.
  OnSlopes(Friction in, Friction out);

  using PathDependentFriction::at;
  FrictionPoint at(double S) const override { return way().at(S); }
  double smooth_scale() const override { return way().smooth_scale(); }
  double max_up_to(double S_max) const override { return way().max_up_to(S_max); }
  std::span<const double> knots() const override { return way().knots(); }
  bool continues(double /*S*/, double direction) const override { return direction == direction_; }
  std::shared_ptr<const PathDependentFriction> from(double S, double q, double direction) const override;
  bool depends_on_way() const override { return true; }

 private:
  struct Ways {
    Friction in, out;
  };
  OnSlopes(std::shared_ptr<const Ways> ways, double direction) : ways_(std::move(ways)), direction_(direction) {}
  const Friction& way() const { return direction_ > 0 ? ways_->in : ways_->out; }

  std::shared_ptr<const Ways> ways_;
  double direction_;
};

// Friction that gets no farther than to where something else gives way: at rollers on pins the pins, once the torque of the specimen turns them.

// The lesser of the friction of the specimen and a cap, at lengths up to S_most.
// Domain:     a friction of one support, along its points; cap >= 0; std::invalid_argument otherwise.
// Tolerance:  lengths at which the cap is crossed are bisected to rounding, between samples at a sixteenth of the shortest period.
Friction capped(const Friction& friction, double cap, double S_most);

// [1] Friction of rollers on pins, which turn at a torque of pin_friction on the radius of the pin: m/√(1 - m²), m = pin_friction pin_radius/radius.
// Domain:     m < 1.
double friction_of_pins(double pin_friction, double pin_radius, double radius);

}  // namespace flexslip
