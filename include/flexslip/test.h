// What is known about a three-point bending test: specimen and rig, friction, and the record. All numbers are in SI.
#pragma once

#include <limits>
#include <vector>

namespace flexslip::v1 {

// A number that is not stated, or does not exist. Test it with std::isnan.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

// A number and its standard error, in the same unit.
// Domain:     an error of 0 up to 0.3 of the value. An error that is not known takes the default of the
//             case-file key (docs/case-file-keys.md).
struct Known {
  double value;
  double error;

  Known(double number = not_known, double standard_error = not_known) : value(number), error(standard_error) {}
};

// The specimen and the rig.
// Domain:     all positive, the radius also 0. The section is a diameter (with an inner diameter for a tube),
//             or a width and a height; without a section, a bending stiffness is stated. The thickness is at
//             most a fifth of the span, except for a modulus.
struct Setup {
  Known diameter{}, inner_diameter{};  // [m] of a round specimen, of a tube
  Known width{}, height{};             // [m] of a rectangular specimen; the height lies in the direction of bending
  Known modulus{};                     // [Pa] Young's modulus; a fit finds it if it is not known
  Known bending_stiffness{};           // [N m^2] EI, instead of the modulus
  Known span{};                        // [m] distance between the supports
  Known load_train_stiffness{};        // [N/m] of load cell, frame and nose in series; may be infinite
  Known roller_radius{};               // [m] of fixed rollers; 0: knife edges; not known: edges are assumed
};

// One periodic term of friction.
struct Wave {
  double amplitude;   // [1] relative to mu0, 0 to 1; all amplitudes add up to 1 at most
  double wavelength;  // [m] along the specimen
  double phase = 0;   // [rad]
};

// The friction where a length of specimen lies between the supports. A point of the specimen at the distance x from
// midspan touches its support at the length 2 x.
struct FrictionPoint {
  double length;  // [m]
  double mu;      // [1] >= 0
};

// The friction of both supports along the specimen: either mu0 and waves, mu0 (1 + Σ amplitude cos(π length/wavelength
// + phase)), or a list of points, with monotone interpolation, constant beyond its ends.
// Domain:     mu0 from 0 to 20 (on rollers, or with a section, to 2); points of rising length, the last beyond the
//             span.
struct Friction {
  double mu0 = not_known;  // [1]
  std::vector<Wave> waves{};
  std::vector<FrictionPoint> points{};
};

// The readings of a test, in the order of time: two of stage, deflection and force. A deflection is measured at
// midspan; a stage position or a crosshead displacement includes the load train.
// Domain:     columns of one length, finite numbers, at least 30 readings, 11 for a modulus.
struct Record {
  std::vector<double> stage{};       // [m]
  std::vector<double> deflection{};  // [m]
  std::vector<double> force{};       // [N]
};

}  // namespace flexslip::v1
