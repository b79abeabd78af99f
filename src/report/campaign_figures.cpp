#include "report/campaign_figures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "io/text.h"
#include "report/campaign_words.h"
#include "report/marks.h"
#include "report/plot_layout.h"
#include "report/plot_units.h"
#include "result/table.h"

namespace flexslip {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

struct CategoryLook {
  SawtoothCategory category;
  std::string_view title;
  Symbol symbol;
  double size;  // [pt]
};
constexpr std::array<CategoryLook, 3> looks{{{SawtoothCategory::clear, "clear sawtooth", Symbol::star, 4.5},
                                             {SawtoothCategory::nominal, "nominal sawtooth", Symbol::triangle, 4.8},
                                             {SawtoothCategory::none, "almost no sawtooth", Symbol::disc, 3.3}}};

// The last number in a name: 14 of "SS14 b".
std::optional<double> number_named_in(std::string_view name) {
  const auto last = std::find_if(name.rbegin(), name.rend(), is_digit);
  const auto first = std::find_if_not(last, name.rend(), is_digit);
  if (last == name.rend() || last.base() - first.base() > 6) return std::nullopt;
  return std::stod(std::string(first.base(), last.base()));
}

struct TestNumbers {
  bool of_names;  // or of rows
  std::vector<double> of_test;
};

// The numbers that the tests bear in their names, if these tell them apart and lie close enough for an axis.
TestNumbers numbers_of(const Campaign& campaign) {
  TestNumbers numbers{true, {}};
  std::set<double> seen;
  for (const auto& test : campaign.tests) {
    const auto number = number_named_in(test.name);
    numbers.of_test.push_back(number.value_or(0));
    if (test.summary) numbers.of_names = numbers.of_names && number && seen.insert(*number).second;
  }
  const auto tests = static_cast<double>(campaign.tests.size());
  if (numbers.of_names && !seen.empty() && *seen.rbegin() - *seen.begin() <= 4 * tests + 10) return numbers;
  numbers.of_names = false;
  for (std::size_t i = 0; i < numbers.of_test.size(); ++i) numbers.of_test[i] = static_cast<double>(i + 1);
  return numbers;
}

const CategorySummary* summary_of(const Campaign& campaign, std::optional<SawtoothCategory> category) {
  const auto found = std::find_if(campaign.categories.begin(), campaign.categories.end(),
                                  [&](const CategorySummary& summary) { return summary.category == category; });
  return found == campaign.categories.end() ? nullptr : &*found;
}

double mean_of(const CategorySummary* summary, Spread CategorySpread::*spread) {
  return summary && (summary->without_suspects.*spread).count > 0 ? (summary->without_suspects.*spread).mean
                                                                  : not_known;
}

constexpr Style mean_look{.width = 1.4}, all_look{.colour = Colour::grey};

}  // namespace

Plot distribution_figure(const Campaign& campaign) {
  if (std::none_of(campaign.tests.begin(), campaign.tests.end(),
                   [](const auto& test) { return test.summary.has_value(); }))
    throw std::invalid_argument("distribution_figure: no test has a summary");
  const TestNumbers numbers = numbers_of(campaign);
  std::vector<double> wavelengths;
  for (const auto& test : campaign.tests)
    if (test.summary && test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
  const TableUnit best = best_unit_of(wavelengths, kind::length);
  const PlotUnit length{typeset(best.name), best.factor};

  PlotTable tests{"tests",
                  {"test", "category (0 clear; 1 nominal; 2 none)", "suspect", "mu0", "mu0 low", "mu0 high",
                   length.column("wavelength"), length.column("low"), length.column("high"), "wave claimed"}};
  double first = INFINITY, last = -INFINITY, shortest = INFINITY, longest = 0, highest = 1;
  for (std::size_t i = 0; i < campaign.tests.size(); ++i) {
    if (!campaign.tests[i].summary) continue;
    const TestSummary& test = *campaign.tests[i].summary;
    const bool has_wave = test.category != SawtoothCategory::none && test.wavelength && test.amplitude;
    const double mu0 = test.mu0_is_bound ? not_known : test.mu0.value;  // a limit is a line without a mark
    const Estimate wave = has_wave ? *test.wavelength : Estimate{not_known, not_known, not_known, not_known};
    tests.rows.push_back({numbers.of_test[i], static_cast<double>(test.category), test.suspect ? 1.0 : 0.0, mu0,
                          test.mu0.low, test.mu0.high, length(wave.value), length(wave.low), length(wave.high),
                          test.wave_claimed ? 1.0 : 0.0});
    first = std::min(first, numbers.of_test[i]);
    last = std::max(last, numbers.of_test[i]);
    shortest = std::fmin(shortest, length(wave.value));
    longest = std::fmax(longest, length(wave.value));
    highest = std::fmax(highest, test.mu0.high);
  }
  const double space = std::max(1.0, 0.07 * (last - first));
  const bool logarithmic = shortest > 0 && longest > 8 * shortest;
  const Axis x{numbers.of_names ? "Test number" : "Test, counted in the order of the table", "", first - space,
               last + space};
  const Axis wavelength{"Wavelength *λ*", length.unit, logarithmic ? shortest / 1.5 : 0,
                        longest > 0 ? (logarithmic ? 1.5 : 1.12) * longest : 1, logarithmic};
  const Axis friction{"Mean friction *μ*_0", "", -0.035 * highest, 1.06 * highest};

  // Of the tests of a category; without suspects, or only these.
  const auto of = [](const CategoryLook& look, std::vector<Condition> more) {
    more.push_back({1, static_cast<double>(look.category)});
    return more;
  };
  const auto symbols = [](const CategoryLook& look, Colour colour) {
    return Style{colour, 1, Dash::solid, look.symbol, look.size};
  };
  std::vector<Panel> panels;
  for (const auto& look : {looks[0], looks[1]}) {
    const double mean = length(mean_of(summary_of(campaign, look.category), &CategorySpread::wavelength));
    Panel panel{
        .title = fmt::format(
            "{}{}\n{}", panels.empty() ? "A: " : "", look.title,
            std::isfinite(mean) ? fmt::format("mean {:.{}f} {}", mean, mean < 100 ? 1 : 0, length.unit) : "no mean"),
        .x = x,
        .y = wavelength,
        .marks = {marks::only(marks::bars("tests", {0, 7, 8}, {Colour::grey, 0.8}), of(look, {})),
                  marks::only(marks::points("tests", {0, 6}, symbols(look, Colour::black)), of(look, {{2, 0}, {9, 1}})),
                  marks::only(marks::points("tests", {0, 6}, symbols(look, Colour::grey)), of(look, {{2, 0}, {9, 0}})),
                  marks::only(marks::points("tests", {0, 6}, styles::suspect), of(look, {{2, 1}}))}};
    if (std::isfinite(mean)) panel.marks.push_back(marks::horizontal({mean}, mean_look));
    panels.push_back(std::move(panel));
  }
  const double all = mean_of(summary_of(campaign, std::nullopt), &CategorySpread::mu0);
  const auto literature = literature_of(campaign);
  for (const auto& look : looks) {
    const double mean = mean_of(summary_of(campaign, look.category), &CategorySpread::mu0);
    Panel panel{.title = fmt::format("{}{}\n{}", panels.size() == 2 ? "B: " : "", look.title,
                                     std::isfinite(mean) ? fmt::format("mean {:.3f}", mean) : "no mean"),
                .x = x,
                .y = friction,
                .marks = {}};
    if (literature)
      panel.marks.push_back(
          marks::rectangle({-marks::edge, marks::edge, literature->low, literature->high}, styles::literature));
    if (std::isfinite(all)) panel.marks.push_back(marks::horizontal({all}, all_look));
    panel.marks.push_back(marks::only(marks::bars("tests", {0, 4, 5}, {.width = 0.7}), of(look, {})));
    panel.marks.push_back(
        marks::only(marks::points("tests", {0, 3}, symbols(look, Colour::black)), of(look, {{2, 0}})));
    panel.marks.push_back(marks::only(marks::points("tests", {0, 3}, styles::suspect), of(look, {{2, 1}})));
    if (std::isfinite(mean)) panel.marks.push_back(marks::horizontal({mean}, mean_look));
    panels.push_back(std::move(panel));
  }
  std::vector<Mark> entries{
      marks::key_points(styles::suspect, "Suspect"), marks::key_line(mean_look, "Mean, suspects left out"),
      marks::key_points({Colour::grey, 1, Dash::solid, Symbol::square, 3.5}, "Wave only indicative"),
      marks::key_line(all_look,
                      std::isfinite(all) ? fmt::format("Mean of all, likewise: {:.3f}", all) : "Mean of all, likewise"),
      marks::key_line({.width = 0.7}, "95 %; without a mark: limits")};
  if (literature)
    entries.push_back(marks::key_fill(styles::literature,
                                      as_it_is(fmt::format("Literature, {} on {}: {:g}–{:g}", literature->specimen,
                                                           literature->support, literature->low, literature->high))));
  panels.front().marks.insert(panels.front().marks.end(), entries.begin(), entries.end());
  const std::string in_literature = literature ? fmt::format("{} on {}, {:g} to {:g}", literature->specimen,
                                                             literature->support, literature->low, literature->high)
                                               : "";
  return {
      .name = "distributions",
      .title = "Wavelength and mean friction of all tests",
      .caption = fmt::format(
          "A: wavelength of the friction along the specimen, with its 95 % interval, for tests with a sawtooth; grey "
          "where the wave is only indicative. B: mean friction, with its 95 % interval. Black lines: means of a "
          "category, grey line: mean of all. Red-orange "
          "crosses: suspect tests, which the means leave out.{}",
          literature ? fmt::format(" Green: what the literature gives for {}.", in_literature) : ""),
      .width = two_columns,
      .height = 84,
      .data = {std::move(tests)},
      .panels = std::move(panels),
      .columns = 5};
}

namespace {

constexpr std::size_t panels_across = 4, panels_down = 5;
constexpr std::size_t panels_on_page = panels_across * panels_down;
constexpr std::size_t longest_name = 20;  // [characters] above a panel

std::string clipped(const std::string& name) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < name.size(); ++i)
    if ((static_cast<unsigned char>(name[i]) & 0xc0) != 0x80 && ++characters == longest_name)
      return name.substr(0, i) + "…";
  return name;
}

double greatest_of(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

// Its friction, a line each.
std::string parameters_of(const TestSummary& test, const PlotUnit& wavelength) {
  if (!is_trusted(test.standing)) return "";
  std::string lines =
      fmt::format("*μ*_0 {} {:.3f}", test.mu0_is_bound ? "≤" : "=", test.mu0_is_bound ? test.mu0.high : test.mu0.value);
  if (test.wave_claimed && test.wavelength && test.amplitude)
    lines += fmt::format("\n*A* = {:.3f}\n*λ* = {:.3g} {}", test.amplitude->value, wavelength(test.wavelength->value),
                         wavelength.unit);
  return lines;
}

Plot atlas_page(const std::vector<const CampaignTest*>& tests, std::string name, std::string title) {
  double deepest = 0, strongest = 0, longest = 0;
  for (const auto* test : tests) {
    deepest = std::max(deepest, greatest_of(test->curves->deflection));
    strongest = std::max(strongest, greatest_of(test->curves->force));
    longest = std::max(longest, 0.01 * test->curves->span);
  }
  const PlotUnit w = plot_unit(deepest, kind::length, false, ""), F = plot_unit(strongest, kind::force, false, "");
  const PlotUnit wavelength = plot_unit(longest, kind::length, false, "");
  const std::vector<std::string> titles{"panel", w.column("deflection"), F.column("force")};
  PlotTable measured{"measured", titles}, model{"model", titles}, beam{"beam", titles},
      frictionless{"frictionless", titles}, drops{"drops", titles};
  std::vector<Panel> panels;
  std::string names;
  for (const auto* test : tests) {
    const CampaignCurves& curves = *test->curves;
    const TestSummary& summary = *test->summary;
    const auto panel = static_cast<double>(panels.size() + 1);
    const double w_max = greatest_of(curves.deflection), F_max = greatest_of(curves.force);
    const auto add = [&](PlotTable& table, const std::vector<std::vector<double>>& rows) {
      for (const auto& row : rows) table.rows.push_back(row.empty() ? row : std::vector{panel, row[0], row[1]});
      table.rows.emplace_back();
    };
    const auto line = [&](const std::vector<double>& deflection, const std::vector<double>& force) {
      std::vector<std::vector<double>> rows;
      for (std::size_t i = 0; i < std::min(deflection.size(), force.size()); ++i)
        rows.push_back({w(deflection[i]), F(force[i])});
      return rows;
    };
    add(measured, line(curves.deflection, curves.force));
    add(model, thinned(line(curves.model_deflection, curves.model_force), w(w_max), F(F_max)));
    const ForceCurve smooth = frictionless_curve(curves, summary.bending_stiffness.value);
    add(frictionless, line(smooth.deflection, smooth.force));
    const double initial = 48 * summary.bending_stiffness.value / std::pow(curves.span, 3);
    add(beam, line({0, w_max}, {0, initial * w_max}));
    // Load lines reach a little beyond the drops on both sides.
    for (const std::size_t before : curves.drops) {
      if (before + 1 >= curves.force.size()) continue;
      const double from = curves.force[before] + 0.06 * F_max,
                   to = std::max(curves.force[before + 1] - 0.16 * F_max, 0.0);
      const auto on_line = [&](double force) {
        return curves.deflection[before] - (force - curves.force[before]) / curves.load_train_stiffness;
      };
      add(drops, line({on_line(from), on_line(to)}, {from, to}));
    }
    const auto of_test = [&](const char* table, Style style) {
      return marks::only(marks::line(table, {1, 2}, style), {{0, panel}});
    };
    panels.push_back({.title = (summary.suspect ? "× " : "") + as_it_is(clipped(printable(test->name))),
                      .x = w.axis(deflection_label, 0, std::max(1.04 * w_max, 1e-9 / w.factor)),
                      .y = F.axis(force_label, 0, std::max(1.15 * F_max, 1e-9 / F.factor)),
                      .marks = {of_test("drops", styles::drop), of_test("beam", styles::euler),
                                of_test("frictionless", styles::frictionless), of_test("model", styles::fit),
                                of_test("measured", {Colour::blue, 0.9}),
                                marks::label(marks::edge, -marks::edge, parameters_of(summary, wavelength))}});
    names += (names.empty() ? "" : ", ") + printable(test->name);
  }
  const std::vector<Mark> entries{
      marks::key_line({Colour::blue, 0.9}, "Measured"), marks::key_line(styles::fit, "Model"),
      marks::key_line(styles::euler, "Euler–Bernoulli"), marks::key_line(styles::frictionless, "No friction"),
      marks::key_line(styles::drop, "Load lines")};
  panels.front().marks.insert(panels.front().marks.end(), entries.begin(), entries.end());
  const std::size_t rows = (tests.size() + panels_across - 1) / panels_across;
  return {
      .name = std::move(name),
      .title = title,
      .caption = title +
                 ": force against deflection at midspan, a panel a test. Blue: measured. Black: the mean of the fit "
                 "run forward. In the corner: the "
                 "mean friction of the fit, and A and λ where a wave is claimed. Orange: Euler–Bernoulli (dashed) and "
                 "the model without friction, with "
                 "the bending stiffness of the fit. Grey: load lines at the drops of the force, with the stiffness of "
                 "the load train as slope. ×: suspect.",
      .width = 183,
      .height = 16 + 46 * static_cast<double>(rows),
      .data = {std::move(measured), std::move(model), std::move(beam), std::move(frictionless), std::move(drops)},
      .panels = std::move(panels),
      .columns = panels_across};
}

}  // namespace

std::vector<Plot> atlas_pages(const Campaign& campaign) {
  std::vector<Plot> pages;
  const auto add_pages = [&](const std::string& key, const std::string& title,
                             const std::function<bool(const TestSummary&)>& belongs) {
    std::vector<const CampaignTest*> tests;
    for (const auto& test : campaign.tests)
      if (test.summary && test.curves && !test.curves->force.empty() && belongs(*test.summary)) tests.push_back(&test);
    const std::size_t count = (tests.size() + panels_on_page - 1) / panels_on_page;
    for (std::size_t page = 0; page < count; ++page) {
      const auto begin = tests.begin() + static_cast<std::ptrdiff_t>(page * panels_on_page);
      const auto end = tests.begin() + static_cast<std::ptrdiff_t>(std::min((page + 1) * panels_on_page, tests.size()));
      pages.push_back(atlas_page({begin, end}, fmt::format("atlas-{}-{}", key, page + 1),
                                 count == 1 ? title : fmt::format("{}, page {} of {}", title, page + 1, count)));
    }
  };
  for (const auto& look : looks) {
    std::string title(look.title);
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    add_pages(std::string(name_of(look.category)), title,
              [&](const TestSummary& test) { return test.category == look.category; });
  }
  add_pages("suspect", "Suspect tests", [](const TestSummary& test) { return test.suspect; });
  return pages;
}

}  // namespace flexslip
