#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "io/text.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "report/answer_documents.h"
#include "report/figures.h"
#include "result/table.h"

namespace flexslip {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

struct Category {
  SawtoothCategory category;
  std::string_view title;
};
constexpr std::array<Category, 3> categories{{{SawtoothCategory::clear, "clear sawtooth"},
                                              {SawtoothCategory::nominal, "nominal sawtooth"},
                                              {SawtoothCategory::none, "almost no sawtooth"}}};

// The last number in a name: 14 of "SS14 b".
std::optional<double> number_named_in(std::string_view name) {
  const auto last = std::find_if(name.rbegin(), name.rend(), is_digit);
  const auto first = std::find_if_not(last, name.rend(), is_digit);
  if (last == name.rend() || last.base() - first.base() > 6) return std::nullopt;
  return std::stod(std::string(first.base(), last.base()));
}

// The numbers in the names of the tests, if they differ and are close enough for an axis; otherwise
// none.
std::vector<double> named_numbers_of(const Campaign& campaign) {
  std::vector<double> numbers;
  std::set<double> seen;
  for (const auto& test : campaign.tests) {
    const auto number = number_named_in(test.name);
    numbers.push_back(number.value_or(0));
    if (test.summary && !(number && seen.insert(*number).second)) return {};
  }
  const double most = 4 * static_cast<double>(campaign.tests.size()) + 10;
  return *seen.rbegin() - *seen.begin() <= most ? numbers : std::vector<double>{};
}

std::string clipped(const std::string& name) {
  constexpr std::size_t longest = 20;  // [characters] of a title
  std::size_t characters = 0;
  for (std::size_t i = 0; i < name.size(); ++i)
    if ((static_cast<unsigned char>(name[i]) & 0xc0) != 0x80 && ++characters == longest) return name.substr(0, i) + "…";
  return name;
}

double mean_of(const Campaign& campaign, std::optional<SawtoothCategory> category, Spread CategorySpread::*spread) {
  for (const CategorySummary& summary : campaign.categories)
    if (summary.category == category && (summary.without_suspects.*spread).count > 0)
      return (summary.without_suspects.*spread).mean;
  return not_known;
}

}  // namespace

namespace {

bool has_loss(const CampaignTest& test) { return test.summary && test.summary->loss && test.summary->loss->needed > 0; }

}  // namespace

bool has_losses(const Campaign& campaign) {
  return std::any_of(campaign.tests.begin(), campaign.tests.end(), has_loss);
}

Plot losses_figure(const Campaign& campaign) {
  if (!has_losses(campaign)) throw std::invalid_argument("losses_figure: no test with drops was loaded again");
  constexpr double percent = 100;
  PlotTable tests{"tests", {"needed (%)", "lost (%)", "low (%)", "high (%)"}};
  double most = 10, least = 0;
  for (const CampaignTest& test : campaign.tests) {
    if (!has_loss(test)) continue;
    const auto& [lost, error, needed] = *test.summary->loss;
    const double reach = two_sided_95 * error;
    tests.rows.push_back({percent * needed, percent * lost, percent * (lost - reach), percent * (lost + reach)});
    most = std::max({most, percent * needed, percent * (lost + reach)});
    least = std::min(least, percent * (lost - reach));
  }
  const Axis x{"Loss of stiffness that the drops need", "%", 0, 1.05 * most},
      y{"Loss of stiffness", "%", std::min(-0.2 * most, 1.05 * least), 1.05 * most};
  return {.name = "losses",
          .title = "Slips or cracks, by the reload",
          .caption =
              "Loss of stiffness between a loading and the next, with 95 % intervals, against the loss that the "
              "drops of the loading would need if they were cracks only. Slips lie on the level line, cracks on "
              "the diagonal; a specimen that does both lies between.",
          .width = one_column,
          .height = 78,
          .data = {std::move(tests)},
          .panels = {{.x = x,
                      .y = y,
                      .marks = {level(0, styles::zero),
                                {.style = styles::zero, .title = "", .at = {0, 0, 1.05 * most, 1.05 * most}},
                                {Mark::bars, "tests", {0, 2, 3}, {.colour = colours::grey}},
                                {Mark::points, "tests", {0, 1}, styles::mark(Symbol::disc, colours::black, 3.5)},
                                label(0.98 * most, 0.03 * most, "slips"),
                                label(0.9 * most, 0.97 * most, "cracks")}}}};
}

Plot distribution_figure(const Campaign& campaign) {
  if (std::none_of(campaign.tests.begin(), campaign.tests.end(),
                   [](const auto& test) { return test.summary.has_value(); }))
    throw std::invalid_argument("distribution_figure: no test has a summary");
  const std::vector<double> numbers = named_numbers_of(campaign);
  std::vector<double> wavelengths;
  for (const auto& test : campaign.tests)
    if (test.summary && test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
  const TableUnit best = best_unit_of(wavelengths, kind::length);
  const PlotUnit length{typeset(best.name), best.factor};

  PlotTable tests{"tests",
                  {"test", "category (0 clear; 1 nominal; 2 none)", "suspect", "mu0", "mu0 low", "mu0 high",
                   length.column("wavelength"), length.column("low"), length.column("high"), "wave claimed"}};
  double first = infinity, last = -infinity, shortest = infinity, longest = 0, highest = 1;
  std::set<SawtoothCategory> with_tests, with_waves;
  for (std::size_t i = 0; i < campaign.tests.size(); ++i) {
    if (!campaign.tests[i].summary) continue;
    const TestSummary& test = *campaign.tests[i].summary;
    const bool has_wave = test.category != SawtoothCategory::none && test.wavelength && test.amplitude;
    const double number = numbers.empty() ? static_cast<double>(i + 1) : numbers[i];
    // a limit is drawn as a line without a mark
    const double mu0 = test.mu0_is_bound ? not_known : test.mu0.value;
    const Estimate wave = has_wave ? *test.wavelength : Estimate{not_known, not_known, not_known, not_known};
    tests.rows.push_back({number, static_cast<double>(test.category), test.suspect ? 1.0 : 0.0, mu0, test.mu0.low,
                          test.mu0.high, length(wave.value), length(wave.low), length(wave.high),
                          test.wave_claimed ? 1.0 : 0.0});
    with_tests.insert(test.category);
    if (has_wave) with_waves.insert(test.category);
    first = std::min(first, number);
    last = std::max(last, number);
    shortest = std::fmin(shortest, length(wave.low));
    longest = std::fmax(longest, length(wave.high));
    highest = std::fmax(highest, test.mu0.high);
  }
  const double space = std::max(1.0, 0.07 * (last - first));
  const bool logarithmic = shortest > 0 && longest > 8 * shortest;
  Axis x{numbers.empty() ? "Test" : "Test number", "", first - space, last + space};
  x.counts = true;
  if (numbers.empty())
    for (std::size_t i = 0; i < campaign.tests.size(); ++i)
      if (campaign.tests[i].summary)
        x.names.push_back({static_cast<double>(i + 1), as_it_is(clipped(campaign.tests[i].name))});
  const auto literature = literature_of(campaign);
  const double all = mean_of(campaign, std::nullopt, &CategorySpread::mu0);
  // With one category the common mean equals the mean of that category.
  const bool has_common_mean = std::isfinite(all) && with_tests.size() > 1;
  constexpr Style mean_look{.width = 1.4}, all_look{.colour = colours::grey},
      indicative = styles::mark(Symbol::disc, colours::grey, 3.5);

  // The tests of a category and its suspects. Values that are only indicative are grey.
  const auto panel_of = [&](const Category& each, const Axis& y, std::size_t column, double mean, std::string title) {
    const Condition belongs{1, static_cast<double>(each.category)};
    const auto tests_that = [&](Style style, std::vector<Condition> conditions) {
      conditions.push_back(belongs);
      return Mark{Mark::points, "tests", {0, column}, style, "", std::move(conditions)};
    };
    const Style disc = styles::mark(Symbol::disc, colours::black, 3.5);
    const bool is_friction = column == 3;
    Panel panel{.title = std::move(title), .x = x, .y = y};
    if (is_friction && literature)
      panel.marks.push_back(rectangle(-edge, literature->low, edge, literature->high, styles::literature));
    if (is_friction && has_common_mean) panel.marks.push_back(level(all, all_look));
    if (std::isfinite(mean)) panel.marks.push_back(level(mean, mean_look));
    panel.marks.push_back({Mark::bars, "tests", {0, column + 1, column + 2}, {.width = 0.7}, "", {belongs}});
    panel.marks.push_back(tests_that(disc, {{2, 0}, {9, 1}}));
    panel.marks.push_back(tests_that(is_friction ? disc : indicative, {{2, 0}, {9, 0}}));
    panel.marks.push_back(tests_that(styles::suspect, {{2, 1}}));
    return panel;
  };
  std::vector<Panel> panels;
  for (const Category& each : categories)
    if (with_waves.count(each.category) > 0) {
      const double mean = length(mean_of(campaign, each.category, &CategorySpread::wavelength));
      panels.push_back(panel_of(
          each,
          {"Wavelength *λ*", length.unit, logarithmic ? shortest / 1.2 : 0, (logarithmic ? 1.2 : 1.06) * longest,
           logarithmic},
          6, mean,
          fmt::format("{}{}\n{}", panels.empty() ? "A: " : "", each.title,
                      std::isfinite(mean) ? fmt::format("mean {:.{}f} {}", mean, mean < 100 ? 1 : 0, length.unit)
                                          : "no mean")));
    }
  const std::size_t waves = panels.size();
  for (const Category& each : categories)
    if (with_tests.count(each.category) > 0) {
      const double mean = mean_of(campaign, each.category, &CategorySpread::mu0);
      panels.push_back(panel_of(each, {"Mean friction *μ*_0", "", -0.035 * highest, 1.06 * highest}, 3, mean,
                                fmt::format("{}{}\n{}", waves > 0 && panels.size() == waves ? "B: " : "", each.title,
                                            std::isfinite(mean) ? fmt::format("mean {:.3f}", mean) : "no mean")));
    }
  // The key has entries only for marks that are drawn.
  std::vector<Mark> entries;
  if (std::any_of(categories.begin(), categories.end(), [&](const Category& each) {
        return std::isfinite(mean_of(campaign, each.category, &CategorySpread::mu0));
      }))
    entries.push_back({.style = mean_look, .title = "Mean, suspects left out"});
  const auto has = [&](auto holds) { return std::any_of(tests.rows.begin(), tests.rows.end(), holds); };
  const bool has_limits = has([](const auto& row) { return std::isnan(row[3]); });
  entries.push_back({.style = {.width = 0.7}, .title = has_limits ? "95 %; without a mark: limits" : "95 %"});
  if (has_common_mean)
    entries.push_back({.style = all_look, .title = fmt::format("Mean of all, without suspects: {:.3f}", all)});
  const bool has_suspects =
      has([](const auto& row) { return row[2] == 1 && (std::isfinite(row[3]) || std::isfinite(row[6])); });
  if (has_suspects) entries.push_back({.kind = Mark::points, .style = styles::suspect, .title = "Suspect"});
  if (has([](const auto& row) { return row[2] == 0 && row[9] == 0 && std::isfinite(row[6]); }))
    entries.push_back({.kind = Mark::points, .style = indicative, .title = "Wave not detected"});
  if (literature)
    entries.push_back({.kind = Mark::area,
                       .style = styles::literature,
                       .title = as_it_is(fmt::format("Literature, {} on {}: {:g}–{:g}", literature->specimen,
                                                     literature->support, literature->low, literature->high))});
  panels.front().marks.insert(panels.front().marks.end(), entries.begin(), entries.end());
  const std::size_t count = panels.size();
  return {.name = "distributions",
          .title = "Wavelength and mean friction of all tests",
          .caption = fmt::format(
              "{}mean friction, with its 95 % interval. Black lines: means of a category{}.{}{}",
              waves > 0 ? "A: wavelength of the friction along the specimen, with its 95 % interval, for tests with a "
                          "sawtooth; grey where the wave is only indicative. B: "
                        : "The ",
              has_common_mean ? ", grey line: mean of all" : "",
              has_suspects ? " Red-orange crosses: suspect tests, which the means leave out." : "",
              literature ? fmt::format(" Green: what the literature gives for {} on {}, {:g} to {:g}.",
                                       literature->specimen, literature->support, literature->low, literature->high)
                         : ""),
          .width = two_columns,
          .height = 84,
          .data = {std::move(tests)},
          .panels = std::move(panels),
          .columns = count};
}

namespace {

constexpr std::size_t panels_across = 4, panels_on_page = 5 * panels_across;

// False for a specimen that cracked, and without an answer.
bool has_friction(const CampaignTest& test) { return std::isfinite(test.summary->mu0.value); }

// The parameters, one per line.
std::string parameters_of(const TestSummary& test, const PlotUnit& wavelength) {
  std::string lines =
      fmt::format("*μ*_0 {} {:.3f}", test.mu0_is_bound ? "≤" : "=", test.mu0_is_bound ? test.mu0.high : test.mu0.value);
  if (test.wave_claimed && test.wavelength && test.amplitude)
    lines += fmt::format("\n*A* = {:.3f}\n*λ* = {:.3g} {}", test.amplitude->value, wavelength(test.wavelength->value),
                         wavelength.unit);
  return lines;
}

Plot atlas_page(std::span<const CampaignTest* const> tests, std::string name, std::string title) {
  double deepest = 0, strongest = 0, longest = 0;
  for (const auto* test : tests) {
    deepest = std::max(deepest, largest(test->curves->deflection));
    strongest = std::max(strongest, largest(test->curves->force));
    longest = std::max(longest, 0.01 * test->curves->span);
  }
  const PlotUnit w = plot_unit(deepest, kind::length), F = plot_unit(strongest, kind::force),
                 wavelength = plot_unit(longest, kind::length);
  std::vector<PlotTable> data;
  for (const char* table : {"drops", "beam", "frictionless", "model", "measured"})
    data.push_back({table, {"panel", w.column("deflection"), F.column("force")}});
  constexpr std::array looks{styles::drop, styles::euler, styles::frictionless, styles::fit, Style{colours::blue, 0.9}};
  constexpr std::array words{"Load lines", "Euler–Bernoulli", "No friction", "Model", "Measured"};
  std::vector<Panel> panels;
  std::string names;
  for (const auto* test : tests) {
    const CampaignCurves& curves = *test->curves;
    const TestSummary& summary = *test->summary;
    const auto number = static_cast<double>(panels.size() + 1);
    const ForcePlane plane{w, F, largest(curves.deflection), largest(curves.force)};
    const auto add = [&](std::size_t table, const std::vector<std::vector<double>>& rows) {
      for (const auto& row : rows) data[table].rows.push_back(row.empty() ? row : std::vector{number, row[0], row[1]});
      if (!rows.empty() && !rows.back().empty()) data[table].rows.emplace_back();
    };
    const auto line = [&](const std::vector<double>& deflection, const std::vector<double>& force) {
      PlotTable table = plane.table("");
      for (std::size_t i = 0; i < std::min(deflection.size(), force.size()); ++i)
        table.rows.push_back({w(deflection[i]), F(force[i])});
      return table;
    };
    for (const std::size_t before : curves.drops)
      if (before + 1 < curves.force.size())
        add(0, plane.load_line(curves.deflection[before], curves.force[before], curves.force[before + 1],
                               curves.load_train_stiffness));
    const double initial = beam_slope(summary.bending_stiffness.value, curves.span);
    add(1, {{0, 0}, {w(plane.w_max), F(initial * plane.w_max)}});
    const auto smooth = frictionless_curve(curves, summary.bending_stiffness.value);
    add(2, plane.curve("", smooth).rows);
    if (has_friction(*test)) add(3, plane.thinned(line(curves.model_deflection, curves.model_force)).rows);
    add(4, line(curves.deflection, curves.force).rows);
    Panel panel{.title = (summary.suspect ? "× " : "") + as_it_is(clipped(printable(test->name))),
                .x = plane.x(1.04),
                .y = plane.y(1.15)};
    for (std::size_t k = 0; k < data.size(); ++k)
      if (std::any_of(data[k].rows.begin(), data[k].rows.end(),
                      [&](const auto& row) { return !row.empty() && row[0] == number; }))
        panel.marks.push_back({Mark::line, data[k].name, {1, 2}, looks[k], "", {{0, number}}});
    if (has_friction(*test)) panel.marks.push_back(label(edge, -edge, parameters_of(summary, wavelength)));
    panels.push_back(std::move(panel));
  }
  for (std::size_t k = looks.size(); k-- > 0;)
    if (!data[k].rows.empty()) panels.front().marks.push_back({.style = looks[k], .title = words[k]});
  const std::size_t count = panels.size(), rows = (count + panels_across - 1) / panels_across;
  return {
      .name = std::move(name),
      .title = title,
      .caption =
          title +
          ": force against deflection at midspan, one panel per test. Blue: measured. Black, if friction is "
          "determined: the "
          "simulated best fit. In the corner: the mean friction of the fit, and A and λ if a wave is detected. Orange: "
          "Euler–Bernoulli (dashed) and the model without friction, with the bending stiffness of the fit. Grey: "
          "load lines at the force drops, whose slope is the stiffness of the load train. ×: suspect.",
      .width = count < 3 ? 100.0 : 183.0,
      .height = (count < 3 ? 24 : 16) + 46 * static_cast<double>(rows),
      .data = std::move(data),
      .panels = std::move(panels),
      .columns = panels_across};
}

}  // namespace

std::vector<Plot> atlas_pages(const Campaign& campaign) {
  std::vector<Plot> pages;
  const auto add_pages = [&](std::string_view key, const std::string& title,
                             const std::function<bool(const TestSummary&)>& belongs) {
    std::vector<const CampaignTest*> tests;
    for (const auto& test : campaign.tests)
      if (test.summary && test.curves && !test.curves->force.empty() && belongs(*test.summary)) tests.push_back(&test);
    const std::size_t count = (tests.size() + panels_on_page - 1) / panels_on_page;
    for (std::size_t page = 0; page < count; ++page) {
      const std::size_t first = page * panels_on_page;
      pages.push_back(atlas_page(std::span(tests).subspan(first, std::min(panels_on_page, tests.size() - first)),
                                 fmt::format("atlas-{}-{}", key, page + 1),
                                 count == 1 ? title : fmt::format("{}, page {} of {}", title, page + 1, count)));
    }
  };
  for (const Category& each : categories)
    add_pages(name_of(each.category), capitalised(each.title),
              [&](const TestSummary& test) { return test.category == each.category; });
  add_pages("suspect", "Suspect tests", [](const TestSummary& test) { return test.suspect; });
  return pages;
}

}  // namespace flexslip
