#include "report/fit_text.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "report/cycles_words.h"
#include "report/fit_words.h"
#include "report/teeth_words.h"

namespace flexslip {
namespace {

constexpr std::size_t line_length = 100;

// Characters, not bytes.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string padded(std::string_view text, std::size_t width, bool to_the_right) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return to_the_right ? space + std::string(text) : std::string(text) + space;
}

// Breaks a text at spaces; lines after the first begin with the indent.
std::string wrapped(std::string_view text, std::string_view indent) {
  std::string out;
  std::size_t length = 0;
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, space);
    text.remove_prefix(std::min(space + 1, text.size()));
    if (length > 0 && length + 1 + width_of(word) > line_length) {
      out += fmt::format("\n{}", indent);
      length = width_of(indent);
    } else if (length > 0) {
      out += ' ';
      ++length;
    }
    out += word;
    length += width_of(word);
  }
  return out + '\n';
}

std::string laid_out(const PrintedTable& table) {
  std::vector<std::size_t> widths;
  for (const auto& title : table.head) widths.push_back(width_of(title));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string out;
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text = " ";
    for (std::size_t i = 0; i < cells.size(); ++i) text += fmt::format("  {}", padded(cells[i], widths[i], i > 0));
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + '\n';
  };
  line(table.head);
  for (const auto& row : table.rows) line(row);
  return out;
}

std::string variables(const FittedTest& test) {
  PrintedTable table{{"", "value", "95 % interval", "remark"}, {}};
  for (const auto& row : parameter_rows(test)) table.rows.push_back({row.name, row.value, row.interval, row.remark});
  std::vector<std::size_t> widths(3);
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < 3; ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string out;
  for (const auto& row : table.rows) {
    std::string line =
        fmt::format("   {}  {}  [{}]", padded(row[0], widths[0], false), padded(row[1], widths[1], false), row[2]);
    if (!row[3].empty()) line += fmt::format("{}  {}", std::string(widths[2] - width_of(row[2]), ' '), row[3]);
    out += line + '\n';
  }
  return out;
}

}  // namespace

std::string fit_text(const FittedTest& test) {
  std::string text = wrapped(fmt::format("{}: {}", test.name, answer_of(test)), "");
  if (test.analysis.status != AnalysisStatus::ok) return text;
  const std::string indent(3, ' ');
  const auto paragraph = [&](const std::string& words) { text += indent + wrapped(words, indent); };
  text += "\n[[Models]]\n" + laid_out(model_table(test));
  text += fmt::format("\n[[Variables]] of the model '{}'\n{}", name_of(chosen_model(test).model), variables(test));
  text += "\n[[Slips]]\n";
  paragraph(slips_in_words(test));
  if (!test.analysis.drops.drops.empty()) text += laid_out(drop_table(test));
  text += "\n[[Stick or slide]]\n";
  paragraph(teeth_in_words(test));
  if (const auto table = tooth_table(test); !table.rows.empty()) text += laid_out(table);
  if (test.cycles) {
    text += "\n[[Load and unload]]\n";
    for (const auto& words : cycles_in_words(test)) paragraph(words);
    if (const auto table = loop_table(test); !table.rows.empty())
      text += laid_out(table) + laid_out(loop_energy_table(test));
    paragraph(reloading_in_words(test));
    text += laid_out(loading_table(test));
  }
  text += fmt::format("\n[[Energy]]{}\n", test.cycles ? " of the first loading" : "") + laid_out(energy_table(test));
  text += "\n[[Plausibility]]\n";
  paragraph(friction_in_literature(test));
  paragraph(suspicion_in_words(test));
  paragraph(replay_in_words(test));
  text += "\n[[Assumed]]\n";
  for (const auto& sentence : assumptions_of(test)) text += " - " + wrapped(sentence, indent);
  return text;
}

}  // namespace flexslip
