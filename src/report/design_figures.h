// Figures of a planned test.
#pragma once

#include <vector>

#include "design/design_answer.h"
#include "design/design_result.h"
#include "report/plot.h"

namespace flexslip {

// The record as it will be, its drops marked, beside the stiffnesses on which the specimen is at a fold: where that of the rig is
// below them, it snaps.
Plot design_figure(const DesignAnswer& answer);

// Drops and the first snap over one parameter; or the largest drop over two, with the border of those that do not snap.
// Domain:     one or two axes, and their points; std::invalid_argument otherwise.
Plot design_map_figure(const Test& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

}  // namespace flexslip
