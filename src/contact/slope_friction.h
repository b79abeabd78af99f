// Coulomb friction on a slope, and a surface as a rounded edge sees it.
//
// A support that climbs a slope tan α of the specimen's surface shows μ_app = (μ + tan α)/(1 - μ tan α) = tan(atan μ + α), and on the way down
// tan(atan μ - α). To first order A μ = (1 + μ²) times the amplitude of the slope (theory.md, "A surface and its friction").
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace flexslip {

// [1] What a contact of friction mu shows where it climbs a slope [1].
// Domain:     mu slope < 1; std::invalid_argument otherwise: it would hold whatever pulls.
double friction_on_slope(double mu, double slope);

// [1] The slope on which a contact of friction mu shows an apparent one: the inverse. Domain: mu apparent > -1.
double slope_of_friction(double apparent, double mu);

// [1] What a slope shows on the way back that shows an apparent friction on the way there: tan(2 atan mu - atan apparent).
// Domain:     of slopes less steep than mu both ways, between 0 and what 2 atan mu gives; 0 beyond.
double friction_on_the_way_back(double apparent, double mu);

// Why heights show no friction that could be computed with: the steepest of the intervals at fault.
struct TooSteep {
  std::size_t interval;  // after this height
  double slope;          // [1]
};

// Where the apparent friction is not above 0 and at most a limit. None where it is everywhere.
// Domain:     step > 0, most > mu > 0.
std::optional<TooSteep> too_steep(std::span<const double> path, double step, double mu, double most);

// [1] What heights at a distance of step show between each and the next, to a support that climbs them in their order.
// Domain:     step > 0, at least two heights, none too steep; std::invalid_argument otherwise.
std::vector<double> friction_of_heights(std::span<const double> path, double step, double mu);

// A surface as a rounded edge sees it that is drawn over it: a circle that rolls on the profile does not reach into valleys narrower than itself.
// [L] Where the lowest point of the circle lies at each place of a trace: the dilation by the disk, max_j z_j + √(r² - (s_i - s_j)²) - r. What a support
// of that radius climbs when it stands at that place.
// Domain:     step > 0, radius >= 0; std::invalid_argument otherwise. Radius 0, and one below the step: the heights themselves.
// Max error:  rounding. The circle touches samples, no lines between them.
// Cost:       O(n log n): which sample is touched never falls along the trace.
std::vector<double> path_of_edge(std::span<const double> height, double step, double radius);

}  // namespace flexslip
