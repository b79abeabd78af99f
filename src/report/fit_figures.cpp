#include "report/fit_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "bending_test/equilibrium.h"
#include "inference/process_search.h"
#include "report/fit_words.h"

namespace flexslip {
namespace {

// The units in which one test is plotted.
struct TestUnits {
  PlotUnit length, small_length, force;
  double per_length, per_force;  // from reduced to plotted
  double per_small_length;
};

TestUnits units_of(const FittedTest& test) {
  const auto& record = test.analysis.record;
  const auto& scales = test.analysis.scales;
  const double deepest = *std::max_element(record.deflection.begin(), record.deflection.end());
  const double greatest = *std::max_element(record.force.begin(), record.force.end());
  TestUnits units{plot_unit(deepest, kind_in(test.measurement.test, kind::length), test.reduced, "L"),
                  plot_unit(0.02 * scales.span(), kind_in(test.measurement.test, kind::length), test.reduced, "L"),
                  plot_unit(greatest, kind_in(test.measurement.test, kind::force), test.reduced, "EI/L^2"),
                  0,
                  0,
                  0};
  units.per_length = scales.physical_length(units.length.factor);
  units.per_small_length = scales.physical_length(units.small_length.factor);
  units.per_force = scales.physical_force(units.force.factor);
  return units;
}

// The mean of the fit, continuously, at its bending stiffness; forces in nominal units.
History drawn_model(const FittedTest& test) {
  constexpr int points = 1000;  // on each stable part: most are thinned out
  const auto& fit = test.analysis.fit;
  const double stiffening = fit.bending_stiffness.value;
  const auto& stage = test.analysis.reduced.stage;
  const double farthest = *std::max_element(stage.begin(), stage.end());
  History history = follow_continuously(
      {Friction::as_met(fit.mean), Rig{test.analysis.rig.stiffness / stiffening, test.analysis.rig.fibre}},
      {&farthest, 1}, points);
  for (auto& point : history.path) point.F *= stiffening;
  return history;
}

}  // namespace

Figure force_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& record = analysis.reduced;
  const auto& fit = analysis.fit;
  const double stiffening = fit.bending_stiffness.value;
  const TestUnits units = units_of(test);
  const double x = units.per_length;
  const double y = units.per_force;
  const std::string length = fmt::format("deflection [{}]", units.length.unit);
  const std::string force = fmt::format("force [{}]", units.force.unit);
  const double w_max = *std::max_element(record.deflection.begin(), record.deflection.end());
  const double F_max = *std::max_element(record.force.begin(), record.force.end());

  FigureData measured{
      "measured", {length, force, fmt::format("residual [{}]", units.force.unit), "on the fibre that is fitted"}, {}};
  double largest_residual = 0;
  for (std::size_t i = 0; i < fit.force.size(); ++i) {
    const double residual = record.force[i] - fit.force[i];
    largest_residual = std::max(largest_residual, std::abs(residual));
    const bool seen = i < analysis.model.path.size() && analysis.model.path[i].S >= fit.S_begin;
    measured.rows.push_back({x * record.deflection[i], y * record.force[i], y * residual, seen ? 1.0 : 0.0});
  }

  FigureData sliding{"sliding", {length, force}, {}};
  FigureData snaps{"snaps", {length, force}, {}};
  const auto history = drawn_model(test);
  for (const auto& point : history.path) {
    if (point.motion == Motion::snap && !sliding.rows.empty()) {
      snaps.rows.push_back(sliding.rows.back());
      snaps.rows.push_back({x * point.w, y * point.F});
      snaps.rows.emplace_back();
      sliding.rows.emplace_back();
    }
    sliding.rows.push_back({x * point.w, y * point.F});
  }
  sliding.rows = thinned(sliding.rows, x * w_max, y * F_max);
  if (snaps.rows.empty()) snaps.rows.push_back({NAN, NAN});

  FigureData references{"references", {length, "Euler-Bernoulli " + force, "frictionless " + force}, {}};
  for (const auto& point : sliding_up_to(w_max, 0, 200, analysis.rig.fibre))
    references.rows.push_back({x * point.w, y * stiffening * 48 * point.w, y * stiffening * point.F});

  // Load lines reach a little beyond the drops on both sides.
  FigureData drops{"drops", {length, force}, {}};
  const double beyond = 0.07 * F_max;
  for (const auto& drop : analysis.drops.drops) {
    const double above = record.force[drop.before] + 0.3 * beyond;
    const double below = std::max(record.force[drop.after] - beyond, 0.0);
    const auto on_line = [&](double F) {
      return record.deflection[drop.before] - (F - record.force[drop.before]) / analysis.rig.stiffness;
    };
    drops.rows.push_back({x * on_line(above), y * above});
    drops.rows.push_back({x * on_line(below), y * below});
    drops.rows.emplace_back();
  }
  const bool has_drops = !drops.rows.empty();
  if (!has_drops) drops.rows.push_back({NAN, NAN});

  const std::string script = fmt::format(
      R"(  set multiplot
  set lmargin at screen 0.095; set rmargin at screen 0.985
  set xrange [0:{x_max:.6g}]
  # The curves
  set tmargin at screen 0.895; set bmargin at screen 0.33
  set yrange [0:{y_max:.6g}]
  set format x ''; unset xlabel
  set ylabel '{force}' offset 0.8
  set key at screen 0.535,0.99 center top vertical Left reverse maxrows 2 samplen 2.2 width -2
  plot keyentry with linespoints lw 0.6 pt 7 ps 0.25 lc rgb blue title 'Measured', \
       drops using 1:2 with lines lw 0.6 dt (6,4) lc rgb grey{drops_title}, \
       references using 1:2 with lines lw 1 dt (14,7) lc rgb orange title 'Euler–Bernoulli', \
       references using 1:3 with lines lw 1 lc rgb orange title 'Model without friction', \
       measured using 1:2 with linespoints lw 0.6 pt 7 ps 0.25 lc rgb blue, \
       sliding using 1:2 with lines lw 1.1 lc rgb 'black' title 'Mean of the fit', \
       snaps using 1:2 with lines lw 1 dt (8,5) lc rgb 'black'{snaps_title}
  # What the model leaves over
  set tmargin at screen 0.305; set bmargin at screen 0.112
  set yrange [{r_min:.6g}:{r_max:.6g}]
  set ytics {r_step:.6g}; set mytics 2
  set format x '%g'
  set xlabel '{length}' offset 0,0.4
  unset ylabel  # which would stand the farther left the longer the numbers are
  set label 1 'Residual ({force_unit})' at screen 0.015,0.2085 center rotate by 90
  set xzeroaxis lw 0.75 lt 1 lc rgb 'black'
  plot measured using ($4==1?$1:NaN):3 with points pt 7 ps 0.25 lc rgb blue, \
       measured using ($4==0?$1:NaN):3 with points pt 7 ps 0.25 lc rgb grey
  unset multiplot; unset xzeroaxis; unset label 1; set ytics auto
)",
      fmt::arg("x_max", x * w_max * 1.03), fmt::arg("y_max", y * F_max * 1.12),
      fmt::arg("force", axis_label("Force", "{/:Italic F}", units.force)),
      fmt::arg("length", axis_label("Deflection at midspan", "{/:Italic w}_0", units.length)),
      fmt::arg("force_unit", units.force.unit),
      fmt::arg("drops_title", has_drops ? " title 'Drops, slope −{/:Italic k}_c'" : ""),
      fmt::arg("snaps_title", history.snaps.empty() ? "" : " title 'Its snaps'"),
      fmt::arg("r_min", -y * 1.15 * largest_residual), fmt::arg("r_max", y * 1.15 * largest_residual),
      fmt::arg("r_step", tick_within(std::max(y * largest_residual, 1e-12))));
  return {
      .name = "force",
      .title = "Force against deflection: " + test.name,
      .description = fmt::format(
          "Measured force against deflection at midspan with the mean of the fit run forward, the Euler-Bernoulli line "
          "and the model without friction; {} drops are marked by load lines. Below, measured force less model.",
          analysis.drops.drops.size()),
      .width = two_columns,
      .height = 114,
      .data = {std::move(measured), std::move(sliding), std::move(snaps), std::move(references), std::move(drops)},
      .script = script};
}

Figure profile_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  const TestUnits units = units_of(test);
  const auto drawn_in = [&](double S) { return units.per_small_length * (S - 1) / 2; };
  const std::string position = fmt::format("drawn in over one support [{}]", units.small_length.unit);
  const auto& profile = analysis.profile_at_fit;

  FigureData measured{"profile", {position, "mu", "mu error of the point", "mu error common to all"}, {}};
  double S_end = fit.S_end;
  const auto literature = literature_of(test);
  double highest = literature ? literature->high : 0.5;
  double lowest = 0;
  for (const auto& point : profile.points) {
    const double common = std::hypot(point.from_bending_stiffness, point.from_contact);
    measured.rows.push_back({drawn_in(point.S), point.mu, point.from_force, common});
    S_end = std::max(S_end, point.S);
    highest = std::max(highest, point.mu);
    if (point.S > 1 + 0.2 * (profile.points.back().S - 1)) lowest = std::min(lowest, point.mu);
  }

  FigureData slips{"slips", {position, "mu"}, {}};
  const auto& slipped = analysis.slips;
  for (const auto& slip : slipped) {
    slips.rows.push_back({drawn_in(slip.S_before), slip.mu_before});
    slips.rows.push_back({drawn_in(slip.S_after), slip.mu_after});
    slips.rows.emplace_back();
  }
  if (slipped.empty()) slips.rows.push_back({NAN, NAN});

  FigureData imaged{"imaged", {position, "mu"}, {}};
  if (test.imaged) {
    auto point = profile.points.begin();
    for (const auto& seen : test.imaged->points) {
      while (point->index < seen.index) ++point;
      imaged.rows.push_back({drawn_in(1 + seen.imaged), point->mu});
    }
  }
  const bool is_imaged = !imaged.rows.empty();
  if (!is_imaged) imaged.rows.push_back({NAN, NAN});

  FigureData band{"band", {position, "mu", "mu deviation"}, {}};
  for (std::size_t i = 0; i < fit.band.S.size(); ++i)
    band.rows.push_back({drawn_in(fit.band.S[i]), fit.band.mean[i], fit.band.deviation[i]});

  // The wave claimed, about the mean and its drift.
  FigureData wave{"wave", {position, "mu"}, {}};
  if (fit.wave_claimed) {
    constexpr double points_a_period = 24;
    double shortest = fit.S_end - fit.S_begin;
    for (const auto& each : fit.waves) shortest = std::min(shortest, 2 * each.wavelength.value);  // a period in S
    const int points =
        static_cast<int>(std::clamp(points_a_period * (fit.S_end - fit.S_begin) / shortest, 100.0, 20000.0));
    for (int i = 0; i <= points; ++i) {
      const double S = fit.S_begin + (fit.S_end - fit.S_begin) * i / points;
      const double away = fit.between_contacts(S) - fit.S_middle;
      double mu = fit.mu0.value + fit.drift.value * away;
      for (const auto& each : fit.waves)
        mu += fit.mu0.value * each.amplitude.value *
              std::cos(std::numbers::pi * away / each.wavelength.value + each.phase_at_middle.value);
      wave.rows.push_back({drawn_in(S), mu});
    }
  } else {
    wave.rows.push_back({NAN, NAN});
  }

  constexpr double step = 0.2;  // of the ticks of friction
  const double top = std::min(step * std::ceil(1.05 * highest / step), 2.0);
  const std::string script = fmt::format(
      R"(  set lmargin at screen 0.095; set rmargin at screen 0.985; set tmargin at screen 0.86; set bmargin at screen 0.145
  set xrange [0:{x_max:.6g}]
  set yrange [{bottom:.6g}:{top:.6g}]
  set xlabel '{label}' offset 0,0.4
  set ylabel 'Coefficient of friction {{/:Italic μ}}' offset 0.8
  set key at screen 0.535,0.985 center top vertical Left reverse maxrows 2 samplen 1.8 width -2
{literature}  # 95 % of a normal distribution: 1.96 standard deviations
  plot band using 1:($2-2*$3):($2+2*$3) with filledcurves lc rgb '#909090' fs transparent solid 0.35 noborder \
            title 'Mean ± 2 deviations', \
       band using 1:2 with lines lw 1.1 lc rgb 'black' title 'Mean of the fit', \
       wave using 1:2 with lines lw 0.9 lc rgb orange{wave_title}, \
       imaged using 1:2 with points pt 6 ps 0.3 lw 0.6 lc rgb '#606060'{imaged_title}, \
       slips using 1:2 with lines lw 0.7 lc rgb vermillion{slips_title}, \
       profile using 1:($2-1.96*$3):(0):(2*1.96*$3) with vectors nohead lw 0.5 lc rgb blue notitle, \
       profile using 1:2 with points pt 7 ps 0.25 lc rgb blue title 'Measured, 95 %'{literature_title}
  unset object 1
)",
      fmt::arg("x_max", drawn_in(S_end) * 1.02), fmt::arg("bottom", lowest < 0 ? -rounded_up(-lowest) : 0.0),
      fmt::arg("top", top), fmt::arg("label", drawn_in_label(units.small_length)),
      fmt::arg("literature",
               literature
                   ? fmt::format(
                         "  set object 1 rectangle from graph 0, first {} to graph 1, first {} behind fc rgb green fs "
                         "transparent solid 0.13 {}\n",
                         literature->low, literature->high,
                         literature->low < literature->high ? "noborder" : "border lc rgb green")
                   : std::string()),
      fmt::arg(
          "literature_title",
          literature
              ? fmt::format(
                    ", \\\n       keyentry with filledcurves lc rgb green fs transparent solid 0.13 noborder title "
                    "'Literature: {} on {}'",
                    literature->specimen, literature->support)
              : std::string()),
      fmt::arg("wave_title", fit.wave_claimed ? " title 'Wave'" : ""),
      fmt::arg("imaged_title", is_imaged ? " title 'Length as imaged'" : " notitle"),
      fmt::arg("slips_title", slipped.empty() ? "" : " title 'Slips'"));
  return {.name = "profile",
          .title = "Friction along the specimen: " + test.name,
          .description = fmt::format(
              "Coefficient of friction against the length drawn in over one support: {} measured points with "
              "their 95 % intervals, {} slips, and the mean of the fit with a band of two standard deviations{}.",
              profile.points.size(), slipped.size(), fit.wave_claimed ? ", and the wave claimed" : ""),
          .width = two_columns,
          .height = 78,
          .data = {std::move(measured), std::move(slips), std::move(imaged), std::move(band), std::move(wave)},
          .script = script};
}

Figure wavelength_figure(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const TestUnits units = units_of(test);
  const std::string wavelength = fmt::format("wavelength [{}]", units.small_length.unit);
  FigureData gains{"gains", {wavelength, "gain of log-evidence"}, {}};
  double highest = 1.5 * claiming_gain, lowest = 0;
  for (const auto& at : fit.scan) {
    gains.rows.push_back({units.per_small_length * at.wavelength, at.gain});
    highest = std::max(highest, at.gain);
    lowest = std::min(lowest, at.gain);
  }
  lowest = std::max(lowest, -highest);
  const double top = 1.08 * highest;
  FigureData likeliest{"likeliest", {wavelength, "gain of log-evidence"}, {}};
  std::vector<double> marked;
  if (fit.wave_claimed) {
    for (const auto& wave : fit.waves) marked.push_back(wave.wavelength.value);
  } else {
    const auto waved = std::find_if(fit.explanations.begin(), fit.explanations.end(),
                                    [](const auto& each) { return !each.wavelengths.empty(); });
    if (waved != fit.explanations.end()) marked.push_back(waved->wavelengths.front());
  }
  for (const double at : marked) {
    likeliest.rows.push_back({units.per_small_length * at, lowest});
    likeliest.rows.push_back({units.per_small_length * at, top});
    likeliest.rows.emplace_back();
  }
  if (marked.empty()) likeliest.rows.push_back({NAN, NAN});
  const std::string script = fmt::format(
      R"(  set lmargin at screen 0.15; set rmargin at screen 0.96; set tmargin at screen 0.9; set bmargin at screen 0.2
  set logscale x
  set xrange [*:*] noextend
  set yrange [{bottom:.6g}:{top:.6g}]
  set xlabel '{label}' offset 0,0.4
  set ylabel 'Gain of log-evidence' offset 0.2
  set key at screen 0.545,0.985 center top vertical Left reverse maxrows 1 samplen 1.8
  set xtics ({tics})
  plot likeliest using 1:2 with lines lw 1 dt (8,5) lc rgb 'black'{likeliest_title}, \
       {claim} with lines lw 0.75 dt (2,3) lc rgb 'black' title 'claimed above', \
       gains using 1:2 with lines lw 1 lc rgb blue
  unset logscale x; set xtics auto
)",
      fmt::arg("bottom", lowest), fmt::arg("top", top), fmt::arg("claim", claiming_gain),
      fmt::arg("tics", logarithmic_tics(gains.rows.front()[0], gains.rows.back()[0])),
      fmt::arg("label", axis_label("Wavelength along the specimen", "{/:Italic λ}", units.small_length)),
      fmt::arg("likeliest_title", marked.empty()     ? ""
                                  : fit.wave_claimed ? " title 'the wave'"
                                                     : " title 'the likeliest'"));
  return {
      .name = "wavelengths",
      .title = "Wavelengths in the friction: " + test.name,
      .description = "Gain of log-evidence that a wave of friction brings beside roughness, against its wavelength.",
      .width = one_column,
      .height = 60,
      .data = {std::move(gains), std::move(likeliest)},
      .script = script};
}

}  // namespace flexslip
