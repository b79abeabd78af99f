// The fields of friction determined point by point (`fit`, `invert`), and the other tables of a
// fit.
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

// A point of a profile with its record.
struct PointOfProfile {
  const Record& record;  // in the unit of the test
  const ProfilePoint& point;
};

std::vector<PointOfProfile> points_of(const Record& record, const FrictionProfile& profile);

// The friction at the rows of a file, with everything determined there.
Fields<PointOfProfile> pointwise_friction_fields();
Fields<PointOfProfile> profile_fields();

// The fields of `invert --json` of a case, and its frame. The test must outlive the frame.
Fields<InvertedTest> inverted_test_fields();
Frame frame_of(const InvertedTest& test);

// A point of the record with its pointwise friction and the fit.
struct CurvePoint {
  const FittedTest& test;
  std::size_t i;
  const ProfilePoint* read;  // null if there is none
};
Fields<CurvePoint> curve_fields();

// A point along the specimen, in the band of a fit.
struct BandPlace {
  const FrictionFit* fit;
  std::size_t i;
};
// The names of the posterior samples must outlive the fields.
Fields<BandPlace> draw_fields(std::span<const std::string> names);

ResultTable curve_table(const FittedTest& test);

void write_curves(const std::string& path, const FittedTest& test, const CsvMarks& marks = {});

// Writes profile_fields.
void write_profile(const std::string& path, const FittedTest& test, const CsvMarks& marks = {});

// Writes friction along the specimen in the format of the model "table": length, mu (mean of the
// fit), deviation, and the posterior samples draw_1, draw_2, ….
// Domain:     analysis.status is ok; std::invalid_argument otherwise.
void write_draws(const std::string& path, const FittedTest& test, const CsvMarks& marks = {});
ResultTable draw_table(const FittedTest& test);

}  // namespace flexslip
