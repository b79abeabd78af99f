// What the cells of a sheet hold that are not plain numbers: dates, clock times, numbers kept as words; and what they are called.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/zip_archive.h"

namespace flexslip {

enum class CellKind : std::uint8_t {
  number,
  date,            // a number of days, shown as 2026-02-01
  clock,           // likewise, shown as 00:00:01.5: a time of day, or elapsed
  date_and_clock,  // likewise, shown as both
  word,            // text that is like a number, in the manner of some country
};

bool is_dated(CellKind kind);  // one of the three that are numbers of days

// Those of a sheet that are not plain numbers, or words. Memory: 12 bytes for each run of cells of one kind below each other.
class CellKinds {
 public:
  // Rows and columns count from 1; the rows of a column rise.
  void add(std::size_t row, std::size_t column, CellKind kind);
  CellKind at(std::size_t row, std::size_t column) const;  // number if none was added
  bool has_dates() const { return has_dates_; }
  bool has_words() const { return has_words_; }

 private:
  struct Run {
    std::uint32_t first, last;
    CellKind kind;
  };
  std::vector<std::vector<Run>> runs_;  // by column
  bool has_dates_ = false, has_words_ = false;
};

// What a number is shown as by a format of a workbook: its number, and its code if it is none of those built in.
CellKind kind_of_format(std::size_t number, std::string_view code = {});

// What numbers are shown as by the styles of a workbook, in their order.
// Fails:      InputError, without a file: damaged.
std::vector<CellKind> read_cell_styles(const ZipArchive& archive, const std::string& part);

// Days as they are shown: "2026-02-01", "00:00:01.5", "2026-02-01 13:05:00". Days count from the end of 1899, or from 1904.
std::string shown_days(double days, CellKind kind, bool from_1904);

std::string cell_name(std::size_t row, std::size_t column);  // "B17"

}  // namespace flexslip
