#include <cmath>
#include <set>
#include <string_view>

#include <doctest/doctest.h>

#include "design/design_axis.h"

namespace flexslip {

TEST_CASE("design_parameter: each is described once, in its place") {
  std::set<std::string_view> names;
  std::size_t place = 0;
  for (const auto& each : design_parameters()) {
    CAPTURE(each.name);
    CHECK(static_cast<std::size_t>(each.parameter) == place++);
    CHECK(described(each.parameter).name == each.name);
    CHECK(names.insert(each.name).second);
    CHECK(!each.description.empty());
    CHECK(!each.symbol.empty());
  }
}

TEST_CASE("design_parameter: what a number may be (limit)") {
  const auto& mu0 = described(DesignParameter::mu0);
  const auto& stiffness = described(DesignParameter::stiffness);
  const auto& span = described(DesignParameter::span);
  CHECK(is_within(mu0, 0));
  CHECK(!is_within(mu0, -0.1));
  CHECK(!is_within(mu0, std::nextafter(mu0.most, INFINITY)));
  CHECK(is_within(stiffness, INFINITY));
  CHECK(!is_within(stiffness, 0));
  CHECK(!is_within(span, INFINITY));
  CHECK(!is_within(span, NAN));
}

}  // namespace flexslip
