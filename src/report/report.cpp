#include "report/report.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text_file.h"
#include "report/cycles_figures.h"
#include "report/cycles_words.h"
#include "report/fit_figures.h"
#include "report/fit_words.h"
#include "report/teeth_figure.h"
#include "report/teeth_words.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --text: #1b1b1b; --soft: #5b5b5b; --line: #d4d4d4; --back: #ffffff; --mark: #0072B2; }
@media (prefers-color-scheme: dark) { :root { --text: #e8e8e8; --soft: #a8a8a8; --line: #444; --back: #16181b; --mark: #56B4E9; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 56rem; padding: 2.2rem 1.5rem 4rem; color: var(--text); background: var(--back);
  font: 1rem/1.5 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.15rem; font-weight: 600; color: var(--soft); margin: 0 0 .6rem; }
h2 { font-size: 1.15rem; margin: 2.4rem 0 .5rem; }
.answer { font-size: 1.4rem; line-height: 1.38; margin: 0 0 1.6rem; text-wrap: pretty; }
figure { margin: 1.4rem 0 1.8rem; }
figure svg { display: block; width: 100%; height: auto; }
figure.narrow svg { max-width: 30rem; }
.plate { background: #fff; border-radius: 4px; }
figcaption, .note { font-size: .88rem; color: var(--soft); }
figcaption { margin-top: .4rem; }
figcaption b { color: var(--text); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; line-height: 1.35; width: 100%; font-variant-numeric: tabular-nums; margin: .5rem 0; }
th { text-align: left; font-weight: 600; border-bottom: 1.5px solid var(--text); vertical-align: bottom; }
th, td { padding: .22rem 1rem .22rem 0; }
td { border-bottom: 1px solid var(--line); vertical-align: top; }
table.numbers td + td, table.numbers th + th { text-align: right; }
table.numbers td:last-child, table.numbers th:last-child { padding-right: 0; }
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
  .scroll { overflow: visible; } .plate { width: 94%; }
  figure, tr, li { break-inside: avoid; } h2, h2 + p { break-after: avoid; }
  .files { display: none; }
}
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

// A hyphen before a number is a minus sign.
std::string typeset_minus(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    const bool number = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    out += text[i] == '-' && begins && number ? std::string("−") : std::string(1, text[i]);
  }
  return out;
}

std::string cells(const std::vector<std::string>& row, std::string_view tag) {
  std::string out;
  for (const auto& cell : row) out += fmt::format("<{}>{}</{}>", tag, typeset_minus(escaped(cell)), tag);
  return out;
}

std::string html_table(const PrintedTable& table, std::size_t marked = static_cast<std::size_t>(-1)) {
  std::string out =
      fmt::format("<div class=\"scroll\"><table class=\"numbers\">\n<thead><tr>{}</tr></thead>\n<tbody>\n",
                  cells(table.head, "th"));
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    out += fmt::format("<tr{}>{}</tr>\n", i == marked ? " class=\"chosen\"" : "", cells(table.rows[i], "td"));
  return out + "</tbody></table></div>\n";
}

std::string parameter_table(const FittedTest& test) {
  std::string out =
      "<div class=\"scroll\"><table class=\"parameters\">\n<thead><tr><th></th><th>Parameter</th><th>Value</th><th>95 "
      "% interval</th><th></th></tr></thead>\n<tbody>\n";
  for (const auto& row : parameter_rows(test))
    out += fmt::format(
        "<tr><td>{}</td><td><code>{}</code>, {}</td><td class=\"value\">{}</td><td class=\"value\">{}</td><td "
        "class=\"remark\">{}</td></tr>\n",
        escaped(row.symbol), escaped(row.name), escaped(row.meaning), typeset_minus(escaped(row.value)),
        typeset_minus(escaped(row.interval)), typeset_minus(escaped(row.remark)));
  return out + "</tbody></table></div>\n";
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Several pictures in one page must not share the names of their parts.
std::string inline_svg(const fs::path& path, const Figure& figure) {
  std::string svg = read_text(path);
  svg.erase(0, svg.find("<svg"));
  const auto rename = [&](const std::string& what, const std::string& by) {
    for (auto at = svg.find(what); at != std::string::npos; at = svg.find(what, at + by.size()))
      svg.replace(at, what.size(), by);
  };
  for (const std::string quote : {"'", "\""}) {
    rename("id=" + quote, "id=" + quote + figure.name + "-");
    rename("xlink:href=" + quote + "#", "xlink:href=" + quote + "#" + figure.name + "-");
  }
  rename("url(#", "url(#" + figure.name + "-");
  svg.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", escaped(figure.description)));
  return svg;
}

struct Plate {
  Figure figure;
  std::string caption;
};

std::string html_figure(const fs::path& folder, const Plate& plate, DrawStatus drawn, int number) {
  const auto& figure = plate.figure;
  const std::string base = "figures/" + figure.name;
  const bool narrow = figure.width < two_columns;
  const std::string picture = drawn == DrawStatus::drawn
                                  ? inline_svg(folder / (base + ".svg"), figure)
                                  : fmt::format(
                                        "<p class=\"note\">Not drawn: gnuplot is not installed. Install it and run "
                                        "<code>gnuplot {}.gp</code> in the folder "
                                        "figures, or fit again.</p>\n",
                                        figure.name);
  std::string files;
  for (const std::string_view ending : {"svg", "pdf", "png", "gp"})
    if (drawn == DrawStatus::drawn || ending == "gp")
      files += fmt::format(" <a href=\"{}.{}\">{}</a>", base, ending, ending);
  for (const auto& data : figure.data)
    files += fmt::format(" <a href=\"{}-{}.csv\">{}.csv</a>", base, data.name, data.name);
  return fmt::format(
      "<figure{}>\n<div class=\"plate\">{}</div>\n<figcaption><b>Figure {}.</b> {} <span "
      "class=\"files\">Files:{}</span></figcaption>\n</figure>\n",
      narrow ? " class=\"narrow\"" : "", picture, number, escaped(plate.caption), files);
}

std::vector<Plate> plates_of(const FittedTest& test) {
  const auto& analysis = test.analysis;
  std::vector<Plate> plates;
  plates.push_back(
      {force_figure(test), fmt::format("Measured force (blue) and the model of friction '{}' (black; dashed where it "
                                       "snaps). Orange: Euler–Bernoulli (dashed) and the "
                                       "model without friction, both with the bending stiffness of the fit. Grey: load "
                                       "lines (slope: the stiffness of the load train) through the {} drops "
                                       "found. Below: measured less model.",
                                       name_of(chosen_model(test).model), analysis.drops.drops.size())});
  plates.push_back({profile_figure(test),
                    "Friction read off the curve point by point, at the bending stiffness of the fit. Bars: what the "
                    "noise of a point leaves open, 95 %. "
                    "Blue band: what bending stiffness and contact leave open, 95 %; it moves all points together. "
                    "Red: the slips. Black: the model. Green: the "
                    "literature's range for glass on steel."});
  if (!analysis.fit.scan.wavelengths.empty())
    plates.push_back({wavelength_figure(test),
                      "How much likelier a wave of friction makes the profile, for every wavelength, slow drift "
                      "allowed for. Circles: where the "
                      "fit to the curve started from; dashed: where it ended."});
  return plates;
}

std::optional<Plate> teeth_plate(const FittedTest& test) {
  if (!test.analysis.teeth || test.analysis.teeth->teeth.empty()) return std::nullopt;
  return Plate{
      teeth_figure(test),
      "Every rise between two drops, between sliding with friction constant (0) and sticking (1): below 1 the "
      "specimen is drawn in, below 0 friction falls as it is. Thin bars: noise, 95 %; wide grey bars: stiffness "
      "and contact, 95 %, common to all. Orange: as steep as if stuck, which sliding against "
      "steeply rising friction is too. Crosses: a stuck specimen on supports that give way by the one compliance that "
      "fits "
      "best."};
}

std::vector<Plate> cycles_plates(const FittedTest& test) {
  const auto& friction = test.cycles->friction;
  if (friction.status != CyclesStatus::ok && friction.status != CyclesStatus::no_mirror) return {};
  std::vector<Plate> plates;
  plates.push_back(
      {loops_figure(test),
       "Force against deflection, loading (blue) and unloading (red); arrows show the direction. Black: one "
       "friction profile for all loops and both directions, run forward over the stage positions."});
  plates.push_back(
      {boxes_figure(test),
       fmt::format(
           "Top: each loop is a box, sliding in along its upper side, sticking while the stage turns back, sliding "
           "out along the lower one. Below{}: friction of both directions at the same points of the specimen. Bands: "
           "95 %, noise, bending stiffness and contact; the latter two move a whole band. Points that noise throws "
           "beyond the axis are not shown.",
           friction.loops.size() > most_drawn_loops ? fmt::format(", the first {} loops", most_drawn_loops) : "")});
  return plates;
}

std::string provenance_html(const FittedTest& test) {
  const auto& provenance = test.provenance;
  std::string out = fmt::format("<p>FlexSlip {}.", escaped(provenance.version));
  out += fmt::format(
      " Options: models {}; {:g} false alarms a test; friction suspect above {:g}.</p>\n",
      [&] {
        std::string names;
        for (const auto model : provenance.options.fit.models)
          names += (names.empty() ? "" : ", ") + std::string(name_of(model));
        return names;
      }(),
      provenance.options.drops.false_alarms_per_test, provenance.options.suspect_limit);
  PrintedTable files{{"File", "Bytes", "SHA-256"}, {}};
  for (const auto& file : provenance.inputs)
    files.rows.push_back({file.name, file.sha256.empty() ? "" : fmt::format("{}", file.bytes), file.sha256});
  std::string table =
      "<div class=\"scroll\"><table><thead><tr><th>File</th><th>Bytes</th><th>SHA-256</th></tr></thead><tbody>\n";
  for (const auto& row : files.rows)
    table += fmt::format("<tr><td>{}</td><td>{}</td><td><code>{}</code></td></tr>\n", escaped(row[0]), row[1], row[2]);
  out += table + "</tbody></table></div>\n";
  return out + fmt::format("<pre>{}</pre>\n", escaped(provenance.test));
}

std::string page(const FittedTest& test, const std::string& body) {
  const std::string title = test.name + ": friction in a bending test";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, "
      "initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n<p "
      "class=\"answer\">{}</p>\n{}</main>\n"
      "</body>\n</html>\n",
      escaped(title), style, escaped(title), escaped(answer_of(test)), body);
}

std::string paragraph(const std::string& words) { return fmt::format("<p>{}</p>\n", typeset_minus(escaped(words))); }

std::string section(const std::string& title) { return fmt::format("<h2>{}</h2>\n", title); }

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw InputError({.file = folder.string(), .expected = "a folder that can be made", .found = error.message()});
}

}  // namespace

DrawStatus write_report(const std::string& folder, const FittedTest& test) {
  const fs::path base(folder);
  make_folder(base / "figures");
  const std::string report = (base / "report.html").string();
  if (test.analysis.status != AnalysisStatus::ok) {
    write_text(report, page(test, section("Provenance") + provenance_html(test)));
    return DrawStatus::drawn;
  }
  const auto& analysis = test.analysis;
  DrawStatus drawn = DrawStatus::drawn;
  int number = 0;
  const auto figure = [&](const Plate& plate) {
    drawn = draw(plate.figure, (base / "figures").string(), {"svg", "pdf", "png"});
    return html_figure(base, plate, drawn, ++number);
  };
  std::vector<std::string> figures;
  for (const auto& plate : plates_of(test)) figures.push_back(figure(plate));

  std::string body = figures[0] + figures[1];
  body += section("Friction") + parameter_table(test) + paragraph(friction_in_literature(test));
  body += section("Which model") + html_table(model_table(test), analysis.fit.chosen) +
          "<p class=\"note\">The model of least BIC is chosen. Differences below 6 say little.</p>\n";
  if (figures.size() > 2) {
    body += figures[2];
    if (!analysis.fit.scan.candidates.empty())
      body += paragraph("The wavelengths that the fit started from, the likeliest first:") +
              html_table(wavelength_table(test));
  }
  body += section("Drops and slips") + paragraph(slips_in_words(test));
  if (!analysis.drops.drops.empty()) body += html_table(drop_table(test));
  if (!analysis.drops.drops.empty() || !analysis.model.snaps.empty())
    body += section("Snaps of the model") + paragraph(snaps_in_words(test));
  if (!analysis.model.snaps.empty()) body += html_table(snap_table(test));
  body += section("Stick or slide") + paragraph(teeth_in_words(test));
  if (const auto plate = teeth_plate(test)) body += figure(*plate) + html_table(tooth_table(test));
  if (test.cycles) {
    body += section("Load and unload");
    for (const auto& plate : cycles_plates(test)) body += figure(plate);
    for (const auto& words : cycles_in_words(test)) body += paragraph(words);
    if (const auto table = loop_table(test); !table.rows.empty())
      body += html_table(table) + html_table(loop_energy_table(test));
    body += paragraph(reloading_in_words(test)) + html_table(loading_table(test));
  }
  body += section(test.cycles ? "Where the work of the first loading went" : "Where the work went") +
          html_table(energy_table(test));
  body += section("Can it be trusted?") + paragraph(suspicion_in_words(test)) + paragraph(replay_in_words(test));
  body += section("What was assumed") + "<ul>\n";
  for (const auto& sentence : assumptions_of(test)) body += fmt::format("<li>{}</li>\n", escaped(sentence));
  body += "</ul>\n" + section("Provenance") + provenance_html(test);
  write_text(report, page(test, body));
  return drawn;
}

}  // namespace flexslip
