#include "report/plot_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace flexslip {
namespace {

// [mm] of type of this size.
constexpr double line_height = 3.4;
constexpr double key_height = 3.6;                                // of a row of a key
constexpr double key_sample = 9.5;                                // the line before the words, and what is left free
constexpr double longest_letter = 6;                              // a title beside which a key stands
constexpr double figure_edge = 1.2;                               // of the figure
constexpr double to_numbers = 1.3;                                // from the frame to the numbers beside it
constexpr double numbers_below = 4.0;                             // from the frame to the lower end of the numbers
constexpr double joined_gap = 2.6;                                // between panels that share an axis
constexpr double colour_bar_width = 3;                            // and what stands between it and the panel
constexpr double closest_x = 12, closest_y = 6, closest_log = 7;  // ticks

// [mm] Wide rather than narrow: the machine at hand may not have Arial.
double text_width(const std::string& markup) {
  constexpr double em = font_size * 25.4 / 72;
  double ems = 0;
  for (const TextPiece& piece : text_pieces(markup)) {
    const double size = piece.style == TextPiece::below || piece.style == TextPiece::above ? 0.8 : 1;
    for (const char c : piece.text) {
      if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue;
      const std::string_view narrow = "ijl.,:;'|!()[]fIt /", wide = "mwMW%@";
      ems += size * (narrow.find(c) != narrow.npos ? 0.38 : wide.find(c) != wide.npos ? 0.9 : 0.62);
    }
  }
  return em * ems;
}

// Which columns of a mark lie along an axis.
std::span<const std::size_t> columns_along(MarkKind kind, bool is_x) {
  static constexpr std::array<std::size_t, 4> first{0, 1, 2, 3};
  static constexpr std::array<std::size_t, 4> crossed{0, 2, 1, 3};
  const std::span plain(first), mixed(crossed);
  switch (kind) {
    case MarkKind::line:
    case MarkKind::points:
    case MarkKind::area:
      return plain.subspan(is_x ? 0 : 1, 1);
    case MarkKind::band:
    case MarkKind::bars:
      return is_x ? plain.subspan(0, 1) : plain.subspan(1, 2);
    case MarkKind::spans:
      return is_x ? plain.subspan(0, 2) : plain.subspan(2, 1);
    case MarkKind::arrows:
      return is_x ? mixed.subspan(0, 2) : mixed.subspan(2, 2);
    case MarkKind::pixels:
      return is_x ? plain.subspan(0, 2) : plain.subspan(2, 2);
    default:
      return {};
  }
}

// Calls with each finite number that the marks of a panel have along an axis.
template <class Call>
void each_number(const Plot& plot, const Panel& panel, bool is_x, Call call) {
  for (const Mark& mark : panel.marks) {
    if (mark.table.empty()) continue;
    const PlotTable& table = table_of(plot, mark.table);
    for (const auto& row : table.rows) {
      if (!is_drawn(mark, row)) continue;
      for (const std::size_t place : columns_along(mark.kind, is_x))
        if (const double value = row.at(mark.columns.at(place)); std::isfinite(value)) call(value);
    }
  }
}

std::pair<double, double> range_of(const Plot& plot, const Panel& panel, const Axis& axis, bool is_x) {
  constexpr double space = 0.04;  // [1] of the range, at an end that the data decide
  double low = INFINITY, high = -INFINITY;
  if (!(std::isfinite(axis.from) && std::isfinite(axis.to)))
    each_number(plot, panel, is_x, [&](double value) {
      if (axis.logarithmic && !(value > 0)) return;
      low = std::min(low, value);
      high = std::max(high, value);
    });
  if (!(low <= high)) low = axis.logarithmic ? 1 : 0, high = axis.logarithmic ? 10 : 1;
  if (std::isfinite(axis.from)) low = axis.from;
  if (std::isfinite(axis.to)) high = axis.to;
  if (!(low < high)) high = axis.logarithmic ? 10 * low : low + (low != 0 ? std::abs(low) : 1);
  if (axis.logarithmic) {
    const double factor = std::pow(high / low, space);
    return {std::isfinite(axis.from) ? low : low / factor, std::isfinite(axis.to) ? high : high * factor};
  }
  const double margin = space * (high - low);
  return {std::isfinite(axis.from) ? low : low - margin, std::isfinite(axis.to) ? high : high + margin};
}

std::string number_text(double value) {
  std::string text = fmt::format("{:.6g}", value);
  if (const auto e = text.find('e'); e != std::string::npos)
    text = fmt::format("{}10^{{{}}}", text.substr(0, e) == "1" ? "" : text.substr(0, e) + "·",
                       std::stoi(text.substr(e + 1)));
  if (const auto minus = text.find('-'); minus != std::string::npos) text.replace(minus, 1, "−");
  return text;
}

std::vector<Tick> linear_ticks(double from, double to, double length, double closest) {
  std::vector<Tick> ticks;
  const double step = round_step((to - from) * closest / length);
  const double half = step / 2;
  const double end = to + 1e-9 * (to - from);
  for (double k = std::ceil((from - 1e-9 * (to - from)) / half); k * half <= end; ++k) {
    const double at = k == 0 ? 0 : k * half;
    ticks.push_back({at, std::fmod(std::abs(k), 2) == 0 ? number_text(at) : ""});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double from, double to, double length) {
  const double decades = std::log10(to / from);
  const double per_decade = length / decades / closest_log;  // numbers that there is room for
  constexpr double digits_1[] = {1}, digits_3[] = {1, 3}, digits_5[] = {1, 2, 5}, digits_8[] = {1, 2, 3, 4, 6, 8};
  const std::span<const double> numbered = per_decade >= 8     ? std::span<const double>(digits_8)
                                           : per_decade >= 3.4 ? std::span<const double>(digits_5)
                                           : per_decade >= 2   ? std::span<const double>(digits_3)
                                                               : std::span<const double>(digits_1);
  const int every = std::max(1, static_cast<int>(std::ceil(1 / per_decade)));  // decades
  const bool only_powers = numbered.size() == 1;
  std::vector<Tick> ticks;
  std::size_t numbers = 0;
  for (int decade = static_cast<int>(std::floor(std::log10(from))); decade <= std::log10(to) + 1e-9; ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const double at = digit * std::pow(10, decade);
      if (at < from * (1 - 1e-9) || at > to * (1 + 1e-9)) continue;
      const bool has_number =
          decade % every == 0 && std::find(numbered.begin(), numbered.end(), digit) != numbered.end();
      if (!has_number && decades > 5 && digit != 1) continue;
      numbers += has_number ? 1 : 0;
      const bool as_power = only_powers && (std::log10(to) > 4 || std::log10(from) < -3);
      ticks.push_back({at, !has_number ? ""
                           : as_power  ? fmt::format("10^{{{}}}", number_text(decade))
                                       : number_text(at)});
    }
  return numbers < 2 ? linear_ticks(from, to, length, closest_x) : ticks;
}

AxisLayout axis_of(const Plot& plot, const Panel& panel, const Axis& axis, bool is_x) {
  const auto [from, to] = range_of(plot, panel, axis, is_x);
  return {from, to, {}, true, label_of(axis)};
}

void place_ticks(AxisLayout& laid, const Axis& axis, double length, double closest) {
  laid.ticks = axis.logarithmic ? logarithmic_ticks(laid.from, laid.to, length)
                                : linear_ticks(laid.from, laid.to, length, closest);
}

bool is_same(const AxisLayout& a, const AxisLayout& b) {
  return a.label == b.label && a.from == b.from && a.to == b.to;
}

double widest_number(const AxisLayout& axis) {
  double longest = 0;
  if (axis.has_numbers)
    for (const Tick& tick : axis.ticks) longest = std::max(longest, text_width(tick.text));
  return longest;
}

bool has_pixels(const Panel& panel) {
  return std::any_of(panel.marks.begin(), panel.marks.end(),
                     [](const Mark& mark) { return mark.kind == MarkKind::pixels; });
}

std::vector<std::string> key_of(const Plot& plot, const Panel& panel) {
  std::vector<std::string> titles;
  for (const Mark& mark : panel.marks)
    if (mark.kind != MarkKind::label && !mark.title.empty() && has_something(plot, mark)) titles.push_back(mark.title);
  return titles;
}

std::size_t count_lines(const std::string& title) {
  return title.empty() ? 0 : 1 + static_cast<std::size_t>(std::count(title.begin(), title.end(), '\n'));
}

// The layout of a plot, part by part: in millimetres from the left and from the top until it is done.
class Layout {
 public:
  explicit Layout(const Plot& plot)
      : plot_(plot),
        columns_(std::max<std::size_t>(1, std::min(plot.columns, plot.panels.size()))),
        rows_((plot.panels.size() + columns_ - 1) / columns_),
        laid_(plot.panels.size()) {
    for (std::size_t i = 0; i < laid_.size(); ++i) {
      const Panel& panel = plot.panels[i];
      laid_[i].x = axis_of(plot, panel, panel.x, true);
      laid_[i].y = axis_of(plot, panel, panel.y, false);
    }
    share_axes();
    across();
    down();
  }

  PlotLayout done() && {
    for (PanelLayout& panel : laid_) {
      for (double* x : {&panel.left, &panel.right, &panel.x_label.x, &panel.y_label.x, &panel.colour_label.x,
                        &panel.title.x, &panel.key.x})
        *x /= plot_.width;
      for (double* y : {&panel.bottom, &panel.top, &panel.x_label.y, &panel.y_label.y, &panel.colour_label.y,
                        &panel.title.y, &panel.key.y})
        *y = 1 - *y / plot_.height;
    }
    PlotLayout all{std::move(laid_), std::move(x_), std::move(y_), {}, {}};
    double left = 1, right = 0, top = 0, bottom = 1;
    for (const PanelLayout& panel : all.panels) {
      left = std::min(left, panel.left);
      right = std::max(right, panel.right);
      top = std::max(top, panel.top);
      bottom = std::min(bottom, panel.bottom);
    }
    all.x_label = {(left + right) / 2, (figure_edge + line_height / 2) / plot_.height};
    all.y_label = {(figure_edge + line_height / 2) / plot_.width, (top + bottom) / 2};
    return all;
  }

 private:
  // What stands once for several panels.
  void share_axes() {
    x_.label = y_.label = "";
    const auto all_have = [&](AxisLayout PanelLayout::*axis) {
      return std::all_of(laid_.begin(), laid_.end(),
                         [&](const PanelLayout& panel) { return (panel.*axis).label == (laid_.front().*axis).label; });
    };
    const bool same_x = columns_ > 1 && all_have(&PanelLayout::x);
    const bool same_y = columns_ > 1 && rows_ > 1 && all_have(&PanelLayout::y);
    for (std::size_t i = laid_.size(); i-- > 0;) {  // from the last, so that a neighbour still has its label
      if (i % columns_ > 0 && is_same(laid_[i].y, laid_[i - 1].y))
        laid_[i].y.label = "", laid_[i].y.has_numbers = false;
    }
    for (std::size_t i = 0; i + columns_ < laid_.size(); ++i)
      if (is_same(laid_[i].x, laid_[i + columns_].x)) laid_[i].x.label = "", laid_[i].x.has_numbers = false;
    if (same_x) x_.label = laid_.back().x.label;
    if (same_y) y_.label = laid_.front().y.label;
    for (PanelLayout& panel : laid_) {
      if (same_x) panel.x.label = "";
      if (same_y) panel.y.label = "";
    }
  }

  void across() {
    const double roughly_high = 0.75 * plot_.height;
    double shares = 0;
    for (std::size_t row = 0; row < rows_; ++row) shares += share_of(row);
    for (std::size_t i = 0; i < laid_.size(); ++i)
      place_ticks(laid_[i].y, plot_.panels[i].y, roughly_high * plot_.panels[i].share / shares, closest_y);
    std::vector<double> before(columns_, 0);  // [mm] left of a column
    double after = 2.2 + figure_edge;         // of the last
    for (std::size_t i = 0; i < laid_.size(); ++i) {
      const AxisLayout& y = laid_[i].y;
      const std::size_t column = i % columns_;
      const double numbers = widest_number(y), label = y.label.empty() ? 0 : line_height + 1.2;
      const double gap = column == 0 ? figure_edge : y.has_numbers ? 3.4 : joined_gap;
      before[column] = std::max(before[column], gap + label + (numbers > 0 ? numbers + to_numbers : 0));
      if (has_pixels(plot_.panels[i])) {
        laid_[i].colour = colour_axis(plot_.panels[i], roughly_high);
        after = std::max(
            after, 2 * colour_bar_width + to_numbers + widest_number(laid_[i].colour) + line_height + 2 * figure_edge);
      }
    }
    if (!y_.label.empty()) before[0] += line_height + 0.8;
    double free = plot_.width - after;
    for (const double space : before) free -= space;
    const double width = free / static_cast<double>(columns_);
    for (std::size_t i = 0; i < laid_.size(); ++i) {
      const std::size_t column = i % columns_;
      double left = static_cast<double>(column) * width;
      for (std::size_t c = 0; c <= column; ++c) left += before[c];
      laid_[i].left = left;
      laid_[i].right = left + width;
      const double first = column == 0 ? (y_.label.empty() ? 0 : line_height + 0.8) : left - before[column];
      laid_[i].y_label.x = first + (column == 0 ? figure_edge : 3.4) + line_height / 2;
      laid_[i].title.x = left;
      laid_[i].colour_label.x = plot_.width - figure_edge - line_height / 2;
      place_ticks(laid_[i].x, plot_.panels[i].x, width, closest_x);
      // The last number would meet the first one of the next panel.
      const bool is_joined = column + 1 < columns_ && i + 1 < laid_.size() && !laid_[i + 1].y.has_numbers;
      AxisLayout& x = laid_[i].x;
      if (is_joined)
        for (Tick& tick : x.ticks)
          if ((x.to - tick.at) / (x.to - x.from) * width < text_width(tick.text)) tick.text = "";
      if (laid_[i].x.label.empty()) continue;
      laid_[i].x_label.x = left + width / 2;
    }
  }

  AxisLayout colour_axis(const Panel& panel, double length) const {
    AxisLayout axis{panel.colour.from, panel.colour.to, {}, true, label_of(panel.colour)};
    place_ticks(axis, panel.colour, length, closest_y);
    return axis;
  }

  double share_of(std::size_t row) const {
    double share = 0;
    for (std::size_t i = row * columns_; i < std::min((row + 1) * columns_, laid_.size()); ++i)
      share = std::max(share, plot_.panels[i].share);
    return share;
  }

  // A key is as wide as there is room to the right until the next one. It stands beside a letter, above a title.
  double place_keys(std::size_t first, std::size_t last, double title_height) {
    double height = title_height, end = plot_.width - figure_edge;
    for (std::size_t i = last; i-- > first;) {
      const auto titles = key_of(plot_, plot_.panels[i]);
      if (titles.empty()) continue;
      double longest = 0;
      for (const auto& title : titles) longest = std::max(longest, text_width(title));
      const double letter = text_width(plot_.panels[i].title);
      const bool is_beside = letter < longest_letter;
      laid_[i].key = {laid_[i].left + (is_beside && letter > 0 ? letter : 0), is_beside ? 0 : title_height};
      const auto fit = std::max(1.0, std::floor((end - laid_[i].key.x) / (longest + key_sample)));
      laid_[i].key_rows = static_cast<std::size_t>(std::ceil(static_cast<double>(titles.size()) / fit));
      height = std::max(height, laid_[i].key.y + key_height * static_cast<double>(laid_[i].key_rows));
      end = laid_[i].left - 2;
    }
    return height;
  }

  void down() {
    std::vector<double> above(rows_, 0), below(rows_, 0), title(rows_, 0);
    double free = plot_.height, shares = 0;
    for (std::size_t row = 0; row < rows_; ++row) {
      const std::size_t first = row * columns_, last = std::min(first + columns_, laid_.size());
      std::size_t lines = 0;
      for (std::size_t i = first; i < last; ++i) {
        lines = std::max(lines, count_lines(plot_.panels[i].title));
        const AxisLayout& x = laid_[i].x;
        below[row] = std::max(below[row],
                              (x.has_numbers ? numbers_below : joined_gap / 2) + (x.label.empty() ? 0 : line_height));
      }
      title[row] = line_height * static_cast<double>(lines);
      above[row] = place_keys(first, last, title[row]) + (row == 0 ? figure_edge + 1 : joined_gap / 2);
      if (row + 1 == rows_) below[row] += figure_edge + (x_.label.empty() ? 0 : line_height);
      free -= above[row] + below[row];
      shares += share_of(row);
    }
    double y = 0;
    for (std::size_t row = 0; row < rows_; ++row) {
      const double height = free * share_of(row) / shares;
      y += above[row];
      for (std::size_t i = row * columns_; i < std::min((row + 1) * columns_, laid_.size()); ++i) {
        PanelLayout& panel = laid_[i];
        panel.top = y;
        panel.bottom = y + height;
        panel.key.y = y - 0.8 - panel.key.y;
        panel.title.y = y - 0.7 - line_height / 2;
        panel.y_label.y = panel.colour_label.y = y + height / 2;
        panel.x_label.y = y + height + numbers_below + line_height / 2;
        place_ticks(panel.y, plot_.panels[i].y, height, closest_y);
        if (has_pixels(plot_.panels[i])) panel.colour = colour_axis(plot_.panels[i], height);
      }
      y += height + below[row];
    }
  }

  const Plot& plot_;
  std::size_t columns_, rows_;
  std::vector<PanelLayout> laid_;
  AxisLayout x_{}, y_{};
};

}  // namespace

PlotLayout layout_of(const Plot& plot) { return Layout(plot).done(); }

const PlotTable& table_of(const Plot& plot, std::string_view name) {
  const auto found =
      std::find_if(plot.data.begin(), plot.data.end(), [&](const PlotTable& table) { return table.name == name; });
  if (found == plot.data.end()) throw std::invalid_argument(fmt::format("{}: no table {}", plot.name, name));
  return *found;
}

std::string label_of(const Axis& axis) {
  return axis.unit.empty() ? axis.label : fmt::format("{} ({})", axis.label, axis.unit);
}

bool is_drawn(const Mark& mark, const std::vector<double>& row) {
  return !row.empty() && std::all_of(mark.only.begin(), mark.only.end(), [&](const Condition& condition) {
    return row.at(condition.column) == condition.value;
  });
}

bool has_something(const Plot& plot, const Mark& mark) {
  if (mark.table.empty()) return true;
  const PlotTable& table = table_of(plot, mark.table);
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<double>& row) {
    return is_drawn(mark, row) && std::all_of(mark.columns.begin(), mark.columns.end(),
                                              [&](std::size_t column) { return std::isfinite(row.at(column)); });
  });
}

std::vector<TextPiece> text_pieces(const std::string& markup) {
  std::vector<TextPiece> pieces;
  TextPiece::Style style = TextPiece::plain;
  const auto add = [&](std::string_view text, TextPiece::Style as) {
    if (text.empty()) return;
    if (pieces.empty() || pieces.back().style != as) pieces.push_back({as, ""});
    pieces.back().text += text;
  };
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const std::string_view rest = std::string_view(markup).substr(i);
    if (rest.front() == '\\' && rest.size() > 1) {
      add(rest.substr(1, 1), style);
      ++i;
    } else if (rest.front() == '*') {
      style = style == TextPiece::italic ? TextPiece::plain : TextPiece::italic;
    } else if ((rest.front() == '_' || rest.front() == '^') && rest.size() > 1) {
      const auto as = rest.front() == '_' ? TextPiece::below : TextPiece::above;
      const auto end = rest[1] == '{' ? rest.find('}') : std::string_view::npos;
      const bool is_group = end != std::string_view::npos;
      add(is_group ? rest.substr(2, end - 2) : rest.substr(1, 1), as);
      i += is_group ? end : 1;
    } else {
      add(rest.substr(0, 1), style);
    }
  }
  return pieces;
}

std::string as_it_is(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\*_^").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

double round_step(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  const double share = value / decade * (1 - 1e-12);
  return (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10) * decade;
}

}  // namespace flexslip
