// The map Ψ on a fixed ladder of lengths, as polynomials in friction: the curve of a friction profile for the price of a few
// multiplications a point. Fits, which run thousands of curves over the same lengths, are built on it; results that are
// reported are computed by rig.h.
#pragma once

#include <span>
#include <vector>

namespace flexslip {

class SlidingMap {
 public:
  // Lengths evenly spaced in √(S - 1) from 1 to S_max, their largest distance being S_step.
  // Domain:     1 < S_max <= 2.1, 0 < S_step, 0 < mu_max <= 5; std::invalid_argument otherwise.
  // Max error:  of w and F 1e-6 of their values for 0 <= q <= mu_max.
  // Cost:       1 ms.
  SlidingMap(double S_max, double S_step, double mu_max);

  std::span<const double> lengths() const { return S_; }  // [L] 1 + (i step)^2
  double sigma_step() const { return sigma_step_; }       // [√L] the step in √(S - 1)
  double mu_max() const { return mu_max_; }               // [1]

  struct Curve {
    std::vector<double> w;  // [L]
    std::vector<double> F;  // [EI/L^2]
  };

  // The sliding curve of a friction profile given at those lengths. Values outside [0, mu_max] count as the nearest bound.
  Curve curve(std::span<const double> mu) const;

  // Its slopes with respect to friction, at fixed length.
  Curve slopes(std::span<const double> mu) const;

 private:
  static constexpr int degree = 9;

  double mu_max_;
  double sigma_step_;
  std::vector<double> S_;
  std::vector<double> w_, F_;  // coefficients: degree + 1 rows of a coefficient for each length
};

// A test in which the stage only advances, on a curve given at a ladder of lengths.
struct MeasuredCurve {
  std::vector<double> F;  // [EI/L^2] at each stage position; that of the last length if the curve does not reach it
  std::vector<std::size_t> cell;  // the state lies between the lengths cell and cell + 1,
  std::vector<double> fraction;   // this fraction of the way
  std::vector<double> F_slope;    // change of F over the cell at that fraction
  std::vector<double> G_slope;    // likewise of the stage position
};

// The running maximum of the stage position G = w + compliance F, as in rig.h, interpolated by cubics between the lengths.
// Domain:     stages rising; w and F of one length, at least 4.
// Max error:  set by the ladder: with n lengths a period, about 60/n^4 of the height of a tooth.
MeasuredCurve measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                             std::span<const double> stages);

}  // namespace flexslip
