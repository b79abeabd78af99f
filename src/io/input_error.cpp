#include "io/input_error.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t longest_quote = 60;        // [bytes] a message stays one readable line
constexpr std::size_t longest_list = 12;         // names
constexpr std::size_t longest_likely_name = 64;  // [bytes] longer words are not names that someone mistyped

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

// The text with \xNN for each byte that cannot be shown.
std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto [bytes, is_control] = first_character(text);
    const bool is_shown = bytes > 0 && !is_control;
    out += is_shown ? std::string(text.substr(0, bytes))
                    : fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    text.remove_prefix(is_shown ? bytes : 1);
  }
  return out;
}

// True if the text ends with what a user copies: a flag, or the unquoted value of a flag or key.
bool ends_with_bare_value(std::string_view text) {
  const auto cut_word = [&text] {
    const std::size_t space = text.rfind(' ');
    const std::string_view word = text.substr(space + 1);  // all of it without a space
    text = text.substr(0, space == std::string_view::npos ? 0 : space);
    return word;
  };
  const std::string_view last = cut_word(), before = cut_word();
  if (last.ends_with('"') || last.ends_with('\'')) return false;
  return last.starts_with("--") || last.find('=') != std::string_view::npos || before.starts_with("--") ||
         before == "=";
}

std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

// The text as a sentence: with a capital letter, and with a full stop unless it ends in another
// mark or in a value to copy.
std::string as_sentence(std::string_view text) {
  std::string out = capitalised(text);
  const bool has_mark = std::string_view(".,:;?!").find(out.back()) != std::string_view::npos;
  return has_mark ? out : out + ".";
}

// "ss14.csv:17: column 'F_N': '12,5' is not a number. Write decimal points, or pass --decimal ,"
std::string sentence(const InputFault& fault) {
  std::string text = fault.file;
  if (fault.line > 0) text += fmt::format("{}{}", fault.file.empty() ? "line " : ":", fault.line);
  if (!text.empty()) text += ": ";
  if (!fault.field.empty()) text += fault.field + ": ";
  if (!fault.problem.empty()) text += as_sentence(fault.problem);
  text = escaped(text);
  std::size_t width = 0;
  for (const MissingInput& each : fault.asks) width = std::max(width, characters_in(each.instruction));
  for (const MissingInput& each : fault.asks)
    text += fmt::format("\n  {}{}  {}", escaped(each.instruction),
                        std::string(width - characters_in(each.instruction), ' '), escaped(capitalised(each.question)));
  if (!fault.remedy.empty())
    text += (fault.asks.empty() ? " " : "\n") +
            escaped(ends_with_bare_value(fault.remedy) ? capitalised(fault.remedy) : as_sentence(fault.remedy));
  return text;
}

char lower_case(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// The number of insertions, deletions, substitutions and swaps of neighbours between two words.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_ago(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_ago = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower_case(a[i - 1]) == lower_case(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower_case(a[i - 1]) == lower_case(b[j - 2]) &&
                           lower_case(a[i - 2]) == lower_case(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], two_ago[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

InputError::InputError(InputFault what_is_wrong) : InputError(std::move(what_is_wrong), {}) {}

InputError::InputError(InputFault what_is_wrong, std::vector<InputFault> also_wrong)
    : std::runtime_error(sentence(what_is_wrong)), fault(std::move(what_is_wrong)), also(std::move(also_wrong)) {}

std::vector<std::string> InputError::lines() const {
  std::vector<std::string> lines{what()};
  for (const InputFault& other : also) lines.push_back(sentence(other));
  return lines;
}

void Faults::raise() const {
  if (faults_.empty()) return;
  std::vector<InputFault> in_order = faults_;
  std::stable_sort(in_order.begin(), in_order.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
  throw InputError(in_order.front(), {in_order.begin() + 1, in_order.end()});
}

void Faults::add(const InputError& error) {
  faults_.push_back(error.fault);
  faults_.insert(faults_.end(), error.also.begin(), error.also.end());
}

bool is_of_call(const InputFault& fault) { return fault.field.starts_with("--") && fault.key.empty(); }

InputError unreadable(std::string file, std::string_view reason) {
  return InputError({.file = std::move(file), .problem = fmt::format("The file cannot be read: {}", reason)});
}

InputError unwritable(std::string file, std::string_view reason) {
  return InputError({.file = std::move(file), .problem = fmt::format("The file cannot be written: {}", reason)});
}

InputError located(const InputError& error, std::string_view file, std::size_t line, std::string_view field) {
  InputFault fault = error.fault;
  fault.file = file;
  fault.line = line;
  fault.field = field;
  return InputError(std::move(fault));
}

std::string in_quotes(std::string_view text) {
  if (text.size() <= longest_quote) return fmt::format("'{}'", escaped(text));
  std::size_t length = longest_quote;
  while (length > longest_quote - 3 && continues_character(text[length])) --length;  // cut between characters
  return fmt::format("'{}…'", escaped(text.substr(0, length)));
}

std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), longest_list);
  const std::size_t hidden = names.size() - shown;
  std::string out;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) out += i + 1 == names.size() ? " and " : ", ";
    out += in_quotes(names[i]);
  }
  return hidden == 0 ? out : out + fmt::format(" and {} more", hidden);
}

std::string on_lines(std::span<const std::size_t> lines) {
  constexpr std::size_t shown = 3;  // a longer list would hide the message
  if (lines.size() == 1) return fmt::format("line {}", lines.front());
  if (lines.size() > 2 && lines.back() - lines.front() + 1 == lines.size())
    return fmt::format("lines {} to {}", lines.front(), lines.back());
  std::string out = "lines ";
  for (std::size_t i = 0; i < std::min(lines.size(), shown); ++i)
    out += fmt::format("{}{}", i > 0 ? ", " : "", lines[i]);
  return lines.size() > shown ? out + fmt::format(" and {} more", lines.size() - shown) : out;
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.size() > longest_likely_name) return "";
  std::string best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.empty() || candidate.size() > longest_likely_name) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= least || distance >= std::max(word.size(), candidate.size())) continue;
    least = distance;
    best = candidate;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates, std::string otherwise) {
  const std::string meant = nearest(word, candidates);
  return meant.empty() ? otherwise : fmt::format("did you mean {}?", in_quotes(meant));
}

}  // namespace flexslip
