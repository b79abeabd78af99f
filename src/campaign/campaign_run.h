// A campaign computed: every test on its own, on as many threads as wanted, with the same answers for any number of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "campaign/campaign_plan.h"

namespace flexslip {

struct CampaignOptions {
  std::function<AnalysisOptions(const Test&)> analysis = [](const Test&) { return AnalysisOptions{}; };
  unsigned threads = 1;
  std::optional<std::string> folder;  // where each test is kept once it is done, and found again by a later run
  // Called while the campaign runs, by one thread at a time.
  std::function<void(std::size_t done, std::size_t tests)> progress = {};
  // Called for each test computed, by several threads at once, with the folder where its files belong; before it is kept.
  // What it does belongs to the answer: `presented` names it, for the key under which a test is kept.
  std::function<void(const FittedTest& test, const std::string& folder)> present = {};
  std::string presented = {};
  const std::atomic<bool>* stop = nullptr;  // becomes true: no further test is begun
};

enum class CampaignStatus {
  ok,
  stopped,  // by `stop`: tests holds those that are done, and nothing else is valid
};

struct CampaignRun {
  CampaignStatus status;
  Campaign campaign;
  std::size_t found;  // tests that a run before had kept
};

// Domain:     threads >= 1.
// Fails:      stopped; InputError if a folder or a file of it cannot be written. A test that fails is listed with its reason.
CampaignRun run_campaign(const std::vector<PlannedTest>& plan, const CampaignOptions& options);

}  // namespace flexslip
