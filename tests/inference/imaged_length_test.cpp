#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "inference/profile.h"

namespace flexslip {

TEST_CASE("identity: offset and scatter of what was imaged are those it was made with") {
  FrictionProfile profile;
  std::vector<double> pulled_in{std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t i = 1; i <= 200; ++i) {
    ProfilePoint point{};
    point.index = i;
    point.imaged = 1 + 1e-3 * static_cast<double>(i);
    profile.points.push_back(point);
    // Scatter that is even from -0.01 to 0.01: its median absolute deviation is 0.005.
    const double scatter = 0.01 * (2 * std::fmod(0.618034 * static_cast<double>(i), 1) - 1);
    pulled_in.push_back(i % 50 == 0 ? std::numeric_limits<double>::quiet_NaN() : point.imaged - 1 - 0.02 + scatter);
  }
  const auto compared = compare_with_images(profile, pulled_in);
  CHECK(compared.points.size() == 196);
  CHECK(compared.points[0].index == 1);
  CHECK(compared.points[0].inferred == doctest::Approx(1e-3));
  CHECK(compared.offset.value == doctest::Approx(0.02).scale(0).epsilon(0.01));
  CHECK(compared.scatter == doctest::Approx(1.4826 * 0.005).scale(0).epsilon(0.03));
  CHECK(compared.offset.standard_error == doctest::Approx(1.2533 * compared.scatter / 14).scale(0).epsilon(1e-9));
}

TEST_CASE("limit: without images there is nothing to compare") {
  ProfilePoint point{};
  point.imaged = 1.1;
  for (const std::vector<double>& pulled_in :
       {std::vector<double>{}, std::vector<double>{std::numeric_limits<double>::quiet_NaN()}}) {
    const auto compared = compare_with_images({{point}, {}}, pulled_in);
    CHECK(compared.points.empty());
    CHECK(std::isnan(compared.offset.value));
  }
}

}  // namespace flexslip
