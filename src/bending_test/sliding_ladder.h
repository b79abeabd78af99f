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

  // The sliding curve of a friction profile given at those lengths, to the accuracy of the table (fibre/state_table.h). Values outside
  // [0, table_q.greatest] count as the nearest bound.
  StateArrays curve(std::span<const double> mu) const;

 private:
  Fibre fibre_;
  std::vector<double> S_;
  std::vector<double> shallow_;  // [L] deflections before it slides in, of the first lengths
};

// A test in which the stage only advances, on a curve given at a ladder of lengths: the force [EI/L^2] at each stage position, that of the last
// length if the curve does not reach it.
// Method:     the running maximum of the stage position G = w + compliance F, as in rig.h, interpolated by cubics between the lengths.
// Domain:     stages rising; w and F of one length, at least 4.
// Max error:  set by the ladder: with n lengths a period, about 60/n^4 of the height of a tooth.
std::vector<double> measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                                   std::span<const double> stages);

}  // namespace flexslip
