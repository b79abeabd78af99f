// What `design` and `sweep` tell, described once: of a planned test, and of a map or a sweep of them.
#pragma once

#include <string>
#include <vector>

#include "design/design_answer.h"
#include "design/design_result.h"
#include "result/fields.h"

namespace flexslip {

// An answer with the sentences that tell it.
struct ToldDesign {
  const DesignAnswer& answer;
  std::string words;
  std::vector<std::string> changes;  // one of each change
};

// Units: those of the case. What is infinite or does not exist is null.
Fields<ToldDesign> design_fields();

// A sweep: a row for each of its designs. A map: likewise.
Fields<DesignPoint> point_fields(const std::vector<DesignAxis>& axes);
Fields<MapPoint> map_fields(const std::vector<DesignAxis>& axes);
Fields<std::vector<MapPoint>> design_map_fields(const std::vector<DesignAxis>& axes);

}  // namespace flexslip
