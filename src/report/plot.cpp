#include "report/plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "data/names.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// [mm] for this font size
constexpr double key_sample = 10;  // the sample before the words of a key, with its gap
constexpr double figure_edge = 1.2, joined_gap = 2.6, panel_gap = 3.4, line_height = 3.4;
constexpr double to_numbers = 1.3;               // from the frame to the numbers next to it
constexpr double numbers_below = 5.2;            // from the frame to the lower end of the numbers below it
constexpr double closest_x = 10, closest_y = 6;  // smallest distance between numbers of an axis
constexpr double usual_margin = 11;              // left of a panel, before its numbers are known

// [mm] An upper estimate, because another font may replace Arial.
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

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const auto to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

bool is_drawn(const Mark& mark, const std::vector<double>& row) {
  return !row.empty() && std::all_of(mark.only.begin(), mark.only.end(), [&](const Condition& condition) {
    return row.at(condition.column) == condition.value;
  });
}

// True if the mark has something to draw or an entry in the key.
bool has_something(const Plot& plot, const Mark& mark) {
  if (mark.table.empty()) return true;
  const auto& rows = table_of(plot, mark.table).rows;
  return std::any_of(rows.begin(), rows.end(), [&](const std::vector<double>& row) {
    return is_drawn(mark, row) && std::all_of(mark.columns.begin(), mark.columns.end(),
                                              [&](std::size_t column) { return std::isfinite(row.at(column)); });
  });
}

// The axis of each column of a mark.
std::string_view axes_of(Mark::Kind kind) {
  return name_in_order<Mark::label>(kind, {"xy", "xy", "xy", "xyy", "xyy", "xxy", "xyxy", "xxyy", ""});
}

// Chooses the ends of an axis from the data.
void decide_ends(Axis& axis, const Plot& plot, const Panel& panel, char name) {
  double low = infinity, high = -infinity;
  for (const Mark& mark : panel.marks) {
    if (mark.table.empty()) continue;
    const std::string_view along = axes_of(mark.kind);
    for (const auto& row : table_of(plot, mark.table).rows)
      for (std::size_t k = 0; k < along.size(); ++k) {
        if (along[k] != name || !is_drawn(mark, row)) continue;
        const double value = row.at(mark.columns.at(k));
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
  constexpr double space = 0.04;  // [1] of the range, at an end chosen from the data
  const double margin = axis.logarithmic ? std::pow(high / low, space) : space * (high - low);
  axis.from = !from_data ? low : axis.logarithmic ? low / margin : low - margin;
  axis.to = !to_data ? high : axis.logarithmic ? high * margin : high + margin;
}

std::string number_text(double value) {
  std::string text = fmt::format("{:.6g}", value);
  if (const auto e = text.find('e'); e != std::string::npos)
    text = fmt::format("{}10^{{{}}}", text.substr(0, e) == "1" ? "" : text.substr(0, e) + "·",
                       std::stoi(text.substr(e + 1)));
  return replaced(text, "-", "−");
}

// A round distance between ticks (1, 2 or 5 times a power of ten), at least the given value.
double round_step(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value))), share = value / decade * (1 - 1e-12);
  return (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10) * decade;
}

std::vector<Tick> linear_ticks(double from, double to, double length, double closest) {
  const double step = round_step((to - from) * closest / length), rounding = 1e-9 * (to - from);
  const auto ticks_every = [&](int numbered) {
    std::vector<Tick> ticks;
    for (double k = std::ceil((from - rounding) / step * 2); k * step / 2 <= to + rounding; ++k)
      ticks.push_back({k * step / 2, std::fmod(k, numbered) == 0 ? number_text(k == 0 ? 0 : k * step / 2) : ""});
    return ticks;
  };
  std::vector<Tick> ticks = ticks_every(2);
  const auto numbers = std::count_if(ticks.begin(), ticks.end(), [](const Tick& tick) { return !tick.text.empty(); });
  return numbers < 2 ? ticks_every(1) : ticks;
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
      ticks.push_back({std::clamp(at, from, to), !has_number ? ""
                                                 : as_powers ? fmt::format("10^{{{}}}", number_text(decade))
                                                             : number_text(at)});
    }
  return numbers < 2 ? linear_ticks(from, to, length, closest_x) : ticks;
}

// Thins names so that each fits; the others become minor ticks.
std::vector<Tick> ticks_of_names(const Axis& axis, double length) {
  const double distance = length / (axis.to - axis.from);
  std::vector<Tick> ticks;
  double next = -infinity;
  for (const Tick& name : axis.names) {
    const bool fits = name.at * distance >= next - 1e-9 * length;
    ticks.push_back({name.at, fits ? name.text : ""});
    if (fits) next = name.at * distance + line_height;
  }
  return ticks;
}

void decide_ticks(Axis& axis, double length, double closest) {
  if (!axis.names.empty()) {
    axis.ticks = ticks_of_names(axis, length);
    return;
  }
  axis.ticks = (axis.logarithmic ? logarithmic_ticks : linear_ticks)(axis.from, axis.to, length, closest);
  if (axis.counts) std::erase_if(axis.ticks, [](const Tick& tick) { return tick.at != std::round(tick.at); });
}

double widest_number(const Axis& axis) {
  double widest = 0;
  if (axis.has_numbers)
    for (const Tick& tick : axis.ticks) widest = std::max(widest, text_width(tick.text));
  return widest;
}

// The distance from the frame to the lower end of the text below it.
double numbers_below_of(const Axis& axis) {
  if (!axis.has_numbers || axis.names.empty()) return axis.has_numbers ? numbers_below : joined_gap / 2;
  double longest = 0;
  for (const Tick& name : axis.names) longest = std::max(longest, text_width(name.text));
  return longest + to_numbers + 0.8;
}

std::string label_of(const Axis& axis) {
  return axis.unit.empty() ? axis.label : fmt::format("{} ({})", axis.label, axis.unit);
}

bool is_same(const Axis& a, const Axis& b) {
  return label_of(a) == label_of(b) && a.from == b.from && a.to == b.to && a.logarithmic == b.logarithmic;
}

bool has_pixels(const Panel& panel) {
  return std::any_of(panel.marks.begin(), panel.marks.end(),
                     [](const Mark& mark) { return mark.kind == Mark::pixels; });
}

// Places a label: below the upper edge, above the lower edge or a horizontal line, or around a
// point.
std::vector<Text> placed(const Mark& label, const Panel& panel) {
  const auto place = [](double value, const Axis& axis, double begin, double length) {
    if (std::isinf(value)) return begin + (value > 0 ? length : 0);
    return begin + length * (axis.logarithmic ? std::log(value / axis.from) / std::log(axis.to / axis.from)
                                              : (value - axis.from) / (axis.to - axis.from));
  };
  const double x = label.at.at(0), y = label.at.at(1);
  const bool at_side = std::isinf(x), at_end = std::isinf(y);
  const std::vector<std::string> lines = lines_in(label.title);
  const auto last = static_cast<double>(lines.size() - 1);
  const double first = at_end && y > 0 ? -2.4
                                       : (at_end    ? 3
                                          : at_side ? 1.9
                                                    : 0) +
                                             last / (at_end || at_side ? 1 : 2) * line_height;
  std::vector<Text> texts;
  for (const std::string& line : lines)
    texts.push_back(
        {line, place(x, panel.x, panel.left, panel.width) - (at_side ? std::copysign(1.5, x) : 0),
         place(y, panel.y, panel.bottom, panel.height) + first - line_height * static_cast<double>(texts.size()),
         !at_side ? Text::centre
         : x < 0  ? Text::left
                  : Text::right,
         false, at_end || !at_side});
  return texts;
}

// Places keys to the right of a letter or above a title, up to the next key or letter. Returns the
// height [mm] of both above a row of panels.
double decide_keys(std::vector<Panel>& panels, std::size_t first, std::size_t last, double pitch, double end) {
  double title = 0, height = 0, end_of_next = end;
  for (std::size_t i = first; i < last; ++i)
    if (!panels[i].title.empty())
      title = std::max(title, line_height * static_cast<double>(lines_in(panels[i].title).size()));
  for (std::size_t i = last; i-- > first;) {
    Panel& panel = panels[i];
    const double letter = text_width(panel.title), left = pitch * static_cast<double>(i - first) + usual_margin;
    const bool is_letter = panel.title.size() <= 1;
    std::size_t entries = 0;
    for (const Mark& mark : panel.marks) {
      if (mark.kind == Mark::label || mark.title.empty()) continue;
      ++entries;
      panel.key_width = std::max(panel.key_width, text_width(mark.title) + key_sample);
    }
    if (entries > 0 || (is_letter && letter > 0)) end_of_next = left - 2;
    if (entries > 0) {
      panel.key_left = is_letter && letter > 0 ? letter + 1.5 : 0;
      const double across = std::max(1.0, std::floor((end - left - panel.key_left) / panel.key_width));
      panel.key_rows = static_cast<std::size_t>(std::ceil(static_cast<double>(entries) / across));
      panel.key_top = 0.7 + (is_letter ? 0 : title) + key_height * static_cast<double>(panel.key_rows);
      height = std::max(height, panel.key_top - 0.7);
    }
    end = end_of_next;
  }
  return std::max(title, height);
}

Json json_of(const Text& text) {
  return {{"words", text.words},
          {"x", text.x},
          {"y", text.y},
          {"anchor", name_in_order<Text::right>(text.anchor, {"left", "center", "right"})},
          {"upright", text.upright},
          {"boxed", text.boxed}};
}

Json json_of(const Tick& tick) { return Json::array({tick.at, tick.text}); }

template <class Each>
Json list_of(const std::vector<Each>& each) {
  Json list = Json::array();
  for (const Each& one : each) list.push_back(json_of(one));
  return list;
}

Json json_of(const Axis& axis) {
  return {{"label", label_of(axis)},         {"from", axis.from},           {"to", axis.to},
          {"logarithmic", axis.logarithmic}, {"numbers", axis.has_numbers}, {"ticks", list_of(axis.ticks)},
          {"upright", !axis.names.empty()},  {"title", json_of(axis.title)}};
}

Json json_of(const Style& style) {
  return {{"colour", style.colour},
          {"width", style.width},
          {"dash", name_in_order<Dash::dotted>(style.dash, {"solid", "dashed", "long_dashed", "dotted"})},
          {"symbol", name_in_order<Symbol::cross>(
                         style.symbol, {"", "disc", "circle", "square", "triangle", "down", "star", "cross"})},
          {"size", style.size},
          {"opacity", style.opacity}};
}

Json json_of(const Mark& mark, const Plot& plot) {
  Json columns = Json::array(), only = Json::object();
  if (!mark.table.empty()) {
    const std::vector<std::string>& titles = table_of(plot, mark.table).titles;
    for (const std::size_t column : mark.columns) columns.push_back(titles.at(column));
    for (const Condition& condition : mark.only) only[titles.at(condition.column)] = condition.value;
  }
  return {{"kind", name_in_order<Mark::label>(
                       mark.kind, {"line", "points", "area", "band", "bars", "spans", "arrows", "pixels", "label"})},
          {"table", mark.table},
          {"columns", columns},
          {"at", mark.at},
          {"only", only},
          {"title", mark.title},
          {"style", json_of(mark.style)}};
}

Json json_of(const Panel& panel, const Plot& plot) {
  Json marks = Json::array();
  for (const Mark& mark : panel.marks) marks.push_back(json_of(mark, plot));
  return {{"title", panel.title},          {"left", panel.left},
          {"bottom", panel.bottom},        {"width", panel.width},
          {"height", panel.height},        {"key_left", panel.key_left},
          {"key_top", panel.key_top},      {"key_width", panel.key_width},
          {"key_rows", panel.key_rows},    {"x", json_of(panel.x)},
          {"y", json_of(panel.y)},         {"colour", has_pixels(panel) ? json_of(panel.colour) : Json(nullptr)},
          {"texts", list_of(panel.texts)}, {"marks", std::move(marks)}};
}

}  // namespace

Plot laid_out(Plot plot) {
  std::vector<Panel>& panels = plot.panels;
  const std::size_t count = panels.size(),
                    columns = std::clamp<std::size_t>(plot.columns, 1, std::max<std::size_t>(1, count)),
                    rows = (count + columns - 1) / columns;
  for (Panel& panel : panels) {
    std::erase_if(panel.marks, [&](const Mark& mark) { return !has_something(plot, mark); });
    decide_ends(panel.x, plot, panel, 'x');
    decide_ends(panel.y, plot, panel, 'y');
  }
  // Axis labels shared by neighbours or by the whole figure appear once.
  const auto is_common = [&](Axis Panel::*axis) {
    return std::all_of(panels.begin(), panels.end(),
                       [&](const Panel& panel) { return label_of(panel.*axis) == label_of(panels.front().*axis); });
  };
  const bool one_x = columns > 1 && is_common(&Panel::x), one_y = columns > 1 && rows > 1 && is_common(&Panel::y);
  for (std::size_t i = 0; i < count; ++i) {
    Axis &x = panels[i].x, &y = panels[i].y;
    x.has_numbers = i + columns >= count || !is_same(x, panels[i + columns].x);
    y.has_numbers = i % columns == 0 || !is_same(y, panels[i - 1].y);
    if (x.has_numbers && !one_x) x.title.words = label_of(x);
    if (y.has_numbers && !one_y) y.title = {.words = label_of(y), .upright = true};
  }

  // Vertical layout.
  const auto each_in = [&](std::size_t row, auto use) {
    for (std::size_t i = row * columns; i < std::min((row + 1) * columns, count); ++i) use(panels[i]);
  };
  std::vector<double> above(rows), below(rows), share(rows);
  double free = plot.height, shares = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    above[row] = decide_keys(panels, row * columns, std::min((row + 1) * columns, count),
                             plot.width / static_cast<double>(columns), plot.width - figure_edge) +
                 (row == 0 ? figure_edge + 1 : joined_gap / 2);
    each_in(row, [&](const Panel& panel) {
      below[row] = std::max(below[row], numbers_below_of(panel.x) +
                                            (panel.x.title.words.empty() ? 0 : line_height + (row + 1 < rows ? 1 : 0)));
      share[row] = std::max(share[row], panel.share);
    });
    if (row + 1 == rows) below[row] += figure_edge + (one_x ? line_height : 0);
    free -= above[row] + below[row];
    shares += share[row];
  }
  double level = plot.height;
  for (std::size_t row = 0; row < rows; ++row) {
    const double height = free * share[row] / shares;
    level -= above[row] + height;
    each_in(row, [&](Panel& panel) {
      panel.bottom = level;
      panel.height = height;
      panel.key_top += level + height;
      decide_ticks(panel.y, height, closest_y);
      if (has_pixels(panel)) decide_ticks(panel.colour, height, closest_y);
    });
    level -= below[row];
  }

  // Horizontal layout.
  const double first_edge = figure_edge + (one_y ? line_height + 0.8 : 0);
  double after = 2.2 + figure_edge, width = plot.width;
  std::vector<double> before(columns, 0);  // left of a column
  for (std::size_t i = 0; i < count; ++i) {
    const Panel& panel = panels[i];
    const double numbers = widest_number(panel.y);
    before[i % columns] = std::max(before[i % columns], (i % columns == 0 ? first_edge
                                                         : numbers > 0    ? panel_gap
                                                                          : joined_gap) +
                                                            (panel.y.title.words.empty() ? 0 : line_height + 1.6) +
                                                            (numbers > 0 ? numbers + to_numbers : 0));
    if (has_pixels(panel))
      after = 2 * colour_bar + to_numbers + widest_number(panel.colour) + line_height + 2 * figure_edge;
  }
  for (const double space : before) width -= space;
  width = (width - after) / static_cast<double>(columns);
  double left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Panel& panel = panels[i];
    Axis& x = panel.x;
    left = (i % columns == 0 ? 0 : left + width) + before[i % columns];
    panel.left = left;
    panel.key_left += left;
    panel.width = width;
    decide_ticks(x, width, closest_x);
    if (x.names.empty() && widest_number(x) + 2 > closest_x) decide_ticks(x, width, widest_number(x) + 2);
    // Omits the last number if it would touch the first one of a close neighbour.
    const bool is_joined = i + 1 < count && (i + 1) % columns > 0 && !panels[i + 1].y.has_numbers;
    for (Tick& tick : x.ticks)
      if (is_joined && x.names.empty() && (x.to - tick.at) / (x.to - x.from) * width < text_width(tick.text))
        tick.text = "";

    const double middle = panel.bottom + panel.height / 2, top = panel.bottom + panel.height;
    x.title.x = left + width / 2;
    x.title.y = panel.bottom - numbers_below_of(x) - line_height / 2;
    panel.y.title.x = left - before[i % columns] + (i % columns == 0 ? first_edge : panel_gap) + line_height / 2;
    panel.y.title.y = middle;
    panel.colour.title = {
        .words = label_of(panel.colour), .x = plot.width - figure_edge - line_height / 2, .y = middle, .upright = true};
    const auto title = panel.title.empty() ? std::vector<std::string>{} : lines_in(panel.title);
    for (std::size_t k = 0; k < title.size(); ++k)
      panel.texts.push_back(
          {title[k], left, top + 0.7 + line_height * (static_cast<double>(title.size() - k) - 0.5), Text::left});
    for (const Mark& mark : panel.marks)
      if (mark.kind == Mark::label)
        for (Text& text : placed(mark, panel)) panel.texts.push_back(std::move(text));
    std::erase_if(panel.marks, [](const Mark& mark) { return mark.kind == Mark::label; });
    for (Mark& mark : panel.marks)
      for (std::size_t k = 0; k < mark.at.size(); ++k) {
        const Axis& axis = k % 2 == 0 ? panel.x : panel.y;
        if (std::isinf(mark.at[k])) mark.at[k] = mark.at[k] > 0 ? axis.to : axis.from;
      }
  }
  if (one_x)
    plot.texts.push_back(
        {label_of(panels.front().x), (panels.front().left + left + width) / 2, figure_edge + line_height / 2});
  if (one_y)
    plot.texts.push_back({label_of(panels.front().y), figure_edge + line_height / 2,
                          (panels.back().bottom + panels.front().bottom + panels.front().height) / 2, Text::centre,
                          true});
  return plot;
}

Plot in_width(Plot plot, double width) {
  constexpr double narrowest_panel = 36;  // [mm] with its numbers
  const auto rows_of = [&](std::size_t columns) {
    return static_cast<double>((plot.panels.size() + columns - 1) / std::max<std::size_t>(columns, 1));
  };
  plot.width = plot.width < two_columns ? std::min(plot.width, width) : width;
  const auto fitting = static_cast<std::size_t>(std::max(1.0, std::floor(plot.width / narrowest_panel)));
  if (plot.columns <= fitting) return plot;
  plot.height *= rows_of(fitting) / rows_of(plot.columns);
  plot.columns = fitting;
  return plot;
}

Json json_of(const Plot& laid) {
  Json panels = Json::array(), stops = Json::array();
  for (const auto& [at, colour] : palette) stops.push_back({at, colour});
  for (const Panel& panel : laid.panels) panels.push_back(json_of(panel, laid));
  return {{"name", laid.name},   {"title", laid.title},          {"caption", laid.caption},
          {"width", laid.width}, {"height", laid.height},        {"columns", laid.columns},
          {"palette", stops},    {"texts", list_of(laid.texts)}, {"panels", std::move(panels)}};
}

const PlotTable& table_of(const Plot& plot, std::string_view name) {
  const auto found =
      std::find_if(plot.data.begin(), plot.data.end(), [&](const PlotTable& table) { return table.name == name; });
  if (found == plot.data.end()) throw std::invalid_argument(fmt::format("{}: no table {}", plot.name, name));
  return *found;
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

std::string PlotUnit::column(std::string_view name) const {
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced, std::string_view reduced_unit) {
  if (reduced) return {std::string(reduced_unit), 1};
  const std::string_view unit = best_unit(magnitude, kind);
  return {typeset(unit), from_si(1, parse_unit(unit))};
}

PlotUnit PlotUnits::unit(double magnitude, double scale, const Kind& kind, std::string_view reduced_unit) const {
  PlotUnit unit = plot_unit(scale * magnitude, in_inches ? flexslip::in_inches(kind) : kind, reduced, reduced_unit);
  unit.factor *= scale;
  return unit;
}

}  // namespace flexslip
