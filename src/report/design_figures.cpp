#include "report/design_figures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/quantity.h"
#include "report/marks.h"
#include "report/plot_units.h"
#include "result/frame.h"

namespace flexslip {
namespace {

constexpr double stiffness_of_straight_fibre = 48;  // [EI/L^3]

// A parameter that goes through values, as an axis.
struct ParameterAxis {
  PlotUnit unit;
  Axis axis;
  bool logarithmic;

  ParameterAxis(const Test& input, const DesignAxis& over) {
    const auto& range = std::get<AxisRange>(over.values);
    const DesignParameterName& parameter = over.parameter;
    const Kind kind = kind_in(input, parameter.kind);
    const auto [least, most] = std::minmax(range.from, range.to);
    logarithmic = range.spacing == Spacing::logarithmic;
    unit = kind.units.empty()
               ? PlotUnit{"", 1}
               : plot_unit(logarithmic ? std::sqrt(least * most) : std::max(std::abs(least), std::abs(most)), kind,
                           input.reduced, typeset(unit_of(kind, true)));
    std::string words(parameter.description);
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    const std::string symbol(parameter.symbol);
    axis = unit.axis(symbol.empty() ? words : words + " " + symbol, least, most);
    axis.logarithmic = logarithmic;
  }

  double operator()(double value) const { return unit(value); }
  // Along which the values are evenly spaced, and back.
  double even(double plotted) const { return logarithmic ? std::log10(plotted) : plotted; }
  double plotted(double even) const { return logarithmic ? std::pow(10, even) : even; }
};

double drop_share(const DesignOutcome& outcome) { return 100 * outcome.largest_drop / outcome.greatest_force; }

// [units of the case] of the first snap.
std::optional<double> first_deflection(const DesignResult& result) {
  const auto& snap = result.outcome->first_snap;
  return snap ? std::optional(result.units->scales.physical_length(snap->w)) : std::nullopt;
}

Plot curve_figure(const Test& input, const DesignAxis& over, const std::vector<MapPoint>& points) {
  const ParameterAxis x(input, over);
  double deepest = 0;
  for (const auto& point : points)
    if (point.result.outcome) deepest = std::max(deepest, first_deflection(point.result).value_or(0));
  const PlotUnit length = plot_unit(deepest > 0 ? deepest : 1, kind_in(input, kind::length), input.reduced, "L");
  PlotTable designs{"designs",
                    {x.unit.column(over.parameter.name), "largest drop [%]", "mean drop [%]", "friction and snaps [%]",
                     length.column("first snap")}};
  for (const auto& point : points) {
    if (!point.result.outcome) {
      designs.rows.emplace_back();
      continue;
    }
    const DesignOutcome& outcome = *point.result.outcome;
    designs.rows.push_back({x(point.values[0]), drop_share(outcome), 100 * outcome.mean_drop / outcome.greatest_force,
                            100 * friction_share(outcome), length(first_deflection(point.result).value_or(NAN))});
  }
  Panel shares{.title = "A",
               .x = x.axis,
               .y = {"Share", "%", 0},
               .marks = {marks::line("designs", {0, 1}, {.width = 1.6}, "Largest drop"),
                         marks::line("designs", {0, 2}, {.width = 1.2, .dash = Dash::dashed}, "Mean drop"),
                         marks::line("designs", {0, 3}, {Colour::vermillion, 1.6}, "Friction and snaps")}};
  Panel first{.title = "B",
              .x = x.axis,
              .y = length.axis("First snap at *w*_0", 0),
              .marks = {marks::points("designs", {0, 4}, {Colour::blue, 0.5, Dash::solid, Symbol::disc, 1.8})}};
  if (!(deepest > 0))
    first.marks.push_back(marks::label(x.plotted((x.even(x.axis.from) + x.even(x.axis.to)) / 2), 0.5, "None snaps"));
  return {.name = "designs",
          .title = "What a test shows over a range",
          .caption = fmt::format("What a test shows over the {}: (A) the largest drop of the force (black) and the "
                                 "mean one (dashed), as shares of "
                                 "the greatest force, and the share of friction and snaps in the work (red-orange); "
                                 "(B) the deflection at which "
                                 "the specimen first snaps.",
                                 over.parameter.description),
          .width = two_columns,
          .height = 66,
          .data = {std::move(designs)},
          .panels = {std::move(shares), std::move(first)},
          .columns = 2};
}

using Grid = std::vector<MapPoint>;  // the second axis fastest

// Where the margin vanishes: on the edges of the grid's cells, and straight between them.
PlotTable border_of(const Grid& points, std::size_t rows, std::size_t columns, const ParameterAxis& x,
                    const ParameterAxis& y) {
  PlotTable border{"border", {"x", "y"}};
  const auto at = [&](std::size_t i, std::size_t j) -> const MapPoint& { return points[i * columns + j]; };
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const std::array corners{&at(i, j), &at(i + 1, j), &at(i + 1, j + 1), &at(i, j + 1), &at(i, j)};
      std::vector<std::vector<double>> crossings;
      for (std::size_t c = 0; c < 4; ++c) {
        const double a = corners[c]->margin;
        const double b = corners[c + 1]->margin;
        if (std::isnan(a) || std::isnan(b) || (a > 0) == (b > 0)) continue;
        const auto between = [&](const ParameterAxis& axis, std::size_t k) {
          const double from = axis.even(axis(corners[c]->values[k])), to = axis.even(axis(corners[c + 1]->values[k]));
          return axis.plotted(from + a / (a - b) * (to - from));
        };
        crossings.push_back({between(x, 0), between(y, 1)});
      }
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2)
        border.rows.insert(border.rows.end(), {crossings[c], crossings[c + 1], {}});
    }
  return border;
}

// The point of a side of the border that is farthest from it, as far from the frame as a word needs; none if there is no such point.
std::optional<std::size_t> middle_of(const Grid& points, std::size_t columns, double side) {
  const auto is_inside = [](std::size_t i, std::size_t count) { return 6 * i > count && 6 * (i + 1) < 5 * count; };
  std::optional<std::size_t> best;
  for (std::size_t n = 0; n < points.size(); ++n)
    if (is_inside(n / columns, points.size() / columns) && is_inside(n % columns, columns) &&
        side * points[n].margin > 0 && (!best || side * points[n].margin > side * points[*best].margin))
      best = n;
  return best;
}

Plot plane_figure(const Test& input, const std::vector<DesignAxis>& axes, const Grid& points) {
  ParameterAxis x(input, axes[0]), y(input, axes[1]);
  const std::size_t rows = points_of(axes[0]), columns = points_of(axes[1]);
  // The edges of a cell, half a step on either side.
  const auto edges = [](const ParameterAxis& axis, double value, std::size_t count) {
    const double half = 0.5 * (axis.even(axis.axis.to) - axis.even(axis.axis.from)) / static_cast<double>(count - 1);
    const double middle = axis.even(axis(value));
    return std::pair{axis.plotted(middle - half), axis.plotted(middle + half)};
  };
  PlotTable designs{"designs",
                    {x.unit.column(axes[0].parameter.name), "left", "right", y.unit.column(axes[1].parameter.name),
                     "low", "high", "largest drop [%]"}};
  double most = 0;
  for (const MapPoint& point : points) {
    const auto [left, right] = edges(x, point.values[0], rows);
    const auto [low, high] = edges(y, point.values[1], columns);
    const double share = point.result.outcome ? drop_share(*point.result.outcome) : NAN;
    designs.rows.push_back({x(point.values[0]), left, right, y(point.values[1]), low, high, share});
    most = std::fmax(most, share);
  }
  const std::vector<double> own{x(value_of(input, axes[0].parameter.parameter).value()),
                                y(value_of(input, axes[1].parameter.parameter).value())};
  std::vector<Mark> marks{
      marks::pixels("designs", {1, 2, 4, 5, 6}, {}),
      marks::line("border", {0, 1}, {Colour::vermillion, 2}, "Border of snapping"),
      marks::points("own", {0, 1}, {Colour::black, 0.5, Dash::solid, Symbol::disc, 4}, "This test")};
  for (const auto& [side, words] : {std::pair{-1.0, "snaps"}, std::pair{1.0, "no snap"}})
    if (const auto there = middle_of(points, columns, side))
      marks.push_back(marks::label(designs.rows[*there][0], designs.rows[*there][3], words));
  std::tie(x.axis.from, x.axis.to) = std::pair{designs.rows.front()[1], designs.rows.back()[2]};
  std::tie(y.axis.from, y.axis.to) = std::pair{designs.rows.front()[4], designs.rows.back()[5]};
  for (Axis* axis : {&x.axis, &y.axis})
    if (axis->from > axis->to) std::swap(axis->from, axis->to);
  PlotTable border = border_of(points, rows, columns, x, y);
  return {
      .name = "designs",
      .title = "Where a test shows a sawtooth",
      .caption = fmt::format("The largest drop of the force (blue, the darker the larger) over the {} and the {}. "
                             "Red-orange: the border of "
                             "snapping. Disc: the test as the case states it. White: no drop, or not to be computed.",
                             axes[0].parameter.description, axes[1].parameter.description),
      .width = 110,
      .height = 85,
      .data = {std::move(designs), std::move(border), {"own", {x.unit.column("x"), y.unit.column("y")}, {own}}},
      .panels = {{.x = x.axis,
                  .y = y.axis,
                  .marks = std::move(marks),
                  .colour = {"Largest drop, of the greatest force", "%", 0, most > 0 ? most : 1}}}};
}

// The falls of a record, each from its top on.
PlotTable falls_of(const PlotTable& record) {
  PlotTable falls{"drops", record.titles};
  const auto& rows = record.rows;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!(rows[i][1] < rows[i - 1][1])) continue;
    if (i < 2 || !(rows[i - 1][1] < rows[i - 2][1])) {
      if (!falls.rows.empty()) falls.rows.emplace_back();
      falls.rows.push_back(rows[i - 1]);
    }
    falls.rows.push_back(rows[i]);
  }
  return falls;
}

}  // namespace

Plot design_figure(const DesignAnswer& answer) {
  const Design& design = answer.design;
  const DesignOutcome& outcome = answer.outcome;
  const double own = design.rig.stiffness;
  const bool breaks = outcome.status == DesignStatus::breaks, is_finite = std::isfinite(own);
  const DesignCurves curves = curves_of(answer);
  double top = is_finite ? own : 0;
  for (const auto& fold : curves.folds) top = std::max(top, std::min(fold.stiffness, 1e6));
  if (std::isfinite(answer.critical)) top = std::max(top, answer.critical);
  if (top == 0) top = stiffness_of_straight_fibre;  // displacement control, and no rig snaps
  // The rig may be far from where it matters.
  constexpr double wide = 20;
  const double likely = is_finite ? own : top;
  const double least = answer.critical > 0 ? std::min(likely, answer.critical) : likely;
  const bool is_wide = top > wide * least;

  const PlotUnits units{answer.scales, answer.input.reduced, is_in_inches(answer.input)};
  const PlotUnit w = units.length(design.travel), F = units.force(outcome.greatest_force), k = units.stiffness(top);
  Axis stiffness = k.axis("", is_wide ? least / 3 : 0, (is_wide ? 2 : 1.12) * top);
  stiffness.logarithmic = is_wide;
  // Supports that give way make a rig of the load train.
  const bool gives = support_compliance_of(answer.input) > 0;
  stiffness.label = gives ? "Stiffness of the rig *k*" : "Load-train stiffness *k*";

  PlotTable record{"record", {w.column("stage"), F.column("force")}};
  for (const auto& reading : curves.record) record.rows.push_back({w(reading.stage), F(reading.F)});
  // On a rig softer than F/(travel - w) the loading ends before this deflection.
  PlotTable folds{
      "folds",
      {w.column("deflection"), k.column("stiffness"), "edge of the axis", k.column("softest that gets there")}};
  for (const auto& fold : curves.folds)
    folds.rows.push_back(
        {w(fold.w), std::max(k(fold.stiffness), stiffness.from), stiffness.from, k(fold.F / (design.travel - fold.w))});
  PlotTable end{"breaks", {w.column("stage"), F.column("force")}};
  if (breaks) end.rows.push_back({w(outcome.stage_reached), F((outcome.stage_reached - outcome.w_reached) * own)});
  PlotTable first{"first", {w.column("deflection"), k.column("stiffness"), w.column("stage"), F.column("force")}};
  if (const auto& snap = outcome.first_snap)
    first.rows.push_back({w(snap->w), k(std::min(own, top)), w(snap->stage), F(snap->F_before)});

  constexpr Style snap_mark{Colour::vermillion, 1, Dash::solid, Symbol::circle, 4};
  std::vector<Mark> marks{marks::band("folds", {0, 2, 1}, {.colour = Colour::sky, .opacity = 0.35}, "Unstable"),
                          marks::line("folds", {0, 1}, {Colour::blue, 0.8}),
                          marks::line("folds", {0, 3}, {.width = 1.2, .dash = Dash::dotted}, "End of travel")};
  if (is_finite) marks.push_back(marks::horizontal({k(own)}, {.width = 1.4}, gives ? "This rig" : "This load train"));
  if (std::isfinite(answer.critical) && answer.critical > 0)
    marks.push_back(marks::horizontal({k(answer.critical)}, {Colour::green, 1.4, Dash::dashed}, "Critical stiffness"));
  if (breaks) marks.push_back(marks::vertical({w(outcome.w_reached)}, {.width = 1.2}));
  marks.push_back(marks::points("first", {0, 1}, snap_mark));
  return {.name = "design",
          .title = "What a planned test will show",
          .caption = fmt::format(
              "(A) The record as it will be, force against stage displacement, its drops in red-orange. (B) By "
              "deflection, the stiffness {} below "
              "which the specimen snaps (blue area), beside that of this test (black) and the critical one (green, "
              "dashed), above which nothing "
              "snaps; dotted: with a softer one the travel ends before that deflection. Circle: the first snap.{}",
              gives ? "of the rig" : "of the load train",
              breaks ? " Cross and upright line: where the specimen breaks." : ""),
          .width = two_columns,
          .height = 70,
          .data = {record, falls_of(record), std::move(folds), std::move(first), std::move(end)},
          .panels = {{.title = "A",
                      .x = w.axis("Stage displacement *w*_s", 0, 1.02 * design.travel),
                      .y = F.axis(force_label, 0, 1.12 * outcome.greatest_force),
                      .marks = {marks::line("record", {0, 1}, {.width = 1.1}, "Record"),
                                marks::line("drops", {0, 1}, {Colour::vermillion, 1.5}, "Drops"),
                                marks::points("breaks", {0, 1}, {Colour::black, 1.6, Dash::solid, Symbol::cross, 5},
                                              "Breaks"),
                                marks::points("first", {2, 3}, snap_mark, "First snap")}},
                     {.title = "B",
                      .x = w.axis("Deflection *w*_0", 0, curves.folds.empty() ? design.travel : curves.folds.back().w),
                      .y = stiffness,
                      .marks = std::move(marks)}},
          .columns = 2};
}

Plot design_map_figure(const Test& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points) {
  if (axes.size() == 1) return curve_figure(input, axes.front(), points);
  if (axes.size() == 2) return plane_figure(input, axes, points);
  throw std::invalid_argument("a map has one axis or two, not " + std::to_string(axes.size()));
}

}  // namespace flexslip
