// What rollers and a thickness add to a stiffness that the bending standards take from a curve: as the specimen bends, its contacts move inwards.
#pragma once

#include <optional>

#include "case/measurement.h"
#include "data/small_deflection.h"

namespace flexslip {

// [1] Of a specimen without friction, between the deflections from which the modulus is told: those of the chord, or of the straight part.
// Friction adds to it, 2.4 μ of the deflection in spans where it slides in.
// Domain:     numbers of the record of the measurement, with status ok.
// Fails:      none without a span, or where the supports of the case have neither radius nor thickness; InputError as supports_of.
// Max error:  1e-9, that of the difference of two forces.
std::optional<double> supports_share(const Measurement& measurement, const SmallDeflection& numbers);

}  // namespace flexslip
