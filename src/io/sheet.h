// Tables as cells, from a delimited text or from a sheet of a workbook: what all that read tables read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/number_format.h"

namespace flexslip {

enum class CellKind : std::uint8_t {
  word,            // all that a text holds; of a workbook also a number kept as text, in the manner of some country
  number,          // of a workbook, digit for digit, with a decimal point
  date,            // a number of days, shown as 2026-02-01
  clock,           // likewise, shown as 00:00:01.5: a time of day, or elapsed
  date_and_clock,  // likewise, shown as both
  error,           // "#REF!"
};

bool is_dated(CellKind kind);  // one of the three that are numbers of days

struct SheetCell {
  std::string text;
  CellKind kind = CellKind::word;
};

// All lines of a text, or all rows of a sheet of a workbook. Lines and columns count from 0.
class Sheet {
 public:
  // Any line ending. A quote without its partner on the same line is an ordinary character: see stray_quote. With a space as separator,
  // runs of spaces and tabs separate.
  Sheet(std::string text, char separator);

  // Of a workbook, whose days count from the end of 1899, or from 1904.
  explicit Sheet(bool dates_from_1904 = false) : dates_from_1904_(dates_from_1904) {}
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;
  Sheet(Sheet&&) = default;
  Sheet& operator=(Sheet&&) = default;

  void append(std::size_t line, std::span<const SheetCell> cells);  // below the last one; lines between are empty
  void fill();  // all lines get as many cells as the widest, as spreadsheet programs write CSV

  std::size_t size() const { return lines_.size(); }
  // A line without its ending; of a workbook its cells, apart by tabs.
  std::string_view text(std::size_t line) const { return lines_[line].text; }
  bool is_comment(std::size_t line) const { return lines_[line].is_comment; }
  bool is_blank(std::size_t line) const;                             // has no cell that is not empty
  std::span<const std::string_view> cells(std::size_t line) const {  // trimmed, without their quotes
    return std::span(cells_).subspan(lines_[line].first_cell, lines_[line].cells);
  }

  // Of a cell that is not there: empty, a word.
  std::string_view at(std::size_t line, std::size_t column) const;
  CellKind kind(std::size_t line, std::size_t column) const;
  // As a number; one of a workbook that is no word has a decimal point, whatever the format. NaN if it is none, or a date.
  double number(std::size_t line, std::size_t column, const NumberFormat& format) const;
  double days(std::size_t line, std::size_t column) const;  // of a date or a clock time; NaN of others
  std::string shown(std::size_t line,
                    std::size_t column) const;  // a date or a clock time as it is shown; others as they stand

  bool quoted() const { return quoted_; }  // is any cell of the text?
  // The first cell of a line with a quote that has no partner, counted from 1; 0 if there is none.
  std::size_t stray_quote(std::size_t line) const;

 private:
  struct Line {
    std::string_view text;
    std::size_t first_cell;
    std::uint32_t cells;
    bool is_comment;
  };
  void cut(std::string_view line, char separator);

  std::deque<std::string> texts_;  // that the cells are parts of; they stay where they are
  std::vector<Line> lines_;
  std::vector<std::string_view> cells_;
  std::vector<CellKind> kinds_;                      // of a workbook, of each cell
  std::map<std::size_t, std::size_t> stray_quotes_;  // of a line, the cell
  bool dates_from_1904_ = false, quoted_ = false;
};

// The separator with which most cells of a text are numbers: ',', ';', tab or ' '.
// Method:     over a thousand lines from all of the text, each gives numbers^2 / cells; the greatest sum wins.
char separator_of(std::string_view text);

// The separator of a text whose first line, comments apart, has titles: that which is most often on it outside of quotes, ',', ';' or tab, or
// else a space.
char separator_of_titles(std::string_view text);

// Days as they are shown: "2026-02-01", "00:00:01.5", "2026-02-01 13:05:00". Days count from the end of 1899, or from 1904.
std::string shown_days(double days, CellKind kind, bool from_1904);

std::string cell_name(std::size_t row, std::size_t column);  // "B17", counted from 1

}  // namespace flexslip
