#include "report/cycles_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace flexslip {
namespace {

FigureData titled(std::string name, const std::vector<std::string>& titles) { return {std::move(name), titles, {}}; }

void require_rows(FigureData& data) {
  if (data.rows.empty()) data.rows.emplace_back(data.titles.size(), NAN);
}

// Of a leg, where its deflection passes a share of its greatest: its index, for an arrow.
std::size_t passing(const std::vector<double>& deflection, const Leg& leg, double share) {
  const auto first = deflection.begin() + static_cast<std::ptrdiff_t>(leg.first);
  const auto last = deflection.begin() + static_cast<std::ptrdiff_t>(leg.last);
  const double wanted = share * *std::max_element(first, last);
  const bool rises = leg.direction == Direction::loading;
  const auto at = std::find_if(first, last, [=](double w) { return rises ? w >= wanted : w <= wanted; });
  return static_cast<std::size_t>((at == last ? first : at) - deflection.begin());
}

// A share of the values lies below.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double tick_for(double range) {
  const double decade = std::pow(10, std::floor(std::log10(range / 3)));
  return (range / 3 >= 5 * decade ? 5 : range / 3 >= 2 * decade ? 2 : 1) * decade;
}

}  // namespace

bool has_loops(const FittedTest& test) {
  if (!test.cycles) return false;
  const CyclesStatus status = test.cycles->friction.status;
  return status == CyclesStatus::ok || status == CyclesStatus::no_mirror;
}

Figure loops_figure(const FittedTest& test) {
  const auto& cycles = *test.cycles;
  const auto& scales = test.analysis.scales;
  const Record& record = *test.measurement.cycles;
  const double w_max = *std::max_element(record.deflection.begin(), record.deflection.end());
  const double F_max = *std::max_element(record.force.begin(), record.force.end());
  const PlotUnit length = plot_unit(w_max, kind_in(test.measurement.test, kind::length), test.reduced, "L");
  const PlotUnit force = plot_unit(F_max, kind_in(test.measurement.test, kind::force), test.reduced, "EI/L^2");
  const std::vector<std::string> titles{fmt::format("deflection [{}]", length.unit),
                                        fmt::format("force [{}]", force.unit)};
  FigureData loading = titled("loading", titles), unloading = titled("unloading", titles),
             forward = titled("forward", titles);
  FigureData arrows = titled("arrows", {titles[0], titles[1], "to " + titles[0], "to " + titles[1], "unloading"});
  const auto plotted = [&](std::size_t i) {
    return std::vector<double>{length.factor * record.deflection[i], force.factor * record.force[i]};
  };
  std::size_t loads = 0;
  for (const Leg& leg : cycles.friction.legs) {
    const bool is_loading = leg.direction == Direction::loading;
    auto& data = is_loading ? loading : unloading;
    // The turning point belongs to both.
    for (std::size_t i = leg.first > 0 ? leg.first - 1 : 0; i < leg.last; ++i) data.rows.push_back(plotted(i));
    data.rows.emplace_back();
    // Arrows of several loops beside, not over one another.
    if (is_loading) ++loads;
    const double share = (is_loading ? 0.66 : 0.54) - 0.08 * static_cast<double>((loads + 2) % 3);
    const double beyond = is_loading ? 0.05 : -0.05;
    const auto from = plotted(passing(record.deflection, leg, share));
    const auto to = plotted(passing(record.deflection, leg, share + beyond));
    arrows.rows.push_back({from[0], from[1], to[0], to[1], is_loading ? 0.0 : 1.0});
  }
  for (std::size_t i = 0; i < cycles.replay.force.size(); ++i) {
    const double F = scales.physical_force(cycles.replay.force[i]);
    if (std::isfinite(F)) {
      // At the stage position imposed, so that the load train gives the deflection that goes with this force.
      const double w =
          record.deflection[i] - (F - record.force[i]) / scales.physical_stiffness(test.analysis.rig.stiffness);
      forward.rows.push_back({length.factor * w, force.factor * F});
    } else if (!forward.rows.empty() && !forward.rows.back().empty()) {
      forward.rows.emplace_back();
    }
  }
  const bool is_replayed = !forward.rows.empty();
  for (FigureData* data : {&loading, &unloading, &forward, &arrows}) require_rows(*data);
  const std::string script = fmt::format(
      R"(  set lmargin at screen 0.095; set rmargin at screen 0.985; set tmargin at screen 0.905; set bmargin at screen 0.135
  set xrange [0:{x_max:.6g}]
  set yrange [0:{y_max:.6g}]
  set xlabel '{length}' offset 0,0.4
  set ylabel '{force}' offset 0.8
  set key at screen 0.535,0.985 center top vertical Left reverse maxrows 1 samplen 2.2 width -6
  set style arrow 1 head filled size screen 0.016,16 lw 1.4 lc rgb blue
  set style arrow 2 head filled size screen 0.016,16 lw 1.4 lc rgb vermillion
  plot loading using 1:2 with lines lw 1.3 lc rgb blue title 'Loading', \
       unloading using 1:2 with lines lw 1.3 lc rgb vermillion title 'Unloading', \
       forward using 1:2 with lines lw 0.7 lc rgb 'black'{forward}, \
       arrows using 1:2:($3-$1):($5 == 0 ? $4-$2 : NaN) with vectors arrowstyle 1, \
       arrows using 1:2:($3-$1):($5 == 1 ? $4-$2 : NaN) with vectors arrowstyle 2
)",
      fmt::arg("x_max", length.factor * w_max * 1.03), fmt::arg("y_max", force.factor * F_max * 1.06),
      fmt::arg("force", axis_label("Force", "{/:Italic F}", force)),
      fmt::arg("length", axis_label("Deflection at midspan", "{/:Italic w}_0", length)),
      fmt::arg("forward", is_replayed ? " title 'Profile, run forward'" : ""));
  return {
      .name = "loops",
      .title = "Loading and unloading: " + test.name,
      .description = fmt::format("Measured force against deflection at midspan in {} loadings and the unloadings after "
                                 "them, and the force that one friction profile gives.",
                                 loads),
      .width = two_columns,
      .height = 100,
      .data = {std::move(loading), std::move(unloading), std::move(forward), std::move(arrows)},
      .script = script};
}

Figure boxes_figure(const FittedTest& test) {
  const CyclicFriction& friction = test.cycles->friction;
  const auto& scales = test.analysis.scales;
  const PlotUnit unit =
      plot_unit(0.02 * scales.span(), kind_in(test.measurement.test, kind::length), test.reduced, "L");
  const auto drawn_in = [&](double S) { return unit.factor * scales.physical_length(S - 1) / 2; };
  const std::string length = fmt::format("drawn in over one support [{}]", unit.unit);

  FigureData in = titled("in", {length, "q"}), out = titled("out", {length, "q"}),
             stuck = titled("stuck", {length, "q"});
  FigureData path = titled("path", {length, "q"});
  std::vector<double> sizes;
  double x_max = 0;
  const CyclicPoint* before = nullptr;
  const auto loop_of = [&](std::size_t leg) {
    return std::find_if(friction.loops.begin(), friction.loops.end(),
                        [&](const FrictionLoop& loop) { return loop.loading == leg || loop.unloading == leg; }) -
           friction.loops.begin();
  };
  for (const CyclicPoint& point : friction.points) {
    const double x = drawn_in(point.S);
    x_max = std::max(x_max, x);
    sizes.push_back(std::abs(point.q));
    (point.motion == LegMotion::in ? in : point.motion == LegMotion::out ? out : stuck).rows.push_back({x, point.q});
    if (before && loop_of(before->leg) != loop_of(point.leg)) path.rows.emplace_back();
    path.rows.push_back({x, point.q});
    before = &point;
  }
  // What the noise throws far off where deflection begins would flatten all else.
  const double top = rounded_up(std::max(1.2 * quantile(sizes, 0.98), 1e-3));

  const std::size_t panels = std::min(friction.loops.size(), most_drawn_loops);
  std::vector<FigureData> data;
  std::string plots;
  const double height = 62 + 32 * static_cast<double>(panels) + 12;
  const double box_top = 1 - 9 / height;
  const double box_bottom = 1 - 59 / height;
  const auto profile_of = [&](std::string name, const FrictionLoop& loop, LegMotion motion) {
    FigureData profile = titled(std::move(name), {length, "mu", "standard error"});
    for (const CyclicPoint& point : friction.points)
      if (point.motion == motion && (point.leg == loop.loading || point.leg == loop.unloading))
        profile.rows.push_back({drawn_in(point.S), motion == LegMotion::in ? point.q : -point.q, point.standard_error});
    std::stable_sort(profile.rows.begin(), profile.rows.end(),
                     [](const auto& a, const auto& b) { return a[0] < b[0]; });
    require_rows(profile);
    return profile;
  };
  for (std::size_t i = 0; i < panels; ++i) {
    const FrictionLoop& loop = friction.loops[i];
    const double panel_top = 1 - (62 + 32 * static_cast<double>(i)) / height;
    data.push_back(profile_of(fmt::format("in_{}", i + 1), loop, LegMotion::in));
    data.push_back(profile_of(fmt::format("out_{}", i + 1), loop, LegMotion::out));
    plots += fmt::format(
        R"(  set tmargin at screen {top:.4f}; set bmargin at screen {bottom:.4f}
  {x_axis}
  set label 1 '{name}' at graph 0.985, graph 0.86 right
  plot in_{n} using 1:($2-1.96*$3):($2+1.96*$3) with filledcurves lc rgb blue fs transparent solid 0.2 noborder, \
       out_{n} using 1:($2-1.96*$3):($2+1.96*$3) with filledcurves lc rgb vermillion fs transparent solid 0.2 noborder, \
       in_{n} using 1:2 with points pt 7 ps 0.22 lc rgb blue, \
       out_{n} using 1:2 with points pt 7 ps 0.22 lc rgb vermillion, \
       profile using 1:2 with lines lw 0.9 lc rgb 'black'
)",
        fmt::arg("top", panel_top), fmt::arg("bottom", panel_top - 29 / height), fmt::arg("n", i + 1),
        fmt::arg("name", friction.loops.size() == 1 ? std::string() : fmt::format("loop {}", i + 1)),
        fmt::arg("x_axis", i + 1 < panels
                               ? std::string("set format x ''; unset xlabel")
                               : fmt::format("set format x '%g'; set xlabel '{}' offset 0,0.4", drawn_in_label(unit))));
  }
  FigureData profile = titled("profile", {length, "mu"});
  for (std::size_t i = 0; i < friction.table.S.size(); ++i)
    profile.rows.push_back({drawn_in(friction.table.S[i]), friction.table.mu[i]});
  for (FigureData* each : {&in, &out, &stuck, &path, &profile}) {
    require_rows(*each);
    data.push_back(std::move(*each));
  }
  const std::string script = fmt::format(
      R"(  set multiplot
  set lmargin at screen 0.095; set rmargin at screen 0.985
  set xrange [0:{x_max:.6g}]
  # The boxes
  set tmargin at screen {box_top:.4f}; set bmargin at screen {box_bottom:.4f}
  set yrange [-{top:.6g}:{top:.6g}]
  set ytics {tick:.6g}
  set format x ''; unset xlabel
  set ylabel 'Mobilised friction {{/:Italic q}}' offset 0.8
  set key at screen 0.535,0.992 center top vertical Left reverse maxrows 1 samplen 1.8 width -2
  set xzeroaxis lw 0.75 lt 1 lc rgb 'black'
  plot path using 1:2 with lines lw 0.4 lc rgb '#b4b4b4', \
       in using 1:2 with points pt 7 ps 0.22 lc rgb blue title 'In: q = μ', \
       out using 1:2 with points pt 7 ps 0.22 lc rgb vermillion title 'Out: q = −μ', \
       stuck using 1:2 with points pt 6 ps 0.3 lw 0.7 lc rgb 'black' title 'Stuck', \
       keyentry with filledcurves lc rgb grey fs transparent solid 0.3 noborder title '95 %', \
       keyentry with lines lw 0.9 lc rgb 'black' title 'All loops'
  # Friction in both directions, loop by loop
  unset key; unset xzeroaxis
  set yrange [0:{top:.6g}]
  set ytics {panel_tick:.6g}
  set ylabel 'Friction {{/:Italic μ}}' offset 0.8
{plots}  unset multiplot; unset label 1; set ytics auto
)",
      fmt::arg("x_max", x_max * 1.02), fmt::arg("box_top", box_top), fmt::arg("box_bottom", box_bottom),
      fmt::arg("top", top), fmt::arg("tick", tick_for(2 * top)), fmt::arg("panel_tick", tick_for(top)),
      fmt::arg("plots", plots));
  return {
      .name = "boxes",
      .title = "Friction in both directions: " + test.name,
      .description = fmt::format("Mobilised friction against the length drawn in, a box for each of {} loops; below, "
                                 "friction in loading and in unloading on one axis, with 95 % bands.",
                                 friction.loops.size()),
      .width = two_columns,
      .height = height,
      .data = std::move(data),
      .script = script};
}

}  // namespace flexslip
