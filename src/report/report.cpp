#include "report/report.h"

#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

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

// The verdict, the rows and the objections; specimen, rig, file, date, command and citation.
std::string head_of(const FittedTest& test, const Answer& answer) {
  const Test& input = test.measurement.test;
  const Print print(test);
  const double stiffness = rig_stiffness_of(input);
  Rows rows = rows_of(answer);
  if (std::string checks = checks_in_words(answer); !checks.empty()) rows.push_back({"checks", std::move(checks)});
  if (!answer.next.empty()) rows.push_back({"next", answer.next});
  const Rows source{
      {"rig", fmt::format("span {}, load train {}", print.length(1),
                          std::isfinite(stiffness) ? print.own(stiffness, kind::stiffness) : "infinitely stiff")},
      {"file", fmt::format("{}, rows {} to {}", test.measurement.file, file_row(test, 0), last_row(test))},
      // A test given by options is a case, too; it is listed under Provenance.
      {"made", fmt::format("{}, by FlexSlip {}: flexslip fit {}", date_of_today(), test.provenance.version,
                           input.source.empty() ? "CASE.toml, the case below" : input.source)},
      {"model", "Fang, Kochiyama and Kesari (2021), J. Mech. Behav. Biomed. Mater., 104787"}};
  return answer_in_html(fmt::format("{} {}", answer.verdict.meaning, answer.verdict.evidence), &answer.verdict) +
         in_html({{"", {rows}}}, {}) + fmt::format("<div class=\"source\">{}</div>\n", in_html({{"", {source}}}, {}));
}

}  // namespace

Drawing write_report(const std::string& folder, const FittedTest& test, const std::string& studio) {
  const std::string link = studio.empty() ? ""
                                          : fmt::format(
                                                "<p class=\"files\"><a href=\"{}\">Open this test in the studio</a>: "
                                                "see it move, change it, fit it again, in this browser.</p>\n",
                                                html_escaped(studio));
  return write_page(folder, test.name + ": friction in a bending test", head_of(test, answer_of(test)) + link,
                    document_of(test));
}

void announce_report(CallFiles& files, const std::string& folder, const std::string& option) {
  files.writes(fs::path(folder) / "report.html", option);
  files.writes_below(fs::path(folder) / "figures", option);
  if (built_studio_page()) files.writes(fs::path(folder) / studio_name, option);
}

Drawing write_report_with_studio(const std::string& folder, const FittedTest& test) {
  const auto built = built_studio_page();
  if (!built || test.measurement.file == "-") return write_report(folder, test);
  make_folder(folder);
  write_studio_page((fs::path(folder) / studio_name).string(), *built,
                    {with_its_files(read_case(std::string_view(test.provenance.test), ""), test.name)});
  return write_report(folder, test, studio_name);
}

}  // namespace flexslip
