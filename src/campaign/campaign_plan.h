// The plan of a campaign: its tests, before any is computed. They come from a folder of case files,
// a folder of data files with shared settings, or a table with one test per row.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case_file.h"
#include "io/input_error.h"

namespace flexslip {

// A valid name of a folder: without separators and control characters, not hidden, not too long.
std::string folder_name(std::string_view name);

struct PlannedTest {
  // as written by the user; its folder_name is unique in the campaign
  std::string name;
  std::string file;                      // the file with the test, as named by the user
  std::variant<Test, InputError> input;  // InputError: why the test cannot be read
};

struct CampaignPlan {
  std::vector<PlannedTest> tests;
  std::vector<std::string> notes;  // omitted files, duplicate records, missing sections
};

// The tests of a campaign, from `path`:
// - a folder: every case file (.toml) with a [record] in it and in its subfolders, sorted by path.
// - a folder, with `common`: every data file (.csv .tsv .txt .dat .asc .tra .lvm .xlsx) in it,
//   sorted by name. Omitted are files written by FlexSlip, and copies of another file with extra
//   columns and a longer name ("SS04_dS.csv").
// - any other file: a table with one row per test and one column per key of a case file: "file",
//   "span [um]", "span (mm)", "span_m", "modulus uncertainty [GPa]", "record.until". "name" is the
//   name of the test; default: the name of its file. Empty cells, and columns whose title begins
//   with #, are ignored. Paths are relative to the table.
// `common` is a case file with settings for all tests; a row of a table overrides them. `changes`
// (case_changes.h) apply to every test.
// Fails:      throws InputError if a folder has no tests, a table has no rows or an unknown key, or
//             the common case cannot be read. A test that cannot be read stays in the plan with its
//             error.
CampaignPlan plan_campaign(const std::string& path, const std::optional<std::string>& common,
                           const std::vector<std::string>& changes = {});

}  // namespace flexslip
