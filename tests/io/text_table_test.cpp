#include "io/text_table.h"

#include <doctest/doctest.h>

#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

TEST_CASE("table: words, quotes, comments, a mark of byte order, rows shorter than the header") {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "table.csv",
      "\xEF\xBB\xBF# kept by hand\nname;span [um];note\r\n\"a;b\";1278;\"he said \"\"no\"\"\"\n\n# b;1;2\nc\n");
  const auto table = read_text_table(file);
  CHECK(table.titles == std::vector<std::string>{"name", "span [um]", "note"});
  CHECK(table.header_line == 2);
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].line == 3);
  CHECK(table.rows[0].cells == std::vector<std::string>{"a;b", "1278", "he said \"no\""});
  CHECK(table.rows[1].line == 6);
  CHECK(table.rows[1].cells == std::vector<std::string>{"c", "", ""});
}

TEST_CASE("identity: words are read back as they were, and no spreadsheet takes them for a formula") {
  const TemporaryFolder folder;
  for (const std::string words : {"=cmd", "+1", "-1", "@x", "'=cmd", "''-1", "=", "'", "''", "'a", "a=b", "1", ""}) {
    INFO(words);
    const std::string written = without_formula(words);
    CHECK((written.empty() || std::string("=+-@").find(written.front()) == std::string::npos));
    CHECK(read_text_table(folder.file("table.csv", "name,end\n" + written + ",x\n")).rows.front().cells.front() ==
          words);
  }
  CHECK(without_formula("=cmd") == "'=cmd");
  CHECK(without_formula("SS14") == "SS14");
  CHECK(read_text_table(folder.file("table.csv", "a,b\n-1,+2.5 mm\n")).rows.front().cells ==
        std::vector<std::string>{"-1", "+2.5 mm"});
}

TEST_CASE("table: what is no such table is refused with its line") {
  const auto says = [](const std::string& content) {
    const TemporaryFolder folder;
    return message_of([&] { read_text_table(folder.file("table.csv", content)); });
  };
  CHECK(says("").find("an empty file") != std::string::npos);
  CHECK(says("a,b\n1,2,3\n").find(":2: expected 2 cells") != std::string::npos);
  CHECK(says("a,a\n").find(":1: expected each title once, found 'a' twice") != std::string::npos);
  CHECK(says("a,,b\n").find("an empty one") != std::string::npos);
  CHECK(says("a,b\n\"x,y\n").find(":2: expected quotes in pairs") != std::string::npos);
}

}  // namespace
TEST_CASE("table: text that every format takes (Unicode 15, table 3-7)") {
  CHECK(printable("ü µ 力 𝄞") == "ü µ 力 𝄞");
  CHECK(printable("a\tb\nc\x7f") == "a b c ");
  CHECK(printable("\xfc") == "\ufffd");                      // Latin-1
  CHECK(printable("\xc0\xaf") == "\ufffd\ufffd");            // overlong
  CHECK(printable("\xed\xa0\x80") == "\ufffd\ufffd\ufffd");  // a surrogate
  CHECK(printable("\xe2\x82") == "\ufffd\ufffd");            // cut off
  CHECK(printable("\xf5\x80\x80\x80") == "\ufffd\ufffd\ufffd\ufffd");
  CHECK(printable("\xef\xbf\xbf") == "\ufffd\ufffd\ufffd");  // U+FFFF, which XML refuses
  CHECK(printable("\xc2\x85") == " ");                       // a control character beyond ASCII
}

}  // namespace flexslip
