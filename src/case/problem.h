// A case made ready to compute: the one place where what a user wrote meets the types of the core.
//
// A reduced case has the scales 1 and 1: "SI" below is then the model's scaled variables. All functions throw an InputError
// that points at the line of the case, or of the file it names, that cannot be computed.
#pragma once

#include <optional>
#include <vector>

#include "bending_test/history.h"
#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "case/case_file.h"
#include "case/measurement.h"
#include "case/stage_programme.h"
#include "case/stiffness_used.h"
#include "case/support_frictions.h"
#include "data/scales.h"
#include "data/section.h"
#include "inference/profile.h"

namespace flexslip {

inline constexpr double thickest = 0.2;  // [L] beyond it shear, which the elastica leaves out, adds 10 % to w

// Fails:      InputError if the case has no span, or its specimen is as thick as a fifth of it: no slender beam.
Scales scales_of(const Case& input, const BendingStiffnessUsed& stiffness);

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
