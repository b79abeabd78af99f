#include "report/document.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "io/text.h"

namespace flexslip {
namespace {

// ---- For a terminal

std::string padded(std::string_view text, std::size_t width, bool to_the_right) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return to_the_right ? space + std::string(text) : std::string(text) + space;
}

// Where the first word ends; a percent sign belongs to its number.
std::size_t end_of_word(std::string_view text) {
  std::size_t end = text.find(' ');
  while (end < text.size() - 1 && text[end + 1] == '%') end = text.find(' ', end + 1);
  return std::min(end, text.size());
}

std::string cut_to(const std::string& line, std::size_t width) {
  if (width_of(line) <= width) return line;
  const std::string begin = wrapped(line, "", "", width - 2);
  return begin.substr(0, begin.find('\n')) + " …";
}

std::string laid_out(const PrintedTable& all, std::size_t width) {
  const PrintedTable table = picked(all, all.on_terminal);
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    widths.push_back(width_of(table.head[i]));
    for (const auto& row : table.rows) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  const std::size_t last = table.head.size() - 1;
  const bool ends_in_words = last > 0 && !is_of_numbers(table, last);
  std::string out;
  const auto add = [&](const std::vector<std::string>& cells) {
    std::string line = " ";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string cell = printable(cells[i]);
      line += "  ";
      // Words at the end of a line go on below it, where there is room for them.
      constexpr std::size_t min_room = 30;
      if (const std::size_t indent = width_of(line);
          i == last && ends_in_words && all.on_terminal.empty() && indent + min_room <= width)
        line = wrapped(cell, std::string(indent, ' '), line, width);
      else
        line += padded(cell, widths[i], is_of_numbers(table, i));
    }
    line.erase(line.find_last_not_of(" \n") + 1);
    out += (all.on_terminal.empty() ? line : cut_to(line, width)) + '\n';
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return out;
}

struct AsText {
  bool has_title;
  std::size_t width;

  std::string operator()(const std::string& words) const {
    const std::string indent(has_title ? 3 : 0, ' ');
    return words.empty() ? "" : wrapped(words, indent, indent, width);
  }
  std::string operator()(const Rows& rows) const {
    // A longer label stands on a line of its own, if its words do not fit beside it.
    constexpr std::size_t usual = 30, margins = 6;
    std::size_t label_width = 13;
    for (const auto& [label, words] : rows)
      if (!words.empty() && (width_of(label) <= usual || width_of(label) + width_of(words) + margins <= width))
        label_width = std::max(label_width, width_of(label));
    const std::string indent(has_title ? 3 : 2, ' ');
    std::string out;
    for (const auto& [label, words] : rows) {
      if (words.empty()) continue;
      const bool is_wide = width_of(label) > label_width;
      if (is_wide) out += indent + label + '\n';
      const std::string begin = fmt::format("{}{}   ", indent, padded(is_wide ? "" : label, label_width, false));
      out += wrapped(printable(words), std::string(width_of(begin), ' '), begin, width);
    }
    return out;
  }
  std::string operator()(const PrintedTable& table) const { return table.rows.empty() ? "" : laid_out(table, width); }
  template <class OnAPageAlone>
  std::string operator()(const OnAPageAlone&) const {
    return "";
  }
};

// Is there an empty line between two blocks? Around tables, and after the answer.
bool are_apart(const Block& above, const Block& below, const Chapter& chapter) {
  const auto is_table = [](const Block& block) { return std::holds_alternative<PrintedTable>(block); };
  return is_table(above) || is_table(below) ||
         (chapter.title.empty() && std::holds_alternative<std::string>(above) && std::holds_alternative<Rows>(below));
}

// ---- For a paper

// Characters that LaTeX takes for more; [ and * are an argument of the row's end before them.
constexpr std::array<std::pair<char, std::string_view>, 15> commands{{{'\\', "\\textbackslash{}"},
                                                                      {'{', "\\{"},
                                                                      {'}', "\\}"},
                                                                      {'$', "\\$"},
                                                                      {'&', "\\&"},
                                                                      {'#', "\\#"},
                                                                      {'_', "\\_"},
                                                                      {'%', "\\%"},
                                                                      {'^', "\\textasciicircum{}"},
                                                                      {'~', "\\textasciitilde{}"},
                                                                      {'<', "\\textless{}"},
                                                                      {'>', "\\textgreater{}"},
                                                                      {'|', "\\textbar{}"},
                                                                      {'[', "{[}"},
                                                                      {'*', "{*}"}}};

// Of our tables, beyond the letters that the fonts of a document have.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> symbols{{{"\"", "''"},
                                                                                 {"μ₀", "$\\mu_0$"},
                                                                                 {"σ", "$\\sigma$"},
                                                                                 {"ℓ", "$\\ell$"},
                                                                                 {"λ", "$\\lambda$"},
                                                                                 {"μ", "$\\mu$"},
                                                                                 {"µ", "$\\mu$"},
                                                                                 {"±", "$\\pm$"},
                                                                                 {"×", "$\\times$"},
                                                                                 {"²", "$^{2}$"},
                                                                                 {"³", "$^{3}$"},
                                                                                 {"⁴", "$^{4}$"},
                                                                                 {"–", "--"},
                                                                                 {"\u00a0", "~"}}};

// A cell of numbers: a hyphen before a digit is a minus sign, and a limit has its sign.
std::string latex_of_numbers(std::string_view cell) {
  constexpr std::string_view limit = "at most ";
  if (cell.starts_with(limit)) return "$\\leq$ " + latex_of_numbers(cell.substr(limit.size()));
  std::string out;
  std::size_t from = 0;
  for (std::size_t i = 0; i + 1 < cell.size(); ++i) {
    const bool begins = i == 0 || cell[i - 1] == ' ' || cell[i - 1] == '(' || cell[i - 1] == '[';
    if (cell[i] != '-' || !begins || !is_digit(cell[i + 1])) continue;
    out += latex_escaped(cell.substr(from, i - from)) + "$-$";
    from = i + 1;
  }
  return out + latex_escaped(cell.substr(from));
}

std::string latex_row(const std::vector<std::string>& cells, std::string_view mark = "") {
  std::string row = latex_escaped(cells.front() + std::string(mark));
  for (std::size_t i = 1; i < cells.size(); ++i) row += " & " + (cells[i].empty() ? "{}" : latex_of_numbers(cells[i]));
  return row + " \\\\\n";
}

// On one page, or with groups of rows on as many as they take.
std::string latex_table(const PrintedTable& all) {
  const OnPaper& paper = all.paper;
  const PrintedTable table = picked(all, paper.columns);
  std::string columns = "l";
  for (std::size_t i = 1; i < table.head.size(); ++i) columns += is_of_numbers(table, i) ? 'r' : 'l';
  const std::string head = latex_row(table.head);
  const auto row = [&](std::size_t i) {
    const bool crossed = std::find(paper.crossed.begin(), paper.crossed.end(), i) != paper.crossed.end();
    return latex_row(table.rows[i], crossed ? " ×" : "");
  };
  std::string rows;
  if (paper.groups.empty()) {
    if (table.rows.empty()) return "";
    for (std::size_t i = 0; i < table.rows.size(); ++i) rows += row(i);
    return fmt::format(
        "\n\\begin{{table}}\n\\centering\\footnotesize\n\\caption{{{}}}\n\\label{{tab:{}}}\n\\begin{{tabular}}{{{}}}\n"
        "\\toprule\n{}\\midrule\n{}\\bottomrule\n\\end{{tabular}}\n\\end{{table}}\n",
        paper.caption, paper.label, columns, head, rows);
  }
  for (const auto& [title, members] : paper.groups) {
    rows += fmt::format("{}\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\*\n", rows.empty() ? "" : "\\addlinespace\n",
                        table.head.size(), title);
    for (const std::size_t i : members) rows += row(i);
  }
  return fmt::format(
      "{{\\footnotesize\\setlength{{\\tabcolsep}}{{4pt}}\n\\begin{{longtable}}{{{}}}\n\\caption{{{}}}\n"
      "\\label{{tab:{}}}\\\\\n\\toprule\n{}\\midrule\n\\endfirsthead\n\\toprule\n{}\\midrule\n\\endhead\n\\bottomrule\n"
      "\\endfoot\n{}\\end{{longtable}}}}\n",
      columns, paper.caption, paper.label, head, head, rows);
}

}  // namespace

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string wrapped(std::string_view text, std::string_view indent, std::string_view begin, std::size_t most) {
  std::string out(begin);
  std::size_t length = width_of(begin);
  bool first = true;
  while (!text.empty()) {
    const std::size_t space = end_of_word(text);
    const std::string_view word = text.substr(0, space);
    text.remove_prefix(std::min(space + 1, text.size()));
    if (!first && length + 1 + width_of(word) > most) {
      out += fmt::format("\n{}", indent);
      length = width_of(indent);
    } else if (!first) {
      out += ' ';
      ++length;
    }
    first = false;
    out += word;
    length += width_of(word);
  }
  return out + '\n';
}

std::string in_text(const std::vector<Chapter>& chapters, std::size_t width) {
  std::string out;
  for (const Chapter& chapter : chapters) {
    std::string words;
    const Block* above = nullptr;
    for (const Block& block : chapter.blocks) {
      const std::string text = std::visit(AsText{!chapter.title.empty(), width}, block);
      if (text.empty()) continue;
      if (above && are_apart(*above, block, chapter)) words += '\n';
      words += text;
      above = &block;
    }
    if (words.empty()) continue;
    if (!out.empty() || !chapter.title.empty()) out += '\n';
    if (!chapter.title.empty()) out += chapter.title + "\n";
    out += words;
  }
  return out;
}

std::string in_latex(const std::vector<Chapter>& chapters) {
  std::string out = fmt::format(
      "% FlexSlip {}. Needs \\usepackage{{booktabs,longtable}}; letters beyond those of the document's fonts, in "
      "names, need others.\n",
      FLEXSLIP_VERSION);
  for (const Chapter& chapter : chapters)
    for (const Block& block : chapter.blocks)
      if (const auto* table = std::get_if<PrintedTable>(&block); table && !table->paper.label.empty())
        out += latex_table(*table);
  return out;
}

std::string latex_escaped(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    const auto known =
        std::find_if(commands.begin(), commands.end(), [c](const auto& each) { return each.first == c; });
    out += known == commands.end() ? std::string(1, c) : std::string(known->second);
  }
  for (const auto& [symbol, command] : symbols) out = replaced(out, symbol, command);
  return out;
}

}  // namespace flexslip
