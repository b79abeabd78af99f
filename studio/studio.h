// The calculations of the page as the pointer moves. Inputs are numbers in SI, results columns of
// numbers in SI. Pure: no files, no JavaScript. `flexslip simulate` and `flexslip
// equilibrium` give the same results bit for bit (tests/studio/studio_test.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "contact/friction.h"

namespace flexslip::studio {

struct RigInput {
  double span;               // [m]
  double depth;              // [m] of the section; 0: friction acts at the axis
  double bending_stiffness;  // [N m²]
  double stiffness;          // [N/m] of the load train; may be infinite
  double roller_radius;      // [m] 0: knife edges
  // a table of a case: friction against the length [m] between the contacts
  FrictionTable friction;
};

struct State {
  double deflection;  // [m]
  double force;       // [N]
  double drawn;       // [m] sliding length over both supports
  double friction;    // [1] mobilised
};

struct Jump {
  double stage;  // [m]
  State from, to;
};

struct Loading {
  // ok; otherwise why the columns end early: slipped_through, contact_lost, branch_ended
  std::string_view status;
  std::vector<double> stage;
  std::vector<double> deflection, force, drawn, friction;  // as in State
  // that led to the point: stick, slip_in, slip_out, snap, crack, apart
  std::vector<std::uint8_t> motion;
  std::vector<Jump> snaps;
};

// The answer of `flexslip simulate`, with a step, or else with `points` points on each segment of
// the programme.
// Domain:     a programme as [stage] program in docs/case-files.md; std::invalid_argument
//             otherwise, and for tests that cannot be computed.
Loading simulate(const RigInput& rig, std::span<const double> programme, std::optional<double> step, int points);

// One loading from the straight specimen to a stage position [m], in `steps` equal steps of the
// stage. It is faster than simulate, for drawing while a slider moves. `motion` and `snaps` are
// empty.
// Domain:     farthest > 0, steps >= 2. std::invalid_argument otherwise, and if the computed
//             lengths do not reach that position.
// Max error:  1e-3 of the maximum force. Near a snap, the error of a shift by one step.
Loading sketch(const RigInput& rig, double farthest, int steps);

// The answer of `flexslip equilibrium`: the loading curve on any rig, up to a length between the
// supports [m].
// Domain:     longest > span, points >= 2; otherwise as above.
Loading equilibrium(const RigInput& rig, double longest, int points);

struct Point {
  double x, y;  // [m] upward, from the middle between the first contacts
};

// The axis of the specimen in a state, and the forces on it.
struct Shape {
  std::vector<Point> axis;  // from end to end
  Point left, right;        // of the axis, at the contacts
  double slope;             // [rad] at the contacts
  // [N] at each support; while the specimen slides in, friction on it points outwards
  double normal, tangential;
  double force;  // [N] at midspan
  double slid;   // [m] length of surface that slid in over both supports
};

// The shape of a specimen at a deflection [m] with a mobilised friction. A length `beyond` [m] of the
// straight specimen lies outside each support.
// Domain:     points >= 2 between the supports; an existing state; std::invalid_argument otherwise.
// Max error:  1e-6 of the span.
Shape shape(const RigInput& rig, double deflection, double friction, int points, double beyond);

// [SI] The value of a text, parsed as in a case. `kind` is a name in io/quantity.h: "a length", "a
// stiffness" (may be "inf"), "a modulus".
// Fails:      throws InputError, also for a value that is invalid for this kind.
double quantity(std::string_view words, std::string_view kind);

// [SI] The value of one unit of that kind.
// Fails:      throws InputError for an unknown unit.
double unit(std::string_view words, std::string_view kind);

// [N] The linear force: 48 EI/L³ times a deflection [m].
double euler_bernoulli(const RigInput& rig, double deflection);

}  // namespace flexslip::studio
