#include "instruments/regrouped.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace flexslip;

namespace {

// A number of four decimals as a German program writes it and an English spreadsheet saves it again: zeros at the end
// are dropped; three or more digits behind the comma, and digits before it, are taken for an integer.
std::string through_spreadsheet(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return text;
  const std::size_t decimals = text.size() - point - 1;
  text.erase(point, 1);
  if (decimals < 3 || text.front() == '0') return text.insert(point, ",");
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

}  // namespace

TEST_CASE("regrouped: a test that went through an English spreadsheet comes back as it was") {
  std::vector<double> truth;
  std::vector<std::string> cells;
  for (int i = 0; i < 14000; ++i) {
    truth.push_back(std::round(1366 + 166.6 * i) / 1e4);
    cells.push_back(through_spreadsheet(truth.back()));
  }
  const std::vector<std::string_view> views(cells.begin(), cells.end());
  const Regrouped result = restored(views);
  CHECK(result.status == Regrouped::Status::restored);
  CHECK(result.values == truth);
  CHECK(result.moved > truth.size() / 2);
}

TEST_CASE("regrouped: an even column of decimal commas is left alone, and no guess is made without an anchor") {
  const std::vector<std::string_view> even{"0,5", "1,234", "2,5"};
  CHECK(restored(even).status == Regrouped::Status::none);
  CHECK(restored(even).values == std::vector<double>{0.5, 1.234, 2.5});
  const std::vector<std::string_view> afloat{"1,000,292", "1,000,312"};
  CHECK(restored(afloat).status == Regrouped::Status::ambiguous);
  const std::vector<std::string_view> uneven{"0,1366", "1,000,292", "0,5", "100,014"};
  CHECK(restored(uneven).status == Regrouped::Status::ambiguous);
}
