// A figure as plain data: what is drawn where, how it looks and what it says. gnuplot draws it for reports (draw.h), matplotlib in Python
// (python/flexslip/_plots.py); margins, ticks and keys are decided once for both (laid_out).
//
// Words are in a small markup: *F* is in italics, _0 and _{ab} below the line, ^{-3} above it; a backslash takes the meaning of what follows.
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
inline constexpr double key_height = 3.6,
                        colour_bar = 3;  // [mm] of a row of a key; the bar's width, and what stands before it
inline constexpr double font_size = 8;   // [pt] journals want at least 7 in print

// Rows of numbers; an empty row interrupts a line, and NaN is not drawn.
struct PlotTable {
  std::string name;                 // of its file: <plot>-<name>.csv
  std::vector<std::string> titles;  // each another
  std::vector<std::vector<double>> rows{};
};

// Colours that all can tell apart (Okabe and Ito), and greys.
using Colour = const char*;
namespace colours {
inline constexpr Colour black = "#000000", dark = "#404040", grey = "#8C8C8C", silver = "#C4C4C4", white = "#FFFFFF";
inline constexpr Colour blue = "#0072B2", sky = "#56B4E9", green = "#009E73", orange = "#E69F00",
                        vermillion = "#D55E00";
}  // namespace colours
// Of pixels, from the least value to the greatest.
inline constexpr std::array<std::pair<double, const char*>, 5> palette{
    {{0, "#FFFFFF"}, {0.005, "#EAF2F8"}, {0.3, "#9CC9E6"}, {0.65, "#2F83BE"}, {1, "#08306B"}}};

enum class Dash { solid, dashed, long_dashed, dotted };
enum class Symbol { none, disc, circle, square, triangle, down, star, cross };  // a circle is white inside

struct Style {
  Colour colour = colours::black;
  double width = 1;  // [pt] of a line
  Dash dash = Dash::solid;
  Symbol symbol = Symbol::none;
  double size = 1.5;   // [pt] of a symbol
  double opacity = 1;  // [1] of what is filled
};

// What several figures show looks alike in all.
namespace styles {
inline constexpr Style fill(Colour colour, double opacity) { return {.colour = colour, .opacity = opacity}; }
inline constexpr Style mark(Symbol symbol, Colour colour, double size, double width = 1) {
  return {colour, width, Dash::solid, symbol, size};
}
// below: a curve on which others lie. Widths of one colour differ: gnuplot's SVG gives a key's dashes to the next of its colour and width.
inline constexpr Style fit{colours::black, 1.6}, snap{colours::black, 1, Dash::dashed}, zero{colours::black, 0.75};
inline constexpr Style euler{colours::orange, 1, Dash::long_dashed}, frictionless{colours::orange, 1.2};
inline constexpr Style drop{colours::grey, 0.6, Dash::dashed}, below{colours::silver, 2};
inline constexpr Style loading{colours::blue, 1.4}, unloading{colours::vermillion, 1.4};
inline constexpr Style measured = mark(Symbol::disc, colours::blue, 1.7, 0.5), literature = fill(colours::green, 0.15);
inline constexpr Style suspect = mark(Symbol::cross, colours::vermillion, 4.5, 1.4);
}  // namespace styles

inline constexpr double edge = std::numeric_limits<double>::infinity();  // of a panel; -edge: the left or the lower one

struct Condition {
  std::size_t column;
  double value;
};

// Drawn of columns of a table, or of its own numbers; what has neither is only an entry of the key.
struct Mark {
  enum Kind {
    line,    // x, y; with a symbol at each point, if its style has one. Its own numbers: x, y of both ends
    points,  // x, y
    area,    // x, y: filled, the outline closed. Its own numbers: two opposite corners
    band,    // x, low, high: filled between them
    bars,    // x, low, high: an upright line a row
    spans,   // low, high, y: a level line a row
    arrows,  // x, y, x of the tip, y of the tip
    pixels,  // low x, high x, low y, high y, value: on the colour axis of the panel
    label,   // its own numbers, x, y: its title stands there; at an edge of the panel inside it, above y
  };
  Kind kind = line;
  std::string table{};                 // of the plot's data
  std::vector<std::size_t> columns{};  // of the table
  Style style{};
  std::string title{};            // in the key; none if empty, or if there is nothing to draw
  std::vector<Condition> only{};  // rows that have these values
  std::vector<double> at{};       // its own numbers, each may be an edge
};

// A line of words.
struct Text {
  enum Anchor { left, centre, right };
  std::string words{};  // in markup
  double x = 0, y = 0;  // [mm] of the figure from its lower left: where the line is anchored, at half its height
  Anchor anchor = centre;
  bool upright = false, boxed = false;
};

struct Tick {
  double at;
  std::string text;  // "" of a small one
};

inline constexpr double as_the_data = std::numeric_limits<double>::quiet_NaN();  // an end: with a little space

struct Axis {
  std::string label;
  std::string unit{};  // "" of a plain number
  double from = as_the_data, to = as_the_data;
  bool logarithmic = false, counts = false;  // both ends above 0; ticks at whole numbers only
  std::vector<Tick> names{};  // along x, upright: they stand for its numbers, every so many where they are too close
  // Decided by laid_out:
  std::vector<Tick> ticks{};
  bool has_numbers = true;  // none where a neighbour has them
  Text title{};             // label and unit; no words where a neighbour or the whole figure has them
};

struct Panel {
  std::string title{};  // above it, at the left; lines apart by \n
  Axis x, y;
  std::vector<Mark> marks{};  // from the back to the front, and from the first in the key to the last
  double share = 1;           // [1] of the height of the figure, beside that of the panels above and below
  Axis colour{};              // of pixels
  // Decided by laid_out, in [mm] of the figure:
  double left = 0, bottom = 0, width = 0, height = 0;
  double key_left = 0, key_top = 0, key_width = 0;  // key_width: of an entry, with the sample before its words
  std::size_t key_rows = 0;                         // filled one column after the other; 0: no key
  std::vector<Text> texts{};                        // its title and its labels
};

// Panels stand in rows, from left to right. A key stands above the panel whose marks have titles, as wide as there is room. A neighbour with
// the same axis shares its numbers and its label.
struct Plot {
  std::string name;      // of its files
  std::string title;     // what it shows
  std::string caption;   // the same with what stands for what: read without the text around it, or aloud
  double width, height;  // [mm]
  std::vector<PlotTable> data{};
  std::vector<Panel> panels{};
  std::size_t columns = 1;    // of panels
  std::vector<Text> texts{};  // decided by laid_out: labels of all panels
};

// The same with the ends of axes, ticks, places and keys decided, and without marks that have nothing to draw. Labels among the marks are texts.
// Domain:     tables and columns that exist; std::invalid_argument otherwise.
Plot laid_out(Plot plot);

// The members above but for the data, which are long, for whoever else draws it. Columns have the titles of the table.
Json json_of(const Plot& laid);

const PlotTable& table_of(const Plot& plot, std::string_view name);  // std::invalid_argument if there is none

// Markup: pieces of it, and text that has none.
struct TextPiece {
  enum Style { plain, italic, below, above } style;
  std::string text;
};
std::vector<TextPiece> text_pieces(const std::string& markup);
std::string as_it_is(const std::string& text);  // as markup

// A unit for people, and the factor to it from the numbers of the answer.
struct PlotUnit {
  std::string unit;  // "µm"; of reduced variables "L"
  double factor;

  double operator()(double value) const { return factor * value; }
  std::string column(std::string_view name) const;  // "force [mN]"
  // The label in markup; the ends in the numbers of the answer.
  Axis axis(std::string label, double from = as_the_data, double to = as_the_data) const {
    return {std::move(label), unit, factor * from, factor * to};
  }
};

// Of numbers that are in the units of the test already, SI or reduced; the unit that reads best for the magnitude.
PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced = false, std::string_view reduced_unit = {});

// Of numbers that are in reduced variables. Magnitudes likewise.
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
