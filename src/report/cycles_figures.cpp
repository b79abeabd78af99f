#include "report/cycles_figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "report/marks.h"
#include "report/plot_units.h"
#include "report/track_arrows.h"

namespace flexslip {
namespace {

constexpr std::size_t most_drawn_loops = 4;

// A share of the values lies below.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

bool has_loops(const FittedTest& test) {
  if (!test.cycles) return false;
  const CyclesStatus status = test.cycles->friction.status;
  return status == CyclesStatus::ok || status == CyclesStatus::no_mirror;
}

Plot loops_figure(const FittedTest& test) {
  const auto& cycles = *test.cycles;
  const Record& record = *test.measurement.cycles;
  const PlotUnits units = plot_units(test);
  const Scales& scales = units.scales;
  const double w_max = scales.reduced_length(*std::max_element(record.deflection.begin(), record.deflection.end()));
  const double F_max = scales.reduced_force(*std::max_element(record.force.begin(), record.force.end()));
  const PlotUnit w = units.length(w_max), F = units.force(F_max);
  const Axis x = w.axis(deflection_label, 0, 1.03 * w_max), y = F.axis(force_label, 0, 1.06 * F_max);
  const std::vector<std::string> titles{w.column("deflection"), F.column("force")};

  std::vector<std::vector<double>> rows;
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    rows.push_back({w(scales.reduced_length(record.deflection[i])), F(scales.reduced_force(record.force[i]))});
    spots.push_back({rows[i][0] / x.to, rows[i][1] / y.to});
  }
  PlotTable loading{"loading", titles}, unloading{"unloading", titles}, forward{"forward", titles};
  const std::vector<std::string> to_tip{titles[0], titles[1], w.column("tip at deflection"), F.column("tip at force")};
  PlotTable arrows_in{"arrows_in", to_tip}, arrows_out{"arrows_out", to_tip};
  std::vector<Arrow> placed;
  std::size_t loads = 0;
  for (const Leg& leg : cycles.friction.legs) {
    const bool is_loading = leg.direction == Direction::loading;
    loads += is_loading ? 1 : 0;
    const std::size_t first = leg.first > 0 ? leg.first - 1 : 0;  // the turning point belongs to both
    auto& data = is_loading ? loading : unloading;
    for (std::size_t i = first; i < leg.last; ++i) data.rows.push_back(rows[i]);
    data.rows.emplace_back();
    if (const auto arrow = arrow_on(spots, first, leg.last - 1, placed)) {
      placed.push_back(*arrow);
      (is_loading ? arrows_in : arrows_out)
          .rows.push_back({arrow->from.x * x.to, arrow->from.y * y.to, arrow->to.x * x.to, arrow->to.y * y.to});
    }
  }
  for (std::size_t i = 0; i < cycles.replay.force.size(); ++i) {
    const double force = cycles.replay.force[i];
    if (!std::isfinite(force)) {
      if (!forward.rows.empty() && !forward.rows.back().empty()) forward.rows.emplace_back();
      continue;
    }
    // At the stage position imposed, so that the load train gives the deflection that goes with this force.
    const double fall = scales.reduced_force(record.force[i]) - force;
    forward.rows.push_back(
        {w(scales.reduced_length(record.deflection[i]) + fall / test.analysis.rig.stiffness), F(force)});
  }
  return {.name = "loops",
          .title = "Loading and unloading: " + test.name,
          .caption =
              "Force against deflection at midspan, as measured in loading (blue) and unloading (red-orange), in the "
              "direction of the "
              "arrows. Black: one friction profile for all loops and both directions, run forward over the stage "
              "positions.",
          .width = two_columns,
          .height = 96,
          .data = {std::move(loading), std::move(unloading), std::move(forward), std::move(arrows_in),
                   std::move(arrows_out)},
          .panels = {{.x = x,
                      .y = y,
                      .marks = {marks::line("loading", {0, 1}, {Colour::blue, 1.8}, "Loading"),
                                marks::line("unloading", {0, 1}, {Colour::vermillion, 1.8}, "Unloading"),
                                marks::line("forward", {0, 1}, {Colour::black, 0.6}, "Profile, run forward"),
                                marks::arrows("arrows_in", {0, 1, 2, 3}, {Colour::blue, 1.4}),
                                marks::arrows("arrows_out", {0, 1, 2, 3}, {Colour::vermillion, 1.4})}}}};
}

Plot boxes_figure(const FittedTest& test) {
  const CyclicFriction& friction = test.cycles->friction;
  const PlotUnit unit = plot_units(test).slid();
  const auto slid = [&](double S) { return unit((S - 1) / 2); };
  const auto loop_of = [&](std::size_t leg) {
    return std::find_if(friction.loops.begin(), friction.loops.end(),
                        [&](const FrictionLoop& loop) { return loop.loading == leg || loop.unloading == leg; }) -
           friction.loops.begin();
  };
  PlotTable points{
      "points",
      {unit.column("slid over one support"), "q", "mu", "mu low", "mu high", "motion (0 in; 1 out; 2 stuck)", "loop"}};
  PlotTable path{"path", {points.titles[0], "q"}}, profile{"profile", {points.titles[0], "mu"}};
  std::vector<double> sizes;
  double x_max = 0;
  const CyclicPoint* before = nullptr;
  for (const CyclicPoint& point : friction.points) {
    const double x = slid(point.S), error = 1.96 * point.standard_error;  // 95 %
    const double mu = point.motion == LegMotion::in ? point.q : point.motion == LegMotion::out ? -point.q : NAN;
    const double motion = point.motion == LegMotion::in ? 0 : point.motion == LegMotion::out ? 1 : 2;
    points.rows.push_back(
        {x, point.q, mu, mu - error, mu + error, motion, static_cast<double>(loop_of(point.leg) + 1)});
    x_max = std::max(x_max, x);
    sizes.push_back(std::abs(point.q));
    if (before && loop_of(before->leg) != loop_of(point.leg)) path.rows.emplace_back();
    path.rows.push_back({x, point.q});
    before = &point;
  }
  for (std::size_t i = 0; i < friction.table.S.size(); ++i)
    profile.rows.push_back({slid(friction.table.S[i]), friction.table.mu[i]});
  // Bands are drawn along the length, loop by loop.
  PlotTable along{"bands", points.titles};
  along.rows = points.rows;
  std::stable_sort(along.rows.begin(), along.rows.end(), [](const auto& a, const auto& b) {
    return std::tuple(a[6], a[5], a[0]) < std::tuple(b[6], b[5], b[0]);
  });
  // What the noise throws far off where deflection begins would flatten all else.
  const double top = rounded_up(std::max(1.2 * quantile(sizes, 0.98), 1e-3));

  const Axis x{slid_label, unit.unit, 0, 1.02 * x_max};
  const auto dots = [](Colour colour) { return Style{colour, 0.5, Dash::solid, Symbol::disc, 1.4}; };
  const auto moving = [&](double motion, std::size_t column, Style style, std::string title) {
    return marks::only(marks::points("points", {0, column}, style, std::move(title)), {{5, motion}});
  };
  constexpr Style profile_look{.width = 0.9};
  std::vector<Panel> panels{
      {.x = x,
       .y = {"Mobilised friction *q*", "", -top, top},
       .marks = {marks::horizontal({0}, {.width = 0.75}), marks::line("path", {0, 1}, {Colour::silver, 0.4}),
                 moving(0, 1, dots(Colour::blue), "In: *q* = *μ*"),
                 moving(1, 1, dots(Colour::vermillion), "Out: *q* = −*μ*"),
                 moving(2, 1, {Colour::black, 0.7, Dash::solid, Symbol::circle, 2}, "Stuck"),
                 marks::key_fill({.colour = Colour::grey, .opacity = 0.3}, "95 %"),
                 marks::key_line(profile_look, "All loops")},
       .share = 1.7}};
  const std::size_t drawn = std::min(friction.loops.size(), most_drawn_loops);
  for (std::size_t i = 0; i < drawn; ++i) {
    const Condition loop{6, static_cast<double>(i + 1)};
    Panel panel{.x = x, .y = {friction_label, "", 0, top}, .marks = {}};
    for (const auto& [motion, colour] : {std::pair{0.0, Colour::blue}, std::pair{1.0, Colour::vermillion}})
      panel.marks.push_back(
          marks::only(marks::band("bands", {0, 3, 4}, {.colour = colour, .opacity = 0.2}), {{5, motion}, loop}));
    for (const auto& [motion, colour] : {std::pair{0.0, Colour::blue}, std::pair{1.0, Colour::vermillion}})
      panel.marks.push_back(marks::only(marks::points("points", {0, 2}, dots(colour)), {{5, motion}, loop}));
    panel.marks.push_back(marks::line("profile", {0, 1}, profile_look));
    if (friction.loops.size() > 1)
      panel.marks.push_back(marks::label(marks::edge, marks::edge, fmt::format("loop {}", i + 1)));
    panels.push_back(std::move(panel));
  }
  return {.name = "boxes",
          .title = "Friction in both directions: " + test.name,
          .caption = fmt::format("Top: mobilised friction against the length slid over one support; each loop is a "
                                 "box. The specimen slides in along its upper "
                                 "side (blue), sticks while the stage turns back (circles), and slides out along its "
                                 "lower side (red-orange). Below{}: friction of "
                                 "both directions at the same points of the specimen. Bands: 95 % intervals from "
                                 "noise, bending stiffness and contact; the last two "
                                 "move a whole band. Black: one profile for all loops. Points that noise throws beyond "
                                 "the axis are not shown.",
                                 friction.loops.size() > drawn ? fmt::format(", the first {} loops", drawn) : ""),
          .width = two_columns,
          .height = 64 + 31 * static_cast<double>(drawn),
          .data = {std::move(points), std::move(along), std::move(path), std::move(profile)},
          .panels = std::move(panels)};
}

}  // namespace flexslip
