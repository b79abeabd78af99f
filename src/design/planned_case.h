// The case of a planned test. Before a test, friction is seldom known: a case may leave it open, and
// the design then covers a range that fits the specimen.
#pragma once

#include <string>
#include <vector>

#include "design/design_axis.h"

namespace flexslip {

// A number of friction that a case does not state, and the range that it may have.
struct OpenNumber {
  DesignAxis axis;     // a range
  std::string reason;  // "literature for glass on steel (…)", "1 to 10 % of the thickness"
};

struct PlannedCase {
  Test loading;  // as one_loading_of (design_result.h); open numbers are in the middle of their ranges
  std::vector<OpenNumber> open{};  // empty if the case states its friction
};

// Reads a case to plan a test with. Of friction, mu0, amplitude and wavelength may be missing; a
// missing section [friction] is a single wave.
// Fails:      InputError as read_case and one_loading_of. If more than friction is missing, one error
//             lists all that is missing, each with a proposal that fits the specimen.
// Source:     mu0 from the literature for the stated materials (data/literature_friction.h), and 0.1
//             to 0.5 without; wavelengths of 1 to 10 % of the thickness, the grain of a surface;
//             amplitudes of 0.05 to 0.3.
PlannedCase read_planned_case(const std::string& path, const std::vector<std::string>& changes = {});

// The same for a text; `source` names it in errors.
PlannedCase planned_case(std::string_view text, const std::string& source,
                         const std::vector<std::string>& changes = {});

// A sentence for each open number that a map does not vary: the value for which the map is.
std::vector<std::string> values_taken_for(const PlannedCase& planned, const std::vector<DesignAxis>& varied);

}  // namespace flexslip
