#include "io/workbook.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include "io/input_error.h"

using namespace flexslip;

namespace {

// Of make_fixtures.py: notes, and two specimens.
const std::string& two_specimens() {
  static const std::string bytes = [] {
    std::ifstream file(FLEXSLIP_SOURCE_DIR "/tests/instruments/fixtures/two_specimens.xlsx", std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  }();
  REQUIRE(!bytes.empty());
  return bytes;
}

std::string_view line(std::string_view text, std::size_t number) {
  for (std::size_t i = 1; i < number; ++i) text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find('\n'));
}

}  // namespace

TEST_CASE("table: a sheet as text, a line for each row, all with as many cells") {
  const WorkbookSheet sheet = read_sheet(two_specimens());
  CHECK(sheet.name == "Specimen 1");
  CHECK(sheet.sheets == std::vector<std::string>{"Notes", "Specimen 1", "Specimen 2"});
  CHECK(sheet.holds == SheetHolds::numbers);
  CHECK(line(sheet.text, 1) == "\"Support span\"\t\"17 mm\"\t");
  CHECK(line(sheet.text, 2) == "");
  CHECK(line(sheet.text, 3) == "\"Time (s)\"\t\"Crosshead (mm)\"\t\"Force (N)\"");
  CHECK(line(sheet.text, 14) == "1.0\t0.2\t390.0");  // 40 i - i^2/10 at i = 10
  CHECK(line(read_sheet(two_specimens(), "3").text, 14) == "1.0\t0.2\t195.0");
  CHECK(read_sheet(two_specimens(), "Specimen 2").text == read_sheet(two_specimens(), "3").text);
}

TEST_CASE("workbook: a sheet that is not there is refused with those that are") {
  CHECK_THROWS_WITH_AS(read_sheet(two_specimens(), "Specimen 7"),
                       doctest::Contains("'Notes', 'Specimen 1' and 'Specimen 2'"), InputError);
  CHECK_THROWS_WITH_AS(read_sheet(two_specimens(), "4"), doctest::Contains("or its number"), InputError);
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
      CHECK(
          (read->name != right.name || read->text == right.text));  // a name in the table of contents may hide a sheet
  }
}

TEST_CASE("workbook: what begins as an archive or an old office document is told from text") {
  CHECK(is_packed(two_specimens()));
  CHECK(is_packed("\xd0\xcf\x11\xe0"));
  CHECK_FALSE(is_packed("Position,Force\n"));
  CHECK_FALSE(is_packed("PK"));
  CHECK_FALSE(is_packed(""));
}
