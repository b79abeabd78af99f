// What a fitted test says: the answer on one screen, and all of it as the document that the text on a terminal and the report lay out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"
#include "report/document.h"

namespace flexslip {

// How the screen is laid out.
struct ScreenStyle {
  std::size_t width = line_length;  // [characters]
  bool colour = false;              // bold, and a colour for the verdict, as terminals take it
};

// The verdict with its numbers on the first line; the rows; at most three doubts, each with its remedy; the checks; one next step. 24 lines at
// most on a terminal of 100 characters or more (tests/outside/fit.py).
std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style = {});

// The rows of an answer and what stands against it, each doubt with its remedy; the checks and the next step, a line.
Rows rows_of(const Answer& answer);
std::string last_line_of(const Answer& answer);

// What the rows leave to tell. Of a test of any status; the test must outlive it.
std::vector<Chapter> document_of(const FittedTest& test);

// The screen and the document, for a terminal.
std::string fit_text(const FittedTest& test);

// Why a test has no answer, and what to look at; "" if it has one.
std::string why_no_answer(const FittedTest& test);

// The steps from the file to the record.
Rows preparation_rows(const Preparation& preparation);

// What the literature gives for the materials that the case states.
std::optional<LiteratureFriction> literature_of(const FittedTest& test);

inline constexpr std::size_t listed_explanations = 8;

}  // namespace flexslip
