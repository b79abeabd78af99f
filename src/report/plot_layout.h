// Where the parts of a figure stand: panels, ticks, labels and keys, for whoever draws it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "report/plot.h"

namespace flexslip {

struct NamedColour {
  const char *name, *hex;
};
inline constexpr std::array<NamedColour, 11> colours{{{"black", "#000000"},
                                                      {"dark", "#404040"},
                                                      {"grey", "#8C8C8C"},
                                                      {"silver", "#C4C4C4"},
                                                      {"white", "#FFFFFF"},
                                                      {"blue", "#0072B2"},
                                                      {"sky", "#56B4E9"},
                                                      {"green", "#009E73"},
                                                      {"orange", "#E69F00"},
                                                      {"vermillion", "#D55E00"},
                                                      {"brown", "#8C510A"}}};
inline const NamedColour& named(Colour colour) { return colours.at(static_cast<std::size_t>(colour)); }

// Of pixels, from the least value to the greatest.
struct PaletteStop {
  double at;
  const char* hex;
};
inline constexpr std::array<PaletteStop, 5> palette{
    {{0, "#FFFFFF"}, {0.005, "#EAF2F8"}, {0.3, "#9CC9E6"}, {0.65, "#2F83BE"}, {1, "#08306B"}}};

inline constexpr double font_size = 8;  // [pt] journals want at least 7 in print
inline constexpr double line_height = 3.4,
                        colour_bar = 3;  // [mm] the width of the bar, and what stands between it and the panel

struct Tick {
  double at;
  std::string text;  // "" of a small one
};

struct AxisLayout {
  double from, to;
  std::vector<Tick> ticks;
  bool has_numbers;   // none where a neighbour has them
  std::string label;  // with its unit; "" where a neighbour or the whole figure has it
};

struct Place {
  double x, y;  // [1] of the figure, from the left and from below
};

struct PanelLayout {
  Place lower, upper;  // its lower left and its upper right corner
  AxisLayout x, y, colour;
  Place x_label, y_label, colour_label, title;  // the middle of a label; the left end of the line that stands lowest
  std::size_t key_rows = 0;                     // 0: no key
  double key_width = 0;                         // [mm] of an entry
  Place key{};                                  // its lower left corner
};

struct PlotLayout {
  std::vector<PanelLayout> panels;
  std::string x, y;  // labels of all panels, or ""
  Place x_label, y_label;
};

// Domain:     tables and columns that exist; std::invalid_argument otherwise.
PlotLayout layout_of(const Plot& plot);

// The label of an axis with its unit.
std::string label_of(const Axis& axis);

// Has the mark something to draw, or to say in the key?
bool has_something(const Plot& plot, const Mark& mark);

// Is the row one of those that the mark draws?
bool is_drawn(const Mark& mark, const std::vector<double>& row);

// Markup: pieces of it, and text that has none.
struct TextPiece {
  enum Style { plain, italic, below, above } style;
  std::string text;
};
std::vector<TextPiece> text_pieces(const std::string& markup);
std::string as_it_is(const std::string& text);  // as markup

// A round distance of ticks: 1, 2 or 5 times a power of ten, at least the value given. Domain: value > 0.
double round_step(double value);

}  // namespace flexslip
