// Cross-sections of specimens, and what bending knows of them.
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
  double inner_diameter;  // [m] less than the outer
  bool operator==(const TubularSection&) const = default;
};

struct RectangularSection {
  double width;   // [m]
  double height;  // [m] in the direction of bending
  bool operator==(const RectangularSection&) const = default;
};

using Section = std::variant<RoundSection, TubularSection, RectangularSection>;

// Second moment I [m^4] about the axis of bending: π D^4/64, π (D^4 - d^4)/64, b h^3/12.
// Domain:    lengths [m] positive and finite, inner_diameter < diameter; std::invalid_argument with the value otherwise.
// Max error: 4 ulp; D^4 - d^4 is factored, so that a thin wall costs no digits.
double second_moment(const Section& section);

// The extent in the direction of bending [m]: diameter or height.
double depth(const Section& section);

// How much shear, which the elastica leaves out, adds to a small deflection over a span [m], relative to that of bending [1].
// Domain:    lengths as for second_moment, span positive.
// Source:    Timoshenko's beam, 24 (1 + ν) I/(κ A L²), with Cowper's coefficients κ(ν) of round, tubular and rectangular sections
//            (J. Appl. Mech. 33, 335 (1966)) and ν = 0.3. Of a material that is soft in shear, as fibre composites are, it is more.
double shear_share(const Section& section, double span);

// A tube whose wall is less than a twentieth of its diameter: it may become oval under the load before it bends as a beam, which
// is nowhere modelled.
bool is_thin_tube(const Section& section);

// Strain and stress at the surface of a bent specimen, where they are greatest: at midspan, away from the axis by half the depth.

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
