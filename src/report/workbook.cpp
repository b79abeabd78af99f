#include "report/workbook.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>
#include <xlsxwriter.h>

#include "io/durable_file.h"
#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

// shown, of the largest number of a column; the cell contains all
constexpr int digits = 4;
constexpr std::size_t widest = 60;    // [characters] of a column
constexpr std::size_t narrowest = 8;  // [characters]

std::time_t date_of_creation() {
  constexpr std::time_t year_1980 = 315532800;  // [s] the earliest date in ZIP
  return std::max(date_of_source(year_1980), year_1980);
}

// "0.000" for a column whose largest number has one digit before the point.
std::string number_format(const ResultTable& table, std::size_t column) {
  double largest = 0;
  bool whole = true;
  for (const auto& row : table.rows)
    if (const double* value = std::get_if<double>(&row[column]); value && std::isfinite(*value)) {
      largest = std::max(largest, std::abs(*value));
      whole = whole && *value == std::floor(*value);
    }
  if (whole || largest == 0) return "0";
  const int decimals = std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(largest))), 0, 9);
  return decimals == 0 ? "0" : fmt::format("0.{}", std::string(static_cast<std::size_t>(decimals), '0'));
}

class Workbook {
 public:
  Workbook(const std::string& path, std::string title) : book_(workbook_new(path.c_str())) {
    title_ = workbook_add_format(book_);
    format_set_bold(title_);
    format_set_text_wrap(title_);
    format_set_align(title_, LXW_ALIGN_VERTICAL_BOTTOM);
    format_set_bottom(title_, LXW_BORDER_THIN);
    lxw_doc_properties properties{};
    std::string author = fmt::format("FlexSlip {}", FLEXSLIP_VERSION);
    properties.title = title.data();
    properties.author = author.data();
    properties.created = date_of_creation();
    workbook_set_properties(book_, &properties);
  }

  void add(const ResultTable& table, const std::string& name) {
    lxw_worksheet* sheet = workbook_add_worksheet(book_, name.c_str());
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const auto& column = table.columns[i];
      const auto at = static_cast<lxw_col_t>(i);
      lxw_format* cells = nullptr;
      if (column.has_numbers) {
        cells = workbook_add_format(book_);
        format_set_num_format(cells, number_format(table, i).c_str());
      }
      const std::string title =
          column.unit.empty() ? column.name : fmt::format("{} ({})", column.name, typeset(column.unit));
      std::size_t width = std::max(narrowest, title.size() + 1);
      worksheet_write_string(sheet, 0, at, title.c_str(), title_);
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const Cell& cell = table.rows[row][i];
        const auto below = static_cast<lxw_row_t>(row + 1);
        if (const double* value = std::get_if<double>(&cell); value && std::isfinite(*value)) {
          worksheet_write_number(sheet, below, at, *value, cells);
        } else if (const std::string* text = std::get_if<std::string>(&cell); text && !text->empty()) {
          worksheet_write_string(sheet, below, at, without_formula(*text).c_str(), nullptr);
          width = std::max(width, std::min(widest, text->size() + 1));
        }
      }
      worksheet_set_column(sheet, at, at, static_cast<double>(width), nullptr);
    }
    worksheet_freeze_panes(sheet, 1, 1);
    if (!table.rows.empty())
      worksheet_autofilter(sheet, 0, 0, static_cast<lxw_row_t>(table.rows.size()),
                           static_cast<lxw_col_t>(table.columns.size() - 1));
  }

  lxw_error close() {
    const lxw_error error = workbook_close(book_);
    book_ = nullptr;
    return error;
  }

  ~Workbook() {
    if (book_) lxw_workbook_free(book_);
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

 private:
  lxw_workbook* book_;
  lxw_format* title_;
};

}  // namespace

void write_workbook(const std::string& path, const std::string& title,
                    const std::vector<std::pair<std::string, ResultTable>>& sheets) {
  OutputFile file(path);
  Workbook book(file.name().string(), title);
  for (const auto& [name, table] : sheets) book.add(table, name);
  if (const lxw_error error = book.close(); error != LXW_NO_ERROR)
    throw InputError({.file = path, .problem = fmt::format("The workbook cannot be written: {}", lxw_strerror(error))});
  file.finish();
}

}  // namespace flexslip
