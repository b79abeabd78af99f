// Excel workbooks (.xlsx, .xlsm): a sheet of one as cells that know what they hold.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// Which sheet of a workbook: its number from 1, or its name, which may be a number in words where no sheet is called that.
using SheetChoice = std::variant<std::string, std::size_t>;

// What a sheet is read for.
enum class SheetFor {
  readings,  // of columns to be found; where no sheet is chosen, the first visible one with three rows of readings or more, else that for words
  titled_readings,  // of columns that somebody names; likewise
  words,            // the first visible one with a number
};

struct WorkbookSheet {
  std::string name;
  std::vector<std::string> sheets;  // the names of all that hold cells, in their order
  std::vector<std::string>
      alike;  // those that hold readings below the same titles, where none is wanted and there are several: one specimen each
  // Row n is line n - 1. Numbers as the workbook has them, digit for digit; formulas by their stored values; TRUE and FALSE; dates as the
  // numbers of days that they are.
  Sheet cells;
  std::optional<std::string> text;  // instead, of words in one column alone: a text file that was opened as a workbook
  std::string which;                // it is, and why, of several sheets; the first of the notes
  std::vector<std::string> notes;   // what was decided
};

// Do the bytes begin as those of an archive or of an old office document do? No table of text does.
bool is_packed(std::string_view bytes);

// A sheet of a workbook: that wanted, or the one that suits.
// Fails:      InputError, without a file, that says what to do: with a password, .xls, .xlsb, .ods, .numbers, another archive; damaged;
//             no such sheet; none with a number; a cell that is out of place or no number; more than 512 MiB of text or 2^26 cells.
// Cost:       10^5 rows of three columns in about 0.3 s, of all sheets that may be alike, and the memory of their text and five bytes a cell.
WorkbookSheet read_sheet(std::string_view bytes, const std::optional<SheetChoice>& wanted = {},
                         SheetFor purpose = SheetFor::readings);

// What a number is shown as by a format of a workbook: its number, and its code if it is none of those built in.
CellKind kind_of_format(std::size_t number, std::string_view code = {});

}  // namespace flexslip
