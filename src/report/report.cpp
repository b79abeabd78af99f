#include "report/report.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/case_file.h"
#include "case/mechanics.h"
#include "finding/answer.h"
#include "finding/printed.h"
#include "io/durable_file.h"
#include "io/text.h"
#include "report/answer_documents.h"
#include "report/page.h"
#include "report/studio_page.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr const char* studio_name = "studio.html";

// Today's date, or SOURCE_DATE_EPOCH for reproducible reports.
std::string date_of_today() {
  const std::tm day = calendar_date(date_of_source(std::time(nullptr)));
  return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

// The verdict, the rows, the objections and the next step.
std::string head_of(const Answer& answer) {
  Rows rows = answer.rows;
  for (AnswerRow& doubt : full_doubts(answer)) rows.push_back(std::move(doubt));
  if (std::string checks = checks_in_words(answer); !checks.empty()) rows.push_back({"checks", std::move(checks)});
  if (!answer.next.empty()) rows.push_back({"next", answer.next});
  return answer_in_html(fmt::format("{} {}", answer.verdict.meaning, answer.verdict.evidence), &answer.verdict) +
         in_html({{"", {rows}}}, {});
}

// The rest of the answer; rig, file, date, command and citation.
Chapter details_of(const FittedTest& test, const Answer& answer) {
  const Test& input = test.measurement.test;
  const Print print(test);
  const double stiffness = rig_stiffness_of(input);
  Rows rows = answer.details;
  const Rows source{
      {"rig", fmt::format("span {}, load train {}", print.length(1),
                          std::isfinite(stiffness) ? print.own(stiffness, kind::stiffness) : "infinitely stiff")},
      {"file", fmt::format("{}, rows {} to {}", test.measurement.file, file_row(test, 0), last_row(test))},
      // A test given by options is a case, too; it is listed under Provenance.
      {"made", fmt::format("{}, by FlexSlip {}: flexslip fit {}", date_of_today(), test.provenance.version,
                           input.source.empty() ? "CASE.toml, the case below" : input.source)},
      {"theory", "Fang, Kochiyama and Kesari (2021), J. Mech. Behav. Biomed. Mater., 104787"}};
  rows.insert(rows.end(), source.begin(), source.end());
  return {"The test", {rows}, Folding::always};
}

}  // namespace

Drawing write_report(const std::string& folder, const FittedTest& test, double figure_width,
                     const std::string& studio) {
  const std::string link = studio.empty() ? ""
                                          : fmt::format(
                                                "<p class=\"files\"><a href=\"{}\">Open this test in the studio</a>: "
                                                "see it move, change it, fit it again, in this browser.</p>\n",
                                                html_escaped(studio));
  const Answer answer = answer_of(test);
  std::vector<Chapter> chapters = document_of(test);
  const auto first_detail = std::find_if(chapters.begin(), chapters.end(),
                                         [](const Chapter& chapter) { return chapter.folding == Folding::always; });
  chapters.insert(first_detail, details_of(test, answer));
  return write_page(folder, test.name + ": friction in a bending test", head_of(answer) + link, chapters, figure_width);
}

void announce_report(CallFiles& files, const std::string& folder, const std::string& option) {
  require_own_report(folder);
  files.writes(fs::path(folder) / "report.html", option);
  files.writes_below(fs::path(folder) / "figures", option);
  if (built_studio_page()) files.writes(fs::path(folder) / studio_name, option);
}

Drawing write_report_with_studio(const std::string& folder, const FittedTest& test, double figure_width) {
  const auto built = built_studio_page();
  if (!built || test.measurement.file == "-") return write_report(folder, test, figure_width);
  make_folder(folder);
  write_studio_page((fs::path(folder) / studio_name).string(), *built,
                    {with_its_files(read_case(std::string_view(test.provenance.test), ""), test.name)});
  return write_report(folder, test, figure_width, studio_name);
}

}  // namespace flexslip
