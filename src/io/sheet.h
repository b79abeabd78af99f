// Tables as cells, from a delimited text or from a sheet of a workbook: what all that read tables read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
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
// Cost:       four bytes a cell and a line beside the text.
class Sheet {
 public:
  static constexpr std::size_t most_cells = std::size_t{1} << 28;

  // Any line ending. A quote without its partner on the same line is an ordinary character: see stray_quote. With a space as separator,
  // runs of spaces and tabs separate.
  // Fails:      InputError, without a file, for more cells than `most`, or more than 2 GiB of text.
  Sheet(std::string text, char separator, std::size_t most = most_cells);

  // Of a workbook, whose days count from the end of 1899, or from 1904.
  explicit Sheet(bool dates_from_1904 = false) : dates_from_1904_(dates_from_1904) {}

  // Below the last line; lines between are empty. The texts of cells hold neither tabs nor ends of lines.
  void append(std::size_t line, std::span<const SheetCell> cells);
  void fill();  // all lines that are not empty get as many cells as the widest, as spreadsheet programs write CSV

  std::size_t size() const { return first_cells_.size(); }
  char separator() const { return separator_; }  // of the text; a tab of a workbook
  // A line without its ending, and with single quotes for doubled ones; of a workbook its cells, apart by tabs.
  std::string_view text(std::size_t line) const;
  bool is_comment(std::size_t line) const;
  bool is_blank(std::size_t line) const;  // has no cell that is not empty

  // The cells of a line, trimmed, without their quotes.
  class Cells {
   public:
    struct Iterator {
      using iterator_category = std::input_iterator_tag;
      using value_type = std::string_view;
      using difference_type = std::ptrdiff_t;
      using pointer = void;
      using reference = std::string_view;
      const Sheet* sheet;
      std::size_t line, column;
      std::string_view operator*() const { return sheet->at(line, column); }
      Iterator& operator++() { return ++column, *this; }
      bool operator==(const Iterator&) const = default;
    };
    Cells(const Sheet& sheet, std::size_t line) : sheet_(&sheet), line_(line) {}
    std::size_t size() const {
      const std::size_t own = sheet_->end_of(line_) - sheet_->first_cells_[line_];
      return own == 0 ? 0 : std::max(own, sheet_->width_);
    }
    std::string_view operator[](std::size_t column) const { return sheet_->at(line_, column); }
    Iterator begin() const { return {sheet_, line_, 0}; }
    Iterator end() const { return {sheet_, line_, size()}; }

   private:
    const Sheet* sheet_;
    std::size_t line_;
  };
  Cells cells(std::size_t line) const { return {*this, line}; }

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
  void cut(std::string_view line, bool may_be_quoted, std::size_t most);
  void make_quotes_single();  // those doubled within quoted cells
  bool has_stray_quote(std::size_t line) const;
  std::size_t begin_of(std::size_t cell) const { return cell < begins_.size() ? begins_[cell] : text_.size(); }
  std::size_t end_of(std::size_t line) const {  // the cell behind its last
    return line + 1 < first_cells_.size() ? first_cells_[line + 1] : begins_.size();
  }
  std::string_view raw(std::size_t cell) const;  // trimmed, with its quotes

  std::string text_;                         // its cells each end with a separator or the end of a line
  std::vector<std::uint32_t> begins_;        // of the cells in it
  std::vector<std::uint32_t> first_cells_;   // of the lines
  std::vector<CellKind> kinds_;              // of a workbook, of each cell
  std::vector<std::uint32_t> stray_quotes_;  // the lines whose quotes are ordinary characters, rising
  std::size_t width_ = 0;                    // of lines that are filled
  char separator_ = '\t';
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
