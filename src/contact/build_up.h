// Friction that builds up: Dahl's law. A fibre that turns back does not stick until friction is exhausted; it creeps, and what is mobilised nears
// the friction of the contact over a length of sliding,
//
//     dp/ds = (μ - p)/σ    with s the way slid since it turned, p = q on the way in and -q on the way out.
//
// So q follows from S alone on a way, as of a profile; on long ways a wave of μ is smoothed to 1/√(1 + (πσ/λ)²) of its height, and lags behind
// (theory.md, "Friction that builds up").
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/friction.h"

namespace flexslip {

// What is left of the height of a wave of a length along the fibre. Domain: length [L] >= 0, wavelength [L] > 0.
double share_after_build_up(double length, double wavelength);

// The way on from where a fibre turned.
class BuildUp final : public PathDependentFriction {
 public:
  // The first way in of a fibre on which friction is mobilised from the beginning, to a length S_most, towards the friction of the points of the
  // specimen.
  // Domain:     length > 0 [L]; a friction of the points of a specimen on edges; std::invalid_argument otherwise, and where a table, or friction
  //             that is held at zero, would need more than a million nodes: σ above 16 millionths of S_most - 1.
  BuildUp(Friction specimen, double length, double S_most);

  // p and dp/dS; what it was where it turned, on lengths that lie behind.
  // Max error:  of waves that no drift carries to zero, as theirs; else 1e-6 of μ is tested (tests/contact/build_up_test.cpp).
  FrictionPoint at(double S) const override;

  double smooth_scale() const override { return trail().smooth_scale(); }
  double max_up_to(double S_max) const override;
  std::span<const double> knots() const override { return knots_; }

  bool continues(double S, double direction) const override {
    return direction == direction_ && direction * (S - S_) >= 0;
  }
  std::shared_ptr<const PathDependentFriction> from(double S, double q, double direction) const override;
  bool depends_on_way() const override { return true; }
  bool lets_stick() const override { return false; }

 private:
  // What is met that has slid on and on.
  struct Trails {
    Friction specimen, in, out;
    double length;
  };
  BuildUp(const std::shared_ptr<const Trails>& trails, double S, double p, double direction);
  void add_knots();
  const Friction& trail() const { return direction_ > 0 ? trails_->in : trails_->out; }

  std::shared_ptr<const Trails> trails_;
  double S_, p_, direction_;  // where it turned, and which way it goes
  double lag_;                // p less what a fibre shows there that has slid on and on
  std::vector<double> knots_;
};

}  // namespace flexslip
