#include "io/statistics_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t most_at_end = 8;   // mean, deviation, variance, sum, count, minimum, maximum, and one spare
constexpr std::size_t most_below = 20;   // labelled rows; more are labelled readings
constexpr std::size_t fewest_rows = 12;  // fewer rows match statistics by chance
constexpr double far = 5;                // times the largest step between readings
constexpr double as_shown = 2e-3;        // relative; statistics are written with at least three digits

// The first words of labels, in lower case: English, German, French, Spanish, Italian, Portuguese,
// Turkish, Japanese.
constexpr std::string_view statistics =
    " mean average avg max maximum min minimum median std stdev stddev stdabw sd rms sum total variance var"
    " cv cov mittelwert mittel mw standardabweichung standardabw streuung summe varianz variationskoeffizient"
    " moyenne moy écart ecart médiane somme media média promedio mediana desviación desviacion desvio"
    " deviazione scarto suma soma somma máximo mínimo massimo minimo ortalama maks toplam"
    " 平均 平均値 標準偏差 最大 最大値 最小 最小値 合計 中央値 ";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

// Running statistics of a column.
class Summary {
 public:
  void add(double value) {
    if (std::isnan(value)) return;
    ++count_;
    const double off = value - mean_;
    mean_ += off / static_cast<double>(count_);
    squares_ += off * (value - mean_);
    sum_ += value;
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value);
  }

  // Mean, deviations, sum; minimum and maximum.
  std::array<double, 6> statistics() const {
    const auto n = static_cast<double>(count_);
    return {mean_, std::sqrt(squares_ / (n - 1)), std::sqrt(squares_ / n), sum_, least_, greatest_};
  }
  static constexpr std::size_t of_all = 4;  // the first four, which a reading equals only by chance
  static constexpr std::size_t count = 6;

 private:
  std::size_t count_ = 0;
  double mean_ = 0, squares_ = 0, sum_ = 0;
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = -least_;
};

// The first statistic that matches a row in all columns; Summary::count if none does.
std::size_t statistic_on(std::span<const Summary> above, std::span<const std::vector<double>> columns,
                         std::size_t row) {
  for (std::size_t which = 0; which < Summary::count; ++which) {
    bool is_all = true;
    for (std::size_t i = 0; is_all && i < columns.size(); ++i) {
      const double is = columns[i][row], wanted = above[i].statistics()[which];
      is_all = wanted != 0 && std::abs(is - wanted) <= as_shown * std::abs(wanted);
    }
    if (is_all) return which;
  }
  return Summary::count;
}

// The step to a row from the previous one: `is_one` if all columns change (equal readings are their
// own mean), `is_far` if a column changes by far more than between readings.
struct Jump {
  bool is_one = true, is_far = false;
};
Jump jump_to(std::span<const std::vector<double>> columns, std::size_t row, std::size_t readings) {
  Jump jump;
  for (const std::vector<double>& column : columns) {
    const auto step = [&](std::size_t to) { return std::abs(column[to] - column[to - 1]); };
    double longest = 0;
    for (std::size_t to = 1; to < readings; ++to)
      if (step(to) > longest) longest = step(to);
    jump.is_one = jump.is_one && step(row) > as_shown * std::abs(column[row]);
    jump.is_far = jump.is_far || step(row) > far * longest;
  }
  return jump;
}

bool is_label(std::string_view cell) {
  static constexpr std::array<std::string_view, 6> missing{"nan", "n/a", "na", "null", "inf", "none"};
  if (cell.empty() || !is_letter(cell.front())) return false;
  return cell.size() > 4 || std::find(missing.begin(), missing.end(), folded(cell)) == missing.end();
}

// A row whose first non-empty cell is a label.
struct LabelledRow {
  std::size_t row;  // from 0
  bool is_statistic;
};

bool are_data(std::size_t labels, std::size_t rows) { return 2 * labels >= rows; }

std::vector<std::size_t> rows_below_readings(std::span<const LabelledRow> labelled, std::size_t rows) {
  if (labelled.empty() || are_data(labelled.size(), rows)) return {};
  std::vector<std::size_t> found;
  std::size_t below = 0;  // number of them at the end
  while (below < labelled.size() && labelled[labelled.size() - 1 - below].row == rows - 1 - below) ++below;
  if (below > most_below) below = 0;
  for (std::size_t i = 0; i < labelled.size(); ++i)
    if (labelled[i].is_statistic || i + below >= labelled.size()) found.push_back(labelled[i].row);
  return found;
}

// The number of rows at the end that are statistics by their numbers. `below_break`: the number of
// rows below a break.
std::size_t statistics_at_end(std::span<const std::vector<double>> columns, std::size_t below_break) {
  if (columns.size() < 2 || columns.front().size() < fewest_rows) return 0;
  const std::size_t rows = columns.front().size();
  const std::size_t most = std::min(most_at_end, rows / 4);
  std::vector<Summary> above(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t row = 0; row + most < rows; ++row) above[i].add(columns[i][row]);
  for (std::size_t tail = most; tail > 0; --tail) {
    bool are_all = true, jumps = false;
    for (std::size_t row = rows - tail; are_all && row < rows; ++row) {
      const std::size_t which = statistic_on(above, columns, row);
      are_all = which < Summary::count;
      if (which >= Summary::of_all || jumps) continue;
      const Jump jump = jump_to(columns, row, rows - tail);
      jumps = jump.is_one && (jump.is_far || tail == below_break);
    }
    if (are_all && jumps) return tail;
    for (std::size_t i = 0; i < columns.size(); ++i) above[i].add(columns[i][rows - tail]);
  }
  return 0;
}

// The number of rows below the last break, a gap of empty lines.
std::size_t rows_below_break(const Sheet& sheet, std::span<const std::size_t> lines) {
  if (lines.empty()) return 0;
  std::size_t begin = lines.size() - 1;
  while (begin > 0 && lines[begin - 1] + 1 == lines[begin]) --begin;
  for (std::size_t line = begin > 0 ? lines[begin - 1] + 1 : 0; begin > 0 && line < lines[begin]; ++line)
    if (!sheet.is_blank(line)) return 0;
  return begin > 0 ? lines.size() - begin : 0;
}

// True if the rows below a break are too few for another cycle, and may not be readings.
bool are_few(std::size_t below_break, std::size_t rows) {
  constexpr std::size_t few = 12;
  return below_break > 0 && below_break <= few && 3 * below_break < rows;
}

std::string below_a_break(std::size_t first_line, std::size_t last_line) {
  return first_line == last_line
             ? fmt::format("line {} is below a break and counts as a reading: delete it if it is not a reading",
                           last_line)
             : fmt::format(
                   "lines {} to {} are below a break and count as readings: delete them if they are not readings",
                   first_line, last_line);
}

}  // namespace

bool names_statistic(std::string_view cell) {
  const std::string label = folded(trimmed(cell));
  std::size_t end = 0;
  while (end < label.size() && is_letter(label[end])) ++end;
  if (end > 0 && statistics.find(fmt::format(" {} ", std::string_view(label).substr(0, end))) != std::string_view::npos)
    return true;
  return label.starts_with("st. dev") || label.starts_with("standard dev") || label.starts_with("standard err") ||
         label.starts_with("standart sapma");
}

std::string_view label_of(const Sheet& sheet, std::size_t line) {
  const auto cells = sheet.cells(line);
  const auto first = std::find_if(cells.begin(), cells.end(), [](std::string_view each) { return !each.empty(); });
  return first != cells.end() && is_label(*first) ? *first : std::string_view{};
}

StatisticsRows statistics_among(const Sheet& sheet, std::span<const std::size_t> lines,
                                std::span<const std::vector<double>> columns, std::vector<std::size_t> known_lines) {
  std::vector<LabelledRow> labelled;
  for (std::size_t row = 0; row < lines.size() && !are_data(labelled.size(), lines.size()); ++row)
    if (const std::string_view label = label_of(sheet, lines[row]); !label.empty())
      labelled.push_back({row, names_statistic(label)});
  const std::size_t below_break = rows_below_break(sheet, lines);
  StatisticsRows found{rows_below_readings(labelled, lines.size()), {}};
  if (found.rows.empty())
    for (std::size_t tail = statistics_at_end(columns, below_break); tail > 0; --tail)
      found.rows.push_back(lines.size() - tail);
  if (found.rows.empty() && are_few(below_break, lines.size()))
    found.notes.push_back(below_a_break(lines[lines.size() - below_break] + 1, lines.back() + 1));
  std::vector<std::size_t>& left_out = known_lines;
  for (const std::size_t row : found.rows) left_out.push_back(lines[row]);
  if (left_out.empty()) return found;
  std::sort(left_out.begin(), left_out.end());
  for (std::size_t& line : left_out) ++line;  // counted from 1
  found.notes.push_back(fmt::format("left out, as {} of the readings: {}",
                                    left_out.size() == 1 ? "it holds a statistic" : "they hold statistics",
                                    on_lines(left_out)));
  return found;
}

}  // namespace flexslip
