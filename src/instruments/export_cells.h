// The cells of an export: those of a text, or of the sheet of a workbook, which knows more of them than their text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "instruments/number_format.h"
#include "instruments/sheet.h"
#include "io/workbook.h"

namespace flexslip {

// Lines and columns count from 0. A cell that is not there is empty.
class ExportCells {
 public:
  // The text, and the workbook whose text it is (or none), must outlive it.
  ExportCells(std::string_view text, char separator, const WorkbookSheet* workbook);

  const Sheet& sheet() const { return sheet_; }
  std::string_view at(std::size_t line, std::size_t column) const;
  CellKind kind(std::size_t line, std::size_t column) const;  // of a text: word
  bool has_dates() const { return workbook_ != nullptr && workbook_->kinds.has_dates(); }

  // As a number; one of a workbook that is no word has a decimal point, whatever the format. NaN if it is none, or a date.
  double number(std::size_t line, std::size_t column, const NumberFormat& format) const;
  // The number of days in a cell that holds a date or a clock time; NaN in others.
  double days(std::size_t line, std::size_t column) const;
  // A date or a clock time as it is shown; anything else as it stands.
  std::string shown(std::size_t line, std::size_t column) const;

 private:
  Sheet sheet_;
  const WorkbookSheet* workbook_;
};

}  // namespace flexslip
