// A case made ready to compute: the one place where what a user wrote meets the types of the core.
//
// A reduced case has the scales 1 and 1: "SI" below is then the model's scaled variables. All functions throw an InputError
// that points at the line of the case, or of the file it names, that cannot be computed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bending_test/cracking_fibre.h"
#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "case/case_file.h"
#include "case/measurement.h"
#include "contact/friction.h"
#include "data/scales.h"
#include "data/surface_strain.h"
#include "inference/profile.h"

namespace flexslip {

// The limits of what is computed; that of friction is the most_friction of the fibre.
inline constexpr double thickest = 0.2;          // [L] beyond it shear, which the elastica leaves out, adds 10 % to w
inline constexpr double nearest_reduced = 1e-6;  // [L] of the stage: what the loading curve can be traced for
inline constexpr double farthest_reduced = 100;  // [L] of the stage: a fibre is through its supports within a few spans
inline constexpr double most_periods = 1e6;      // of a wave: what trace_loading_curve takes, half a minute
inline constexpr double most_correlations = 2.4e5;  // of a rough profile, which has four knots to each

enum class StiffnessSource {
  stated,         // by the case, with its uncertainty
  assumed_error,  // by the case, without: usual_stiffness_error
  initial_slope,  // of the record, F = 48 EI w/L^3
  mirror,         // of the loops of a test that is unloaded, which friction makes mirror images in (S, q)
};

std::string_view name_of(StiffnessSource source);

struct BendingStiffnessUsed {
  double value;           // [N m^2] EI
  double relative_error;  // [1] standard deviation
  StiffnessSource source;
};

// Does the case state its bending stiffness, or leave it to the fit?
bool states_stiffness(const Case& input);

// The bending stiffness that a case states.
// Fails:      InputError if it states none.
BendingStiffnessUsed bending_stiffness_of(const Case& input);

// The same, or where the case leaves it to the fit, from the initial slope of the record.
// Fails:      InputError if the force does not rise where the record begins.
BendingStiffnessUsed bending_stiffness_of(const Case& input, const Measurement& measurement);

// Fails:      InputError if the case has no span, or its specimen is as thick as a fifth of it: no slender beam.
Scales scales_of(const Case& input, const BendingStiffnessUsed& stiffness);

// Fails:      InputError if the case has no span.
double span_of(const Case& input);

// [N/m] of the load train alone.
// Fails:      InputError if the case has no stiffness of the rig.
double load_train_stiffness_of(const Case& input);

// [m/N] What the two supports of a case, each of which carries half the force, add to the compliance of the load train: 0 of rigid ones.
double support_compliance_of(const Case& input);

// [N/m] Of a load train and supports in line, from that of the load train; and back, infinite where the supports alone are as soft.
inline double with_supports(double load_train, double compliance) {
  return compliance == 0 ? load_train : 1 / (1 / load_train + compliance);
}
inline double without_supports(double both, double compliance) {
  return compliance == 0 ? both : 1 / std::max(1 / both - compliance, 0.0);
}

// [N/m] Of load train and supports together: what stands between the stage and the deflection of the specimen.
// Fails:      as load_train_stiffness_of.
double rig_stiffness_of(const Case& input);

// What the specimen of a case stands on, and how far off. Of a section that may be another than that of the case.
// Fails:      InputError if rollers and thickness leave no span.
Supports supports_of(const Case& input, const std::optional<Section>& section, const Scales& scales);

// The specimen of a case on its supports: fixed rollers or edges, with its thickness if friction acts at its surface. Of a section that may be
// another than that of the case.
// Fails:      InputError if rollers and thickness leave no span.
Fibre fibre_of(const Case& input, const std::optional<Section>& section, const Scales& scales);
Fibre fibre_of(const Case& input, const Scales& scales);

// Fails:      InputError if the case has no stiffness of the rig.
Rig rig_of(const Case& input, const Scales& scales);

// [1/L] The curvature at which the specimen of a case breaks; infinite where none is stated. `surface` is that of its section, if it has one.
double breaking_curvature_of(const SpecimenInput& specimen, const std::optional<SurfaceStrain>& surface);

// Why a reference [m] of the drift is no length that a specimen may have between the supports; none if it is one.
// The field of this fault and of the next is the key of [friction] that brings it about; they have neither file nor line.
std::optional<InputFault> misplaced(const Case& input, double reference, const Scales& scales);

// What the mechanics of a fibre does not cover of the friction of a support, and the profile it was made from, at lengths up to S_max [L]: more
// than its most_friction, or steeper than steepest_followed. None if it covers all.
std::optional<InputFault> uncovered(const Case& input, const FrictionProfileInput& profile, const Friction& kinetic,
                                    const Fibre& fibre, const Scales& scales, double S_max);

// The length [L] up to which the friction of one support counts where the specimen is drawn in to S_max [L]: of two supports that are not alike
// one may slide alone.
double one_sided_reach(const Case& input, double S_max);

// What rollers on pins leave of the friction of a support, for lengths up to S_max [L].
Friction on_pins(const RigInput& rig, Friction friction, double S_max);

// The friction of each support.
struct SupportFrictions {
  Friction first;
  std::optional<Friction> other;  // where it is not that of the first
};

// Of each support for lengths up to S_max [L] of the specimen; a table is read from its file.
// Fails:      InputError if the case has none, several models, one without parameters, or one that is not covered.
SupportFrictions frictions_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max);

// Of both together: on supports that are not alike that of the way on which the specimen is drawn in (contact/two_supports.h), and likewise
// where friction builds up (contact/build_up.h).
// Fails:      InputError where it is too fine to be followed as it builds up.
Friction together(const Case& input, SupportFrictions supports, const Fibre& fibre, const Scales& scales, double S_max);

// The kinetic friction of a case for lengths up to S_max [L], of both supports together.
// Fails:      as frictions_of.
Friction friction_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max);

// What the stage is to do.
struct StageProgramme {
  std::vector<double> positions;  // [m] in steps: of every reading; else the turning points, exactly followed
  double farthest;                // [m] the greatest of them
  bool in_steps;
  bool measured;  // read from a file
};

// The programme of a case, its cycles and steps written out; a measured one is read from its file.
// Fails:      InputError if the case has none, or one that goes nowhere, farther than a specimen bends, behind the contact, or
//             back in time.
StageProgramme programme_of(const Case& input);

// The test that a case describes, for stage positions up to `farthest` [L]: friction at rest and in sliding, rig, snaps.
// Fails:      InputError as friction_of and rig_of, and if the rig is too soft to bend the specimen.
BendingTest bending_test_of(const Case& input, const Scales& scales, double farthest);

// So many periods of friction, at most, come to the supports while the stage moves up to a position [L].
double periods_up_to(const Friction& friction, double stage);

// None without a section.
std::optional<SurfaceStrain> surface_of(const Case& input, const Scales& scales);

// The curvature at midspan [1/L] from which a specimen wraps the nose of its rig, as its axis is bent more sharply than nose and half depth allow; up to
// there the radius of the nose has no effect. Infinite for a sharp nose.
double nose_curvature_of(const Case& input, const std::optional<Section>& section, const Scales& scales);

// Where the specimen of a case cracks.
std::vector<Crack> cracks_of(const Case& input, const Scales& scales);

// Reduced errors of the readings, for measure_friction and fit_friction.
MeasurementErrors errors_of(const Measurement& measurement, const BendingStiffnessUsed& stiffness,
                            const Scales& scales);

}  // namespace flexslip
