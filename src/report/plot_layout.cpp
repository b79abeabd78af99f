#include "report/plot_layout.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace flexslip {
namespace {

// [mm] of type of this size.
constexpr double key_height = 3.6;  // of a row of a key
constexpr double key_sample = 10;   // the line before its words, and what is left free
constexpr double figure_edge = 1.2, joined_gap = 2.6, panel_gap = 3.4;
constexpr double to_numbers = 1.3,
                 numbers_below = 5.2;  // from the frame to those beside it, and to the lower end of those below
constexpr double closest_x = 10, closest_y = 7;  // numbers of an axis

// [mm] Wide rather than narrow: the machine at hand may not have Arial.
double text_width(const std::string& markup) {
  constexpr double em = font_size * 25.4 / 72;
  double ems = 0;
  for (const TextPiece& piece : text_pieces(markup))
    for (const char c : piece.text) {
      if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue;
      const std::string_view narrow = "ijlrtf.,:;'|!()[]I /", wide = "mwMW%@";
      ems += narrow.find(c) != narrow.npos ? 0.36 : wide.find(c) != wide.npos ? 0.9 : 0.6;
    }
  return em * ems;
}

// Which columns of a mark lie along an axis.
std::vector<std::size_t> columns_along(MarkKind kind, bool is_x) {
  using Columns = std::vector<std::size_t>;
  switch (kind) {
    case MarkKind::line:
    case MarkKind::points:
    case MarkKind::area:
      return is_x ? Columns{0} : Columns{1};
    case MarkKind::band:
    case MarkKind::bars:
      return is_x ? Columns{0} : Columns{1, 2};
    case MarkKind::spans:
      return is_x ? Columns{0, 1} : Columns{2};
    case MarkKind::arrows:
      return is_x ? Columns{0, 2} : Columns{1, 3};
    case MarkKind::pixels:
      return is_x ? Columns{0, 1} : Columns{2, 3};
    default:
      return {};
  }
}

std::pair<double, double> range_of(const Plot& plot, const Panel& panel, const Axis& axis, bool is_x) {
  double low = INFINITY, high = -INFINITY;
  for (const Mark& mark : panel.marks) {
    if (mark.table.empty()) continue;
    const auto columns = columns_along(mark.kind, is_x);
    for (const auto& row : table_of(plot, mark.table).rows)
      for (const std::size_t place : columns) {
        if (!is_drawn(mark, row)) continue;
        const double value = row.at(mark.columns.at(place));
        if (!std::isfinite(value) || (axis.logarithmic && !(value > 0))) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
  }
  if (!(low <= high)) low = axis.logarithmic ? 1 : 0, high = axis.logarithmic ? 10 : 1;
  const bool from_data = !std::isfinite(axis.from), to_data = !std::isfinite(axis.to);
  if (!from_data) low = axis.from;
  if (!to_data) high = axis.to;
  if (!(low < high)) high = axis.logarithmic ? 10 * low : low + (low != 0 ? std::abs(low) : 1);
  constexpr double space = 0.04;  // [1] of the range, at an end that the data decide
  const double margin = axis.logarithmic ? std::pow(high / low, space) : space * (high - low);
  const auto away = [&](double end, double sign) {
    return axis.logarithmic ? end * std::pow(margin, sign) : end + sign * margin;
  };
  return {from_data ? away(low, -1) : low, to_data ? away(high, 1) : high};
}

std::string number_text(double value) {
  std::string text = fmt::format("{:.6g}", value);
  if (const auto e = text.find('e'); e != std::string::npos)
    text = fmt::format("{}10^{{{}}}", text.substr(0, e) == "1" ? "" : text.substr(0, e) + "·",
                       std::stoi(text.substr(e + 1)));
  for (auto minus = text.find('-'); minus != std::string::npos; minus = text.find('-')) text.replace(minus, 1, "−");
  return text;
}

std::vector<Tick> linear_ticks(double from, double to, double length, double closest) {
  std::vector<Tick> ticks;
  const double half = round_step((to - from) * closest / length) / 2, rounding = 1e-9 * (to - from);
  for (double k = std::ceil((from - rounding) / half); k * half <= to + rounding; ++k)
    ticks.push_back({k * half, std::fmod(k, 2) == 0 ? number_text(k == 0 ? 0 : k * half) : ""});
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double from, double to, double length, double closest) {
  const double decades = std::log10(to / from);
  const double room = length / decades / closest;  // numbers in a decade
  const std::string_view with_number = room >= 8 ? "123468" : room >= 3.4 ? "125" : room >= 2 ? "13" : "1";
  const int every = std::max(1, static_cast<int>(std::ceil(1 / room)));  // decade
  const bool as_powers = with_number.size() == 1 && (std::log10(to) > 4 || std::log10(from) < -3);
  std::vector<Tick> ticks;
  std::size_t numbers = 0;
  for (int decade = static_cast<int>(std::floor(std::log10(from))); decade <= std::log10(to) + 1e-9; ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const double at = digit * std::pow(10, decade);
      if (at < from * (1 - 1e-9) || at > to * (1 + 1e-9)) continue;
      const bool has_number =
          decade % every == 0 && with_number.find(static_cast<char>('0' + digit)) != with_number.npos;
      if (!has_number && decades > 5 && digit != 1) continue;
      numbers += has_number ? 1 : 0;
      ticks.push_back({at, !has_number ? ""
                           : as_powers ? fmt::format("10^{{{}}}", number_text(decade))
                                       : number_text(at)});
    }
  return numbers < 2 ? linear_ticks(from, to, length, closest_x) : ticks;
}

void place_ticks(AxisLayout& laid, const Axis& axis, double length, double closest) {
  laid.ticks = axis.logarithmic ? logarithmic_ticks(laid.from, laid.to, length, closest)
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

// The layout of a plot, part by part.
class Layout {
 public:
  explicit Layout(const Plot& plot)
      : plot_(plot),
        columns_(std::clamp<std::size_t>(plot.columns, 1, std::max<std::size_t>(1, plot.panels.size()))),
        rows_((plot.panels.size() + columns_ - 1) / columns_),
        before_(columns_, 0) {
    all_.panels.resize(plot.panels.size());
    for (std::size_t i = 0; i < plot.panels.size(); ++i) {
      const Panel& panel = plot.panels[i];
      const auto laid = [&](const Axis& axis, bool is_x) {
        const auto [from, to] = range_of(plot, panel, axis, is_x);
        return AxisLayout{from, to, {}, true, label_of(axis)};
      };
      all_.panels[i].x = laid(panel.x, true);
      all_.panels[i].y = laid(panel.y, false);
      all_.panels[i].colour = {panel.colour.from, panel.colour.to, {}, true, label_of(panel.colour)};
    }
    share_axes();
    // Twice, since the width of numbers depends on the height of panels, and that of a key on their width.
    for (int round = 0; round < 2; ++round) {
      across();
      down();
    }
  }

  PlotLayout done() && { return std::move(all_); }

 private:
  // What stands once for several panels.
  void share_axes() {
    auto& panels = all_.panels;
    const auto once = [&](AxisLayout PanelLayout::*axis, bool wanted) {
      return wanted && std::all_of(panels.begin(), panels.end(), [&](const PanelLayout& panel) {
               return (panel.*axis).label == (panels.front().*axis).label;
             });
    };
    const bool same_x = once(&PanelLayout::x, columns_ > 1), same_y = once(&PanelLayout::y, columns_ > 1 && rows_ > 1);
    if (same_x) all_.x = panels.back().x.label;
    if (same_y) all_.y = panels.front().y.label;
    // In an order in which a neighbour still has its label.
    for (std::size_t i = panels.size(); i-- > 0;) {
      AxisLayout& y = panels[i].y;
      if (i % columns_ > 0 && is_same(y, panels[i - 1].y)) y.label = "", y.has_numbers = false;
    }
    for (std::size_t i = 0; i < panels.size(); ++i) {
      AxisLayout& x = panels[i].x;
      if (i + columns_ < panels.size() && is_same(x, panels[i + columns_].x)) x.label = "", x.has_numbers = false;
    }
    for (PanelLayout& panel : panels) {
      if (same_x) panel.x.label = "";
      if (same_y) panel.y.label = "";
    }
  }

  void across() {
    double after = 2.2 + figure_edge;  // [mm] of the last column
    std::fill(before_.begin(), before_.end(), 0);
    for (std::size_t i = 0; i < all_.panels.size(); ++i) {
      PanelLayout& laid = all_.panels[i];
      const Panel& panel = plot_.panels[i];
      const double height = laid.upper.y > 0 ? (laid.upper.y - laid.lower.y) * plot_.height : 0.2 * plot_.height;
      place_ticks(laid.y, panel.y, height, closest_y);
      const double numbers = widest_number(laid.y), label = laid.y.label.empty() ? 0 : line_height + 1.6;
      double& before = before_[i % columns_];
      before = std::max(before, (i % columns_ == 0    ? left_edge()
                                 : laid.y.has_numbers ? panel_gap
                                                      : joined_gap) +
                                    label + (numbers > 0 ? numbers + to_numbers : 0));
      if (!has_pixels(panel)) continue;
      place_ticks(laid.colour, panel.colour, height, closest_y);
      after = 2 * colour_bar + to_numbers + widest_number(laid.colour) + line_height + 2 * figure_edge;
    }
    width_ = plot_.width - after;
    for (const double space : before_) width_ -= space;
    width_ /= static_cast<double>(columns_);
    for (std::size_t i = 0; i < all_.panels.size(); ++i) {
      AxisLayout& x = all_.panels[i].x;
      place_ticks(x, plot_.panels[i].x, width_, closest_x);
      if (widest_number(x) + 2 > closest_x) place_ticks(x, plot_.panels[i].x, width_, widest_number(x) + 2);
      // The last number would meet the first one of a neighbour that is close.
      const bool is_joined = i + 1 < all_.panels.size() && (i + 1) % columns_ > 0 && !all_.panels[i + 1].y.has_numbers;
      for (Tick& tick : x.ticks)
        if (is_joined && (x.to - tick.at) / (x.to - x.from) * width_ < text_width(tick.text)) tick.text = "";
    }
  }

  double left_edge() const { return figure_edge + (all_.y.empty() ? 0 : line_height + 0.8); }  // [mm]
  double left_of(std::size_t column) const {                                                   // [mm]
    double left = static_cast<double>(column) * width_;
    for (std::size_t c = 0; c <= column; ++c) left += before_[c];
    return left;
  }

  double share_of(std::size_t row) const {
    double share = 0;
    for (std::size_t i = row * columns_; i < std::min((row + 1) * columns_, plot_.panels.size()); ++i)
      share = std::max(share, plot_.panels[i].share);
    return share;
  }

  // The height above a row of panels [mm]. A key is as wide as there is room to the right until the next one; it stands beside a letter, above
  // a title.
  double above(std::size_t first, std::size_t last) {
    double title = 0, height = 0, end = plot_.width - figure_edge, end_of_next = end;
    for (std::size_t i = first; i < last; ++i)
      if (const std::string& words = plot_.panels[i].title; !words.empty())
        title = std::max(title, line_height * static_cast<double>(1 + std::count(words.begin(), words.end(), '\n')));
    for (std::size_t i = last; i-- > first;) {
      const double letter = text_width(plot_.panels[i].title), left = left_of(i % columns_);
      const bool is_letter = plot_.panels[i].title.size() <= 1;
      std::size_t entries = 0;
      double longest = 0;
      for (const Mark& mark : plot_.panels[i].marks) {
        if (mark.kind == MarkKind::label || mark.title.empty() || !has_something(plot_, mark)) continue;
        ++entries;
        longest = std::max(longest, text_width(mark.title));
      }
      if (entries > 0 || (is_letter && letter > 0)) end_of_next = left - 2;
      if (entries == 0) {
        end = end_of_next;
        continue;
      }
      PanelLayout& laid = all_.panels[i];
      laid.key = is_letter ? Place{left + (letter > 0 ? letter + 1.5 : 0), 0} : Place{left, title};
      laid.key_width = longest + key_sample;
      const double fit = std::max(1.0, std::floor((end - laid.key.x) / laid.key_width));
      laid.key_rows = static_cast<std::size_t>(std::ceil(static_cast<double>(entries) / fit));
      height = std::max(height, laid.key.y + key_height * static_cast<double>(laid.key_rows));
      end = end_of_next;
    }
    return std::max(title, height);
  }

  void down() {
    std::vector<double> above_row(rows_), below(rows_, 0);
    double free = plot_.height, shares = 0;
    for (std::size_t row = 0; row < rows_; ++row) {
      const std::size_t first = row * columns_, last = std::min(first + columns_, all_.panels.size());
      above_row[row] = above(first, last) + (row == 0 ? figure_edge + 1 : joined_gap / 2);
      for (std::size_t i = first; i < last; ++i) {
        const AxisLayout& x = all_.panels[i].x;
        below[row] = std::max(below[row],
                              (x.has_numbers ? numbers_below : joined_gap / 2) + (x.label.empty() ? 0 : line_height));
      }
      if (row + 1 == rows_) below[row] += figure_edge + (all_.x.empty() ? 0 : line_height);
      free -= above_row[row] + below[row];
      shares += share_of(row);
    }
    const auto place = [&](double x, double from_top) { return Place{x / plot_.width, 1 - from_top / plot_.height}; };
    double y = 0, first_top = above_row.empty() ? 0 : above_row[0];
    for (std::size_t row = 0; row < rows_; ++row) {
      const double height = free * share_of(row) / shares;
      y += above_row[row];
      for (std::size_t i = row * columns_; i < std::min((row + 1) * columns_, all_.panels.size()); ++i) {
        PanelLayout& laid = all_.panels[i];
        const std::size_t column = i % columns_;
        const double left = left_of(column);
        laid.lower = place(left, y + height);
        laid.upper = place(left + width_, y);
        laid.title = place(left, y - 0.7 - line_height / 2);
        laid.key = place(laid.key.x, y - 0.8 - laid.key.y);
        laid.x_label = place(left + width_ / 2, y + height + numbers_below + line_height / 2);
        laid.y_label =
            place(left - before_[column] + (column == 0 ? left_edge() : panel_gap) + line_height / 2, y + height / 2);
        laid.colour_label = place(plot_.width - figure_edge - line_height / 2, y + height / 2);
        place_ticks(laid.y, plot_.panels[i].y, height, closest_y);
        if (has_pixels(plot_.panels[i])) place_ticks(laid.colour, plot_.panels[i].colour, height, closest_y);
      }
      y += height + below[row];
    }
    const double right = left_of(columns_ - 1) + width_, bottom = y - (below.empty() ? 0 : below.back());
    all_.x_label = place((left_of(0) + right) / 2, plot_.height - figure_edge - line_height / 2);
    all_.y_label = place(figure_edge + line_height / 2, (first_top + bottom) / 2);
  }

  const Plot& plot_;
  std::size_t columns_, rows_;
  std::vector<double> before_;  // [mm] left of a column
  double width_ = 0;            // [mm] of a panel
  PlotLayout all_{};
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
