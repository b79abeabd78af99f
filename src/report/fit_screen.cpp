#include "report/fit_screen.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "finding/printed.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t label_width = 13;
constexpr std::size_t most_doubts = 3;

// Words beside a label, in lines of their own.
std::string row_of_screen(std::string_view label, const std::string& words, std::size_t width) {
  const std::string begin = fmt::format("  {}   ", padded_right(label, label_width));
  return wrapped(words, std::string(width_of(begin), ' '), begin, width);
}

std::string_view colour_of(VerdictCode code) {
  switch (code) {
    case VerdictCode::slip:
    case VerdictCode::no_drops:
      return "\x1b[1;32m";
    case VerdictCode::undecided:
      return "\x1b[1;33m";
    default:
      return "\x1b[1;31m";
  }
}

std::string coloured(std::string line, const std::string& name, const Verdict& verdict) {
  constexpr std::string_view bold = "\x1b[1m", plain = "\x1b[0m";
  const std::string_view word = word_of(verdict.code);
  if (const auto at = line.find(word, name.size()); at != std::string::npos)
    line.replace(at, word.size(), fmt::format("{}{}{}", colour_of(verdict.code), word, plain));
  return fmt::format("{}{}{}{}", bold, name, plain, line.substr(name.size()));
}

}  // namespace

std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style) {
  const std::string shown = printable(name);
  const std::string begin = fmt::format("{}  {}   ", shown, word_of(answer.verdict.code));
  const std::string title = wrapped(fmt::format("{}", fmt::join(answer.verdict.parts, " · ")),
                                    std::string(std::min<std::size_t>(width_of(begin), 12), ' '), begin, style.width);
  std::string text = (style.colour ? coloured(title, shown, answer.verdict) : title) + "\n";
  for (const auto& [label, words] : answer.rows) text += row_of_screen(label, words, style.width);

  const std::vector<Finding> doubts = doubts_of(answer);
  for (std::size_t i = 0; i < std::min(doubts.size(), most_doubts); ++i)
    text += row_of_screen(i == 0 ? (doubts.size() == 1 ? "doubt" : "doubts") : "",
                          doubts[i].sentence + (doubts[i].remedy.empty() ? "" : " " + doubts[i].remedy), style.width);
  std::string last = checks_in_words(answer);
  if (doubts.size() > most_doubts)
    last += fmt::format("{}{}: --full.", last.empty() ? "" : " ",
                        counted(doubts.size() - most_doubts, "more doubt", "more doubts"));
  if (const std::string next = next_in_words(answer); !next.empty()) last += (last.empty() ? "" : " ") + next;
  if (!last.empty()) text += wrapped(last, "", "", style.width);
  return text;
}

}  // namespace flexslip
