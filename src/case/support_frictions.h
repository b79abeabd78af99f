// The friction of the supports in the test that a case describes. All functions throw as problem.h says.
#pragma once

#include <optional>
#include <string>

#include "case/case_file.h"
#include "contact/friction.h"
#include "data/scales.h"
#include "fibre/fibre.h"
#include "io/input_error.h"

namespace flexslip {

// How fine it may be.
inline constexpr double most_periods = 1e6;         // of a wave: what trace_loading_curve takes, half a minute
inline constexpr double most_correlations = 2.4e5;  // of a rough profile, which has four knots to each

// What friction there may be, in words: "friction of at most 20".
std::string friction_limit(const Fibre& fibre);

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

// [1] The friction at which rollers turn on their pins; none of rollers that are not on pins.
std::optional<double> pin_limit_of(const RigInput& rig);

// What pins with such a limit leave of the friction of a support, for lengths up to S_max [L].
Friction on_pins(const std::optional<double>& pin_limit, Friction friction, double S_max);

// Whether a support climbs a surface in this case.
bool climbs_surface(const Case& input);

// Of a surface that is climbed on the way in and come down on the way out, on edges that are alike.
// Fails:      InputError where that is not covered: two surfaces, rollers, friction that builds up, an excess at rest, or slopes on which the specimen
//             would slide out by itself.
Friction on_both_ways(const Case& input, const Friction& inwards, const Fibre& fibre, const Scales& scales);

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
// Fails:      InputError where it is too fine to be followed as it builds up, and for what is not covered on rollers.
Friction together(const Case& input, SupportFrictions supports, const Fibre& fibre, const Scales& scales, double S_max);

// The kinetic friction of a case for lengths up to S_max [L], of both supports together.
// Fails:      as frictions_of.
Friction friction_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max);

}  // namespace flexslip
