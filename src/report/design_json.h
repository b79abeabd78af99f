// A planned test as JSON (docs/rig-design.md).
#pragma once

#include <vector>

#include "cases/design_answer.h"
#include "cases/design_map.h"
#include "io/json.h"

namespace flexslip {

// In SI, or reduced if the case is. What is infinite or does not exist is null.
Json design_json(const DesignAnswer& answer);
Json design_map_json(const DesignCase& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

}  // namespace flexslip
