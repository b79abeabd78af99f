#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "finding/printed.h"
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

// True if a word of a name ends before this position.
bool is_between_words(std::string_view name, std::size_t at) {
  return at == 0 || at >= name.size() || std::string_view(" ,;:_-/").find(name[at - 1]) != std::string_view::npos;
}

// The common beginning of names up to the end of a word [bytes].
std::size_t common_beginning(const std::vector<std::string>& names) {
  std::size_t common = names.front().size();
  for (const std::string& name : names) {
    const auto [end, other] = std::mismatch(name.begin(), name.end(), names.front().begin(),
                                            names.front().begin() + static_cast<std::ptrdiff_t>(common));
    common = static_cast<std::size_t>(end - name.begin());
  }
  while (common > 0 && (!is_between_words(names.front(), common) || common == names.front().size())) --common;
  return common;
}

// The characters of a text in UTF-8.
std::vector<std::string> characters_of(const std::string& text) {
  std::vector<std::string> characters;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xc0) != 0x80 || characters.empty()) characters.emplace_back();
    characters.back() += c;
  }
  return characters;
}

// At most 20 characters: the beginning and the end of a longer name.
std::string clipped(const std::string& name) {
  constexpr std::ptrdiff_t longest = 20, begin = 9, end = longest - begin - 1;
  const std::vector<std::string> characters = characters_of(name);
  if (std::ssize(characters) <= longest) return name;
  return fmt::format("{}…{}", fmt::join(characters.begin(), characters.begin() + begin, ""),
                     fmt::join(characters.end() - end, characters.end(), ""));
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

bool has_friction(const Campaign& campaign) {
  return std::any_of(campaign.tests.begin(), campaign.tests.end(), determines_friction);
}

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

std::vector<std::string> labels_of(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::vector<std::string> parts = names;
  for (int end = 0; end < 2 && names.size() > 1; ++end) {
    const std::size_t common = common_beginning(parts);
    for (std::string& part : parts) {
      part.erase(0, common);
      std::reverse(part.begin(), part.end());  // the second time forwards again
    }
  }
  const bool are_names = std::none_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); });
  std::vector<std::string> labels;
  for (const std::string& part : are_names ? parts : names) labels.push_back(clipped(printable(part)));
  const std::multiset<std::string> all(labels.begin(), labels.end());
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (all.count(labels[i]) > 1) labels[i] = clipped(fmt::format("{}: {}", i + 1, labels[i]));
  return labels;
}

namespace {

// An axis over the data, with room above them for the titles of the categories.
Axis axis_over(std::string label, std::string unit, double low, double high, bool logarithmic) {
  constexpr double below = 0.08, above = 0.45;  // [1] of the range of the data
  if (logarithmic) {
    const double range = high / low;
    return {std::move(label), std::move(unit), low / std::pow(range, below), high * std::pow(range, above), true};
  }
  const double range = high > low ? high - low : std::abs(high);
  return {std::move(label), std::move(unit), low - below * range, high + above * range};
}

// The label of each test of a campaign.
std::vector<std::string> test_labels(const Campaign& campaign) {
  std::vector<std::string> names;
  for (const CampaignTest& test : campaign.tests) names.push_back(test.name);
  return labels_of(names);
}

// The places of the tests that determine friction along the axis of a figure: a range for each
// category, wide enough for its title.
struct Places {
  struct Range {
    Category category;
    double from, to;
    std::vector<std::pair<std::size_t, double>> tests{};  // in the campaign, with their places
  };
  std::vector<Range> ranges;
  double end = 0;
};

constexpr double margins = 17;  // [mm] left and right of the places

// The width [mm] at which the name of each test has a place.
double width_for(const Campaign& campaign) {
  constexpr double place = 3.6;  // [mm]
  const auto tests = std::count_if(campaign.tests.begin(), campaign.tests.end(), determines_friction);
  return std::max(one_column, margins + place * static_cast<double>(tests + std::ssize(categories)));
}

Places places_of(const Campaign& campaign, double width) {
  constexpr double title = 24;  // [mm]
  std::vector<std::vector<std::size_t>> tests(categories.size());
  double count = 0, groups = 0;
  for (std::size_t k = 0; k < categories.size(); ++k) {
    for (std::size_t i = 0; i < campaign.tests.size(); ++i)
      if (determines_friction(campaign.tests[i]) && campaign.tests[i].summary->category == categories[k].category)
        tests[k].push_back(i);
    count += static_cast<double>(tests[k].size());
    groups += tests[k].empty() ? 0 : 1;
  }
  const double share = std::min(title / (width - margins), 1 / groups), least = share * (count + groups);
  Places places;
  for (std::size_t k = 0; k < categories.size(); ++k) {
    if (tests[k].empty()) continue;
    const auto here = static_cast<double>(tests[k].size());
    Places::Range range{categories[k], places.end, places.end + std::max(here + 1, least)};
    double place = (range.from + range.to + 1 - here) / 2;  // in the middle of the range
    for (const std::size_t i : tests[k]) range.tests.emplace_back(i, place++);
    places.end = range.to;
    places.ranges.push_back(std::move(range));
  }
  return places;
}

}  // namespace

Plot distribution_figure(const Campaign& campaign, double most_width) {
  const double width = std::min(most_width, width_for(campaign));
  const Places places = places_of(campaign, width);
  if (places.ranges.empty()) throw std::invalid_argument("distribution_figure: no test determines friction");
  std::vector<double> wavelengths;
  for (const auto& test : campaign.tests)
    if (test.summary && test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
  const TableUnit best = best_unit_of(wavelengths, kind::length);
  const PlotUnit length{typeset(best.name), best.factor};
  const std::vector<std::string> labels = test_labels(campaign);

  PlotTable tests{"tests",
                  {"place", "test (its number in the campaign)", "suspect", "mu0", "mu0 low", "mu0 high",
                   length.column("wavelength"), length.column("low"), length.column("high"), "wave claimed"}};
  const auto literature = literature_of(campaign);
  double shortest = infinity, longest = 0;
  double lowest = literature ? literature->low : infinity, highest = literature ? literature->high : 0;
  Axis x{"", "", 0, places.end};
  bool has_waves = false;
  for (const Places::Range& range : places.ranges)
    for (const auto& [i, place] : range.tests) {
      const TestSummary& test = *campaign.tests[i].summary;
      const bool has_wave = test.category != SawtoothCategory::none && test.wavelength && test.amplitude;
      // a limit is drawn as a line without a mark
      const double mu0 = test.mu0_is_bound ? not_known : test.mu0.value;
      const Estimate wave = has_wave ? *test.wavelength : Estimate{not_known, not_known, not_known, not_known};
      tests.rows.push_back({place, static_cast<double>(i + 1), test.suspect ? 1.0 : 0.0, mu0, test.mu0.low,
                            test.mu0.high, length(wave.value), length(wave.low), length(wave.high),
                            test.wave_claimed ? 1.0 : 0.0});
      x.names.push_back({place, as_it_is(labels[i])});
      has_waves = has_waves || has_wave;
      shortest = std::fmin(shortest, length(wave.low));
      longest = std::fmax(longest, length(wave.high));
      lowest = std::fmin(lowest, test.mu0.low);
      highest = std::fmax(highest, test.mu0.high);
    }
  const double all = mean_of(campaign, std::nullopt, &CategorySpread::mu0);
  // With one category the common mean equals the mean of that category.
  const bool has_common_mean = std::isfinite(all) && places.ranges.size() > 1;
  constexpr double two_lines_below = 32;  // [mm] the width of the title of a category
  constexpr Style mean_look{.width = 1.4}, all_look{.colour = colours::grey},
      indicative = styles::mark(Symbol::disc, colours::grey, 3.5);

  // All tests, with the mean of each category over its range. Values that are only indicative are
  // grey.
  const auto panel_of = [&](const Axis& y, std::size_t column, const auto& mean, const auto& mean_in_words) {
    const bool is_friction = column == 3;
    Panel panel{.x = x, .y = y};
    if (is_friction && literature)
      panel.marks.push_back(rectangle(-edge, literature->low, edge, literature->high, styles::literature));
    if (is_friction && has_common_mean) panel.marks.push_back(level(all, all_look));
    for (const Places::Range& range : places.ranges) {
      if (range.from > 0) panel.marks.push_back(upright(range.from, {.colour = colours::silver, .width = 0.75}));
      const double value = mean(range.category.category);
      if (std::isfinite(value))
        panel.marks.push_back({.style = mean_look, .title = "", .at = {range.from, value, range.to, value}});
      const bool is_narrow = (width - margins) * (range.to - range.from) / places.end < two_lines_below;
      panel.marks.push_back(label(
          (range.from + range.to) / 2, edge,
          (is_narrow ? replaced(range.category.title, " sawtooth", "\nsawtooth") : std::string(range.category.title)) +
              (std::isfinite(value) ? "\n" + mean_in_words(value) : "")));
    }
    panel.marks.push_back({Mark::bars, "tests", {0, column + 1, column + 2}, {.width = 0.7}});
    const Style disc = styles::mark(Symbol::disc, colours::black, 3.5);
    for (const auto& [style, conditions] : std::initializer_list<std::pair<Style, std::vector<Condition>>>{
             {disc, {{2, 0}, {9, 1}}},
             {is_friction ? disc : indicative, {{2, 0}, {9, 0}}},
             {styles::suspect, {{2, 1}}}})
      panel.marks.push_back({Mark::points, "tests", {0, column}, style, "", conditions});
    return panel;
  };
  std::vector<Panel> panels;
  if (has_waves)
    panels.push_back(panel_of(
        axis_over("Wavelength *λ*", length.unit, shortest, longest, shortest > 0 && longest > 8 * shortest), 6,
        [&](auto category) { return length(mean_of(campaign, category, &CategorySpread::wavelength)); },
        [&](double mean) { return fmt::format("mean {} {}", format_significant(mean, 3), length.unit); }));
  panels.push_back(panel_of(
      axis_over("Mean friction *μ*_0", "", lowest, highest, false), 3,
      [&](auto category) { return mean_of(campaign, category, &CategorySpread::mu0); },
      [](double mean) { return fmt::format("mean {:.2f}", mean); }));
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
    entries.push_back({.style = all_look, .title = fmt::format("Mean of all, without suspects: {:.2f}", all)});
  const bool has_suspects =
      has([](const auto& row) { return row[2] == 1 && (std::isfinite(row[3]) || std::isfinite(row[6])); });
  if (has_suspects) entries.push_back({.kind = Mark::points, .style = styles::suspect, .title = "Suspect"});
  const bool has_indicative = has([](const auto& row) { return row[2] == 0 && row[9] == 0 && std::isfinite(row[6]); });
  if (has_indicative) entries.push_back({.kind = Mark::points, .style = indicative, .title = "Wave not detected"});
  if (literature)
    entries.push_back({.kind = Mark::area,
                       .style = styles::literature,
                       .title = as_it_is(fmt::format("Literature, {} on {}: {:g}–{:g}", literature->specimen,
                                                     literature->support, literature->low, literature->high))});
  panels.front().marks.insert(panels.front().marks.end(), entries.begin(), entries.end());
  return {.name = "distributions",
          .title = "Wavelength and mean friction of all tests",
          .caption = fmt::format(
              "{}{}mean friction of each test that determines it, with its 95 % interval. Black lines: means of a "
              "category{}.{}{}",
              has_waves ? "Above: wavelength of the friction along the specimen, with its 95 % interval, for tests "
                          "with a sawtooth"
                        : "The ",
              !has_waves       ? ""
              : has_indicative ? "; grey where the wave is not detected, which the mean counts, too. Below: "
                               : ". Below: ",
              has_common_mean ? ", grey line: mean of all" : "",
              has_suspects ? " Red-orange crosses: suspect tests, which the means leave out." : "",
              literature ? fmt::format(" Green: what the literature gives for {} on {}, {:g} to {:g}.",
                                       literature->specimen, literature->support, literature->low, literature->high)
                         : ""),
          .width = width,
          .height = has_waves ? 120.0 : 80.0,
          .data = {std::move(tests)},
          .panels = std::move(panels)};
}

namespace {

constexpr double panel_width = 42;  // [mm]
constexpr std::size_t rows_on_page = 5;

// The parameters, one per line.
std::string parameters_of(const TestSummary& test, const PlotUnit& wavelength) {
  std::string lines =
      fmt::format("*μ*_0 {} {:.2f}", test.mu0_is_bound ? "≤" : "=", test.mu0_is_bound ? test.mu0.high : test.mu0.value);
  if (test.wave_claimed && test.wavelength && test.amplitude)
    lines += fmt::format("\n*A* = {:.2f}\n*λ* = {:.3g} {}", test.amplitude->value, wavelength(test.wavelength->value),
                         wavelength.unit);
  return lines;
}

struct LabelledTest {
  const CampaignTest* test;
  std::string label;
};

Plot atlas_page(std::span<const LabelledTest> tests, std::size_t across, std::string name, std::string title) {
  double deepest = 0, strongest = 0, longest = 0;
  for (const auto& [test, label] : tests) {
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
  for (const auto& [test, name_of_panel] : tests) {
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
    if (determines_friction(*test)) add(3, plane.thinned(line(curves.model_deflection, curves.model_force)).rows);
    add(4, line(curves.deflection, curves.force).rows);
    Panel panel{
        .title = (is_excluded(*test) ? "× " : "") + as_it_is(name_of_panel), .x = plane.x(1.04), .y = plane.y(1.15)};
    for (std::size_t k = 0; k < data.size(); ++k)
      if (std::any_of(data[k].rows.begin(), data[k].rows.end(),
                      [&](const auto& row) { return !row.empty() && row[0] == number; }))
        panel.marks.push_back({Mark::line, data[k].name, {1, 2}, looks[k], "", {{0, number}}});
    if (determines_friction(*test)) panel.marks.push_back(label(edge, -edge, parameters_of(summary, wavelength)));
    panels.push_back(std::move(panel));
  }
  for (std::size_t k = looks.size(); k-- > 0;)
    if (!data[k].rows.empty()) panels.front().marks.push_back({.style = looks[k], .title = words[k]});
  const std::size_t count = panels.size(), rows = (count + across - 1) / across;
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
      .width = count < 3 ? 100.0 : two_columns,
      .height = (count < 3 ? 24 : 16) + 46 * static_cast<double>(rows),
      .data = std::move(data),
      .panels = std::move(panels),
      .columns = across};
}

}  // namespace

std::vector<Plot> comparison_figures(const Campaign& campaign, double width) {
  std::vector<Plot> figures;
  if (has_friction(campaign)) figures.push_back(distribution_figure(campaign, width));
  if (has_losses(campaign)) figures.push_back(losses_figure(campaign));
  return figures;
}

std::vector<Plot> atlas_pages(const Campaign& campaign, double width) {
  const auto across = static_cast<std::size_t>(std::max(1.0, std::floor(width / panel_width)));
  const std::size_t panels_on_page = rows_on_page * across;
  const std::vector<std::string> labels = test_labels(campaign);
  std::vector<Plot> pages;
  const auto add_pages = [&](std::string_view key, const std::string& title,
                             const std::function<bool(const CampaignTest&)>& belongs) {
    std::vector<LabelledTest> tests;
    for (std::size_t i = 0; i < campaign.tests.size(); ++i) {
      const CampaignTest& test = campaign.tests[i];
      if (test.summary && test.curves && !test.curves->force.empty() && belongs(test))
        tests.push_back({&test, labels[i]});
    }
    const std::size_t count = (tests.size() + panels_on_page - 1) / panels_on_page;
    for (std::size_t page = 0; page < count; ++page) {
      const std::size_t first = page * panels_on_page, here = std::min(panels_on_page, tests.size() - first);
      pages.push_back(atlas_page(std::span(tests).subspan(first, here), across,
                                 fmt::format("atlas-{}-{}", key, page + 1),
                                 count == 1 ? title : fmt::format("{}, page {} of {}", title, page + 1, count)));
    }
  };
  for (const Category& each : categories)
    add_pages(name_of(each.category), capitalised(each.title),
              [&](const CampaignTest& test) { return test.summary->category == each.category; });
  add_pages("suspect", "Suspect tests", is_excluded);
  return pages;
}

}  // namespace flexslip
