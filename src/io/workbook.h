// Excel workbooks (.xlsx, .xlsm): a sheet of one as text, for whatever reads tables as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/cell_kinds.h"
#include "io/input_error.h"

namespace flexslip {

// Which sheet of a workbook: its number from 1, or its name, which may be a number in words where no sheet is called that.
using SheetChoice = std::variant<std::string, std::size_t>;
std::string shown(const SheetChoice& sheet);  // "'Data'", "2"

// What a sheet is read for, where none is chosen.
enum class SheetFor {
  readings,  // the first visible one with three rows of readings or more, else that for words
  words,     // the first visible one with a number
};

enum class SheetHolds {
  numbers,        // as numbers, most of them: they have decimal points and no other marks
  words,          // numbers as words, most of them, with the marks of some country
  lines_of_text,  // words in one column alone: a text file that was opened as a workbook
};

struct WorkbookSheet {
  std::string name;
  std::vector<std::string> sheets;  // the names of all that hold cells, in their order
  std::string text;                 // row n of the sheet is line n, cells apart by tabs (worksheet.h)
  SheetHolds holds;
  std::vector<std::string> notes;  // what was decided
  CellKinds kinds{};               // which of its cells are dates, or numbers as words
  bool dates_from_1904 = false;    // or from 1900
  bool is_chosen = false;          // by who called

  // The refusal of a cell that holds a date or a clock time where a number is wanted, with its place and a remedy.
  InputError dated(const std::string& file, std::size_t row, std::size_t column, double days,
                   std::string_view expected) const;
};

// An error in what a sheet holds that nobody chose, with the others in its remedy: is the table on one of them? One in a single cell is left as it is.
InputError with_other_sheets(const InputError& error, const std::string& name, const std::vector<std::string>& sheets);

// Do the bytes begin as those of an archive or of an old office document do? No table of text does.
bool is_packed(std::string_view bytes);

// A sheet of a workbook: that wanted, or the one that suits.
// Fails:      InputError, without a file, that says what to do: with a password, .xls, .xlsb, .ods, .numbers, another archive; damaged;
//             no such sheet; none with a number.
// Cost:       10^5 rows of three columns in about 0.3 s, and the memory of their text.
WorkbookSheet read_sheet(std::string_view bytes, const std::optional<SheetChoice>& wanted = {},
                         SheetFor purpose = SheetFor::readings);

}  // namespace flexslip
