// The sliding curve on a fixed ladder of lengths, and what a test measures of it: fits run thousands of curves over the same lengths.
// Results that are reported are computed by rig.h.
#pragma once

#include <span>
#include <vector>

#include "fibre/fibre.h"

namespace flexslip {

inline constexpr double longest_ladder = 2.1;  // [L] before the branch ends, whatever the friction

class SlidingLadder {
 public:
  // Lengths evenly spaced in √(S - 1) (Fibre::way) from 1 to S_max, their largest distance being S_step; of a specimen with a thickness those
  // before it slides in count as 1.
  // Domain:     1 < S_max <= longest_ladder, 0 < S_step; std::invalid_argument otherwise.
  SlidingLadder(double S_max, double S_step, const Fibre& fibre = {});

  std::span<const double> lengths() const { return S_; }  // [L]
  double sigma_step() const { return sigma_step_; }       // [√L] the step in √(S - 1)

  // The sliding curve of a friction profile given at those lengths, to the accuracy of the table (fibre/state_table.h). Values outside
  // [0, table_q.greatest] count as the nearest bound.
  StateArrays curve(std::span<const double> mu) const;

  // The same with its slopes; those to q are zero at S = 1.
  SlopeArrays slopes(std::span<const double> mu) const;

 private:
  struct Bent {
    double w, F;
  };
  Bent bent_shallow(std::size_t i, double mu) const;

  Fibre fibre_;
  double sigma_step_;
  std::vector<double> S_;
  std::vector<double> shallow_;  // [L] deflections before it slides in, of the first lengths
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
