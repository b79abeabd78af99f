// Characters and pieces of text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flexslip {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Text without the spaces and tabs around it.
std::string_view trimmed(std::string_view text);

// Text without the brackets around all of it.
std::string_view without_brackets(std::string_view text);

// Text in lower case: ASCII and the letters with accents of Latin-1.
std::string folded(std::string_view text);

// The first character of a text.
// Domain:     a text that is not empty.
struct Character {
  std::size_t bytes;  // 0 for invalid UTF-8
  bool is_control;
};
Character first_character(std::string_view text);

// Text for any output format: U+FFFD replaces invalid UTF-8, and a space replaces control
// characters.
std::string printable(std::string_view text);

// Words that no spreadsheet takes for a formula: a ' is put before = + - and @ at the beginning,
// also after other '.
std::string without_formula(std::string_view words);
// The inverse of without_formula.
std::string with_formula(std::string words);

// True if the first name comes before the second in natural order: SS2 before SS10. A strict order;
// names that differ only in leading zeros are ordered as text.
bool in_natural_order(std::string_view first, std::string_view second);

// A phrase with its first letter as a capital, if the letter is ASCII.
std::string capitalised(std::string_view phrase);

// Text with every occurrence replaced.
std::string replaced(std::string_view text, std::string_view what, std::string_view by);

// Text escaped for HTML and SVG, also inside double quotes. Control characters other than line
// breaks and tabs, which neither format allows, become "\x1b"; U+FFFD replaces invalid UTF-8.
std::string html_escaped(std::string_view text);

}  // namespace flexslip
