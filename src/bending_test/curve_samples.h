// A sliding curve sampled along the way that the fibre slides.
//
// The way is x = σ = √(S - 1) (Fibre::way) for a fibre drawn in and x = -σ for one let out, so that x rises on either. In σ the curve has no
// singularity at its start: dw/dσ -> √15/6 and F -> 48 w.
#pragma once

#include <span>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

inline double direction_of(Sliding sliding) { return sliding == Sliding::in ? 1 : -1; }
double way_at(const Fibre& fibre, Sliding sliding, double S);  // [√L]

struct CurveSample {
  bool exists;     // false beyond the end of the branch; then nothing else is valid
  RigPoint point;  // its stage_slope is infinite at S = 1
  double slope;    // [√L] dG/dx
  double scale;    // [√L] size of its terms
};

// Points of the way, to the accuracy of Fibre::state_slopes. The friction is that met on the way.
CurveSample sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x);
std::vector<CurveSample> samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                    std::span<const double> x);

// The same to the accuracy of the table (state_table.h): slopes to this, relative to their scale.
inline constexpr double tabulated_error = 1e-9;
std::vector<CurveSample> tabulated_samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                              std::span<const double> x);

}  // namespace flexslip
