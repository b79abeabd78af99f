#include "io/workbook.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "io/input_error.h"
#include "io/text_file.h"

using namespace flexslip;

namespace {

// Of make_fixtures.py: notes, and two specimens.
const std::string& two_specimens() {
  static const std::string bytes = bytes_of(FLEXSLIP_SOURCE_DIR "/tests/instruments/fixtures/two_specimens.xlsx");
  return bytes;
}

using Cells = std::vector<std::string>;

Cells cells_of(const WorkbookSheet& sheet, std::size_t row) {
  return {sheet.cells.cells(row - 1).begin(), sheet.cells.cells(row - 1).end()};
}

// All that a sheet holds.
std::vector<Cells> rows_of(const WorkbookSheet& sheet) {
  std::vector<Cells> rows;
  for (std::size_t row = 1; row <= sheet.cells.size(); ++row) rows.push_back(cells_of(sheet, row));
  return rows;
}

}  // namespace

TEST_CASE("table: the cells of a sheet, in all rows as many") {
  const WorkbookSheet sheet = read_sheet(two_specimens());
  CHECK(sheet.name == "Specimen 1");
  CHECK(sheet.sheets == std::vector<std::string>{"Notes", "Specimen 1", "Specimen 2"});
  CHECK_FALSE(sheet.text);
  CHECK(cells_of(sheet, 1) == Cells{"Support span", "17 mm", ""});
  CHECK(cells_of(sheet, 2).empty());
  CHECK(cells_of(sheet, 3) == Cells{"Time (s)", "Crosshead (mm)", "Force (N)"});
  CHECK(sheet.cells.kind(2, 0) == CellKind::word);
  CHECK(cells_of(sheet, 14) == Cells{"1.0", "0.2", "390.0"});  // 40 i - i^2/10 at i = 10
  CHECK(sheet.cells.kind(13, 2) == CellKind::number);
  CHECK(cells_of(read_sheet(two_specimens(), "3"), 14) == Cells{"1.0", "0.2", "195.0"});
  CHECK(rows_of(read_sheet(two_specimens(), "Specimen 2")) == rows_of(read_sheet(two_specimens(), "3")));
}

TEST_CASE("workbook: a sheet that is not there is refused with those that are") {
  CHECK_THROWS_WITH_AS(read_sheet(two_specimens(), "Specimen 7"),
                       doctest::Contains("'Notes', 'Specimen 1' and 'Specimen 2'"), InputError);
  CHECK_THROWS_WITH_AS(read_sheet(two_specimens(), "4"),
                       doctest::Contains("There is no sheet '4'; the workbook has 'Notes'"), InputError);
}

TEST_CASE("workbook: cut off anywhere it is refused") {
  const std::string_view bytes = two_specimens();
  for (std::size_t size = 0; size + 1 < bytes.size(); size += 7) {
    CAPTURE(size);
    CHECK_THROWS_AS(read_sheet(bytes.substr(0, size)), InputError);
  }
}

TEST_CASE("identity: with any bit turned it is refused, or says the same") {
  const WorkbookSheet right = read_sheet(two_specimens());
  for (std::size_t at = 0; at < two_specimens().size(); at += 3) {
    std::string bytes = two_specimens();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
    std::optional<WorkbookSheet> read;
    try {
      read = read_sheet(bytes);
    } catch (const InputError&) {
    }
    CAPTURE(at);
    if (read)
      CHECK((read->name != right.name ||
             rows_of(*read) == rows_of(right)));  // a name in the table of contents may hide a sheet
  }
}

TEST_CASE("workbook: what begins as an archive or an old office document is told from text") {
  CHECK(is_packed(two_specimens()));
  CHECK(is_packed("\xd0\xcf\x11\xe0"));
  CHECK_FALSE(is_packed("Position,Force\n"));
  CHECK_FALSE(is_packed("PK"));
  CHECK_FALSE(is_packed(""));
}

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
