#include "report/report.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "case/case_file.h"
#include "io/text_file.h"
#include "report/answer_words.h"
#include "report/cycles_figures.h"
#include "report/cycles_words.h"
#include "report/fit_figures.h"
#include "report/fit_print.h"
#include "report/fit_words.h"
#include "report/implied_words.h"
#include "report/page.h"
#include "report/preparation_words.h"
#include "report/record_figure.h"
#include "report/small_deflection_words.h"
#include "report/studio_page.h"
#include "report/teeth_figure.h"
#include "report/teeth_words.h"

namespace flexslip {
namespace {

// Two texts, of which the first may be empty.
std::string joined(const std::string& first, const std::string& second) {
  return first.empty() ? second : first + " " + second;
}

namespace fs = std::filesystem;

constexpr const char* studio_name = "studio.html";

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

std::string preparation_section(const FittedTest& test) {
  std::string out = section("From the file to the record") +
                    "<div class=\"scroll\"><table class=\"parameters\">\n<thead><tr><th>Step</th><th>What was "
                    "done</th><th>Value</th><th>Rows</th><th>To change this</th></tr></thead>\n<tbody>\n";
  for (const auto& row : preparation_rows(test.measurement.preparation))
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"value\">{}</td><td "
        "class=\"value\">{}</td><td><code>{}</code></td></tr>\n",
        escaped(row.name), typeset_minus(escaped(row.done)), typeset_minus(escaped(row.value)), escaped(row.rows),
        escaped(row.otherwise));
  return out + "</tbody></table></div>\n";
}

std::vector<Plate> plates_of(const FittedTest& test) {
  const auto& analysis = test.analysis;
  std::vector<Plate> plates;
  plates.push_back(
      {force_figure(test),
       fmt::format(
           "Measured force (blue) and the mean of the fit run forward (black; dashed where it snaps). Orange: "
           "Euler–Bernoulli (dashed) and the model without friction, both with the bending stiffness of the fit. Grey: "
           "load lines (slope: the stiffness of the load train) through the {} drops found. Below: measured minus "
           "model, grey where the force tells too little of friction and the mean is continued as it begins.",
           analysis.drops.drops.size())});
  plates.push_back(
      {profile_figure(test),
       fmt::format(
           "Friction read off the curve point by point, at the bending stiffness of the fit. Bars: 95 % "
           "intervals from the noise of each point. Red-orange: the slips. Black: the mean of the fit; grey band: two "
           "standard deviations about the mean, with the errors of stiffness and contact.{}{}",
           analysis.fit.wave_claimed ? " Orange: the wave claimed." : "",
           literature_of(test) ? fmt::format(" Green: what the literature gives for {} on {}.",
                                             literature_of(test)->specimen, literature_of(test)->support)
                               : "")});
  if (!analysis.fit.scan.empty())
    plates.push_back({wavelength_figure(test),
                      "How much a wave of friction adds to the logarithm of the evidence, against its wavelength. The "
                      "roughness is kept as fitted without a wave; for ln B, wave and roughness are fitted anew. "
                      "Dotted: 3, beyond which a wave is claimed."});
  return plates;
}

std::optional<Plate> teeth_plate(const FittedTest& test) {
  if (!test.analysis.teeth || test.analysis.teeth->teeth.empty()) return std::nullopt;
  return Plate{teeth_figure(test),
               "Every rise between two drops, on a scale from sliding at constant friction (0) to sticking (1). Below "
               "1 the specimen is drawn in; below 0 friction falls at the same time. Thin bars: noise, 95 %. Wide grey "
               "bars: stiffness and contact, 95 %, common to all rises. Orange: cannot be told from sticking; sliding "
               "against steeply rising friction looks the same. Crosses: a stuck specimen on supports that give way by "
               "the one compliance that fits best."};
}

std::vector<Plate> cycles_plates(const FittedTest& test) {
  if (!has_loops(test)) return {};
  const auto& friction = test.cycles->friction;
  std::vector<Plate> plates;
  plates.push_back({loops_figure(test),
                    "Force against deflection, loading (blue) and unloading (red); arrows show the direction. Black: "
                    "one friction profile for all loops and both directions, run forward over the stage positions."});
  plates.push_back(
      {boxes_figure(test),
       fmt::format(
           "Top: each loop is a box. The specimen slides in along its upper side, sticks while the stage turns back, "
           "and slides out along its lower side. Below{}: friction of both directions at the same points of the "
           "specimen. Bands: 95 % intervals from noise, bending stiffness and contact; the last two move a whole band. "
           "Points that noise throws beyond the axis are not shown.",
           friction.loops.size() > most_drawn_loops ? fmt::format(", the first {} loops", most_drawn_loops) : "")});
  return plates;
}

std::string provenance_html(const FittedTest& test) {
  const auto& provenance = test.provenance;
  std::string out = fmt::format("<p>FlexSlip {}.", escaped(provenance.version));
  out += fmt::format(" Options: model {}; {:g} false alarms a test; friction suspect above {:g}.</p>\n",
                     name_of(provenance.options.fit.model), provenance.options.drops.false_alarms_per_test,
                     provenance.options.suspect_limit);
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

}  // namespace

DrawStatus write_report(const std::string& folder, const FittedTest& test, const std::string& studio) {
  const fs::path base(folder);
  make_folder((base / "figures").string());
  const std::string report = (base / "report.html").string();
  const std::string title = test.name + ": friction in a bending test";
  const std::string link =
      studio.empty() ? ""
                     : fmt::format(
                           "<p class=\"files\"><a href=\"{}\">Open this test in the studio</a>: see it move, change "
                           "it, fit it again, in this browser.</p>\n",
                           escaped(studio));
  DrawStatus drawn = DrawStatus::drawn;
  int number = 0;
  const auto figure = [&](const Plate& plate) {
    drawn = draw(plate.figure, (base / "figures").string(), {"svg", "pdf", "png"});
    return html_figure(folder, plate, drawn, ++number);
  };
  const auto& analysis = test.analysis;
  if (analysis.status != AnalysisStatus::ok) {
    const std::string picture =
        analysis.status == AnalysisStatus::not_explained
            ? figure(
                  {record_figure(test),
                   "Measured force (blue). Orange: Euler–Bernoulli (dashed) and the model without friction, both with "
                   "the bending stiffness stated, or that of the initial slope."})
            : "";
    write_text(report,
               page(title, answer_of(test),
                    link + picture + preparation_section(test) + section("Provenance") + provenance_html(test)));
    return drawn;
  }
  std::vector<std::string> figures;
  for (const auto& plate : plates_of(test)) figures.push_back(figure(plate));

  std::string body = link + figures[0] + figures[1];
  body += section("Friction") + paragraph(joined(caution_of(test), friction_in_words(test))) + parameter_table(test) +
          paragraph(joined(strain_in_words(test), friction_in_literature(test)));
  body += section("Does it repeat along the specimen?") +
          paragraph(joined(joined(wave_in_words(test), sides_in_words(test)), smoothing_in_words(test)));
  for (const auto& words : implied_in_words(test)) body += paragraph(words);
  if (figures.size() > 2) body += figures[2];
  if (analysis.fit.explanations.size() > 1)
    body += paragraph("The answer is an average over these explanations, weighted as listed:") +
            html_table(explanation_table(test));
  body += section("Checks") + "<ul>\n";
  for (const auto& words : checks_in_words(test)) body += fmt::format("<li>{}</li>\n", escaped(words));
  body += "</ul>\n";
  body += section("Drops and slips") + paragraph(slips_in_words(test));
  if (!analysis.drops.drops.empty()) body += html_table(drop_table(test));
  if (!analysis.drops.drops.empty() || !analysis.model.snaps.empty())
    body += section("Snaps of the fit's mean") + paragraph(snaps_in_words(test));
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
          (caution_of(test).empty() ? "" : paragraph(caution_of(test))) + html_table(energy_table(test));
  body += section("Can it be trusted?") + paragraph(suspicion_in_words(test)) + paragraph(replay_in_words(test));
  body +=
      section("Small deflection, as the standards have it") + html_table(small_deflection_table(standard_test(test)));
  for (const auto& words : small_deflection_in_words(standard_test(test))) body += paragraph(words);
  body += paragraph(small_deflection_and_fit(test));
  body += preparation_section(test);
  body += section("What was assumed") + "<ul>\n";
  for (const auto& sentence : assumptions_of(test)) body += fmt::format("<li>{}</li>\n", escaped(sentence));
  body += "</ul>\n" + section("Provenance") + provenance_html(test);
  write_text(report, page(title, answer_of(test), body));
  return drawn;
}

void announce_report(CallFiles& files, const std::string& folder, const std::string& option) {
  files.writes(fs::path(folder) / "report.html", option);
  files.writes_below(fs::path(folder) / "figures", option);
  if (built_studio_page()) files.writes(fs::path(folder) / studio_name, option);
}

DrawStatus write_report_with_studio(const std::string& folder, const FittedTest& test) {
  const auto built = built_studio_page();
  if (!built || test.measurement.file == "-") return write_report(folder, test);
  make_folder(folder);
  write_studio_page((fs::path(folder) / studio_name).string(), *built,
                    {taken_along(read_case(std::string_view(test.provenance.test), ""), test.name)});
  return write_report(folder, test, studio_name);
}

}  // namespace flexslip
