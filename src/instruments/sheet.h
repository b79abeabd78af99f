// A delimited text as lines of cells.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

struct SheetLine {
  std::string_view text;  // without its ending
  std::size_t first_cell, cells;
};

// Any line ending. A quote without its partner on the same line is an ordinary character. With a space as separator,
// runs of spaces and tabs separate.
class Sheet {
 public:
  // The text must outlive the sheet.
  Sheet(std::string_view text, char separator);

  std::size_t size() const { return lines_.size(); }
  std::string_view text(std::size_t line) const { return lines_[line].text; }  // counted from 0
  std::span<const std::string_view> cells(std::size_t line) const {            // trimmed, without their quotes
    return std::span(cells_).subspan(lines_[line].first_cell, lines_[line].cells);
  }
  bool quoted() const { return quoted_; }  // is any cell?

 private:
  void split(std::string_view line, char separator);

  std::vector<SheetLine> lines_;
  std::vector<std::string_view> cells_;
  std::deque<std::string> unescaped_;  // cells that held doubled quotes
  bool quoted_ = false;
};

// A cell with a number in some country's notation (digits with a sign, marks . , ' and spaces, an exponent), and perhaps
// its unit: "12.5 N".
struct NumberCell {
  std::string_view number, unit;
};

// Both parts are empty if the cell holds no number.
NumberCell number_cell(std::string_view cell);

// Is there something in the cell that says that there is no number: nothing, a dash, "nan", "N/A"?
bool says_missing(std::string_view cell);

// The separator with which most cells of the file are numbers: ',', ';', tab or ' '.
// Method:     over a thousand lines from all of the file, each gives numbers^2 / cells; the greatest sum wins.
char separator_of(std::string_view text);

}  // namespace flexslip
