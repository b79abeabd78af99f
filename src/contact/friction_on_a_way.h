// Friction that is more than a profile: it depends on the way on which the fibre gets to a length.
#pragma once

#include <memory>
#include <span>

#include "contact/friction_forms.h"

namespace flexslip {

// Friction as it is met on a way, in or out, from the lengths of which it makes more than a profile (two_supports.h, over_rollers.h, build_up.h).
class FrictionOnAWay {
 public:
  virtual ~FrictionOnAWay() = default;
  virtual FrictionPoint at(double S) const = 0;
  virtual double smooth_scale() const = 0;
  virtual double end_of(double S, double scales, bool inwards) const {
    const double step = scales * smooth_scale();
    return inwards ? S + step : S - step;
  }
  virtual double most_up_to(double S_max) const = 0;
  virtual std::span<const double> knots() const = 0;
  // As the fibre meets it, at what has been drawn in: else of the points of the specimen.
  virtual bool is_met() const { return false; }

  // May a fibre that is at a length slide on in a direction, in (1) or out (-1)? If not it takes the way from there, and from its q.
  virtual bool leads(double /*S*/, double /*direction*/) const { return true; }
  virtual std::shared_ptr<const FrictionOnAWay> from(double /*S*/, double /*q*/, double /*direction*/) const {
    return nullptr;
  }
  virtual bool depends_on_way() const { return false; }
  virtual bool lets_stick() const { return true; }
};

}  // namespace flexslip
