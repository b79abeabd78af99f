#include "io/sheet_file.h"

#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

using namespace flexslip;

namespace {

// Of make_fixtures.py: notes, and two specimens.
const std::string workbook = FLEXSLIP_SOURCE_DIR "/tests/instruments/fixtures/two_specimens.xlsx";

SheetFile text(const std::string& bytes, SheetFor purpose, const SheetOptions& options = {}) {
  return sheet_in(bytes, "a.csv", options, purpose);
}

}  // namespace

TEST_CASE("sheet file: the separator is that of most numbers, of the titles, or of words") {
  CHECK(text("name\n1,5;2\n", SheetFor::readings).origin.separator == ';');
  CHECK(text("a b\n1,5 250\n", SheetFor::titled_readings).origin.separator == ' ');
  CHECK(text("# x;y;z\n\na\tb\n1;2\n", SheetFor::titled_readings).origin.separator == '\t');
  CHECK(text("first name\nA. B.\n", SheetFor::words).origin.separator == ',');
  CHECK(text("a;b\n1;2\n", SheetFor::readings, {.separator = ','}).cells.cells(0).size() == 1);
}

TEST_CASE("sheet file: commas that separate cells and decimals alike (table)") {
  const std::string titles = "Time (s),Force (N)\n";
  const auto read = [](const std::string& text) { return sheet_in(text, "e.csv", {}, SheetFor::readings); };
  const SheetFile file = read("Test of a beam, 3\n" + titles + "0,0,-0,019\n0,5,1,469\n1,0,2,956\n");
  REQUIRE(file.notes.size() == 1);
  CHECK(file.cells.at(1, 1) == "Force (N)");
  CHECK(file.cells.at(2, 1) == "-0,019");
  CHECK(file.cells.cells(3).size() == 2);
  const auto refused = [&](const std::string& rows) { return message_of([&] { read(titles + rows); }); };
  const char* of_three = "e.csv:2: Commas separate cells and decimals alike: 2 titles above rows of 3 whole";
  CHECK(refused("0,0,019\n1,1,469\n2,2,956\n").starts_with(of_three));
  CHECK(refused("0,0,0,019\n1,1,469\n1,5,2,956\n").find("rows of 3 to 4 whole") != std::string::npos);
  CHECK(read(titles + "1,0,19\n2,5,20\n").notes.empty());        // numbers of rows, and whole numbers
  CHECK(read("a,b,c,d\n0,0,0,019\n0,5,1,469\n").notes.empty());  // as many as titles
  CHECK(read(titles + "0.5,0.019\n1.5,1.469\n").notes.empty());
}

TEST_CASE("sheet file: formulas that are but words, and files that are no text (table)") {
  const auto read = [](const std::string& text) { return sheet_in(text, "e.csv", {}, SheetFor::readings); };
  const SheetFile file = read("\"=\"\"t\"\"\",F\n=\"0.5\",=\"-1,5\"\n\"=\"\"1.0\"\"\",=\"2.5\"\n");
  CHECK(file.cells.at(0, 0) == "t");
  CHECK(file.cells.at(1, 0) == "0.5");
  CHECK(file.cells.at(1, 1) == "-1,5");
  CHECK(file.cells.at(2, 0) == "1.0");
  CHECK(message_of([&] { read("\x1f\x8b\x08 packed"); }).find(".zs2") != std::string::npos);
  CHECK(message_of([&] { read("\n<html><table>"); }).find("HTML or XML") != std::string::npos);
}

TEST_CASE("sheet file: where it comes from") {
  const SheetFile file = text(
      "\xEF\xBB\xBF"
      "a,b\n1,2\n",
      SheetFor::titled_readings);
  CHECK(file.origin.source == "a.csv");
  CHECK(file.origin.encoding == Encoding::utf8);
  CHECK(file.origin.byte_order_mark);
  CHECK(file.cells.size() == 2);
  const TemporaryFolder folder;
  CHECK(open_sheet(folder.file("b.csv", "a\n1\n"), {}, SheetFor::readings).cells.at(1, 0) == "1");
  const SheetFile book = open_sheet(workbook, {}, SheetFor::titled_readings);
  CHECK(book.origin.sheet == "Specimen 1");
  CHECK_FALSE(book.origin.sheet_is_chosen);
  CHECK_FALSE(book.origin.has_delimiters);
  CHECK(book.notes.size() == 1);
  CHECK(open_sheet(workbook, {.sheet = "Specimen 2"}, SheetFor::words).origin.sheet_is_chosen);
}

TEST_CASE("sheet file: choices that a file does not have are refused") {
  CHECK(message_of([] { text("a\n1\n", SheetFor::readings, {.sheet = "Data"}); }) ==
        "a.csv: --sheet: The file is a text file, which has no sheets. Leave it out.");
  CHECK(has(message_of([] { text("a\n1\n", SheetFor::readings, {.separator = '|'}); }),
            "a.csv: separator: '|' is not a comma"));
  CHECK(has(message_of([] { open_sheet(workbook, {.encoding = Encoding::utf8}, SheetFor::readings); }),
            "--encoding: The file is a workbook, which needs no such choice. Leave out --encoding"));
}

TEST_CASE("sheet file: an error in a sheet that nobody chose names the others, but for one in a cell") {
  SheetOrigin origin{.source = "a.xlsx", .sheet = "Notes", .sheets = {"Notes", "Data", "More"}};
  const InputError error({.file = "a.xlsx", .problem = "The rows hold words"});
  CHECK(with_other_sheets(error, origin).fault.remedy ==
        "this is the sheet 'Notes', and there are also 'Data' and 'More': read another with --sheet \"Data\"");
  const InputError in_cell({.file = "a.xlsx", .problem = "'x' is not a number", .part = TablePart::cell});
  CHECK(with_other_sheets(in_cell, origin).fault.remedy.empty());
  origin.sheet_is_chosen = true;
  CHECK(with_other_sheets(error, origin).fault.remedy.empty());

  Sheet cells;
  cells.append(2, std::vector<SheetCell>{{"1"}, {"46054", CellKind::date}});
  CHECK(dated({{.source = "a.xlsx", .sheet = "Data"}, std::move(cells), {}}, 2, 1, "a number").what() ==
        std::string("a.xlsx:3: sheet 'Data', cell B3: The cell holds the date 2026-02-01, not a number. Format the "
                    "cell as a number and type it again, or delete the row."));
}
