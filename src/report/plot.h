// A figure as plain data, drawn by gnuplot (draw.h) or matplotlib (python/flexslip/_plots.py).
// laid_out decides margins, ticks and keys once for both. Text is in a small markup: *F* is italic,
// _0 and _{ab} are subscripts, ^{-3} is a superscript; a backslash escapes the next character.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/scales.h"
#include "io/quantity.h"
#include "result/table.h"

namespace flexslip {

inline constexpr double one_column = 85;    // [mm] of a journal
inline constexpr double two_columns = 170;  // [mm]
inline constexpr double key_height = 3.6;   // [mm] of one row
inline constexpr double colour_bar = 3;     // [mm] its width, and the gap before it
inline constexpr double font_size = 8;      // [pt] journals want at least 7 in print

// Rows of numbers. An empty row interrupts a line; NaN is not drawn.
struct PlotTable {
  std::string name;                 // of the file <plot>-<name>.csv
  std::vector<std::string> titles;  // all different
  std::vector<std::vector<double>> rows{};
};

// Colours that colour-blind readers can distinguish (Okabe and Ito), and greys.
using Colour = const char*;
namespace colours {
inline constexpr Colour black = "#000000", dark = "#404040", grey = "#8C8C8C", silver = "#C4C4C4", white = "#FFFFFF";
inline constexpr Colour blue = "#0072B2", sky = "#56B4E9", green = "#009E73", orange = "#E69F00",
                        vermillion = "#D55E00", purple = "#CC79A7";
}  // namespace colours
// Colours of pixels from the minimum to the maximum.
inline constexpr std::array<std::pair<double, const char*>, 5> palette{
    {{0, "#FFFFFF"}, {0.005, "#EAF2F8"}, {0.3, "#9CC9E6"}, {0.65, "#2F83BE"}, {1, "#08306B"}}};

enum class Dash { solid, dashed, long_dashed, dotted };
enum class Symbol { none, disc, circle, square, triangle, down, star, cross };  // circle: white

struct Style {
  Colour colour = colours::black;
  double width = 1;  // [pt] of a line
  Dash dash = Dash::solid;
  Symbol symbol = Symbol::none;
  double size = 1.5;   // [pt] of a symbol
  double opacity = 1;  // [1] of filled areas
};

// The styles that all figures share.
namespace styles {
inline constexpr Style fill(Colour colour, double opacity) { return {.colour = colour, .opacity = opacity}; }
inline constexpr Style mark(Symbol symbol, Colour colour, double size, double width = 1) {
  return {colour, width, Dash::solid, symbol, size};
}
// below: a curve under others. Equal colours need different widths (dashes in gnuplot's SVG keys).
inline constexpr Style fit{colours::black, 1.6}, snap{colours::black, 1, Dash::dashed}, zero{colours::black, 0.75};
inline constexpr Style euler{colours::orange, 1, Dash::long_dashed}, frictionless{colours::orange, 1.2};
inline constexpr Style drop{colours::grey, 0.6, Dash::dashed}, below{colours::silver, 2};
inline constexpr Style loading{colours::blue, 1.4}, unloading{colours::vermillion, 1.4};
inline constexpr Style measured = mark(Symbol::disc, colours::blue, 1.7, 0.5), literature = fill(colours::green, 0.15);
inline constexpr Style suspect = mark(Symbol::cross, colours::vermillion, 4.5, 1.4);
}  // namespace styles

inline constexpr double edge = std::numeric_limits<double>::infinity();  // -edge: left or lower

struct Condition {
  std::size_t column;
  double value;
};

// Drawn from columns of a table or from its own numbers; without either, only an entry of the key.
struct Mark {
  enum Kind {
    line,    // x, y; with symbols if the style has one. Own numbers: x, y of both ends
    points,  // x, y
    area,    // x, y of a closed, filled outline. Own numbers: two opposite corners
    band,    // x, low, high: filled between them
    bars,    // x, low, high: one vertical line per row
    spans,   // low, high, y: one horizontal line per row
    arrows,  // x, y, x of the tip, y of the tip
    pixels,  // low x, high x, low y, high y, value: on the colour axis of the panel
    label,   // own numbers x, y: the title above y; at an edge, inside it
  };
  Kind kind = line;
  std::string table{};                 // of the plot's data
  std::vector<std::size_t> columns{};  // of the table
  Style style{};
  std::string title{};            // in the key; not shown if empty or if nothing is drawn
  std::vector<Condition> only{};  // draws only rows with these values
  std::vector<double> at{};       // own numbers; `edge` is allowed
};

// One line of text.
struct Text {
  enum Anchor { left, centre, right };
  std::string words{};  // in markup
  double x = 0, y = 0;  // [mm] of the anchor from the lower left of the figure, at half height
  Anchor anchor = centre;
  bool upright = false, boxed = false;
};

struct Tick {
  double at;
  std::string text;  // "" for a minor tick
};
inline constexpr double as_the_data = std::numeric_limits<double>::quiet_NaN();  // from the data

struct Axis {
  std::string label;
  std::string unit{};  // "" for a plain number
  double from = as_the_data, to = as_the_data;
  bool logarithmic = false, counts = false;  // both ends above 0; ticks at whole numbers only
  std::vector<Tick> names{};                 // replace the numbers along x; upright, thinned
  // Decided by laid_out:
  std::vector<Tick> ticks{};
  bool has_numbers = true;  // false if a neighbour shows them
  Text title{};             // label and unit; empty if a neighbour or the whole figure has them
};

struct Panel {
  std::string title{};  // above the panel, at the left; lines separated by \n
  Axis x, y;
  std::vector<Mark> marks{};  // from back to front, and from first to last in the key
  double share = 1;           // [1] height relative to the panels above and below
  Axis colour{};              // of pixels
  // Decided by laid_out, in [mm] of the figure:
  double left = 0, bottom = 0, width = 0, height = 0;
  double key_left = 0, key_top = 0, key_width = 0;  // key_width: of one entry, with its sample
  std::size_t key_rows = 0;                         // filled column by column; 0: no key
  std::vector<Text> texts{};                        // title and labels
};

// Panels in rows, from left to right. The key is above the panel whose marks have titles.
// Neighbours with the same axis share its numbers and label.
struct Plot {
  std::string name;      // of the files
  std::string title;     // the content, in a few words
  std::string caption;   // title with explanations: understandable without the surrounding text
  double width, height;  // [mm]
  std::vector<PlotTable> data{};
  std::vector<Panel> panels{};
  std::size_t columns = 1;    // of panels
  std::vector<Text> texts{};  // decided by laid_out: labels shared by all panels
};

// Decides ends, ticks, positions and keys; omits empty marks and turns labels into texts.
// Domain:     tables and columns that exist; std::invalid_argument otherwise.
Plot laid_out(Plot plot);

// The figure for a width [mm]: letters keep their size, and panels that would become too narrow move
// below each other. A narrower figure keeps its width. Domain: width >= min_figure_width.
inline constexpr double min_figure_width = 60, max_figure_width = 300;  // [mm]
Plot in_width(Plot plot, double width);

// The members above, without the data, for other programs that draw. Columns are given by title.
Json json_of(const Plot& laid);
const PlotTable& table_of(const Plot& plot, std::string_view name);  // throws std::invalid_argument
// Markup: its pieces, and text without markup.
struct TextPiece {
  enum Style { plain, italic, below, above } style;
  std::string text;
};
std::vector<TextPiece> text_pieces(const std::string& markup);
std::string as_it_is(const std::string& text);  // as markup

// A readable unit, and the factor from the unit of the answer.
struct PlotUnit {
  std::string unit;  // "µm"; in reduced variables "L"
  double factor;
  double operator()(double value) const { return factor * value; }
  std::string column(std::string_view name) const;  // "force [mN]"
  // The label is markup; the ends are in the unit of the answer.
  Axis axis(std::string label, double from = as_the_data, double to = as_the_data) const {
    return {std::move(label), unit, factor * from, factor * to};
  }
};

// The readable unit for numbers of this magnitude, both in the unit of the test (SI or reduced).
PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced = false, std::string_view reduced_unit = {});

// The readable units for numbers and magnitudes in reduced variables.
struct PlotUnits {
  Scales scales;
  bool reduced, in_inches = false;
  PlotUnit length(double magnitude) const { return unit(magnitude, scales.physical_length(1), kind::length, "L"); }
  PlotUnit force(double magnitude) const { return unit(magnitude, scales.physical_force(1), kind::force, "EI/L²"); }
  PlotUnit stiffness(double magnitude) const {
    return unit(magnitude, scales.physical_stiffness(1), kind::stiffness, "EI/L³");
  }
  PlotUnit unit(double magnitude, double scale, const Kind& kind, std::string_view reduced_unit) const;
};

}  // namespace flexslip
