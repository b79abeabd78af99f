#include "report/teeth_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace flexslip {

Figure teeth_figure(const FittedTest& test) {
  const Teeth& judged = *test.analysis.teeth;
  const auto& scales = test.analysis.scales;
  const PlotUnit unit =
      plot_unit(0.02 * scales.span(), kind_in(test.measurement.test, kind::length), test.reduced, "L");
  const auto drawn_in = [&](double S) { return unit.factor * scales.physical_length(S - 1) / 2; };
  const double least_share = test.provenance.options.teeth.least_share;

  const std::string length = fmt::format("drawn in over one support [{}]", unit.unit);
  const std::vector<std::string> titles{
      length, "begin", "end", "position p", "noise error", "error common to all", "p if compliant"};
  FigureData sliding{"sliding", titles, {}}, sticking{"sticking", titles, {}}, undecided{"undecided", titles, {}};
  FigureData all{"teeth", titles, {}};
  double lowest = -0.2, highest = 1.15, first = INFINITY, last = 0;
  for (const Tooth& tooth : judged.teeth) {
    if (!std::isfinite(tooth.S_begin) || !std::isfinite(tooth.S_end)) continue;
    const double begin = drawn_in(tooth.S_begin);
    const double end = drawn_in(tooth.S_end);
    first = std::min({first, begin, end});
    last = std::max({last, begin, end});
    const double bar = 2 * std::hypot(tooth.position.standard_error, tooth.position_systematic);
    lowest = std::min(lowest, tooth.position.value - bar - 0.05);
    highest = std::max(highest, tooth.position.value + bar + 0.05);
    const std::vector<double> row{0.5 * (begin + end),
                                  begin,
                                  end,
                                  tooth.position.value,
                                  tooth.position.standard_error,
                                  tooth.position_systematic,
                                  tooth.compliant_position};
    all.rows.push_back(row);
    (tooth.verdict == ToothVerdict::sliding       ? sliding
     : tooth.verdict == ToothVerdict::as_if_stuck ? sticking
                                                  : undecided)
        .rows.push_back(row);
  }
  if (all.rows.empty()) first = 0, last = 1;
  const bool is_compliant = judged.compliance.status == ComplianceStatus::ok;
  const auto title = [](const FigureData& data, const char* words) {
    return data.rows.empty() ? std::string() : fmt::format(" title '{}'", words);
  };
  const std::vector<double> nothing(titles.size(), NAN);
  const std::string script = fmt::format(
      R"(  set lmargin at screen 0.095; set rmargin at screen 0.985; set tmargin at screen 0.86; set bmargin at screen 0.17
  set xrange [{x_min:.6g}:{x_max:.6g}]
  set yrange [{bottom:.6g}:{top:.6g}]
  set xlabel '{label}' offset 0,0.4
  set ylabel 'Position {{/:Italic p}} between slide and stick' offset 0.8
  set key at screen 0.535,0.985 center top vertical Left reverse maxrows 2 samplen 1.8 width -3
  set object 1 rectangle from graph 0, first {stuck} to graph 1, graph 1 behind fc rgb orange fs transparent solid 0.16 noborder
  set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lw 0.75 lc rgb 'black'
  set arrow 2 from graph 0, first 0 to graph 1, first 0 nohead lw 0.75 lc rgb 'black'
  set label 1 'stuck' at graph 0.008, first 1 offset 0,0.45
  set label 3 'from here on as if stuck' at graph 0.008, first {stuck} offset 0,0.5
  set label 2 'sliding, friction constant' at graph 0.008, first 0 offset 0,-0.6
  # 95 % of a normal distribution: 1.96 standard deviations; the wide bars are common to all teeth
  plot teeth using 1:($4-1.96*$6):(0):(2*1.96*$6) with vectors nohead lw 4 lc rgb '#c8c8c8' title '95 %: common to all', \
       teeth using 1:($4-1.96*$5):(0):(2*1.96*$5) with vectors nohead lw 0.8 lc rgb 'black' title '95 %: noise', \
       teeth using 2:4:($3-$2):(0) with vectors nohead lw 0.8 lc rgb grey, \
       sliding using 1:4 with points pt 7 ps 0.55 lc rgb blue{sliding}, \
       sticking using 1:4 with points pt 5 ps 0.55 lc rgb vermillion{sticking}, \
       undecided using 1:4 with points pt 6 ps 0.6 lw 1.2 lc rgb 'black'{undecided}, \
       teeth using 1:7 with points pt 2 ps 0.45 lw 0.8 lc rgb green{compliant}
  unset object 1; unset arrow 1; unset arrow 2; unset label 1; unset label 2; unset label 3
)",
      fmt::arg("x_min", first - 0.04 * (last - first)), fmt::arg("x_max", last + 0.03 * (last - first)),
      fmt::arg("bottom", std::max(lowest, -1.5)), fmt::arg("top", std::min(highest, 2.0)),
      fmt::arg("label", drawn_in_label(unit)), fmt::arg("stuck", 1 - least_share),
      fmt::arg("sliding", title(sliding, "slides")), fmt::arg("sticking", title(sticking, "as if stuck")),
      fmt::arg("undecided", title(undecided, "undecided")),
      fmt::arg("compliant", is_compliant ? " title 'if stuck, compliant'" : ""));
  const std::string described = fmt::format(
      "Position between sliding (0) and sticking (1) of {} rises between drops, along the specimen: {} slide, {} "
      "are as if stuck, {} undecided.",
      judged.teeth.size(), sliding.rows.size(), sticking.rows.size(), undecided.rows.size());
  for (FigureData* data : {&sliding, &sticking, &undecided, &all})
    if (data->rows.empty()) data->rows.push_back(nothing);
  return {.name = "teeth",
          .title = "Stick or slide between the drops: " + test.name,
          .description = described,
          .width = two_columns,
          .height = 80,
          .data = {std::move(all), std::move(sliding), std::move(sticking), std::move(undecided)},
          .script = script};
}

}  // namespace flexslip
