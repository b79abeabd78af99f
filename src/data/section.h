// Cross-sections of specimens and their properties in bending.
#pragma once

#include <variant>

#include "data/scales.h"

namespace flexslip {

struct RoundSection {
  double diameter;  // [m]
  bool operator==(const RoundSection&) const = default;
};

struct TubularSection {
  double diameter;        // [m] outer
  double inner_diameter;  // [m] smaller than the outer one
  bool operator==(const TubularSection&) const = default;
};

struct RectangularSection {
  double width;   // [m]
  double height;  // [m] in the direction of bending
  bool operator==(const RectangularSection&) const = default;
};

using Section = std::variant<RoundSection, TubularSection, RectangularSection>;

// Second moment I [m^4] about the axis of bending: π D^4/64, π (D^4 - d^4)/64, b h^3/12.
// Domain:     lengths [m] positive and finite, inner_diameter < diameter; std::invalid_argument
//             with the value otherwise.
// Max error:  4 ulp; D^4 - d^4 is factored, so that a thin wall loses no digits.
double second_moment(const Section& section);

// [m] The extent in the direction of bending: diameter or height.
double depth(const Section& section);

// [1] The relative increase of a small deflection due to shear, which the elastica neglects.
// Domain:     lengths as for second_moment, span [m] positive.
// Source:     Timoshenko's beam, 24 (1 + ν) I/(κ A L²), with Cowper's coefficients κ(ν) (J. Appl.
//             Mech. 33, 335 (1966)) and ν = 0.3. The increase is larger for materials soft in
//             shear, such as fibre composites.
double shear_share(const Section& section, double span);

// True for a tube with a wall below a twentieth of its diameter. Such a tube may ovalise before it
// bends as a beam, which the model does not include.
bool is_thin_tube(const Section& section);

// Strain and stress at the surface at midspan, where they are largest.

// Strain and stress at the surface of a specimen, half its depth away from the axis. The modulus
// follows from the bending stiffness.
class SurfaceStrain {
 public:
  SurfaceStrain(const Section& section, const Scales& scales)
      : strain_(0.5 * depth(section) / scales.span()), modulus_(scales.bending_stiffness() / second_moment(section)) {}

  double strain(double curvature) const { return strain_ * curvature; }  // [1] for a curvature [1/L]
  // [Pa]; in a reduced case [EI/L^4]
  double stress(double curvature) const { return modulus_ * strain(curvature); }
  double curvature_at_strain(double strain) const { return strain / strain_; }  // [1/L]
  double curvature_at_stress(double stress) const { return stress / modulus_ / strain_; }

 private:
  double strain_;   // [1] at a curvature of 1/L
  double modulus_;  // [Pa]
};

}  // namespace flexslip
