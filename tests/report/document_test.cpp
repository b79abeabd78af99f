#include "report/document.h"

#include <doctest/doctest.h>

#include "report/plain_text.h"
#include "tests/has.h"

using namespace flexslip;

namespace {

std::vector<Chapter> small_document() {
  Chapter first{""};
  first.show(Picture{[] {
    Plot plot{};
    plot.caption = "A caption.";
    return plot;
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
  const std::string html = in_html(small_document(), [](const Plot& plot) { return "(" + plot.caption + ")"; });
  for (const char* part : {"(A caption.)<h2>Friction &amp; wear</h2>", "<p>It is \u22120.5.</p>", "<th>Fall</th>",
                           "<td>0.2</td>", "<li>one</li>\n<li>a &lt; b</li>", "<pre>[rig]\n\nspan = '1 mm'\n</pre>"})
    CHECK(has(html, part));
  CHECK_FALSE(has(html, "none"));
}

TEST_CASE("by hand: rows of parameters, of steps and of files in both layouts") {
  Chapter chapter{"All"};
  chapter
      .show(std::vector<ParameterRow>{{"mu0", "μ₀", "mean friction", "0.50 ± 0.01", "0.48 to 0.52", ""},
                                      {"drift", "", "along it", "-1", "", "held"}})
      .show(std::vector<PreparationRow>{{"zero", "the force counts from there", "-3 mN", "1 to 40", "[record] zero"}})
      .show(Files{{{"run -2.csv", 12, "ab"}, {"-", 0, ""}}});
  CHECK(in_text({chapter}) ==
        "\n[[All]]\n   mu0    0.50 ± 0.01  [0.48 to 0.52]\n   drift  -1                           held\n - zero: the "
        "force "
        "counts from there (-3 mN; rows 1 to 40); to change this: [record] zero\n" +
            laid_out({{"File", "Bytes", "SHA-256"}, {{"run -2.csv", "12", "ab"}, {"-", "", ""}}}));
  const std::string html = in_html({chapter}, [](const Plot&) { return ""; });
  for (const char* part :
       {"<td>μ₀</td><td><code>mu0</code>, mean friction</td><td class=\"value\">0.50 ± 0.01</td>", "\u22121</td>",
        "<td class=\"value\">\u22123 mN</td><td class=\"value\">1 to 40</td><td><code>[record] zero</code></td>",
        "<td>run -2.csv</td><td>12</td><td><code>ab</code></td>"})
    CHECK_MESSAGE(has(html, part), part, " in ", html);
}
