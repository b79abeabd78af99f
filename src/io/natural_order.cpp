#include "io/natural_order.h"

#include <cstddef>

#include "io/text.h"

namespace flexslip {
namespace {

// The digits that a text begins with, without leading zeros; the text goes on after them.
std::string_view number_at_front(std::string_view& text) {
  std::size_t zeros = 0;
  while (zeros + 1 < text.size() && text[zeros] == '0' && is_digit(text[zeros + 1])) ++zeros;
  std::size_t end = zeros;
  while (end < text.size() && is_digit(text[end])) ++end;
  const std::string_view digits = text.substr(zeros, end - zeros);
  text.remove_prefix(end);
  return digits;
}

}  // namespace

bool in_natural_order(std::string_view first, std::string_view second) {
  std::string_view a = first, b = second;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = number_at_front(a), y = number_at_front(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a.front() != b.front()) return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.empty() && b.empty() ? first < second : a.empty();
}

}  // namespace flexslip
