// What the rows of one loading show of the cause of its drops: slips over the supports, cracks, or both.
//
// A slip is a snap: it draws in a length, and friction must fall within it. On a stiff load train that length is very short. All lengths are therefore
// measured in units of the length that a snap draws in, which makes the features alike on every rig and at every depth (theory.md, "Slip or crack").
// Reduced variables of the nominal bending stiffness.
#pragma once

#include <cstddef>
#include <span>

#include "bending_test/rig.h"
#include "data/drops.h"
#include "data/record.h"

namespace flexslip {

// [L] The length drawn in by a snap, for each unit of friction lost in it: -dS/dq along the line of the load train.
// Domain:     a state at the deflection w [L] with the mobilised friction q, before it is bent through the supports; k [EI/L^3] > 0, may be infinite.
//             NaN where there is no state.
// Source:     theory.md, "Slip or crack": c = S_w F_q/(k + F_w) - S_q, with the slopes of S(w, q) and F(w, q).
double snap_length(const Fibre& fibre, double w, double q, double k);

// What is known of a loading besides its rows and drops.
struct LoadingErrors {
  double force;              // [EI/L^2] noise of one reading
  double bending_stiffness;  // [1] of EI
  std::span<const std::size_t>
      halts{};  // points after which the stage halted, rising: what the force did meanwhile is relaxation
};

// Friction is meant as it is read at the nominal bending stiffness.
struct DropFeatures {
  std::size_t drops = 0;  // those that are judged; 0: only least_anywhere and fall_anywhere are valid

  // How far the apparent stiffness follows the drops, 0 for slips and 1 for cracks.
  double follows_drops = 0, follows_drops_error = 0;
  // Of the rise that is most like sticking: 0 for sliding at a constant friction, 1 for sticking.
  double greatest_steepness = 0;
  // Of a drop, the part of friction that is back after three and twelve lengths of its snap.
  double recovery_near = 0, recovery_far = 0;
  double stiffness_recovery = 0;  // the sum of the rises of friction over that of its falls
  double least_after_drop = 0;    // [errors] the least friction after a drop
  double needed_at_end = 0;       // friction at the end of the loading, if the drops were cracks only
  double roughness = 0;           // of friction within the rises, over the usual drop
  double drawn_in = 0;            // the length of all snaps over the length that slid
  double loss_needed = 0;         // of the stiffness, by the drops, if they were cracks only
  double loss_recovered = 0;      // of it, what is back after twelve lengths of the snaps

  // Of all rows, in drops or not: the least friction [errors], and the farthest that friction fell
  // below what it was before, while the stage moved.
  double least_anywhere = 0, fall_anywhere = 0;
};

// Domain:     rows of one loading without faults; its drops in order; errors >= 0.
// Accuracy:   that of the tables of the fibre.
// Cost:       0.3 µs a row.
DropFeatures drop_features(const ReducedRecord& record, const Rig& rig, const LoadingErrors& errors,
                           std::span<const Drop> drops);

// Did the specimen lose force or stiffness, in a drop or not, that no friction explains?
bool is_loss_without_friction(const DropFeatures& features);

}  // namespace flexslip
