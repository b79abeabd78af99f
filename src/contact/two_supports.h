// Friction of a specimen on two different supports, under a nose that fixes its middle and under a
// free nose.
//
// Different sides pull the nose sideways by half of the difference of their frictions. A nose that
// resists this fixes the middle: both sides slide equally, with their mean friction. Under a free
// nose the weaker side slides. The shape of the specimen depends only on the length between the
// supports, S = 1 + left + right. Each support sticks while the mobilised friction, equal on both,
// is below the friction of its contact point. So one side slides alone while its friction falls or
// is the smaller, and both slide together while both frictions rise at one level. Friction for
// sliding in then depends on S alone, for any rig; sliding out has a different one (theory.md,
// "Two supports").
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "contact/friction.h"

namespace flexslip {

// The mean friction of two sides that slide equally, up to S_max.
// Domain:     profiles defined for S >= 1.
class MeanOfSides final : public PathDependentFriction {
 public:
  MeanOfSides(Friction left, Friction right, double S_max);

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

// [L] Length that has slid in over each support since the specimen was straight; negative if it
// slid out.
struct ContactPoints {
  double left, right;
};

// The path from a pair of contact points, inwards and outwards.
class TwoSupportPath final : public PathDependentFriction {
 public:
  // Sliding in up to S_max, and out to the straight specimen. The friction of a side is given as
  // for both sides: at(S) is the friction (S - 1)/2 from the initial contact point.
  // Domain:     sides that are not themselves two supports; S = 1 + from.left + from.right in [1,
  //             S_max]; std::invalid_argument otherwise.
  // Tolerance:  changes of the sliding side are bisected to rounding. Crests are not searched
  //             between samples at a sixteenth of the shortest period and the knots of tables.
  // Method:     if both frictions are equal and one falls, the side with the steeper fall slides;
  //             if the slopes are equal, the left side. At a crest as high as the friction of the
  //             other side, the side on the crest slides.
  TwoSupportPath(Friction left, Friction right, ContactPoints from, double S_max);

  // The friction at a length: for sliding in beyond the length of `from`, for sliding out below it.
  // Constant beyond the ends.
  FrictionPoint at(double S) const override;

  ContactPoints points_at(double S) const;

  double origin() const { return origin_; }  // [L] the length at which the path starts
  double end() const { return pieces_.back().to; }
  TwoSupportPath from(double S) const { return {sides_, points_at(S), S, end()}; }
  bool continues(double S, double direction) const override { return direction * (S - origin_) >= 0; }
  std::shared_ptr<const PathDependentFriction> from(double S, double /*q*/, double /*direction*/) const override {
    return std::make_shared<const TwoSupportPath>(from(S));
  }
  bool is_path_dependent() const override { return true; }
  std::shared_ptr<const PathDependentFriction> scaled(double factor) const override {
    const std::array<Friction, 2> sides{sides_[0].scaled(factor), sides_[1].scaled(factor)};
    return std::shared_ptr<const TwoSupportPath>(new TwoSupportPath(sides, points_at(origin_), origin_, end()));
  }

  double smooth_scale() const override;
  double max_up_to(double S_max) const override;
  std::span<const double> knots() const override { return knots_; }

 private:
  enum class Slides { left, right, both };

  // A part of the path, with S rising in either direction.
  struct Piece {
    double from, to;           // [L]
    ContactPoints begin, end;  // at from and to
    Slides slides;
  };
  class Tracer;

  TwoSupportPath(std::array<Friction, 2> sides, ContactPoints from, double origin, double S_max);
  void add_knots(const Piece& piece);
  const Piece& piece_at(double S) const;
  ContactPoints points_in(const Piece& piece, double S) const;

  std::array<Friction, 2> sides_;
  double origin_;
  std::vector<Piece> pieces_;  // sorted by S
  std::vector<double> knots_;
};

}  // namespace flexslip
