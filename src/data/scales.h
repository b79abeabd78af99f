// Conversion between SI and the reduced variables of the core; the only place where the two meet.
//
// A reduced quantity is a quantity divided by its unit: L for lengths, EI/L^2 for forces, EI/L^3
// for stiffnesses, EI/L for energies. Record and ReducedRecord (record.h) are separate types that
// only a Scales converts, so neither can be mistaken for the other.
#pragma once

namespace flexslip {

class Scales {
 public:
  // Units:      span in [m], bending stiffness EI in [N m^2].
  // Domain:     both positive and finite, as are the derived units; std::invalid_argument with the
  //             value otherwise.
  Scales(double span, double bending_stiffness);

  double span() const { return span_; }                            // [m]
  double bending_stiffness() const { return bending_stiffness_; }  // [N m^2]
  double force_unit() const { return force_unit_; }                // [N]    EI/L^2
  double stiffness_unit() const { return force_unit_ / span_; }    // [N/m]  EI/L^3
  double energy_unit() const { return force_unit_ * span_; }       // [J]    EI/L

  double reduced_length(double length) const { return length / span_; }                      // [m] -> [1]
  double reduced_force(double force) const { return force / force_unit_; }                   // [N] -> [1]
  double reduced_stiffness(double stiffness) const { return stiffness / stiffness_unit(); }  // [N/m] -> [1]

  double physical_length(double reduced) const { return reduced * span_; }                // [1] -> [m]
  double physical_force(double reduced) const { return reduced * force_unit_; }           // [1] -> [N]
  double physical_stiffness(double reduced) const { return reduced * stiffness_unit(); }  // [1] -> [N/m]
  double physical_energy(double reduced) const { return reduced * energy_unit(); }        // [1] -> [J]

 private:
  double span_;
  double bending_stiffness_;
  double force_unit_;
};

// Second moment I [m^4] of a solid round section: π D^4/64.
// Domain: diameter [m] positive and finite; std::invalid_argument otherwise.
double round_section_moment(double diameter);

// Second moment I [m^4] of a tube: π (D^4 - d^4)/64.
// Domain: diameters [m] positive and finite, inner < outer; std::invalid_argument otherwise.
double tubular_section_moment(double diameter, double inner_diameter);

// Second moment I [m^4] of a rectangular section bent across its height: b h^3/12.
// Domain: width, height [m] positive and finite; std::invalid_argument otherwise.
double rectangular_section_moment(double width, double height);

}  // namespace flexslip
