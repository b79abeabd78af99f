#include "campaign/campaign_run.h"

#include <exception>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "campaign/campaign_store.h"
#include "case/fitted.h"
#include "io/parallel.h"
#include "io/sha256.h"
#include "io/table.h"

namespace flexslip {
namespace {

// All that the answer depends on.
std::string key_of(const PlannedTest& planned, const Test& input, const AnalysisOptions& options,
                   const std::string& presented) {
  const std::string source = input.source.empty() ? "" : digest_of(*open_to_read(input.source)).sha256;
  return sha256_of(fmt::format("{}\n{}\n{}\n{}\n{}\npresented {}\n{}\n{}\n", FLEXSLIP_VERSION, source, planned.name,
                               planned.file, analysis_fields()(options, {}).dump(), presented, to_toml(input),
                               digest_of(*open_to_read(input.record.value().file)).sha256));
}

// A device has no end, and standard input no second reading.
void require_file(const std::string& file) {
  std::error_code missing;
  if (std::filesystem::exists(file, missing) && !std::filesystem::is_regular_file(file, missing))
    throw InputError({.file = file, .expected = "a file", .found = "a folder or a device"});
}

class Runner {
 public:
  Runner(const std::vector<PlannedTest>& plan, const CampaignOptions& options)
      : plan_(plan), options_(options), tests_(plan.size()) {
    if (options.folder) store_.emplace(*options.folder);
  }

  CampaignRun run() {
    for_each_index(plan_.size(), options_.threads, [this](std::size_t i) {
      if (options_.stop && options_.stop->load()) return;
      finish(i, computed(plan_[i]));
    });
    CampaignRun result{CampaignStatus::ok, {}, found_};
    std::vector<TestSummary> summaries;
    for (auto& test : tests_) {
      if (!test) {
        result.status = CampaignStatus::stopped;
        continue;
      }
      if (test->summary) summaries.push_back(*test->summary);
      result.campaign.tests.push_back(std::move(*test));
    }
    result.campaign.categories = summarise(summaries);
    return result;
  }

 private:
  struct Computed {
    CampaignTest test;
    bool found;
  };

  Computed computed(const PlannedTest& planned) const {
    std::string key;
    std::optional<FittedTest> test;
    try {
      if (const auto* error = std::get_if<InputError>(&planned.input)) throw InputError(*error);
      const Test& input = std::get<Test>(planned.input);
      const AnalysisOptions options = options_.analysis(input);
      require_file(input.record.value().file);
      if (store_) key = key_of(planned, input, options, options_.presented);
      if (store_)
        if (auto kept = store_->find(planned.name, key)) return {std::move(*kept), true};
      test = fit_test(input, options);
      test->name = planned.name;
    } catch (const std::exception& error) {
      if (store_) store_->emptied_folder(planned.name);
      return {failed_test(planned.name, planned.file, error.what()), false};
    }
    const CampaignTest line = campaign_test_of(*test, planned.file);
    if (!store_) return {line, false};
    const auto folder = store_->emptied_folder(planned.name);
    if (options_.present) options_.present(*test, folder.string());
    store_->keep(line, key);
    return {campaign_test_from(to_text(line)).value(), false};  // as a later run finds it
  }

  void finish(std::size_t index, Computed computed) {
    const std::lock_guard lock(mutex_);
    tests_[index] = std::move(computed.test);
    found_ += computed.found;
    ++done_;
    if (options_.progress) options_.progress(done_, plan_.size());
  }

  const std::vector<PlannedTest>& plan_;
  const CampaignOptions& options_;
  std::optional<CampaignStore> store_;
  std::mutex mutex_;  // guards all below
  std::vector<std::optional<CampaignTest>> tests_;
  std::size_t done_ = 0;
  std::size_t found_ = 0;
};

}  // namespace

CampaignRun run_campaign(const std::vector<PlannedTest>& plan, const CampaignOptions& options) {
  return Runner(plan, options).run();
}

}  // namespace flexslip
