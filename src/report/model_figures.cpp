#include "report/model_figures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "report/marks.h"
#include "report/plot_units.h"
#include "report/track_arrows.h"

namespace flexslip {
namespace {

constexpr const char* w_label = "Deflection *w*_0";
constexpr const char* S_label = "Length *S*";

constexpr Style curve_look{.colour = Colour::dark, .width = 1.3};

struct Extent {
  double w = 0, F = 0;
};

template <class Points>
Extent extended(Extent extent, const Points& points) {
  for (const auto& point : points) extent = {std::max(extent.w, point.w), std::max(extent.F, point.F)};
  return extent;
}

// The units and the tables of one model.
struct Drawing {
  PlotUnit length, force;
  Extent extent;

  Drawing(const PlotUnits& units, const Extent& largest)
      : length(units.length(largest.w)), force(units.force(largest.F)), extent(largest) {}

  PlotTable table(std::string name) const {
    return {std::move(name),
            {length.column("deflection"), force.column("force"), length.column("length"), "mobilised friction"}};
  }
  PlotTable curve(std::string name, const std::vector<EquilibriumPoint>& points) const {
    PlotTable data = table(std::move(name));
    for (const auto& p : points) data.rows.push_back({length(p.w), force(p.F), length(p.S), p.q});
    return data;
  }
  Axis w(double to) const { return length.axis(w_label, 0, to); }
  Axis F(double to) const { return force.axis(force_label, 0, to); }
};

std::vector<Mark> of_columns(std::vector<Mark> marks, std::size_t x, std::size_t y) {
  for (Mark& each : marks) {
    each.columns = {x, y};
    each.title.clear();
  }
  return marks;
}

Plot region_figure(const EquilibriumStudy& study) {
  EquilibriumPortrait portrait = portrait_of(study);
  const Extent extent = extended({}, portrait.in);
  const Drawing drawing({study.scales, study.reduced, study.in_inches}, extent);
  std::vector<EquilibriumPoint> boundary = portrait.in;
  boundary.insert(boundary.end(), portrait.out.rbegin(), portrait.out.rend());
  // Arrows beside the curve, in the direction of growing length.
  PlotTable arrows{"arrows",
                   {drawing.length.column("deflection"), drawing.force.column("force"),
                    drawing.length.column("tip at deflection"), drawing.force.column("tip at force")}};
  const std::size_t n = portrait.in.size();
  for (const double share : {0.15, 0.42, 0.72}) {
    const auto i = static_cast<std::size_t>(share * static_cast<double>(n));
    const auto &from = portrait.in[i], &to = portrait.in[std::min(i + n / 12, n - 1)];
    const double lift = 0.1 * extent.F;
    arrows.rows.push_back(
        {drawing.length(from.w), drawing.force(from.F + lift), drawing.length(to.w), drawing.force(to.F + lift)});
  }
  const std::vector<Mark> marks{marks::area("region", {}, {.colour = Colour::silver, .opacity = 0.5}),
                                marks::line("curve", {}, curve_look)};
  std::vector<Mark> first = of_columns(marks, 0, 1);
  first.push_back(marks::line("locus", {0, 1}, {.dash = Dash::dashed}));
  first.push_back(marks::arrows("arrows", {0, 1, 2, 3}, {.width = 0.8}));
  const Axis S = drawing.length.axis(S_label, 1);
  return {.name = "region",
          .title = "The equilibria of the specimen",
          .caption =
              "All equilibria of the specimen: (A) force against deflection, (B) deflection and (C) force against the "
              "length between the "
              "supports. Grey: the region of equilibria. Dark: its upper edge, on which the specimen slides in, in the "
              "direction of the "
              "arrows. Dashed: one length with every friction that it may have.",
          .width = two_columns,
          .height = 56,
          .data = {drawing.curve("region", boundary), drawing.curve("curve", portrait.in),
                   drawing.curve("locus", portrait.at_one_length), std::move(arrows)},
          .panels = {{.title = "A",
                      .x = drawing.length.axis(w_label, 0),
                      .y = drawing.F(1.25 * extent.F),
                      .marks = std::move(first)},
                     {.title = "B", .x = S, .y = drawing.length.axis(w_label, 0), .marks = of_columns(marks, 2, 0)},
                     {.title = "C", .x = S, .y = drawing.F(1.25 * extent.F), .marks = of_columns(marks, 2, 1)}},
          .columns = 3};
}

Plot curve_figure(const EquilibriumStudy& study) {
  const EquilibriumPortrait portrait = portrait_of(study);
  const Extent extent = extended({}, portrait.in);
  const double w_max = std::max(extent.w, extended({}, portrait.frictionless).w);
  const Drawing drawing({study.scales, study.reduced, study.in_inches}, extent);
  PlotTable beam = drawing.table("beam");
  beam.rows = {{0, 0, NAN, NAN}, {drawing.length(w_max), drawing.force(48 * w_max), NAN, NAN}};
  return {
      .name = "equilibrium",
      .title = "The equilibrium curve",
      .caption =
          "Force against deflection while the specimen slides in (dark), without friction (orange) and by "
          "Euler–Bernoulli "
          "(orange, dashed).",
      .width = one_column,
      .height = 64,
      .data = {std::move(beam), drawing.curve("frictionless", portrait.frictionless),
               drawing.curve("curve", portrait.in)},
      .panels = {{.x = drawing.w(1.03 * w_max),
                  .y = drawing.F(1.3 * extent.F),
                  .marks = {marks::line("curve", {0, 1}, curve_look, "Equilibrium curve"),
                            marks::line("frictionless", {0, 1}, {Colour::orange}, "No friction"),
                            marks::line("beam", {0, 1}, {Colour::orange, 1, Dash::long_dashed}, "Euler–Bernoulli")}}}};
}

// What a test goes through, point by point, and in which direction the stage moved.
struct TrackPoint {
  PathPoint at;
  Direction direction;
};

std::vector<TrackPoint> track_of(const SimulatedPortrait& portrait) {
  std::vector<TrackPoint> track;
  for (const Leg& leg : portrait.legs)
    for (std::size_t i = leg.first; i < leg.last; ++i) track.push_back({portrait.history.path[i], leg.direction});
  return track;
}

// Or a crack: what is too fast to be seen.
bool is_snap(const TrackPoint& point) { return point.at.motion == Motion::snap || point.at.motion == Motion::crack; }
bool is_sticking(const TrackPoint& point) { return point.at.motion == Motion::stick; }

// The pieces of a track that `belongs` chooses, thinned to what can be told apart in print.
template <typename Predicate>
PlotTable pieces_of(std::string name, const std::vector<TrackPoint>& track, const Drawing& drawing, Predicate belongs) {
  constexpr double finest = 0.002;  // of the figure: a sixth of a millimetre
  PlotTable data = drawing.table(std::move(name));
  const auto add = [&](const PathPoint& p) {
    data.rows.push_back({drawing.length(p.w), drawing.force(p.F), drawing.length(p.S), p.q});
  };
  const PathPoint* kept = nullptr;
  for (std::size_t i = 1; i < track.size(); ++i) {
    if (!belongs(track[i])) continue;
    const PathPoint& here = track[i].at;
    if (i == 1 || !belongs(track[i - 1])) {
      if (!data.rows.empty()) data.rows.emplace_back();
      add(track[i - 1].at);
      kept = &track[i - 1].at;
    }
    const bool is_end = i + 1 == track.size() || !belongs(track[i + 1]);
    const double step = std::hypot((here.w - kept->w) / drawing.extent.w, (here.F - kept->F) / drawing.extent.F);
    if (!is_end && step < finest && std::abs(here.q - kept->q) < finest) continue;
    add(here);
    kept = &here;
  }
  return data;
}

std::string_view title_of_snaps(const History& history) { return history.cracks.empty() ? "Snaps" : "Cracks, snaps"; }

Plot loading_figure(const SimulatedPortrait& portrait, const PlotUnits& units) {
  const History& history = portrait.history;
  const auto track = track_of(portrait);
  const Drawing drawing(units, extended(extended({}, portrait.limits.in), history.path));
  const std::string snaps(title_of_snaps(history));
  return {
      .name = "measured",
      .title = "What the test measures",
      .caption = fmt::format(
          "Force against deflection as the test measures it (black; {} dashed), over the curve on which the {}specimen "
          "slides in (grey).",
          history.cracks.empty() ? "snaps" : "cracks and snaps", history.cracks.empty() ? "" : "sound "),
      .width = one_column,
      .height = 64,
      .data = {drawing.curve("curve", portrait.limits.in),
               pieces_of("measured", track, drawing, [](const auto& point) { return !is_snap(point); }),
               pieces_of("snaps", track, drawing, is_snap)},
      .panels = {{.x = drawing.w(1.03 * drawing.extent.w),
                  .y = drawing.F(1.2 * drawing.extent.F),
                  .marks = {marks::line("curve", {0, 1}, styles::below,
                                        history.cracks.empty() ? "Equilibrium curve" : "Sound specimen"),
                            marks::line("measured", {0, 1}, {.width = 1.2}, "Measured curve"),
                            marks::line("snaps", {0, 1}, {.dash = Dash::dashed}, snaps)}}}};
}

// Arrows on each leg and on each long stretch of sticking, in the ranges of the axes of a panel.
template <class Project>
PlotTable arrows_of(std::string name, const std::vector<TrackPoint>& track, Direction direction, const Axis& x,
                    const Axis& y, Project project) {
  std::vector<Spot> spots;
  for (const TrackPoint& point : track) {
    const std::pair<double, double> at = project(point.at);
    spots.push_back({(at.first - x.from) / (x.to - x.from), (at.second - y.from) / (y.to - y.from)});
  }
  std::vector<Arrow> arrows;
  const auto mark_each = [&](auto belongs) {
    for (std::size_t i = 1; i < track.size(); ++i) {
      if (!belongs(track[i])) continue;
      const std::size_t first = i - 1;
      while (i + 1 < track.size() && belongs(track[i + 1])) ++i;
      if (const auto arrow = arrow_on(spots, first, i, arrows)) arrows.push_back(*arrow);
    }
  };
  mark_each(
      [&](const TrackPoint& point) { return point.direction == direction && !is_snap(point) && !is_sticking(point); });
  mark_each([&](const TrackPoint& point) { return point.direction == direction && is_sticking(point); });
  PlotTable data{std::move(name), {"x", "y", "x of the tip", "y of the tip"}};
  for (const auto& [from, to] : arrows)
    data.rows.push_back({x.from + from.x * (x.to - x.from), y.from + from.y * (y.to - y.from),
                         x.from + to.x * (x.to - x.from), y.from + to.y * (y.to - y.from)});
  return data;
}

Plot loops_figure(const SimulatedPortrait& portrait, const PlotUnits& units) {
  const History& history = portrait.history;
  const auto track = track_of(portrait);
  const Drawing drawing(units, extended(extended({}, portrait.limits.in), history.path));
  double q_most = 0.05, S_max = portrait.limits.in.back().S;
  for (const TrackPoint& point : track) q_most = std::max(q_most, std::abs(point.at.q));
  const Axis w = drawing.w(1.04 * drawing.extent.w), F = drawing.F(1.1 * drawing.extent.F);
  const double margin = 0.04 * (S_max - 1);
  const Axis S = drawing.length.axis(S_label, 1 - margin, S_max + margin),
             q{"Mobilised friction *q*", "", -1.2 * q_most, 1.2 * q_most};

  PlotTable limits = drawing.curve("limits", portrait.limits.in);
  const PlotTable out = drawing.curve("", portrait.limits.out);
  limits.rows.emplace_back();
  limits.rows.insert(limits.rows.end(), out.rows.begin(), out.rows.end());
  const auto part = [&](const char* name, Direction direction, bool sticking) {
    return pieces_of(name, track, drawing, [=](const TrackPoint& point) {
      return !is_snap(point) && point.direction == direction && is_sticking(point) == sticking;
    });
  };
  const auto in_force = [&](const PathPoint& p) { return std::pair{drawing.length(p.w), drawing.force(p.F)}; };
  const auto in_friction = [&](const PathPoint& p) { return std::pair{drawing.length(p.S), p.q}; };

  constexpr Style stuck_in{Colour::blue, 1, Dash::dotted}, stuck_out{Colour::vermillion, 1, Dash::dotted};
  constexpr Style sticking{Colour::black, 1, Dash::dotted};
  const std::vector<Mark> lines{
      marks::line("limits", {}, styles::below),    marks::line("snaps", {}, styles::snap),
      marks::line("sticking_in", {}, stuck_in),    marks::line("sticking_out", {}, stuck_out),
      marks::line("loading", {}, styles::loading), marks::line("unloading", {}, styles::unloading)};
  const auto with_arrows = [&](std::vector<Mark> marks, const std::string& space) {
    marks.push_back(marks::arrows("arrows_in_" + space, {0, 1, 2, 3}, {Colour::blue, 1}));
    marks.push_back(marks::arrows("arrows_out_" + space, {0, 1, 2, 3}, {Colour::vermillion, 1}));
    return marks;
  };
  std::vector<Mark> first{marks::key_line(styles::loading, "Loading"), marks::key_line(styles::unloading, "Unloading"),
                          marks::key_line(sticking, "Sticking")};
  if (!history.snaps.empty() || !history.cracks.empty())
    first.push_back(marks::key_line(styles::snap, std::string(title_of_snaps(history))));
  first.push_back(marks::key_line(styles::below, portrait.limits.out.empty() ? "*q* = *μ*" : "*q* = ±*μ*"));
  for (Mark& each : with_arrows(of_columns(lines, 0, 1), "force")) first.push_back(std::move(each));
  return {.name = "measured",
          .title = "What the test measures",
          .caption =
              "(A) Force against deflection and (B) mobilised friction against the length between the supports, as the "
              "specimen is loaded "
              "(blue) and unloaded (red-orange), in the direction of the arrows. Dotted: it sticks. Dashed: it snaps. "
              "Grey: where it slides.",
          .width = two_columns,
          .height = 70,
          .data = {std::move(limits), pieces_of("snaps", track, drawing, is_snap),
                   part("sticking_in", Direction::loading, true), part("sticking_out", Direction::unloading, true),
                   part("loading", Direction::loading, false), part("unloading", Direction::unloading, false),
                   arrows_of("arrows_in_force", track, Direction::loading, w, F, in_force),
                   arrows_of("arrows_out_force", track, Direction::unloading, w, F, in_force),
                   arrows_of("arrows_in_friction", track, Direction::loading, S, q, in_friction),
                   arrows_of("arrows_out_friction", track, Direction::unloading, S, q, in_friction)},
          .panels = {{.title = "A", .x = w, .y = F, .marks = std::move(first)},
                     {.title = "B", .x = S, .y = q, .marks = with_arrows(of_columns(lines, 2, 3), "friction")}},
          .columns = 2};
}

PlotUnits units_of(const SimulatedTest& test) { return {test.scales, test.reduced, test.in_inches}; }

}  // namespace

Plot equilibrium_figure(const EquilibriumStudy& study) {
  return study.region ? region_figure(study) : curve_figure(study);
}

Plot simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks) {
  const SimulatedPortrait portrait = portrait_of(test, cracks);
  return portrait.legs.size() < 2 ? loading_figure(portrait, units_of(test)) : loops_figure(portrait, units_of(test));
}

Plot equilibria_figure(const SimulatedTest& test, std::span<const double> stages) {
  const OverallPortrait portrait = overall_portrait(test, stages);
  const double stiffness = test.followed.value().bending_test.rig.stiffness;
  const Drawing drawing(units_of(test), extended({}, portrait.in));
  const std::vector<std::string> titles{drawing.length.column("deflection"), drawing.force.column("force")};
  PlotTable lines{"lines", titles}, stable{"stable", titles}, partial{"partial", titles}, unstable{"unstable", titles};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double top = 1.15 * drawing.extent.F;
    lines.rows.insert(
        lines.rows.end(),
        {{drawing.length(stages[i] - top / stiffness), drawing.force(top)}, {drawing.length(stages[i]), 0}, {}});
    for (const auto& [point, stability] : portrait.at_stage[i])
      (stability == Stability::stable     ? stable
       : stability == Stability::unstable ? unstable
                                          : partial)
          .rows.push_back({drawing.length(point.w), drawing.force(point.F)});
  }
  const auto symbols = [](Colour colour, Symbol symbol) { return Style{colour, 0.8, Dash::solid, symbol, 3.8}; };
  return {
      .name = "equilibria",
      .title = "Overall equilibria",
      .caption =
          "The overall equilibria of specimen and rig, where load lines of the rig (dashed) cross the curve on "
          "which the specimen slides "
          "in (grey): filled if stable, open if unstable, red-orange if partially stable.",
      .width = one_column,
      .height = 64,
      .data = {drawing.curve("curve", portrait.in), std::move(lines), std::move(stable), std::move(partial),
               std::move(unstable)},
      .panels = {
          {.x = drawing.w(1.03 * drawing.extent.w),
           .y = drawing.F(1.2 * drawing.extent.F),
           .marks = {marks::line("curve", {0, 1}, styles::below, "Equilibrium curve"),
                     marks::line("lines", {0, 1}, {Colour::grey, 0.8, Dash::dashed}, "Load lines"),
                     marks::points("stable", {0, 1}, symbols(Colour::black, Symbol::disc), "Stable"),
                     marks::points("partial", {0, 1}, symbols(Colour::vermillion, Symbol::circle), "Partially stable"),
                     marks::points("unstable", {0, 1}, symbols(Colour::black, Symbol::circle), "Unstable")}}}};
}

}  // namespace flexslip
