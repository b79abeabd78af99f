#include "finding/printed.h"

#include <limits>

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("table: two digits of the uncertainty, the value to match (GUM 7.2.6)") {
  struct Row {
    double value, error;
    const char *printed, *printed_error;
  };
  for (const auto& row :
       {Row{0.58423, 0.0123, "0.584", "0.012"}, Row{10.9, 0.2, "10.90", "0.20"}, Row{0.5, 0.0996, "0.50", "0.10"},
        Row{1234.5, 56.7, "1234", "57"}, Row{1234.5, 560, "1234", "560"}, Row{-1e-9, 0.01, "0.000", "0.010"},
        Row{0.001234, 0.000099, "0.001234", "0.000099"}}) {
    INFO(row.value, " ± ", row.error);
    const auto digits = matched_digits({row.value, row.error, row.value - 2 * row.error, row.value + 2 * row.error}, 1);
    CHECK(digits.value == row.printed);
    CHECK(digits.error == row.printed_error);
  }
}

TEST_CASE("limit: without an uncertainty four significant digits, and none is claimed") {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto digits = matched_digits({10.98765e-6, unknown, unknown, unknown}, 1e6);
  CHECK(digits.value == "10.99");
  CHECK(digits.error.empty());
  CHECK(digits.low.empty());
}

TEST_CASE("table: three significant digits") {
  CHECK(format_significant(3.7, 3) == "3.70");
  CHECK(format_significant(175.4, 3) == "175");
  CHECK(format_significant(0.0123456, 3) == "0.0123");
  CHECK(format_significant(0, 3) == "0.00");
}
