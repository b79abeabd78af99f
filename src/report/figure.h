// Figures for journals, drawn by gnuplot. Each is a script and its data as CSV, kept beside the pictures for restyling.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/quantity.h"

namespace flexslip {

// Data of a figure: rows of numbers; an empty row interrupts a line.
struct FigureData {
  std::string name;  // of its file: <figure>-<name>.csv
  std::vector<std::string> titles;
  std::vector<std::vector<double>> rows;
};

struct Figure {
  std::string name;         // of its files
  std::string title;        // what it shows
  std::string description;  // the same for those who cannot see it
  double width, height;     // [mm]
  std::vector<FigureData> data;
  std::string script{};  // gnuplot commands; reads data with `using`, in the file variable that is its name
};

inline constexpr double one_column = 85;    // [mm]
inline constexpr double two_columns = 170;  // [mm]

// What a quantity is plotted in: its unit for people and the factor from the units of the test.
struct PlotUnit {
  std::string unit;  // "µm"; for reduced variables "L"
  double factor;
};
PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced, std::string_view reduced_unit);

// "Force F (mN)" in gnuplot's markup, the symbol in italics.
std::string axis_label(std::string_view words, std::string_view symbol, const PlotUnit& unit);
std::string drawn_in_label(const PlotUnit& unit);  // of half of what is drawn in over both supports

enum class DrawStatus {
  drawn,
  no_gnuplot,  // script and data are written, pictures are not
};

// A round distance of ticks: 1, 2 or 5 times a power of ten, at most the value given. Domain: value > 0.
double tick_within(double value);

// A round number, 1 to 10 in halves times a power of ten, at least the value given: where an axis ends. Domain: value > 0.
double rounded_up(double value);

// Round values within a range, for gnuplot, which labels only the powers of ten of a logarithmic axis. Domain: a, b > 0.
std::string logarithmic_tics(double a, double b);

// The points of a line that can be told apart in a figure of this width and height [units of the rows], with those where it
// begins, breaks and ends.
std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& rows, double width, double height);

// Text as a word of a gnuplot script, in quotes.
std::string in_script(std::string_view text);

// Writes <folder>/<name>.gp and its data, and the pictures in the formats given: "svg", "pdf", "png".
// Fails:      no_gnuplot; InputError if a file cannot be written; std::runtime_error, with its words, if gnuplot refuses.
// Method:     the same figure gives the same bytes: the date in the PDF is set to SOURCE_DATE_EPOCH, or 1970.
DrawStatus draw(const Figure& figure, const std::string& folder, const std::vector<std::string>& formats);

// The same to one picture FILE.svg, FILE.pdf or FILE.png, script and data beside it under the same name.
// Fails:      also InputError for another ending.
DrawStatus draw(Figure figure, const std::string& picture);

}  // namespace flexslip
