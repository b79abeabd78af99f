#include "case/toml.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

// Restricts a text to the tokens of case files: words, plain numbers, quoted texts on one line, = [
// ] { } , and comments. For some other texts, mostly invalid TOML, toml++ 3.3 has undefined
// behaviour or failed assertions, as fuzzing showed: "µ" outside quotes, "[" without a name, "[}",
// "1262-05-7n 3". This also excludes dates and multi-line strings, which case files do not need.
class TokenCheck {
 public:
  TokenCheck(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  void run() {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    at_ = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
        if (in_header_) open_.clear();  // TOML refuses an unclosed bracket
        in_header_ = false;
        line_is_blank_ = true;
        ++at_;
      } else if (blanks.find(c) != std::string_view::npos) {
        ++at_;
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        take_token(c);
        line_is_blank_ = false;
      }
    }
  }

 private:
  static constexpr std::string_view blanks = " \t\r";
  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+.";

  [[noreturn]] void refuse(std::string problem) const {
    throw InputError({.file = source_, .line = line_, .problem = std::move(problem)});
  }

  std::string_view text_to_blank() const { return text_.substr(at_, text_.find_first_of(" =\r\n", at_) - at_); }

  char next_after(std::size_t at) const {
    const std::size_t next = text_.find_first_not_of(" \t", at);
    return next < text_.size() ? text_[next] : '\n';
  }

  void take_token(char c) {
    if (c == '"' || c == '\'')
      take_text(c);
    else if (letters.find(c) != std::string_view::npos)
      take_word();
    else if (std::string_view("=[]{},").find(c) != std::string_view::npos)
      take_mark(c);
    else
      refuse(fmt::format("{} stands outside quotes and is not in plain letters", in_quotes(text_to_blank())));
  }

  void take_text(char quote) {
    if (at_ > 0 && std::string_view(" \t\r\n=[{,").find(text_[at_ - 1]) == std::string_view::npos)
      refuse("A quote is in the middle of a text");
    if (text_.substr(at_, 3) == std::string(3, quote)) refuse("A text in quotes must stand on one line");
    for (++at_; at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n'; ++at_)
      if (quote == '"' && text_[at_] == '\\') ++at_;
    if (at_ >= text_.size() || text_[at_] == '\n') refuse("A text has no closing quote on its line");
    last_ = text_[at_++];
  }

  void take_word() {
    const std::size_t end = std::min(text_.find_first_not_of(letters, at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    constexpr std::ptrdiff_t max_parts = 16;  // a key with thousands of parts overflows the stack of the parser
    if (std::count(word.begin(), word.end(), '.') >= max_parts) refuse("The key has too many parts");
    const bool is_key = next_after(end) == '=' && last_ != '=' && (open_.empty() || open_.back() == '{');
    const bool is_whole =
        end == text_.size() || std::string_view(" \t\r\n,]}#").find(text_[end]) != std::string_view::npos;
    if (!is_key && !in_header_ && line_is_blank_ && open_.empty())
      refuse(fmt::format("{} is neither a [section] nor key = value in plain letters", in_quotes(text_to_blank())));
    if (!is_key && !in_header_ && !(is_value(word) && is_whole))
      refuse(fmt::format("{} is not a number, true, false or text in quotes", in_quotes(text_to_blank())));
    last_ = word.back();
    at_ = end;
  }

  static bool is_value(std::string_view word) {
    if (word == "true" || word == "false") return true;
    if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
    if (word == "inf" || word == "nan") return true;
    const std::size_t sign = word.find_first_of("+-");  // of the exponent, otherwise it is a date
    const bool has_odd_sign = sign != std::string_view::npos && word.find_first_of("eE") + 1 != sign;
    return word.find_first_of("0123456789") == 0 && !has_odd_sign &&
           word.find_first_not_of("0123456789.eE+-_") == std::string_view::npos;
  }

  void take_mark(char c) {
    if (c == '[' && line_is_blank_ && open_.empty()) {
      const char first = next_after(text_.substr(at_ + 1, 1) == "[" ? at_ + 2 : at_ + 1);
      in_header_ = true;
      if (first != '"' && first != '\'' && letters.substr(0, letters.size() - 2).find(first) == std::string_view::npos)
        refuse("The name of a section is missing after [");
    }
    if (c == '=' && (line_is_blank_ || std::string_view("=[{,").find(last_) != std::string_view::npos))
      refuse("The key is missing before =");
    if (c == '}' && (last_ == '[' || last_ == ',')) refuse("A value is missing before }");
    if (c == '[' || c == '{') open_ += c;
    if ((c == ']' || c == '}') && !open_.empty()) open_.pop_back();
    last_ = c;
    ++at_;
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool line_is_blank_ = true;
  bool in_header_ = false;
  std::string open_;  // open brackets
  char last_ = '\n';  // last character of the tokens
};

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& source) {
  if (text.find('\0') != std::string_view::npos)
    throw InputError({.file = source, .problem = "The file holds binary data (a NUL byte) and is no case file (TOML)"});
  TokenCheck(text, source).run();
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    const std::string description(error.description());
    throw InputError({.file = source,
                      .line = error.source().begin.line,
                      .problem = fmt::format("The file is no case file (TOML): {}", description)});
  }
}

std::optional<std::pair<std::string, std::string>> value_and_uncertainty(std::string_view text) {
  for (const std::string_view between : {"±", "+-", "+/-"}) {
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos) continue;
    std::pair both{std::string(trimmed(text.substr(0, at))), std::string(trimmed(text.substr(at + between.size())))};
    const auto unit = [](const std::string& of) {
      return std::string(trimmed(of.substr(std::min(of.find_last_of("0123456789.") + 1, of.size()))));
    };
    const std::string of_value = unit(both.first), of_uncertainty = unit(both.second);
    if (of_value.empty() && of_uncertainty != "%" && !of_uncertainty.empty()) both.first += " " + of_uncertainty;
    if (of_uncertainty.empty() && !of_value.empty()) both.second += " " + of_value;
    return both;
  }
  return std::nullopt;
}

toml::table& table_at(toml::table& parent, std::string_view name) {
  if (!parent[name].is_table()) {
    toml::table table;
    if (const toml::node* value = parent.get(name)) {
      const auto both = value_and_uncertainty(value->value<std::string_view>().value_or(""));
      if (both)
        table.insert_or_assign("value", both->first);  // replaces the uncertainty in the text
      else
        table.insert_or_assign("value", *value);
    }
    parent.insert_or_assign(name, std::move(table));
  }
  return *parent[name].as_table();
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += byte < 0x20 || byte == 0x7f ? fmt::format("\\u{:04x}", byte) : std::string(1, c);
  }
  return quoted + '"';
}

}  // namespace flexslip
