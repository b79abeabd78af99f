// The fields of `design` and `sweep` answers: a planned test, a map, a sweep.
#pragma once

#include <string>
#include <vector>

#include "design/design_answer.h"
#include "design/design_result.h"
#include "result/fields.h"

namespace flexslip {

// A design answer with its sentences.
struct DescribedDesign {
  const DesignAnswer& answer;
  std::string words;
  std::vector<std::string> changes;  // one per change
};

// Units:      as in the case. Infinite and undefined values are null.
Fields<DescribedDesign> design_fields();

// The fields of one design of a sweep, and of one point of a map.
Fields<DesignPoint> point_fields(const std::vector<DesignAxis>& axes);
Fields<MapPoint> map_fields(const std::vector<DesignAxis>& axes);
Fields<std::vector<MapPoint>> design_map_fields(const std::vector<DesignAxis>& axes);

}  // namespace flexslip
