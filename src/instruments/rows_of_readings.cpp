#include "instruments/rows_of_readings.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "io/statistics_rows.h"

namespace flexslip {
namespace {

constexpr std::size_t few_below_break = 12;  // rows below a break, which may be no readings; more are another cycle

std::vector<LabelledRow> labelled_rows(const TableBlock& block, const Sheet& sheet) {
  std::vector<LabelledRow> labelled;
  for (std::size_t row = 0; row < block.rows.size(); ++row) {
    const auto cells = sheet.cells(block.rows[row]);
    const auto first = std::find_if(cells.begin(), cells.end(), [](std::string_view each) { return !each.empty(); });
    if (first != cells.end() && is_label(*first)) labelled.push_back({row, names_statistic(*first)});
  }
  return labelled;
}

// A number before the marks are known: those of a column are wrong by one factor, if at all.
double roughly(const ExportCells& cells, std::size_t line, std::size_t column) {
  const std::string_view number = number_cell(cells.at(line, column)).number;
  const bool has_comma = std::count(number.begin(), number.end(), ',') == 1;
  return cells.number(line, column, {has_comma && number.find('.') == std::string_view::npos ? ',' : '.', '\0'});
}

bool is_break(const Sheet& sheet, std::size_t before, std::size_t after) {
  for (std::size_t line = before + 1; line < after; ++line)
    for (const std::string_view each : sheet.cells(line))
      if (!each.empty()) return false;
  return true;
}

}  // namespace

std::string leave_out_statistics(TableBlock& block, const ExportCells& cells, const std::vector<bool>& numeric) {
  const std::size_t count = block.rows.size();
  std::vector<std::size_t> rows = rows_below_readings(labelled_rows(block, cells.sheet()), count);
  if (rows.empty()) {
    std::size_t begin = count - 1;  // of the rows below the last break
    while (begin > 0 && block.rows[begin - 1] + 1 == block.rows[begin]) --begin;
    const bool has_break = begin > 0 && is_break(cells.sheet(), block.rows[begin - 1], block.rows[begin]);
    const std::size_t below = has_break ? count - begin : 0;
    std::vector<std::vector<double>> columns;
    for (std::size_t column = 0; column < numeric.size(); ++column) {
      if (!numeric[column]) continue;
      columns.emplace_back();
      for (const std::size_t line : block.rows) columns.back().push_back(roughly(cells, line, column));
    }
    const std::vector<std::span<const double>> views(columns.begin(), columns.end());
    for (std::size_t tail = statistics_at_end(views, below); tail > 0; --tail) rows.push_back(count - tail);
    if (rows.empty())
      return below > 0 && below <= few_below_break && 2 * below < begin
                 ? below_a_break(block.rows[begin] + 1, block.rows.back() + 1)
                 : "";
  }
  std::vector<std::size_t> lines;
  for (const std::size_t row : rows) lines.push_back(block.rows[row] + 1);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    block.rows.erase(block.rows.begin() + static_cast<std::ptrdiff_t>(*row));
  return left_out_statistics(lines);
}

}  // namespace flexslip
