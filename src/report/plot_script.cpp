#include "report/plot_script.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "data/names.h"
#include "report/document.h"
#include "report/plot_layout.h"

namespace flexslip {
namespace {

std::string gnuplot_style() {
  std::string out, stops;
  for (const NamedColour& colour : colours) out += fmt::format("{} = '{}'; ", colour.name, colour.hex);
  for (const PaletteStop& stop : palette)
    stops += fmt::format("{}{} '{}'", stops.empty() ? "" : ", ", stop.at, stop.hex);
  return out + "\nset palette defined (" + stops + ")" + R"(
set encoding utf8
set datafile separator comma
set datafile columnheaders
set border linewidth 0.75
set tics front in scale 0.6, 0.35
set style textbox opaque noborder margins 0.6, 0.6
)";
}

// Pixels, centimetres and the fonts of the terminals are made to agree, so that all three pictures look alike: `up` and `apart` set right where SVG
// puts the numbers below an axis and the rows of a key.
std::string terminals(const Plot& plot) {
  constexpr double mm_per_inch = 25.4, css_resolution = 96, scale = png_resolution / css_resolution;
  const auto pixels = [](double mm, double resolution) { return std::lround(mm / mm_per_inch * resolution); };
  return fmt::format(
      "  up = 0; apart = 1.15\n"
      "  if (format eq 'svg') {{ up = 0.2; apart = 0.85; set terminal svg size {},{} font 'Arial,{:.2f}' linewidth "
      "1.25 "
      "enhanced background 'white' }}\n"
      "  if (format eq 'pdf') {{ set terminal pdfcairo size {:.2f}cm,{:.2f}cm font 'Arial,{:g}' fontscale 0.75 "
      "linewidth 1.9 dashlength 1.6 enhanced }}\n"
      "  if (format eq 'png') {{ set terminal pngcairo size {},{} font 'Arial,{:g}' fontscale {:.3f} linewidth {:.2f} "
      "pointscale {:.2f} dashlength 1.6 enhanced background 'white' }}\n",
      pixels(plot.width, css_resolution), pixels(plot.height, css_resolution), font_size * css_resolution / 72,
      plot.width / 10, plot.height / 10, font_size, pixels(plot.width, png_resolution),
      pixels(plot.height, png_resolution), font_size, scale, 1.25 * scale, scale);
}

std::string_view dash_of(Dash dash) { return name_in_order<Dash::dotted>(dash, {"solid", "(6,4)", "(14,7)", "(2,3)"}); }

std::string_view point_type_of(Symbol symbol) {
  return name_in_order<Symbol::cross>(symbol, {"7", "7", "6", "5", "9", "11", "3", "2"});
}

// Markup as gnuplot's enhanced text.
std::string enhanced(const std::string& markup) {
  constexpr std::string_view meaningful = "\\{}^_@&~";
  const std::vector<TextPiece> pieces = text_pieces(markup);
  std::string out;
  for (const TextPiece& piece : pieces) {
    out += piece.style == TextPiece::italic  ? "{/:Italic "
           : piece.style == TextPiece::below ? "_{"
           : piece.style == TextPiece::above ? "^{"
                                             : "";
    const std::string_view text = piece.text;
    for (std::size_t i = 0; i < text.size(); ++i) {
      // SVG drops plain spaces beside a change of font.
      const bool is_beside =
          (i == 0 && &piece != &pieces.front()) || (i + 1 == text.size() && &piece != &pieces.back());
      if (meaningful.find(text[i]) != std::string_view::npos) out += '\\';
      out += text[i] == ' ' && is_beside ? std::string("\u00a0") : std::string(1, text[i]);
    }
    if (piece.style != TextPiece::plain) out += '}';
  }
  return out;
}

std::string quoted(const std::string& markup) { return in_script(enhanced(markup)); }

std::string line_look(const Style& style) {
  return fmt::format("lw {:g} dt {} lc rgb {}", style.width, dash_of(style.dash), named(style.colour).name);
}

std::string point_look(const Style& style, Symbol symbol, Colour colour) {
  constexpr double size_of_gnuplot = 6;  // [pt] at pointsize 1
  return fmt::format("pt {} ps {:.3g} lw {:g} lc rgb {}", point_type_of(symbol), style.size / size_of_gnuplot,
                     style.width, named(colour).name);
}

std::string fill_look(const Style& style) {
  return fmt::format("lc rgb {} fs {} noborder", named(style.colour).name,
                     style.opacity < 1 ? fmt::format("transparent solid {:g}", style.opacity) : "solid");
}

// How a mark is drawn: the columns of gnuplot's `using`, $N standing for the Nth, and what follows. Several, one over the other.
struct Layer {
  std::vector<std::string> columns;
  std::string with;
};

std::string lines_or_points(const Style& style) {
  if (style.symbol == Symbol::none) return "lines " + line_look(style);
  return fmt::format("linespoints dt {} {}", dash_of(style.dash), point_look(style, style.symbol, style.colour));
}

std::vector<Layer> layers_of(const Mark& mark, const std::vector<std::string>& c) {
  const Style& style = mark.style;
  const auto minus = [&](std::size_t a, std::size_t b) { return fmt::format("{}-{}", c[a], c[b]); };
  const auto middle = [&](std::size_t a, std::size_t b) { return fmt::format("({}+{})/2", c[a], c[b]); };
  switch (mark.kind) {
    case MarkKind::line:
    case MarkKind::horizontal:
    case MarkKind::vertical:
      return {{c, lines_or_points(style)}};
    case MarkKind::points: {
      const Layer shape{c, "points " + point_look(style, style.symbol, style.colour)};
      if (style.symbol != Symbol::circle) return {shape};
      return {{c, "points " + point_look(style, Symbol::disc, Colour::white)}, shape};
    }
    case MarkKind::band:
      return {{c, "filledcurves " + fill_look(style)}};
    case MarkKind::area:
    case MarkKind::rectangle:
      return {{c, "filledcurves closed " + fill_look(style)}};
    case MarkKind::bars:
      return {{{c[0], c[1], "0", minus(2, 1)}, "vectors nohead " + line_look(style)}};
    case MarkKind::spans:
      return {{{c[0], c[2], minus(1, 0), "0"}, "vectors nohead " + line_look(style)}};
    case MarkKind::arrows:
      return {{{c[0], c[1], minus(2, 0), minus(3, 1)}, "vectors head filled size screen 0.013,20 " + line_look(style)}};
    case MarkKind::pixels:
      return {
          {{middle(0, 1), middle(2, 3), c[0], c[1], c[2], c[3], c[4]}, "boxxyerror fs solid border lw 0.5 lc palette"}};
    default:
      return {};
  }
}

bool is_only_key(const Mark& mark) {
  return mark.kind == MarkKind::key_line || mark.kind == MarkKind::key_points || mark.kind == MarkKind::key_fill;
}

std::string key_entry(const Mark& mark) {
  const Style& style = mark.style;
  return fmt::format("keyentry with {} title {}",
                     mark.kind == MarkKind::key_fill     ? "filledcurves " + fill_look(style)
                     : mark.kind == MarkKind::key_points ? "points " + point_look(style, style.symbol, style.colour)
                                                         : lines_or_points(style),
                     quoted(mark.title));
}

// A mark that has its numbers itself is a block of the script: its outline.
bool is_own(const Mark& mark) {
  return mark.kind == MarkKind::horizontal || mark.kind == MarkKind::vertical || mark.kind == MarkKind::rectangle;
}

std::string block_name(std::size_t panel, std::size_t mark) { return fmt::format("$panel{}_{}", panel + 1, mark + 1); }

std::string block(const std::string& name, const Mark& mark, const PanelLayout& panel) {
  const auto within = [](double value, const AxisLayout& axis) { return std::clamp(value, axis.from, axis.to); };
  const bool is_level = mark.kind == MarkKind::horizontal, is_upright = mark.kind == MarkKind::vertical;
  const double left = is_level ? panel.x.from : is_upright ? mark.at.at(0) : within(mark.at.at(0), panel.x);
  const double right = is_level ? panel.x.to : is_upright ? left : within(mark.at.at(1), panel.x);
  const double bottom = is_upright ? panel.y.from : is_level ? mark.at.at(0) : within(mark.at.at(2), panel.y);
  const double top = is_upright ? panel.y.to : is_level ? bottom : within(mark.at.at(3), panel.y);
  std::string out = fmt::format("{} << EOD\nx,y\n{:.8g},{:.8g}\n", name, left, bottom);
  if (mark.kind == MarkKind::rectangle)
    out += fmt::format("{0:.8g},{1:.8g}\n{0:.8g},{2:.8g}\n{3:.8g},{2:.8g}\n", right, bottom, top, left);
  else
    out += fmt::format("{:.8g},{:.8g}\n", right, top);
  return out + "EOD\n";
}

std::string set_axis(std::string_view name, const Axis& axis, const AxisLayout& laid) {
  std::string ticks;
  for (const Tick& tick : laid.ticks)
    ticks += fmt::format("{}{} {:.8g}{}", ticks.empty() ? "" : ", ", quoted(laid.has_numbers ? tick.text : ""), tick.at,
                         tick.text.empty() ? " 1" : "");
  return fmt::format("  {}set logscale {}; set {}range [{:.8g}:{:.8g}] noextend\n  set {}tics ({}){}\n",
                     axis.logarithmic ? "" : "un", name, name, laid.from, laid.to, name, ticks,
                     name == "x" ? " offset 0,up" : "");
}

// None without words.
std::string set_label(const std::string& markup, const std::string& place, std::string_view how) {
  return markup.empty() ? "" : fmt::format("  set label {} at {} {}\n", quoted(markup), place, how);
}

std::string at_screen(const Place& place) { return fmt::format("screen {:.5f},{:.5f}", place.x, place.y); }

// A label a line: the distance of lines within one is another in each kind of picture.
std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const auto to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

std::string label_script(const Mark& mark, const PanelLayout& panel, const Plot& plot) {
  const double mm_x = 1 / plot.width / (panel.upper.x - panel.lower.x),
               mm_y = 1 / plot.height / (panel.upper.y - panel.lower.y);
  const double x = mark.at.at(0), y = mark.at.at(1);
  const bool at_side = std::isinf(x), at_end = std::isinf(y);
  const std::vector<std::string> lines = lines_in(mark.title);
  const auto last = static_cast<double>(lines.size() - 1);
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto k = static_cast<double>(i);
    // [mm] of the line from the place: below the upper edge, above the lower one and above a level, about a point.
    const double lift = line_height * (y > 0 && at_end     ? -k
                                       : at_end || at_side ? last - k
                                                           : last / 2 - k) +
                        (!at_end ? (at_side ? 1.9 : 0)
                         : y > 0 ? -2.4
                                 : 2.4);
    out += set_label(lines[i],
                     fmt::format("{}, {}",
                                 at_side ? fmt::format("graph {:.4f}", x < 0 ? 1.5 * mm_x : 1 - 1.5 * mm_x)
                                         : fmt::format("first {:.8g}", x),
                                 at_end ? (y < 0 ? "graph 0" : "graph 1") : fmt::format("first {:.8g}", y)),
                     fmt::format("{} front offset graph 0,{:.4f}",
                                 !at_side ? "center boxed"
                                 : x < 0  ? "left"
                                          : "right",
                                 lift * mm_y));
  }
  return out;
}

// gnuplot takes an entry of a key to be as wide as its longest title has characters, of another width in each terminal [mm]; `width` adds some.
std::string set_key(const Plot& plot, const Panel& panel, const PanelLayout& laid) {
  std::size_t longest = 0;
  for (const Mark& mark : panel.marks) {
    if (mark.kind == MarkKind::label || !has_something(plot, mark)) continue;
    std::size_t length = 0;
    for (const TextPiece& piece : text_pieces(mark.title)) length += width_of(piece.text);
    longest = std::max(longest, length);
  }
  const auto added = [&](double around, double character) {
    return (laid.key_width - around) / character - static_cast<double>(longest);
  };
  return fmt::format(
      "  set key at {} left bottom Left reverse vertical maxrows {} samplen 2.2 spacing apart noautotitle width format "
      "eq "
      "'svg' ? {:.2f} : {:.2f}\n",
      at_screen({laid.key.x - 1.2 / plot.width, laid.key.y}), laid.key_rows, added(10.4, 1.974), added(8.85, 1.796));
}

std::string plotted(const Mark& mark, const std::string& source) {
  std::vector<std::string> columns;
  for (const std::size_t column : is_own(mark) ? std::vector<std::size_t>{0, 1} : mark.columns)
    columns.push_back(fmt::format("${}", column + 1));
  std::string chosen, out;
  for (const Condition& condition : mark.only)
    chosen += fmt::format("{}${}=={:g}", chosen.empty() ? "" : " && ", condition.column + 1, condition.value);
  std::vector<Layer> layers = layers_of(mark, columns);
  for (Layer& layer : layers) {
    if (!chosen.empty()) layer.columns[0] = fmt::format("{} ? {} : NaN", chosen, layer.columns[0]);
    const bool has_title = &layer == &layers.back() && !mark.title.empty();
    out +=
        fmt::format("{}{} using ({}) with {} {}", out.empty() ? "" : ", \\\n       ", source,
                    fmt::join(layer.columns, "):("), layer.with, has_title ? "title " + quoted(mark.title) : "notitle");
  }
  return out;
}

std::string panel_script(const Plot& plot, const PlotLayout& layout, std::size_t i) {
  const Panel& panel = plot.panels[i];
  const PanelLayout& laid = layout.panels[i];
  std::string out = fmt::format(
      "  # Panel {}\n  set lmargin at screen {:.5f}; set rmargin at screen {:.5f}; set bmargin at screen {:.5f}; set "
      "tmargin at screen {:.5f}\n",
      i + 1, laid.lower.x, laid.upper.x, laid.lower.y, laid.upper.y);
  out += set_axis("x", panel.x, laid.x) + set_axis("y", panel.y, laid.y) + "  unset label\n";
  constexpr std::string_view upright = "center rotate by 90";
  out += set_label(laid.x.label, at_screen(laid.x_label), "center") +
         set_label(laid.y.label, at_screen(laid.y_label), upright);
  if (i == 0)
    out += set_label(layout.x, at_screen(layout.x_label), "center") +
           set_label(layout.y, at_screen(layout.y_label), upright);
  const std::vector<std::string> lines = lines_in(panel.title);
  for (std::size_t k = 0; k < lines.size(); ++k)
    out += set_label(
        lines[k],
        at_screen({laid.title.x, laid.title.y + line_height * static_cast<double>(lines.size() - 1 - k) / plot.height}),
        "left");
  if (!laid.colour.ticks.empty())
    out += set_axis("cb", panel.colour, laid.colour) +
           set_label(laid.colour.label, at_screen(laid.colour_label), upright) +
           fmt::format("  set colorbox user origin screen {:.5f},{:.5f} size screen {:.5f},{:.5f}\n",
                       laid.upper.x + colour_bar / plot.width, laid.lower.y, colour_bar / plot.width,
                       laid.upper.y - laid.lower.y);
  out += laid.key_rows == 0 ? "  unset key\n" : set_key(plot, panel, laid);
  std::string marks;
  for (std::size_t k = 0; k < panel.marks.size(); ++k) {
    const Mark& mark = panel.marks[k];
    if (mark.kind == MarkKind::label) out += label_script(mark, laid, plot);
    if (mark.kind == MarkKind::label || !has_something(plot, mark)) continue;
    marks += marks.empty() ? "  plot " : ", \\\n       ";
    marks += is_only_key(mark) ? key_entry(mark) : plotted(mark, is_own(mark) ? block_name(i, k) : mark.table);
  }
  return out + (marks.empty() ? "  plot NaN notitle" : marks) + "\n";
}

}  // namespace

std::string in_script(std::string_view text) {
  if (text.find('\'') == std::string_view::npos) return fmt::format("'{}'", text);
  // A doubled ' is misread between braces (gnuplot 5.4). Between " all that means something goes by its number.
  std::string out = "\"";
  for (const char c : text)
    out +=
        std::string_view("'\"\\`").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("\\{:03o}", c);
  return out + '"';
}

std::string script_of(const Plot& plot) {
  const PlotLayout layout = layout_of(plot);
  std::string tables, blocks, panels;
  for (const PlotTable& table : plot.data)
    tables += fmt::format("{} = {}\n", table.name, in_script(fmt::format("{}-{}.csv", plot.name, table.name)));
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    for (std::size_t k = 0; k < plot.panels[i].marks.size(); ++k)
      if (const Mark& mark = plot.panels[i].marks[k]; is_own(mark))
        blocks += block(block_name(i, k), mark, layout.panels[i]);
    panels += panel_script(plot, layout, i);
  }
  return fmt::format(
      "# gnuplot THIS_FILE draws the figure from the data beside it, as SVG, PDF and PNG; one of them only:\n"
      "# gnuplot -e \"formats='pdf'\" THIS_FILE\n"
      "if (!exists('formats')) formats = 'svg pdf png'\n"
      "if (!exists('folder')) folder = ''\n"
      "{}{}{}\ndo for [format in formats] {{\n{}  set output folder.{}.'.'.format\n  set multiplot\n{}  unset "
      "multiplot\n  unset output\n}}\n",
      tables, gnuplot_style(), blocks, terminals(plot), in_script(plot.name), panels);
}

}  // namespace flexslip
