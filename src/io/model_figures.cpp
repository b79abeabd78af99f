#include "io/model_figures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bending_test/equilibrium.h"
#include "fibre/elastica.h"

namespace flexslip {
namespace {

// From reduced variables to the units of the axes.
class Axes {
 public:
  Axes(const DrawnIn& units, double deepest, double strongest)
      : length_(plot_unit(units.scales.physical_length(deepest), kind::length, units.reduced, "L")),
        force_(plot_unit(units.scales.physical_force(strongest), kind::force, units.reduced, "EI/L²")),
        x_(units.scales.physical_length(length_.factor)),
        y_(units.scales.physical_force(force_.factor)) {}

  double x(double length) const { return x_ * length; }
  double y(double force) const { return y_ * force; }
  std::string deflection() const { return axis_label("Deflection", "{/:Italic w}_0", length_); }
  std::string length() const { return axis_label("Length", "{/:Italic S}", length_); }
  std::string force() const { return axis_label("Force", "{/:Italic F}", force_); }
  std::string title(std::string_view name) const {
    return fmt::format("{} [{}]", name, name == "force" ? force_.unit : length_.unit);
  }

 private:
  PlotUnit length_, force_;
  double x_, y_;
};

// Enough points for every wave and every knot of the friction.
int points_for(const Friction& friction, double S_max) {
  constexpr double most = 20000;
  const double waves = 16 * (S_max - 1) / friction.smooth_scale();
  return static_cast<int>(std::clamp(std::max(waves, 8.0 * static_cast<double>(friction.knots().size())), 300.0, most));
}

struct Extent {
  double w = 0, F = 0;
};

Extent extent_of(const std::vector<EquilibriumPoint>& points) {
  Extent extent;
  for (const auto& point : points) extent = {std::max(extent.w, point.w), std::max(extent.F, point.F)};
  return extent;
}

FigureData curve_data(std::string name, const std::vector<EquilibriumPoint>& points, const Axes& axes) {
  FigureData data{std::move(name), {axes.title("deflection"), axes.title("force"), axes.title("length")}, {}};
  for (const auto& point : points) data.rows.push_back({axes.x(point.w), axes.y(point.F), axes.x(point.S)});
  return data;
}

FigureData euler_bernoulli(double w_max, const Axes& axes) {
  return {"beam", {axes.title("deflection"), axes.title("force")}, {{0, 0}, {axes.x(w_max), axes.y(48 * w_max)}}};
}

FigureData sliding_curve(const Friction& friction, double S_max, const Axes& axes) {
  return curve_data("curve", equilibrium_curve(friction, Sliding::in, S_max, points_for(friction, S_max)).points, axes);
}

constexpr std::string_view one_panel =
    "  set lmargin at screen 0.145; set rmargin at screen 0.965; set tmargin at screen 0.845; set bmargin at screen "
    "0.165\n"
    "  set key at screen 0.555,0.985 center top vertical Left reverse maxrows 2\n";

}  // namespace

Figure region_figure(const Friction& friction, double S_max, const DrawnIn& units) {
  const int n = points_for(friction, S_max);
  const auto upper = equilibrium_curve(friction, Sliding::in, S_max, n).points;
  auto lower = equilibrium_curve(friction, Sliding::out, S_max, n).points;
  const auto extent = extent_of(upper);
  const Axes axes(units, extent.w, extent.F);

  auto boundary = upper;
  boundary.insert(boundary.end(), lower.rbegin(), lower.rend());
  // One length, at every friction it may have: seven tenths of the way into the figure.
  const double S = 1 + 0.7 * (upper.back().S - 1);
  const double mu = friction.at(S).mu;
  FigureData locus{"locus", {axes.title("deflection"), axes.title("force"), axes.title("length")}, {}};
  constexpr int levels = 60;
  for (int i = 0; i <= levels; ++i) {
    const FibreState state = fibre_state(S, mu * (2.0 * i / levels - 1));
    if (state.status == FibreStatus::ok) locus.rows.push_back({axes.x(state.w), axes.y(state.F), axes.x(state.S)});
  }
  // Arrows along the curve, in the direction of growing length.
  FigureData arrows{"arrows",
                    {axes.title("deflection"), axes.title("force"), "step " + axes.title("deflection"),
                     "step " + axes.title("force")},
                    {}};
  for (const double share : {0.15, 0.42, 0.72}) {
    const auto i = static_cast<std::size_t>(share * static_cast<double>(upper.size()));
    const auto& from = upper[i];
    const auto& to = upper[std::min(i + upper.size() / 12, upper.size() - 1)];
    const double lift = 0.13 * extent.F;
    arrows.rows.push_back({axes.x(from.w), axes.y(from.F + lift), axes.x(to.w - from.w), axes.y(to.F - from.F)});
  }

  const std::string panels = fmt::format(
      R"(  set multiplot
  set tmargin at screen 0.9; set bmargin at screen 0.2
  unset key
  set label 1 '(A)' at graph 0, 1.06 font ',9'
  set lmargin at screen 0.078; set rmargin at screen 0.325
  set xrange [0:*]; set yrange [0:{F_max:.6g}]
  set xlabel '{w}' offset 0,0.3; set ylabel '{F}' offset 1.2
  plot region using 1:2 with filledcurves closed lc rgb '#E2E2E2', curve using 1:2 with lines lw 1.3 lc rgb '#404040', \
       locus using 1:2 with lines lw 1 dt (6,4) lc rgb 'black', arrows using 1:2:3:4 with vectors lw 0.8 lc rgb 'black' filled size screen 0.012,20
  set label 1 '(B)'
  set lmargin at screen 0.41; set rmargin at screen 0.657
  set xrange [{S_min:.6g}:*]; set yrange [0:*]
  set xlabel '{S}'; set ylabel '{w}'
  plot region using 3:1 with filledcurves closed lc rgb '#E2E2E2', curve using 3:1 with lines lw 1.3 lc rgb '#404040'
  set label 1 '(C)'
  set lmargin at screen 0.738; set rmargin at screen 0.985
  set yrange [0:{F_max:.6g}]
  set ylabel '{F}'
  plot region using 3:2 with filledcurves closed lc rgb '#E2E2E2', curve using 3:2 with lines lw 1.3 lc rgb '#404040'
  unset multiplot; unset label 1
)",
      fmt::arg("F_max", axes.y(1.25 * extent.F)), fmt::arg("S_min", axes.x(1)), fmt::arg("w", axes.deflection()),
      fmt::arg("F", axes.force()), fmt::arg("S", axes.length()));
  return {.name = "region",
          .title = "The equilibria of the specimen",
          .description =
              "Three panels: force against deflection, deflection against length between the supports, force against "
              "length. "
              "The region of equilibria is grey; its upper edge, on which the specimen slides in, is a dark curve.",
          .width = two_columns,
          .height = 58,
          .data = {curve_data("region", boundary, axes), curve_data("curve", upper, axes), std::move(locus),
                   std::move(arrows)},
          .script = panels};
}

Figure equilibrium_figure(const Friction& friction, double S_max, const DrawnIn& units) {
  const int n = points_for(friction, S_max);
  const auto sliding = equilibrium_curve(friction, Sliding::in, S_max, n).points;
  const auto smooth = equilibrium_curve(Friction::constant(0), Sliding::in, S_max, n).points;
  const auto extent = extent_of(sliding);
  const Axes axes(units, extent.w, extent.F);
  const double w_max = std::max(extent.w, extent_of(smooth).w);
  const std::string script = fmt::format(
      R"({}  set xrange [0:{:.6g}]; set yrange [0:{:.6g}]
  set xlabel '{}' offset 0,0.4; set ylabel '{}' offset 0.8
  plot beam using 1:2 with lines lw 1 dt (14,7) lc rgb orange title 'Euler–Bernoulli', \
       frictionless using 1:2 with lines lw 1 lc rgb orange title 'No friction', \
       curve using 1:2 with lines lw 1.3 lc rgb '#404040' title 'Equilibrium curve'
)",
      one_panel, axes.x(1.03 * w_max), axes.y(1.3 * extent.F), axes.deflection(), axes.force());
  return {.name = "equilibrium",
          .title = "The equilibrium curve",
          .description =
              "Force against deflection along the equilibrium curve, with that of no friction and the Euler-Bernoulli "
              "line.",
          .width = one_column,
          .height = 66,
          .data = {euler_bernoulli(w_max, axes), curve_data("frictionless", smooth, axes),
                   curve_data("curve", sliding, axes)},
          .script = script};
}

Figure measured_figure(const Friction& friction, const History& history, const DrawnIn& units) {
  double S_max = 1.01;
  for (const auto& point : history.path) S_max = std::max(S_max, point.S);
  const auto extent = extent_of(equilibrium_curve(friction, Sliding::in, S_max, points_for(friction, S_max)).points);
  const Axes axes(units, extent.w, extent.F);
  FigureData measured{"measured", {axes.title("deflection"), axes.title("force")}, {}};
  FigureData snaps{"snaps", {axes.title("deflection"), axes.title("force")}, {}};
  for (const auto& point : history.path) {
    if (point.motion == Motion::snap) measured.rows.emplace_back();
    measured.rows.push_back({axes.x(point.w), axes.y(point.F)});
  }
  for (const auto& snap : history.snaps) {
    snaps.rows.push_back({axes.x(snap.before.w), axes.y(snap.before.F)});
    snaps.rows.push_back({axes.x(snap.after.w), axes.y(snap.after.F)});
    snaps.rows.emplace_back();
  }
  const bool snapped = !snaps.rows.empty();
  if (!snapped) snaps.rows.push_back({NAN, NAN});
  const std::string script = fmt::format(
      R"({}  set xrange [0:{:.6g}]; set yrange [0:{:.6g}]
  set xlabel '{}' offset 0,0.4; set ylabel '{}' offset 0.8
  plot curve using 1:2 with lines lw 1.6 lc rgb '#BDBDBD' title 'Equilibrium curve', \
       measured using 1:2 with lines lw 1.2 lc rgb 'black' title 'Measured curve', \
       snaps using 1:2 with lines lw 1 dt (8,5) lc rgb 'black'{}
)",
      one_panel, axes.x(1.03 * extent.w), axes.y(1.25 * extent.F), axes.deflection(), axes.force(),
      snapped ? " title 'Snaps'" : "");
  return {.name = "measured",
          .title = "What the test measures",
          .description = fmt::format("Force against deflection as measured, with {} snaps, over the equilibrium curve.",
                                     history.snaps.size()),
          .width = one_column,
          .height = 66,
          .data = {sliding_curve(friction, S_max, axes), std::move(measured), std::move(snaps)},
          .script = script};
}

Figure overall_equilibria_figure(const Friction& friction, const Rig& rig, std::span<const double> stages,
                                 const DrawnIn& units) {
  const double farthest = *std::max_element(stages.begin(), stages.end());
  const auto traced = trace_loading_curve(friction, rig, longest_at_stage(farthest));
  double S_max = 1.01;
  std::vector<std::vector<OverallEquilibrium>> at_stage;
  for (const double stage : stages) {
    at_stage.push_back(overall_equilibria(traced, stage));
    for (const auto& equilibrium : at_stage.back()) S_max = std::max(S_max, equilibrium.point.S);
  }
  S_max = std::min(1 + 1.1 * (S_max - 1), traced.end.S);
  const auto extent = extent_of(equilibrium_curve(friction, Sliding::in, S_max, points_for(friction, S_max)).points);
  const Axes axes(units, extent.w, extent.F);

  const std::vector<std::string> titles{axes.title("deflection"), axes.title("force")};
  FigureData lines{"lines", titles, {}};
  FigureData stable{"stable", titles, {}};
  FigureData partial{"partial", titles, {}};
  FigureData unstable{"unstable", titles, {}};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double top = 1.2 * extent.F;
    lines.rows.push_back({axes.x(stages[i] - top / rig.stiffness), axes.y(top)});
    lines.rows.push_back({axes.x(stages[i]), 0});
    lines.rows.emplace_back();
    for (const auto& [point, stability] : at_stage[i]) {
      auto& points = stability == Stability::stable ? stable : stability == Stability::unstable ? unstable : partial;
      points.rows.push_back({axes.x(point.w), axes.y(point.F)});
    }
  }
  std::string shown = "stable using 1:2 with points pt 7 ps 0.6 lc rgb 'black' title 'stable'";
  for (const auto& [data, type, name] :
       {std::tuple{&partial, 6, "partially stable"}, std::tuple{&unstable, 6, "unstable"}}) {
    if (data->rows.empty()) continue;
    shown += fmt::format(
        ", \\\n       {} using 1:2 with points pt 7 ps 0.6 lc rgb 'white', \\\n       {} using 1:2 with points pt {} "
        "ps 0.6 lw 0.8 lc rgb {} title '{}'",
        data->name, data->name, type, data == &partial ? "vermillion" : "'black'", name);
  }
  for (auto* data : {&stable, &partial, &unstable})
    if (data->rows.empty()) data->rows.push_back({NAN, NAN});
  const std::string script = fmt::format(
      R"({}  set xrange [0:{:.6g}]; set yrange [0:{:.6g}]
  set xlabel '{}' offset 0,0.4; set ylabel '{}' offset 0.8
  plot curve using 1:2 with lines lw 1.6 lc rgb '#BDBDBD' title 'Equilibrium curve', \
       lines using 1:2 with lines lw 0.8 dt (8,5) lc rgb grey title 'Load lines', \
       {}
)",
      one_panel, axes.x(1.03 * extent.w), axes.y(1.25 * extent.F), axes.deflection(), axes.force(), shown);
  return {.name = "equilibria",
          .title = "Overall equilibria",
          .description = fmt::format(
              "The overall equilibria at {} stage positions on the equilibrium curve, with the load lines of the rig.",
              stages.size()),
          .width = one_column,
          .height = 66,
          .data = {sliding_curve(friction, S_max, axes), std::move(lines), std::move(stable), std::move(partial),
                   std::move(unstable)},
          .script = script};
}

}  // namespace flexslip
