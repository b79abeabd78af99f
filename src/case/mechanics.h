// The mechanics of a test: the one place where what a user wrote meets the types of the core.
//
// A reduced test has the scales 1 and 1: "SI" below is then the model's scaled variables. All functions throw an InputError
// that points at the line of the case, or of the file it names, that cannot be computed.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "bending_test/history.h"
#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "case/case_file.h"
#include "case/measurement.h"
#include "data/scales.h"
#include "data/section.h"
#include "inference/fit.h"
#include "inference/profile.h"

namespace flexslip {

inline constexpr double thickest = 0.2;  // [L] beyond it shear, which the elastica leaves out, adds 10 % to w

// How far the stage may move.
inline constexpr double min_stage = 1e-6;  // [L] of the stage: what the loading curve can be traced for
inline constexpr double max_stage = 100;   // [L] of the stage: a fibre is through its supports within a few spans

// There is no such test: a specimen too thick for its span, a rig too soft to bend it. What other errors refuse cannot be computed, or is not stated.
struct ImpossibleTest : InputError {
  explicit ImpossibleTest(const InputError& error) : InputError(error) {}
};

enum class StiffnessSource {
  stated,         // by the case, with its uncertainty
  assumed_error,  // by the case, without: default_stiffness_error
  initial_slope,  // of the record, F = 48 EI w/L^3
};

std::string_view name_of(StiffnessSource source);

struct BendingStiffnessUsed {
  double value;           // [N m^2] EI
  double relative_error;  // [1] standard deviation
  StiffnessSource source;
};

// Does the test state its bending stiffness, or leave it to the fit?
bool states_stiffness(const Test& test);

// What a test says of its specimen as a beam.
BeamGeometry geometry_of(const Test& test);

// The bending stiffness that a test states; or, where it leaves that to the fit, the one from the initial slope of the record: that of its straight part
// where it tells no friction, or else of its beginning.
// Fails:      InputError if it states none; if the force does not rise where the record begins.
BendingStiffnessUsed bending_stiffness_of(const Test& test);
BendingStiffnessUsed bending_stiffness_of(const Test& test, const Measurement& measurement);

// Fails:      InputError if the test has no span.
double span_of(const Test& test);

// [N/m] Of the load train alone; and of load train and supports together, which is what stands between the stage and the deflection.
// Fails:      InputError if the test has no stiffness of the rig.
double load_train_stiffness_of(const Test& test);
double rig_stiffness_of(const Test& test);

// [m/N] What the two supports of a test, each of which carries half the force, add to the compliance of the load train: 0 of rigid ones.
double support_compliance_of(const Test& test);

// [N/m] Of a load train and supports in line, from that of the load train; and back, infinite where the supports alone are as soft.
inline double with_supports(double load_train, double compliance) {
  return compliance == 0 ? load_train : 1 / (1 / load_train + compliance);
}
inline double without_supports(double both, double compliance) {
  return compliance == 0 ? both : 1 / std::max(1 / both - compliance, 0.0);
}

// What the stage is to do.
struct StageProgramme {
  std::vector<double> positions;  // [m] in steps: of every reading; else the turning points, exactly followed
  double farthest;                // [m] the greatest of them
  bool in_steps;
  bool measured;  // read from a file
};

// The programme of a test, its cycles and steps written out; a measured one is read from its file.
// Fails:      InputError if the test has none, or one that goes nowhere, farther than a specimen bends, behind the contact, or
//             back in time.
StageProgramme programme_of(const Test& test);

// Fails:      InputError if the test has no span; ImpossibleTest if its specimen is as thick as a fifth of it: no slender beam.
Scales scales_of(const Test& test, const BendingStiffnessUsed& stiffness);
Scales scales_of(const Test& test);  // as it states its bending stiffness

// What the specimen of a test stands on, and how far off: rollers or edges, with its thickness if friction acts at its surface.
// Fails:      InputError if rollers and thickness leave no span.
Supports supports_of(const Test& test, const Scales& scales);
Fibre fibre_of(const Test& test, const Scales& scales);

// Fails:      InputError if the test has no stiffness of the rig.
Rig rig_of(const Test& test, const Scales& scales);

// By how much the rig may be off what the test states: as it says, and as is usual where it does not.
// Fails:      InputError if that of the preload exceeds a twentieth of the span.
RigErrors rig_errors_of(const Measurement& measurement);

// The key by which the snaps of a test overshoot; "" if they do not.
std::string_view key_of_overshoot(const Test& test);

// [1] The friction at which rollers turn on their pins; none of rollers that are not on pins.
std::optional<double> pin_limit_of(const Test& test);

// The kinetic friction of a test for lengths up to S_max [L], of both supports together: of supports that are not alike the mean, or under a free nose
// that of the way on which the specimen is drawn in (contact/two_supports.h).
// Fails:      InputError if the test has none, a model without parameters, or one that is not covered.
Friction friction_of(const Test& test, const Fibre& fibre, const Scales& scales, double S_max);

// The test with what the files of its friction hold, so that they are not read again.
Test with_files_read(Test test);

// What is to be computed, for stage positions up to `farthest` [L]: friction at rest and in sliding, rig, snaps.
// Fails:      InputError as friction_of and rig_of; ImpossibleTest if the rig is too soft to bend the specimen, or its pins too tight to turn.
BendingTest bending_test_of(const Test& test, const Scales& scales, double farthest);

// So many periods of friction, at most, come to the supports while the stage moves up to a position [L].
double periods_up_to(const Friction& friction, double stage);

// None without a section.
std::optional<SurfaceStrain> surface_of(const Test& test, const Scales& scales);

// [1/L] The curvature at which the specimen breaks, infinite where none is stated; and that from which it wraps the nose, as its axis is bent more
// sharply than nose and half depth allow: up to there the radius of the nose has no effect. Infinite for a sharp nose.
double breaking_curvature_of(const Test& test, const Scales& scales);
double nose_curvature_of(const Test& test, const Scales& scales);

// Where the specimen of a test cracks.
std::vector<Crack> cracks_of(const Test& test, const Scales& scales);

// Reduced errors of the readings, for measure_friction and fit_friction.
MeasurementErrors errors_of(const Measurement& measurement, const BendingStiffnessUsed& stiffness,
                            const Scales& scales);

}  // namespace flexslip
