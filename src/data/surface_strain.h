// Strain and stress at the surface of a bent specimen, where they are greatest: at midspan, away from the axis by half the depth.
#pragma once

#include "data/scales.h"
#include "data/section.h"

namespace flexslip {

// Of a specimen of a section and a bending stiffness. Stress is that of a material as stiff as the bending stiffness says.
class SurfaceStrain {
 public:
  SurfaceStrain(const Section& section, const Scales& scales)
      : strain_(0.5 * depth(section) / scales.span()), modulus_(scales.bending_stiffness() / second_moment(section)) {}

  double strain(double curvature) const { return strain_ * curvature; }           // [1] of a curvature [1/L]
  double stress(double curvature) const { return modulus_ * strain(curvature); }  // [Pa]; in a reduced case [EI/L^4]
  double curvature_at_strain(double strain) const { return strain / strain_; }    // [1/L]
  double curvature_at_stress(double stress) const { return stress / modulus_ / strain_; }

 private:
  double strain_;   // [1] at a curvature of 1/L
  double modulus_;  // [Pa]
};

}  // namespace flexslip
