#include "instruments/export_cells.h"

#include "numerics/elementary.h"

namespace flexslip {

ExportCells::ExportCells(std::string_view text, char separator, const WorkbookSheet* workbook)
    : sheet_(text, separator), workbook_(workbook) {}

std::string_view ExportCells::at(std::size_t line, std::size_t column) const {
  const auto cells = sheet_.cells(line);
  return column < cells.size() ? cells[column] : std::string_view{};
}

CellKind ExportCells::kind(std::size_t line, std::size_t column) const {
  const bool has_kinds = workbook_ != nullptr && workbook_->holds != SheetHolds::lines_of_text;
  return has_kinds ? workbook_->kinds.at(line + 1, column + 1) : CellKind::word;
}

double ExportCells::number(std::size_t line, std::size_t column, const NumberFormat& format) const {
  const CellKind held = kind(line, column);
  if (is_dated(held)) return not_a_number;
  return number_in(number_cell(at(line, column)).number, held == CellKind::word ? format : NumberFormat{});
}

double ExportCells::days(std::size_t line, std::size_t column) const {
  return is_dated(kind(line, column)) ? number_in(at(line, column), {}) : not_a_number;
}

std::string ExportCells::shown(std::size_t line, std::size_t column) const {
  const CellKind held = kind(line, column);
  if (!is_dated(held)) return std::string(at(line, column));
  return shown_days(days(line, column), held, workbook_->dates_from_1904);
}

}  // namespace flexslip
