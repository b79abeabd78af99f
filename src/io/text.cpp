#include "io/text.h"

namespace flexslip {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string_view without_brackets(std::string_view text) {
  const bool bracketed =
      text.size() > 1 && ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']'));
  return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

}  // namespace flexslip
