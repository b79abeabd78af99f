// The number format of a file: decimal mark and thousands separator, determined from all its numbers together.
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

// The number that a text with a decimal point consists of: "-1.5e3", "+2", also "nan", "-inf" and "1e999".
// nullopt for other text.
// Max error:  correctly rounded.
std::optional<double> plain_number(std::string_view text);

// The number in a cell: digits with at most one decimal mark, ungrouped or in groups of three. NaN for other text, for
// 'nan' and for an empty cell.
// Also "−1.5" with a minus or dash of any kind, "(1.5)" and "1.5-" for -1.5, "1.5D+01" for 15.
// Max error:  correctly rounded.
double number_in(std::string_view cell, const NumberFormat& format);

// A number in the notation of any country (sign, digits, marks . , ' and spaces, exponent)
// and its optional unit: "12.5 N".
struct NumberCell {
  std::string_view number, unit;
};

// Both parts are empty if the cell holds no number.
NumberCell number_cell(std::string_view cell);

// True for a cell without a reading: empty, a dash, "nan", "N/A".
bool says_missing(std::string_view cell);

// True for a cell that reports an overloaded sensor: "OVER", "OL", "+OVLD", "overflow", ">>>", "> 500", "Inf".
bool says_overload(std::string_view cell);

// Evidence on the number format from the cells of a file. "1,234" is ambiguous, "0,123" is not.
class NumberEvidence {
 public:
  // Adds a cell that looks numeric.
  void add(std::string_view text);

  // The decimal mark that the cells prove; nullopt without a proof. Damaged cells do not matter: a mark is
  // proven if fewer than 1 % of the cells with a mark contradict it.
  // Fails:      InputError, without a place, if both marks are used as decimal marks.
  std::optional<char> decimal() const;

  // True if some cells depend on the decimal mark and no cell proves it.
  bool undecidable() const;

  // True if the comma is the only mark.
  bool only_commas() const { return point_.as_decimal + point_.as_group + point_.either == 0; }

  // The thousands separator for a known decimal mark; the decimal mark itself if numbers have several of it.
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
