#include "report/document.h"

#include <doctest/doctest.h>

#include "report/plain_text.h"
#include "tests/has.h"

using namespace flexslip;

namespace {

std::vector<Chapter> small_document() {
  Chapter first{""};
  first.show(Picture{[] {
    Plate plate{};
    plate.caption = "A caption.";
    return plate;
  }});
  Chapter second{"Friction & wear"};
  second.say("It is -0.5.")
      .say("")
      .show(PrintedTable{{"Slip", "Fall"}, {{"1", "0.2"}}})
      .show(PrintedTable{{"none"}, {}})
      .show(Bullets{{"one", "a < b"}})
      .show(Verbatim{"[rig]\n\nspan = '1 mm'\n"});
  return {first, second};
}

}  // namespace

TEST_CASE("by hand: a terminal shows words, tables and lists, no pictures and no tables without rows") {
  CHECK(in_text(small_document()) == "\n[[Friction & wear]]\n   It is -0.5.\n" +
                                         laid_out({{"Slip", "Fall"}, {{"1", "0.2"}}}) + " - one\n - a < b\n");
}

TEST_CASE("by hand: a page shows the same and the pictures") {
  const std::string html = in_html(small_document(), [](const Plate& plate) { return "(" + plate.caption + ")"; });
  for (const char* part : {"(A caption.)<h2>Friction &amp; wear</h2>", "<p>It is \u22120.5.</p>", "<th>Fall</th>",
                           "<td>0.2</td>", "<li>one</li>\n<li>a &lt; b</li>", "<pre>[rig]\n\nspan = '1 mm'\n</pre>"})
    CHECK(has(html, part));
  CHECK_FALSE(has(html, "none"));
}
