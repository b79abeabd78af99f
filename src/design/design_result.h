// A planned test: its single loading, the outcome, and the outcomes over a range of one or two
// parameters.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bending_test/design.h"
#include "case/mechanics.h"
#include "data/scales.h"
#include "data/section.h"
#include "design/design_axis.h"
#include "result/fields.h"

namespace flexslip {

// The test as one loading whose parameters can be varied (design_axis.h). The programme goes from 0
// to its farthest position. A missing step becomes 0, a single wave becomes a sinusoid, and files
// of friction are read.
// Domain:     a test to simulate, with specimen, rig, friction and [stage].
// Fails:      throws InputError, naming the key, if something is missing, cannot be computed, or is
//             no single loading: a measured programme, a reversal before the farthest position,
//             static friction above the kinetic one, snaps that overshoot.
Test one_loading_of(const Test& given);

// Converts results of a design to the units of the case.
struct DesignUnits {
  Scales scales;
  std::optional<SurfaceStrain> surface;  // empty without a section
};

struct PlannedDesign {
  Design design;
  DesignUnits units;
};

// The design with the current parameters of a loading.
// Fails:      throws ImpossibleTest, or InputError for a design that cannot be computed.
// Cost:       a few µs, except for tables and rough profiles.
PlannedDesign design_of(const Test& loading);

enum class ResultStatus {
  ok,
  slipped_through,  // the outcome covers the loading up to that point
  impossible,       // no such test exists (ImpossibleTest, case/mechanics.h); no outcome
  // outside the limits of FlexSlip: friction above largest_q, roughness too fine; no outcome
  not_computable,
  breaks,  // the outcome covers the loading up to that point
};
inline constexpr std::array<std::string_view, 5> result_status_words{"ok", "slipped_through", "impossible",
                                                                     "not_computable", "breaks"};
std::string_view word_of(ResultStatus status);
ResultStatus status_of(const DesignOutcome& outcome);

struct DesignResult {
  ResultStatus status;
  std::optional<DesignUnits> units;  // present if outcome is
  std::optional<DesignOutcome> outcome;
};

// The result of one loading. A value that is too extreme for any part of the computation gives
// not_computable.
DesignResult result_of(const Test& loading);

// The fields of an outcome, with the same names in CSV and JSON; missing without an outcome.
const Fields<DesignResult>& outcome_fields();

// Parses "stiffness=10 N/m:1000 N/m:50": a name, two ends, and the number of values. The spacing is
// logarithmic if the ends differ by a factor of ten or more.
// Fails:      throws InputError without a place if the case has no such parameter or range.
DesignAxis map_axis(const Test& input, std::string_view text, std::uint64_t usual_points);

// At most two axes from such texts. Errors name the option --over.
// Fails:      throws InputError as map_axis, and for more axes, a repeated parameter, or more than
//             a million designs.
std::vector<DesignAxis> map_axes(const Test& input, const std::vector<std::string>& texts);

// One design of a map or a sweep.
struct DesignPoint {
  std::vector<double> values;  // one per axis
  DesignResult result;
};

struct MapPoint : DesignPoint {
  // [1] stiffness_margin: positive if the specimen does not snap; NaN without an outcome
  double margin;
};

// All designs of the grid; the last axis changes fastest. They do not depend on the number of
// threads.
// Domain:     axes of ranges.
// Cost:       one outcome and one critical stiffness per design.
std::vector<MapPoint> design_map(const Test& input, const std::vector<DesignAxis>& axes, unsigned threads);

// The zero contour of the margin of a map over two axes. Its points on the edges of the grid cells
// are interpolated linearly, in the logarithm for a logarithmic axis.
struct BorderPiece {
  std::array<double, 2> from, to;  // the two parameters
};
std::vector<BorderPiece> border_of_snapping(const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

}  // namespace flexslip
