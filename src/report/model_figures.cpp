#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "io/text.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "report/figures.h"
#include "result/frame.h"

namespace flexslip {
namespace {

constexpr const char* w_label = "Deflection *w*_0";
constexpr const char* S_label = "Length *S*";
constexpr Style curve_look{.colour = colours::dark, .width = 1.3};

ForcePlane extended(ForcePlane plane, double w, double F) {
  plane.w_max = std::max(plane.w_max, w);
  plane.F_max = std::max(plane.F_max, F);
  return plane;
}

// A plane that contains all points of some curves.
template <class... Curves>
ForcePlane plane_of(const PlotUnits& units, const Curves&... curves) {
  ForcePlane plane{};
  const auto extend = [&](const auto& points) {
    for (const auto& point : points) plane = extended(plane, point.w, point.F);
  };
  (extend(curves), ...);
  return force_plane(units, plane.w_max, plane.F_max);
}

// Deflection, force, length and mobilised friction.
template <class Point>
std::vector<double> state_row(const ForcePlane& plane, const Point& point) {
  return {plane.w(point.w), plane.F(point.F), plane.w(point.S), point.q};
}

PlotTable state_table(std::string name, const ForcePlane& plane, std::vector<std::vector<double>> rows = {}) {
  PlotTable table = plane.table(std::move(name));
  table.titles.insert(table.titles.end(), {plane.w.column("length"), "mobilised friction"});
  table.rows = std::move(rows);
  return plane.thinned(std::move(table));
}

PlotTable state_curve(std::string name, const ForcePlane& plane, const std::vector<EquilibriumPoint>& points) {
  std::vector<std::vector<double>> rows;
  for (const auto& point : points) rows.push_back(state_row(plane, point));
  return state_table(std::move(name), plane, std::move(rows));
}

// The same marks in another plane, without a second entry in the key.
std::vector<Mark> in_columns(std::vector<Mark> marks, std::size_t x, std::size_t y) {
  for (Mark& each : marks) {
    each.columns = {x, y};
    each.title.clear();
  }
  return marks;
}

PlotUnits units_of(const EquilibriumStudy& study) { return {study.scales, study.reduced, study.in_inches}; }
PlotUnits units_of(const SimulatedTest& test) { return {test.scales, test.reduced, test.in_inches}; }

Plot region_figure(const EquilibriumStudy& study) {
  const EquilibriumPortrait portrait = portrait_of(study);
  const ForcePlane plane = plane_of(units_of(study), portrait.in);
  std::vector<EquilibriumPoint> boundary = portrait.in;
  boundary.insert(boundary.end(), portrait.out.rbegin(), portrait.out.rend());
  // Arrows next to the curve, in the direction of increasing length.
  PlotTable arrows = plane.table("arrows");
  arrows.titles.insert(arrows.titles.end(), {plane.w.column("tip at deflection"), plane.F.column("tip at force")});
  const std::size_t n = portrait.in.size();
  for (const double share : {0.15, 0.42, 0.72}) {
    const auto i = static_cast<std::size_t>(share * static_cast<double>(n));
    const auto &from = portrait.in[i], &to = portrait.in[std::min(i + n / 12, n - 1)];
    const double lift = 0.1 * plane.F_max;
    arrows.rows.push_back({plane.w(from.w), plane.F(from.F + lift), plane.w(to.w), plane.F(to.F + lift)});
  }
  const std::vector<Mark> marks{{Mark::area, "region", {0, 1}, styles::fill(colours::silver, 0.5)},
                                {Mark::line, "curve", {0, 1}, curve_look}};
  std::vector<Mark> first = marks;
  first.push_back({Mark::line, "locus", {0, 1}, {.dash = Dash::dashed}});
  first.push_back({Mark::arrows, "arrows", {0, 1, 2, 3}, {.width = 0.8}});
  const Axis S = plane.w.axis(S_label, 1), w = plane.w.axis(w_label, 0);
  return {
      .name = "region",
      .title = "The equilibria of the specimen",
      .caption =
          "All equilibria of the specimen: (A) force against deflection, (B) deflection and (C) force against the "
          "length between the supports. Grey: the region of equilibria. Dark: its upper edge, on which the specimen "
          "slides in, in the direction of the arrows. Dashed: one length with every friction that it may have.",
      .width = two_columns,
      .height = 56,
      .data = {state_curve("region", plane, boundary), state_curve("curve", plane, portrait.in),
               state_curve("locus", plane, portrait.at_one_length), std::move(arrows)},
      .panels = {{.title = "A", .x = w, .y = plane.y(1.25), .marks = std::move(first)},
                 {.title = "B", .x = S, .y = w, .marks = in_columns(marks, 2, 0)},
                 {.title = "C", .x = S, .y = plane.y(1.25), .marks = in_columns(marks, 2, 1)}},
      .columns = 3};
}

}  // namespace

Plot equilibrium_figure(const EquilibriumStudy& study) {
  if (study.region) return region_figure(study);
  const EquilibriumPortrait portrait = portrait_of(study);
  const ForcePlane plane = plane_of(units_of(study), portrait.in, portrait.frictionless);
  return {.name = "equilibrium",
          .title = "The equilibrium curve",
          .caption =
              "Force against deflection while the specimen slides in (dark), without friction (orange) and by "
              "Euler–Bernoulli (orange, dashed).",
          .width = one_column,
          .height = 64,
          .data = {state_curve("frictionless", plane, portrait.frictionless), state_curve("curve", plane, portrait.in)},
          .panels = {{.x = plane.x(1.03, w_label),
                      .y = plane.y(1.3),
                      .marks = {{Mark::line, "curve", {0, 1}, curve_look, "Equilibrium curve"},
                                {Mark::line, "frictionless", {0, 1}, styles::frictionless, "No friction"},
                                {.style = styles::euler,
                                 .title = "Euler–Bernoulli",
                                 .at = {0, 0, plane.w(plane.w_max), plane.F(beam_stiffness * plane.w_max)}}}}}};
}

namespace {

// A point of the path with the direction of the stage.
struct TrackPoint {
  PathPoint at;
  Direction direction;
};
// True for snaps and cracks, which are instantaneous.
bool is_snap(const TrackPoint& point) { return point.at.motion == Motion::snap || point.at.motion == Motion::crack; }

// Arrows in the middle of the long sections of a table. Coinciding sections get one arrow.
PlotTable arrows_of(std::string name, const PlotTable& stretches, std::size_t x, std::size_t y, const Axis& across,
                    const Axis& up) {
  PlotTable arrows{std::move(name), {"x", "y", "x of the tip", "y of the tip"}};
  const auto& rows = stretches.rows;
  const double width = across.to - across.from, height = up.to - up.from;
  for (std::size_t first = 0, last = 0; first < rows.size(); first = last + 2) {
    for (last = first; last + 1 < rows.size() && !rows[last + 1].empty();) ++last;
    const double dx = rows[last][x] - rows[first][x], dy = rows[last][y] - rows[first][y];
    const double size = std::hypot(dx / width, dy / height), half = 0.025 / size;
    const double from_x = rows[first][x] + (0.5 - half) * dx, from_y = rows[first][y] + (0.5 - half) * dy;
    if (size > 0.2 && std::none_of(arrows.rows.begin(), arrows.rows.end(), [&](const auto& other) {
          return std::hypot((other[0] - from_x) / width, (other[1] - from_y) / height) < 0.15;
        }))
      arrows.rows.push_back({from_x, from_y, from_x + 2 * half * dx, from_y + 2 * half * dy});
  }
  return arrows;
}

}  // namespace

Plot simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks) {
  const SimulatedPortrait portrait = portrait_of(test, cracks);
  const History& history = portrait.history;
  const ForcePlane plane = plane_of(units_of(test), portrait.limits.in, history.path);
  std::vector<TrackPoint> track;
  for (const Leg& leg : portrait.legs)
    for (std::size_t i = leg.first; i < leg.last; ++i) track.push_back({history.path[i], leg.direction});
  const auto stretches = [&](std::string name, auto belongs) {
    return state_table(std::move(name), plane, stretches_of(track, belongs, [&](const TrackPoint& point) {
                         return state_row(plane, point.at);
                       }));
  };
  const bool cracked = !history.cracks.empty();
  const std::string snaps_title = history.snaps.empty() && !cracked ? "" : cracked ? "Cracks, snaps" : "Snaps";
  PlotTable limits = state_curve("limits", plane, portrait.limits.in), snaps = stretches("snaps", is_snap);
  if (portrait.legs.size() < 2)
    return {
        .name = "measured",
        .title = "What the test measures",
        .caption = fmt::format("Force against deflection as the test measures it (black; {} dashed), over the curve on "
                               "which the {}specimen slides in (grey).",
                               cracked ? "cracks and snaps" : "snaps", cracked ? "sound " : ""),
        .width = one_column,
        .height = 64,
        .data = {std::move(limits), stretches("measured", [](const auto& point) { return !is_snap(point); }),
                 std::move(snaps)},
        .panels = {
            {.x = plane.x(1.03, w_label),
             .y = plane.y(1.2),
             .marks = {{Mark::line, "limits", {0, 1}, styles::below, cracked ? "Sound specimen" : "Equilibrium curve"},
                       {Mark::line, "measured", {0, 1}, {.width = 1.2}, "Measured curve"},
                       {Mark::line, "snaps", {0, 1}, {.dash = Dash::dashed}, snaps_title}}}}};

  const auto part = [&](const char* name, Direction direction, bool sticking) {
    return stretches(name, [=](const TrackPoint& point) {
      return !is_snap(point) && point.direction == direction && (point.at.motion == Motion::stick) == sticking;
    });
  };
  PlotTable stuck_in = part("sticking_in", Direction::loading, true),
            stuck_out = part("sticking_out", Direction::unloading, true);
  const PlotTable out = state_curve("", plane, portrait.limits.out);
  limits.rows.emplace_back();
  limits.rows.insert(limits.rows.end(), out.rows.begin(), out.rows.end());
  double q_most = 0.05, S_max = portrait.limits.in.back().S;
  for (const TrackPoint& point : track) q_most = std::max(q_most, std::abs(point.at.q));
  const double margin = 0.04 * (S_max - 1);
  const Axis w = plane.x(1.04, w_label), F = plane.y(1.1), S = plane.w.axis(S_label, 1 - margin, S_max + margin),
             q{"Mobilised friction *q*", "", -1.2 * q_most, 1.2 * q_most};
  const std::vector<Mark> lines{
      {Mark::line, "limits", {0, 1}, styles::below, portrait.limits.out.empty() ? "*q* = *μ*" : "*q* = ±*μ*"},
      {Mark::line, "snaps", {0, 1}, styles::snap, snaps_title},
      {Mark::line, "sticking_in", {0, 1}, {colours::blue, 1, Dash::dotted}},
      {Mark::line, "sticking_out", {0, 1}, {colours::vermillion, 1, Dash::dotted}},
      {Mark::line, "loading", {0, 1}, styles::loading},
      {Mark::line, "unloading", {0, 1}, styles::unloading}};
  std::vector<Panel> panels{{.title = "A", .x = w, .y = F, .marks = lines},
                            {.title = "B", .x = S, .y = q, .marks = in_columns(lines, 2, 3)}};
  const std::vector<Mark> entries{{.style = styles::loading, .title = "Loading"},
                                  {.style = styles::unloading, .title = "Unloading"},
                                  {.style = {.dash = Dash::dotted}, .title = "Sticking"}};
  panels[0].marks.insert(panels[0].marks.end(), entries.begin(), entries.end());
  std::vector<PlotTable> data{std::move(limits), std::move(snaps), part("loading", Direction::loading, false),
                              part("unloading", Direction::unloading, false)};
  for (const bool is_second : {false, true})
    for (const auto& [name, sticking, colour] : {std::tuple{"arrows_in", &stuck_in, colours::blue},
                                                 std::tuple{"arrows_out", &stuck_out, colours::vermillion}}) {
      Panel& panel = panels[is_second ? 1 : 0];
      data.push_back(arrows_of(fmt::format("{}_{}", name, is_second ? "friction" : "force"), *sticking,
                               is_second ? 2 : 0, is_second ? 3 : 1, panel.x, panel.y));
      panel.marks.push_back({Mark::arrows, data.back().name, {0, 1, 2, 3}, {colour}});
    }
  data.push_back(std::move(stuck_in));
  data.push_back(std::move(stuck_out));
  return {.name = "measured",
          .title = "What the test measures",
          .caption =
              "(A) Force against deflection and (B) mobilised friction against the length between the supports, as the "
              "specimen is loaded (blue) and unloaded (red-orange). Dotted: it sticks, in the direction of the arrows. "
              "Dashed: it snaps. Grey: where it slides.",
          .width = two_columns,
          .height = 70,
          .data = std::move(data),
          .panels = std::move(panels),
          .columns = 2};
}

Plot equilibria_figure(const SimulatedTest& test, std::span<const double> stages) {
  const OverallPortrait portrait = overall_portrait(test, stages);
  const double stiffness = test.followed.bending_test.rig.stiffness;
  const ForcePlane plane = plane_of(units_of(test), portrait.in);
  PlotTable points = plane.table("equilibria");
  points.titles.emplace_back("stability (0 stable; 1 partial; 2 unstable)");
  std::vector<Mark> marks{{Mark::line, "curve", {0, 1}, styles::below, "Equilibrium curve"}};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double top = 1.15 * plane.F_max;
    marks.push_back({.style = {colours::grey, 0.8, Dash::dashed},
                     .title = i == 0 ? "Load lines" : "",
                     .at = {plane.w(stages[i] - top / stiffness), plane.F(top), plane.w(stages[i]), 0}});
    for (const auto& [point, stability] : portrait.at_stage[i])
      points.rows.push_back({plane.w(point.w), plane.F(point.F),
                             stability == Stability::stable     ? 0.0
                             : stability == Stability::unstable ? 2.0
                                                                : 1.0});
  }
  for (const auto& [which, symbol, colour, words] :
       {std::tuple{0.0, Symbol::disc, colours::black, "Stable"},
        std::tuple{1.0, Symbol::circle, colours::vermillion, "Partially stable"},
        std::tuple{2.0, Symbol::circle, colours::black, "Unstable"}})
    marks.push_back({Mark::points, "equilibria", {0, 1}, styles::mark(symbol, colour, 3.8, 0.8), words, {{2, which}}});
  return {
      .name = "equilibria",
      .title = "Overall equilibria",
      .caption =
          "The overall equilibria of specimen and rig, where load lines of the rig (dashed) cross the curve on which "
          "the specimen slides in (grey): filled if stable, open if unstable, red-orange if partially stable.",
      .width = one_column,
      .height = 64,
      .data = {plane.curve("curve", portrait.in), std::move(points)},
      .panels = {{.x = plane.x(1.03, w_label), .y = plane.y(1.2), .marks = std::move(marks)}}};
}

Plot design_figure(const DesignAnswer& answer) {
  const Design& design = answer.design;
  const DesignOutcome& outcome = answer.outcome;
  const double own = design.rig.stiffness;
  const bool breaks = outcome.status == DesignStatus::breaks, is_finite = std::isfinite(own);
  const std::vector<FoldPoint> folds = folds_of(answer);
  double top = is_finite ? own : 0;
  for (const auto& fold : folds) top = std::max(top, std::min(fold.stiffness, 1e6));
  if (std::isfinite(answer.critical)) top = std::max(top, answer.critical);
  if (top == 0) top = beam_stiffness;  // displacement control, and no rig snaps
  // The stiffness of the rig may be far from the relevant range.
  constexpr double wide = 20;
  const double likely = is_finite ? own : top;
  const double least = answer.critical > 0 ? std::min(likely, answer.critical) : likely;
  const bool is_wide = top > wide * least;

  const PlotUnits units{answer.scales, answer.input.reduced, is_in_inches(answer.input)};
  const PlotUnit w = units.length(design.travel), F = units.force(outcome.greatest_force), k = units.stiffness(top);
  // Compliant supports are combined with the load train into one rig stiffness.
  const bool gives = support_compliance_of(answer.input) > 0;
  Axis stiffness = k.axis(gives ? "Stiffness of the rig *k*" : "Load-train stiffness *k*", is_wide ? least / 3 : 0,
                          (is_wide ? 2 : 1.12) * top);
  stiffness.logarithmic = is_wide;

  PlotTable record{"record", {w.column("stage"), F.column("force")}};
  for (const auto& reading : record_of(answer)) record.rows.push_back({w(reading.stage), F(reading.F)});
  PlotTable unknown{"unknown", {w.column("stage"), F.column("low"), F.column("high")}};
  if (answer.open)
    for (const auto& [stage, low, high] : answer.open->force) unknown.rows.push_back({w(stage), F(low), F(high)});
  struct Fall {
    double stage, F;
    bool falls;
  };
  std::vector<Fall> readings;
  for (const auto& row : record.rows)
    readings.push_back({row[0], row[1], !readings.empty() && row[1] < readings.back().F});
  const PlotTable drops{"drops", record.titles,
                        stretches_of(
                            readings, [](const Fall& at) { return at.falls; },
                            [](const Fall& at) {
                              return std::vector{at.stage, at.F};
                            })};
  // On a rig softer than F/(travel - w) the loading ends before this deflection.
  PlotTable table{
      "folds",
      {w.column("deflection"), k.column("stiffness"), "edge of the axis", k.column("softest that gets there")}};
  for (const auto& fold : folds)
    table.rows.push_back(
        {w(fold.w), std::max(k(fold.stiffness), stiffness.from), stiffness.from, k(fold.F / (design.travel - fold.w))});

  const bool is_open = answer.open && !answer.open->open.empty();
  std::vector<Mark> of_record{{Mark::band,
                               "unknown",
                               {0, 1, 2},
                               styles::fill(colours::grey, 0.35),
                               is_open ? "Unknown friction" : "Unknown phase"},
                              {Mark::line, "record", {0, 1}, {.width = 1.1}, "Record"},
                              {Mark::line, "drops", {0, 1}, {colours::vermillion, 1.5}, "Drops"}};
  std::vector<Mark> of_folds{{Mark::band, "folds", {0, 2, 1}, styles::fill(colours::sky, 0.35), "Unstable"},
                             {Mark::line, "folds", {0, 1}, {colours::blue, 0.8}},
                             {Mark::line, "folds", {0, 3}, {.width = 1.2, .dash = Dash::dotted}, "End of travel"}};
  if (is_finite) of_folds.push_back(level(k(own), {.width = 1.4}, gives ? "This rig" : "This load train"));
  if (std::isfinite(answer.critical) && answer.critical > 0)
    of_folds.push_back(level(k(answer.critical), {colours::green, 1.4, Dash::dashed}, "Critical stiffness"));
  if (breaks) {
    of_folds.push_back(upright(w(outcome.w_reached), {.width = 1.2}));
    of_record.push_back(spot(w(outcome.stage_reached), F((outcome.stage_reached - outcome.w_reached) * own),
                             styles::mark(Symbol::cross, colours::black, 5, 1.6), "Breaks"));
  }
  if (const auto& snap = outcome.first_snap) {
    constexpr Style circle = styles::mark(Symbol::circle, colours::vermillion, 4);
    of_record.push_back(spot(w(snap->stage), F(snap->F_before), circle, "First snap"));
    of_folds.push_back(spot(w(snap->w), k(std::min(own, top)), circle));
  }
  return {
      .name = "design",
      .title = "What a planned test will show",
      .caption = fmt::format(
          "(A) The expected record, force against stage displacement, with its drops in red-orange.{} "
          "(B) By deflection, the stiffness {} below which the specimen snaps (blue area), the "
          "stiffness of this test (black) and the critical one (green, dashed), above which "
          "nothing snaps; dotted: on a softer rig the travel ends before that deflection. Circle: the first snap.{}",
          !answer.open ? ""
          : is_open    ? " Grey: the force for any friction in the ranges that fit the specimen; the record is for "
                         "their middle."
                       : " Grey: the force for any phase of the friction.",
          gives ? "of the rig" : "of the load train",
          breaks ? " Cross and upright line: where the specimen breaks." : ""),
      .width = two_columns,
      .height = 70,
      .data = {std::move(record), drops, std::move(table), std::move(unknown)},
      .panels = {{.title = "A",
                  .x = w.axis("Stage displacement *w*_s", 0, 1.02 * design.travel),
                  .y = F.axis(force_label, 0,
                              1.12 * std::max(outcome.greatest_force, answer.open ? answer.open->max_force : 0)),
                  .marks = std::move(of_record)},
                 {.title = "B",
                  .x = w.axis(w_label, 0, folds.empty() ? design.travel : folds.back().w),
                  .y = stiffness,
                  .marks = std::move(of_folds)}},
      .columns = 2};
}

namespace {

// A varied parameter as an axis.
struct ParameterAxis {
  AxisRange range;
  PlotUnit unit;
  Axis axis;

  double operator()(double value) const { return unit(value); }
  // The edges of the cell around a value, half a step on each side.
  std::pair<double, double> cell(double value) const {
    const auto steps = static_cast<double>(range.points - 1);
    if (range.spacing == Spacing::linear) {
      const double half = 0.5 * std::abs(range.to - range.from) / steps;
      return {unit(value - half), unit(value + half)};
    }
    const double half = std::pow(std::max(range.to / range.from, range.from / range.to), 0.5 / steps);
    return {unit(value / half), unit(value * half)};
  }
};

ParameterAxis parameter_axis(const Test& input, const DesignAxis& over) {
  const auto& range = std::get<AxisRange>(over.values);
  const Kind kind = kind_in(input, over.parameter.kind());
  const bool logarithmic = range.spacing == Spacing::logarithmic;
  const double magnitude =
      logarithmic ? std::sqrt(range.from * range.to) : std::max(std::abs(range.from), std::abs(range.to));
  PlotUnit unit{"", 1};
  if (!kind.units.empty()) unit = plot_unit(magnitude, kind, input.reduced, typeset(unit_of(kind, true)));
  std::string words = capitalised(over.parameter.description);
  if (!over.parameter.symbol.empty()) words += fmt::format(" {}", over.parameter.symbol);
  Axis axis = unit.axis(words, std::min(range.from, range.to), std::max(range.from, range.to));
  axis.logarithmic = logarithmic;
  return {range, std::move(unit), std::move(axis)};
}

// [%] of the maximum force
double drop_share(const DesignOutcome& outcome) { return 100 * outcome.largest_drop / outcome.greatest_force; }

Plot line_map(const Test& input, const DesignAxis& over, const std::vector<MapPoint>& points) {
  const ParameterAxis x = parameter_axis(input, over);
  const auto first_deflection = [](const DesignResult& result) {  // [units of the case]
    return result.outcome && result.outcome->first_snap
               ? result.units->scales.physical_length(result.outcome->first_snap->w)
               : not_a_number;
  };
  double deepest = 0;
  for (const auto& point : points) deepest = std::fmax(deepest, first_deflection(point.result));
  const PlotUnit length = plot_unit(deepest > 0 ? deepest : 1, kind_in(input, kind::length), input.reduced, "L");
  PlotTable designs{"designs",
                    {x.unit.column(over.parameter.name), "largest drop [%]", "mean drop [%]", "friction and snaps [%]",
                     length.column("first snap")}};
  for (const auto& point : points) {
    auto& row = designs.rows.emplace_back();
    if (const auto& outcome = point.result.outcome)
      row = {x(point.values[0]), drop_share(*outcome), 100 * outcome->mean_drop / outcome->greatest_force,
             100 * friction_share(*outcome), length(first_deflection(point.result))};
  }
  std::vector<Panel> panels{
      {.title = "A",
       .x = x.axis,
       .y = {"Share", "%", 0},
       .marks = {{Mark::line, "designs", {0, 1}, {.width = 1.6}, "Largest drop"},
                 {Mark::line, "designs", {0, 2}, {.width = 1.2, .dash = Dash::dashed}, "Mean drop"},
                 {Mark::line, "designs", {0, 3}, {colours::vermillion, 1.6}, "Friction and snaps"}}}};
  if (deepest > 0)
    panels.push_back({.title = "B",
                      .x = x.axis,
                      .y = length.axis("First snap at *w*_0", 0),
                      .marks = {{Mark::points, "designs", {0, 4}, styles::mark(Symbol::disc, colours::blue, 1.8)}}});
  const std::size_t columns = panels.size();
  return {.name = "designs",
          .title = "What a test shows over a range",
          .caption = fmt::format(
              "What a test shows over the {}: {}the largest drop of the force (black) and the mean one (dashed), as "
              "shares of the maximum force, and the share of friction and snaps in the work (red-orange){}.",
              over.parameter.description, deepest > 0 ? "(A) " : "",
              deepest > 0 ? "; (B) the deflection at which the specimen first snaps" : "; it never snaps"),
          .width = deepest > 0 ? two_columns : one_column,
          .height = 66,
          .data = {std::move(designs)},
          .panels = std::move(panels),
          .columns = columns};
}

// The point on one side of the border that is farthest from it, far enough from the frame for a
// label; null if there is none.
const MapPoint* middle_of(const std::vector<MapPoint>& points, std::size_t columns, double side) {
  const auto is_inside = [](std::size_t i, std::size_t count) { return 6 * i > count && 6 * (i + 1) < 5 * count; };
  const MapPoint* best = nullptr;
  for (std::size_t n = 0; n < points.size(); ++n)
    if (is_inside(n / columns, points.size() / columns) && is_inside(n % columns, columns) &&
        side * points[n].margin > 0 && (!best || side * points[n].margin > side * best->margin))
      best = &points[n];
  return best;
}

Plot plane_map(const Test& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points) {
  ParameterAxis x = parameter_axis(input, axes[0]), y = parameter_axis(input, axes[1]);
  PlotTable designs{"designs",
                    {x.unit.column(axes[0].parameter.name), "left", "right", y.unit.column(axes[1].parameter.name),
                     "low", "high", "largest snap [%]"}};
  double most = 0;
  for (const MapPoint& point : points) {
    const auto [left, right] = x.cell(point.values[0]);
    const auto [low, high] = y.cell(point.values[1]);
    const auto& outcome = point.result.outcome;
    const double share =
        outcome && outcome->snaps > 0 ? 100 * outcome->largest_snap / outcome->greatest_force : not_a_number;
    designs.rows.push_back({x(point.values[0]), left, right, y(point.values[1]), low, high, share});
    most = std::fmax(most, share);
  }
  PlotTable border{"border", {"x", "y"}};
  for (const auto& [from, to] : border_of_snapping(axes, points))
    border.rows.insert(border.rows.end(), {{x(from[0]), y(from[1])}, {x(to[0]), y(to[1])}, {}});
  std::vector<Mark> marks{
      {Mark::pixels, "designs", {1, 2, 4, 5, 6}},
      {Mark::line, "border", {0, 1}, {colours::vermillion, 2}, "Border of snapping"},
      spot(x(value_of(input, axes[0].parameter.name).value()), y(value_of(input, axes[1].parameter.name).value()),
           styles::mark(Symbol::disc, colours::black, 4), "This test")};
  for (const auto& [side, words] : {std::pair{-1.0, "snaps"}, std::pair{1.0, "no snap"}})
    if (const MapPoint* there = middle_of(points, static_cast<std::size_t>(points_of(axes[1])), side))
      marks.push_back(label(x(there->values[0]), y(there->values[1]), words));
  for (ParameterAxis* each : {&x, &y}) {
    const auto [least, greatest] = std::minmax(each->range.from, each->range.to);
    each->axis.from = each->cell(least).first;
    each->axis.to = each->cell(greatest).second;
  }
  return {.name = "designs",
          .title = "Where a test shows a sawtooth",
          .caption = fmt::format(
              "The largest snap (blue, the darker the larger the drop of the force in it) over the {} and the {}. "
              "Red-orange: the border of snapping. Disc: the test as the case states it. White: no snap, though the "
              "force may fall smoothly beyond its maximum; or not to be computed.",
              axes[0].parameter.description, axes[1].parameter.description),
          .width = 110,
          .height = 85,
          .data = {std::move(designs), std::move(border)},
          .panels = {{.x = x.axis,
                      .y = y.axis,
                      .marks = std::move(marks),
                      .colour = {"Largest snap, of the maximum force", "%", 0, most > 0 ? most : 1}}}};
}

}  // namespace

Plot design_map_figure(const Test& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points) {
  if (axes.size() == 1) return line_map(input, axes.front(), points);
  if (axes.size() == 2) return plane_map(input, axes, points);
  throw std::invalid_argument("a map has one axis or two, not " + std::to_string(axes.size()));
}

}  // namespace flexslip
