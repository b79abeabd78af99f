#include "design/design_axis.h"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

namespace flexslip {
TEST_CASE("design axis: each is described once, in its place") {
  std::vector<std::string_view> names;
  for (const auto& each : design_parameters()) {
    CAPTURE(each.name);
    CHECK(&design_parameter(each.name) == &each);
    CHECK(!each.description.empty());
    CHECK(!each.symbol.empty());
    names.push_back(each.name);
  }
  // The samples of a sweep are drawn by these places.
  CHECK(names == std::vector<std::string_view>{"mu0", "amplitude", "wavelength", "phase", "span", "diameter", "modulus",
                                               "stiffness", "travel", "step", "height", "width", "reference",
                                               "pin_friction"});
  CHECK_THROWS_AS(design_parameter("spam"), std::invalid_argument);
}

TEST_CASE("design axis: the range of a parameter (limit)") {
  const auto& mu0 = design_parameter("mu0");
  const auto& stiffness = design_parameter("stiffness");
  const auto& span = design_parameter("span");
  CHECK(is_within(mu0, 0));
  CHECK(!is_within(mu0, -0.1));
  CHECK(!is_within(mu0, std::nextafter(mu0.most, INFINITY)));
  CHECK(is_within(stiffness, INFINITY));
  CHECK(!is_within(stiffness, 0));
  CHECK(!is_within(span, INFINITY));
  CHECK(!is_within(span, NAN));
}

TEST_CASE("oracle: a logarithmic range against long double pow, its ends exact") {
  for (const auto& [from, to] : {std::pair{10.0, 1000.0}, std::pair{3e10, 1e-6}, std::pair{1e-9, 1e9}}) {
    const AxisRange range{from, to, Spacing::logarithmic, 0};
    CHECK(value_at(range, 0) == from);
    CHECK(value_at(range, 1) == to);
    for (int i = 1; i < 1000; ++i) {
      const double t = i / 1000.0;
      const auto exact = static_cast<double>(from * std::pow(static_cast<long double>(to) / from, t));
      // Half an ulp for each square root, 26 of them twice; a last interval of 1e-8 of the logarithm, squared over 8.
      const double bound = 30 * 2.3e-16 + std::pow(std::log(to / from) * std::ldexp(1, -26), 2) / 8;
      CHECK(std::abs(value_at(range, t) / exact - 1) < bound);
    }
  }
}

TEST_CASE("table: the rows of a grid, the last axis fastest") {
  const std::vector<DesignAxis> axes{{design_parameter("mu0"), AxisValues{0.3, 0.1}},
                                     {design_parameter("step"), AxisRange{1, 2, Spacing::linear, 3}}};
  CHECK(points_of(axes[0]) == 2);
  CHECK(points_of(axes[1]) == 3);
  const std::vector<std::vector<double>> rows{{0.3, 1}, {0.3, 1.5}, {0.3, 2}, {0.1, 1}, {0.1, 1.5}, {0.1, 2}};
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(grid_inputs(axes, i) == rows[i]);
}

}  // namespace flexslip
