#include "report/report.h"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case/case_file.h"
#include "case/mechanics.h"
#include "finding/answer.h"
#include "finding/printed.h"
#include "io/text.h"
#include "io/text_file.h"
#include "report/fit_document.h"
#include "report/page.h"
#include "report/studio_page.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr const char* studio_name = "studio.html";

// Of the day: that of SOURCE_DATE_EPOCH, where it is set, so that a report can be made again to the byte.
std::string date_of_today() {
  const char* asked = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t seconds = asked ? std::strtoll(asked, nullptr, 10) : std::time(nullptr);
  std::tm day{};
  gmtime_r(&seconds, &day);
  return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

std::string row(std::string_view label, const std::string& words) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", label, typeset_minus(html_escaped(words)));
}

// The verdict, the rows, what speaks against it; specimen, rig, file, date, command and citation.
std::string head_of(const FittedTest& test, const Answer& answer) {
  const Test& input = test.measurement.test;
  const Print print(test);
  std::string out = fmt::format("<p class=\"answer\"><b class=\"{}\">{}</b> {}</p>\n", name_of(answer.verdict.code),
                                word_of(answer.verdict.code),
                                typeset_minus(html_escaped(fmt::format("{}", fmt::join(answer.verdict.parts, " · ")))));
  out += "<dl class=\"rows\">\n";
  for (const AnswerRow& each : answer.rows) out += row(each.label, each.words);
  for (const Finding& doubt : doubts_of(answer))
    out += row(name_of(doubt.severity), doubt.sentence + (doubt.remedy.empty() ? "" : " " + doubt.remedy));
  std::string last = checks_in_words(answer);
  if (const std::string next = next_in_words(answer); !next.empty()) last += (last.empty() ? "" : " ") + next;
  out += row("checks", last) + "</dl>\n<dl class=\"rows source\">\n";
  const double stiffness = rig_stiffness_of(input);
  out += row("rig", fmt::format("span {}, load train {}", print.length(1),
                                std::isfinite(stiffness) ? print.own(stiffness, kind::stiffness) : "infinitely stiff"));
  out += row("file", fmt::format("{}, rows {} to {}", test.measurement.file, file_row(test, 0), last_row(test)));
  // What was given by flags is a case all the same: it stands under Provenance.
  out += row("made", fmt::format("{}, by FlexSlip {}: flexslip fit {}", date_of_today(), test.provenance.version,
                                 input.source.empty() ? "CASE.toml, the case below" : input.source));
  out += row("model", "Fang, Kochiyama and Kesari (2021), J. Mech. Behav. Biomed. Mater., 104787");
  return out + "</dl>\n";
}

}  // namespace

DrawStatus write_report(const std::string& folder, const FittedTest& test, const std::string& studio) {
  const fs::path base(folder);
  make_folder((base / "figures").string());
  const std::string link =
      studio.empty() ? ""
                     : fmt::format(
                           "<p class=\"files\"><a href=\"{}\">Open this test in the studio</a>: see it move, change "
                           "it, fit it again, in this browser.</p>\n",
                           html_escaped(studio));
  DrawStatus drawn = DrawStatus::drawn;
  const std::string body = in_html(document_of(test), [&, number = 0](const Plot& plot) mutable {
    drawn = draw(plot, (base / "figures").string(), {"svg", "pdf", "png"});
    return html_figure(folder, plot, drawn, ++number);
  });
  write_text((base / "report.html").string(),
             page(test.name + ": friction in a bending test", head_of(test, answer_of(test)), link + body));
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
