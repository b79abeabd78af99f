#include "design/open_study.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "tests/design/some_design.h"

namespace flexslip {

TEST_CASE("open study: nothing is open without a phase") {
  Test input = loading_of(spicule);
  set(input, "amplitude", 0);
  CHECK_FALSE(open_study(input, {}, 1));
}

TEST_CASE("open study, identity: the band of phases contains the force of the test") {
  const Test input = loading_of(spicule);
  const auto study = open_study(input, {}, 1);
  REQUIRE(study);
  CHECK(study->designs == 24);
  CHECK(study->phases == 24);
  const Design design = design_of(input).design;
  const auto record = record_of({design.friction, design.rig}, design.travel, design.travel / 400);
  REQUIRE(record.size() == study->force.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    CHECK(record[i].F >= study->force[i].low);
    CHECK(record[i].F <= study->force[i].high);
  }
}

TEST_CASE("open study, identity: the ends of the ranges are among the designs, for any number of threads") {
  const Test input = loading_of(spicule);
  const std::vector<OpenNumber> open{{{design_parameter("mu0"), AxisRange{0.1, 0.9, Spacing::linear, 0}}, "usual"}};
  const auto one = open_study(input, open, 1), two = open_study(input, open, 2);
  REQUIRE(one);
  CHECK(one->designs == 24);
  double least = 1, most = 0;
  for (const double mu0 : {0.1, 0.9}) {
    Test there = input;
    set(there, "mu0", mu0);
    const DesignOutcome outcome = result_of(there).outcome.value();
    least = std::min(least, outcome.largest_snap / outcome.greatest_force);
    most = std::max(most, outcome.largest_snap / outcome.greatest_force);
    CHECK(one->min_force <= outcome.greatest_force);
    CHECK(one->max_force >= outcome.greatest_force);
  }
  CHECK(one->min_snap <= least);
  CHECK(one->max_snap >= most);
  CHECK(one->min_snap == two->min_snap);
  CHECK(one->force.size() == two->force.size());
}

}  // namespace flexslip
