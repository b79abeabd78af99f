#include "instruments/sheet.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

std::vector<std::string> cells_of(std::string_view text, char separator, std::size_t line = 0) {
  const Sheet sheet(text, separator);
  return {sheet.cells(line).begin(), sheet.cells(line).end()};
}

using Cells = std::vector<std::string>;

}  // namespace

TEST_CASE("sheet: cells, quotes and line endings as RFC 4180 and spreadsheets have them") {
  CHECK(cells_of("a, b ,c\n", ',') == Cells{"a", "b", "c"});
  CHECK(cells_of("\"1,234.5\",\"say \"\"x\"\"\"", ',') == Cells{"1,234.5", "say \"x\""});
  CHECK(cells_of("a;;b;\r\n1", ';') == Cells{"a", "", "b", ""});
  CHECK(cells_of("a;b\r1;2\r", ';', 1) == Cells{"1", "2"});
  CHECK(cells_of("  1\t 2   3 ", ' ') == Cells{"1", "2", "3"});
  CHECK(cells_of("5\" pipe,2", ',') == Cells{"5\" pipe", "2"});
  CHECK(cells_of("\"broken,2", ',') == Cells{"\"broken", "2"});
}

TEST_CASE("sheet: the separator of small tables whose separator is plain to see") {
  CHECK(separator_of("0,1;0,2\n0,3;0,4\n") == ';');
  CHECK(separator_of("0,1\t0,2\n") == '\t');
  CHECK(separator_of("0.1,0.2\n0.3,0.4\n") == ',');
  CHECK(separator_of("0,1 0,2\n0,3 0,4\n") == ' ');
  CHECK(separator_of("Ch 1 Load\tCh 1 LVDT\n0.1\t0.2\n") == '\t');
  CHECK(separator_of("1 234,5;2 345,6\n1 234,5;2 345,6\n") == ';');
  CHECK(separator_of("1\n2\n3\n") == ',');
}

TEST_CASE("sheet: numbers in any notation, with a unit or without, and what is none") {
  for (const char* text : {"1", "-0", "+1.5", "1,5", "1.234,5", "1'234.5", "1 234", "4.4E-8", "5e-005", ".5"})
    CHECK_MESSAGE(number_cell(text).number == text, text);
  CHECK(number_cell("12.5 N").number == "12.5");
  CHECK(number_cell("12.5 N").unit == "N");
  for (const char* text : {"", "-", "e5", "1e", "1-Preload", "12:30", "10/26/2022", "1 apple", "inf", "nan", "1e5x"})
    CHECK_MESSAGE(number_cell(text).number.empty(), text);
}
