// The fields of `campaign` answers.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/campaign.h"
#include "result/fields.h"
#include "result/table.h"

namespace flexslip {

// One parameter of a category: the typical value of its specimens, and their spread.
struct SpecimenLine {
  std::string category;   // as key_of
  std::string parameter;  // "mu0", "roughness", "correlation_length"
  std::string unit;       // SI
  // The population describes logarithms: its typical value and spreads are exp of them.
  bool by_factors;
  Population population;
};
std::vector<SpecimenLine> specimen_lines(const Campaign& campaign);

// "clear", "nominal", "none", or "all".
std::string_view key_of(const CategorySummary& category);

// The fields of `campaign --json`.
const Fields<Campaign>& campaign_fields();
Json campaign_json(const Campaign& campaign);

// The columns of the tables.
struct CategoryLine {
  std::string_view key, suspects;
  const CategorySpread* spread;
};
Fields<CampaignTest> test_columns();
Fields<CategoryLine> category_columns();
Fields<SpecimenLine> specimen_columns();

// The tables of a campaign. Units: SI.
// - test_table: one row per test, failed tests included.
// - category_table: one row per category with suspects, one without, and both for all tests.
// - specimen_table: one row per category and parameter.
// - failure_table: one row per test without an answer.
ResultTable test_table(const Campaign& campaign);
ResultTable category_table(const Campaign& campaign);
ResultTable specimen_table(const Campaign& campaign);
ResultTable failure_table(const Campaign& campaign);

// The tables (specimens only if not empty), in readable units, each under its name in a workbook.
std::vector<std::pair<std::string, ResultTable>> sheets_of(const Campaign& campaign);

}  // namespace flexslip
