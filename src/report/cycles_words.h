// What a load-unload-reload test says, in words and as tables.
#pragma once

#include <string>
#include <vector>

#include "case/fitted.h"
#include "finding/printed.h"

namespace flexslip {

// Domain of all: analysis.status is ok, test.cycles is given.

// Paragraphs. If the loops say nothing, one that says why.
std::vector<std::string> cycles_in_words(const FittedTest& test);

// What friction that builds up after a reversal leaves of the height of waves and roughness as fitted; "" where none is told.
std::string smoothing_in_words(const FittedTest& test);

// Friction in both directions, and what work was put in and given back; no rows if the loops say nothing.
PrintedTable loop_table(const FittedTest& test);
PrintedTable loop_energy_table(const FittedTest& test);

// Stiffness of every loading against that of the first.
std::string reloading_in_words(const FittedTest& test);
PrintedTable loading_table(const FittedTest& test);

}  // namespace flexslip
