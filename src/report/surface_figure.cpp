#include "report/surface_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

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

std::string power_of_ten_tics(double low, double high) {
  const double decades = std::log10(high / low);
  return fmt::format("set ytics {:g}; set format y '10^{{%T}}'", std::pow(10, std::max(1.0, std::ceil(decades / 5))));
}

}  // namespace

Figure surface_figure(const SurfaceStudy& study) {
  const HeightTrace& trace = study.trace;
  const Texture& texture = study.texture;
  const PlotUnit along = plot_unit(0.1 * trace.width(), kind::length, false, "");
  const auto [lowest, highest] = std::minmax_element(trace.height.begin(), trace.height.end());
  const PlotUnit up = plot_unit(std::max(std::abs(*lowest), std::abs(*highest)), kind::length, false, "");
  const std::string position = fmt::format("position [{}]", along.unit), height = fmt::format("height [{}]", up.unit);

  std::vector<double> x, z, edge, middle;
  for (std::size_t i = 0; i < trace.height.size(); ++i) {
    x.push_back(along.factor * trace.position(i));
    middle.push_back(along.factor * (trace.position(i) + 0.5 * trace.step));
    z.push_back(up.factor * trace.height[i]);
    edge.push_back(up.factor * study.path[i]);
  }
  FigureData heights{"heights", {position, height}, extremes(x, z)};
  FigureData path{"edge", {position, height}, {}};
  const bool is_rounded = study.options.edge_radius > 0;
  if (is_rounded) path.rows = extremes(x, edge);
  if (!is_rounded) path.rows.push_back({NAN, NAN});

  FigureData friction{"friction", {position, "mu"}, {}};
  double mu_low = 0, mu_high = 0;
  if (study.friction) {
    middle.pop_back();
    friction.rows = extremes(middle, study.friction->mu);
    const auto [low, high] = std::minmax_element(study.friction->mu.begin(), study.friction->mu.end());
    mu_low = *low;
    mu_high = *high;
  } else {
    friction.rows.push_back({NAN, NAN});
  }

  const double to_density = up.factor * up.factor * along.factor;
  const std::string wavelength = fmt::format("wavelength [{}]", along.unit);
  const std::string density = fmt::format("density [{}² {}]", up.unit, along.unit);
  FigureData spectrum{"spectrum", {wavelength, density, "low", "high", "smooth part"}, {}};
  const auto interval = density_interval(texture.spectrum.tapers);
  double most = 0, least = 1e300, last = 0;
  for (std::size_t j = 1; j < texture.spectrum.density.size(); ++j) {
    const double f = texture.spectrum.frequency[j];
    if (f < 0.5 / trace.width() || (last > 0 && f < last * 1.002)) continue;  // finer than the picture
    last = f;
    const double there = to_density * texture.spectrum.density[j];
    most = std::max(most, there);
    least = std::min(least, there);
    spectrum.rows.push_back({along.factor / f, there, there * interval.low, there * interval.high,
                             to_density * texture.continuum.continuum(f)});
  }
  constexpr double decades_shown = 1e8;
  const double bottom = std::max(0.3 * least, most / decades_shown), top = 4 * most;
  FigureData waves{"waves", {wavelength, density}, {}};
  for (const DominantWave& wave : texture.waves)
    waves.rows.push_back({along.factor * wave.wavelength.value,
                          to_density * texture.spectrum.density[texture.spectrum.at(1 / wave.wavelength.value)]});
  if (waves.rows.empty()) waves.rows.push_back({NAN, NAN});
  const double floor = to_density * texture.continuum.continuum.noise;

  const bool shows_friction = study.friction.has_value();
  const double tall = shows_friction ? 150 : 112;
  const auto screen = [&](double from_top) { return 1 - from_top / tall; };
  const double reach = std::max(1e-300, *std::max_element(z.begin(), z.end()) - *std::min_element(z.begin(), z.end()));
  std::string script = fmt::format(
      R"(  set multiplot
  set lmargin at screen 0.105; set rmargin at screen 0.985
  set xrange [{x0:.8g}:{x1:.8g}]
  # The heights
  set tmargin at screen {top1:.4f}; set bmargin at screen {bottom1:.4f}
  set yrange [{z0:.6g}:{z1:.6g}]
  {no_label}
  set ylabel '{height}' offset 0.8
  set key at screen 0.545,0.995 center top vertical Left reverse maxrows 1 samplen 1.8 width -1
  plot edge using 1:2 with lines lw 2 lc rgb orange{edge_title}, \
       heights using 1:2 with lines lw 0.6 lc rgb blue title 'Heights, levelled'
)",
      fmt::arg("x0", x.front()), fmt::arg("x1", x.back()), fmt::arg("top1", screen(7)),
      fmt::arg("bottom1", screen(shows_friction ? 45 : 47)),
      fmt::arg("z0", *std::min_element(z.begin(), z.end()) - 0.08 * reach),
      fmt::arg("z1", *std::max_element(edge.begin(), edge.end()) + 0.08 * reach),
      fmt::arg("no_label", shows_friction
                               ? "set format x ''; unset xlabel"
                               : fmt::format("set xlabel '{}' offset 0,0.4",
                                             axis_label("Position along the surface", "{/:Italic s}", along))),
      fmt::arg("height", axis_label("Height", "{/:Italic z}", up)),
      fmt::arg("edge_title", is_rounded ? fmt::format(" title 'Path of an edge of {}'",
                                                      readable(study.options.edge_radius, kind::length))
                                        : " notitle"));
  if (shows_friction)
    script += fmt::format(
        R"(  # The friction that a support shows which climbs them
  set tmargin at screen {top:.4f}; set bmargin at screen {bottom:.4f}
  set yrange [{low:.6g}:{high:.6g}]
  set format x '%g'; set xlabel '{label}' offset 0,0.4
  set ylabel 'Friction {{/:Italic μ}}' offset 0.8
  set ytics {step:.6g}
  set key off
  plot friction using 1:2 with lines lw 0.7 lc rgb green notitle, {base:.6g} with lines lw 0.8 dt (8,5) lc rgb 'black' notitle
  set key on
)",
        fmt::arg("top", screen(49)), fmt::arg("bottom", screen(83)), fmt::arg("low", mu_low - 0.1 * (mu_high - mu_low)),
        fmt::arg("high", mu_high + 0.1 * (mu_high - mu_low)),
        fmt::arg("label", axis_label("Position along the surface", "{/:Italic s}", along)),
        fmt::arg("step", tick_within(0.4 * std::max(mu_high - mu_low, 1e-6))),
        fmt::arg("base", *study.options.friction));
  script += fmt::format(
      R"(  # The spectrum
  set tmargin at screen {top:.4f}; set bmargin at screen {bottom:.4f}
  set ytics auto; set logscale xy
  set xrange [{l0:.6g}:{l1:.6g}] noextend
  set yrange [{d0:.6g}:{d1:.6g}]
  {tics_y}
  set xtics ({tics}); set format x '%g'
  set xlabel '{wavelength}' offset 0,0.4
  set ylabel '{density}' offset 0.8
  set key at graph 0.015,0.97 left top vertical Left reverse maxrows 6 samplen 1.8
  # What height and slope are told of
  set object 1 rectangle from {band0:.6g}, graph 0 to {band1:.6g}, graph 1 behind fc rgb '#909090' fs transparent solid 0.10 noborder
  plot spectrum using 1:3:4 with filledcurves lc rgb blue fs transparent solid 0.22 noborder title '95 %', \
       spectrum using 1:2 with lines lw 0.9 lc rgb blue title 'Spectrum', \
       spectrum using 1:5 with lines lw 1 dt (8,5) lc rgb 'black' title 'Smooth part', \
       waves using 1:2 with points pt 6 ps 0.9 lw 1.1 lc rgb vermillion{waves_title}{floor}
  unset object 1; unset logscale; unset multiplot; set xtics auto; set ytics auto; set format '%g'
)",
      fmt::arg("top", screen(shows_friction ? 99 : 61)), fmt::arg("bottom", 11 / tall),
      fmt::arg("l0", spectrum.rows.back()[0]), fmt::arg("l1", spectrum.rows.front()[0]), fmt::arg("d0", bottom),
      fmt::arg("d1", top), fmt::arg("tics_y", power_of_ten_tics(bottom, top)),
      fmt::arg("tics",
               [&] {
                 std::string tics;
                 const double low = spectrum.rows.back()[0], high = spectrum.rows.front()[0];
                 for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::log10(high); ++decade)
                   for (const double digit : {1, 2, 5})
                     if (const double tic = digit * std::pow(10, decade); tic >= low && tic <= high)
                       tics += fmt::format("{}{:g}", tics.empty() ? "" : ",", tic);
                 return tics;
               }()),
      fmt::arg("wavelength", axis_label("Wavelength", "{/:Italic λ}", along)),
      fmt::arg("density", fmt::format("Density\u00a0({}²\u00a0{})", up.unit, along.unit)),
      fmt::arg("band0", along.factor * texture.shortest), fmt::arg("band1", along.factor * texture.longest),
      fmt::arg("waves_title", texture.waves.empty() ? " notitle" : " title 'Waves'"),
      fmt::arg("floor",
               floor > bottom
                   ? fmt::format(", \\\n       {:.6g} with lines lw 0.75 dt (2,3) lc rgb 'black' title 'Noise'", floor)
                   : std::string()));
  return {
      .name = "surface",
      .title = "A surface: " + study.file.source,
      .description = fmt::format(
          "Height against position along the surface, {} heights{}{}; below, the power spectral density against the "
          "wavelength with its 95 % interval, its smooth part and {} waves that stand out.",
          trace.height.size(), is_rounded ? ", with the path of a rounded edge" : "",
          shows_friction ? "; the friction that a support shows which climbs it" : "", texture.waves.size()),
      .width = two_columns,
      .height = tall,
      .data = {std::move(heights), std::move(path), std::move(friction), std::move(spectrum), std::move(waves)},
      .script = script};
}

}  // namespace flexslip
