#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "answers/campaign_fields.h"
#include "answers/fit_fields.h"
#include "answers/profile_fields.h"
#include "campaign/campaign_plan.h"
#include "io/durable_file.h"
#include "io/text_file.h"
#include "report/answer_documents.h"
#include "report/page.h"
#include "report/report.h"
#include "report/workbook.h"
#include "result/table.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

// Escapes a name for a link.
std::string in_link(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                       c == '_' || c == '.' || c == '~';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

// The links to the reports of the tests, in their order; empty if a report is missing.
std::vector<std::string> links_to_tests(const std::string& folder, const Campaign& campaign) {
  std::vector<std::string> links;
  for (const auto& test : campaign.tests) {
    std::error_code unreadable;
    const bool exists = fs::exists(fs::path(folder) / "tests" / folder_name(test.name) / "report.html", unreadable);
    links.push_back(exists ? fmt::format("tests/{}/report.html", in_link(folder_name(test.name))) : "");
  }
  return links;
}

// A file next to report.html.
struct TableFile {
  const char *name, *holds;
  void (*write)(const std::string& path, const Campaign& campaign, const CsvMarks& marks);
};
const std::array table_files{TableFile{"tests.csv", "a row per test, SI",
                                       [](const std::string& path, const Campaign& campaign, const CsvMarks& marks) {
                                         write_csv(path, test_table(campaign), marks);
                                       }},
                             TableFile{"categories.csv", "a row per category, SI",
                                       [](const std::string& path, const Campaign& campaign, const CsvMarks& marks) {
                                         write_csv(path, category_table(campaign), marks);
                                       }},
                             TableFile{"specimens.csv", "typical specimen and spread of each category, SI",
                                       [](const std::string& path, const Campaign& campaign, const CsvMarks& marks) {
                                         write_csv(path, specimen_table(campaign), marks);
                                       }},
                             TableFile{"campaign.json", "all of it, for scripts",
                                       [](const std::string& path, const Campaign& campaign, const CsvMarks&) {
                                         write_json(path, campaign_json(campaign));
                                       }},
                             TableFile{"campaign.xlsx", "for spreadsheets",
                                       [](const std::string& path, const Campaign& campaign, const CsvMarks&) {
                                         write_workbook(path, "Friction in bending tests", sheets_of(campaign));
                                       }}};

// True for unfinished files of an interrupted run, and for atlas pages, because their number may
// have decreased.
bool is_old_figure(const fs::path& file) {
  return is_unfinished(file) || file.filename().string().starts_with("atlas-");
}

void remove_from(const fs::path& folder, bool (*is_old)(const fs::path&)) {
  std::error_code error;
  std::vector<fs::path> old;
  for (auto file = fs::directory_iterator(folder, error); !error && file != fs::directory_iterator();
       file.increment(error))
    if (is_old(file->path())) old.push_back(file->path());
  for (const auto& file : old) fs::remove(file, error);
}

}  // namespace

void keep_tests_in(const std::string& folder, bool with_reports, CampaignOptions& options, double figure_width,
                   const CsvMarks& marks) {
  make_folder(folder);
  options.folder = (fs::path(folder) / "tests").string();
  options.present = [with_reports, figure_width, marks](const FittedTest& test, const std::string& folder_of_test) {
    const fs::path base(folder_of_test);
    write_json((base / "fit.json").string(), fit_json(test));
    write_curves((base / "curves.csv").string(), test, marks);
    write_profile((base / "profile.csv").string(), test, marks);
    if (with_reports) write_report(folder_of_test, test, figure_width);
  };
  options.presented = with_reports ? "report" : "";
}

Drawing write_campaign_report(const std::string& folder, const Campaign& campaign, std::optional<double> figure_width,
                              const CsvMarks& marks) {
  make_folder(folder);
  remove_from(folder, is_unfinished);
  for (const TableFile& file : table_files) file.write((fs::path(folder) / file.name).string(), campaign, marks);
  if (!figure_width) return {};
  remove_from(fs::path(folder) / "figures", is_old_figure);
  std::vector<Chapter> chapters = document_of(campaign, with_interval, links_to_tests(folder, campaign));
  AccompanyingFiles files;
  for (const TableFile& file : table_files) files.files.push_back({file.name, file.holds});
  chapters.push_back({"Files", {files, fmt::format("FlexSlip {}.", FLEXSLIP_VERSION)}, Folding::always});
  return write_page(folder, "Friction in a campaign of bending tests",
                    answer_in_html(campaign_in_short(campaign)) + in_html({{"", {rows_of(campaign)}}}, {}), chapters,
                    *figure_width);
}

void announce_campaign_report(CallFiles& files, const std::string& folder, const std::string& option) {
  const std::filesystem::path report(folder);
  require_own_report(folder);
  files.writes(report / "report.html", option);
  for (const TableFile& file : table_files) files.writes(report / file.name, option);
  for (const char* name : {"figures", "tests"}) files.writes_below(report / name, option);
  files.keeps_inputs_out_of(report, option);
}

}  // namespace flexslip
