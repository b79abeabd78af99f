// Columns of a workbook whose cells are formatted as dates or clock times.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "instruments/export.h"
#include "instruments/export_cells.h"

namespace flexslip {

// Of the lines and the column, counted from 0, where `numbers` cells hold numbers: what is made of a column whose name, unit and role
// are known, and what is said of it. Empty, and nothing made, if it is none of these:
// - a time whose numbers are all clock times, with a date or without: in its unit, or in seconds;
// - one that means nothing measured, and whose numbers are all dates or clock times: its words.
std::string take_dated(const ExportCells& cells, std::span<const std::size_t> lines, std::size_t column,
                       std::size_t numbers, ExportColumn& out);

}  // namespace flexslip
