#include <fmt/format.h>

#include "numerics/elementary.h"
#include "report/figures.h"
#include "result/frame.h"

namespace flexslip {
namespace {

// The greatest and the least of each of many stretches, so that a picture shows all extremes of a long column.
std::vector<std::vector<double>> extremes(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr std::size_t stretches = 1500;
  std::vector<std::vector<double>> rows;
  const auto add = [&](std::size_t i) { rows.push_back({x[i], y[i]}); };
  const std::size_t count = y.size() <= 2 * stretches ? y.size() : stretches;
  for (std::size_t k = 0; k < count; ++k) {
    const auto begin = y.begin() + static_cast<std::ptrdiff_t>(k * y.size() / count),
               end = y.begin() + static_cast<std::ptrdiff_t>((k + 1) * y.size() / count);
    const auto [low, high] = std::minmax_element(begin, end);
    add(static_cast<std::size_t>(std::min(low, high) - y.begin()));
    if (low != high) add(static_cast<std::size_t>(std::max(low, high) - y.begin()));
  }
  return rows;
}

}  // namespace

Plot surface_figure(const SurfaceStudy& study) {
  const HeightTrace& trace = study.trace;
  const Texture& texture = study.texture;
  const auto [lowest, highest] = std::minmax_element(trace.height.begin(), trace.height.end());
  const PlotUnit along = plot_unit(0.1 * trace.width(), kind::length);
  const PlotUnit up = plot_unit(std::max(std::abs(*lowest), std::abs(*highest)), kind::length);

  std::vector<double> x, z, path, middle;
  for (std::size_t i = 0; i < trace.height.size(); ++i) {
    x.push_back(along(trace.position(i)));
    middle.push_back(along(trace.position(i) + 0.5 * trace.step));
    z.push_back(up(trace.height[i]));
    path.push_back(up(study.path[i]));
  }
  const bool is_rounded = study.options.edge_radius > 0;
  std::vector<PlotTable> data{{"heights", {along.column("position"), up.column("height")}, extremes(x, z)}};
  data.push_back({"edge", data[0].titles, {}});
  data.push_back({"friction", {data[0].titles[0], "mu"}, {}});
  if (is_rounded) data[1].rows = extremes(x, path);
  if (study.friction) data[2].rows = extremes(middle, study.friction->mu);

  const double to_density = up.factor * up.factor * along.factor;
  const std::string density_unit = fmt::format("{}² {}", up.unit, along.unit);
  PlotTable spectrum{
      "spectrum",
      {along.column("wavelength"), fmt::format("density [{}]", density_unit), "low", "high", "smooth part"}};
  const auto interval = density_interval(texture.spectrum.tapers);
  double most = 0, least = infinity, last = 0;
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
  const double bottom = std::max(0.3 * least, most / decades_shown),
               noise = to_density * texture.continuum.continuum.noise;
  PlotTable waves{"waves", {spectrum.titles[0], spectrum.titles[1]}};
  for (const DominantWave& wave : texture.waves)
    waves.rows.push_back({along(wave.wavelength.value),
                          to_density * texture.spectrum.density[texture.spectrum.at(1 / wave.wavelength.value)]});

  const Axis position{"Position along the surface *s*", along.unit, x.front(), x.back()};
  std::vector<Panel> panels{
      {.x = position,
       .y = {"Height *z*", up.unit},
       .marks = {{Mark::line,
                  "edge",
                  {0, 1},
                  {colours::orange, 2},
                  fmt::format("Path of an edge of {}", readable(study.options.edge_radius, kind::length))},
                 {Mark::line, "heights", {0, 1}, {colours::blue, 0.6}, "Heights, levelled"}}}};
  if (study.friction)
    panels.push_back(
        {.x = position,
         .y = {friction_label},
         .marks = {{Mark::line, "friction", {0, 1}, {colours::green, 0.7}, "Friction shown on the slopes"},
                   level(*study.options.friction, {.width = 0.8, .dash = Dash::dashed}, "Of the flat surface")},
         .share = 0.9});
  panels.push_back(
      {.x = {"Wavelength *λ*", along.unit, spectrum.rows.back()[0], spectrum.rows.front()[0], true},
       .y = {"Density", density_unit, bottom, 4 * most, true},
       .marks = {rectangle(along(texture.shortest), -edge, along(texture.longest), edge,
                           styles::fill(colours::grey, 0.12)),
                 {Mark::band, "spectrum", {0, 2, 3}, styles::fill(colours::blue, 0.22), "95 %"},
                 {Mark::line, "spectrum", {0, 1}, {colours::blue, 0.9}, "Spectrum"},
                 {Mark::line, "spectrum", {0, 4}, {.dash = Dash::dashed}, "Smooth part"},
                 {Mark::points, "waves", {0, 1}, styles::mark(Symbol::circle, colours::vermillion, 5, 1.1), "Waves"}},
       .share = 1.7});
  if (noise > bottom) panels.back().marks.push_back(level(noise, {.width = 0.75, .dash = Dash::dotted}, "Noise"));
  data.push_back(std::move(spectrum));
  data.push_back(std::move(waves));
  return {.name = "surface",
          .title = "A surface: " + study.file.source,
          .caption = fmt::format(
              "Heights along the surface, levelled{}{}. Below: their power spectral density with its 95 % interval; "
              "dashed: its smooth part; circles: the waves that stand out of it. The grey wavelengths are those that "
              "height and slope are stated for.",
              is_rounded ? " (blue), and the path of a rounded edge over them (orange)" : "",
              study.friction ? "; the friction that a support shows as it climbs them, beside that of the flat surface "
                               "(dashed)"
                             : ""),
          .width = two_columns,
          .height = study.friction ? 152.0 : 114.0,
          .data = std::move(data),
          .panels = std::move(panels)};
}

}  // namespace flexslip
