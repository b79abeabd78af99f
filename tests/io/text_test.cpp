#include "io/text.h"

#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <rapidcheck.h>

namespace flexslip {

TEST_CASE("text: spaces and brackets around it (table)") {
  CHECK(trimmed(" \t w_s [m]\t ") == "w_s [m]");
  CHECK(trimmed(" \t ").empty());
  CHECK(trimmed("a\nb ") == "a\nb");
  for (const auto text : {"[mm]", "(mm)", "mm"}) CHECK(without_brackets(text) == "mm");
  CHECK(without_brackets("a [mm]") == "a [mm]");
  CHECK(without_brackets("[mm") == "[mm");
  CHECK(without_brackets("").empty());
}

TEST_CASE("text: what HTML reads as its own is escaped, also within double quotes (table)") {
  CHECK(html_escaped("a < b & \"c\" > 'd'") == "a &lt; b &amp; &quot;c&quot; &gt; 'd'");
  CHECK(html_escaped("μ₀ &amp;") == "μ₀ &amp;amp;");
  CHECK(html_escaped("a\x1b[1m\x07\tb\n\xc2\x85\xff") == "a\\x1b[1m\\x07\tb\n\\x85\ufffd");
}

TEST_CASE("text: digits are those of numbers, whatever the locale (limit)") {
  for (int c = 0; c < 256; ++c) CHECK(is_digit(static_cast<char>(c)) == (c >= '0' && c <= '9'));
}

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

TEST_CASE("table: numbers in names count as numbers") {
  std::vector<std::string> names{
      "SS10", "SS2", "SS1b", "SS1", "SS02", "a", "SS2_10", "SS2_9", "", "99999999999999999999x", "9x"};
  std::sort(names.begin(), names.end(), in_natural_order);
  CHECK(names == std::vector<std::string>{"", "9x", "99999999999999999999x", "SS1", "SS1b", "SS02", "SS2", "SS2_9",
                                          "SS2_10", "SS10", "a"});
}

TEST_CASE("identity: a strict order of all texts") {
  CHECK(rc::check("one before the other, unless they are the same", [](const std::string& a, const std::string& b) {
    RC_ASSERT(in_natural_order(a, b) + in_natural_order(b, a) == (a != b));
  }));
  CHECK(rc::check("transitive", [] {
    const auto digit_rich = rc::gen::container<std::string>(rc::gen::element('0', '1', '2', 'a'));
    const std::string a = *digit_rich, b = *digit_rich, c = *digit_rich;
    RC_ASSERT(!(in_natural_order(a, b) && in_natural_order(b, c)) || in_natural_order(a, c));
  }));
}

}  // namespace flexslip
