// A fibre on two supports that are not alike: the friction that it shows under a nose that holds its middle, and under one that does not.
//
// Sides that are not alike pull a nose sideways, by half of the difference of their frictions. A nose that bears that holds the fibre's middle:
// both sides slide alike, and their mean friction counts. A free one bears nothing, and the weaker side slides. The shape of the fibre does not
// know which of its points touch, only how much of it lies between the supports: S = 1 + left + right. Each support holds while the mobilised
// friction, which is one for both, stays below that of its own point; so the weaker side slides, alone where its friction falls or is the lower,
// and both at once where both rise at one level. Drawn in from somewhere the fibre so meets a friction that depends on S alone, whatever the rig;
// let out, another one (theory.md, "Two supports").
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "contact/friction.h"

namespace flexslip {

// The mean friction of two sides, at a length up to S_most that both have let in alike.
// Domain:     profiles, at lengths from 1 on.
class MeanOfSides final : public PathDependentFriction {
 public:
  MeanOfSides(Friction left, Friction right, double S_most);

  FrictionPoint at(double S) const override;
  double smooth_scale() const override { return std::min(left_.smooth_scale(), right_.smooth_scale()); }
  double max_up_to(double S_max) const override { return 0.5 * (left_.max_up_to(S_max) + right_.max_up_to(S_max)); }
  std::span<const double> knots() const override { return knots_; }
  std::shared_ptr<const PathDependentFriction> scaled(double factor) const override {
    return std::make_shared<const MeanOfSides>(left_.scaled(factor), right_.scaled(factor), S_most_);
  }

 private:
  Friction left_, right_;
  double S_most_;
  std::vector<double> knots_;
};

// [L] of fibre drawn in over each support since it was straight; below 0 where a side has let out more.
struct ContactPoints {
  double left, right;
};

// The way from a pair of contact points, inwards and outwards.
class TwoSupportPath final : public PathDependentFriction {
 public:
  // Drawn in up to a length S_most, and let out down to the straight fibre. The friction of a side is stated as for both together: at(S) is
  // that of the point (S - 1)/2 from where the straight fibre touches.
  // Domain:     sides that are not themselves of two supports; S = 1 + from.left + from.right in [1, S_most]; std::invalid_argument otherwise. Of
  //             two sides at one level of which one falls, the one that falls the more slides; if both are alike, the left; over a crest as high
  //             as the friction of the other side, the one that does.
  // Tolerance:  lengths at which sides change are bisected to rounding; between samples at a sixteenth of the shortest period, and the knots of
  //             tables, no crest is looked for.
  TwoSupportPath(Friction left, Friction right, ContactPoints from, double S_most);

  // The friction met at a length: drawn in beyond that of `from`, let out below. Constant beyond the ends.
  FrictionPoint at(double S) const override;

  ContactPoints points_at(double S) const;

  double origin() const { return origin_; }  // [L] the length from which it leads
  double end() const { return pieces_.back().to; }
  TwoSupportPath from(double S) const { return {sides_, points_at(S), S, end()}; }
  bool continues(double S, double direction) const override { return direction * (S - origin_) >= 0; }
  std::shared_ptr<const PathDependentFriction> from(double S, double /*q*/, double /*direction*/) const override {
    return std::make_shared<const TwoSupportPath>(from(S));
  }
  bool depends_on_way() const override { return true; }
  std::shared_ptr<const PathDependentFriction> scaled(double factor) const override {
    const std::array<Friction, 2> sides{sides_[0].scaled(factor), sides_[1].scaled(factor)};
    return std::shared_ptr<const TwoSupportPath>(new TwoSupportPath(sides, points_at(origin_), origin_, end()));
  }

  double smooth_scale() const override;
  double max_up_to(double S_max) const override;
  std::span<const double> knots() const override { return knots_; }

 private:
  enum class Slides { left, right, both };

  // S rising, whichever way it is gone.
  struct Piece {
    double from, to;           // [L]
    ContactPoints begin, end;  // at these
    Slides slides;
  };
  class Tracer;

  TwoSupportPath(std::array<Friction, 2> sides, ContactPoints from, double origin, double S_most);
  void add_knots(const Piece& piece);
  const Piece& piece_at(double S) const;
  ContactPoints points_in(const Piece& piece, double S) const;

  std::array<Friction, 2> sides_;
  double origin_;
  std::vector<Piece> pieces_;  // S rising
  std::vector<double> knots_;
};

}  // namespace flexslip
