// The stiffness of the specimen of a case, and of what it stands on. All functions throw as problem.h says.
#pragma once

#include <algorithm>
#include <string_view>

#include "case/case_file.h"
#include "case/measurement.h"

namespace flexslip {

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

}  // namespace flexslip
