#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "inference/analysis.h"
#include "inference/fit.h"
#include "numerics/statistics.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip {
namespace {

// The quantile of the sizes at `share`.
double size_quantile(double share, std::vector<double> sizes) {
  if (sizes.empty()) return 0;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

// Converts a length between the supports to the length slid over one support.
struct Slid {
  PlotUnit unit;
  double operator()(double S) const { return unit((S - 1) / 2); }
  std::string column() const { return unit.column("slid over one support"); }
};
Slid slid_of(const FittedTest& test) { return {plot_units(test).length(0.02)}; }

// The reference curves of every force figure: Euler-Bernoulli and the model without friction.
std::vector<PlotTable> references(const TestAnalysis& analysis, const ForcePlane& plane) {
  PlotTable beam = plane.table("beam");
  beam.rows = {{0, 0}, {plane.w(plane.w_max), plane.F(euler_bernoulli_force(analysis, plane.w_max))}};
  return {std::move(beam), plane.curve("frictionless", frictionless_curve(analysis))};
}
const Mark beam_mark{Mark::line, "beam", {0, 1}, styles::euler, "Euler–Bernoulli"};
const Mark frictionless_mark{Mark::line, "frictionless", {0, 1}, styles::frictionless, "Model without friction"};

}  // namespace

PlotTable ForcePlane::thinned(PlotTable data) const {
  constexpr double finest = 0.002;  // of the figure: a third of a millimetre
  std::vector<std::vector<double>> kept;
  const auto& rows = data.rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i == 0 || i + 1 == rows.size() || rows[i].empty() || rows[i - 1].empty() || rows[i + 1].empty() ||
        std::hypot((rows[i][0] - kept.back()[0]) / w(w_max), (rows[i][1] - kept.back()[1]) / F(F_max)) > finest)
      kept.push_back(rows[i]);
  data.rows = std::move(kept);
  return data;
}

std::vector<std::vector<double>> ForcePlane::load_line(double deflection, double before, double after,
                                                       double stiffness) const {
  std::vector<std::vector<double>> rows;
  for (const double force : {before + 0.03 * F_max, std::max(after - 0.08 * F_max, 0.0)})
    rows.push_back({w(deflection - (force - before) / stiffness), F(force)});
  rows.emplace_back();
  return rows;
}

ForcePlane force_plane(const PlotUnits& units, double w_max, double F_max) {
  return {units.length(w_max), units.force(F_max), w_max, F_max};
}

PlotUnits plot_units(const FittedTest& test) {
  return {test.analysis.scales, test.reduced, is_in_inches(test.measurement.test)};
}

Plot force_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& record = analysis.reduced;
  const auto& fit = analysis.fit;
  const ForcePlane plane = force_plane(plot_units(test), largest(record.deflection), largest(record.force));
  const PlotUnit &w = plane.w, &F = plane.F;

  std::vector<double> sizes;
  for (std::size_t i = 0; i < fit.force.size(); ++i)
    if (const double residual = record.force[i] - fit.force[i]; std::isfinite(residual))
      sizes.push_back(std::abs(residual));
  const double usual = size_quantile(0.99, sizes), end = F(usual > 0 ? 1.25 * usual : 1e-3 * plane.F_max);
  PlotTable measured = plane.table("measured");
  measured.titles.insert(measured.titles.end(),
                         {F.column("residual"), F.column("residual within the axis"),
                          "kind (0 before friction shows; 1 fitted; 2 above the axis; 3 below)"});
  for (std::size_t i = 0; i < fit.force.size(); ++i) {
    const double residual = F(record.force[i] - fit.force[i]);
    const bool is_fitted = i < analysis.model.path.size() && analysis.model.path[i].S >= fit.S_begin;
    measured.rows.push_back({w(record.deflection[i]), F(record.force[i]), residual,
                             std::clamp(residual, -0.93 * end, 0.93 * end),
                             residual > end    ? 2.0
                             : residual < -end ? 3.0
                             : is_fitted       ? 1.0
                                               : 0.0});
  }
  const bool has_beyond =
      std::any_of(measured.rows.begin(), measured.rows.end(), [](const auto& row) { return row[4] > 1; });
  PlotTable sliding = plane.table("sliding"), snaps = plane.table("snaps"), drops = plane.table("drops");
  const TestPath forward = simulated_mean_fit(analysis);
  const auto at = [&](const PathPoint& point) { return std::vector{w(point.w), F(point.F)}; };
  const auto is_snap = [](const PathPoint& point) { return point.motion == Motion::snap; };
  sliding.rows = stretches_of(
      forward.path, [&](const PathPoint& point) { return !is_snap(point); }, at);
  snaps.rows = stretches_of(forward.path, is_snap, at);
  for (const auto& drop : analysis.drops.drops)
    for (auto& row : plane.load_line(record.deflection[drop.before], record.force[drop.before],
                                     record.force[drop.after], analysis.rig.stiffness))
      drops.rows.push_back(std::move(row));
  const std::size_t count = analysis.drops.drops.size();

  const auto residuals = [](double which, Symbol symbol, Colour colour, double size) {
    return Mark{Mark::points, "measured", {0, 3}, styles::mark(symbol, colour, size, 0.5), "", {{4, which}}};
  };
  std::vector<PlotTable> data = references(analysis, plane);
  const std::string snaps_in_words = snaps.rows.empty() ? "" : ", dashed where it snaps";
  for (PlotTable* table : {&measured, &snaps, &drops}) data.push_back(std::move(*table));
  data.push_back(plane.thinned(std::move(sliding)));
  return {.name = "force",
          .title = "Force against deflection: " + test.name,
          .caption = fmt::format(
              "Force against deflection at midspan. Blue: measured. Black: the simulated best fit{}. Orange: "
              "Euler–Bernoulli (dashed) and the model without friction, both with the bending stiffness of the fit. "
              "{}Below: measured minus fitted force, grey where the force is not informative about friction{}.",
              snaps_in_words,
              count == 0 ? ""
                         : fmt::format("Grey: load lines, whose slope is the stiffness of the load train, through {}. ",
                                       count == 1 ? "the drop" : fmt::format("the {} drops", count)),
              has_beyond ? "; triangles: beyond the axis" : ""),
          .width = two_columns,
          .height = 108,
          .data = std::move(data),
          .panels = {{.x = plane.x(1.03),
                      .y = plane.y(1.12),
                      .marks = {{.style = styles::measured, .title = "Measured"},
                                {Mark::line, "drops", {0, 1}, styles::drop, "Drops, slope −*k*_c"},
                                beam_mark,
                                frictionless_mark,
                                {Mark::line, "sliding", {0, 1}, styles::fit, "Mean of the fit"},
                                {Mark::line, "snaps", {0, 1}, styles::snap, "Its snaps"},
                                {Mark::line, "measured", {0, 1}, styles::measured}},
                      .share = 2.6},
                     {.x = plane.x(1.03),
                      .y = {"Residual", F.unit, -end, end},
                      .marks = {level(0, styles::zero), residuals(0, Symbol::disc, colours::grey, 1.7),
                                residuals(1, Symbol::disc, colours::blue, 1.7),
                                residuals(2, Symbol::triangle, colours::vermillion, 3.5),
                                residuals(3, Symbol::down, colours::vermillion, 3.5)}}}};
}

Plot profile_figure(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const auto& fit = analysis.fit;
  const Slid slid = slid_of(test);
  const auto table = [&](std::string name) { return PlotTable{std::move(name), {slid.column(), "mu"}}; };

  PlotTable measured{"profile",
                     {slid.column(), "mu", "mu low", "mu high", "mu error of the point", "mu error common to all"}};
  double S_end = fit.S_end, lowest = 0, highest = 0.5;
  for (const auto& point : analysis.profile_at_fit.points) {
    const double half = two_sided_95 * point.from_force;
    measured.rows.push_back({slid(point.S), point.mu, point.mu - half, point.mu + half, point.from_force,
                             std::hypot(point.from_bending_stiffness, point.from_contact)});
    S_end = std::max(S_end, point.S);
    if (point.S < fit.S_begin) continue;
    highest = std::max(highest, point.mu);
    lowest = std::min(lowest, point.mu);
  }
  PlotTable band{"band", {slid.column(), "mu", "mu low", "mu high"}};
  for (std::size_t i = 0; i < fit.band.S.size(); ++i) {
    const double mean = fit.band.mean[i], wide = 2 * fit.band.deviation[i];
    band.rows.push_back({slid(fit.band.S[i]), mean, mean - wide, mean + wide});
    highest = std::max(highest, mean + wide);
    if (mean < 0) lowest = std::min(lowest, mean - wide);
  }
  PlotTable slips = table("slips"), imaged = table("imaged"), wave = table("wave");
  for (const auto& slip : analysis.slips)
    slips.rows.insert(slips.rows.end(),
                      {{slid(slip.S_before), slip.mu_before}, {slid(slip.S_after), slip.mu_after}, {}});
  if (test.imaged) {
    auto point = analysis.profile_at_fit.points.begin();
    for (const auto& seen : test.imaged->points) {
      while (point->index < seen.index) ++point;
      imaged.rows.push_back({slid(1 + seen.imaged), point->mu});
    }
  }
  for (const auto& point : detected_waves(analysis)) wave.rows.push_back({slid(point.S), point.mu});

  std::vector<Mark> marks;
  const auto literature = literature_of(test);
  if (literature) {
    const std::string words = as_it_is(fmt::format("Literature: {} on {}", literature->specimen, literature->support));
    highest = std::max(highest, literature->high);
    if (literature->low < literature->high)
      marks.push_back(rectangle(-edge, literature->low, edge, literature->high, styles::literature, words));
    else
      marks.push_back(level(literature->low, {colours::green}, words));
  }
  const std::vector<Mark> of_test{
      {Mark::band, "band", {0, 2, 3}, styles::fill(colours::grey, 0.35), "Mean ± 2 deviations"},
      {Mark::line, "band", {0, 1}, styles::fit, "Mean of the fit"},
      {Mark::line, "wave", {0, 1}, {colours::purple, 1.2}, "Wave"},
      {Mark::points, "imaged", {0, 1}, styles::mark(Symbol::circle, colours::dark, 2.2, 0.6), "Length as imaged"},
      {Mark::line, "slips", {0, 1}, {colours::vermillion, 0.8}, "Slips"},
      {Mark::bars, "profile", {0, 2, 3}, {colours::blue, 0.5}},
      {Mark::points, "profile", {0, 1}, styles::measured, "Measured, 95 %"}};
  marks.insert(marks.end(), of_test.begin(), of_test.end());
  return {
      .name = "profile",
      .title = "Friction along the specimen: " + test.name,
      .caption = fmt::format(
          "Friction along the specimen, at the bending stiffness of the fit. Blue: inverted from the force point by "
          "point, with 95 % intervals from the noise of each point. {}Black: the mean of the fit; grey: two "
          "standard deviations about it, with the errors of stiffness and contact.{}{}{}",
          slips.rows.empty() ? "" : "Red-orange: the slips. ", fit.wave_claimed ? " Purple: the detected wave." : "",
          imaged.rows.empty() ? "" : " Circles: at the length that was imaged.",
          literature ? fmt::format(" Green: what the literature gives for {} on {}.", literature->specimen,
                                   literature->support)
                     : ""),
      .width = two_columns,
      .height = 74,
      .data = {std::move(measured), std::move(slips), std::move(imaged), std::move(band), std::move(wave)},
      .panels = {{.x = {slid_label, slid.unit.unit, 0, 1.02 * slid(S_end)},
                  .y = {friction_label, "", 1.05 * lowest, 1.05 * highest},
                  .marks = std::move(marks)}}};
}

bool has_waves(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  return !fit.scan.empty() && (fit.wave_claimed || std::any_of(fit.scan.begin(), fit.scan.end(),
                                                               [](const ScannedWave& at) { return at.gain > 0; }));
}

Plot wavelength_figure(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  const PlotUnit length = slid_of(test).unit;
  PlotTable gains{"gains", {length.column("wavelength"), "gain of log-evidence"}};
  for (const auto& at : fit.scan) gains.rows.push_back({length(at.wavelength), at.gain});
  const auto [least, likeliest] = std::minmax_element(fit.scan.begin(), fit.scan.end(),
                                                      [](const auto& a, const auto& b) { return a.gain < b.gain; });
  const double highest = std::max(1.5 * claiming_gain, likeliest->gain);

  std::vector<Mark> marks{{Mark::line, "gains", {0, 1}, {colours::blue}},
                          level(claiming_gain, {colours::black, 0.75, Dash::dotted}, "Detected above"),
                          spot(length(likeliest->wavelength), likeliest->gain,
                               styles::mark(Symbol::circle, colours::blue, 4), "Most probable")};
  if (fit.wave_claimed)
    for (const auto& wave : fit.waves)
      marks.push_back(upright(length(wave.wavelength.value), {.dash = Dash::dashed},
                              &wave == &fit.waves.front() ? "Wave of the fit" : ""));
  return {
      .name = "wavelengths",
      .title = "Wavelengths in the friction: " + test.name,
      .caption = fmt::format(
          "How much a wave of friction adds to the logarithm of the evidence, by its wavelength, with the roughness "
          "fitted without a wave. Circle: the maximum, {:.3g} {}. Dotted: {:g}, above which a wave counts as "
          "detected.{}",
          length(likeliest->wavelength), length.unit, claiming_gain,
          fit.wave_claimed ? " Dashed: the wave of the fit, for which the roughness was fitted anew." : ""),
      .width = one_column,
      .height = 58,
      .data = {std::move(gains)},
      .panels = {{.x = {"Wavelength along the specimen *λ*", length.unit, length(fit.scan.front().wavelength),
                        length(fit.scan.back().wavelength), true},
                  .y = {"Gain of log-evidence", "", std::clamp(1.04 * least->gain, -highest, 0.0), 1.08 * highest},
                  .marks = std::move(marks)}}};
}

Plot record_figure(const FittedTest& test) {
  const TestAnalysis& analysis = test.analysis;
  const Record& record = analysis.record;
  const PlotUnits units = plot_units(test);
  const auto [least, greatest] = std::minmax_element(record.force.begin(), record.force.end());
  const double F_least = units.scales.reduced_force(*least), F_most = units.scales.reduced_force(*greatest);
  const ForcePlane plane =
      force_plane(units, units.scales.reduced_length(largest(record.deflection)), std::max(-F_least, F_most));
  const auto at = [&](std::size_t i) {
    return std::vector{plane.w(units.scales.reduced_length(record.deflection[i])),
                       plane.F(units.scales.reduced_force(record.force[i]))};
  };
  PlotTable measured = plane.table("measured"), drops = plane.table("drops");
  for (std::size_t i = 0; i < record.force.size(); ++i) measured.rows.push_back(at(i));
  for (const Drop& drop : analysis.drops.drops)
    drops.rows.insert(drops.rows.end(), {at(drop.before), at(drop.after), std::vector<double>{}});
  std::vector<PlotTable> data;
  std::vector<Mark> marks{{.style = styles::measured, .title = "Measured"}, level(0, styles::zero)};
  std::string caption = "Force against deflection at midspan. Blue: measured.";
  if (analysis.status == AnalysisStatus::not_explained || analysis.status == AnalysisStatus::ok) {
    TestAnalysis as_stated = analysis;
    as_stated.status = AnalysisStatus::not_explained;  // its curves have the stated bending stiffness
    data = references(as_stated, plane);
    marks.insert(marks.end(), {beam_mark, frictionless_mark});
    caption +=
        " Orange: Euler–Bernoulli (dashed) and the model without friction, both with the stated bending stiffness, or "
        "with the initial slope.";
  }
  marks.push_back({Mark::line, "measured", {0, 1}, styles::measured});
  if (!drops.rows.empty()) {
    marks.push_back({Mark::line, "drops", {0, 1}, styles::unloading, "Drops"});
    caption += " Red: the drops.";
  }
  for (PlotTable* table : {&measured, &drops}) data.push_back(std::move(*table));
  return {.name = "record",
          .title = "Force against deflection: " + test.name,
          .caption = caption,
          .width = two_columns,
          .height = 78,
          .data = std::move(data),
          .panels = {{.x = plane.x(1.03),
                      .y = plane.F.axis(force_label, std::min(0.0, 1.1 * F_least), std::max(0.0, 1.1 * F_most)),
                      .marks = std::move(marks)}}};
}

bool has_passes(const FittedTest& test) { return test.passes && test.passes->status == PassesStatus::ok; }

namespace {

// The action of a pass and its style. The first loading is wide, so that later ones are visible on
// it.
struct PassStyle {
  std::string_view words;
  Style style;
};
constexpr std::array pass_styles{PassStyle{"in", {colours::sky, 2.6}}, PassStyle{"out", {colours::vermillion, 1.2}},
                                 PassStyle{"in again", {colours::black, 0.8}}};

std::size_t style_of_pass(const PassesFit& passes, std::size_t number) {
  if (passes.passes[number].rows.direction == Direction::unloading) return 1;
  const auto is_loading = [](const PassFriction& pass) { return pass.rows.direction == Direction::loading; };
  return std::any_of(passes.passes.begin(), passes.passes.begin() + static_cast<std::ptrdiff_t>(number), is_loading)
             ? 2
             : 0;
}

// "Passes 2, 4: out", for passes with the same style.
std::string pass_title(const PassesFit& passes, std::size_t style) {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < passes.passes.size(); ++number)
    if (style_of_pass(passes, number) == style) numbers.push_back(number + 1);
  return fmt::format("{} {}: {}", numbers.size() == 1 ? "Pass" : "Passes", fmt::join(numbers, ", "),
                     pass_styles[style].words);
}

}  // namespace

Plot passes_figure(const FittedTest& test) {
  const PassesFit& passes = *test.passes;
  const Record& all = *test.measurement.cycles;
  const PlotUnits units = plot_units(test);
  const Scales& scales = units.scales;
  const ForcePlane plane =
      force_plane(units, scales.reduced_length(largest(all.deflection)), scales.reduced_force(largest(all.force)));
  std::vector<PlotTable> tables;
  std::vector<Mark> marks;
  for (std::size_t style = 0; style < pass_styles.size(); ++style) {
    std::string title = pass_title(passes, style);
    for (std::size_t number = 0; number < passes.passes.size(); ++number) {
      if (style_of_pass(passes, number) != style) continue;
      const Record record = record_of(test, passes.passes[number]);
      PlotTable& table = tables.emplace_back(plane.table(fmt::format("pass_{}", number + 1)));
      for (std::size_t i = 0; i < record.force.size(); ++i)
        table.rows.push_back(
            {plane.w(scales.reduced_length(record.deflection[i])), plane.F(scales.reduced_force(record.force[i]))});
      marks.push_back({Mark::line, table.name, {0, 1}, pass_styles[style].style, std::exchange(title, std::string())});
    }
  }
  return {.name = "passes",
          .title = "Loading, unloading and loading again: " + test.name,
          .caption =
              "Force against deflection at midspan, pass by pass: the specimen is loaded (wide, blue), unloaded "
              "(red-orange) and loaded again (thin, black).",
          .width = two_columns,
          .height = 96,
          .data = std::move(tables),
          .panels = {{.x = plane.x(1.03), .y = plane.y(1.06), .marks = std::move(marks)}}};
}

Plot boxes_figure(const FittedTest& test) {
  const PassesFit& passes = *test.passes;
  const Slid slid = slid_of(test);
  PlotTable points{"points", {slid.column(), "q", "pass", "slides (1) or sticks (0)"}};
  std::vector<double> sizes;
  double x_max = 0;
  for (const PassPoint& point : passes.points) {
    points.rows.push_back({slid(point.S), point.q, static_cast<double>(point.pass), point.slides ? 1.0 : 0.0});
    x_max = std::max(x_max, slid(point.S));
    sizes.push_back(std::abs(point.q));
  }
  // ignores outliers due to noise
  const double top = std::max(1.25 * size_quantile(0.98, sizes), 1e-3);
  std::vector<Mark> marks{level(0, styles::zero)};
  std::array<bool, pass_styles.size()> is_told{};
  for (std::size_t number = 0; number < passes.passes.size(); ++number) {
    const std::size_t style = style_of_pass(passes, number);
    const Colour colour = pass_styles[style].style.colour;
    const Condition of_pass{2, static_cast<double>(number)};
    marks.push_back({Mark::points,
                     "points",
                     {0, 1},
                     styles::mark(Symbol::disc, colour, style == 0 ? 2.6 : 1.4, 0.5),
                     std::exchange(is_told[style], true) ? "" : pass_title(passes, style),
                     {of_pass, {3, 1}}});
    marks.push_back(
        {Mark::points, "points", {0, 1}, styles::mark(Symbol::circle, colour, 1.2, 0.3), "", {of_pass, {3, 0}}});
  }
  return {
      .name = "boxes",
      .title = "Friction of each pass: " + test.name,
      .caption =
          "Mobilised friction against the length slid over one support, at the bending stiffness of the fit. "
          "The specimen slides in along +μ, sticks while the stage turns back, and slides out along −μ. Open "
          "circles: it sticks there, or only one pass came this far. Points that noise moves beyond the axis are not "
          "shown.",
      .width = two_columns,
      .height = 78,
      .data = {std::move(points)},
      .panels = {{.x = {slid_label, slid.unit.unit, 0, 1.02 * x_max},
                  .y = {"Mobilised friction *q*", "", -top, top},
                  .marks = std::move(marks)}}};
}

}  // namespace flexslip
