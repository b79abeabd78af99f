// Friction as a fibre meets it that slides over rollers: of the point that touches, which is not the length that has slid.
//
// The axis between the contacts is shorter than what has been drawn in by what lies on the rollers, and that depends on friction through the
// slope of the fibre. So friction met at a length is the solution of q = μ(S(Σ, q)), another one drawn in than let out (theory.md, "Rollers and
// thickness").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

class OverRollers final : public FrictionOnAWay {
 public:
  // Drawn in, direction = 1, or let out, -1; with the knots met up to S_most.
  // Domain: a friction of the specimen's points, on rollers (std::invalid_argument otherwise).
  OverRollers(Friction along, Fibre fibre, double direction, double S_most);

  // Of a length Σ >= 1. Max error: 1e-12 of the friction, and as the tables of fibre.h. Constant where the fibre has no state.
  FrictionPoint at(double S) const override;
  double smooth_scale() const override { return along_.smooth_scale(); }
  double end_of(double S, double scales, bool inwards) const override;
  double most_up_to(double S_max) const override { return most_at_contacts(S_max); }
  std::span<const double> knots() const override { return knots_; }
  bool is_met() const override { return true; }

 private:
  void add_knots(double S_most);
  double most_at_contacts(double S_max) const;

  Friction along_;
  Fibre fibre_;
  double direction_;
  std::vector<double> knots_;  // [L] Σ rising
};

// [1/L] How steep friction may be along the specimen, |dμ/dS|, for its fibre to be drawn in by up to S_most under friction of up to `most`: the
// point that touches moves with friction, and where friction changes faster than that, several frictions agree with one length. Infinite on
// edges of a specimen without thickness.
// Method:     sampled, at 48 lengths and, before the surface slides in, deflections.
double steepest_followed(const Fibre& fibre, double most, double S_most);

// The friction of the specimen as its fibre meets it: on edges that of its points.
Friction met(const Friction& along, const Fibre& fibre, double direction, double S_most);

// Likewise, none on edges, without the work of finding where its knots touch.
std::optional<Friction> met_without_knots(const Friction& along, const Fibre& fibre, double direction);

}  // namespace flexslip
