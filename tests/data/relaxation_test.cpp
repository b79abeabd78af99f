#include "data/relaxation.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/approximately.h"

using namespace flexslip;

namespace {

struct RestingColumns {
  std::vector<double> stage, force;
};

// A force that rises by 1 N in each of 200 rows, and falls by `rate` of itself in each of 40 rows of two rests.
RestingColumns with_rests(double rate) {
  RestingColumns columns;
  double relaxed = 0;
  for (int i = 0; i <= 200; ++i)
    for (int k = 0; k <= (i == 100 || i == 160 ? 40 : 0); ++k) {
      if (k > 0) relaxed += rate * i;
      columns.stage.push_back(0.01 * i);
      columns.force.push_back(i - relaxed);
    }
  return columns;
}

}  // namespace

TEST_CASE("relaxation: rests and their falls are found, and what a loading loses at their rate (truth known)") {
  const double rate = 1e-4;
  const auto [stage, force] = with_rests(rate);
  const std::vector<StageRest> rests = find_rests(stage, force);
  REQUIRE(rests.size() == 2);
  CHECK(rests[0].first == 100);
  CHECK(rests[0].last == 140);
  CHECK(rests[1].first == 200);
  CHECK(rests[1].last == 240);
  CHECK(rests[0].force == 100);
  // The mean of the last ten rows lies four rows and a half before the last.
  CHECK(rests[0].fall == to(1e-12, rate * 100 * 35.5));
  const auto found = relaxation_at(rests, stage.size(), 0);
  REQUIRE(found);
  CHECK(found->rests == 2);
  CHECK(found->rows == 80);
  const double mean_force = 0.5 * (rests[0].force + rests[1].force);
  CHECK(found->share.value == to(1e-12, rate * 260 * 35.5 / mean_force));
  CHECK(found->share.standard_error == 0);
  CHECK(found->over_loading == to(1e-12, found->share.value * static_cast<double>(stage.size()) / 80));
}

TEST_CASE("relaxation: what falls by less than three errors, or rises, is none (limit)") {
  const auto [stage, force] = with_rests(1e-4);
  const std::vector<StageRest> rests = find_rests(stage, force);
  const double fall = rests[0].fall + rests[1].fall, of_noise = std::sqrt(2 * 1.1);  // ten rows at the end of each
  const double just = fall / (3 * of_noise);
  CHECK(relaxation_at(rests, 281, 0.99 * just));
  CHECK(!relaxation_at(rests, 281, 1.01 * just));
  CHECK(relaxation_at(rests, 281, 0.99 * just)->share.standard_error ==
        to(1e-12, 0.99 * just * of_noise / (0.5 * (rests[0].force + rests[1].force))));
  const auto [same, level] = with_rests(0);
  CHECK(!relaxation_at(find_rests(same, level), 281, 0));
  CHECK(!relaxation_at({}, 281, 0));
  CHECK(!relaxation_at({{0, 40, 1, -5}}, 281, 0));  // it carries no force
}
