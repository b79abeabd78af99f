// Friction read off a curve point by point, as `fit` and `invert` tell it, and the other tables of a fit, that a user may restyle or read into Excel.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "case/fitted.h"
#include "case/studies.h"
#include "data/record.h"
#include "inference/profile.h"
#include "result/fields.h"
#include "result/table.h"

namespace flexslip {

// A point of a profile and the record that it was read off.
struct ReadPoint {
  const Record& record;  // in the unit of the test
  const ProfilePoint& point;
};

std::vector<ReadPoint> points_of(const Record& record, const FrictionProfile& profile);

// Friction at the rows of a file, and all that is read off there.
Fields<ReadPoint> read_friction_fields();
Fields<ReadPoint> profile_fields();

// Of `invert --json` of a case, and its frame, which the test must outlive.
Fields<InvertedTest> inverted_test_fields();
Frame frame_of(const InvertedTest& test);

// A point of the record with what was read there, and what the fit says.
struct CurvePoint {
  const FittedTest& test;
  std::size_t i;
  const ProfilePoint* read;  // null where none was
};
Fields<CurvePoint> curve_fields();

// A place along the specimen, in the band of a fit.
struct BandPlace {
  const FrictionFit* fit;
  std::size_t i;
};
// With the names of its draws, which must outlive the fields.
Fields<BandPlace> draw_fields(std::span<const std::string> names);

void write_curves(const std::string& path, const FittedTest& test);

// As profile_fields.
void write_profile(const std::string& path, const FittedTest& test);

// Friction along the specimen as the model "table" of a case takes it: length, mu (the mean of the fit), deviation, and draw_1,
// draw_2, …: profiles that explain the record as well.
// Domain:     analysis.status is ok; std::invalid_argument otherwise.
void write_draws(const std::string& path, const FittedTest& test);
ResultTable draw_table(const FittedTest& test);

}  // namespace flexslip
