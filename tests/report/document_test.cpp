#include "report/document.h"

#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "io/child_process.h"
#include "io/text_file.h"
#include "report/answer_documents.h"
#include "report/page.h"
#include "tests/has.h"
#include "tests/report/some_campaign.h"
#include "tests/temporary_folder.h"

using namespace flexslip;

namespace {

std::vector<Chapter> small_document() {
  PrintedTable numbers{{"Slip", "Fall"}, {{"1", "0.2"}, {"12", "-0.15"}}};
  PrintedTable names{.head = {"Test", "μ", "Doubts"},
                     .rows = {{"a <b>", "0.5", "one doubt; another doubt; a third one, and a fourth"}},
                     .links = {"tests/a%20/report.html"},
                     .on_terminal = {"Test", "Doubts"}};
  return {{"", {Pictures{[] { return std::vector<Plot>(1); }}}},
          {"Friction & wear",
           {std::string("It is -0.5."), std::string(), numbers, PrintedTable{{"none"}, {}},
            Rows{{"work", "a < b"}, {"left out", ""}}, Verbatim{"[rig]\n\nspan = '1 mm'\n"}, names,
            FilesBeside{{{"tests.csv", "a row per test"}}}}},
          {"Nothing to say", {std::string(), Rows{{"left out", ""}}}}};
}

}  // namespace

TEST_CASE("by hand: a terminal shows words, rows and tables, no pictures, nothing that says nothing") {
  CHECK(in_text(small_document(), 40) ==
        "\nFriction & wear\n   It is -0.5.\n\n   Slip   Fall\n   1       0.2\n   12    -0.15\n\n   work            "
        "a < "
        "b\n\n   "
        "Test   Doubts\n   a <b>  one doubt; another doubt; a …\n");
}

TEST_CASE("by hand: words are apart from the rows below them where no title stands above") {
  CHECK(in_text({{"", {std::string("The answer."), Rows{{"work", "0.2 mJ"}}, std::string("Next: nothing.")}}}) ==
        "The answer.\n\n  work            0.2 mJ\nNext: nothing.\n");
}

TEST_CASE("by hand: a page shows the same and the pictures, numbers to the right") {
  const std::string html = in_html(small_document(), [] { return std::string("(a figure)"); });
  for (const char* part :
       {"(a figure)<h2>Friction &amp; wear</h2>", "<p>It is \u22120.5.</p>", "<th class=\"n\">Fall</th>",
        "<td>12</td><td class=\"n\">\u22120.15</td>", "<dt>work</dt><dd>a &lt; b</dd>",
        "<pre>[rig]\n\nspan = '1 mm'\n</pre>",
        "<td><a href=\"tests/a%20/report.html\">a &lt;b&gt;</a></td><td class=\"n\">0.5</td><td>one doubt",
        "<dt><a href=\"tests.csv\">tests.csv</a></dt><dd>a row per test</dd>"})
    CHECK_MESSAGE(has(html, part), part, " in ", html);
  for (const char* part : {"none", "left out", "Nothing to say"}) CHECK_FALSE(has(html, part));
}

TEST_CASE("by hand: a table of more than 12 rows is folded, unless it is to stay open") {
  PrintedTable table{{"Row"}, {}};
  for (int i = 0; i < 13; ++i) table.rows.push_back({std::to_string(i)});
  const auto html = [&] { return in_html({{"All", {table}}}, {}); };
  CHECK(has(html(), "<details><summary>A table of 13 rows</summary>"));
  table.folding = Folding::never;
  CHECK_FALSE(has(html(), "<details>"));
  table.folding = Folding::of_long;
  table.rows.pop_back();
  CHECK_FALSE(has(html(), "<details>"));
  table.head = {"Row", "What it is"};
  for (auto& row : table.rows) row.emplace_back("a row");
  table.folding = Folding::always;
  CHECK(has(html(), "<details><summary>Row: What it is</summary>"));
}

// ---- For a paper

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
  const TemporaryFolder folder;
  for (const auto& campaign : {some_campaign(), no_tests(), only_failures()}) {
    write_text(folder.path() / "t.tex", document(latex_of(campaign)));
    const auto result = run_child({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "t.tex"}, folder.path());
    if (result.status == ChildStatus::not_found) {
      MESSAGE("skipped: no pdflatex");
      return;
    }
    INFO(result.output);
    CHECK(result.exit_code == 0);
  }
}
