// A figure as plain data: what is drawn where, how it looks and what it says. gnuplot draws it for reports (plot_script.h), matplotlib in
// Python (python/flexslip/_plots.py); margins, ticks and keys are made in one place for both (plot_layout.h).
//
// Labels and titles are in a small markup: *F* is in italics, _0 and _{ab} below the line, ^{-3} above it; a backslash takes the meaning of
// what follows.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

inline constexpr double one_column = 85;    // [mm] of a journal
inline constexpr double two_columns = 170;  // [mm]

// Rows of numbers; an empty row interrupts a line, and NaN is not drawn.
struct PlotTable {
  std::string name;                 // of its file: <plot>-<name>.csv
  std::vector<std::string> titles;  // each another
  std::vector<std::vector<double>> rows{};
};

// Colours that all can tell apart (Okabe and Ito), and greys.
enum class Colour { black, dark, grey, silver, white, blue, sky, green, orange, vermillion, brown };
enum class Dash { solid, dashed, long_dashed, dotted };
enum class Symbol { none, disc, circle, square, triangle, down, star, cross };  // a circle is white inside

struct Style {
  Colour colour = Colour::black;
  double width = 1;  // [pt] of a line
  Dash dash = Dash::solid;
  Symbol symbol = Symbol::none;
  double size = 1.5;   // [pt] of a symbol
  double opacity = 1;  // [1] of what is filled
};

// What a mark reads: the columns of its table; or, from `horizontal` on, the numbers that it has itself.
enum class MarkKind {
  line,        // x, y; with a symbol at each point, if its style has one
  points,      // x, y
  band,        // x, low, high: filled between them
  area,        // x, y: filled, the outline closed
  bars,        // x, low, high: an upright line a row
  spans,       // low, high, y: a level line a row
  arrows,      // x, y, x of the tip, y of the tip
  pixels,      // low x, high x, low y, high y, value: on the colour axis of the panel
  horizontal,  // y: a line across the panel
  vertical,    // x: likewise
  rectangle,   // low x, high x, low y, high y; infinite: the edge of the panel
  label,       // x, y: its title stands there; infinite: inside that edge of the panel, above y
  key_line,    // only an entry of the key, as the next two
  key_points,
  key_fill,
};

struct Condition {
  std::size_t column;
  double value;
};

struct Mark {
  MarkKind kind;
  std::string table;                 // of the plot's data
  std::vector<std::size_t> columns;  // of the table, as the kind says
  std::vector<double> at;            // or its own numbers
  Style style;
  std::string title;              // in the key, unless there is nothing to draw; none if empty
  std::vector<Condition> only{};  // rows that have these values
};

inline constexpr double as_the_data =
    std::numeric_limits<double>::quiet_NaN();  // an end of an axis: with a little space

struct Axis {
  std::string label;
  std::string unit{};  // "" of a plain number
  double from = as_the_data, to = as_the_data;
  bool logarithmic = false;  // both ends above 0
};

struct Panel {
  std::string title{};  // above it, at the left; lines apart by \n
  Axis x, y;
  std::vector<Mark> marks;  // from the back to the front, and from the first in the key to the last
  double share = 1;         // [1] of the height of the figure, beside that of the panels above and below
  Axis colour{};            // of pixels
};

// Panels stand in rows, from left to right. A key stands above the panel whose marks have titles, as wide as there is room. A neighbour with
// the same axis shares its numbers and its label.
struct Plot {
  std::string name;   // of its files
  std::string title;  // what it shows
  std::string
      caption;  // the same with what stands for what: read without the text around it, also by those who cannot see
  double width, height;  // [mm]
  std::vector<PlotTable> data;
  std::vector<Panel> panels;
  std::size_t columns = 1;  // of panels
};

// Domain: there is one of that name; std::invalid_argument otherwise.
const PlotTable& table_of(const Plot& plot, std::string_view name);

}  // namespace flexslip
