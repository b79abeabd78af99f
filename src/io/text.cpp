#include "io/text.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace flexslip {
namespace {

bool is_like_formula(std::string_view words) {
  const std::size_t first = words.find_first_not_of('\'');
  return first != std::string_view::npos && std::string_view("=+-@").find(words[first]) != std::string_view::npos;
}

// Takes the leading digits off a text and returns them without leading zeros.
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

std::string folded(std::string_view text) {
  std::string out(text);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto byte = static_cast<unsigned char>(out[i]);
    if (byte < 0x80) out[i] = static_cast<char>(std::tolower(byte));
    const bool latin_capital = i > 0 && static_cast<unsigned char>(out[i - 1]) == 0xc3 && byte >= 0x80 && byte <= 0x9e;
    if (latin_capital && byte != 0x97) out[i] = static_cast<char>(byte + 0x20);  // 0x97 is the multiplication sign
  }
  return out;
}

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length > text.size()) return {0, false};
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return {0, false};
  if (length < 3) return {length, first < ' ' || first == 0x7f || (first == 0xc2 && byte(1) < 0xa0)};
  const unsigned char second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90) ||
                            (first == 0xef && second == 0xbf && byte(2) >= 0xbe);
  return {overlong || no_character ? 0 : length, false};
}

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const auto [bytes, is_control] = first_character(text);
    out += bytes == 0 ? "\ufffd" : is_control ? " " : text.substr(0, bytes);
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return out;
}

std::string without_formula(std::string_view words) {
  std::string out(words);
  if (is_like_formula(words)) out.insert(out.begin(), '\'');
  return out;
}

std::string with_formula(std::string words) {
  if (words.starts_with('\'') && is_like_formula(words)) words.erase(0, 1);
  return words;
}

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

std::string capitalised(std::string_view phrase) {
  std::string text(phrase);
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string replaced(std::string_view text, std::string_view what, std::string_view by) {
  std::string out;
  for (auto at = text.find(what); at != std::string_view::npos; at = text.find(what)) {
    out.append(text.substr(0, at)).append(by);
    text.remove_prefix(at + what.size());
  }
  return out.append(text);
}

std::string html_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const auto [bytes, is_control] = first_character(text);
    const char c = text.front();
    if (bytes == 0)
      out += "\ufffd";
    else if (is_control && c != '\n' && c != '\t')
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[bytes - 1]));
    else if (c == '&' || c == '<' || c == '>' || c == '"')
      out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&quot;";
    else
      out += text.substr(0, bytes);
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return out;
}

}  // namespace flexslip
