#include "io/text.h"

#include <doctest/doctest.h>

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
}

TEST_CASE("text: digits are those of numbers, whatever the locale (limit)") {
  for (int c = 0; c < 256; ++c) CHECK(is_digit(static_cast<char>(c)) == (c >= '0' && c <= '9'));
}

}  // namespace flexslip
