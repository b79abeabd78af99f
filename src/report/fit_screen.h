// The answer of one fitted test on one screen.
#pragma once

#include <cstddef>
#include <string>

#include "finding/finding.h"
#include "report/plain_text.h"

namespace flexslip {

// How it is laid out.
struct ScreenStyle {
  std::size_t width = line_length;  // [characters]
  bool colour = false;              // bold, and a colour for the verdict, as terminals take it
};

// The verdict with its numbers on the first line; the rows; at most three doubts, each with its remedy; the checks; one next step. 24 lines at
// most on a terminal of 100 characters or more (tests/outside/fit.py).
std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style = {});

}  // namespace flexslip
