// Excel workbooks (.xlsx, .xlsm): one sheet as cells with their kinds.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// The choice of a sheet: its number from 1, or its name. A name of digits is a number if no sheet
// has this name.
using SheetChoice = std::variant<std::string, std::size_t>;

// The purpose for which a sheet is read. It decides which sheet is taken if the user chooses no sheet.
enum class SheetFor {
  readings,         // detected columns: the first visible sheet with three rows of readings, or else as words
  titled_readings,  // columns named by the user: the same sheet
  words,            // the first visible sheet with a number
};

struct WorkbookSheet {
  std::string name;
  std::vector<std::string> sheets;  // the names of all sheets with cells, in order
  std::vector<std::string> alike;   // sheets with the same titles; empty if one was chosen or there is one only
  // Row n is line n - 1. Numbers have all digits of the workbook, formulas their stored values, and
  // dates are numbers of days.
  Sheet cells;
  std::optional<std::string>
      text;           // instead of cells: words in one column only, from a text file that was opened as a workbook
  std::string which;  // which of several sheets was read, and why; the first note
  std::vector<std::string> notes;  // decisions
};

// True if the bytes begin like an archive or an old office document. No text table does.
bool is_packed(std::string_view bytes);

// Reads the chosen sheet of a workbook, or a suitable one.
// Fails:      InputError, without a file, with a remedy: a password, .xls, .xlsb, .ods, .numbers,
//             or another archive; a damaged file; no such sheet; no sheet with a number; a cell out
//             of order or with an invalid number; more than 512 MiB of text or 2^26 cells.
// Cost:       0.3 s for 10^5 rows of three columns, for each sheet with the same titles. Memory:
//             the text and 5 bytes a cell.
WorkbookSheet read_sheet(std::string_view bytes, const std::optional<SheetChoice>& wanted = {},
                         SheetFor purpose = SheetFor::readings);

// The kind of value that a number format displays. `code` is the format code if the format is not
// built in.
CellKind kind_of_format(std::size_t number, std::string_view code = {});

}  // namespace flexslip
