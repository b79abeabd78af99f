#include "report/page.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --text: #1b1b1b; --soft: #5b5b5b; --line: #d4d4d4; --back: #ffffff; --mark: #0072B2; }
@media (prefers-color-scheme: dark) { :root { --text: #e8e8e8; --soft: #a8a8a8; --line: #444; --back: #16181b; --mark: #56B4E9; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 56rem; padding: 2.2rem 1.5rem 4rem; color: var(--text); background: var(--back);
  font: 1rem/1.5 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.15rem; font-weight: 600; color: var(--soft); margin: 0 0 .6rem; }
h2 { font-size: 1.15rem; margin: 2.4rem 0 .5rem; }
.answer b { letter-spacing: .02em; margin-right: .5rem; } .answer .slip, .answer .no_drops { color: #007a58; }
.answer .undecided { color: #a66f00; } .answer .crack, .answer .check_input, .answer .no_answer { color: #c04a00; }
dl.rows { display: grid; grid-template-columns: 7.5rem 1fr; gap: .2rem 1rem; margin: 0 0 1rem; } dl.rows dt { color: var(--soft); } dl.rows dd { margin: 0; }
dl.source { font-size: .88rem; color: var(--soft); border-top: 1px solid var(--line); padding-top: .6rem; }
details summary { cursor: pointer; color: var(--soft); }
.answer { font-size: 1.4rem; line-height: 1.38; margin: 0 0 1.6rem; text-wrap: pretty; }
figure { margin: 1.4rem 0 1.8rem; }
figure svg { display: block; width: 100%; height: auto; }
figure.narrow svg { max-width: 30rem; }
.plate { background: #fff; border-radius: 4px; }
figcaption, .note { font-size: .88rem; color: var(--soft); }
figcaption { margin-top: .4rem; }
figcaption b { color: var(--text); }
.scroll { overflow-x: auto; }
.wide { position: relative; left: 50%; transform: translateX(-50%); width: max-content; min-width: 100%; max-width: 95vw; }
.wide table { font-size: 0.72rem; }
table { border-collapse: collapse; font-size: .88rem; line-height: 1.35; width: 100%; font-variant-numeric: tabular-nums; margin: .5rem 0; }
th { text-align: left; font-weight: 600; border-bottom: 1.5px solid var(--text); vertical-align: bottom; }
th, td { padding: .22rem 1rem .22rem 0; }
td { border-bottom: 1px solid var(--line); vertical-align: top; }
table.numbers td + td, table.numbers th + th { text-align: right; }
table.numbers td:last-child, table.numbers th:last-child { padding-right: 0; }
table.words td { white-space: nowrap; padding-right: .8rem; } table.words td:last-child { white-space: normal; min-width: 14rem; }
table.words td:first-child { position: sticky; left: 0; background: var(--back); }
td.value, table.numbers td { white-space: nowrap; }
table.parameters td:first-child { white-space: nowrap; width: 3rem; }
table.parameters td:nth-child(2) { width: 35%; }
td.remark { color: var(--soft); }
tr.chosen td { font-weight: 600; }
ul { padding-left: 1.1rem; } li { margin: .2rem 0; }
code, pre { font: .82rem/1.45 ui-monospace, "DejaVu Sans Mono", Consolas, monospace; overflow-wrap: anywhere; }
pre { border-left: 3px solid var(--line); margin: .6rem 0; padding: .2rem 0 .2rem .9rem; white-space: pre-wrap; }
a { color: var(--mark); }
@page { size: A4; margin: 18mm 17mm; }
@media print {
  :root { color-scheme: light; --text: #000; --soft: #444; --line: #ccc; --back: #fff; --mark: #000; }
  html { font-size: 8.8pt; }
  body { max-width: none; padding: 0; }
  .answer { margin-bottom: .8rem; } h2 { margin-top: 1.6rem; } figure { margin: .8rem 0 1.2rem; }
  .scroll { overflow: visible; } .wide { left: 0; transform: none; width: auto; } .plate { width: 94%; }
  figure, tr, li { break-inside: avoid; } h2, h2 + p { break-after: avoid; }
  .files { display: none; } table.words { font-size: 6.2pt; } table.words td, table.words th { padding-right: .4rem; }
  table.words td, table.words td:last-child { white-space: normal; min-width: 0; }
}
)";

std::string cells(const std::vector<std::string>& row, std::string_view tag) {
  std::string out;
  for (const auto& cell : row) out += fmt::format("<{}>{}</{}>", tag, typeset_minus(html_escaped(cell)), tag);
  return out;
}

// Several pictures in one page must not share the names of their parts.
std::string inline_svg(const fs::path& path, const Plot& plot) {
  std::string svg = read_text(path.string()).value_or("");
  if (svg.find("<svg") == std::string::npos) throw std::runtime_error(fmt::format("no picture in {}", path.string()));
  svg.erase(0, svg.find("<svg"));
  const auto rename = [&](const std::string& what, const std::string& by) {
    for (auto at = svg.find(what); at != std::string::npos; at = svg.find(what, at + by.size()))
      svg.replace(at, what.size(), by);
  };
  for (const std::string quote : {"'", "\""}) {
    rename("id=" + quote, "id=" + quote + plot.name + "-");
    rename("xlink:href=" + quote + "#", "xlink:href=" + quote + "#" + plot.name + "-");
  }
  rename("url(#", "url(#" + plot.name + "-");
  svg.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", html_escaped(plot.caption)));
  return svg;
}

}  // namespace

std::string typeset_minus(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    const bool number = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    out += text[i] == '-' && begins && number ? std::string("−") : std::string(1, text[i]);
  }
  return out;
}

std::string html_table(const PrintedTable& table, std::size_t marked) {
  std::string out =
      fmt::format("<div class=\"scroll\"><table class=\"numbers\">\n<thead><tr>{}</tr></thead>\n<tbody>\n",
                  cells(table.head, "th"));
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    out += fmt::format("<tr{}>{}</tr>\n", i == marked ? " class=\"chosen\"" : "", cells(table.rows[i], "td"));
  return out + "</tbody></table></div>\n";
}

std::string html_word_table(const PrintedTable& table, const std::vector<std::string>& links) {
  std::string out =
      fmt::format("<div class=\"scroll wide\"><table class=\"words\">\n<thead><tr>{}</tr></thead>\n<tbody>\n",
                  cells(table.head, "th"));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    const bool linked = i < links.size() && !links[i].empty();
    out += linked ? fmt::format("<tr><td><a href=\"{}\">{}</a></td>{}</tr>\n", html_escaped(links[i]),
                                html_escaped(row.front()), cells({row.begin() + 1, row.end()}, "td"))
                  : fmt::format("<tr>{}</tr>\n", cells(row, "td"));
  }
  return out + "</tbody></table></div>\n";
}

std::string html_figure(const std::string& folder, const Plot& plot, DrawStatus drawn, int number) {
  const std::string base = "figures/" + plot.name;
  const bool narrow = plot.width < two_columns;
  const std::string picture = drawn == DrawStatus::drawn
                                  ? inline_svg(fs::path(folder) / (base + ".svg"), plot)
                                  : fmt::format(
                                        "<p class=\"note\">Not drawn: gnuplot is not installed. Install it and run "
                                        "<code>gnuplot {}.gp</code> in the folder "
                                        "figures, or make the report again.</p>\n",
                                        plot.name);
  std::string files;
  for (const std::string_view ending : {"svg", "pdf", "png", "gp"})
    if (drawn == DrawStatus::drawn || ending == "gp")
      files += fmt::format(" <a href=\"{}.{}\">{}</a>", base, ending, ending);
  for (const auto& data : plot.data)
    files += fmt::format(" <a href=\"{}-{}.csv\">{}.csv</a>", base, data.name, data.name);
  return fmt::format(
      "<figure{}>\n<div class=\"plate\">{}</div>\n<figcaption><b>Figure {}.</b> {} <span "
      "class=\"files\">Files:{}</span></figcaption>\n</figure>\n",
      narrow ? " class=\"narrow\"" : "", picture, number, html_escaped(plot.caption), files);
}

std::string page(const std::string& title, const std::string& head, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, "
      "initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n"
      "{}{}</main>\n"
      "</body>\n</html>\n",
      html_escaped(title), page_style, html_escaped(title), head, body);
}

std::string answer_in_html(const std::string& words) {
  return fmt::format("<p class=\"answer\">{}</p>\n", typeset_minus(html_escaped(words)));
}

std::string paragraph(const std::string& words) {
  return fmt::format("<p>{}</p>\n", typeset_minus(html_escaped(words)));
}

std::string section(const std::string& title) { return fmt::format("<h2>{}</h2>\n", html_escaped(title)); }

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw unwritable(folder, error.message());
}

}  // namespace flexslip
