#include "report/page.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/parallel.h"
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
dl.rows { display: grid; grid-template-columns: fit-content(16rem) minmax(0, 1fr); overflow-wrap: anywhere; gap: .2rem 1rem; margin: 0 0 1rem; } dl.rows dt { color: var(--soft); min-width: 6.5rem; } dl.rows dd { margin: 0; }
@media (max-width: 34rem) { dl.rows { grid-template-columns: minmax(0, 1fr); } dl.rows dd { margin-bottom: .4rem; } }
.source { font-size: .88rem; color: var(--soft); border-top: 1px solid var(--line); padding-top: .6rem; }
details summary { cursor: pointer; color: var(--soft); }
details.chapter { border-top: 1px solid var(--line); } details.chapter > summary { padding: .35rem 0; }
details.chapter > summary h2 { display: inline; font-size: 1rem; color: var(--text); }
.answer { font-size: 1.4rem; line-height: 1.38; margin: 0 0 1.2rem; text-wrap: pretty; }
figure { margin: 1.2rem 0 1.4rem; }
figure svg { display: block; width: 100%; height: auto; min-width: calc(var(--mm) * .7mm); }
.plate { background: #fff; border-radius: 4px; max-width: calc(var(--mm) * 53rem / 170); overflow-x: auto; }
figcaption, .note { font-size: .88rem; color: var(--soft); }
figcaption { margin-top: .4rem; }
figcaption b { color: var(--text); }
.scroll { overflow-x: auto; }
table { border-collapse: separate; border-spacing: 0; font-size: .88rem; line-height: 1.35; width: 100%; font-variant-numeric: tabular-nums; margin: .5rem 0; }
th { text-align: left; font-weight: 600; border-bottom: 1.5px solid var(--text); vertical-align: bottom; }
th, td { padding: .22rem .8rem .22rem 0; } th:last-child, td:last-child { padding-right: 0; }
td { border-bottom: 1px solid var(--line); vertical-align: top; }
td:last-child:not(:first-child, .n) { min-width: 12rem; overflow-wrap: anywhere; } th:first-child, td:first-child { position: sticky; left: 0; background: var(--back); }
th.n, td.n { text-align: right; } td.n, .values td + td { white-space: nowrap; }
code, pre { font: .82rem/1.45 ui-monospace, "DejaVu Sans Mono", Consolas, monospace; overflow-wrap: anywhere; }
pre { border-left: 3px solid var(--line); margin: .6rem 0; padding: .2rem 0 .2rem .9rem; white-space: pre-wrap; }
a { color: var(--mark); }
@page { size: A4; margin: 18mm 17mm; }
@media print {
  :root { color-scheme: light; --text: #000; --soft: #444; --line: #ccc; --back: #fff; --mark: #000; }
  html { font-size: 8.8pt; }
  body { max-width: none; padding: 0; }
  .answer { margin-bottom: .8rem; } h2 { margin-top: 1.6rem; } figure { margin: .8rem 0 1.2rem; }
  .scroll { overflow: visible; } th:first-child, td:first-child { position: static; } .plate { width: 94%; } .files { display: none; }
  figure, tr { break-inside: avoid; } h2, h2 + p { break-after: avoid; }
  details.chapter::details-content { content-visibility: visible; block-size: auto; }
}
)";

// Escapes HTML, and replaces a hyphen before a number by a minus sign.
std::string in_page(const std::string& words) {
  const std::string text = html_escaped(words);
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    const bool number = i + 1 < text.size() && is_digit(text[i + 1]);
    out += text[i] == '-' && begins && number ? std::string("−") : std::string(1, text[i]);
  }
  return out;
}

std::string cells_in_html(const PrintedTable& table, const std::vector<std::string>& row, std::string_view tag,
                          const std::string& link = "") {
  std::string out;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string words = i == 0 && !link.empty()
                                  ? fmt::format("<a href=\"{}\">{}</a>", html_escaped(link), in_page(row[i]))
                                  : in_page(row[i]);
    out += fmt::format("<{}{}>{}</{}>", tag, is_of_numbers(table, i) ? " class=\"n\"" : "", words, tag);
  }
  return out;
}

struct AsHtml {
  const std::function<std::string()>& next_pictures;
  Folding folding;  // of the chapter; a folded one folds nothing inside

  std::string operator()(const std::string& words) const {
    return words.empty() ? "" : fmt::format("<p>{}</p>\n", in_page(words));
  }
  std::string operator()(const Rows& rows) const {
    std::string out;
    for (const auto& [label, words] : rows)
      if (!words.empty()) out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", in_page(label), in_page(words));
    return out.empty() ? "" : fmt::format("<dl class=\"rows\">\n{}</dl>\n", out);
  }
  // A long table is folded.
  std::string operator()(const PrintedTable& all) const {
    if (all.rows.empty()) return "";
    constexpr std::size_t max_open = 12;
    const PrintedTable table = picked(all, all.on_page);
    std::string rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      rows += fmt::format("<tr>{}</tr>\n",
                          cells_in_html(table, table.rows[i], "td", all.links.empty() ? "" : all.links[i]));
    const std::string html =
        fmt::format("<div class=\"scroll{}\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
                    all.on_page.empty() ? "" : " values", cells_in_html(table, table.head, "th"), rows);
    const bool is_open = folding == Folding::always || all.folding == Folding::never ||
                         (all.folding == Folding::of_long && all.rows.size() <= max_open);
    if (is_open) return html;
    const std::string title = all.folding != Folding::always ? fmt::format("A table of {} rows", all.rows.size())
                              : all.on_page.empty()          ? fmt::format("{}: {}", all.head.front(), all.head.back())
                                                             : table.head.front();
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", in_page(title), html);
  }
  std::string operator()(const Pictures&) const { return next_pictures(); }
  std::string operator()(const Verbatim& lines) const {
    return fmt::format("<pre>{}</pre>\n", html_escaped(lines.text));
  }
  std::string operator()(const AccompanyingFiles& beside) const {
    std::string out;
    for (const auto& [name, holds] : beside.files)
      out += fmt::format("<dt><a href=\"{0}\">{0}</a></dt><dd>{1}</dd>\n", name, html_escaped(holds));
    return fmt::format("<dl class=\"rows files\">\n{}</dl>\n", out);
  }
};

// Makes the names of the parts of a picture unique on the page.
std::string inline_svg(const fs::path& path, const Plot& plot) {
  std::string svg = read_text(path.string()).value_or("");
  svg.erase(0, svg.find("<svg"));
  for (const std::string_view before : {"id='", "id=\"", "xlink:href='#", "xlink:href=\"#", "url(#"})
    svg = replaced(svg, before, fmt::format("{}{}-", before, plot.name));
  svg.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", html_escaped(plot.caption)));
  return svg;
}

// A picture with its caption and links to its files.
std::string html_figure(const std::string& folder, const Plot& plot, const Drawing& drawing, std::size_t number) {
  const std::string base = "figures/" + plot.name;
  const std::string picture = drawing.is_done()
                                  ? inline_svg(fs::path(folder) / (base + ".svg"), plot)
                                  : fmt::format(
                                        "<p class=\"note\">Not drawn: {}. Once gnuplot works, run <code>gnuplot "
                                        "{}.gp</code> in the folder figures, or make the report again.</p>\n",
                                        html_escaped(drawing.why_not), html_escaped(plot.name));
  std::string files;
  for (const std::string_view ending : {"svg", "pdf", "png", "gp"})
    if (drawing.is_done() || ending == "gp") files += fmt::format(" <a href=\"{}.{}\">{}</a>", base, ending, ending);
  for (const auto& data : plot.data)
    files += fmt::format(" <a href=\"{}-{}.csv\">{}.csv</a>", base, data.name, data.name);
  return fmt::format(
      "<figure>\n<div class=\"plate\" style=\"--mm:{:.0f}\">{}</div>\n<figcaption><b>Figure {}.</b> {} <span "
      "class=\"files\">Files:{}</span></figcaption>\n</figure>\n",
      plot.width, picture, number, html_escaped(plot.caption), files);
}

// Draws all plots, two at a time, because gnuplot uses one core.
std::vector<Drawing> draw_all(const std::vector<Plot>& plots, const std::string& folder) {
  std::vector<Drawing> drawings(plots.size());
  for_each_index(plots.size(), 2, [&](std::size_t i) { drawings[i] = draw(plots[i], folder, {"svg", "pdf", "png"}); });
  return drawings;
}

}  // namespace

std::string in_html(const std::vector<Chapter>& chapters, const std::function<std::string()>& next_pictures) {
  std::string out;
  for (const Chapter& chapter : chapters) {
    std::string html;
    for (const Block& block : chapter.blocks) html += std::visit(AsHtml{next_pictures, chapter.folding}, block);
    if (html.empty()) continue;
    const std::string heading = chapter.title.empty() ? "" : fmt::format("<h2>{}</h2>", html_escaped(chapter.title));
    if (chapter.folding == Folding::always)
      out += fmt::format("<details class=\"chapter\"><summary>{}</summary>\n{}</details>\n", heading, html);
    else
      out += heading + (heading.empty() ? "" : "\n") + html;
  }
  return out;
}

std::string answer_in_html(const std::string& words, const Verdict* verdict) {
  return fmt::format(
      "<p class=\"answer\">{}{}</p>\n",
      verdict ? fmt::format("<b class=\"{}\">{}</b> ", name_of(verdict->code), word_of(verdict->code)) : "",
      in_page(words));
}

Drawing write_page(const std::string& folder, const std::string& title, const std::string& answer,
                   const std::vector<Chapter>& chapters, double figure_width) {
  std::vector<Plot> plots;
  std::vector<std::size_t> ends;  // end of each block of pictures
  for (const Chapter& chapter : chapters)
    for (const Block& block : chapter.blocks)
      if (const auto* pictures = std::get_if<Pictures>(&block)) {
        for (Plot& plot : pictures->plots(figure_width)) plots.push_back(in_width(std::move(plot), figure_width));
        ends.push_back(plots.size());
      }
  const std::string figures = (fs::path(folder) / "figures").string();
  make_folder(figures);
  const std::vector<Drawing> drawings = draw_all(plots, figures);
  std::size_t figure = 0, block = 0;
  const std::string body = in_html(chapters, [&] {
    std::string html;
    for (; figure < ends[block]; ++figure) html += html_figure(folder, plots[figure], drawings[figure], figure + 1);
    ++block;
    return html;
  });
  write_text(
      (fs::path(folder) / "report.html").string(),
      fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"generator\" "
                  "content=\"FlexSlip\">\n<meta name=\"viewport\" content=\"width=device-width, "
                  "initial-scale=1\">\n<title>{0}</title>\n<style>{1}</style>\n"
                  "</head>\n<body>\n<main>\n<h1>{0}</h1>\n{2}{3}</main>\n</body>\n</html>\n",
                  html_escaped(title), page_style, answer, body));
  const auto missing =
      std::find_if(drawings.begin(), drawings.end(), [](const Drawing& each) { return !each.is_done(); });
  return missing == drawings.end() ? Drawing{} : *missing;
}

void require_own_report(const std::string& folder) {
  const fs::path report = fs::path(folder) / "report.html";
  std::error_code error;
  if (!fs::exists(report, error)) return;
  std::ifstream file(report);
  std::string begin(1000, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin.find("FlexSlip") == std::string::npos && begin.find("in a bending test") == std::string::npos)
    throw InputError({.file = report.string(),
                      .problem = "This file is not a report of FlexSlip, and would be overwritten",
                      .remedy = "pass another folder with --report"});
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw unwritable(folder, error.message());
}

}  // namespace flexslip
