#include "report/surface_figure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "report/marks.h"
#include "report/plot_units.h"

namespace flexslip {
namespace {

// The greatest and the least of each of many stretches, so that a picture shows all extremes of a long column.
std::vector<std::vector<double>> extremes(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr std::size_t stretches = 1500;
  std::vector<std::vector<double>> rows;
  if (y.size() <= 2 * stretches) {
    for (std::size_t i = 0; i < y.size(); ++i) rows.push_back({x[i], y[i]});
    return rows;
  }
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t from = k * y.size() / stretches, to = (k + 1) * y.size() / stretches;
    const auto [low, high] =
        std::minmax_element(y.begin() + static_cast<std::ptrdiff_t>(from), y.begin() + static_cast<std::ptrdiff_t>(to));
    auto first = static_cast<std::size_t>(low - y.begin()), second = static_cast<std::size_t>(high - y.begin());
    if (second < first) std::swap(first, second);
    rows.push_back({x[first], y[first]});
    if (second != first) rows.push_back({x[second], y[second]});
  }
  return rows;
}

}  // namespace

Plot surface_figure(const SurfaceStudy& study) {
  const HeightTrace& trace = study.trace;
  const Texture& texture = study.texture;
  const auto [lowest, highest] = std::minmax_element(trace.height.begin(), trace.height.end());
  const PlotUnit along = plot_unit(0.1 * trace.width(), kind::length, false, "");
  const PlotUnit up = plot_unit(std::max(std::abs(*lowest), std::abs(*highest)), kind::length, false, "");

  std::vector<double> x, z, edge, middle;
  for (std::size_t i = 0; i < trace.height.size(); ++i) {
    x.push_back(along(trace.position(i)));
    middle.push_back(along(trace.position(i) + 0.5 * trace.step));
    z.push_back(up(trace.height[i]));
    edge.push_back(up(study.path[i]));
  }
  middle.pop_back();
  const bool is_rounded = study.options.edge_radius > 0;
  PlotTable heights{"heights", {along.column("position"), up.column("height")}, extremes(x, z)};
  PlotTable path{"edge", heights.titles}, friction{"friction", {heights.titles[0], "mu"}};
  if (is_rounded) path.rows = extremes(x, edge);
  if (study.friction) friction.rows = extremes(middle, study.friction->mu);

  const double to_density = up.factor * up.factor * along.factor;
  const std::string density_unit = fmt::format("{}² {}", up.unit, along.unit);
  PlotTable spectrum{
      "spectrum",
      {along.column("wavelength"), fmt::format("density [{}]", density_unit), "low", "high", "smooth part"}};
  const auto interval = density_interval(texture.spectrum.tapers);
  double most = 0, least = INFINITY, last = 0;
  for (std::size_t j = 1; j < texture.spectrum.density.size(); ++j) {
    const double f = texture.spectrum.frequency[j];
    if (f < 0.5 / trace.width() || (last > 0 && f < last * 1.002)) continue;  // finer than the picture
    last = f;
    const double there = to_density * texture.spectrum.density[j];
    most = std::max(most, there);
    least = std::min(least, there);
    spectrum.rows.push_back({along(1 / f), there, there * interval.low, there * interval.high,
                             to_density * texture.continuum.continuum(f)});
  }
  constexpr double decades_shown = 1e8;
  const double bottom = std::max(0.3 * least, most / decades_shown);
  PlotTable waves{"waves", {spectrum.titles[0], spectrum.titles[1]}};
  for (const DominantWave& wave : texture.waves)
    waves.rows.push_back({along(wave.wavelength.value),
                          to_density * texture.spectrum.density[texture.spectrum.at(1 / wave.wavelength.value)]});

  const Axis position{"Position along the surface *s*", along.unit, x.front(), x.back()};
  std::vector<Panel> panels{
      {.x = position,
       .y = {"Height *z*", up.unit},
       .marks = {marks::line("edge", {0, 1}, {Colour::orange, 2},
                             fmt::format("Path of an edge of {}", readable(study.options.edge_radius, kind::length))),
                 marks::line("heights", {0, 1}, {Colour::blue, 0.6}, "Heights, levelled")},
       .share = 1}};
  if (study.friction)
    panels.push_back({.x = position,
                      .y = {friction_label},
                      .marks = {marks::line("friction", {0, 1}, {Colour::green, 0.7}, "Friction shown on the slopes"),
                                marks::horizontal({*study.options.friction}, {.width = 0.8, .dash = Dash::dashed},
                                                  "Of the flat surface")},
                      .share = 0.9});
  const double floor = to_density * texture.continuum.continuum.noise;
  Panel densities{
      .x = {"Wavelength *λ*", along.unit, spectrum.rows.back()[0], spectrum.rows.front()[0], true},
      .y = {"Density", density_unit, bottom, 4 * most, true},
      .marks = {marks::rectangle({along(texture.shortest), along(texture.longest), -marks::edge, marks::edge},
                                 {.colour = Colour::grey, .opacity = 0.12}),
                marks::band("spectrum", {0, 2, 3}, {.colour = Colour::blue, .opacity = 0.22}, "95 %"),
                marks::line("spectrum", {0, 1}, {Colour::blue, 0.9}, "Spectrum"),
                marks::line("spectrum", {0, 4}, {.dash = Dash::dashed}, "Smooth part"),
                marks::points("waves", {0, 1}, {Colour::vermillion, 1.1, Dash::solid, Symbol::circle, 5}, "Waves")},
      .share = 1.7};
  if (floor > bottom)
    densities.marks.push_back(marks::horizontal({floor}, {.width = 0.75, .dash = Dash::dotted}, "Noise"));
  panels.push_back(std::move(densities));
  return {.name = "surface",
          .title = "A surface: " + study.file.source,
          .caption = fmt::format(
              "Heights along the surface, levelled{}{}. Below: their power spectral density with its 95 % interval; "
              "dashed: its smooth part; circles: "
              "the waves that stand out of it. The grey wavelengths are those that height and slope are stated for.",
              is_rounded ? " (blue), and the path of a rounded edge over them (orange)" : "",
              study.friction
                  ? "; the friction that a support shows as it climbs them, beside that of the flat surface (dashed)"
                  : ""),
          .width = two_columns,
          .height = study.friction ? 152.0 : 114.0,
          .data = {std::move(heights), std::move(path), std::move(friction), std::move(spectrum), std::move(waves)},
          .panels = std::move(panels)};
}

}  // namespace flexslip
