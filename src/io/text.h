// Characters and pieces of text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flexslip {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Text without the spaces and tabs around it.
std::string_view trimmed(std::string_view text);

// The inside of brackets around all of the text, or the text.
std::string_view without_brackets(std::string_view text);

// Text in lower case: ASCII and the letters with accents of Latin-1.
std::string folded(std::string_view text);

// The character that a text begins with.
// Domain:     text that is not empty.
struct Character {
  std::size_t bytes;  // 0 if it is no valid UTF-8
  bool is_control;
};
Character first_character(std::string_view text);

// Text that every format takes: valid UTF-8 without control characters, what is neither replaced by U+FFFD or a space.
std::string printable(std::string_view text);

// Words that no spreadsheet takes for a formula: with a ' before those that begin with = + - or @, also after others of '.
std::string without_formula(std::string_view words);
// What without_formula was given.
std::string with_formula(std::string words);

// Do two names stand in the order in which people list them, SS2 before SS10? Whole numbers within names count as numbers.
// A strict order: names that differ in leading zeros alone are ordered as text.
bool in_natural_order(std::string_view first, std::string_view second);

// A phrase whose first letter, if it is one of ASCII, is a capital.
std::string capitalised(std::string_view phrase);

// Text with all that stands in it replaced.
std::string replaced(std::string_view text, std::string_view what, std::string_view by);

// Text as it may stand in HTML and SVG, also within double quotes.
std::string html_escaped(std::string_view text);

}  // namespace flexslip
