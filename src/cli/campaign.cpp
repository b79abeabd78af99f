#include "campaign/campaign.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/campaign_fields.h"
#include "campaign/campaign_run.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "report/answer_documents.h"
#include "report/report.h"

namespace flexslip {
namespace {

struct CampaignRequest {
  std::string path;
  std::optional<std::string> common;
  std::vector<std::string> changes;
  std::string report;
  double figure_width = 17;  // [cm]
  bool figures = true;
  bool test_reports = false;
  bool full = false;
  unsigned jobs = 1;
  AnalysisChoice flags;
  Output output;
};

CampaignOptions campaign_options(const CampaignRequest& request) {
  CampaignOptions options;
  options.analysis = [&request](const Test& input) { return options_for(input, request.flags); };
  options.threads = request.jobs;
  options.stop = &interrupted();
  if (!request.report.empty())
    keep_tests_in(request.report, request.test_reports, options, 10 * request.figure_width, request.output.csv);
  options.progress = progress_of("tests", request.output);
  return options;
}

void run_campaign_command(const CampaignRequest& request) {
  const CampaignPlan plan = plan_campaign(request.path, request.common, request.changes);
  const CampaignOptions options = campaign_options(request);
  const auto run = [&] {
    const WhileInterruptible guard;
    return run_campaign(plan, options);
  }();
  if (run.status == CampaignStatus::stopped)
    throw Interrupted(fmt::format("interrupted after {} of {} tests{}", run.campaign.tests.size(), plan.tests.size(),
                                  request.report.empty() ? "; with --report FOLDER they would be kept"
                                                         : "; the same command continues from there"));
  for (const std::string& remark : run.campaign.notes) note(request.output, remark);
  if (run.found > 0)
    note(request.output, fmt::format("{} of {} tests were computed by an earlier run", run.found, plan.tests.size()));
  write_words(
      request.output, [&] { return campaign_json(run.campaign); },
      [&] {
        return request.full ? campaign_text(run.campaign) : campaign_screen(run.campaign, screen_style(request.output));
      });
  if (!request.report.empty())
    note_pictures(request.output,
                  write_campaign_report(request.report, run.campaign,
                                        request.figures ? std::optional(10 * request.figure_width) : std::nullopt,
                                        request.output.csv));
  const auto without_answer = std::count_if(run.campaign.tests.begin(), run.campaign.tests.end(),
                                            [](const CampaignTest& test) { return !is_answered(test); });
  if (without_answer > 0)
    throw CalculationFailed(fmt::format("{}: {} of {} tests gave no answer; --full lists the reasons", request.path,
                                        without_answer, plan.tests.size()));
}

}  // namespace

void add_campaign_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "campaign", "Friction in many measured tests: one table, categories, figures", run_campaign_command);
  add_option(command, "path PATH", request.path,
             "Folder of case files; or, with --common, of data files; or a table (CSV) with one test per row")
      ->required();
  add_option(command, "--common FILE", request.common, "Case file with what all tests have in common");
  add_set_option(command, request.changes);
  add_report_option(command, request.report,
                    "Write report.html, tables, figures and each test's results into this folder; results that are "
                    "already there are not computed again",
                    announce_campaign_report);
  add_figure_width_option(command, request.figure_width);
  command.add_flag("!--no-figures", request.figures, "Write only the tables, without report.html and figures");
  command.add_flag("--test-reports", request.test_reports, "Also write the report of each test, with its figures");
  command.add_flag("--full", request.full, "Print all tests and tables, not only what fits on one screen");
  add_threads_option(command, "-j,--jobs NUMBER", request.jobs, "Number of tests computed at the same time");
  add_analysis_options(command, request.flags);
  add_csv_option(command, request.output);
  add_output_options(command, request.output);
  command.footer(
      "A table has a column for each key of a case file that differs between tests: \"file\", \"diameter [um]\", "
      "\"until\".\n"
      "A test without an answer (CHECK INPUT, NO ANSWER) is listed with the reason, and the exit code is 1. If a run "
      "is interrupted, the\n"
      "same command with the same --report continues where it stopped. The results are identical for any number of\n"
      "jobs.\n\n"
      "Examples:\n"
      "  flexslip campaign tests/ --report report\n"
      "  flexslip campaign exports/ --common rig.toml --report report\n"
      "  flexslip campaign cases.csv --common rig.toml --json");
}

}  // namespace flexslip
