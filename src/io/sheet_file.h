// A file as a sheet of cells: text in any supported encoding, or a workbook.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/encoding.h"
#include "io/input_error.h"
#include "io/sheet.h"
#include "io/workbook.h"

namespace flexslip {

// Choices of the user. Everything else is detected.
struct SheetOptions {
  std::optional<SheetChoice> sheet{};  // for a workbook
  std::optional<Encoding> encoding{};  // for a text
  std::optional<char> separator{};     // for a text: ',', ';', '\t'; ' ' for runs of spaces and tabs
};

// The origin of a sheet.
struct SheetOrigin {
  std::string source{};        // the name that the user gave
  bool has_delimiters = true;  // true for a text, which has an encoding, a separator and quotes
  Encoding encoding = Encoding::utf8;
  bool byte_order_mark = false;
  char separator = '\t';
  std::optional<std::string> sheet{};  // the sheet that was read, if the file is a workbook
  std::vector<std::string> sheets{};   // all sheets of the workbook
  std::vector<std::string> alike{};    // other candidates for the table (WorkbookSheet)
  std::string which_sheet{};           // which of several sheets was read, and why; one of the notes
  bool sheet_is_chosen = false;        // by the caller
};

struct SheetFile {
  SheetOrigin origin;
  Sheet cells;
  std::vector<std::string> notes;  // decisions
};

// Reads a file from its bytes.
// Fails:      InputError with the file: as decode and read_sheet; for a sheet name if it is a text;
//             for an encoding or a separator if it is a workbook.
SheetFile sheet_in(std::string bytes, const std::string& source, const SheetOptions& options, SheetFor purpose);

// Reads a file; "-" is standard input.
SheetFile open_sheet(const std::string& path, const SheetOptions& options, SheetFor purpose);

// The error for a date or clock time where a number is needed, with place and remedy. Line and
// column count from 0.
InputError dated(const SheetFile& file, std::size_t line, std::size_t column, std::string_view expected);

// The error, with the other sheets in its remedy if nobody chose the sheet. An error of a single
// cell is returned unchanged.
InputError with_other_sheets(const InputError& error, const SheetOrigin& origin);

}  // namespace flexslip
