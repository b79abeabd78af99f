// Computes a campaign. Each test is computed separately, and the answers do not depend on the
// number of threads. Every finished test is stored in a folder, so a later run continues an
// interrupted one.
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

// Converts a test to text and back, without loss except that invalid UTF-8 is repaired.
std::string to_text(const CampaignTest& test);
// Fails:      empty if the text is not of this format and version.
std::optional<CampaignTest> campaign_test_from(const std::string& text);

// The stored tests of a campaign, in a folder with one file per test. A file exists completely or not
// at all.
class CampaignStore {
 public:
  // Fails:      throws InputError if the folder cannot be created.
  explicit CampaignStore(std::filesystem::path folder);

  // An empty folder for the files of a test, without files of earlier runs.
  // Fails:      throws InputError if it cannot be created or emptied.
  std::filesystem::path emptied_folder(const std::string& test) const;

  // The test stored under this key; empty if there is none. The key contains everything on which
  // the answer depends.
  std::optional<CampaignTest> find(const std::string& test, const std::string& key) const;

  // Domain:     emptied_folder(test.name) has been called.
  // Fails:      throws InputError if the file cannot be written.
  void keep(const CampaignTest& test, const std::string& key) const;

 private:
  std::filesystem::path folder_;
};

struct CampaignOptions {
  std::function<AnalysisOptions(const Test&)> analysis = [](const Test&) { return AnalysisOptions{}; };
  unsigned threads = 1;
  // where finished tests are stored and found again by a later run
  std::optional<std::string> folder;
  // Called during the run, by one thread at a time.
  std::function<void(std::size_t done, std::size_t tests)> progress = {};
  // Called once for each computed test, before it is stored, by several threads at once. `folder`
  // is for its files. Its output belongs to the answer; `presented` describes it in the key of the
  // stored test.
  std::function<void(const FittedTest& test, const std::string& folder)> present = {};
  std::string presented = {};
  // if true, no further test starts and running ones are abandoned
  const std::atomic<bool>* stop = nullptr;
};

enum class CampaignStatus {
  ok,
  stopped,  // by `stop`: only the finished `tests` are valid
};

struct CampaignRun {
  CampaignStatus status;
  Campaign campaign;
  std::size_t found;  // number of tests stored by earlier runs
};

// Domain:     threads >= 1.
// Fails:      status `stopped`. Throws InputError if a folder or a file in it cannot be written. A
//             test that fails is listed with its reason.
CampaignRun run_campaign(const CampaignPlan& plan, const CampaignOptions& options);

}  // namespace flexslip
