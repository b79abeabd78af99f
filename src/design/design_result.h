// A test that is being planned: the one loading that it is, what comes of it, and what would over a range of one of its numbers, or of two.
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

// A test as one loading whose numbers can be varied (design_axis.h): its programme goes from 0 to its farthest position, its step is 0 if it has none, a
// single wave is a sinusoid, and the files of its friction are read.
// Domain:     a test to simulate, with specimen, rig, friction and [stage].
// Fails:      InputError, naming the key, for what is not there, cannot be computed, or cannot be loaded once: a measured programme, one that turns
//             back before its farthest position, static friction above the kinetic one, snaps that overshoot.
Test one_loading_of(const Test& given);

// What makes numbers of the case of those of a design.
struct DesignUnits {
  Scales scales;
  std::optional<SurfaceStrain> surface;  // none without a section
};

struct PlannedDesign {
  Design design;
  DesignUnits units;
};

// What the numbers of one loading as they are now make.
// Fails:      ImpossibleTest, or InputError for what cannot be computed.
// Cost:       some µs, but for tables and rough profiles.
PlannedDesign design_of(const Test& loading);

enum class ResultStatus {
  ok,
  slipped_through,  // the outcomes are those up to there
  impossible,       // there is no such test, as ImpossibleTest (case/mechanics.h): no outcomes
  not_computable,   // beyond what FlexSlip can compute: friction above largest_q, roughness too fine; no outcomes
  breaks,           // the outcomes are those up to there
};
inline constexpr std::array<std::string_view, 5> result_status_words{"ok", "slipped_through", "impossible",
                                                                     "not_computable", "breaks"};
std::string_view word_of(ResultStatus status);
ResultStatus status_of(const DesignOutcome& outcome);

struct DesignResult {
  ResultStatus status;
  std::optional<DesignUnits> units;  // both, or none
  std::optional<DesignOutcome> outcome;
};

// What a number is too extreme for is not computable, whatever part of the computation finds out.
DesignResult result_of(const Test& loading);

// The numbers of an outcome, each described once: the same names in CSV and JSON. None where there is no outcome.
const Fields<DesignResult>& outcome_fields();

// A range from "stiffness=10 N/m:1000 N/m:50": name, ends and how many values. They are evenly spaced, in the logarithm where the ends
// are ten times apart or more.
// Fails:      InputError, without a place, for a name or a range that the case does not have.
DesignAxis map_axis(const Test& input, std::string_view text, std::uint64_t usual_points);

// One axis or two, each from such a text; none of none. Errors name the flag --over.
// Fails:      InputError as map_axis; for more axes, the same parameter twice, and more than a million designs.
std::vector<DesignAxis> map_axes(const Test& input, const std::vector<std::string>& texts);

// A design of a map or a sweep.
struct DesignPoint {
  std::vector<double> values;  // of the parameters of the axes
  DesignResult result;
};

struct MapPoint : DesignPoint {
  double margin;  // [1] as stiffness_margin; above 0 the specimen does not snap; NaN where there is no outcome
};

// All of the grid, the last axis fastest.
// Domain:     axes of ranges.
// Cost:       one outcome and one critical stiffness each. The same points for any number of them.
std::vector<MapPoint> design_map(const Test& input, const std::vector<DesignAxis>& axes, unsigned threads);

// Where the margin of a map over two axes vanishes: on the edges of the grid's cells, evenly in the logarithm of a logarithmic axis, and straight
// between them.
struct BorderPiece {
  std::array<double, 2> from, to;  // the two parameters
};
std::vector<BorderPiece> border_of_snapping(const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

}  // namespace flexslip
