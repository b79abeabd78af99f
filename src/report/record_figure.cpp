#include "report/record_figure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bending_test/equilibrium.h"

namespace flexslip {

Figure record_figure(const FittedTest& test) {
  const auto& record = test.analysis.record;
  const auto& scales = test.analysis.scales;
  const auto [least, greatest] = std::minmax_element(record.force.begin(), record.force.end());
  const double deepest = *std::max_element(record.deflection.begin(), record.deflection.end());
  const PlotUnit length = plot_unit(deepest, kind_in(test.measurement.test, kind::length), test.reduced, "L");
  const PlotUnit force = plot_unit(std::max(std::abs(*least), std::abs(*greatest)),
                                   kind_in(test.measurement.test, kind::force), test.reduced, "EI/L^2");
  const double x = scales.physical_length(length.factor), y = scales.physical_force(force.factor);

  const std::string abscissa = fmt::format("deflection [{}]", length.unit),
                    ordinate = fmt::format("force [{}]", force.unit);
  FigureData measured{"measured", {abscissa, ordinate}, {}};
  for (std::size_t i = 0; i < record.force.size(); ++i)
    measured.rows.push_back({length.factor * record.deflection[i], force.factor * record.force[i]});
  FigureData references{"references", {abscissa, "Euler-Bernoulli " + ordinate, "frictionless " + ordinate}, {}};
  const double w_max = deepest / scales.span();
  for (const auto& point : sliding_up_to(w_max, 0, 200, test.analysis.rig.fibre))
    references.rows.push_back({x * point.w, y * 48 * point.w, y * point.F});

  const double from = std::min(0.0, 1.1 * force.factor * *least), to = 1.1 * force.factor * *greatest;
  return {
      .name = "record",
      .title = "Force against deflection: " + test.name,
      .description =
          "Measured force against deflection at midspan, with the Euler-Bernoulli line and the model without "
          "friction at the bending stiffness stated.",
      .width = two_columns,
      .height = 80,
      .data = {std::move(measured), std::move(references)},
      .script = fmt::format(
          R"(  set lmargin at screen 0.095; set rmargin at screen 0.985; set tmargin at screen 0.9; set bmargin at screen 0.15
  set xrange [0:{:.6g}]; set yrange [{:.6g}:{:.6g}]
  set xlabel '{}' offset 0,0.4; set ylabel '{}' offset 0.8
  set key at screen 0.535,0.99 center top vertical Left reverse maxrows 1 samplen 2.2
  set xzeroaxis lw 0.75 lt 1 lc rgb 'black'
  plot measured using 1:2 with linespoints lw 0.6 pt 7 ps 0.25 lc rgb blue title 'Measured', \
       references using 1:2 with lines lw 1 dt (14,7) lc rgb orange title 'Euler–Bernoulli', \
       references using 1:3 with lines lw 1 lc rgb orange title 'Model without friction'
  unset xzeroaxis
)",
          1.03 * length.factor * deepest, from, to, axis_label("Deflection at midspan", "{/:Italic w}_0", length),
          axis_label("Force", "{/:Italic F}", force))};
}

}  // namespace flexslip
