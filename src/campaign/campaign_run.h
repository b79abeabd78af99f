// A campaign computed: every test on its own, on as many threads as wanted, with the same answers for any number of them;
// each test kept in a folder, so that a run that was stopped goes on.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "campaign/campaign_plan.h"

namespace flexslip {

// What a campaign has computed so far, in a folder: a file a test, there whole or not at all, so that a campaign that was
// stopped at any moment goes on where it was.

// The text of a kept test, and back: to the last bit, but that text which is no UTF-8 is made so.
std::string to_text(const CampaignTest& test);
// Fails:      none for what is no such text, or that of another version.
std::optional<CampaignTest> campaign_test_from(const std::string& text);

class CampaignStore {
 public:
  // Fails:      InputError if the folder cannot be made.
  explicit CampaignStore(std::filesystem::path folder);

  // Where the files of a test are to be written: an empty folder, so that nothing in it is of another run.
  // Fails:      InputError if it cannot be made or emptied.
  std::filesystem::path emptied_folder(const std::string& test) const;

  // A test that was kept under this key; none if it was kept under another, or not at all. A key says all that the answer
  // depends on.
  std::optional<CampaignTest> find(const std::string& test, const std::string& key) const;

  // Domain:     emptied_folder(test.name) has been called.
  // Fails:      InputError if it cannot be written.
  void keep(const CampaignTest& test, const std::string& key) const;

 private:
  std::filesystem::path folder_;
};

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
  const std::atomic<bool>* stop = nullptr;  // becomes true: no further test is begun, and those under way are given up
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
CampaignRun run_campaign(const CampaignPlan& plan, const CampaignOptions& options);

}  // namespace flexslip
