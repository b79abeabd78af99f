// The units in which the numbers of one answer are plotted: the one home of axes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "data/scales.h"
#include "io/quantity.h"
#include "report/plot.h"

namespace flexslip {

// A unit for people, and the factor to it from the numbers of the answer.
struct PlotUnit {
  std::string unit;  // "µm"; of reduced variables "L"
  double factor;

  double operator()(double value) const { return factor * value; }
  std::string column(std::string_view name) const;  // "force [mN]"
  // The label in markup; the ends in the numbers of the answer.
  Axis axis(std::string label, double from = as_the_data, double to = as_the_data) const;
};

// Of numbers that are in the units of the test already, SI or reduced; the unit that reads best for the magnitude.
PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced, std::string_view reduced_unit);

// Of numbers that are in reduced variables. Magnitudes likewise.
struct PlotUnits {
  Scales scales;
  bool reduced;
  bool in_inches = false;

  PlotUnit length(double magnitude) const { return unit(magnitude, scales.physical_length(1), kind::length, "L"); }
  PlotUnit force(double magnitude) const { return unit(magnitude, scales.physical_force(1), kind::force, "EI/L²"); }
  PlotUnit stiffness(double magnitude) const {
    return unit(magnitude, scales.physical_stiffness(1), kind::stiffness, "EI/L³");
  }
  // What has been slid over one support, of the length between both.
  PlotUnit slid() const { return length(0.02); }

 private:
  PlotUnit unit(double magnitude, double scale, const Kind& kind, std::string_view reduced_unit) const;
};
PlotUnits plot_units(const FittedTest& test);

// Labels that several figures have.
inline constexpr const char* deflection_label = "Deflection at midspan *w*_0";
inline constexpr const char* force_label = "Force *F*";
inline constexpr const char* slid_label = "Length slid over one support";
inline constexpr const char* friction_label = "Friction *μ*";

// A round number, 1 to 10 in halves times a power of ten, at least the value given: where an axis ends. Domain: value > 0.
double rounded_up(double value);

// The points of a line that can be told apart in a figure of this width and height [units of the rows], with those where it
// begins, breaks and ends.
std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& rows, double width, double height);

}  // namespace flexslip
