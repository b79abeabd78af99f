// What a campaign says, as the one content of all formats: tables of numbers and words whose columns state their units.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cases/campaign_test.h"
#include "io/quantity.h"

namespace flexslip {

// Nothing, a number in the unit of its column, or words.
using Cell = std::variant<std::monostate, double, std::string>;

struct CampaignColumn {
  std::string name;          // "wavelength_low"
  std::optional<Kind> kind;  // of numbers; none: words
  std::string unit;          // empty for words and plain numbers
  std::string meaning;       // in a few words
  std::string quantity;      // "wavelength": columns of one quantity have one unit; empty for words
};

struct CampaignTable {
  std::string name;  // "tests"
  std::vector<CampaignColumn> columns;
  std::vector<std::vector<Cell>> rows;
};

// What the specimens of a category have in common in one parameter, and how they differ.
struct SpecimenLine {
  std::string category;       // as key_of
  std::string parameter;      // "mu0", "roughness", "correlation_length"
  std::string unit;           // SI
  bool by_factors;            // specimens differ by factors, exp of the spread; else by the spread itself
  ParameterEstimate typical;  // the mean, or exp of the mean logarithm
  ParameterEstimate spread;   // standard deviation, or exp of that of the logarithm
  const BetweenSpecimens* between;
};
std::vector<SpecimenLine> specimen_lines(const Campaign& campaign);

// A row per test, those that failed among them; a category with its suspects and without, and all tests; what specimens have in common,
// a row per category and parameter; a row per test without an answer; a row per shared parameter. Units: SI.
CampaignTable test_table(const Campaign& campaign);
CampaignTable category_table(const Campaign& campaign);
CampaignTable specimen_table(const Campaign& campaign);
CampaignTable failure_table(const Campaign& campaign);
CampaignTable shared_table(const Campaign& campaign);

// What a column is shown in.
struct TableUnit {
  std::string name;  // as parse_unit takes it
  double factor;     // from SI
};

// That of the median, which a single odd test does not move. NaN is passed over.
TableUnit best_unit_of(std::vector<double> values, const Kind& kind);

// That of one number in an SI unit, or in "1".
TableUnit print_unit(double value, const std::string& si_unit);

// The units in which the tests of a campaign are printed.
struct CampaignUnits {
  TableUnit wavelength, bending_stiffness, residual, work;
};
CampaignUnits units_of(const Campaign& campaign);

// The same table with every quantity in the unit that suits its first column.
// Domain:     units in SI.
CampaignTable in_best_units(CampaignTable table);

// "clear", "nominal", "none", or "all".
std::string key_of(const CategorySummary& category);

// Text that every format takes: valid UTF-8 without control characters, what is neither replaced by U+FFFD or a space.
std::string printable(std::string_view text);

// CSV, units in the titles, the shortest digits that read back to the same bits; "nan" where there is no number.
// Fails:      InputError if it cannot be written.
void write_campaign_csv(const std::string& path, const CampaignTable& table);

}  // namespace flexslip
