// Where the text of a table comes from: a text file, or a sheet of a workbook.
#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <string>

#include "io/workbook.h"

namespace flexslip {

struct TableSource {
  std::string name;                    // the file as the user named it
  std::shared_ptr<std::istream> text;  // a text file as its bytes are; of a sheet the lines are its rows
  std::optional<WorkbookSheet> sheet;  // without its text
};

// A table to read from; "-" is standard input. A text file is read as it is needed, a workbook at once.
// Fails:      OutputClash if the call writes it; InputError if it cannot be opened, of what read_sheet refuses, and if a sheet is
//             wanted of a file that is no workbook.
TableSource open_table(const std::string& path, const std::optional<SheetChoice>& sheet = {},
                       SheetFor purpose = SheetFor::readings);

}  // namespace flexslip
