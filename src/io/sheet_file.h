// A file as a sheet of cells, whatever it is: the bytes of a text in its encoding, or a workbook. All that read tables begin here.
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

// What a user decides about a file; all else is found.
struct SheetOptions {
  std::optional<SheetChoice> sheet{};  // of a workbook
  std::optional<Encoding> encoding{};  // of a text
  std::optional<char> separator{};     // of a text: ',', ';', '\t'; ' ' for runs of spaces and tabs
};

// Where a sheet comes from.
struct SheetOrigin {
  std::string source{};        // the file as the user named it
  bool has_delimiters = true;  // encoding, separator and quotes; the cells of a workbook are apart
  Encoding encoding = Encoding::utf8;
  bool byte_order_mark = false;
  char separator = '\t';
  std::optional<std::string> sheet{};  // of the workbook that it is, whose rows are the lines
  std::vector<std::string> sheets{};   // of that workbook
  std::vector<std::string> alike{};    // those of them that it may be as well, see WorkbookSheet
  std::string which_sheet{};           // and why, of several; among the notes as well
  bool sheet_is_chosen = false;        // by who called
};

struct SheetFile {
  SheetOrigin origin;
  Sheet cells;
  std::vector<std::string> notes;  // what was decided
};

// A file from its bytes.
// Fails:      InputError with the file: what decode and read_sheet refuse; a sheet wanted of a text, an encoding or a separator of a workbook.
SheetFile sheet_in(std::string bytes, const std::string& source, const SheetOptions& options, SheetFor purpose);

// The same from a file; "-" is standard input.
SheetFile open_sheet(const std::string& path, const SheetOptions& options, SheetFor purpose);

// The refusal of a cell that holds a date or a clock time where a number is wanted, with its place and a remedy. Counted from 0.
InputError dated(const SheetFile& file, std::size_t line, std::size_t column, std::string_view expected);

// An error in what a sheet holds. If nobody chose that sheet, the others are in its remedy: is the table on one of them? One in a single cell is
// left as it is.
InputError with_other_sheets(const InputError& error, const SheetOrigin& origin);

}  // namespace flexslip
