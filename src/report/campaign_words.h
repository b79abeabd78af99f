// A campaign in words and in tables for people: what the report and the terminal lay out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign.h"
#include "finding/printed.h"

namespace flexslip {

// How many tests, what sawtooth, what friction, how it lies to the literature, what is suspect and what failed.
std::string answer_of(const Campaign& campaign);

// What the clear, nominal and other tests have in common: mean (min to max), a row with its suspects and one without.
PrintedTable category_rows(const Campaign& campaign);

// An estimate in print, "0.519 (0.40 to 0.64)" or "0.519 ± 0.060", in a unit that is `factor` of its own.
using WriteEstimate = std::string(const Estimate& estimate, double factor);
WriteEstimate with_interval, with_error;

// A row for each test with an answer, in the order of the campaign. The first cell is its name, as printable(), the last its remarks.
PrintedTable test_rows(const Campaign& campaign, WriteEstimate* written);

// Some columns of a table, by what their headings begin with.
// Domain:     headings of the table; std::invalid_argument otherwise.
PrintedTable picked(const PrintedTable& table, const std::vector<std::string_view>& columns);

// A row for each test without.
PrintedTable failure_rows(const Campaign& campaign);

// A row for each shared parameter; what agreement means.
PrintedTable shared_rows(const Campaign& campaign);
std::string sharing_rule();

// A row for each category and parameter of friction: what the specimens have in common, and how they differ; what its columns mean.
PrintedTable specimen_rows(const Campaign& campaign);
std::string specimen_rule();

// The rule of the categories, and what the columns of test_rows are.
std::string category_rule();

// What the literature gives for the materials, if all tests state the same ones.
std::optional<LiteratureFriction> literature_of(const Campaign& campaign);

// Which tests are suspect, one sentence; empty if none is.
std::string suspects_in_words(const Campaign& campaign);

}  // namespace flexslip
