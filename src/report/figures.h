// The figures of all answers, in widths of journal columns. They draw the content of the answers
// and compute nothing.
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

// ---- A fitted test. Domain: analysis.status is ok, unless stated otherwise.

// Force against deflection with the simulated best-fit profile, reference curves and drops, as in
// Fig. 10 of the paper; residuals below.
Plot force_figure(const FittedTest& test);

// Friction along the specimen at the fitted bending stiffness: pointwise, with 95 % intervals, and
// the fit.
Plot profile_figure(const FittedTest& test);

// The evidence for a wave against its wavelength. Domain: has_waves.
Plot wavelength_figure(const FittedTest& test);
// a wave is detected, or a scanned one increases the evidence
bool has_waves(const FittedTest& test);

// A record that determines no friction: force against deflection, with its drops; and, if the model
// applies, the frictionless curve and the Euler-Bernoulli line at the stated bending stiffness.
// Domain: any status.
Plot record_figure(const FittedTest& test);

// The force of all passes of a test with unloading, and their friction. Domain: has_passes.
Plot passes_figure(const FittedTest& test);
Plot boxes_figure(const FittedTest& test);
bool has_passes(const FittedTest& test);

// ---- A campaign

// The names of tests as labels: without the words that all names begin or end with, at most 20
// characters, all different if the names are.
std::vector<std::string> labels_of(const std::vector<std::string>& names);

// Wavelength and friction of each test, sorted by category, with means and the range in the
// literature, as in Fig. 9 of the paper. `width` [mm] as in in_width, here and below.
// Domain:     has_friction; std::invalid_argument otherwise.
Plot distribution_figure(const Campaign& campaign, double width = two_columns);
bool has_friction(const Campaign& campaign);  // a test determines it

// The stiffness loss measured by a reload against the loss that the drops require if they are
// cracks only. Slips lie at zero, cracks on the diagonal. Domain: has_losses.
Plot losses_figure(const Campaign& campaign);
bool has_losses(const Campaign& campaign);  // a test with drops was loaded again

// The figures above that have something to show.
std::vector<Plot> comparison_figures(const Campaign& campaign, double width = two_columns);

// Force curves of all tests, as in Figs. 10 to 13, on pages of at most five rows of panels: clear,
// nominal, none, then the suspect tests again. Tests without curves have no panel.
std::vector<Plot> atlas_pages(const Campaign& campaign, double width = two_columns);

// ---- A planned test

// The expected record with its drops, and the stiffnesses at which the specimen is at a fold. The
// specimen snaps where the stiffness of the rig is below them.
Plot design_figure(const DesignAnswer& answer);

// Drops and first snap over one parameter; or the largest drop over two, with the border of
// snapping.
// Domain:     one or two axes, and their points; std::invalid_argument otherwise.
Plot design_map_figure(const Test& input, const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

// All equilibria of the specimen (--region) in three planes: deflection and force, length and
// deflection, length and force (Fig. 7). Otherwise the loading curve with the frictionless one and
// the Euler-Bernoulli line (Fig. 8A).
Plot equilibrium_figure(const EquilibriumStudy& study);

// A simulated test with dashed snaps: for one loading over the equilibrium curve (Fig. 8C),
// otherwise as loops, also in the plane of length and mobilised friction. Domain: a test with its
// path, here and below.
Plot simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks);

// The overall equilibria at some stage positions [L]: stable filled, unstable open, partially
// stable red; with load lines of the rig (Fig. 8B).
Plot equilibria_figure(const SimulatedTest& test, std::span<const double> stages);

// ---- Parts of several figures: marks with their own numbers, labels, the plane of force and
// deflection
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
  double w_max, F_max;  // in the unit of the answer

  PlotTable table(std::string name) const { return {std::move(name), {w.column("deflection"), F.column("force")}}; }
  // The points of a curve, without those too close to be distinguished.
  template <class Points>
  PlotTable curve(std::string name, const Points& points) const {
    PlotTable data = table(std::move(name));
    for (const auto& point : points) data.rows.push_back({w(point.w), F(point.F)});
    return thinned(std::move(data));
  }
  // Omits such points, except where a line begins, breaks or ends.
  PlotTable thinned(PlotTable data) const;
  // A load line between two forces, extended slightly on both sides, followed by a break.
  std::vector<std::vector<double>> load_line(double deflection, double before, double after, double stiffness) const;
  Axis x(double to, const char* label = "Deflection at midspan *w*_0") const { return w.axis(label, 0, to * w_max); }
  Axis y(double to) const { return F.axis(force_label, 0, to * F_max); }
};
ForcePlane force_plane(const PlotUnits& units, double w_max, double F_max);
PlotUnits plot_units(const FittedTest& test);
inline double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

// The sections of a path chosen by `belongs`, each with the point before it, as rows with breaks.
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
