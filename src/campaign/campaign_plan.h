// The tests of a campaign, before any is computed: from a folder of case files, a folder of data files with what they have in
// common, or a table with a test a row.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case_file.h"
#include "io/input_error.h"

namespace flexslip {

// A name made fit for a folder: no separators, no control characters, not hidden, not too long for a file system.
std::string folder_name(std::string_view name);

struct PlannedTest {
  std::string name;                      // as the user wrote it; folder_name of it is unique in the campaign
  std::string file;                      // what describes the test, as the user named it
  std::variant<Test, InputError> input;  // or why it cannot be read
};

struct CampaignPlan {
  std::vector<PlannedTest> tests;
  std::vector<std::string> notes;  // files left out, records that several tests have, sections that are not stated
};

// The tests of a campaign.
//   a folder                 every case file (.toml) with a [record], in the folder and those below it, by path
//   a folder with `common`   every data file (.csv .tsv .txt .dat .asc .tra .lvm .xlsx) of the folder, by name, but those that the program wrote and
//                            those that hold the rows of another, named as that with an ending, and columns besides ("SS04_dS.csv")
//   a table (any other file) a test a row, a column a key of a case file: "file", "span [um]", "span (mm)", "span_m", "modulus uncertainty [GPa]",
//                            "record.until"; "name" is the name of the test, by default that of its file. An empty cell says
//                            nothing; a column whose title begins with # is not read. Paths are relative to the table.
// `common` is a case file that says what all tests have in common; a row says otherwise where it wants.
// `changes` from the command line (case_changes.h) are made to every test.
// Fails:      InputError for a folder without tests, a table without rows or with a column that is no key, a common case that
//             cannot be read. A test that cannot be read is planned all the same, with its error.
CampaignPlan plan_campaign(const std::string& path, const std::optional<std::string>& common,
                           const std::vector<std::string>& changes = {});

}  // namespace flexslip
