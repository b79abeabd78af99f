// How the errors of estimates go together.
#include "inference/correlations.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/elementary.h"
#include "tests/approximately.h"

namespace flexslip {
namespace {

JointPart part_of(double weight, double mu0, double drift, double roughness) {
  JointPart part{weight, {}};
  part.value.fill(not_a_number);
  part.value[JointPart::mu0] = mu0;
  part.value[JointPart::drift] = drift;
  part.value[JointPart::roughness] = roughness;
  return part;
}

}  // namespace

TEST_CASE("correlations, definition: a mixture varies within its parts and between them") {
  std::vector<JointPart> parts{part_of(1, -1, -2, not_a_number), part_of(1, 1, 2, not_a_number)};
  for (JointPart& part : parts) part.covariance = {{{3, -1, 0}, {-1, 5, 0}, {0, 0, 0}}};
  const auto found = correlations_of(parts);
  REQUIRE(found.size() == 1);
  CHECK(found[0].of == "mu0");
  CHECK(found[0].with == "drift");
  CHECK(found[0].value == to(1e-15, (2. - 1) / std::sqrt((1. + 3) * (4 + 5))));
}

TEST_CASE("correlations, limit: what some parts tell nothing of is in these what it is on average") {
  const auto found =
      correlations_of(std::vector{part_of(2, -1, 0, 4), part_of(2, 1, 0, 6), part_of(4, 3, 0, not_a_number)});
  REQUIRE(found.size() == 1);  // the drift does not vary
  CHECK(found[0].with == "roughness");
  // Means 1.5 and 5: covariance 2(-2.5)(-1) + 2(-.5)(1) of weights 8, variances 2·6.25 + 2·.25 + 4·2.25 and 2 + 2.
  CHECK(found[0].value == to(1e-15, 4 / std::sqrt(22. * 4)));
}

}  // namespace flexslip
