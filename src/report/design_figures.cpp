#include "report/design_figures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bending_test/readings.h"
#include "fibre/limits.h"
#include "io/quantity.h"
#include "result/frame.h"

namespace flexslip {
namespace {

constexpr double nan = not_a_number;

FigureData line_of(std::string name, const std::vector<RecordedForce>& readings, double x, double y,
                   bool falling_only) {
  FigureData data{std::move(name), {"stage", "force"}, {}};
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const bool falls = i > 0 && readings[i].F < readings[i - 1].F;
    if (falling_only && !falls) continue;
    if (falling_only && (i < 2 || !(readings[i - 1].F < readings[i - 2].F))) {
      if (!data.rows.empty()) data.rows.emplace_back();
      data.rows.push_back({x * readings[i - 1].stage, y * readings[i - 1].F});
    }
    data.rows.push_back({x * readings[i].stage, y * readings[i].F});
  }
  if (data.rows.empty()) data.rows.push_back({nan, nan});
  return data;
}

std::string capitalised(std::string_view words) {
  std::string text(words);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

// An axis of a map: what is drawn of its values, logarithms if it is logarithmic, because gnuplot's pixels are all of one size.
class Drawn {
 public:
  Drawn(const DesignCase& input, const DesignAxis& axis) {
    const auto& range = std::get<AxisRange>(axis.values);
    logarithmic_ = range.spacing == Spacing::logarithmic;
    const DesignParameterName& parameter = axis.parameter;
    const Kind kind = input.shown_as(parameter.kind);
    const auto [least, most] = std::minmax(range.from, range.to);
    unit_ = kind.units.empty()
                ? PlotUnit{"", 1}
                : plot_unit(logarithmic_ ? std::sqrt(least * most) : std::max(std::abs(least), std::abs(most)), kind,
                            input.reduced(), typeset(unit_of(kind, true)));
    label_ = axis_label(capitalised(parameter.description), parameter.symbol, unit_);
    low_ = unit_.factor * least;
    high_ = unit_.factor * most;
  }

  double operator()(double value) const {
    return logarithmic_ ? std::log10(unit_.factor * value) : unit_.factor * value;
  }
  const std::string& label() const { return label_; }

  // The commands that set range and tics of the axis "x" or "y", with a margin on both sides [1] of the range.
  std::string set(char name, double margin) const {
    const double from = logarithmic_ ? std::log10(low_) : low_;
    const double to = logarithmic_ ? std::log10(high_) : high_;
    std::string script =
        fmt::format("  set {}range [{:.8g}:{:.8g}]\n", name, from - margin * (to - from), to + margin * (to - from));
    if (!logarithmic_) return script;
    std::string tics;
    const auto digits = to - from < 2.2   ? std::vector{1.0, 2.0, 5.0}
                        : to - from < 3.2 ? std::vector{1.0, 3.0}
                                          : std::vector{1.0};
    for (int decade = static_cast<int>(std::floor(from)); decade <= to; ++decade)
      for (const double digit : digits)
        if (const double tic = decade + std::log10(digit); tic >= from - 1e-9 && tic <= to + 1e-9)
          tics += fmt::format("{}'{:g}' {:.8g}", tics.empty() ? "" : ", ", digit * std::pow(10, decade), tic);
    return script + fmt::format("  set {}tics ({})\n", name, tics);
  }

 private:
  bool logarithmic_;
  PlotUnit unit_;
  std::string label_;
  double low_, high_;
};

constexpr double stiffness_of_straight_fibre = 48;  // [EI/L^3]

double drop_share(const DesignOutcome& outcome) { return 100 * outcome.largest_drop / outcome.greatest_force; }

// [units of the case] of the first snap.
std::optional<double> first_deflection(const DesignResult& result) {
  const auto& snap = result.outcome->first_snap;
  return snap ? std::optional(result.units->scales.physical_length(snap->w)) : std::nullopt;
}

Figure curve_figure(const DesignCase& input, const DesignAxis& axis, const std::vector<MapPoint>& points) {
  const Drawn drawn(input, axis);
  double deepest = 0;
  double most = 1;
  for (const auto& point : points)
    if (const auto& outcome = point.result.outcome) {
      most = std::max({most, drop_share(*outcome), 100 * friction_share(*outcome)});
      deepest = std::max(deepest, first_deflection(point.result).value_or(0));
    }
  const PlotUnit length = plot_unit(deepest > 0 ? deepest : 1, input.shown_as(kind::length), input.reduced(), "L");
  FigureData data{
      "designs", {"parameter", "largest drop [%]", "mean drop [%]", "friction and snaps [%]", "first snap"}, {}};
  for (const auto& point : points) {
    if (!point.result.outcome) {
      data.rows.emplace_back();
      continue;
    }
    const DesignOutcome& outcome = *point.result.outcome;
    data.rows.push_back({drawn(point.values[0]), drop_share(outcome), 100 * outcome.mean_drop / outcome.greatest_force,
                         100 * friction_share(outcome), length.factor * first_deflection(point.result).value_or(nan)});
  }
  const std::string script = fmt::format(
      R"(  set multiplot
  set tmargin at screen 0.88; set bmargin at screen 0.16
  set key at screen 0.28,0.985 center top vertical Left reverse maxrows 1 width 1 samplen 2
  set lmargin at screen 0.095; set rmargin at screen 0.48
  set xlabel '{0}' offset 0,0.3
{1}  set yrange [0:{2:.6g}]
  set ylabel 'Share (%)' offset 1
  set label 1 '(A)' at graph 0.03, 0.94 font ',9'
  plot designs using 1:2 with lines lw 1.6 lc rgb 'black' title 'Largest drop', \
       designs using 1:3 with lines lw 1.2 dt (6,4) lc rgb 'black' title 'Mean drop', \
       designs using 1:4 with lines lw 1.6 lc rgb vermillion title 'Friction and snaps'
  unset key
  set lmargin at screen 0.58; set rmargin at screen 0.97
  set yrange [0:{3:.6g}]
  set ylabel '{4}' offset 0.6
  set label 1 '(B)'
  set label 2 '{5}' at graph 0.5, 0.5 center
  plot designs using 1:5 with points pt 7 ps 0.3 lc rgb blue
  unset multiplot; unset label 1; unset label 2
)",
      drawn.label(), drawn.set('x', 0), 1.15 * most, deepest > 0 ? 1.15 * length.factor * deepest : 1,
      axis_label("First snap at deflection", "{/:Italic w}_0", length), deepest > 0 ? "" : "None snaps");
  return {.name = "designs",
          .title = "What a test shows over a range",
          .description = fmt::format("Two panels over the {}: the largest and the mean drop of the force, as shares of "
                                     "the greatest force, and the share of friction in "
                                     "the work; and the deflection of the first snap.",
                                     axis.parameter.name),
          .width = two_columns,
          .height = 66,
          .data = {std::move(data)},
          .script = script};
}

// Where the margin vanishes: on the edges of the grid's cells, and straight between them.
FigureData border_of(const std::vector<MapPoint>& points, std::size_t rows, std::size_t columns, const Drawn& x,
                     const Drawn& y) {
  FigureData border{"border", {"x", "y"}, {}};
  const auto at = [&](std::size_t i, std::size_t j) -> const MapPoint& { return points[i * columns + j]; };
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const std::array corners{&at(i, j), &at(i + 1, j), &at(i + 1, j + 1), &at(i, j + 1), &at(i, j)};
      std::vector<std::vector<double>> crossings;
      for (std::size_t c = 0; c < 4; ++c) {
        const double a = corners[c]->margin;
        const double b = corners[c + 1]->margin;
        if (std::isnan(a) || std::isnan(b) || (a > 0) == (b > 0)) continue;
        const double share = a / (a - b);
        const auto between = [&](const Drawn& axis, std::size_t k) {
          const double from = axis(corners[c]->values[k]);
          return from + share * (axis(corners[c + 1]->values[k]) - from);
        };
        crossings.push_back({between(x, 0), between(y, 1)});
      }
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
        border.rows.push_back(crossings[c]);
        border.rows.push_back(crossings[c + 1]);
        border.rows.emplace_back();
      }
    }
  if (border.rows.empty()) border.rows.push_back({nan, nan});
  return border;
}

// The cell of a map where the test itself lies, or that is nearest to it.
std::size_t cell_of(const std::vector<double>& own, const std::vector<MapPoint>& points, const Drawn& x,
                    const Drawn& y) {
  const auto away = [&](const MapPoint& point) {
    return std::abs(std::log(x(point.values[0]) / own[0])) + std::abs(y(point.values[1]) - own[1]) / std::abs(own[1]);
  };
  const auto nearest = std::min_element(points.begin(), points.end(),
                                        [&](const MapPoint& a, const MapPoint& b) { return away(a) < away(b); });
  return static_cast<std::size_t>(nearest - points.begin());
}

// The command for a label where the points of a side are farthest from others, from the test itself and from the frame; none if there is
// no room.
template <class Belongs>
std::string side_label(int tag, std::string_view words, const std::vector<MapPoint>& points, std::size_t columns,
                       const Drawn& x, const Drawn& y, std::size_t taken, Belongs belongs) {
  constexpr int room = 3;  // [cells]
  const std::size_t rows = points.size() / columns;
  std::vector<int> depth(points.size(), 0);  // [cells] to the nearest that does not belong
  const auto at = [&](std::size_t i, std::size_t j) { return i < rows && j < columns ? depth[i * columns + j] : 0; };
  for (std::size_t n = 0; n < points.size(); ++n)  // indices below 0 are large
    if (n != taken && belongs(points[n].margin))
      depth[n] = 1 + std::min(at(n / columns - 1, n % columns), at(n / columns, n % columns - 1));
  for (std::size_t n = points.size(); n-- > 0;)
    depth[n] = std::min(depth[n], 1 + std::min(at(n / columns + 1, n % columns), at(n / columns, n % columns + 1)));
  const auto deepest = std::max_element(depth.begin(), depth.end());
  if (*deepest < room) return "";
  const MapPoint& there = points[static_cast<std::size_t>(deepest - depth.begin())];
  return fmt::format("  set label {} '{}' at {:.8g}, {:.8g} center front boxed\n", tag, words, x(there.values[0]),
                     y(there.values[1]));
}

Figure plane_figure(const DesignCase& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points) {
  const Drawn x(input, axes[0]);
  const Drawn y(input, axes[1]);
  FigureData data{"designs", {"x", "y", "largest drop [%]"}, {}};
  for (const MapPoint& point : points)
    data.rows.push_back(
        {x(point.values[0]), y(point.values[1]), point.result.outcome ? drop_share(*point.result.outcome) : nan});
  FigureData own{
      "own", {"x", "y"}, {{x(input.value(axes[0].parameter.parameter)), y(input.value(axes[1].parameter.parameter))}}};
  const std::size_t taken = cell_of(own.rows.front(), points, x, y), columns = points_of(axes[1]);
  const std::string sides =
      side_label(2, "snaps", points, columns, x, y, taken, [](double margin) { return margin < 0; }) +
      side_label(3, "no snap", points, columns, x, y, taken, [](double margin) { return margin > 0; });
  FigureData border = border_of(points, points_of(axes[0]), columns, x, y);
  const bool has_border = border.rows.size() > 1;
  const std::string script = fmt::format(
      R"(  set lmargin at screen 0.13; set rmargin at screen 0.80; set tmargin at screen 0.89; set bmargin at screen 0.145
  set key at screen 0.465,0.985 center top vertical Left reverse maxrows 1 samplen 2.2
  set xlabel '{0}' offset 0,0.3; set ylabel '{1}' offset 0.8
{2}{3}  set cblabel 'Largest drop (% of the greatest force)' offset 0.5
  set cbrange [0:*]
  set palette defined (0 '#FFFFFF', 0.005 '#EAF2F8', 0.3 '#9CC9E6', 0.65 '#2F83BE', 1 '#08306B')
  set colorbox user origin screen 0.83, 0.145 size screen 0.03, 0.745
  set tics front
  set style textbox opaque noborder margins 0.6, 0.6
{4}  plot designs using 1:2:3 with image pixels notitle, \
       {5}own using 1:2 with points pt 7 ps 0.7 lc rgb 'black' title 'This test'
)",
      x.label(), y.label(), x.set('x', 0.5 / static_cast<double>(points_of(axes[0]) - 1)),
      y.set('y', 0.5 / static_cast<double>(points_of(axes[1]) - 1)), sides,
      has_border ? "border using 1:2 with lines lw 2 lc rgb vermillion title 'Border of snapping', \\\n       " : "");
  return {.name = "designs",
          .title = "Where a test shows a sawtooth",
          .description = fmt::format(
              "The largest drop of the force over {} and {}, with the border beyond which the specimen does not snap.",
              axes[0].parameter.name, axes[1].parameter.name),
          .width = 110,
          .height = 85,
          .data = {std::move(data), std::move(border), std::move(own)},
          .script = script};
}

}  // namespace

Figure design_figure(const DesignAnswer& answer) {
  const Design& design = answer.design;
  const Scales& scales = answer.scales;
  const bool reduced = answer.input.reduced();
  const DesignOutcome& outcome = answer.outcome;
  const PlotUnit length =
      plot_unit(scales.physical_length(design.travel), answer.input.shown_as(kind::length), reduced, "L");
  const PlotUnit force =
      plot_unit(scales.physical_force(outcome.greatest_force), answer.input.shown_as(kind::force), reduced, "EI/L²");
  const double x = scales.physical_length(length.factor);
  const double y = scales.physical_force(force.factor);

  const bool breaks = outcome.status == DesignStatus::breaks;
  const auto readings =
      record_of({design.friction, design.rig}, breaks ? outcome.stage_reached : design.travel, design.step);
  const auto folds = folds_up_to(design.friction, design.travel, design.rig.fibre);
  double top = std::isfinite(design.rig.stiffness) ? design.rig.stiffness : 0;
  for (const auto& fold : folds) top = std::max(top, std::min(fold.stiffness, 1e6));
  if (std::isfinite(answer.critical)) top = std::max(top, answer.critical);
  if (top == 0) top = stiffness_of_straight_fibre;  // displacement control, and no rig snaps
  // The rig may be far from where it matters.
  constexpr double wide = 20;
  const double own = std::isfinite(design.rig.stiffness) ? design.rig.stiffness : top;
  const double least = answer.critical > 0 ? std::min(own, answer.critical) : own;
  const bool is_wide = top > wide * least;
  const PlotUnit stiffness =
      plot_unit(scales.physical_stiffness(top), answer.input.shown_as(kind::stiffness), reduced, "EI/L³");
  const double z = scales.physical_stiffness(stiffness.factor);

  // On a rig softer than F/(travel - w) the loading ends before this deflection.
  FigureData curve{"folds", {"deflection", "stiffness", "softest that gets there"}, {}};
  for (const auto& fold : folds)
    curve.rows.push_back({x * fold.w, z * fold.stiffness, z * fold.F / (design.travel - fold.w)});
  if (curve.rows.empty()) curve.rows.push_back({nan, nan, nan});
  FigureData end{"breaks", {"stage", "force", "deflection", "stiffness"}, {}};
  end.rows.push_back(breaks ? std::vector{x * outcome.stage_reached,
                                          y * (outcome.stage_reached - outcome.w_reached) * design.rig.stiffness,
                                          x * outcome.w_reached, 10 * z * top}
                            : std::vector(4, nan));
  FigureData first{"first", {"deflection", "stiffness", "stage", "force"}, {}};
  if (outcome.first_snap)
    first.rows.push_back({x * outcome.first_snap->w, z * std::min(design.rig.stiffness, top),
                          x * outcome.first_snap->stage, y * outcome.first_snap->F_before});
  else
    first.rows.push_back({nan, nan, nan, nan});

  const double right = x * (folds.empty() ? design.travel : folds.back().w);
  const bool gives =
      answer.input.support_compliance() > 0;  // then the stiffness is that of load train and supports together
  std::string lines;
  if (std::isfinite(design.rig.stiffness))
    lines += fmt::format("{:.8g} with lines lw 1.4 lc rgb 'black' title '{}', \\\n       ", z * design.rig.stiffness,
                         gives ? "This rig" : "This load train");
  if (std::isfinite(answer.critical) && answer.critical > 0)
    lines += fmt::format("{:.8g} with lines lw 1.4 dt (7,4) lc rgb green title 'Critical stiffness', \\\n       ",
                         z * answer.critical);
  const std::string script = fmt::format(
      R"(  set multiplot
  set tmargin at screen 0.825; set bmargin at screen 0.185
  set lmargin at screen 0.075; set rmargin at screen 0.475
  set key at screen 0.275,0.985 center top vertical Left reverse maxrows 1 width 0 samplen 1.6
  set xrange [0:{0:.6g}]; set yrange [0:{1:.6g}]
  set xlabel '{2}' offset 0,0.3; set ylabel '{3}' offset 0.9
  set label 1 '(A)' at graph 0.03, 0.94 font ',9'
  plot record using 1:2 with lines lw 1.1 lc rgb 'black' title 'Record', \
       drops using 1:2 with lines lw 1.5 lc rgb vermillion {9}, \
       breaks using 1:2 with points pt 2 ps 0.8 lw 1.6 lc rgb 'black' {13}, \
       first using 3:4 with points pt 6 ps 0.7 lw 1 lc rgb vermillion {10}
  set lmargin at screen 0.58; set rmargin at screen 0.985
  set key at screen 0.79,0.985 center top vertical Left reverse maxrows 2 width 0 samplen 1.6
  set xrange [0:{4:.6g}]; set yrange [{11}:{5:.6g}]{12}
  set xlabel '{6}'; set ylabel '{7}' offset 0.6
  set label 1 '(B)'
  plot folds using 1:($2 > {11} ? $2 : {11}) with filledcurves above y1={11} fs solid 0.35 noborder lc rgb sky title 'Unstable', \
       folds using 1:2 with lines lw 0.8 lc rgb blue notitle, \
       folds using 1:3 with lines lw 1.2 dt (2,3) lc rgb 'black' title 'End of travel', \
       {8}breaks using 3:4 with impulses lw 1.2 lc rgb 'black' notitle, \
       first using 1:2 with points pt 6 ps 0.7 lw 1 lc rgb vermillion notitle
  unset multiplot; unset label 1; unset logscale
)",
      1.02 * x * design.travel, 1.15 * y * outcome.greatest_force,
      axis_label("Stage displacement", "{/:Italic w}_s", length), axis_label("Force", "{/:Italic F}", force), right,
      (is_wide ? 2 : 1.12) * z * top, axis_label("Deflection", "{/:Italic w}_0", length),
      axis_label(gives ? "Stiffness of the rig" : "Load-train stiffness", "{/:Italic k}", stiffness), lines,
      outcome.drops > 0 ? "title 'Drops'" : "notitle", outcome.first_snap ? "title 'First snap'" : "notitle",
      fmt::format("{:.6g}", is_wide ? z * least / 3 : 0), is_wide ? "; set logscale y" : "",
      breaks ? "title 'Breaks'" : "notitle");
  return {.name = "design",
          .title = "What a planned test will show",
          .description = fmt::format("Two panels: the record of force against stage displacement, with {} drops "
                                     "marked; and the load-train stiffnesses below which "
                                     "the specimen snaps, against deflection, with that of the rig, the critical one, "
                                     "and those with which the travel ends there.{}",
                                     outcome.drops, breaks ? " A cross, and a line, where the specimen breaks." : ""),
          .width = two_columns,
          .height = 70,
          .data = {line_of("record", readings, x, y, false), line_of("drops", readings, x, y, true), std::move(curve),
                   std::move(first), std::move(end)},
          .script = script};
}

Figure design_map_figure(const DesignCase& input, const std::vector<DesignAxis>& axes,
                         const std::vector<MapPoint>& points) {
  if (axes.size() == 1) return curve_figure(input, axes.front(), points);
  if (axes.size() == 2) return plane_figure(input, axes, points);
  throw std::invalid_argument("a map has one axis or two, not " + std::to_string(axes.size()));
}

}  // namespace flexslip
