// The mechanics of a test: the conversion of user input to the types of the core.
//
// A reduced test has the scales 1 and 1; "SI" below then means the model's scaled variables. All
// functions throw an InputError that names the line of the case, or of a file named there, with the
// invalid value.
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

inline constexpr double thickest = 0.2;  // [L] beyond it, shear adds 10 % to w, and the elastica has no shear

// The range of the stage.
inline constexpr double min_stage = 1e-6;  // [L] of the stage: limit of the loading curve
inline constexpr double max_stage = 100;   // [L] of the stage: a specimen slips off its supports within a few spans

// An impossible test: a specimen too thick for its span, a rig too soft to bend it. Other errors
// mean that a value is missing or cannot be computed.
struct ImpossibleTest : InputError {
  explicit ImpossibleTest(const InputError& error) : InputError(error) {}
};

enum class StiffnessSource {
  stated,         // by the case, with an uncertainty
  assumed_error,  // by the case, without an uncertainty: default_stiffness_error
  initial_slope,  // of the record, F = 48 EI w/L^3
};

std::string_view name_of(StiffnessSource source);

struct BendingStiffnessUsed {
  double value;           // [N m^2] EI
  double relative_error;  // [1] standard deviation
  StiffnessSource source;
};

// True if the test states its bending stiffness; false if the fit determines it.
bool states_stiffness(const Test& test);

// The beam properties of a specimen.
BeamGeometry geometry_of(const Test& test);

// The stated bending stiffness of a test. If the fit determines it: from the initial slope of the
// record, or from its linear region if the deflection is too small for friction.
// Fails:      InputError if it is not stated, or if the force does not rise at the start of the
//             record.
BendingStiffnessUsed bending_stiffness_of(const Test& test);
BendingStiffnessUsed bending_stiffness_of(const Test& test, const Measurement& measurement);

// Fails:      InputError if the test has no span.
double span_of(const Test& test);

// [N/m] The stiffness of the load train; of load train and supports in series, between stage and
// deflection.
// Fails:      InputError if the rig stiffness is missing.
double load_train_stiffness_of(const Test& test);
double rig_stiffness_of(const Test& test);

// [m/N] The compliance that the two supports add to the load train; each carries half the force. 0
// for rigid supports.
double support_compliance_of(const Test& test);

// [N/m] Converts the stiffness of a load train to load train and supports in series, and back;
// infinite if the supports alone are as soft.
inline double with_supports(double load_train, double compliance) {
  return compliance == 0 ? load_train : 1 / (1 / load_train + compliance);
}
inline double without_supports(double both, double compliance) {
  return compliance == 0 ? both : 1 / std::max(1 / both - compliance, 0.0);
}

// The path of the stage.
struct StageProgramme {
  std::vector<double> positions;  // [m] every reading, if in steps; otherwise turning points, followed exactly
  double farthest;                // [m] the maximum
  bool in_steps;
  bool measured;  // true if read from a file
};

// The programme of a test with all cycles and steps. A measured programme is read from its file.
// Fails:      InputError if the test has no programme, or one that does not move, moves too far,
//             starts before the contact, or runs back in time.
StageProgramme programme_of(const Test& test);

// Fails:      InputError if the test has no span; ImpossibleTest if the thickness exceeds a fifth
//             of the span.
Scales scales_of(const Test& test, const BendingStiffnessUsed& stiffness);
Scales scales_of(const Test& test);  // with the stated bending stiffness

// The supports of a test: rollers or knife edges, with the thickness of the specimen if friction
// acts at its surface.
// Fails:      InputError if rollers and thickness leave no span.
Supports supports_of(const Test& test, const Scales& scales);
Fibre fibre_of(const Test& test, const Scales& scales);

// Fails:      InputError if the rig stiffness is missing.
Rig rig_of(const Test& test, const Scales& scales);

// The errors of the rig, as stated or by default.
// Fails:      InputError if the preload error exceeds a twentieth of the span.
RigErrors rig_errors_of(const Measurement& measurement);

// The key that makes snaps overshoot; "" if they do not.
std::string_view key_of_overshoot(const Test& test);

// [1] The friction at which rollers turn on their pins; empty for other supports.
std::optional<double> pin_limit_of(const Test& test);

// The kinetic friction of a test for lengths up to S_max [L], of both supports together. For unlike
// supports it is the mean, or under a free nose the friction along the path of the specimen
// (contact/two_supports.h).
// Fails:      InputError if the test has no friction, a model without parameters, or a profile
//             beyond the limits.
Friction friction_of(const Test& test, const Fibre& fibre, const Scales& scales, double S_max);

// The test with the content of its friction files, so that they are read once.
Test with_files_read(Test test);

// The input of a simulation for stage positions up to `farthest` [L]: static and kinetic friction,
// rig, snaps.
// Fails:      InputError as friction_of and rig_of; ImpossibleTest if the rig is too soft or the
//             pins are too tight.
BendingTest bending_test_of(const Test& test, const Scales& scales, double farthest);

// The maximum number of periods of friction that reach the supports up to a stage position [L].
double periods_up_to(const Friction& friction, double stage);

// Empty without a section.
std::optional<SurfaceStrain> surface_of(const Test& test, const Scales& scales);

// [1/L] The curvature at which the specimen breaks, infinite if not stated; and the curvature at
// which it wraps the nose. Below the latter, the radius of the nose has no effect. Infinite for a
// sharp nose.
double breaking_curvature_of(const Test& test, const Scales& scales);
double nose_curvature_of(const Test& test, const Scales& scales);

// The cracks of the specimen.
std::vector<Crack> cracks_of(const Test& test, const Scales& scales);

// Reduced errors of the readings, for measure_friction and fit_friction.
MeasurementErrors errors_of(const Measurement& measurement, const BendingStiffnessUsed& stiffness,
                            const Scales& scales);

}  // namespace flexslip
