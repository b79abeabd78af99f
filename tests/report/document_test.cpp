#include "report/document.h"

#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "report/page.h"
#include "tests/has.h"

using namespace flexslip;

namespace {

std::vector<Chapter> small_document() {
  PrintedTable numbers{{"Slip", "Fall"}, {{"1", "0.2"}, {"12", "-0.15"}}};
  PrintedTable names{.head = {"Test", "μ", "Doubts"},
                     .rows = {{"a <b>", "0.5", "one doubt; another doubt; a third one, and a fourth"}},
                     .links = {"tests/a%20/report.html"},
                     .is_cut = true};
  return {{"", {Pictures{[](double) { return std::vector<Plot>(1); }}}},
          {"Friction & wear",
           {std::string("It is -0.5."), std::string(), numbers, PrintedTable{{"none"}, {}},
            Rows{{"work", "a < b"}, {"left out", ""}}, Verbatim{"[rig]\n\nspan = '1 mm'\n"}, names,
            AccompanyingFiles{{{"tests.csv", "a row per test"}}}}},
          {"Nothing to say", {std::string(), Rows{{"left out", ""}}}}};
}

}  // namespace

TEST_CASE("by hand: a terminal shows text, rows and tables, but no pictures and no empty parts") {
  CHECK(in_text(small_document(), 40) ==
        "\nFriction & wear\n   It is -0.5.\n\n   Slip   Fall\n   1       0.2\n   12    -0.15\n\n   work            "
        "a < "
        "b\n\n   "
        "Test     μ  Doubts\n   a <b>  0.5  one doubt; another …\n");
}

TEST_CASE("by hand: an empty line separates text from rows if the chapter has no title") {
  CHECK(in_text({{"", {std::string("The answer."), Rows{{"work", "0.2 mJ"}}, std::string("Next: nothing.")}}}) ==
        "The answer.\n\n  work            0.2 mJ\nNext: nothing.\n");
}

TEST_CASE("by hand: a page shows the same with pictures, numbers right-aligned") {
  const std::string html = in_html(small_document(), [] { return std::string("(a figure)"); });
  for (const char* part :
       {"(a figure)<h2>Friction &amp; wear</h2>", "<p>It is \u22120.5.</p>", "<th class=\"n\">Fall</th>",
        "<td>12</td><td class=\"n\">\u22120.15</td>", "<dt>work</dt><dd>a &lt; b</dd>",
        "<pre>[rig]\n\nspan = '1 mm'\n</pre>",
        "<td><a href=\"tests/a%20/report.html\">a &lt;b&gt;</a></td><td class=\"n\">0.5</td><td>one doubt",
        "<dt><a href=\"tests.csv\">tests.csv</a></dt><dd>a row per test</dd>"})
    CHECK_MESSAGE(has(html, part), part, " in ", html);
  for (const char* part : {"none", "left out", "Nothing to say"}) CHECK_FALSE(has(html, part));
}

TEST_CASE("by hand: a table of more than 12 rows is folded, unless it must stay open") {
  PrintedTable table{{"Row"}, {}};
  for (int i = 0; i < 13; ++i) table.rows.push_back({std::to_string(i)});
  const auto html = [&] { return in_html({{"All", {table}}}, {}); };
  CHECK(has(html(), "<details><summary>A table of 13 rows</summary>"));
  table.folding = Folding::never;
  CHECK_FALSE(has(html(), "<details>"));
  table.folding = Folding::of_long;
  table.rows.pop_back();
  CHECK_FALSE(has(html(), "<details>"));
  table.head = {"Row", "What it is"};
  for (auto& row : table.rows) row.emplace_back("a row");
  table.folding = Folding::always;
  CHECK(has(html(), "<details><summary>Row: What it is</summary>"));
}
