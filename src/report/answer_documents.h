// Answers for people: a short sentence, and a document for the terminal, the report and the paper.
// One source per kind of answer: fit_document.cpp, modulus_document.cpp, campaign_document.cpp,
// design_document.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answers/standard_fields.h"
#include "campaign/campaign.h"
#include "case/fitted.h"
#include "design/design_answer.h"
#include "finding/finding.h"
#include "report/document.h"
#include "report/screen.h"
#include "result/table.h"

namespace flexslip {

// ---- A fitted test

// The answer in at most 12 lines on a terminal of 100 characters or more (tests/outside/fit.py):
// the verdict with its meaning and evidence; rows, each shortened to one line; at most two doubts;
// the next step; the checks.
std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style = {});

// All doubts of an answer, each with its remedy.
Rows full_doubts(const Answer& answer);

// The chapters of the full answer, without its rows.
// Domain:     a test of any status, which must outlive the chapters.
std::vector<Chapter> document_of(const FittedTest& test);

// The full answer for a terminal: all rows, then the chapters.
std::string fit_text(const FittedTest& test);

// The sheets of a workbook: the answer in words, its parameters, and the readings with the fitted
// curve.
std::vector<std::pair<std::string, ResultTable>> sheets_of(const FittedTest& test);

// The reason why a test has no answer, and what to check; "" if it has an answer.
std::string why_no_answer(const FittedTest& test);

// The steps from the file to the record.
Rows preparation_rows(const Measurement& measurement);

// The friction that the literature gives for the stated materials.
std::optional<LiteratureFriction> literature_of(const FittedTest& test);

inline constexpr std::size_t listed_explanations = 8;

// ---- The numbers of the bending standards

// The answer of `modulus` in at most 12 lines on a terminal of 100 characters or more: the modulus
// to quote, the rows, and at most three warnings.
std::string modulus_screen(const std::string& name, const StandardTest& test, const ScreenStyle& style = {});

// The full answer for a terminal: the screen, the definitions, all remarks, and the preparation.
std::string modulus_text(const std::string& name, const StandardTest& test);

// The chapter with these numbers in the document of a fit, compared with the fit.
Chapter small_deflection_chapter(const FittedTest& test);

// Remarks on these numbers, one sentence each; the reason if there are no numbers.
std::vector<std::string> small_deflection_in_words(const StandardTest& test);

// ---- A campaign

// The first line: "4 tests: 3 SLIP, 1 CRACK."; "No tests.".
std::string campaign_in_short(const Campaign& campaign);

// The rows: friction with its conditions, work, causes of the drops, suspect tests.
Rows rows_of(const Campaign& campaign);

// The answer in at most 12 lines on a terminal of 100 characters or more: the counts of the
// verdicts; the rows; at most two tests without an answer; as many tests as there is room for.
std::string campaign_screen(const Campaign& campaign, const ScreenStyle& style = {});

// Prints an estimate as "0.519 (0.40 to 0.64)" or "0.519 ± 0.060", divided by `factor`.
using WriteEstimate = std::string(const Estimate& estimate, double factor);
WriteEstimate with_interval, with_error;

// The document of a campaign: tests, and figures that compare them; folded, categories, spread
// between specimens, details of each test, force curves, meaning of the columns. `written` prints
// the estimates. `links`, if given, lead to the reports of the tests, in their order.
std::vector<Chapter> document_of(const Campaign& campaign, WriteEstimate* written,
                                 const std::vector<std::string>& links = {});

// The full answer for a terminal: all rows, then the chapters.
std::string campaign_text(const Campaign& campaign);

// The friction that the literature gives for the materials, if all tests state the same ones.
std::optional<LiteratureFriction> literature_of(const Campaign& campaign);

// ---- A planned test

// The answer in one sentence.
std::string design_in_short(const DesignAnswer& answer);

// Changes that reverse the answer, one each: "a load train of at least 438 N/m instead of 90.65
// N/m".
std::vector<std::string> changes_in_words(const DesignAnswer& answer);

// The document of a design: the answer, its reasons, the energy account, and the changes.
std::vector<Chapter> document_of(const DesignAnswer& answer);

}  // namespace flexslip
