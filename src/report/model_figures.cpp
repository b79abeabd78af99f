#include "report/model_figures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bending_test/equilibrium.h"
#include "contact/over_rollers.h"
#include "report/track_arrows.h"

namespace flexslip {
namespace {

const Kind& shown_in(const DrawnIn& units, const Kind& kind) { return units.in_inches ? in_inches(kind) : kind; }

// From reduced variables to the units of the axes.
class Axes {
 public:
  Axes(const DrawnIn& units, double deepest, double strongest)
      : length_(plot_unit(units.scales.physical_length(deepest), shown_in(units, kind::length), units.reduced, "L")),
        force_(plot_unit(units.scales.physical_force(strongest), shown_in(units, kind::force), units.reduced, "EI/L²")),
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
int points_drawn_for(const Friction& friction, double S_max) {
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

FigureData sliding_curve(const Friction& friction, const Fibre& fibre, double S_max, const Axes& axes) {
  return curve_data(
      "curve", equilibrium_curve(friction, Sliding::in, S_max, points_drawn_for(friction, S_max), fibre).points, axes);
}

constexpr std::string_view one_panel =
    "  set lmargin at screen 0.145; set rmargin at screen 0.965; set tmargin at screen 0.845; set bmargin at screen "
    "0.165\n"
    "  set key at screen 0.555,0.985 center top vertical Left reverse maxrows 2\n";

}  // namespace

Figure region_figure(const Friction& friction, const Fibre& fibre, double S_max, const DrawnIn& units) {
  const int n = points_drawn_for(friction, S_max);
  const auto upper = equilibrium_curve(friction, Sliding::in, S_max, n, fibre).points;
  auto lower = equilibrium_curve(friction, Sliding::out, S_max, n, fibre).points;
  const auto extent = extent_of(upper);
  const Axes axes(units, extent.w, extent.F);

  auto boundary = upper;
  boundary.insert(boundary.end(), lower.rbegin(), lower.rend());
  // One length, at every friction it may have: seven tenths of the way into the figure.
  const double S = 1 + 0.7 * (upper.back().S - 1);
  const double most = met(friction, fibre, 1, S_max).at(S).mu, least = -met(friction, fibre, -1, S_max).at(S).mu;
  FigureData locus{"locus", {axes.title("deflection"), axes.title("force"), axes.title("length")}, {}};
  constexpr int levels = 60;
  for (int i = 0; i <= levels; ++i) {
    const FibreState state = fibre.state(S, least + (most - least) * i / levels);
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

Figure equilibrium_figure(const Friction& friction, const Fibre& fibre, double S_max, const DrawnIn& units) {
  const int n = points_drawn_for(friction, S_max);
  const auto sliding = equilibrium_curve(friction, Sliding::in, S_max, n, fibre).points;
  const auto smooth = equilibrium_curve(Friction::constant(0), Sliding::in, S_max, n, fibre).points;
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

namespace {

double longest_of(const History& history) {
  double S_max = 1.01;
  for (const auto& point : history.path) S_max = std::max(S_max, point.S);
  for (const auto& snap : history.snaps) S_max = std::max({S_max, snap.before.S, snap.after.S});
  return S_max;
}

// gnuplot refuses to plot data without a point.
void fill_if_empty(FigureData& data) {
  if (data.rows.empty()) data.rows.emplace_back(data.titles.size(), NAN);
}

// The pieces of a track that `belongs` chooses, thinned to what can be told apart in print.
template <typename Predicate>
FigureData pieces_of(std::string name, const std::vector<TrackPoint>& track, const Axes& axes, const Extent& extent,
                     Predicate belongs) {
  constexpr double finest = 0.002;  // of the figure: a sixth of a millimetre
  FigureData data{
      std::move(name), {axes.title("deflection"), axes.title("force"), axes.title("length"), "mobilised friction"}, {}};
  const auto add = [&](const TrackPoint& p) { data.rows.push_back({axes.x(p.w), axes.y(p.F), axes.x(p.S), p.q}); };
  const TrackPoint* kept = nullptr;
  for (std::size_t i = 1; i < track.size(); ++i) {
    if (!belongs(track[i])) continue;
    if (i == 1 || !belongs(track[i - 1])) {
      if (!data.rows.empty()) data.rows.emplace_back();
      add(track[i - 1]);
      kept = &track[i - 1];
    }
    const bool is_end = i + 1 == track.size() || !belongs(track[i + 1]);
    const double step = std::hypot((track[i].w - kept->w) / extent.w, (track[i].F - kept->F) / extent.F);
    if (!is_end && step < finest && std::abs(track[i].q - kept->q) < finest) continue;
    add(track[i]);
    kept = &track[i];
  }
  fill_if_empty(data);
  return data;
}

// Or a crack: what is too fast to be seen.
bool is_snap(const TrackPoint& point) { return point.motion == Motion::snap || point.motion == Motion::crack; }

std::string_view title_of_snaps(const History& history) { return history.cracks.empty() ? "Snaps" : "Cracks, snaps"; }

Figure loading_figure(const BendingTest& test, const History& history, std::span<const Leg> legs,
                      const DrawnIn& units) {
  const Fibre& fibre = test.rig.fibre;
  const double S_max = longest_of(history);
  const Friction& friction = test.friction.kinetic;
  auto extent =
      extent_of(equilibrium_curve(friction, Sliding::in, S_max, points_drawn_for(friction, S_max), fibre).points);
  const auto track = track_of(history, legs);
  for (const auto& point : track) extent = {std::max(extent.w, point.w), std::max(extent.F, point.F)};
  const Axes axes(units, extent.w, extent.F);
  const bool snapped = !history.snaps.empty() || !history.cracks.empty();
  const std::string script = fmt::format(
      R"({}  set xrange [0:{:.6g}]; set yrange [0:{:.6g}]
  set xlabel '{}' offset 0,0.4; set ylabel '{}' offset 0.8
  plot curve using 1:2 with lines lw 1.6 lc rgb '#BDBDBD' title '{}', \
       measured using 1:2 with lines lw 1.2 lc rgb 'black' title 'Measured curve', \
       snaps using 1:2 with lines lw 1 dt (8,5) lc rgb 'black'{}
)",
      one_panel, axes.x(1.03 * extent.w), axes.y(1.25 * extent.F), axes.deflection(), axes.force(),
      history.cracks.empty() ? "Equilibrium curve" : "Sound specimen",
      snapped ? fmt::format(" title '{}'", title_of_snaps(history)) : "");
  return {.name = "measured",
          .title = "What the test measures",
          .description = fmt::format(
              "Force against deflection as measured, with {} snaps{}, over the equilibrium curve.",
              history.snaps.size(), history.cracks.empty() ? "" : fmt::format(" and {} cracks", history.cracks.size())),
          .width = one_column,
          .height = 66,
          .data = {sliding_curve(friction, fibre, S_max, axes),
                   pieces_of("measured", track, axes, extent, [](const auto& point) { return !is_snap(point); }),
                   pieces_of("snaps", track, axes, extent, is_snap)},
          .script = script};
}

FigureData arrow_data(std::string name, const std::vector<Arrow>& arrows, const Panel& panel, double x_unit,
                      double y_unit) {
  FigureData data{std::move(name), {"x", "y", "step x", "step y"}, {}};
  const double x = panel.x * x_unit;
  const double y = panel.y * y_unit / panel.aspect;
  for (const auto& [from, to] : arrows)
    data.rows.push_back({x * from.x, y * from.y, x * (to.x - from.x), y * (to.y - from.y)});
  fill_if_empty(data);
  return data;
}

Figure loops_figure(const BendingTest& test, const History& history, std::span<const Leg> legs, const DrawnIn& units) {
  const Fibre& fibre = test.rig.fibre;
  const double S_max = longest_of(history);
  const Friction& friction = test.friction.kinetic;
  const auto track = track_of(history, legs);
  const int n = points_drawn_for(friction, S_max);
  auto upper = equilibrium_curve(friction, Sliding::in, S_max, n, fibre).points;
  auto lower = equilibrium_curve(friction, Sliding::out, S_max, n, fibre).points;
  if (friction.depends_on_way()) lower.clear();  // it depends on where the specimen turns back
  Extent extent = extent_of(upper);
  double q_least = 0;
  double q_most = 0;
  for (const auto& point : track) {
    extent = {std::max(extent.w, point.w), std::max(extent.F, point.F)};
    q_least = std::min(q_least, point.q);
    q_most = std::max(q_most, point.q);
  }
  const Axes axes(units, extent.w, extent.F);
  const double q_range = 1.3 * std::max({q_most, -q_least, 0.05});
  const double S_margin = 0.04 * (S_max - 1);
  const double F_range = 1.1 * extent.F;
  const double w_range = 1.04 * extent.w;
  constexpr double aspect = 0.84;  // of the panels below
  const Panel force_panel{w_range, F_range, aspect};
  const Panel friction_panel{S_max - 1 + 2 * S_margin, 2 * q_range, aspect};

  FigureData limits = curve_data("limits", upper, axes);
  limits.titles.emplace_back("friction");
  for (std::size_t i = 0; i < upper.size(); ++i) limits.rows[i].push_back(upper[i].q);
  limits.rows.emplace_back();
  for (const auto& point : lower) limits.rows.push_back({axes.x(point.w), axes.y(point.F), axes.x(point.S), point.q});
  const auto part = [&](const char* name, Direction direction, bool sticking) {
    return pieces_of(name, track, axes, extent, [=](const TrackPoint& point) {
      return !is_snap(point) && point.direction == direction && is_sticking(point) == sticking;
    });
  };
  const auto arrows = [&](const char* name, Projection projection, const Panel& panel, Direction direction) {
    const bool is_force = projection == in_force;
    return arrow_data(name, arrows_on(track, projection, panel, direction), panel, axes.x(1), is_force ? axes.y(1) : 1);
  };
  const auto panel_script = [&](std::string_view letter, std::string_view columns, std::string_view suffix) {
    return fmt::format(
        R"(  set label 1 '({0})' at graph 0.03, 0.945 font ',9'
  plot limits using {1} with lines lw 2.2 lc rgb '#CFCFCF', \
       snaps using {1} with lines lw 0.9 dt (7,4) lc rgb 'black', \
       sticking_in using {1} with lines lw 1 dt (3,2) lc rgb blue, \
       sticking_out using {1} with lines lw 1 dt (3,2) lc rgb vermillion, \
       loading using {1} with lines lw 1.5 lc rgb blue, \
       unloading using {1} with lines lw 1.5 lc rgb vermillion, \
       arrows_in_{2} using 1:2:3:4 with vectors lw 1 lc rgb blue filled size screen 0.013,22,90, \
       arrows_out_{2} using 1:2:3:4 with vectors lw 1 lc rgb vermillion filled size screen 0.013,22,90)",
        letter, columns, suffix);
  };
  const std::string script = fmt::format(
      R"(  set multiplot
  set tmargin at screen 0.91; set bmargin at screen 0.155
  set key at screen 0.53,0.99 center top vertical Left reverse maxrows 1 width 1 samplen 2
  set lmargin at screen 0.075; set rmargin at screen 0.48
  set xrange [0:{:.6g}]; set yrange [0:{:.6g}]
  set xlabel '{}' offset 0,0.4; set ylabel '{}' offset 1.2
{}, \
       keyentry with lines lw 1.5 lc rgb blue title 'Loading', \
       keyentry with lines lw 1.5 lc rgb vermillion title 'Unloading', \
       keyentry with lines lw 1 dt (3,2) lc rgb 'black' title 'Sticking', \
       {}keyentry with lines lw 2.2 lc rgb '#CFCFCF' title '{}'
  unset key
  set lmargin at screen 0.58; set rmargin at screen 0.985
  set xrange [{:.6g}:{:.6g}]; set yrange [{:.6g}:{:.6g}]; set xtics {:.6g}
  set xlabel '{}'; set ylabel 'Mobilised friction {{/:Italic q}}' offset 0.6
{}
  unset multiplot; unset label 1; set xtics auto
)",
      axes.x(w_range), axes.y(F_range), axes.deflection(), axes.force(), panel_script("A", "1:2", "force"),
      history.snaps.empty() && history.cracks.empty()
          ? ""
          : fmt::format("keyentry with lines lw 0.9 dt (7,4) lc rgb 'black' title '{}', ", title_of_snaps(history)),
      friction.depends_on_way() ? "q = μ" : "q = ±μ", axes.x(1 - S_margin), axes.x(S_max + S_margin), -q_range, q_range,
      tick_within(axes.x(0.3 * (S_max - 1))), axes.length(), panel_script("B", "3:4", "friction"));
  return {
      .name = "measured",
      .title = "What the test measures",
      .description = fmt::format(
          "Two panels: force against deflection, and mobilised friction against the length between the supports, in {} "
          "loading and unloading legs with {} snaps. Arrows show the direction.",
          legs.size(), history.snaps.size()),
      .width = two_columns,
      .height = 72,
      .data = {std::move(limits), pieces_of("snaps", track, axes, extent, is_snap),
               part("sticking_in", Direction::loading, true), part("sticking_out", Direction::unloading, true),
               part("loading", Direction::loading, false), part("unloading", Direction::unloading, false),
               arrows("arrows_in_force", in_force, force_panel, Direction::loading),
               arrows("arrows_out_force", in_force, force_panel, Direction::unloading),
               arrows("arrows_in_friction", in_friction, friction_panel, Direction::loading),
               arrows("arrows_out_friction", in_friction, friction_panel, Direction::unloading)},
      .script = script};
}

}  // namespace

Figure measured_figure(const BendingTest& test, const History& history, std::span<const Leg> legs,
                       const DrawnIn& units) {
  return legs.size() < 2 ? loading_figure(test, history, legs, units) : loops_figure(test, history, legs, units);
}

Figure overall_equilibria_figure(const Friction& friction, const Rig& rig, std::span<const double> stages,
                                 const DrawnIn& units) {
  const Fibre& fibre = rig.fibre;
  const double farthest = *std::max_element(stages.begin(), stages.end());
  const auto traced = trace_loading_curve(friction, rig, longest_at_stage(farthest));
  double S_max = 1.01;
  std::vector<std::vector<OverallEquilibrium>> at_stage;
  for (const double stage : stages) {
    at_stage.push_back(overall_equilibria(traced, stage));
    for (const auto& equilibrium : at_stage.back()) S_max = std::max(S_max, equilibrium.point.S);
  }
  S_max = std::min(1 + 1.1 * (S_max - 1), traced.end.S);
  const auto extent =
      extent_of(equilibrium_curve(friction, Sliding::in, S_max, points_drawn_for(friction, S_max), fibre).points);
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
          .data = {sliding_curve(friction, fibre, S_max, axes), std::move(lines), std::move(stable), std::move(partial),
                   std::move(unstable)},
          .script = script};
}

}  // namespace flexslip
