// How a file writes its numbers: the decimal mark and the separator of thousands, which only all of them together tell.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace flexslip {

struct NumberFormat {
  char decimal = '.';  // or ','
  char thousands =
      '\0';  // '.', ',', ' ', '\''; '\0' for none; equal to decimal where a spreadsheet has regrouped digits
  bool operator==(const NumberFormat&) const = default;
};

// A cell as a number, NaN if it is none: digits with at most one decimal mark, in groups of three if at all in groups.
// Cells that are 'nan', or empty, are none. Regrouped cells are none either: see regrouped.h.
// Max error:  correctly rounded.
double number_in(std::string_view cell, const NumberFormat& format);

// What the cells of a file say about its number format. Each is worth looking at: "1,234" may be either, "0,123" not.
class NumberEvidence {
 public:
  // A cell that looks numeric, of a column counted from 0.
  void add(std::string_view cell);

  // The decimal mark that the cells prove; none if none does. A mark that fewer than a hundredth of those with any
  // contradict is proven: damaged cells do not change how a file is read.
  // Fails:      InputError, without a place, if both marks are used as decimal marks.
  std::optional<char> decimal() const;

  // Are there cells that only the decimal mark would explain, with no proof of it?
  bool undecidable() const;

  // Is the comma the only mark?
  bool only_commas() const { return point_.as_decimal + point_.as_group + point_.either == 0; }

  // The separator of thousands, once the decimal mark is known.
  char thousands(char decimal) const;

 private:
  struct Mark {
    std::size_t as_decimal = 0;  // cannot be a separator of thousands
    std::size_t as_group = 0;    // cannot be a decimal mark
    std::size_t either = 0;
  };
  Mark point_, comma_;
  std::size_t spaces_ = 0, apostrophes_ = 0;
  std::size_t ungrouped_ = 0;  // cells with more than three digits in a row before any decimal mark
};

}  // namespace flexslip
