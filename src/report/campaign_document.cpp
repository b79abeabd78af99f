#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answers/campaign_fields.h"
#include "finding/finding.h"
#include "finding/printed.h"
#include "io/quantity.h"
#include "io/text.h"
#include "numerics/statistics.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip {
namespace {

constexpr std::size_t max_name_width = 24;  // [characters] so that its row has room for the answer

// ---- Numbers in print

// The readable unit of a length, modulus or bending stiffness.
TableUnit print_unit(double value, const std::string& si_unit) {
  if (si_unit == "1") return {"", 1};
  const Unit si = parse_unit(si_unit);
  for (const Kind* kind : {&kind::length, &kind::pressure, &kind::bending_stiffness})
    if (kind->dimension == si.dimension) return best_unit_of({value}, *kind);
  return {si_unit, 1};
}

struct CampaignUnits {
  TableUnit length, bending_stiffness, force, energy, modulus, strength;
};

CampaignUnits units_of(const Campaign& campaign) {
  std::vector<double> wavelengths, stiffnesses, residuals, works, moduli, strengths;
  for (const auto& test : campaign.tests) {
    if (test.standard) moduli.push_back(test.standard->modulus.value);
    if (test.standard && std::isfinite(test.standard->strength)) strengths.push_back(test.standard->strength);
    if (!test.summary) continue;
    if (test.summary->wavelength) wavelengths.push_back(test.summary->wavelength->value);
    stiffnesses.push_back(test.summary->bending_stiffness.value);
    residuals.push_back(test.summary->residual_rms);
    works.push_back(test.summary->work_of_fracture);
  }
  return {
      best_unit_of(std::move(wavelengths), kind::length), best_unit_of(std::move(stiffnesses), kind::bending_stiffness),
      best_unit_of(std::move(residuals), kind::force),    best_unit_of(std::move(works), kind::energy),
      best_unit_of(std::move(moduli), kind::pressure),    best_unit_of(std::move(strengths), kind::pressure)};
}

std::string titled(std::string_view symbol, const TableUnit& unit) {
  return fmt::format("{} ({})", symbol, typeset(unit.name));
}

// Mean (minimum to maximum).
std::string of_spread(const Spread& spread, double factor, int decimals) {
  if (spread.count == 0) return "";
  const std::string mean = fmt::format("{:.{}f}", factor * spread.mean, decimals);
  return spread.count == 1 ? mean
                           : fmt::format("{} ({:.{}f} to {:.{}f})", mean, factor * spread.min, decimals,
                                         factor * spread.max, decimals);
}

// "at most 0.09", "at most 0.03 to 0.09".
std::string at_most(const Spread& limits) {
  return limits.count == 1
             ? fmt::format("at most {}", format_significant(limits.max, 2))
             : fmt::format("at most {} to {}", format_significant(limits.min, 2), format_significant(limits.max, 2));
}

// ---- Names

// The names of the tests as printed; if some are long, their labels in the figures.
std::vector<std::string> names_of(const Campaign& campaign) {
  std::vector<std::string> names;
  for (const auto& test : campaign.tests) names.push_back(printable(test.name));
  const bool are_short =
      std::all_of(names.begin(), names.end(), [](const auto& name) { return width_of(name) <= max_name_width; });
  return are_short ? names : labels_of(names);
}

template <class Use>
void for_each_test(const Campaign& campaign, Use use) {
  const std::vector<std::string> names = names_of(campaign);
  for (std::size_t i = 0; i < names.size(); ++i) use(campaign.tests[i], names[i]);
}

// The names behind the labels; empty if the names are printed.
Rows name_rows(const Campaign& campaign) {
  Rows rows;
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& label) {
    if (label != printable(test.name)) rows.push_back({label, printable(test.name)});
  });
  return rows;
}

// ---- The answer: the verdicts on one line, then a row for each number

template <class Predicate>
std::size_t count_of(const Campaign& campaign, Predicate belongs) {
  return static_cast<std::size_t>(std::count_if(campaign.tests.begin(), campaign.tests.end(), belongs));
}

// True if the test is missing from the table.
bool is_failure(const CampaignTest& test) { return !test.summary && !is_answered(test); }

// "SS8, SS32 and SS36", of at most eight.
std::string excluded_tests(const Campaign& campaign) {
  constexpr std::size_t max_names = 8;
  std::vector<std::string> names;
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    if (is_excluded(test)) names.push_back(name);
  });
  if (names.size() > max_names) {
    const std::size_t more = names.size() - max_names;
    names.resize(max_names);
    names.push_back(fmt::format("{} more", more));
  }
  return in_words(names, "and");
}

// "4 tests: 3 SLIP, 1 CRACK."
std::string verdicts_in_words(const Campaign& campaign, const ScreenStyle& style) {
  std::vector<std::string> counts;
  for (int i = 0; i <= static_cast<int>(VerdictCode::no_answer); ++i) {
    const auto code = static_cast<VerdictCode>(i);
    const std::size_t count =
        count_of(campaign, [&](const CampaignTest& test) { return test.verdict == word_of(code); });
    if (count > 0) counts.push_back(fmt::format("{} {}", count, verdict_word(code, style)));
  }
  return counts.empty()
             ? "No tests."
             : fmt::format("{}: {}.", format_count(campaign.tests.size(), "test", "tests"), fmt::join(counts, ", "));
}

// The spread over the tests that are not suspect, or over all if all are suspect; null without
// tests.
const CategorySpread* spread_of_all(const Campaign& campaign) {
  const auto all = std::find_if(campaign.categories.begin(), campaign.categories.end(),
                                [](const CategorySummary& category) { return !category.category; });
  if (all == campaign.categories.end()) return nullptr;
  return all->without_suspects.tests > 0 ? &all->without_suspects : &all->with_suspects;
}

// The conditions under which the mean friction holds.
std::string conditions_in_words(const Campaign& campaign) {
  const bool are_all_suspect = spread_of_all(campaign) == &campaign.categories.back().with_suspects;
  const auto counts = [&](const CampaignTest& test) {
    return test.summary && std::isfinite(test.summary->mu0.value) && (are_all_suspect || !test.summary->suspect);
  };
  // Cracks make drops, and cracks too small to detect make the force uneven.
  const std::size_t may_have_lost = count_of(campaign, [&](const CampaignTest& test) {
    return counts(test) && !test.summary->loss && (test.summary->drops > 0 || test.summary->measured.log_roughness);
  });
  const std::size_t undecided = count_of(campaign, [&](const CampaignTest& test) {
    return counts(test) && test.summary->drops > 0 && test.verdict == word_of(VerdictCode::undecided);
  });
  const std::size_t on_assumed_edges =
      count_of(campaign, [&](const CampaignTest& test) { return counts(test) && test.summary->on_assumed_edges; });
  std::vector<std::string> conditions;
  if (are_all_suspect) conditions.emplace_back("all tests are suspect");
  if (may_have_lost > 0) conditions.emplace_back("with no stiffness lost");
  if (undecided > 0)
    conditions.push_back(
        fmt::format("counting {} as slips", format_count(undecided, "undecided test", "undecided tests")));
  if (on_assumed_edges > 0) conditions.emplace_back("on knife edges (not stated)");
  return fmt::format("{}", fmt::join(conditions, ", "));
}

std::string friction_in_words(const Campaign& campaign) {
  const CategorySpread* over = spread_of_all(campaign);
  const auto answered = [](const CampaignTest& test) { return is_answered(test); };
  if (!over || count_of(campaign, answered) == 0) return "";
  const Spread& mu0 = over->mu0;
  const std::size_t limits = over->mu0_limit.count;
  const std::string limits_in_words =
      limits == 0 ? ""
                  : fmt::format("{} (95 %) in {}", at_most(over->mu0_limit), format_count(limits, "test", "tests"));
  const std::string conditions = conditions_in_words(campaign);
  const std::string condition = conditions.empty() ? "" : ", " + conditions;  // never cut off on a screen
  if (mu0.count == 0) return limits == 0 ? "none: no test determines friction" : limits_in_words + condition;
  std::string words = mu0.count == 1 ? fmt::format("{:.2f}, of one specimen{}", mu0.mean, condition)
                                     : fmt::format("mean {:.2f} of {} specimens, from {:.2f} to {:.2f}{}", mu0.mean,
                                                   mu0.count, mu0.min, mu0.max, condition);
  if (limits > 0) words += "; " + limits_in_words;
  constexpr double noticeable = 0.005;
  if (mu0.count > 1 && campaign.shared_error > noticeable)
    words += fmt::format("; ± {:.2f} by errors of the rig that all tests share", campaign.shared_error);
  return words;
}

// The friction share of the work.
std::string work_in_words(const Campaign& campaign) {
  std::vector<double> shares;
  for (const CampaignTest& test : campaign.tests)
    if (test.summary && !test.summary->suspect && std::isfinite(test.summary->friction_share))
      shares.push_back(test.summary->friction_share);
  if (shares.empty()) return "";
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  const Estimate& mean = campaign.friction_share;
  const std::string low = fmt::format("{:.0f}", 100 * *least), high = fmt::format("{:.0f}", 100 * *most);
  return fmt::format("{}friction took {} of the work{}; this is not toughness", shares.size() > 1 ? "on average " : "",
                     std::isfinite(mean.standard_error)
                         ? fmt::format("{:.0f} ± {:.0f} %", 100 * mean.value, 100 * mean.standard_error)
                         : format_percent(mean.value),
                     low == high ? "" : fmt::format(" ({} to {} %)", low, high));
}

// The causes of the drops of all specimens; empty if fewer than two tests have probabilities.
std::string causes_in_words(const Campaign& campaign) {
  const CauseShares& shares = campaign.causes;
  if (shares.tests < 2) return "";
  const auto range = [](const CauseShares::Share& share) {
    return fmt::format("{:.0f}–{}", 100 * share.low, format_percent(share.high));
  };
  return fmt::format("only slips in {} of specimens, only cracks in {}, both in {} (95 %); from {} tests",
                     range(shares.slips), range(shares.cracks), range(shares.both), shares.tests);
}

std::string exclusion_in_words(const Campaign& campaign) {
  const std::string names = excluded_tests(campaign);
  const CategorySpread* over = spread_of_all(campaign);
  const bool are_all_suspect = over && over == &campaign.categories.back().with_suspects;
  return names.empty() || are_all_suspect ? "" : names + ", not in the means";
}

// The share that friction adds to a number of the bending standards: "0.8 to 3.9".
std::string gain_in_percent(const CampaignTest& test, ShareRange FrictionGain::*share) {
  if (!test.standard || !test.standard->friction) return "";
  const ShareRange& range = (*test.standard->friction).*share;
  return fmt::format("{} to {}", format_significant(100 * range.least, 2), format_significant(100 * range.most, 2));
}

// The doubts about a test; without a fit and a doubt, the first sentence of the reason.
std::string doubts_in_words(const CampaignTest& test) {
  if (test.summary || !test.remarks.empty()) return fmt::format("{}", fmt::join(test.remarks, "; "));
  const std::string sentence = test.reason.substr(0, test.reason.find(". "));
  return sentence.ends_with('.') ? sentence.substr(0, sentence.size() - 1) : sentence;
}

// ---- Tables

// A row for each test, in their order: verdict, friction and doubts.
PrintedTable test_rows(const Campaign& campaign, WriteEstimate* written) {
  const CampaignUnits units = units_of(campaign);
  const char* friction = written == with_interval ? "Friction (95 %)" : "Friction";
  PrintedTable table{
      .head = {"Test", "Verdict", friction, titled("Spacing", units.length), "Drops", "Work (%)", "Doubts"},
      .rows = {},
      .folding = Folding::never};
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    std::vector<std::string> numbers(4);
    if (test.summary) {
      const TestSummary& summary = *test.summary;
      const double share = summary.friction_share;
      numbers = {!std::isfinite(summary.mu0.value) ? ""
                 : summary.mu0_is_bound            ? fmt::format("at most {}", format_significant(summary.mu0.high, 2))
                                                   : written(summary.mu0, 1),
                 format_significant(units.length.factor * summary.spacing, 2), fmt::format("{}", summary.drops),
                 std::isnan(share) ? "" : fmt::format("{:.0f}", std::abs(share) < 0.005 ? 0.0 : 100 * share)};
    }
    table.rows.push_back({name, test.verdict, numbers[0], numbers[1], numbers[2], numbers[3], doubts_in_words(test)});
  });
  return table;
}

// How friction varies along the specimens; empty without a test that shows it.
PrintedTable variation_rows(const Campaign& campaign, WriteEstimate* written) {
  const TableUnit length = units_of(campaign).length;
  PrintedTable table{.head = {"Test", "σ", titled("ℓ", length), "A", titled("λ", length)}, .rows = {}};
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    if (!test.summary || !std::isfinite(test.summary->mu0.value)) return;
    const TestSummary& summary = *test.summary;
    const auto of_roughness = [&](const Estimate& estimate, double factor) {
      return summary.model == ProfileModel::roughness && std::isfinite(estimate.value) ? written(estimate, factor) : "";
    };
    const auto of_wave = [&](const std::optional<Estimate>& estimate, double factor) {
      if (!estimate || !std::isfinite(estimate->value)) return std::string();
      return summary.wave_claimed ? written(*estimate, factor) : fmt::format("[{}]", written(*estimate, factor));
    };
    std::vector<std::string> row{name, of_roughness(summary.roughness, 1),
                                 of_roughness(summary.correlation_length, length.factor), of_wave(summary.amplitude, 1),
                                 of_wave(summary.wavelength, length.factor)};
    if (std::any_of(row.begin() + 1, row.end(), [](const std::string& cell) { return !cell.empty(); }))
      table.rows.push_back(std::move(row));
  });
  return table;
}

// Sawtooth, stiffness, work, and the numbers of the bending standards.
PrintedTable stiffness_rows(const Campaign& campaign, WriteEstimate* written) {
  const CampaignUnits units = units_of(campaign);
  PrintedTable table{
      .head = {"Test", "Sawtooth", titled("EI", units.bending_stiffness), titled("Residual", units.force),
               titled("Work", units.energy), titled("Modulus", units.modulus), titled("Strength", units.strength),
               "Friction in modulus (%)", "in stress (%)"},
      .rows = {}};
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    if (!test.summary) return;
    const TestSummary& summary = *test.summary;
    table.rows.push_back({name, std::string(name_of(summary.category)),
                          written(summary.bending_stiffness, units.bending_stiffness.factor),
                          format_significant(units.force.factor * summary.residual_rms, 3),
                          format_significant(units.energy.factor * summary.work_of_fracture, 3),
                          test.standard ? written(test.standard->modulus, units.modulus.factor) : "",
                          test.standard && std::isfinite(test.standard->strength)
                              ? format_significant(units.strength.factor * test.standard->strength, 3)
                              : "",
                          gain_in_percent(test, &FrictionGain::modulus),
                          gain_in_percent(test, &FrictionGain::strength)});
  });
  return table;
}

// True if tests are of more than one category, so that the row of all tests differs from each category.
bool has_several_categories(const Campaign& campaign) {
  return std::count_if(campaign.categories.begin(), campaign.categories.end(), [](const CategorySummary& summary) {
           return summary.category && summary.with_suspects.tests > 0;
         }) > 1;
}

PrintedTable category_rows(const Campaign& campaign) {
  const TableUnit length = units_of(campaign).length;
  PrintedTable table{.head = {"Sawtooth", "Tests", "Friction", "Upper limits", "A", titled("λ", length)}, .rows = {}};
  for (const auto& category : campaign.categories) {
    if (!category.category && !has_several_categories(campaign)) continue;
    const auto row_of = [&](const CategorySpread& spreads, std::string_view suspects) {
      // Brackets if some of the waves are only indicative.
      const auto of_waves = [&](const Spread& spread, double factor, int decimals) {
        const std::string words = of_spread(spread, factor, decimals);
        return words.empty() || spreads.waves_claimed == spread.count ? words : fmt::format("[{}]", words);
      };
      const std::size_t limits = spreads.mu0_limit.count;
      return std::vector{fmt::format("{}{}", key_of(category), suspects),
                         fmt::format("{}", spreads.mu0.count + limits),
                         of_spread(spreads.mu0, 1, 2),
                         limits == 0 ? "" : fmt::format("{} ({})", at_most(spreads.mu0_limit), limits),
                         of_waves(spreads.amplitude, 1, 2),
                         of_waves(spreads.wavelength, length.factor, 1)};
    };
    const auto values = [](const CategorySpread& spreads) { return spreads.mu0.count + spreads.mu0_limit.count; };
    const auto &without = category.without_suspects, &with = category.with_suspects;
    if (values(without) > 0) table.rows.push_back(row_of(without, ""));
    if (values(with) > values(without)) table.rows.push_back(row_of(with, ", with suspects"));
  }
  return table;
}

PrintedTable specimen_rows(const Campaign& campaign) {
  PrintedTable table{.head = {"Sawtooth", "Parameter", "Tests", "Typical", "Specimens differ by"}, .rows = {}};
  for (const auto& line : specimen_lines(campaign)) {
    if (line.category == "all" && !has_several_categories(campaign)) continue;
    const Population& population = line.population;
    const auto [unit, factor] = print_unit(population.typical.value, line.unit);
    const std::string sign = line.by_factors ? "a factor " : "± ";
    const std::string typical = with_interval(population.typical, factor);
    const auto of_spread = [](double spread) { return format_significant(spread, 2); };
    table.rows.push_back({line.category,
                          line.parameter == "mu0"         ? "μ₀"
                          : line.parameter == "roughness" ? "σ"
                                                          : "ℓ",
                          fmt::format("{}", population.tests),
                          unit.empty() ? typical : fmt::format("{} {}", typical, typeset(unit)),
                          population.min_spread > (line.by_factors ? 1 : 0)
                              ? fmt::format("{}{} ({} to {})", sign, of_spread(population.spread),
                                            of_spread(population.min_spread), of_spread(population.max_spread))
                              : fmt::format("{}{} at most", sign, of_spread(population.max_spread))});
  }
  return table;
}

Rows failure_rows(const Campaign& campaign) {
  Rows rows;
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    if (is_failure(test)) rows.push_back({name, test.reason});
  });
  return rows;
}

Rows rows_without_friction(const Campaign& campaign) {
  Rows rows;
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    if (!test.summary && is_answered(test)) rows.push_back({name, test.reason});
  });
  return rows;
}

// ---- Remarks outside tables

// How the friction of the tests compares with the literature.
std::string literature_in_words(const Campaign& campaign) {
  const auto literature = literature_of(campaign);
  const CategorySpread* over = spread_of_all(campaign);
  if (!literature || !over || over->mu0.count == 0) return "";
  const bool all_are_suspect = std::all_of(campaign.tests.begin(), campaign.tests.end(), [](const CampaignTest& test) {
    return !test.summary || test.summary->suspect;
  });
  const auto agree = std::count_if(campaign.tests.begin(), campaign.tests.end(), [&](const CampaignTest& test) {
    return test.summary && (all_are_suspect || !test.summary->suspect) && !test.summary->mu0_is_bound &&
           test.summary->mu0.low <= literature->high && test.summary->mu0.high >= literature->low;
  });
  return fmt::format("{:g} to {:g} for {} on {}; the mean is {} it, and {} of {} agree with it", literature->low,
                     literature->high, literature->specimen, literature->support,
                     over->mu0.mean < literature->low    ? "below"
                     : over->mu0.mean > literature->high ? "above"
                                                         : "within",
                     agree, format_count(over->mu0.count, "test", "tests"));
}

// The meaning of the columns, for the tables that exist.
Rows column_rows(const Campaign& campaign) {
  const auto has = [&](auto part) {
    return std::any_of(campaign.tests.begin(), campaign.tests.end(),
                       [&](const auto& test) { return (test.*part).has_value(); });
  };
  if (!has(&CampaignTest::summary)) return {};
  return {
      {"Sawtooth",
       "none: fewer than three force drops, or drops that sum to less than 3\u00a0% of the maximum force; clear: "
       "15\u00a0% "
       "or more; nominal: between"},
      {"Friction",
       "mean μ₀ over the sliding length; σ is its variation, ℓ the correlation length; ± is one standard error, "
       "ranges in parentheses are 95 % intervals"},
      {"A, λ", "amplitude and wavelength of the wave with the highest probability; brackets: not detected"},
      {"Work (%)", "friction share of the work; empty if the friction is not determined, or only an upper limit"},
      {"Modulus, strength",
       !has(&CampaignTest::standard)
           ? ""
           : "modulus of the chord, or else of the linear region, and stress at the maximum force of a specimen that "
             "broke, by the bending standards; and how much friction at the supports increases the modulus and this "
             "stress (0.1 to 0.5 if the case states none)"},
      {"Typical", specimen_rows(campaign).rows.empty()
                      ? ""
                      : "mean μ₀ of the specimens, and median σ and ℓ, with 95 % intervals; specimens differ by the "
                        "standard deviation of μ₀, and by a factor in σ and ℓ, without the errors of the "
                        "records; suspects are left out"}};
}

}  // namespace

std::string with_interval(const Estimate& estimate, double factor) {
  const MatchedDigits digits = matched_digits(estimate, factor);
  return digits.low.empty() ? digits.value : fmt::format("{} ({} to {})", digits.value, digits.low, digits.high);
}

std::string with_error(const Estimate& estimate, double factor) {
  const MatchedDigits digits = matched_digits(estimate, factor);
  return digits.error.empty() ? digits.value : fmt::format("{} ± {}", digits.value, digits.error);
}

std::optional<LiteratureFriction> literature_of(const Campaign& campaign) {
  std::optional<Materials> all;
  for (const auto& test : campaign.tests) {
    if (!test.summary) continue;
    if (!test.materials || (all && *all != *test.materials)) return std::nullopt;
    all = test.materials;
  }
  return all ? friction_in_literature(*all) : std::nullopt;
}

std::string campaign_in_short(const Campaign& campaign) { return verdicts_in_words(campaign, {}); }

Rows rows_of(const Campaign& campaign) {
  return {{"friction", friction_in_words(campaign)},
          {"work", work_in_words(campaign)},
          {"causes", causes_in_words(campaign)},
          {"suspect", exclusion_in_words(campaign)}};
}

std::vector<Chapter> document_of(const Campaign& campaign, WriteEstimate* written,
                                 const std::vector<std::string>& links) {
  PrintedTable tests = test_rows(campaign, written);
  tests.links = links;
  const Pictures comparisons{[&campaign](double width) { return comparison_figures(campaign, width); }};
  const Pictures curves{[&campaign](double width) { return atlas_pages(campaign, width); }};
  std::vector<Chapter> chapters{{"", {tests, comparisons}},
                                {"By category: mean (minimum to maximum)",
                                 {category_rows(campaign), Rows{{"literature", literature_in_words(campaign)}}}},
                                {"Between specimens", {specimen_rows(campaign)}},
                                {"Variation of friction along the specimens", {variation_rows(campaign, written)}},
                                {"Sawtooth, stiffness and work", {stiffness_rows(campaign, written)}},
                                {"Deflection too small to determine friction", {rows_without_friction(campaign)}},
                                {"Not evaluated", {failure_rows(campaign)}},
                                {"Force curves", {curves}},
                                {"Names of the tests", {name_rows(campaign)}},
                                {"Meaning of the columns", {column_rows(campaign)}}};
  for (auto chapter = chapters.begin() + 1; chapter != chapters.end(); ++chapter) chapter->folding = Folding::always;
  return chapters;
}

namespace {

// Reasons of at most two tests without an answer, one line each.
Rows shown_failures(const Campaign& campaign, std::size_t width) {
  constexpr std::size_t max_failures = 2;
  Rows rows;
  for_each_test(campaign, [&](const CampaignTest& test, const std::string& name) {
    if (is_failure(test) && rows.size() < max_failures)
      rows.push_back({folded(test.verdict), cut_to_row(fmt::format("{}: {}", name, test.reason), width)});
  });
  return rows;
}

// Adds the rows of the tests with an answer, as many as there are free lines. If some are missing,
// tests with doubts come first.
void add_tests(Screen& screen, const Campaign& campaign, const ScreenStyle& style) {
  constexpr std::size_t lines_of_head = 2;
  PrintedTable tests = test_rows(campaign, with_error);
  for (std::size_t i = campaign.tests.size(); i-- > 0;)
    if (is_failure(campaign.tests[i])) tests.rows.erase(tests.rows.begin() + static_cast<std::ptrdiff_t>(i));
  const std::size_t lines = free_lines(screen, style);
  const std::size_t room = lines > lines_of_head ? lines - lines_of_head : 0;
  if (tests.rows.size() > room) {
    std::stable_partition(tests.rows.begin(), tests.rows.end(), [](const auto& row) { return !row.back().empty(); });
    tests.rows.resize(room);
  }
  const std::size_t shown = tests.rows.size() + screen.doubts.size();
  if (shown < campaign.tests.size())
    screen.footer = format_count(campaign.tests.size() - shown, "more test. ", "more tests. ") + screen.footer;
  screen.table = picked(tests, {0, 1, 2, 3, 5, 6});  // without the drops, for which there is no room
  screen.table.is_cut = true;
}

}  // namespace

std::string campaign_screen(const Campaign& campaign, const ScreenStyle& style) {
  Screen screen{.title = wrapped(verdicts_in_words(campaign, style), "  ", "", style.width),
                .rows = rows_of(campaign),
                .doubts = style.is_full ? Rows{} : shown_failures(campaign, style.width),
                .footer = ""};
  if (std::any_of(screen.rows.begin(), screen.rows.end(), [](const AnswerRow& row) { return !row.words.empty(); }))
    screen.footer = "± is one standard error.";
  if (campaign.tests.empty() || style.is_full) return in_text(screen, style);
  screen.footer += screen.footer.empty() ? "More: --full" : " More: --full";
  add_tests(screen, campaign, style);
  return in_text(screen, style);
}

std::string campaign_text(const Campaign& campaign) {
  const std::string chapters = in_text(document_of(campaign, with_error));
  return campaign_screen(campaign, {.is_full = true}) + (chapters.empty() || chapters.front() == '\n' ? "" : "\n") +
         chapters;
}

}  // namespace flexslip
