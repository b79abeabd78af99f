// Friction of a surface that a support climbs on one way and comes down on the other: on slopes the friction of both ways differs.
//
// On a slope tan α it is tan(atan μ + α) on the way in and tan(atan μ - α) on the way out (theory.md, "A surface and its friction").
#pragma once

#include <memory>
#include <span>

#include "contact/friction.h"

namespace flexslip {

class OnSlopes final : public FrictionOnAWay {
 public:
  // Begins on the way in.
  // Domain:     profiles that depend on no way; std::invalid_argument otherwise.
  OnSlopes(Friction in, Friction out);

  FrictionPoint at(double S) const override { return way().at(S); }
  double smooth_scale() const override { return way().smooth_scale(); }
  double most_up_to(double S_max) const override { return way().most_up_to(S_max); }
  std::span<const double> knots() const override { return way().knots(); }
  bool leads(double /*S*/, double direction) const override { return direction == direction_; }
  std::shared_ptr<const FrictionOnAWay> from(double S, double q, double direction) const override;
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

}  // namespace flexslip
