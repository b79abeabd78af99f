#include "cases/campaign_run.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <sstream>
#include <thread>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cases/campaign_store.h"
#include "io/sha256.h"
#include "io/table.h"

namespace flexslip {
namespace {

std::string digest_of_text(const std::string& text) {
  std::istringstream in(text);
  return digest_of(in).sha256;
}

// All that the answer depends on.
std::string key_of(const PlannedTest& planned, const Case& input, const CampaignOptions& options) {
  std::string models;
  for (const auto model : options.analysis.fit.models) models += fmt::format(" {}", name_of(model));
  return digest_of_text(fmt::format(
      "{}\n{}\n{}\nmodels{}\nfalse alarms {}\nsuspect limit {}\npresented {}\n{}\n{}\n", FLEXSLIP_VERSION, planned.name,
      planned.file, models, options.analysis.drops.false_alarms_per_test, options.analysis.suspect_limit,
      options.presented, to_toml(input), digest_of(*open_to_read(input.record.value().file)).sha256));
}

class Runner {
 public:
  Runner(const std::vector<PlannedTest>& plan, const CampaignOptions& options)
      : plan_(plan), options_(options), tests_(plan.size()) {
    if (options.folder) store_.emplace(*options.folder);
  }

  CampaignRun run() {
    {
      std::vector<std::jthread> threads;
      const auto count = std::min<std::size_t>(options_.threads, plan_.size());
      for (std::size_t i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
    }
    if (broken_) std::rethrow_exception(broken_);
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
  void work() {
    while (const auto next = take()) {
      try {
        finish(*next, computed(plan_[*next]));
      } catch (...) {  // nothing can be kept any more
        const std::lock_guard lock(mutex_);
        broken_ = std::current_exception();
      }
    }
  }

  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    const bool stopped = options_.stop && options_.stop->load();
    if (stopped || broken_ || next_ == plan_.size()) return std::nullopt;
    return next_++;
  }

  struct Computed {
    CampaignTest test;
    bool found;
  };

  Computed computed(const PlannedTest& planned) const {
    std::string key;
    std::optional<FittedTest> test;
    try {
      if (const auto* error = std::get_if<InputError>(&planned.input)) throw InputError(*error);
      const Case& input = std::get<Case>(planned.input);
      if (store_) key = key_of(planned, input, options_);
      if (store_)
        if (auto kept = store_->find(planned.name, key)) return {std::move(*kept), true};
      test = fit_test(input, options_.analysis);
      test->name = planned.name;
    } catch (const std::exception& error) {
      return {failed_test(planned.name, planned.file, error.what()), false};
    }
    const CampaignTest line = campaign_test_of(*test, planned.file);
    if (!store_) return {line, false};
    if (options_.present) options_.present(*test, store_->folder_of(planned.name).string());
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
  std::size_t next_ = 0;
  std::size_t done_ = 0;
  std::size_t found_ = 0;
  std::exception_ptr broken_;
};

}  // namespace

CampaignRun run_campaign(const std::vector<PlannedTest>& plan, const CampaignOptions& options) {
  return Runner(plan, options).run();
}

}  // namespace flexslip
