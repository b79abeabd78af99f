// Tables of results as a workbook, for spreadsheets.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "result/table.h"

namespace flexslip {

// A sheet a table, under its name: numbers stay numbers, shown with four digits; names are never formulas; titles are frozen. The same tables give the
// same bytes: the date is SOURCE_DATE_EPOCH, or 1980.
// Fails:      InputError if it cannot be written.
void write_workbook(const std::string& path, const std::string& title,
                    const std::vector<std::pair<std::string, ResultTable>>& sheets);

}  // namespace flexslip
