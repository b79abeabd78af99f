// What the page computes as the pointer moves: numbers in SI in, columns of numbers in SI out. Pure: no files, no JavaScript.
//
// The same arithmetic as the program's, in the same order: what `flexslip simulate` and `flexslip equilibrium` answer to a case is what
// these answer to its numbers, to the last bit (tests/studio/studio_test.cpp).
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
  double roller_radius;      // [m] 0: edges
  FrictionTable friction;    // of the specimen's points, as a table of a case: over lengths [m] between the contacts
};

struct State {
  double deflection;  // [m]
  double force;       // [N]
  double drawn;       // [m] over both supports
  double friction;    // [1] mobilised
};

struct Jump {
  double stage;  // [m]
  State from, to;
};

struct Loading {
  std::string_view status;  // ok, slipped_through, contact_lost, branch_ended: why the columns end early
  std::vector<double> stage;
  std::vector<double> deflection, force, drawn, friction;  // as in State
  std::vector<std::uint8_t> motion;  // stick, slip_in, slip_out, snap, crack, apart: by which it came here
  std::vector<Jump> snaps;
};

// What `flexslip simulate` answers, in steps, or where there is no step at so many points on each stretch.
// Domain:     a programme as [stage] program of docs/case-files.md; std::invalid_argument, also for all that the mechanics cannot compute.
Loading simulate(const RigInput& rig, std::span<const double> programme, std::optional<double> step, int points);

// One loading from the straight fibre on up to a stage position [m], at so many even steps of the stage: as simulate, but quickly, for what is drawn
// while a slider moves. `motion` and `snaps` are empty.
// Domain:     farthest > 0, steps >= 2. std::invalid_argument otherwise, and where the fibre does not get so far on the lengths that are computed.
// Max error:  1e-3 of the greatest force; beside a snap, that a step earlier or later.
Loading sketch(const RigInput& rig, double farthest, int steps);

// The equilibrium curve of loading, whatever the rig, up to a length between the supports [m]: what `flexslip equilibrium` answers.
// Domain:     longest > span, points >= 2; else as above.
Loading equilibrium(const RigInput& rig, double longest, int points);

struct Point {
  double x, y;  // [m] from midway between the supports as they are first touched, upward
};

// The axis of the fibre at a state, and what holds it.
struct Shape {
  std::vector<Point> axis;    // from its one end to the other
  Point left, right;          // of the axis, where it touches
  double slope;               // [rad] there
  double normal, tangential;  // [N] at each support; friction on a fibre drawn in points outwards
  double force;               // [N] at midspan
};

// Of a fibre so much of which [m, over both supports] has been drawn in, with a mobilised friction; `beyond` [m] of it lie past each support as it is
// straight. Where a thick fibre, hardly bent, has two states of a length: the more bent one.
// Domain:     points >= 2 between the supports; a state that exists; std::invalid_argument otherwise.
// Max error:  1e-6 of the span.
Shape shape(const RigInput& rig, double drawn, double friction, int points, double beyond);

// What is written in a box, [SI], by the parser that reads it in a case: of "a length", "a stiffness" (may be "inf"), "a modulus" or another kind of
// io/quantity.h, by its name.
// Fails:      InputError with its sentence, also for a value that such a box cannot have.
double quantity(std::string_view words, std::string_view kind);

// What one of a unit is in SI; of a kind likewise.
// Fails:      InputError, if it is none.
double unit(std::string_view words, std::string_view kind);

// [N] 48 EI/L³ times a deflection [m].
double euler_bernoulli(const RigInput& rig, double deflection);

}  // namespace flexslip::studio
