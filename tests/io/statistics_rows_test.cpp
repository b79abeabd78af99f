#include "io/statistics_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

std::vector<double> ramp(std::size_t rows, double step) {
  std::vector<double> values(rows);
  for (std::size_t i = 0; i < rows; ++i)
    values[i] = step * static_cast<double>(i) + 0.1 * std::sin(static_cast<double>(i));
  return values;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  double squares = 0;
  for (const double value : values) squares += std::pow(value - mean(values), 2);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

// The rows of statistics among lines of a text, but for those that are empty.
std::vector<std::size_t> found_in(const std::string& text, const std::vector<std::vector<double>>& columns) {
  const Sheet sheet(text, ',');
  std::vector<std::size_t> lines;
  for (std::size_t line = 0; line < sheet.size(); ++line)
    if (!sheet.is_blank(line)) lines.push_back(line);
  return statistics_among(sheet, lines, columns).rows;
}

// The number of rows at the end that are statistics by their numbers, with a number of rows below a break.
std::size_t at_end(const std::vector<std::vector<double>>& columns, std::size_t below_break = 0) {
  std::string text;
  for (std::size_t row = 0; row < columns.front().size(); ++row)
    text += row > 0 && row + below_break == columns.front().size() ? "\n1\n" : "1\n";
  return found_in(text, columns).size();
}

}  // namespace

TEST_CASE("table: labels of statistics, and of what is none") {
  for (const char* label : {"Mean", "MEAN (N)", "Max.", "Std. Dev.", "St. Dev", "Standard deviation", "Mittelwert:",
                            "Standardabw.", "Écart type", "ÉCART TYPE", "Máximo", "平均", "Average of 3", "sd"})
    CHECK_MESSAGE(names_statistic(label), label);
  for (const char* label : {"", "meaning", "Maxwell", "Specimen 1", "loading", "minute", "summit", "12", "S"})
    CHECK_FALSE_MESSAGE(names_statistic(label), label);
  const auto label = [](const std::string& line) { return std::string(label_of(Sheet(line + "\n", ','), 0)); };
  CHECK(label("Mean,1") == "Mean");
  CHECK(label(",平均") == "平均");
  for (const char* line : {"", "1.5", "-", "nan,Mean", "N/A", "#N/A", "+3"}) CHECK_MESSAGE(label(line).empty(), line);
}

TEST_CASE("rows below readings: labels are data where half of the rows have one") {
  const auto found = [](const std::vector<std::string>& labels, std::size_t rows) {
    std::string text;
    for (std::size_t row = 0; row < rows; ++row)
      text += (row + labels.size() < rows ? "" : labels[row + labels.size() - rows]) + ",1\n";
    return found_in(text, {});
  };
  using Rows = std::vector<std::size_t>;
  CHECK(found({"Mean", "", "", "", "", "a", "b"}, 10) == Rows{3, 8, 9});
  CHECK(found({"Mean", "", "", "", "", "a", "b", ""}, 11) == Rows{3});  // the last has no label: these mark readings
  CHECK(found({"Mean", "a", "b"}, 6).empty());
  CHECK(found(std::vector<std::string>(30, "a"), 100).empty());
}

TEST_CASE("statistics at the end: found with the digits that are shown, by what they are and not by where") {
  const std::vector<double> a = ramp(200, 0.5), b = ramp(200, 0.031);
  CHECK(at_end({a, b}) == 0);
  const auto with = [](std::vector<double> values, std::initializer_list<double> more) {
    values.insert(values.end(), more);
    return values;
  };
  const double round = 1.0005;  // three digits
  const auto greatest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  CHECK(at_end({with(a, {mean(a) * round}), with(b, {mean(b) / round})}) == 1);
  CHECK(at_end({with(a, {mean(a), deviation(a)}), with(b, {mean(b), deviation(b)})}) == 2);
  CHECK(at_end({with(a, {greatest(a), mean(a)}), with(b, {greatest(b), mean(b)})}) == 2);
  CHECK(at_end({with(a, {mean(a)}), with(b, {deviation(b)})}) == 0);  // not the same of both
  CHECK(at_end({with(a, {greatest(a)}), with(b, {greatest(b)})}) ==
        0);  // the last reading of a loading is the greatest
}

TEST_CASE("statistics at the end: an unloading that ends halfway is none, and the same numbers below a break are") {
  std::vector<double> a(113), b(113);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = i < 80 ? 1.0 * static_cast<double>(i) : 79 - 1.0 * static_cast<double>(i - 79);
  const double middle = mean({a.begin(), a.end() - 1});
  a.back() = middle;
  for (std::size_t i = 0; i < a.size(); ++i) b[i] = 0.03 * a[i];
  CHECK(at_end({a, b}) == 0);
  CHECK(at_end({a, b}, 1) == 1);
}

TEST_CASE("statistics at the end: readings that are all alike are none") {
  std::vector<double> a(100, 3.0), b(100);
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = 5 + 1e-4 * std::sin(static_cast<double>(i));
  CHECK(at_end({a, b}) == 0);
  CHECK(at_end({ramp(11, 1), ramp(11, 2)}) == 0);
  CHECK(at_end({a}) == 0);
}
