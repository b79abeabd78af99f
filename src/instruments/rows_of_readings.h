// Which rows of a table are readings: those of statistics below them are none.
#pragma once

#include <string>
#include <vector>

#include "instruments/export_cells.h"
#include "instruments/layout.h"

namespace flexslip {

// Takes the rows of statistics (io/statistics_rows.h) off a table, by their labels, or without one by their numbers in the columns that
// hold numbers. What is said of them, and of a few rows that stand below a break: empty if there is nothing to say.
std::string leave_out_statistics(TableBlock& block, const ExportCells& cells, const std::vector<bool>& numeric);

}  // namespace flexslip
