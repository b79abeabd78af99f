#include "data/literature_friction.h"

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("paper: Table 1, friction of glass on steel") {
  const auto glass = friction_in_literature({"glass", "steel"});
  REQUIRE(glass);
  CHECK(glass->low == 0.5);
  CHECK(glass->high == 0.721);
  CHECK(friction_in_literature({"silica", "stainless steel"})->low == 0.7);
}

TEST_CASE("limit: of other pairs the table says nothing, and maize is no glass") {
  CHECK(!friction_in_literature({"maize", "steel"}));
  CHECK(!friction_in_literature({"glass", ""}));
  CHECK(!friction_in_literature({"steel", "glass"}));
}

}  // namespace flexslip
