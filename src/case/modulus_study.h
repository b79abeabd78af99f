// The numbers of the bending standards, of the record of a case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"
#include "case/measurement.h"
#include "data/small_deflection.h"

namespace flexslip {

struct ModulusStudy {
  Measurement measurement;
  BeamGeometry geometry;
  SmallDeflection numbers;
};

// The straight part as two words say it, "0.1" and "30 %"; none of none.
// Domain:     no words, or two.
// Fails:      InputError that names the flag --window, unless they are rising shares from 0 to 1.
std::optional<ForceWindow> window_of(const std::vector<std::string>& words);

// Fails:      InputError as read_measurement, and for a record of fewer points than tell the noise.
ModulusStudy study_modulus(const Case& input, const std::optional<ForceWindow>& window);

}  // namespace flexslip
