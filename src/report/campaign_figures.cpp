#include "report/campaign_figures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "bending_test/equilibrium.h"
#include "fibre/limits.h"
#include "io/text.h"
#include "io/text_table.h"
#include "report/campaign_words.h"
#include "result/table.h"

namespace flexslip {
namespace {

struct CategoryLook {
  SawtoothCategory category;
  std::string_view title;
  int point, size_percent;  // of gnuplot
};
constexpr std::array<CategoryLook, 3> looks{{{SawtoothCategory::clear, "clear sawtooth", 3, 75},
                                             {SawtoothCategory::nominal, "nominal sawtooth", 9, 80},
                                             {SawtoothCategory::none, "almost no sawtooth", 7, 55}}};

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

double at_screen(double millimetres, double whole) { return millimetres / whole; }

// The margins of a panel of a multiplot, from millimetres from the left and from the top.
std::string margins(const Figure& figure, double left, double right, double top, double bottom) {
  return fmt::format(
      "  set lmargin at screen {:.5f}; set rmargin at screen {:.5f}; set tmargin at screen {:.5f}; set bmargin at "
      "screen {:.5f}\n",
      at_screen(left, figure.width), at_screen(right, figure.width), 1 - at_screen(top, figure.height),
      1 - at_screen(bottom, figure.height));
}

// A legend laid out in millimetres from the left and the top: gnuplot's own key has another width in each kind of picture.
struct LegendEntry {
  double left, top;       // [mm]
  std::string_view mark;  // of an arrow, or of a point
  bool is_point;
  std::string words;
};

constexpr int first_tag = 20;  // of the labels and arrows of a legend; those below are for others

std::string legend(const Figure& figure, const std::vector<LegendEntry>& entries) {
  constexpr double mark_width = 7, space = 1.5;  // [mm]
  std::string script;
  int tag = first_tag;
  for (const auto& entry : entries) {
    const double y = 1 - at_screen(entry.top, figure.height);
    const auto x = [&](double after) { return at_screen(entry.left + after, figure.width); };
    script += entry.is_point
                  ? fmt::format("  set label {} '' at screen {:.5f},{:.5f} point {}\n", tag++, x(mark_width / 2), y,
                                entry.mark)
                  : fmt::format("  set arrow {} from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead {}\n", tag++,
                                x(0), y, x(mark_width), y, entry.mark);
    script +=
        fmt::format("  set label {} '{}' at screen {:.5f},{:.5f} left\n", tag++, entry.words, x(mark_width + space), y);
  }
  return script;
}

// A legend is drawn with the first panel only: once more over it would be bolder.
std::string no_legend(std::size_t entries) {
  const int end = first_tag + 2 * static_cast<int>(entries);
  return fmt::format("  do for [tag={}:{}] {{ unset label tag; unset arrow tag }}\n", first_tag, end - 1);
}

const CategorySummary* summary_of(const Campaign& campaign, std::optional<SawtoothCategory> category) {
  const auto found = std::find_if(campaign.categories.begin(), campaign.categories.end(),
                                  [&](const CategorySummary& summary) { return summary.category == category; });
  return found == campaign.categories.end() ? nullptr : &*found;
}

double mean_of(const CategorySummary* summary, Spread CategorySpread::*spread) {
  return summary && (summary->without_suspects.*spread).count > 0 ? (summary->without_suspects.*spread).mean
                                                                  : not_a_number;
}

std::string mean_in_words(double mean, double factor, int digits) {
  return std::isfinite(mean) ? fmt::format("mean {:.{}f}", factor * mean, digits) : "no mean";
}

struct CurveExtent {
  double low, high;
};

std::string mean_line(double mean, const CurveExtent& along, std::string_view looks_like) {
  if (!std::isfinite(mean)) return "";
  return fmt::format("  set arrow 1 from {:.6g},{:.6g} to {:.6g},{:.6g} nohead front {}\n", along.low, mean, along.high,
                     mean, looks_like);
}

// --- The atlas ----------------------------------------------------------------------------------------------------------

constexpr std::size_t panels_across = 4;
constexpr std::size_t panels_down = 5;
constexpr std::size_t panels_on_page = panels_across * panels_down;
constexpr double panel_width = 36, panel_height = 35;   // [mm] of the axes
constexpr double panel_across = 44.5, panel_down = 46;  // [mm] from one to the next
constexpr double page_left = 13.5, page_top = 19;       // [mm] to the axes of the first
constexpr double page_foot = 13;                        // [mm] below the axes of the last row
constexpr std::size_t longest_name = 22;                // [characters] above a panel

std::string clipped(const std::string& name) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < name.size(); ++i)
    if ((static_cast<unsigned char>(name[i]) & 0xc0) != 0x80 && ++characters == longest_name)
      return name.substr(0, i) + "…";
  return name;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

// Its friction, in lines of gnuplot's markup.
std::vector<std::string> parameter_lines(const TestSummary& test, const PlotUnit& wavelength) {
  if (!is_trusted(test.standing)) return {};
  std::vector<std::string> lines{fmt::format("{{/*0.92 {{/:Italic μ}}_0 {} {:.3f}}}", test.mu0_is_bound ? "≤" : "=",
                                             test.mu0_is_bound ? test.mu0.high : test.mu0.value)};
  if (test.wave_claimed && test.wavelength && test.amplitude) {
    lines.push_back(fmt::format("{{/*0.92 {{/:Italic A}} = {:.3f}}}", test.amplitude->value));
    lines.push_back(fmt::format("{{/*0.92 {{/:Italic λ}} = {:.3g}\u00a0{}}}",
                                wavelength.factor * test.wavelength->value, wavelength.unit));
  }
  return lines;
}

class AtlasPage {
 public:
  AtlasPage(const std::vector<const CampaignTest*>& tests, std::string name, const std::string& title) {
    const std::size_t rows = (tests.size() + panels_across - 1) / panels_across;
    figure_ = {.name = std::move(name),
               .title = title,
               .description = {},
               .width = page_left + static_cast<double>(panels_across - 1) * panel_across + panel_width + 1.5,
               .height = page_top + static_cast<double>(rows - 1) * panel_down + panel_height + page_foot,
               .data = {},
               .script = {}};
    double deepest = 0, strongest = 0, longest = 0;
    for (const auto* test : tests) {
      deepest = std::max(deepest, largest(test->curves->deflection));
      strongest = std::max(strongest, largest(test->curves->force));
      longest = std::max(longest, 0.01 * test->curves->span);
    }
    length_ = plot_unit(deepest, kind::length, false, "");
    force_ = plot_unit(strongest, kind::force, false, "");
    wavelength_ = plot_unit(longest, kind::length, false, "");
    const std::string w = fmt::format("deflection [{}]", length_.unit);
    const std::string F = fmt::format("force [{}]", force_.unit);
    measured_ = {"measured", {"panel", w, F}, {}};
    model_ = {"model", {"panel", w, F}, {}};
    references_ = {"references", {"panel", w, "Euler-Bernoulli " + F, "frictionless " + F}, {}};
    drops_ = {"drops", {"panel", w, F}, {}};
    begin(title);
    std::string names;
    for (std::size_t i = 0; i < tests.size(); ++i) {
      add(*tests[i], i);
      names += (i == 0 ? "" : ", ") + printable(tests[i]->name);
    }
    figure_.script += "  unset multiplot; unset label; set xtics auto; set ytics auto\n";
    figure_.description = fmt::format(
        "A panel a test ({}): measured force against deflection at midspan, the model, the Euler-Bernoulli line, the "
        "model without friction, and load lines at the drops of the force.",
        names);
    figure_.data = {std::move(measured_), std::move(model_), std::move(references_), std::move(drops_)};
  }
  Figure figure() && { return std::move(figure_); }

 private:
  void begin(const std::string& title) {
    figure_.script += fmt::format(
        R"(  set multiplot
  set format x '{{/*0.86 %g}}'; set format y '{{/*0.86 %g}}'
  set xtics offset 0,0.35; set ytics offset 0.5,0
  set label 1 {title} at screen {left:.5f},{top:.5f} left
  set label 2 '{length}' at screen 0.5,{foot:.5f} center
  set label 3 '{force}' at screen {side:.5f},0.5 center rotate by 90
)",
        fmt::arg("title", in_script(title)), fmt::arg("left", at_screen(page_left, figure_.width)),
        fmt::arg("top", 1 - at_screen(3.2, figure_.height)), fmt::arg("foot", at_screen(3, figure_.height)),
        fmt::arg("side", at_screen(3, figure_.width)),
        fmt::arg("length", axis_label("Deflection at midspan", "{/:Italic w}_0", length_)),
        fmt::arg("force", axis_label("Force", "{/:Italic F}", force_)));
    constexpr double top = 8, step = 34;  // [mm]
    const auto at = [](int entry) { return page_left + step * entry; };
    // No neighbours of one colour: the SVG terminal would give both the dashes of the first.
    const std::vector<LegendEntry> entries{{at(0), top, "dt solid lw 1.1 lc rgb blue", false, "Measured"},
                                           {at(1), top, "dt solid lw 0.9 lc rgb 'black'", false, "Model"},
                                           {at(2), top, "dt (9,5) lw 0.9 lc rgb brown", false, "Euler–Bernoulli"},
                                           {at(3), top, "dt (5,4) lw 0.6 lc rgb grey", false, "Load lines"},
                                           {at(4), top, "dt solid lw 0.9 lc rgb brown", false, "No friction"}};
    figure_.script += legend(figure_, entries);
    after_first_panel_ = "  unset label 1; unset label 2; unset label 3\n" + no_legend(entries.size());
  }

  void add(const CampaignTest& test, std::size_t index) {
    const CampaignCurves& curves = *test.curves;
    const TestSummary& summary = *test.summary;
    const auto panel = static_cast<double>(index + 1);
    const double x = length_.factor;
    const double y = force_.factor;
    const double w_max = largest(curves.deflection);
    const double F_max = largest(curves.force);
    const auto line = [&](const std::vector<double>& w, const std::vector<double>& F) {
      std::vector<std::vector<double>> rows;
      rows.reserve(w.size());
      for (std::size_t i = 0; i < std::min(w.size(), F.size()); ++i) rows.push_back({x * w[i], y * F[i]});
      return rows;
    };
    const auto numbered = [&](std::vector<std::vector<double>> rows) {
      for (auto& row : rows) row.insert(row.begin(), panel);
      return rows;
    };
    for (auto& row : numbered(line(curves.deflection, curves.force))) measured_.rows.push_back(std::move(row));
    measured_.rows.emplace_back();
    for (auto& row : numbered(thinned(line(curves.model_deflection, curves.model_force), x * w_max, y * F_max)))
      model_.rows.push_back(std::move(row));
    model_.rows.emplace_back();

    const double reduced_deepest = w_max / curves.span;
    const double stiffness = summary.bending_stiffness.value;
    const double per_force = y * stiffness / (curves.span * curves.span);
    constexpr int points = 60;
    if (reduced_deepest > 0)
      for (const auto& point : sliding_up_to(reduced_deepest, 0, points))
        references_.rows.push_back({panel, x * curves.span * point.w, per_force * 48 * point.w, per_force * point.F});
    references_.rows.emplace_back();

    // Load lines reach a little beyond the drops on both sides.
    for (const std::size_t before : curves.drops) {
      if (before + 1 >= curves.force.size()) continue;
      const auto on_line = [&](double F) {
        return curves.deflection[before] - (F - curves.force[before]) / curves.load_train_stiffness;
      };
      const double above = curves.force[before] + 0.06 * F_max;
      const double below = std::max(curves.force[before + 1] - 0.16 * F_max, 0.0);
      for (const double F : {above, below}) drops_.rows.push_back({panel, x * on_line(F), y * F});
      drops_.rows.emplace_back();
    }

    // A label a line: the distance of lines within a label is another in each kind of picture.
    std::string parameters = "  unset label 6; unset label 7; unset label 8\n";
    const auto lines = parameter_lines(summary, wavelength_);
    for (std::size_t i = 0; i < lines.size(); ++i)
      parameters += fmt::format("  set label {} '{}' at graph 0.945,{:.3f} right front\n", 6 + i, lines[i],
                                0.075 + 0.1 * static_cast<double>(lines.size() - 1 - i));
    const double left = page_left + static_cast<double>(index % panels_across) * panel_across;
    const std::size_t row = index / panels_across;
    const double top = page_top + static_cast<double>(row) * panel_down;
    const double x_max = std::max(x * w_max * 1.04, 1e-9);
    const double y_max = std::max(y * F_max * 1.15, 1e-9);
    figure_.script += margins(figure_, left, left + panel_width, top, top + panel_height);
    figure_.script += fmt::format(
        R"(  set xrange [0:{x_max:.6g}]; set yrange [0:{y_max:.6g}]
  set xtics {x_step:.6g}; set ytics {y_step:.6g}
  set label 4 {name} at graph {name_at},1.065 left noenhanced
  set label 5 '{cross}' at graph 0,1.07 left textcolor rgb vermillion
{parameters}  plot drops using {panel}:3 with lines lw 0.6 dt (5,4) lc rgb grey, \
       references using {panel}:3 with lines lw 0.9 dt (9,5) lc rgb brown, \
       references using {panel}:4 with lines lw 0.9 lc rgb brown, \
       measured using {panel}:3 with lines lw 1.1 lc rgb blue, \
       model using {panel}:3 with lines lw 0.9 lc rgb 'black'
)",
        fmt::arg("x_max", x_max), fmt::arg("y_max", y_max), fmt::arg("x_step", tick_within(x_max / 2)),
        fmt::arg("y_step", tick_within(y_max / 2)), fmt::arg("name", in_script(clipped(printable(test.name)))),
        fmt::arg("name_at", summary.suspect ? 0.085 : 0.0), fmt::arg("cross", summary.suspect ? "{/:Bold ×}" : ""),
        fmt::arg("parameters", parameters), fmt::arg("panel", fmt::format("($1=={}?$2:NaN)", index + 1)));
    if (index == 0) figure_.script += after_first_panel_;
  }

  Figure figure_;
  std::string after_first_panel_;
  PlotUnit length_, force_, wavelength_;
  FigureData measured_, model_, references_, drops_;
};

}  // namespace

Figure distribution_figure(const Campaign& campaign) {
  if (std::none_of(campaign.tests.begin(), campaign.tests.end(),
                   [](const auto& test) { return test.summary.has_value(); }))
    throw std::invalid_argument("distribution_figure: no test has a summary");
  const TestNumbers numbers = numbers_of(campaign);
  std::vector<double> wavelengths;
  for (const auto& test : campaign.tests)
    if (test.summary && test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
  const TableUnit unit = best_unit_of(wavelengths, kind::length);
  const std::string length = typeset(unit.name);

  FigureData tests{"tests",
                   {"test", "category (0 clear, 1 nominal, 2 none)", "suspect", "mu0", "mu0 low", "mu0 high",
                    fmt::format("wavelength [{}]", length), fmt::format("low [{}]", length),
                    fmt::format("high [{}]", length), "wave claimed"},
                   {}};
  CurveExtent along{not_a_number, not_a_number}, waves{not_a_number, not_a_number};
  double highest = 1;
  for (std::size_t i = 0; i < campaign.tests.size(); ++i) {
    if (!campaign.tests[i].summary) continue;
    const TestSummary& test = *campaign.tests[i].summary;
    const bool has_wave = test.category != SawtoothCategory::none && test.wavelength && test.amplitude;
    const double mu0 = test.mu0_is_bound ? not_a_number : test.mu0.value;  // a limit is a line without a mark
    const double wavelength = has_wave ? unit.factor * test.wavelength->value : not_a_number;
    const double low = has_wave ? unit.factor * test.wavelength->low : not_a_number;
    const double high = has_wave ? unit.factor * test.wavelength->high : not_a_number;
    tests.rows.push_back({numbers.of_test[i], static_cast<double>(test.category), test.suspect ? 1.0 : 0.0, mu0,
                          test.mu0.low, test.mu0.high, wavelength, low, high, test.wave_claimed ? 1.0 : 0.0});
    along = {std::fmin(along.low, numbers.of_test[i]), std::fmax(along.high, numbers.of_test[i])};
    waves = {std::fmin(waves.low, wavelength), std::fmax(waves.high, wavelength)};
    highest = std::fmax(highest, test.mu0.high);
  }
  const double space = std::max(1.0, 0.07 * (along.high - along.low));
  along = {along.low - space, along.high + space};
  const bool has_waves = std::isfinite(waves.low);
  const bool logarithmic = has_waves && waves.low > 0 && waves.high > 8 * waves.low;
  if (!has_waves) waves = {0, 1};
  waves = logarithmic ? CurveExtent{waves.low / 1.5, waves.high * 1.5} : CurveExtent{0, 1.12 * waves.high};

  Figure figure{.name = "distributions",
                .title = "Wavelength and mean friction of all tests",
                .description = {},
                .width = two_columns,
                .height = 84,
                .data = {std::move(tests)}};
  constexpr double top = 19, bottom = 72.5;                // [mm] of the axes
  constexpr double first = 12.5, panel = 26, gap = 2.5;    // [mm]
  constexpr double second = first + 2 * panel + gap + 17;  // [mm] where (B) begins
  const double step = std::max(1.0, tick_within((along.high - along.low) / 2.2));
  figure.script = fmt::format(
      R"(  set multiplot
  set xrange [{low:.6g}:{high:.6g}]
  set xtics {first_tick:.6g},{step:.6g},{last_tick:.6g}; set format x '{{/*0.9 %g}}'
  set label 2 '{{/:Bold A}}' at screen 0.008,0.845 left
  set label 3 '{{/:Bold B}}' at screen {b_at:.5f},0.845 left
  set label 4 '{tests}' at screen 0.5,0.035 center
)",
      fmt::arg("low", along.low), fmt::arg("high", along.high), fmt::arg("b_at", (second - 11) / figure.width),
      fmt::arg("step", step), fmt::arg("first_tick", step * std::ceil(along.low / step)),
      fmt::arg("last_tick", along.high - 0.2 * step),  // or its number meets the first one of the next panel
      fmt::arg("tests", numbers.of_names ? "Test number" : "Test, counted in the order of the table"));
  const double all = mean_of(summary_of(campaign, std::nullopt), &CategorySpread::mu0);
  constexpr double row1 = 3.5, row2 = 8, column1 = first, column2 = first + 43, column3 = first + 102;  // [mm]
  const auto literature = literature_of(campaign);
  std::vector<LegendEntry> entries{
      {column1, row1, "pt 2 ps 0.8 lw 1.6 lc rgb vermillion", true, "Suspect"},
      {column1, row2, "pt 5 ps 0.6 lc rgb grey", true, "Wave only indicative"},
      {column2, row1, "dt solid lw 1.4 lc rgb 'black'", false, "Mean, suspects left out"},
      {column2, row2, "dt solid lw 1 lc rgb grey", false,
       fmt::format("Mean of all, likewise{}", std::isfinite(all) ? fmt::format(": {:.3f}", all) : "")},
      {column3, row2, "dt solid lw 0.7 lc rgb 'black'", false, "95 % intervals; without a mark: limits"}};
  if (literature)
    entries.push_back({column3, row1, "dt solid lw 8 lc rgb '#D6EFE7'", false,
                       fmt::format("Literature: {} on {}, {:g}–{:g}", literature->specimen, literature->support,
                                   literature->low, literature->high)});
  figure.script += legend(figure, entries);
  std::string after_first_panel = no_legend(entries.size());
  const auto panel_script = [&](double left, const CategoryLook& look, double mean, const std::string& words,
                                std::string_view body) {
    figure.script += margins(figure, left, left + panel, top, bottom);
    figure.script += fmt::format(
        "  set label 1 '{{/*0.9 {}}}' at graph 0.5,1.11 center\n  set label 5 '{{/*0.9 {}}}' at graph 0.5,1.045 "
        "center\n",
        look.title, words);
    figure.script += mean_line(mean, along, "lw 1.4 lc rgb 'black'");
    figure.script += body;
    figure.script += std::exchange(after_first_panel, "");
    figure.script += "  unset arrow 1; unset label; set format y ''; unset ylabel\n";
  };
  const auto index_of = [](const CategoryLook& look) { return static_cast<int>(look.category); };

  // (A)
  figure.script += logarithmic
                       ? fmt::format("  set logscale y; set ytics ({})\n", logarithmic_tics(waves.low, waves.high))
                       : std::string();
  figure.script +=
      fmt::format("  set yrange [{:.6g}:{:.6g}]\n  set label 6 '{}' at screen 0.012,0.46 center rotate by 90\n",
                  waves.low, waves.high, axis_label("Wavelength", "{/:Italic λ}", {length, unit.factor}));
  for (const auto& look : {looks[0], looks[1]}) {
    const double mean = unit.factor * mean_of(summary_of(campaign, look.category), &CategorySpread::wavelength);
    const int k = index_of(look);
    panel_script(
        first + (k == 0 ? 0 : panel + gap), look, mean,
        std::isfinite(mean) ? fmt::format("mean {:.{}f} {}", mean, mean < 100 ? 1 : 0, length) : "no mean",
        fmt::format(R"(  plot tests using 1:($2=={k}?$8:NaN):(0):($9-$8) with vectors nohead lw 0.8 lc rgb grey, \
       tests using ($2=={k}&&$3==0&&$10==1?$1:NaN):7 with points pt {pt} ps {ps} lw 1 lc rgb 'black', \
       tests using ($2=={k}&&$3==0&&$10==0?$1:NaN):7 with points pt {pt} ps {ps} lw 1 lc rgb grey, \
       tests using ($2=={k}&&$3==1?$1:NaN):7 with points pt 2 ps 0.8 lw 1.6 lc rgb vermillion
)",
                    fmt::arg("k", k), fmt::arg("pt", look.point), fmt::arg("ps", look.size_percent / 100.0)));
  }
  // (B)
  figure.script += fmt::format(
      R"(  unset logscale y; set format y '%g'; set ytics auto; set mytics 2
  set yrange [{bottom:.6g}:{top:.6g}]
  set ylabel 'Mean friction {{/:Italic μ}}_0' offset 0.2
)",
      fmt::arg("bottom", -0.035 * highest), fmt::arg("top", 1.06 * highest));
  if (literature)
    figure.script += fmt::format(
        "  set object 1 rectangle from graph 0, first {} to graph 1, first {} behind fc rgb green fs transparent solid "
        "0.16 noborder\n",
        literature->low, literature->high);
  if (std::isfinite(all))
    figure.script += fmt::format("  set arrow 2 from {:.6g},{:.6g} to {:.6g},{:.6g} nohead back lw 1 lc rgb grey\n",
                                 along.low, all, along.high, all);
  for (const auto& look : looks) {
    const double mean = mean_of(summary_of(campaign, look.category), &CategorySpread::mu0);
    const int k = index_of(look);
    panel_script(
        second + k * (panel + gap), look, mean, mean_in_words(mean, 1, 3),
        fmt::format(R"(  plot tests using 1:($2=={k}?$5:NaN):(0):($6-$5) with vectors nohead lw 0.7 lc rgb 'black', \
       tests using ($2=={k}&&$3==0?$1:NaN):4 with points pt {pt} ps {ps} lw 1 lc rgb 'black', \
       tests using ($2=={k}&&$3==1?$1:NaN):4 with points pt 2 ps 0.8 lw 1.6 lc rgb vermillion
)",
                    fmt::arg("k", k), fmt::arg("pt", look.point), fmt::arg("ps", look.size_percent / 100.0)));
  }
  figure.script += "  unset multiplot; unset object 1; unset arrow 2; unset label 1; set format; set xtics auto\n";
  figure.description = fmt::format(
      "A: wavelength of the friction along the specimen, by test, for tests with a clear and with a nominal sawtooth. "
      "B: mean friction by test, with its mean without suspects ({}){}.",
      mean_in_words(all, 1, 3),
      literature ? fmt::format(" and the literature's range for {} on {}, {:g} to {:g}", literature->specimen,
                               literature->support, literature->low, literature->high)
                 : "");
  return figure;
}

std::vector<Figure> atlas_pages(const Campaign& campaign) {
  std::vector<Figure> pages;
  const auto add_pages = [&](const std::string& key, const std::string& title,
                             const std::function<bool(const TestSummary&)>& belongs) {
    std::vector<const CampaignTest*> tests;
    for (const auto& test : campaign.tests)
      if (test.summary && test.curves && !test.curves->force.empty() && belongs(*test.summary)) tests.push_back(&test);
    const std::size_t count = (tests.size() + panels_on_page - 1) / panels_on_page;
    for (std::size_t page = 0; page < count; ++page) {
      const auto begin = tests.begin() + static_cast<std::ptrdiff_t>(page * panels_on_page);
      const auto end = tests.begin() + static_cast<std::ptrdiff_t>(std::min((page + 1) * panels_on_page, tests.size()));
      pages.push_back(AtlasPage({begin, end}, fmt::format("atlas-{}-{}", key, page + 1),
                                count == 1 ? title : fmt::format("{}, page {} of {}", title, page + 1, count))
                          .figure());
    }
  };
  for (const auto& look : looks)
    add_pages(
        std::string(name_of(look.category)),
        [&] {
          std::string title(look.title);
          title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
          return title;
        }(),
        [&](const TestSummary& test) { return test.category == look.category; });
  add_pages("suspect", "Suspect tests", [](const TestSummary& test) { return test.suspect; });
  return pages;
}

}  // namespace flexslip
