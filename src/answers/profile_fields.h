// Friction read off a curve point by point, as `fit` and `invert` tell it.
#pragma once

#include <vector>

#include "case/measurement.h"
#include "case/mechanics.h"
#include "data/record.h"
#include "inference/profile.h"
#include "result/fields.h"

namespace flexslip {

// A point of a profile and the record that it was read off.
struct ReadPoint {
  const Record& record;  // in the unit of the test
  const ProfilePoint& point;
};

std::vector<ReadPoint> points_of(const Record& record, const FrictionProfile& profile);

Fields<ReadPoint> profile_fields();

// A test of which only that is asked for, by `invert`.
struct ReadTest {
  const Measurement& measurement;
  const BendingStiffnessUsed& stiffness;
  const FrictionProfile& profile;
};
Fields<ReadTest> read_test_fields();

// The test must outlive it.
Frame frame_of(const ReadTest& test, const Scales& scales);

}  // namespace flexslip
