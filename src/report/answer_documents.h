// What the answers say for people: the sentence, and all of it as the document that the text on a
// terminal, the report and the paper lay out. A source each: fit_document.cpp,
// modulus_document.cpp, campaign_document.cpp, design_document.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "answers/standard_fields.h"
#include "campaign/campaign.h"
#include "case/fitted.h"
#include "design/design_answer.h"
#include "finding/finding.h"
#include "report/document.h"

namespace flexslip {

// ---- A fitted test: the answer on one screen, and all of it

// The layout of the screen.
struct ScreenStyle {
  std::size_t width = line_length;  // [characters]
  bool colour = false;              // bold, and a colour for the verdict, for terminals
  bool is_full = false;             // all rows and doubts with all their clauses
};

// The answer in at most 12 lines on a terminal of 100 characters or more (tests/outside/fit.py):
// the verdict with its meaning and evidence; rows, each shortened to one line; at most two doubts;
// the next step; the checks.
std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style = {});

// All rows of an answer, then its doubts, each with its remedy.
Rows rows_of(const Answer& answer);

// The chapters of the full answer, without its rows.
// Domain:     a test of any status, which must outlive the chapters.
std::vector<Chapter> document_of(const FittedTest& test);

// The full answer for a terminal: all rows, then the chapters.
std::string fit_text(const FittedTest& test);

// Why a test has no answer, and what to look at; "" if it has one.
std::string why_no_answer(const FittedTest& test);

// The steps from the file to the record.
Rows preparation_rows(const Measurement& measurement);

// What the literature gives for the materials that the case states.
std::optional<LiteratureFriction> literature_of(const FittedTest& test);

inline constexpr std::size_t listed_explanations = 8;

// ---- The numbers of the bending standards

// All of `modulus`.
std::vector<Chapter> document_of(const StandardTest& test);

// The numbers in the document of a fit, and how they lie to those of the fit.
Chapter small_deflection_chapter(const FittedTest& test);

// What a reader of these numbers should know, sentence by sentence; one that says why if there are
// none.
std::vector<std::string> small_deflection_in_words(const StandardTest& test);

// ---- A campaign

// How many tests, with what verdicts, what friction, what share of the work, what is suspect and
// what failed.
std::string campaign_in_short(const Campaign& campaign);

// An estimate in print, "0.519 (0.40 to 0.64)" or "0.519 ± 0.060", in a unit that is `factor` of
// its own.
using WriteEstimate = std::string(const Estimate& estimate, double factor);
WriteEstimate with_interval, with_error;

// All of it: test by test, by category, between specimens, what tests share, what failed, the force
// curves, what the columns say. The estimates of the tests are written so; links lead to the
// reports of the tests with an answer, in their order, if they are given.
std::vector<Chapter> document_of(const Campaign& campaign, WriteEstimate* written,
                                 const std::vector<std::string>& links = {});

// For a terminal.
std::string campaign_text(const Campaign& campaign);

// What the literature gives for the materials, if all tests state the same ones.
std::optional<LiteratureFriction> literature_of(const Campaign& campaign);

// ---- A planned test

// The answer in a sentence.
std::string design_in_short(const DesignAnswer& answer);

// What to change for it to be otherwise, one change each: "a load train of at least 438 N/m instead
// of 90.65 N/m".
std::vector<std::string> changes_in_words(const DesignAnswer& answer);

// The answer, what decides it, what becomes of the work, and the changes.
std::vector<Chapter> document_of(const DesignAnswer& answer);

// ---- A height trace

// The answer in a sentence; all of it.

}  // namespace flexslip
