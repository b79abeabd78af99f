// Tables as cells, from delimited text or from a sheet of a workbook.
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
  word,            // any cell of a text; in a workbook also a number stored as text
  number,          // in a workbook; all its digits, with a decimal point
  date,            // a number of days, shown as 2026-02-01
  clock,           // a number of days, shown as 00:00:01.5; a time of day or an elapsed time
  date_and_clock,  // a number of days, shown as date and time
  error,           // "#REF!"
};

bool is_dated(CellKind kind);  // True for the three kinds that are numbers of days.

struct SheetCell {
  std::string text;
  CellKind kind = CellKind::word;
};

// The lines of a text, or the rows of a sheet of a workbook. Lines and columns count from 0.
// Cost:       4 bytes for each cell and line, and the text.
class Sheet {
 public:
  static constexpr std::size_t most_cells = std::size_t{1} << 28;

  // Splits text with any line endings. With a space as separator, runs of spaces and tabs separate
  // cells. A quote without a partner on its line is an ordinary character (stray_quote).
  // Fails:      InputError, without a file, for more cells than `most`, or more than 2 GiB of text.
  Sheet(std::string text, char separator, std::size_t most = most_cells);

  // An empty sheet of a workbook. Its days count from the end of 1899, or from 1904.
  explicit Sheet(bool dates_from_1904 = false) : dates_from_1904_(dates_from_1904) {}

  // Adds a line below the last one; lines in between are empty. Cells must not contain tabs or line
  // ends.
  void append(std::size_t line, std::span<const SheetCell> cells);
  void fill();  // pads every non-empty line to the width of the widest, as spreadsheet programs write CSV

  std::size_t size() const { return first_cells_.size(); }
  char separator() const { return separator_; }  // a tab for a workbook
  // A line without its ending, with doubled quotes made single. For a workbook, its cells separated
  // by tabs.
  std::string_view text(std::size_t line) const;
  bool is_comment(std::size_t line) const;
  bool is_blank(std::size_t line) const;  // true if all its cells are empty

  // The cells of a line, trimmed and without quotes.
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

  // The text of a cell; empty, and a word, for a cell beyond the line.
  std::string_view at(std::size_t line, std::size_t column) const;
  CellKind kind(std::size_t line, std::size_t column) const;
  // The number in a cell; NaN for other text and for dates. `format` applies to words only: a
  // number of a workbook has a decimal point.
  double number(std::size_t line, std::size_t column, const NumberFormat& format) const;
  double days(std::size_t line, std::size_t column) const;  // [days] of a date or clock time; otherwise NaN
  std::string shown(std::size_t line,
                    std::size_t column) const;  // a date or clock time as displayed; the text of any other cell

  bool quoted() const { return quoted_; }  // true if any cell of the text is in quotes
  // The first cell of a line with an unpaired quote, counted from 1; 0 if there is none.
  std::size_t stray_quote(std::size_t line) const;

 private:
  void cut(std::string_view line, bool may_be_quoted, std::size_t most);
  void make_quotes_single();  // within quoted cells
  bool has_stray_quote(std::size_t line) const;
  std::size_t begin_of(std::size_t cell) const { return cell < begins_.size() ? begins_[cell] : text_.size(); }
  std::size_t end_of(std::size_t line) const {  // the index after its last cell
    return line + 1 < first_cells_.size() ? first_cells_[line + 1] : begins_.size();
  }
  std::string_view raw(std::size_t cell) const;  // trimmed, with its quotes

  std::string text_;                         // every cell ends with a separator or a line end
  std::vector<std::uint32_t> begins_;        // start of each cell in the text
  std::vector<std::uint32_t> first_cells_;   // index of the first cell of each line
  std::vector<CellKind> kinds_;              // kind of each cell of a workbook
  std::vector<std::uint32_t> stray_quotes_;  // lines with unpaired quotes, ascending
  std::size_t width_ = 0;                    // of filled lines
  char separator_ = '\t';
  bool dates_from_1904_ = false, quoted_ = false;
};

// The separator that makes most cells of a text numbers: ',', ';', tab or ' '.
// Method:     each of a thousand lines from the whole text gives numbers^2 / cells; the largest sum
//             wins.
char separator_of(std::string_view text);

// The separator of a text whose first non-comment line has titles: the commonest of ',', ';'
// and tab outside quotes, otherwise a space.
char separator_of_titles(std::string_view text);

// Days as displayed: "2026-02-01", "00:00:01.5", "2026-02-01 13:05:00". They count from the end of
// 1899, or from 1904.
std::string shown_days(double days, CellKind kind, bool from_1904);

std::string cell_name(std::size_t row, std::size_t column);  // "B17", counted from 1

}  // namespace flexslip
