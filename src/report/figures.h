// The figures of all answers, in journal column widths. None of them computes: what they draw is in the answers, or asked of those who made them.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "case/fitted.h"
#include "case/simulated_test.h"
#include "case/studies.h"
#include "design/design_answer.h"
#include "design/design_result.h"
#include "report/plot.h"

namespace flexslip {

// Of a fitted test. Domain: analysis.status is ok, unless they say otherwise.

// Force against deflection with the mean of the fit run forward, references and drops, as Fig. 10 of the paper; residuals below.
Plot force_figure(const FittedTest& test);

// Friction along the specimen, with its 95 % intervals, at the bending stiffness of the fit, and what the fit knows of it.
Plot profile_figure(const FittedTest& test);

// What a wave of each wavelength adds to the evidence. Domain: has_waves.
Plot wavelength_figure(const FittedTest& test);
bool has_waves(const FittedTest& test);  // is one claimed, or would any of those scanned add to the evidence?

// A record of which there is no fit, to look at: force against deflection, with what the bending stiffness stated would give with small
// deflections and without friction. Domain: analysis.status is not_explained.
Plot record_figure(const FittedTest& test);

// The force of all passes of a test that was unloaded, and the friction of each. Domain: has_passes.
Plot passes_figure(const FittedTest& test);
Plot boxes_figure(const FittedTest& test);
bool has_passes(const FittedTest& test);

// Wavelength and friction by test, a panel a category that there is, with the means and the literature's band, as Fig. 9 of the paper.
// Domain: at least one test has a summary; std::invalid_argument otherwise.
Plot distribution_figure(const Campaign& campaign);

// Stiffness lost to the next loading against the stiffness that the drops would need if they were cracks only: slips lie at zero, cracks on the diagonal.
// Domain: has_losses.
Plot losses_figure(const Campaign& campaign);
bool has_losses(const Campaign& campaign);  // was a test that has drops loaded again?

// Force curves of all tests, as Figs. 10 to 13, on pages of at most 20 panels: clear, nominal, none, then the suspect tests once more. A test
// without curves has no panel.
std::vector<Plot> atlas_pages(const Campaign& campaign);

// The record of a planned test as it will be, its drops marked, beside the stiffnesses on which the specimen is at a fold: where that of the rig
// is below them, it snaps.
Plot design_figure(const DesignAnswer& answer);

// Drops and the first snap over one parameter; or the largest drop over two, with the border of those that do not snap.
// Domain:     one or two axes, and their points; std::invalid_argument otherwise.
Plot design_map_figure(const Test& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

// All equilibria of the specimen in three spaces, if the study asks for the region: deflection and force, length and deflection, length and force
// (Fig. 7). Otherwise the curve along which it slides, with that of no friction and the Euler-Bernoulli line (Fig. 8A).
Plot equilibrium_figure(const EquilibriumStudy& study);

// What a test measures, its snaps dashed: over the equilibrium curve (Fig. 8C) if it only loads; otherwise its loops, beside the boxes that they
// are in length and mobilised friction. Domain: a test that was followed; likewise for the next.
Plot simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks);

// The overall equilibria at some stage positions [L]: stable ones filled, unstable ones open, partially stable ones in red; load lines
// of the rig through them (Fig. 8B).
Plot equilibria_figure(const SimulatedTest& test, std::span<const double> stages);

// A height trace, what an edge sees of it, its spectrum, and the friction that it predicts.

// What several of them have: marks with numbers of their own, labels, and force against deflection.
inline Mark level(double y, const Style& style, std::string title = {}) {
  return {.style = style, .title = std::move(title), .at = {-edge, y, edge, y}};
}
inline Mark upright(double x, const Style& style, std::string title = {}) {
  return {.style = style, .title = std::move(title), .at = {x, -edge, x, edge}};
}
inline Mark rectangle(double left, double low, double right, double high, const Style& style, std::string title = {}) {
  return {.kind = Mark::area, .style = style, .title = std::move(title), .at = {left, low, right, high}};
}
inline Mark spot(double x, double y, const Style& style, std::string title = {}) {
  return {.kind = Mark::points, .style = style, .title = std::move(title), .at = {x, y}};
}
inline Mark label(double x, double y, std::string words) {
  return {.kind = Mark::label, .title = std::move(words), .at = {x, y}};
}
inline constexpr const char* force_label = "Force *F*";
inline constexpr const char* slid_label = "Length slid over one support";
inline constexpr const char* friction_label = "Friction *μ*";

struct ForcePlane {
  PlotUnit w, F;
  double w_max, F_max;  // in the numbers of the answer

  PlotTable table(std::string name) const { return {std::move(name), {w.column("deflection"), F.column("force")}}; }
  // The points of a curve that can be told apart.
  template <class Points>
  PlotTable curve(std::string name, const Points& points) const {
    PlotTable data = table(std::move(name));
    for (const auto& point : points) data.rows.push_back({w(point.w), F(point.F)});
    return thinned(std::move(data));
  }
  // With those where a line begins, breaks and ends.
  PlotTable thinned(PlotTable data) const;
  // Of a drop between two forces, a little beyond it on both sides, and the break behind.
  std::vector<std::vector<double>> load_line(double deflection, double before, double after, double stiffness) const;
  Axis x(double to, const char* label = "Deflection at midspan *w*_0") const { return w.axis(label, 0, to * w_max); }
  Axis y(double to) const { return F.axis(force_label, 0, to * F_max); }
};
ForcePlane force_plane(const PlotUnits& units, double w_max, double F_max);
PlotUnits plot_units(const FittedTest& test);
inline double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

// The stretches of a path that `belongs` chooses, each from the point before it on, as rows with breaks.
template <class Points, class Belongs, class Row>
std::vector<std::vector<double>> stretches_of(const Points& path, Belongs belongs, Row row) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!belongs(path[i])) continue;
    if (i == 1 || !belongs(path[i - 1])) {
      if (!rows.empty()) rows.emplace_back();
      rows.push_back(row(path[i - 1]));
    }
    rows.push_back(row(path[i]));
  }
  return rows;
}

}  // namespace flexslip
