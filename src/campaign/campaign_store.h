// What a campaign has computed so far, in a folder: a file a test, there whole or not at all, so that a campaign that was
// stopped at any moment goes on where it was.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "campaign/campaign.h"

namespace flexslip {

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

}  // namespace flexslip
