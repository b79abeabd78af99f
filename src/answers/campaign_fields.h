// What `campaign` tells of many tests, described once.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/campaign.h"
#include "result/fields.h"
#include "result/table.h"

namespace flexslip {

// What the specimens of a category have in common in one parameter, and how they differ.
struct SpecimenLine {
  std::string category;   // as key_of
  std::string parameter;  // "mu0", "roughness", "correlation_length"
  std::string unit;       // SI
  bool
      by_factors;  // the population is one of logarithms: typical and spreads are exp of them, and specimens differ by factors
  Population population;
};
std::vector<SpecimenLine> specimen_lines(const Campaign& campaign);

// "clear", "nominal", "none", or "all".
std::string_view key_of(const CategorySummary& category);

// Of `campaign --json`.
const Fields<Campaign>& campaign_fields();
Json campaign_json(const Campaign& campaign);

// The columns of its tables.
struct CategoryLine {
  std::string_view key, suspects;
  const CategorySpread* spread;
};
Fields<CampaignTest> test_columns();
Fields<CategoryLine> category_columns();
Fields<SpecimenLine> specimen_columns();

// A row per test, those that failed among them; a category with its suspects and without, and all tests; what specimens have in common,
// a row per category and parameter; a row per test without an answer. Units: SI.
ResultTable test_table(const Campaign& campaign);
ResultTable category_table(const Campaign& campaign);
ResultTable specimen_table(const Campaign& campaign);
ResultTable failure_table(const Campaign& campaign);

// All of them that say something, in the units that read best, under their names in a workbook.
std::vector<std::pair<std::string, ResultTable>> sheets_of(const Campaign& campaign);

}  // namespace flexslip
