#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/campaign_fields.h"
#include "campaign/campaign.h"
#include "campaign/campaign_run.h"
#include "case/fitted.h"
#include "figures.h"
#include "interruptible.h"
#include "parts.h"
#include "plain.h"
#include "report/answer_documents.h"
#include "report/figures.h"
#include "report/report.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

struct Options {
  std::string model;
  double false_alarms, suspect_limit;
  unsigned jobs;
  std::optional<std::string> report;
  bool figures, test_reports;
};

// Shares stored tests with the command.
std::shared_ptr<Campaign> run(const std::string& path, const std::optional<std::string>& common,
                              const std::vector<std::string>& changes, const Options& asked) {
  return interruptible([&](const std::atomic<bool>& stop) -> std::shared_ptr<Campaign> {
    const CampaignPlan plan = plan_campaign(path, common, changes);
    AnalysisChoice choice{.model = asked.model};
    choice.options.drops.false_alarms_per_test = asked.false_alarms;
    choice.options.suspect_limit = asked.suspect_limit;
    CampaignOptions options;
    options.analysis = [&](const Test& input) { return options_for(input, choice); };
    options.threads = asked.jobs;
    options.stop = &stop;
    if (asked.report) keep_tests_in(*asked.report, asked.test_reports, options);
    CampaignRun computed = run_campaign(plan, options);
    // the signal handler raises an exception
    if (computed.status == CampaignStatus::stopped) return nullptr;
    if (asked.report) write_campaign_report(*asked.report, computed.campaign, asked.figures);
    return std::make_shared<Campaign>(std::move(computed.campaign));
  });
}

py::list figures_of_campaign(const Campaign& campaign) {
  py::list out;
  for (const Plot& figure : comparison_figures(campaign)) out.append(plain(figure));
  for (const Plot& page : atlas_pages(campaign)) out.append(plain(page));
  return out;
}

}  // namespace

void add_campaigns(py::module_& module) {
  py::class_<Campaign, std::shared_ptr<Campaign>>(module, "Campaign")
      .def("answer",
           [](const Campaign& campaign) { return plain(campaign_json(campaign), campaign_fields().descriptions()); })
      .def("test_table", [](const Campaign& campaign) { return plain(test_table(campaign)); })
      .def("figures", figures_of_campaign)
      .def("text", campaign_text);
  module.def("campaign", [](const std::string& path, const std::optional<std::string>& common,
                            const std::vector<std::string>& changes, const std::string& model, double false_alarms,
                            double suspect_limit, unsigned jobs, const std::optional<std::string>& report,
                            bool with_figures, bool test_reports) {
    return run(path, common, changes, {model, false_alarms, suspect_limit, jobs, report, with_figures, test_reports});
  });
}

}  // namespace flexslip::python
