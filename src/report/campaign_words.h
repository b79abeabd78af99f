// A campaign in words and in tables for people: what the report and the terminal lay out.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "report/printed.h"

namespace flexslip {

// How many tests, what sawtooth, what friction, how it lies to the literature, what is suspect and what failed.
std::string answer_of(const Campaign& campaign);

// What the clear, nominal and other tests have in common: mean (min to max), a row with its suspects and one without.
PrintedTable category_rows(const Campaign& campaign);

// A row for each test with an answer, in the order of the campaign. The first cell is its name, as printable().
PrintedTable test_rows(const Campaign& campaign);

// A row for each test without.
PrintedTable failure_rows(const Campaign& campaign);

// A row for each shared parameter; what agreement means.
PrintedTable shared_rows(const Campaign& campaign);
std::string sharing_rule();

// A row for each category and parameter of friction: what the specimens have in common, and how they differ; what its columns mean.
PrintedTable specimen_rows(const Campaign& campaign);
std::string specimen_rule();

// The rule of the categories, and what parentheses mean in test_rows.
std::string category_rule();

// What the literature gives for the materials, if all tests state the same ones.
std::optional<LiteratureFriction> literature_of(const Campaign& campaign);

// Which tests are suspect, one sentence; empty if none is.
std::string suspects_in_words(const Campaign& campaign);

}  // namespace flexslip
