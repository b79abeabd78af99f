#include "report/campaign_latex.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/text.h"
#include "report/campaign_words.h"

namespace flexslip {
namespace {

// Of our tables, beyond the letters that the fonts of a document have.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> symbols{{{"μ₀", "$\\mu_0$"},
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
std::string of_numbers(std::string_view cell) {
  constexpr std::string_view limit = "at most ";
  if (cell.starts_with(limit)) return "$\\leq$ " + of_numbers(cell.substr(limit.size()));
  std::string out;
  std::size_t from = 0;
  for (std::size_t i = 0; i + 1 < cell.size(); ++i) {
    const bool begins = i == 0 || cell[i - 1] == ' ' || cell[i - 1] == '(' || cell[i - 1] == '[';
    if (cell[i] != '-' || !begins || cell[i + 1] < '0' || cell[i + 1] > '9') continue;
    out += latex_escaped(cell.substr(from, i - from)) + "$-$";
    from = i + 1;
  }
  return out + latex_escaped(cell.substr(from));
}

// Cells of a row: words, then numbers.
std::string row_of(const std::vector<std::string>& cells) {
  std::string row = latex_escaped(cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i) row += " & " + (cells[i].empty() ? "{}" : of_numbers(cells[i]));
  return row + " \\\\\n";
}

// "lrrr": words to the left, numbers to the right.
std::string columns_of(const PrintedTable& table) { return "l" + std::string(table.head.size() - 1, 'r'); }

// Nothing where there are no rows.
std::string tabular(const PrintedTable& table, std::string_view label, std::string_view caption) {
  if (table.rows.empty()) return "";
  std::string rows;
  for (const auto& row : table.rows) rows += row_of(row);
  return fmt::format(
      "\n\\begin{{table}}\n\\centering\\footnotesize\n\\caption{{{}}}\n\\label{{tab:{}}}\n\\begin{{tabular}}{{{}}}\n"
      "\\toprule\n{}\\midrule\n{}\\bottomrule\n\\end{{tabular}}\n\\end{{table}}\n",
      caption, label, columns_of(table), row_of(table.head), rows);
}

// The tests by their sawtooth, over as many pages as they take.
std::string tests_of(const Campaign& campaign) {
  const PrintedTable all = test_rows(campaign, with_error);
  std::vector<const TestSummary*> summaries;  // of its rows
  for (const auto& test : campaign.tests)
    if (test.summary) summaries.push_back(&*test.summary);
  const PrintedTable table =
      picked(all, {"Test", "μ₀", "A", "λ", "Height", "Slope", "EI", "Residual", "Drops", "Friction"});
  const std::string head = row_of(table.head);
  std::string out = fmt::format(
      "{{\\footnotesize\\setlength{{\\tabcolsep}}{{4pt}}\n\\begin{{longtable}}{{{}}}\n\\caption{{Friction in bending "
      "tests, by "
      "the sawtooth of their force curves: mean friction $\\mu_0$, amplitude $A$ and wavelength $\\lambda$ of one wave "
      "of "
      "friction along the specimen (in brackets where it is only indicative), height (half of crest to trough) and rms "
      "slope of a surface that would explain them, bending stiffness $EI$, root mean square "
      "of "
      "measured less model force, drops of the force, and the share of the work that was friction; $\\pm$ standard "
      "error, $\\times$ suspect.}}\n\\label{{tab:friction}}\\\\\n\\toprule\n{}\\midrule\n\\endfirsthead\n\\toprule\n{}"
      "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n",
      columns_of(table), head, head);
  const auto heading = [&](std::string_view words) {
    return fmt::format("\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\*\n", table.head.size(), words);
  };
  bool first = true;
  for (const auto& [category, title] : {std::pair{SawtoothCategory::clear, "Clear sawtooth"},
                                        {SawtoothCategory::nominal, "Nominal sawtooth"},
                                        {SawtoothCategory::none, "No sawtooth, or hardly any"}}) {
    std::string rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      if (summaries[i]->category != category) continue;
      std::vector<std::string> row = table.rows[i];
      if (summaries[i]->suspect) row[0] += " ×";
      rows += row_of(row);
    }
    if (rows.empty()) continue;
    out += (first ? "" : "\\addlinespace\n") + heading(title) + rows;
    first = false;
  }
  return out + (first ? heading("No test with an answer.") : "") + "\\end{longtable}}\n";
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) switch (c) {
      case '\\':
        out += "\\textbackslash{}";
        break;
      case '{':
      case '}':
      case '$':
      case '&':
      case '#':
      case '_':
      case '%':
        out += '\\';
        out += c;
        break;
      case '^':
        out += "\\textasciicircum{}";
        break;
      case '~':
        out += "\\textasciitilde{}";
        break;
      case '<':
        out += "\\textless{}";
        break;
      case '>':
        out += "\\textgreater{}";
        break;
      case '|':
        out += "\\textbar{}";
        break;
      case '[':  // an argument of the row's end before it
      case '*':
        out += fmt::format("{{{}}}", c);
        break;
      case '"':
        out += "''";
        break;
      default:
        out += c;
    }
  for (const auto& [symbol, command] : symbols)
    for (auto at = out.find(symbol); at != std::string::npos; at = out.find(symbol, at + command.size()))
      out.replace(at, symbol.size(), command);
  return out;
}

std::string campaign_latex(const Campaign& campaign) {
  return fmt::format(
             "% FlexSlip {}. Needs \\usepackage{{booktabs,longtable}}; letters beyond those of the document's fonts, "
             "in "
             "names, need others.\n",
             FLEXSLIP_VERSION) +
         tests_of(campaign) +
         tabular(category_rows(campaign), "friction-categories",
                 "Friction by category of the sawtooth: mean (least to greatest).") +
         tabular(
             specimen_rows(campaign), "friction-specimens",
             "Friction between specimens, suspects left out: mean of $\\mu_0$ and its standard deviation between "
             "specimens; middle roughness $\\sigma$ and correlation length $\\ell$, and the factor by which specimens "
             "differ; 95\\,\\% intervals.") +
         tabular(shared_rows(campaign), "friction-shared",
                 "One value for several tests, with its 95\\,\\% interval; $p$: probability that tests that share it "
                 "differ as much.");
}

}  // namespace flexslip
