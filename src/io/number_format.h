// How a file writes its numbers: the decimal mark and the separator of thousands, which only all of them together tell.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace flexslip {

struct NumberFormat {
  char decimal = '.';     // or ','
  char thousands = '\0';  // '.', ',', ' ', '\''; '\0' for none
  bool operator==(const NumberFormat&) const = default;
};

// A text that is all one number with a decimal point: "-1.5e3", "+2", also "nan", "-inf" and "1e999". nullopt if it is none.
// Max error:  correctly rounded.
std::optional<double> plain_number(std::string_view text);

// A cell as a number, NaN if it is none: digits with at most one decimal mark, in groups of three if at all in groups.
// Cells that are 'nan', or empty, are none.
// Also "−1.5" with a minus or dash of any kind, "(1.5)" and "1.5-" for -1.5, "1.5D+01" for 15.
// Max error:  correctly rounded.
double number_in(std::string_view cell, const NumberFormat& format);

// A cell with a number in some country's notation (digits with a sign, marks . , ' and spaces, an exponent), and perhaps
// its unit: "12.5 N".
struct NumberCell {
  std::string_view number, unit;
};

// Both parts are empty if the cell holds no number.
NumberCell number_cell(std::string_view cell);

// Is there something in the cell that says that there is no number: nothing, a dash, "nan", "N/A"?
bool says_missing(std::string_view cell);

// Does the cell say that a sensor or its amplifier was at its end: "OVER", "OL", "+OVLD", "overflow", ">>>", "> 500", "Inf"?
bool says_overload(std::string_view cell);

// What the cells of a file say about its number format. Each is worth looking at: "1,234" may be either, "0,123" not.
class NumberEvidence {
 public:
  // A cell that looks numeric.
  void add(std::string_view text);

  // The decimal mark that the cells prove; none if none does. A mark that fewer than a hundredth of those with any
  // contradict is proven: damaged cells do not change how a file is read.
  // Fails:      InputError, without a place, if both marks are used as decimal marks.
  std::optional<char> decimal() const;

  // Are there cells that only the decimal mark would explain, with no proof of it?
  bool undecidable() const;

  // Is the comma the only mark?
  bool only_commas() const { return point_.as_decimal + point_.as_group + point_.either == 0; }

  // The separator of thousands, once the decimal mark is known: that mark itself where numbers have several.
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
