// The points of a loop that slide, by length: as both directions at the same places, and as one friction that all of them support.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Dense>

#include "inference/loop_points.h"

namespace flexslip::loops {

inline constexpr double least_noise = 1e-9;  // [1] of q: keeps the filter regular for records without noise

// Sorted by S: one loop's points that slide.
struct Row {
  double side;                 // +1 in, -1 out
  double S, variance_of_unit;  // of y, for force noise 1
  std::array<double, 3> y;     // side q, and its regressors: ln EI, contact
};
struct Block {
  std::vector<Row> rows;
  std::size_t column;
  double roughness;  // [1/L] variance of μ per length
  double range;      // [L]
};

// Of a force reading [EI/L^2], and of the difference of the directions [1] with its correlation length [L].
struct Noise {
  double force, difference, length;
};

std::vector<Block> make_blocks(std::span<const Point> points, std::span<const LoopLegs> loops, std::size_t legs,
                               double force_noise);

// Both directions at the same places.
struct Pairs {
  std::vector<double> S, in, out;
  std::vector<std::array<double, 2>> in_slopes, out_slopes;  // of μ to ln EI and contact
  std::vector<double> noise_of_unit;                         // variance of in - out, for force noise 1
};

// Points sliding out, paired with the points sliding in around them where these leave no gap, averaged over places.
Pairs pair_directions(const Block& block);

// Friction at the rows of a block, as all of them support it: ±q = μ(S) ± δ(S)/2 + noise with μ a random walk, by a Kalman filter
// along S and Rauch, Tung & Striebel's smoother on the way back.
struct Smoothed {
  std::vector<Eigen::Vector3d> mu;  // and its regressors to ln EI and contact
  std::vector<double> variance;
};

Smoothed smooth(const Block& block, const Noise& noise);

}  // namespace flexslip::loops
