// Characters and pieces of text.
#pragma once

#include <string>
#include <string_view>

namespace flexslip {

bool is_digit(char c);  // 0 to 9

// Text without the spaces and tabs around it.
std::string_view trimmed(std::string_view text);

// The inside of brackets around all of the text, or the text.
std::string_view without_brackets(std::string_view text);

// Text in lower case: ASCII and the letters with accents of Latin-1.
std::string folded(std::string_view text);

// Text as it may stand in HTML and SVG, also within double quotes.
std::string html_escaped(std::string_view text);

}  // namespace flexslip
