// Features of the rows of one loading that depend on the cause of its drops: slips, cracks, or
// both.
//
// In a slip, a length slides in, and friction decreases within this length. On a stiff load train
// the length is very short. All lengths are measured in units of the length that slides in during a
// snap, so that the features are alike on every rig and at every depth (theory.md, "Slip or
// crack"). Reduced variables of the nominal bending stiffness.
#pragma once

#include <cstddef>
#include <span>

#include "bending_test/rig.h"
#include "data/drops.h"
#include "data/record.h"

namespace flexslip {

// [L] The length that slides in during a snap, per unit of friction lost: -dS/dq along the line of
// the load train.
// Domain:     a state at the deflection w [L] with the mobilised friction q, before it is pushed
//             through the supports; k [EI/L^3] > 0, may be infinite. NaN without a state.
// Source:     theory.md, "Slip or crack": c = S_w F_q/(k + F_w) - S_q, with the slopes of S(w, q)
//             and F(w, q).
double snap_length(const Fibre& fibre, double w, double q, double k);

// The errors of a loading, and its rests.
struct LoadingErrors {
  double force;                          // [EI/L^2] noise of one reading
  double bending_stiffness;              // [1] of EI
  std::span<const std::size_t> halts{};  // points after which the stage stopped, in order; the force relaxes there
};

// Features of the friction inverted at the nominal bending stiffness.
struct DropFeatures {
  std::size_t drops = 0;  // judged drops; if 0, only least_anywhere and fall_anywhere are valid

  // [1] The apparent loss of stiffness relative to that required by the drops as cracks: 0 for
  // slips, 1 for cracks.
  double follows_drops = 0, follows_drops_error = 0;
  // [1] Of the steepest rise: 0 for sliding at constant friction, 1 for sticking.
  double max_steepness = 0;
  // [1] The share of the friction lost in a drop that recovers within 3 and 12 snap lengths.
  double recovery_near = 0, recovery_far = 0;
  double stiffness_recovery = 0;  // sum of the rises of friction / sum of its falls
  double least_after_drop = 0;    // [errors] the lowest friction after a drop
  double needed_at_end = 0;       // friction at the end of the loading if the drops are cracks only
  double roughness = 0;           // of friction within the rises / a typical drop
  double slid_in = 0;             // length of all snaps / sliding length
  double loss_needed = 0;         // of the stiffness, if the drops are cracks only
  double loss_recovered = 0;      // the part of loss_needed that recovers within 12 snap lengths

  // Over all rows: the lowest friction [errors], and the largest decrease of friction while the
  // stage moved.
  double least_anywhere = 0, fall_anywhere = 0;
};

// Domain:     rows of one loading without faults; its drops in order; errors >= 0.
// Accuracy:   that of the tables of the fibre.
// Cost:       0.3 µs a row.
DropFeatures drop_features(const ReducedRecord& record, const Rig& rig, const LoadingErrors& errors,
                           std::span<const Drop> drops);

// True if the specimen lost force or stiffness that no friction explains, in a drop or not.
bool is_loss_without_friction(const DropFeatures& features);

}  // namespace flexslip
