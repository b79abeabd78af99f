// Excel workbooks (.xlsx, .xlsm): a sheet of one as text, for whatever reads tables as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

enum class SheetHolds {
  numbers,        // as numbers: they have decimal points and no other marks
  words,          // numbers as words, most of them, with the marks of some country
  lines_of_text,  // words in one column alone: a text file that was opened as a workbook
};

struct WorkbookSheet {
  std::string name;
  std::vector<std::string> sheets;  // the names of all that hold cells, in their order
  std::string text;                 // row n of the sheet is line n, cells apart by tabs (worksheet.h)
  SheetHolds holds;
  std::vector<std::string> notes;  // what was decided
};

// Do the bytes begin as those of an archive or of an old office document do? No table of text does.
bool is_packed(std::string_view bytes);

// A sheet of a workbook, by name or number from 1: the first visible one with a number, if none is wanted.
// Fails:      InputError, without a file, that says what to do: with a password, .xls, .xlsb, .ods, .numbers, another archive; damaged;
//             no such sheet; none with a number.
// Cost:       10^5 rows of three columns in about 0.3 s, and the memory of their text.
WorkbookSheet read_sheet(std::string_view bytes, const std::optional<std::string>& wanted = {});

}  // namespace flexslip
