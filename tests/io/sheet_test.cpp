#include "io/sheet.h"

#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/refusal.h"

using namespace flexslip;

namespace {

std::vector<std::string> cells_of(std::string_view text, char separator, std::size_t line = 0) {
  const Sheet sheet(std::string(text), separator);
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

TEST_CASE("sheet: a quote without its partner makes all quotes of its line ordinary characters, of that line alone") {
  const Sheet sheet("\"a \"\"x\"\"\",\"b\"\n\"a\",\"b\"c\r\n \"d;\" , \"\"\n\n", ',');
  REQUIRE(sheet.size() == 4);
  CHECK(sheet.at(0, 0) == "a \"x\"");
  CHECK(sheet.at(0, 1) == "b");
  CHECK(sheet.stray_quote(0) == 0);
  CHECK(sheet.at(1, 0) == "\"a\"");
  CHECK(sheet.at(1, 1) == "\"b\"c");
  CHECK(sheet.stray_quote(1) == 2);
  CHECK(sheet.text(1) == "\"a\",\"b\"c");
  CHECK(sheet.at(2, 0) == "d;");
  CHECK(sheet.at(2, 1).empty());
  CHECK(sheet.cells(2).size() == 2);
  CHECK(sheet.is_blank(3));
  CHECK(sheet.quoted());
  CHECK_FALSE(Sheet("5\" pipe,2\n", ',').quoted());
  const Sheet blanks("\"a b\"  1 \n\n  2 3", ' ');
  CHECK(blanks.at(0, 0) == "a b");
  CHECK(blanks.at(0, 1) == "1");
  CHECK(blanks.cells(0).size() == 2);
  CHECK(blanks.is_blank(1));
  CHECK(blanks.text(2) == "  2 3");
  CHECK(blanks.at(2, 1) == "3");
}

TEST_CASE("sheet: a line that begins with what a spreadsheet could not compute is none of words (table)") {
  for (const char* line : {"#N/A,1", "#NV,1", "#DIV/0!,1", "#WERT!,1", "#NAME?,1", " #N/A , 1"}) {
    CAPTURE(line);
    CHECK(!Sheet(line, ',').is_comment(0));
  }
  for (const char* line : {"# N/A,1", "#TIME,FORCE", "#N/A", "# stop!", "#1,2", "# what?, which?"}) {
    CAPTURE(line);
    CHECK(Sheet(line, ',').is_comment(0));
  }
}

TEST_CASE("sheet: more cells than memory should be filled with are refused with their line") {
  CHECK(Sheet("1,2\n3\n", ',', 3).size() == 2);
  CHECK(message_of([] { Sheet("1,2\n3,4\n", ',', 3); }) ==
        "line 2: The table has more than 3 cells. Split the table, or leave out the columns that are not needed.");
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

TEST_CASE("table: days as spreadsheets show them") {
  // 1 January 1900 is 1; the 29 February 1900 that there was not is 60; 1 March 1900 is 61; 2026-02-01 is 46054.
  CHECK(shown_days(1, CellKind::date, false) == "1900-01-01");
  CHECK(shown_days(59, CellKind::date, false) == "1900-02-28");
  CHECK(shown_days(61, CellKind::date, false) == "1900-03-01");
  CHECK(shown_days(46054, CellKind::date, false) == "2026-02-01");
  CHECK(shown_days(46054 - 1462, CellKind::date, true) == "2026-02-01");
  CHECK(shown_days(1.5 / 86400, CellKind::clock, false) == "00:00:01.5");
  CHECK(shown_days(59.9999 / 86400, CellKind::clock, false) == "00:01:00");
  CHECK(shown_days(1.25, CellKind::clock, false) == "30:00:00");
  CHECK(shown_days(46054.5, CellKind::date_and_clock, false) == "2026-02-01 12:00:00");
  CHECK(shown_days(-1, CellKind::date, false) == "-1 days");
  CHECK(shown_days(1e300, CellKind::clock, false) == "1e+300 days");
}

TEST_CASE("table: names of cells") {
  CHECK(cell_name(1, 1) == "A1");
  CHECK(cell_name(17, 26) == "Z17");
  CHECK(cell_name(2, 27) == "AA2");
  CHECK(cell_name(9, 16384) == "XFD9");
}

TEST_CASE("sheet: rows of a workbook know what their cells hold, and all are as wide as the widest") {
  Sheet sheet;
  sheet.append(1, std::vector<SheetCell>{{"# a remark"}});
  sheet.append(3, std::vector<SheetCell>{{"1,5"}, {"2.5", CellKind::number}, {"46054.5", CellKind::date_and_clock}});
  sheet.append(4, std::vector<SheetCell>{{"#REF!", CellKind::error}, {}});
  sheet.fill();
  REQUIRE(sheet.size() == 5);
  CHECK(sheet.cells(0).size() == 0);
  CHECK(sheet.is_comment(1));
  CHECK_FALSE(sheet.is_comment(4));
  CHECK(sheet.cells(4).size() == 3);
  CHECK(sheet.text(3) == "1,5\t2.5\t46054.5");
  CHECK(sheet.kind(3, 0) == CellKind::word);
  CHECK(sheet.kind(3, 7) == CellKind::word);
  const NumberFormat comma{',', '\0'};
  CHECK(sheet.number(3, 0, comma) == 1.5);
  CHECK(sheet.number(3, 1, comma) == 2.5);  // whatever the marks of words
  CHECK(std::isnan(sheet.number(3, 2, comma)));
  CHECK(sheet.days(3, 2) == 46054.5);
  CHECK(sheet.shown(3, 2) == "2026-02-01 12:00:00");
  CHECK(sheet.shown(3, 1) == "2.5");
}
