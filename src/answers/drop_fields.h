// The drops of the force and the rises between them, described once: whether these are slips, whether the specimen sticks.
#pragma once

#include <cstddef>
#include <vector>

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// A drop of the force and the record that it is in.
struct DropOf {
  const Record& record;
  const Slip& slip;
};
Fields<DropOf> drop_fields();

// Those that can be slips.
Fields<TestAnalysis> slips_fields();

Fields<SlipOrCrack> slip_or_crack_fields();

// Domain: analysis.teeth are given.
Fields<FittedTest> teeth_fields();

// A point that needs more friction than is plausible.
struct SuspectPoint {
  std::size_t index;
  const ProfilePoint* read;  // null where no friction explains it
};
std::vector<SuspectPoint> suspects_of(const FittedTest& test);
Fields<SuspectPoint> suspect_fields();
Fields<SuspectReport> suspect_criteria_fields();

}  // namespace flexslip
