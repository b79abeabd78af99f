#include <atomic>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "tests/approximately.h"
#include "tests/design/some_design.h"
#include "tests/refusal.h"

namespace flexslip {

TEST_CASE("design map, identity: its points are the outcomes at its values") {
  const Test input = loading_of(spicule);
  const std::vector<DesignAxis> axes{map_axis(input, "stiffness=20 N/m:400 N/m:4", 10),
                                     map_axis(input, "mu0=0:0.6", 3)};
  CHECK(std::get<AxisRange>(axes[0].values).spacing == Spacing::logarithmic);
  CHECK(values_of(axes[1]) == std::vector{0.0, 0.3, 0.6});
  const auto points = design_map(input, axes, 2);
  REQUIRE(points.size() == 12);
  for (const auto& point : points) {
    Test there = input;
    set(there, DesignParameter::stiffness, point.values[0]);
    set(there, DesignParameter::mu0, point.values[1]);
    CHECK(point.result.outcome->snaps == outcome_of(design_of(there).design).snaps);
  }
}

TEST_CASE("design map, limit: one that is stopped gives nothing") {
  const Test input = loading_of(spicule);
  const std::atomic<bool> stop = true;
  CHECK(design_map(input, {map_axis(input, "mu0=0:0.6", 3)}, 2, &stop).empty());
}

TEST_CASE("design map, contract: a range that makes no sense is refused with a remedy") {
  const Test input = loading_of(spicule);
  CHECK(message_of([&] { map_axis(input, "stiffnes=1 N/m:2 N/m", 5); }).find("did you mean 'stiffness'?") !=
        std::string::npos);
  CHECK(message_of([&] { map_axis(input, "stiffness=1:2", 5); }).find("unit") != std::string::npos);
  CHECK(values_of(map_axis(input, "phase=0:90 deg", 5)).back() == to(1e-15, std::numbers::pi / 2));
  CHECK(values_of(map_axis(input, "phase=0:6.25", 5)).back() == 6.25);  // radians
  CHECK(message_of([&] { map_axis(input, "mu0=0:1:1", 5); }).find("points") != std::string::npos);
  CHECK(message_of([&] { map_axis(input, "mu0", 5); }).find("write it as") != std::string::npos);
}

}  // namespace flexslip
