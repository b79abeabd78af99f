// Coulomb friction on a slope, and the surface that a rounded edge follows.
//
// A support that slides up a slope tan α has the apparent friction μ_app = (μ + tan α)/(1 - μ tan
// α) = tan(atan μ + α), and tan(atan μ - α) on the way down. To first order, A μ = (1 + μ²) times
// the amplitude of the slope (theory.md, "A surface and its friction").
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace flexslip {

// [1] The apparent friction of a contact of friction mu that slides up a slope [1].
// Domain:     mu slope < 1; std::invalid_argument otherwise, because the contact would never slide.
double friction_on_slope(double mu, double slope);

// [1] The inverse: the slope that causes an apparent friction.
// Domain:     mu apparent > -1.
double slope_of_friction(double apparent, double mu);

// [1] The apparent friction in the opposite direction: tan(2 atan mu - atan apparent).
// Domain:     slopes below mu in both directions, apparent between 0 and tan(2 atan mu); 0 beyond.
double friction_on_the_way_back(double apparent, double mu);

// The steepest interval that prevents a calculation of friction.
struct TooSteep {
  std::size_t interval;  // follows this height
  double slope;          // [1]
};

// The steepest interval with an apparent friction outside (0, max_mu]; empty if there is none.
// Domain:     step > 0, max_mu > mu > 0.
std::optional<TooSteep> too_steep(std::span<const double> path, double step, double mu, double max_mu);

// [1] The apparent friction of each interval for a support that slides along the heights in order.
// Domain:     step > 0, at least two heights, none too steep; std::invalid_argument otherwise.
std::vector<double> friction_of_heights(std::span<const double> path, double step, double mu);

// [L] The path of a rounded edge over a surface. A circle does not reach into narrow valleys.
// The height of its lowest point at each place of the trace: the dilation by the disk, max_j z_j +
// √(r² - (s_i - s_j)²) - r.
// Domain:     step > 0, radius >= 0; std::invalid_argument otherwise. A radius below the step
//             returns the heights.
// Max error:  rounding. The circle touches samples, not lines between them.
// Cost:       O(n log n), because the index of the touched sample never decreases along the trace.
std::vector<double> path_of_edge(std::span<const double> height, double step, double radius);

}  // namespace flexslip
