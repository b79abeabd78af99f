// Tables of results as a workbook for spreadsheets.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "result/table.h"

namespace flexslip {

// Writes one sheet per table, under its name. Numbers stay numbers, shown with four digits; text is
// never a formula; titles are frozen. The same tables give the same bytes: the date is
// SOURCE_DATE_EPOCH, or 1980.
// Fails:      throws InputError if the file cannot be written.
void write_workbook(const std::string& path, const std::string& title,
                    const std::vector<std::pair<std::string, ResultTable>>& sheets);

}  // namespace flexslip
