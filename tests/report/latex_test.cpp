#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "io/child_process.h"
#include "io/text_file.h"
#include "report/campaign_document.h"
#include "report/document.h"
#include "tests/report/some_campaign.h"

using namespace flexslip;

namespace {

std::string document(const std::string& body) {
  return "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\usepackage[utf8]{inputenc}\n"
         "\\usepackage{booktabs,longtable}\n\\begin{document}\n" +
         body + "\\end{document}\n";
}

std::string latex_of(const Campaign& campaign) { return in_latex(document_of(campaign, with_error)); }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

// Characters that LaTeX takes for commands, not those after a backslash.
std::ptrdiff_t count_unescaped(const std::string& line, char wanted) {
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i] == '\\')
      ++i;
    else if (line[i] == wanted)
      ++count;
  return count;
}

void check_syntax(const std::string& latex) {
  std::ptrdiff_t braces = 0;
  std::vector<std::string> open;
  std::ptrdiff_t columns = 0;
  for (const auto& line : lines_of(latex)) {
    if (line.starts_with("%")) continue;
    INFO(line);
    CHECK(count_unescaped(line, '$') % 2 == 0);
    CHECK(count_unescaped(line, '%') == 0);
    CHECK(count_unescaped(line, '#') == 0);
    braces += count_unescaped(line, '{') - count_unescaped(line, '}');
    CHECK(braces >= 0);
    for (auto at = line.find("\\begin{"); at != std::string::npos; at = line.find("\\begin{", at + 1))
      open.push_back(line.substr(at + 7, line.find('}', at) - at - 7));
    if (line.find("\\begin{longtable}") != std::string::npos) columns = 10;
    const std::string tabular = "\\begin{tabular}{";
    if (const auto at = line.find(tabular); at != std::string::npos)
      columns = static_cast<std::ptrdiff_t>(line.find('}', at + tabular.size()) - at - tabular.size());
    if (const auto at = line.find("\\end{"); at != std::string::npos) {
      REQUIRE(!open.empty());
      CHECK(line.substr(at + 5, line.find('}', at) - at - 5) == open.back());
      open.pop_back();
    }
    const bool is_row = line.ends_with("\\\\") && line.find("\\multicolumn") == std::string::npos &&
                        line.find("\\label") == std::string::npos;
    if (is_row) CHECK(count_unescaped(line, '&') == columns - 1);
  }
  CHECK(braces == 0);
  CHECK(open.empty());
}

}  // namespace

TEST_CASE("table: every character that means something to LaTeX") {
  CHECK(latex_escaped("A <b> & 50%_ü") == "A \\textless{}b\\textgreater{} \\& 50\\%\\_ü");
  CHECK(latex_escaped("\\{}$#^~|") == "\\textbackslash{}\\{\\}\\$\\#\\textasciicircum{}\\textasciitilde{}\\textbar{}");
  CHECK(latex_escaped("[a]*") == "{[}a]{*}");
  CHECK(latex_escaped("heat most -5 µm ± 2") == "heat most -5 $\\mu$m $\\pm$ 2");
}

TEST_CASE("identity: braces and environments close, and every row has its columns") {
  for (const auto& campaign : {some_campaign(), no_tests(), only_failures()}) check_syntax(latex_of(campaign));
}

TEST_CASE("table: value and uncertainty to matching digits, by category, suspects marked") {
  const std::string latex = latex_of(some_campaign());
  CHECK(
      latex.find("A \\textless{}b\\textgreater{} \\& 50\\%\\_ü ''x'' & 0.600 $\\pm$ 0.012 & 0.150 $\\pm$ 0.020 & 10.90 "
                 "$\\pm$ 0.20 & ") != std::string::npos);
  CHECK(latex.find("SS8 $\\times$") != std::string::npos);
  CHECK(latex.find("clear & left out & 2 & 0.500 (0.400 to 0.600)") != std::string::npos);
  CHECK(latex.find("$\\lambda$ ($\\mu$m)") != std::string::npos);
}

TEST_CASE("outside: pdflatex compiles it") {
  const Folder folder;
  for (const auto& campaign : {some_campaign(), no_tests(), only_failures()}) {
    write_text(folder.path + "/t.tex", document(latex_of(campaign)));
    const auto result = run_child({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "t.tex"}, folder.path);
    if (result.status == ChildStatus::not_found) {
      MESSAGE("skipped: no pdflatex");
      return;
    }
    INFO(result.output);
    CHECK(result.exit_code == 0);
  }
}
