// A table of words, one header line: what a person keeps in a spreadsheet.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

struct TextRow {
  std::size_t line;                // of the file, counted from 1
  std::vector<std::string> cells;  // one for each title; those that the line lacks are empty
};

struct TextTable {
  std::string source;  // the file as the user named it
  std::size_t header_line;
  std::vector<std::string> titles;  // none empty, none twice
  std::vector<TextRow> rows;
};

// Words that no spreadsheet takes for a formula: with a ' before those that begin with = + - or @, also after others of '.
std::string without_formula(std::string_view words);

// Text that every format takes: valid UTF-8 without control characters, what is neither replaced by U+FFFD or a space.
std::string printable(std::string_view text);

// Reads a table separated by commas, semicolons or tabs, or the first sheet with a number of a workbook; comments and empty lines are left out as in read_table. A cell
// is what without_formula was given: '=a is =a.
// Fails:      InputError with file and line: no header, a title that is missing or there twice, more cells than titles, a stray quote.
TextTable read_text_table(const std::string& path);

}  // namespace flexslip
