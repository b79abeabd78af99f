#include "io/natural_order.h"

#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <rapidcheck.h>

using namespace flexslip;

TEST_CASE("table: numbers in names count as numbers") {
  std::vector<std::string> names{
      "SS10", "SS2", "SS1b", "SS1", "SS02", "a", "SS2_10", "SS2_9", "", "99999999999999999999x", "9x"};
  std::sort(names.begin(), names.end(), in_natural_order);
  CHECK(names == std::vector<std::string>{"", "9x", "99999999999999999999x", "SS1", "SS1b", "SS02", "SS2", "SS2_9",
                                          "SS2_10", "SS10", "a"});
}

TEST_CASE("identity: a strict order of all texts") {
  CHECK(rc::check("one before the other, unless they are the same", [](const std::string& a, const std::string& b) {
    RC_ASSERT(in_natural_order(a, b) + in_natural_order(b, a) == (a != b));
  }));
  CHECK(rc::check("transitive", [] {
    const auto digit_rich = rc::gen::container<std::string>(rc::gen::element('0', '1', '2', 'a'));
    const std::string a = *digit_rich, b = *digit_rich, c = *digit_rich;
    RC_ASSERT(!(in_natural_order(a, b) && in_natural_order(b, c)) || in_natural_order(a, c));
  }));
}
