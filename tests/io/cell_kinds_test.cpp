#include "io/cell_kinds.h"

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("table: formats built in, as ECMA-376 lists them") {
  for (const int number : {0, 1, 2, 3, 4, 9, 10, 11, 12, 13, 37, 38, 39, 40, 48, 49})
    CHECK(kind_of_format(number) == CellKind::number);
  for (const int number : {14, 15, 16, 17}) CHECK(kind_of_format(number) == CellKind::date);
  for (const int number : {18, 19, 20, 21, 45, 46, 47}) CHECK(kind_of_format(number) == CellKind::clock);
  CHECK(kind_of_format(22) == CellKind::date_and_clock);
}

TEST_CASE("table: codes of formats, by their letters, and not by those of words, colours and languages") {
  const auto of = [](std::string_view code) { return kind_of_format(164, code); };
  for (const char* code : {"General", "0.00E+00", "#,##0.00", "0.00\" mm/s\"", "0.00\\ \\m\\m", "[Red]0.0", "0.000 mm",
                           "?/?", "_-* #,##0.00_-", "[$-409]0.00", "@", "[>100]0;[<5]0.0", "0\\d", "\"day\" 0", "0.0%"})
    CHECK_MESSAGE(of(code) == CellKind::number, code);
  for (const char* code : {"yyyy-mm-dd", "d-mmm", "mmm\\-yy", "[$-407]d. mmmm yyyy", "dd/mm/yyyy;@", "mmm"})
    CHECK_MESSAGE(of(code) == CellKind::date, code);
  for (const char* code : {"h:mm:ss", "[h]:mm:ss", "mm:ss.0", "[ss].00", "[$-F400]h:mm:ss AM/PM", "[mm]:ss", "[m]"})
    CHECK_MESSAGE(of(code) == CellKind::clock, code);
  CHECK(of("yyyy-mm-dd hh:mm:ss.000") == CellKind::date_and_clock);
  CHECK(of("\"") == CellKind::number);
  CHECK(of("[") == CellKind::number);
  CHECK(of("\\") == CellKind::number);
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

TEST_CASE("cell kinds: what was added is found, and nothing else") {
  CellKinds kinds;
  kinds.add(3, 2, CellKind::clock);
  kinds.add(4, 2, CellKind::clock);
  kinds.add(5, 2, CellKind::number);
  kinds.add(6, 2, CellKind::clock);
  CHECK(kinds.has_dates());
  CHECK_FALSE(kinds.has_words());
  kinds.add(7, 2, CellKind::word);
  CHECK(kinds.has_words());
  for (std::size_t row = 0; row < 10; ++row) {
    const CellKind right = row == 7                           ? CellKind::word
                           : row == 3 || row == 4 || row == 6 ? CellKind::clock
                                                              : CellKind::number;
    CHECK(kinds.at(row, 2) == right);
    CHECK(kinds.at(row, 1) == CellKind::number);
    CHECK(kinds.at(row, 3) == CellKind::number);
  }
}

TEST_CASE("table: names of cells") {
  CHECK(cell_name(1, 1) == "A1");
  CHECK(cell_name(17, 26) == "Z17");
  CHECK(cell_name(2, 27) == "AA2");
  CHECK(cell_name(9, 16384) == "XFD9");
}
