#include "report/fit_figures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "inference/analysis_curves.h"
#include "inference/process_search.h"
#include "report/fit_document.h"
#include "report/marks.h"
#include "report/plot_layout.h"
#include "report/plot_units.h"

namespace flexslip {
namespace {

constexpr double in_95_percent = 1.96;  // [1] standard deviations of a normal distribution

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

// Euler-Bernoulli and the model without friction: the references of every figure of force.
std::vector<PlotTable> references(const TestAnalysis& analysis, const PlotUnit& w, const PlotUnit& F, double w_max) {
  PlotTable beam{"beam",
                 {w.column("deflection"), F.column("force")},
                 {{0, 0}, {w(w_max), F(euler_bernoulli_force(analysis, w_max))}}};
  PlotTable frictionless{"frictionless", beam.titles};
  for (const auto& point : frictionless_curve(analysis)) frictionless.rows.push_back({w(point.w), F(point.F)});
  return {std::move(beam), std::move(frictionless)};
}

// The size that all but a hundredth of the numbers have at most.
double most_of(std::vector<double> sizes) {
  if (sizes.empty()) return 0;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

}  // namespace

Plot force_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& record = analysis.reduced;
  const auto& fit = analysis.fit;
  const double w_max = largest(record.deflection), F_max = largest(record.force);
  const PlotUnits units = plot_units(test);
  const PlotUnit w = units.length(w_max), F = units.force(F_max);
  const std::vector<std::string> titles{w.column("deflection"), F.column("force")};

  PlotTable measured{"measured", {titles[0], titles[1], F.column("residual"), "on the specimen that is fitted"}};
  std::vector<double> sizes;
  for (std::size_t i = 0; i < fit.force.size(); ++i) {
    const double residual = record.force[i] - fit.force[i];
    if (std::isfinite(residual)) sizes.push_back(std::abs(residual));
    const bool seen = i < analysis.model.path.size() && analysis.model.path[i].S >= fit.S_begin;
    measured.rows.push_back({w(record.deflection[i]), F(record.force[i]), F(residual), seen ? 1.0 : 0.0});
  }
  const double usual = most_of(sizes);
  const double residual_end = F(usual > 0 ? 1.25 * usual : 1e-3 * F_max);
  PlotTable beyond{"beyond", {titles[0], F.column("edge of the axis"), F.column("residual"), "above"}};
  for (const auto& row : measured.rows)
    if (std::abs(row[2]) > residual_end)
      beyond.rows.push_back({row[0], std::copysign(0.93 * residual_end, row[2]), row[2], row[2] > 0 ? 1.0 : 0.0});

  PlotTable sliding{"sliding", titles}, snaps{"snaps", titles};
  for (const auto& point : mean_run_forward(analysis).path) {
    const std::vector<double> here{w(point.w), F(point.F)};
    if (point.motion == Motion::snap && !sliding.rows.empty()) {
      snaps.rows.insert(snaps.rows.end(), {sliding.rows.back(), here, {}});
      sliding.rows.emplace_back();
    }
    sliding.rows.push_back(here);
  }
  sliding.rows = thinned(sliding.rows, w(w_max), F(F_max));

  // Load lines reach a little beyond the drops on both sides.
  PlotTable drops{"drops", titles};
  const double reach = 0.07 * F_max;
  for (const auto& drop : analysis.drops.drops) {
    const double F_before = record.force[drop.before];
    for (const double force : {F_before + 0.3 * reach, std::max(record.force[drop.after] - reach, 0.0)})
      drops.rows.push_back({w(record.deflection[drop.before] - (force - F_before) / analysis.rig.stiffness), F(force)});
    drops.rows.emplace_back();
  }

  std::vector<PlotTable> data = references(analysis, w, F, w_max);
  const Axis deflection = w.axis(deflection_label, 0, 1.03 * w_max);
  Panel force{.x = deflection,
              .y = F.axis(force_label, 0, 1.12 * F_max),
              .marks = {marks::key_line(styles::measured, "Measured"),
                        marks::line("drops", {0, 1}, styles::drop, "Drops, slope −*k*_c"),
                        marks::line("beam", {0, 1}, styles::euler, "Euler–Bernoulli"),
                        marks::line("frictionless", {0, 1}, styles::frictionless, "Model without friction"),
                        marks::line("sliding", {0, 1}, styles::fit, "Mean of the fit"),
                        marks::line("snaps", {0, 1}, styles::snap, "Its snaps"),
                        marks::line("measured", {0, 1}, styles::measured)},
              .share = 2.6};
  const auto points = [](Colour colour, double seen) {
    return marks::only(marks::points("measured", {0, 2}, {colour, 0.5, Dash::solid, Symbol::disc, 1.7}), {{3, seen}});
  };
  const auto triangles = [](Symbol symbol, double above) {
    return marks::only(marks::points("beyond", {0, 1}, styles::symbols(Colour::vermillion, symbol, 3.5)), {{3, above}});
  };
  Panel residuals{.x = deflection,
                  .y = {"Residual", F.unit, -residual_end, residual_end},
                  .marks = {marks::horizontal({0}, styles::zero), points(Colour::grey, 0), points(Colour::blue, 1),
                            triangles(Symbol::triangle, 1), triangles(Symbol::down, 0)}};
  const bool has_snaps = !snaps.rows.empty(), has_beyond = !beyond.rows.empty();
  for (PlotTable* table : {&measured, &sliding, &snaps, &drops, &beyond}) data.push_back(std::move(*table));
  return {.name = "force",
          .title = "Force against deflection: " + test.name,
          .caption = fmt::format(
              "Force against deflection at midspan. Blue: measured. Black: the mean of the fit run forward{}. Orange: "
              "Euler–Bernoulli (dashed) and the model without friction, both with the bending stiffness of the fit. {}"
              "Below: measured force less that of the fit, grey where the force says too little about friction{}.",
              has_snaps ? ", dashed where it snaps" : "",
              analysis.drops.drops.empty()
                  ? ""
                  : fmt::format("Grey: load lines, whose slope is the stiffness of the load train, through {}. ",
                                analysis.drops.drops.size() == 1
                                    ? "the drop"
                                    : fmt::format("the {} drops", analysis.drops.drops.size())),
              has_beyond ? "; triangles: beyond the axis" : ""),
          .width = two_columns,
          .height = 108,
          .data = std::move(data),
          .panels = {std::move(force), std::move(residuals)}};
}

Plot profile_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  const auto& profile = analysis.profile_at_fit;
  const PlotUnit length = plot_units(test).slid();
  const auto slid = [&](double S) { return length((S - 1) / 2); };
  const std::string position = length.column("slid over one support");

  PlotTable measured{"profile",
                     {position, "mu", "mu low", "mu high", "mu error of the point", "mu error common to all"}};
  double S_end = fit.S_end, lowest = 0, highest = 0.5;
  for (const auto& point : profile.points) {
    const double half = in_95_percent * point.from_force;
    measured.rows.push_back({slid(point.S), point.mu, point.mu - half, point.mu + half, point.from_force,
                             std::hypot(point.from_bending_stiffness, point.from_contact)});
    S_end = std::max(S_end, point.S);
    if (point.S < fit.S_begin) continue;
    highest = std::max(highest, point.mu);
    lowest = std::min(lowest, point.mu);
  }
  PlotTable band{"band", {position, "mu", "mu low", "mu high"}};
  for (std::size_t i = 0; i < fit.band.S.size(); ++i) {
    const double mean = fit.band.mean[i], wide = 2 * fit.band.deviation[i];
    band.rows.push_back({slid(fit.band.S[i]), mean, std::max(mean - wide, 0.0), mean + wide});
    highest = std::max(highest, mean + wide);
  }
  PlotTable slips{"slips", {position, "mu"}};
  for (const auto& slip : analysis.slips)
    slips.rows.insert(slips.rows.end(),
                      {{slid(slip.S_before), slip.mu_before}, {slid(slip.S_after), slip.mu_after}, {}});
  PlotTable imaged{"imaged", slips.titles};
  if (test.imaged) {
    auto point = profile.points.begin();
    for (const auto& seen : test.imaged->points) {
      while (point->index < seen.index) ++point;
      imaged.rows.push_back({slid(1 + seen.imaged), point->mu});
    }
  }
  PlotTable wave{"wave", slips.titles};
  for (const auto& point : claimed_waves(analysis)) wave.rows.push_back({slid(point.S), point.mu});

  constexpr Style band_look{.colour = Colour::grey, .opacity = 0.35};
  constexpr Style point_look{Colour::blue, 0.5, Dash::solid, Symbol::disc, 1.7};
  std::vector<Mark> marks;
  const auto literature = literature_of(test);
  if (literature) {
    const std::string words = as_it_is(fmt::format("Literature: {} on {}", literature->specimen, literature->support));
    highest = std::max(highest, literature->high);
    marks.push_back(literature->low < literature->high
                        ? marks::rectangle({-marks::edge, marks::edge, literature->low, literature->high},
                                           styles::literature, words)
                        : marks::horizontal({literature->low}, {Colour::green, 1}, words));
  }
  const std::vector<Mark> of_test{
      marks::band("band", {0, 2, 3}, band_look, "Mean ± 2 deviations"),
      marks::line("band", {0, 1}, styles::fit, "Mean of the fit"),
      marks::line("wave", {0, 1}, {Colour::orange, 0.9}, "Wave"),
      marks::points("imaged", {0, 1}, {Colour::dark, 0.6, Dash::solid, Symbol::circle, 2.2}, "Length as imaged"),
      marks::line("slips", {0, 1}, {Colour::vermillion, 0.8}, "Slips"),
      marks::bars("profile", {0, 2, 3}, {Colour::blue, 0.5}),
      marks::points("profile", {0, 1}, point_look, "Measured, 95 %")};
  marks.insert(marks.end(), of_test.begin(), of_test.end());
  return {
      .name = "profile",
      .title = "Friction along the specimen: " + test.name,
      .caption = fmt::format(
          "Friction along the specimen, at the bending stiffness of the fit. Blue: read off the force point by "
          "point, with 95 % intervals from the noise of each point. {}Black: the mean of the fit; grey: two standard "
          "deviations about it, "
          "with the errors of stiffness and contact.{}{}{}",
          analysis.slips.empty() ? "" : "Red-orange: the slips. ", fit.wave_claimed ? " Orange: the wave claimed." : "",
          imaged.rows.empty() ? "" : " Circles: at the length that was imaged.",
          literature ? fmt::format(" Green: what the literature gives for {} on {}.", literature->specimen,
                                   literature->support)
                     : ""),
      .width = two_columns,
      .height = 74,
      .data = {std::move(measured), std::move(slips), std::move(imaged), std::move(band), std::move(wave)},
      .panels = {{.x = {slid_label, length.unit, 0, 1.02 * slid(S_end)},
                  .y = {friction_label, "", lowest < 0 ? -rounded_up(-lowest) : 0, 1.05 * highest},
                  .marks = std::move(marks)}}};
}

bool has_waves(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const auto listed = std::min(listed_explanations, fit.explanations.size());
  return !fit.scan.empty() &&
         (fit.wave_claimed ||
          std::any_of(fit.explanations.begin(), fit.explanations.begin() + static_cast<std::ptrdiff_t>(listed),
                      [](const Explanation& each) { return !each.wavelengths.empty(); }));
}

Plot wavelength_figure(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const PlotUnit length = plot_units(test).slid();
  PlotTable gains{"gains", {length.column("wavelength"), "gain of log-evidence"}};
  for (const auto& at : fit.scan) gains.rows.push_back({length(at.wavelength), at.gain});
  const auto likeliest =
      *std::max_element(gains.rows.begin(), gains.rows.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  const double highest = std::max(1.5 * claiming_gain, likeliest[1]);
  double lowest = 0;
  for (const auto& row : gains.rows) lowest = std::min(lowest, row[1]);
  lowest = std::max(lowest, -highest);

  std::vector<Mark> marks{
      marks::line("gains", {0, 1}, {Colour::blue, 1}),
      marks::horizontal({claiming_gain}, {Colour::black, 0.75, Dash::dotted}, "Claimed above"),
      marks::points("likeliest", {0, 1}, {Colour::blue, 1, Dash::solid, Symbol::circle, 4}, "Likeliest")};
  if (fit.wave_claimed)
    for (const auto& wave : fit.waves)
      marks.push_back(marks::vertical({length(wave.wavelength.value)}, {Colour::black, 1, Dash::dashed},
                                      &wave == &fit.waves.front() ? "Wave of the fit" : ""));
  return {
      .name = "wavelengths",
      .title = "Wavelengths in the friction: " + test.name,
      .caption = fmt::format(
          "How much a wave of friction adds to the logarithm of the evidence, by its wavelength, the roughness being "
          "as "
          "fitted without a wave. Circle: the likeliest, {:.3g} {}. Dotted: {:g}, beyond which a wave is claimed.{}",
          likeliest[0], length.unit, claiming_gain,
          fit.wave_claimed ? " Dashed: the wave of the fit, for which the roughness was fitted anew." : ""),
      .width = one_column,
      .height = 58,
      .data = {std::move(gains), {"likeliest", {length.column("wavelength"), "gain of log-evidence"}, {likeliest}}},
      .panels = {{.x = {"Wavelength along the specimen *λ*", length.unit, length(fit.scan.front().wavelength),
                        length(fit.scan.back().wavelength), true},
                  .y = {"Gain of log-evidence", "", lowest, 1.08 * highest},
                  .marks = std::move(marks)}}};
}

bool has_judged_teeth(const FittedTest& test) {
  const auto& teeth = test.analysis.teeth;
  return teeth && std::any_of(teeth->teeth.begin(), teeth->teeth.end(),
                              [](const Tooth& tooth) { return tooth.verdict != ToothVerdict::undecided; });
}

Plot teeth_figure(const FittedTest& test) {
  const Teeth& judged = test.analysis.teeth.value();
  const PlotUnit length = plot_units(test).slid();
  const auto slid = [&](double S) { return length((S - 1) / 2); };
  PlotTable teeth{"teeth",
                  {length.column("slid over one support"), length.column("begin"), length.column("end"), "position p",
                   "low by noise", "high by noise", "low by what is common", "high by what is common", "p if compliant",
                   "verdict (0 sliding; 1 as if stuck; 2 undecided)"}};
  double lowest = -0.2, highest = 1.15;
  for (const Tooth& tooth : judged.teeth) {
    if (!std::isfinite(tooth.S_begin) || !std::isfinite(tooth.S_end)) continue;
    const double p = tooth.position.value, noise = in_95_percent * tooth.position.standard_error,
                 common = in_95_percent * tooth.position_systematic, all = std::hypot(noise, common) + 0.05;
    lowest = std::min(lowest, p - all);
    highest = std::max(highest, p + all);
    const double begin = slid(tooth.S_begin), end = slid(tooth.S_end);
    teeth.rows.push_back({0.5 * (begin + end), begin, end, p, p - noise, p + noise, p - common, p + common,
                          tooth.compliant_position, static_cast<double>(tooth.verdict)});
  }
  const double stuck = 1 - test.provenance.options.teeth.least_share;
  const auto verdict = [](ToothVerdict which, Style style, std::string title) {
    return marks::only(marks::points("teeth", {0, 3}, style, std::move(title)), {{9, static_cast<double>(which)}});
  };
  constexpr Style open{Colour::black, 1, Dash::solid, Symbol::circle, 3.5};
  return {
      .name = "teeth",
      .title = "Stick or slide between the drops: " + test.name,
      .caption =
          "Every rise of the force between two drops, on a scale from sliding at constant friction (0) to sticking "
          "(1). Below 1 "
          "the specimen slides in; below 0 friction falls at the same time. Thin bars: noise, 95 %. Wide grey "
          "bars: stiffness and contact, 95 %, common to all rises. Orange: not distinguishable from sticking; "
          "sliding against steeply rising friction looks the same. Crosses: a stuck specimen on supports that "
          "give way by the one compliance that fits best.",
      .width = two_columns,
      .height = 78,
      .data = {std::move(teeth)},
      .panels = {{.x = {slid_label, length.unit},
                  .y = {"Position *p* (0: sliding, 1: stuck)", "", std::max(lowest, -1.5), std::min(highest, 2.0)},
                  .marks = {marks::rectangle({-marks::edge, marks::edge, stuck, marks::edge},
                                             {.colour = Colour::orange, .opacity = 0.16}),
                            marks::horizontal({1}, styles::zero), marks::horizontal({0}, styles::zero),
                            marks::label(-marks::edge, stuck, "as if stuck"),
                            marks::bars("teeth", {0, 6, 7}, {Colour::silver, 4}, "95 %: common to all"),
                            marks::bars("teeth", {0, 4, 5}, {Colour::black, 0.8}, "95 %: noise"),
                            marks::spans("teeth", {1, 2, 3}, {Colour::grey, 0.8}),
                            verdict(ToothVerdict::sliding, {Colour::blue, 1, Dash::solid, Symbol::disc, 3.5}, "slides"),
                            verdict(ToothVerdict::as_if_stuck,
                                    {Colour::vermillion, 1, Dash::solid, Symbol::square, 3.5}, "as if stuck"),
                            verdict(ToothVerdict::undecided, open, "undecided"),
                            marks::points("teeth", {0, 8}, {Colour::green, 0.8, Dash::solid, Symbol::cross, 3},
                                          "if stuck, compliant")}}}};
}

Plot record_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& record = analysis.record;
  const auto [least, greatest] = std::minmax_element(record.force.begin(), record.force.end());
  const PlotUnits units = plot_units(test);
  const auto reduced_force = [&](double force) { return units.scales.reduced_force(force); };
  const double w_max = units.scales.reduced_length(largest(record.deflection));
  const PlotUnit w = units.length(w_max),
                 F = units.force(reduced_force(std::max(std::abs(*least), std::abs(*greatest))));
  PlotTable measured{"measured", {w.column("deflection"), F.column("force")}};
  for (std::size_t i = 0; i < record.force.size(); ++i)
    measured.rows.push_back({w(units.scales.reduced_length(record.deflection[i])), F(reduced_force(record.force[i]))});
  std::vector<PlotTable> data = references(analysis, w, F, w_max);
  data.push_back(std::move(measured));
  return {
      .name = "record",
      .title = "Force against deflection: " + test.name,
      .caption =
          "Force against deflection at midspan. Blue: measured. Orange: Euler–Bernoulli (dashed) and the "
          "model without friction, both with the bending stiffness stated, or that of the initial slope.",
      .width = two_columns,
      .height = 78,
      .data = std::move(data),
      .panels = {{.x = w.axis(deflection_label, 0, 1.03 * w_max),
                  .y = F.axis(force_label, std::min(0.0, 1.1 * reduced_force(*least)), 1.1 * reduced_force(*greatest)),
                  .marks = {marks::key_line(styles::measured, "Measured"), marks::horizontal({0}, styles::zero),
                            marks::line("beam", {0, 1}, styles::euler, "Euler–Bernoulli"),
                            marks::line("frictionless", {0, 1}, styles::frictionless, "Model without friction"),
                            marks::line("measured", {0, 1}, styles::measured)}}}};
}

}  // namespace flexslip
