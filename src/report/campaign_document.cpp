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
    if (test.standard) moduli.push_back(test.standard->modulus.value), strengths.push_back(test.standard->strength);
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

std::string of_friction(const CategorySpread& category) {
  const std::string mean = of_spread(category.mu0, 1, 3);
  if (category.mu0_limit.count == 0) return mean;
  const std::string limits = fmt::format("{} {}", category.mu0_limit.count, at_most(category.mu0_limit));
  return mean.empty() ? limits : fmt::format("{} of {}; {}", mean, category.mu0.count, limits);
}

// ---- The answer

template <class Predicate>
std::string enumerated(const Campaign& campaign, Predicate belongs, std::string_view is, std::string_view are) {
  constexpr std::size_t max_names = 8;
  std::vector<std::string> names;
  for (const auto& test : campaign.tests)
    if (belongs(test)) names.push_back(printable(test.name));
  if (names.empty()) return "";
  const std::size_t shown = std::min(names.size(), max_names);
  std::string out = names.front();
  for (std::size_t i = 1; i < shown; ++i) out += (i + 1 == names.size() ? " and " : ", ") + names[i];
  if (shown < names.size()) out += fmt::format(" and {} more", names.size() - shown);
  return fmt::format("{} {}", out, names.size() == 1 ? is : are);
}

// True if the test is missing from the table.
bool is_failure(const CampaignTest& test) { return !test.summary && !is_answered(test); }
// True if the friction is determined but excluded: the verdict counts such a test elsewhere.
bool is_excluded(const CampaignTest& test) {
  return test.summary && test.summary->suspect && std::isfinite(test.summary->mu0.value);
}

// "21 slip, 9 undecided, 0 crack, 8 without drops"; other verdicts only if they occur. A test that
// failed has no verdict.
std::string verdicts_in_words(const Campaign& campaign) {
  const auto count = [&](VerdictCode code) {
    return std::count_if(campaign.tests.begin(), campaign.tests.end(),
                         [&](const CampaignTest& test) { return !is_failure(test) && test.verdict == word_of(code); });
  };
  std::string words =
      fmt::format("{} slip, {} undecided, {} crack, {} without drops", count(VerdictCode::slip),
                  count(VerdictCode::undecided), count(VerdictCode::crack), count(VerdictCode::no_drops));
  if (const auto both = count(VerdictCode::slip_and_damage); both > 0)
    words += fmt::format(", {} slip and damage", both);
  if (const auto settled = count(VerdictCode::settled); settled > 0) words += fmt::format(", {} settled", settled);
  if (const auto wrong = count(VerdictCode::check_input); wrong > 0)
    words += fmt::format(", {} to check the input of", wrong);
  if (const auto none = count(VerdictCode::no_answer); none > 0) words += fmt::format(", {} without an answer", none);
  return words;
}

// The causes of the drops of all specimens; empty if fewer than two tests have probabilities.
std::string causes_in_words(const Campaign& campaign) {
  const CauseShares& shares = campaign.causes;
  if (shares.tests < 2) return "";
  const auto range = [](const CauseShares::Share& share) {
    return fmt::format("{:.0f} to {}", 100 * share.low, format_percent(share.high));
  };
  return fmt::format(" Of the specimens {} only slipped, {} only cracked, {} did both (95 %, by {}).",
                     range(shares.slips), range(shares.cracks), range(shares.both),
                     format_count(shares.tests, "test", "tests"));
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
  const std::string low = fmt::format("{:.0f} %", 100 * *least), high = fmt::format("{:.0f} %", 100 * *most);
  return fmt::format("; {} of the work went into friction{}{}", format_percent(mean.value),
                     std::isfinite(mean.standard_error)
                         ? fmt::format(" ({:.0f} to {}, 95 %)", 100 * mean.low, format_percent(mean.high))
                         : "",
                     low == high ? "" : fmt::format(", {:.0f} to {} between specimens", 100 * *least, high));
}

// The spread over the tests that are not suspect, or over all if all are suspect; null without
// tests.
const CategorySpread* spread_of_all(const Campaign& campaign) {
  const auto all = std::find_if(campaign.categories.begin(), campaign.categories.end(),
                                [](const CategorySummary& category) { return !category.category; });
  if (all == campaign.categories.end()) return nullptr;
  return all->without_suspects.tests > 0 ? &all->without_suspects : &all->with_suspects;
}

std::string friction_in_words(const Campaign& campaign) {
  const CategorySpread* over = spread_of_all(campaign);
  if (!over) return "";
  const Spread& mu0 = over->mu0;
  const std::string limits =
      over->mu0_limit.count == 0
          ? ""
          : fmt::format("{} only that it is {}", format_count(over->mu0_limit.count, "test tells", "tests tell"),
                        at_most(over->mu0_limit));
  if (mu0.count == 0)
    return limits.empty() ? " No test tells friction." : fmt::format(" No test tells friction from zero; {}.", limits);
  const bool has_undecided = std::any_of(campaign.tests.begin(), campaign.tests.end(), [](const CampaignTest& test) {
    return test.verdict == word_of(VerdictCode::undecided);
  });
  const bool has_unstated_supports =
      std::any_of(campaign.tests.begin(), campaign.tests.end(),
                  [](const CampaignTest& test) { return test.summary && test.summary->on_assumed_edges; });
  std::vector<std::string> conditions;
  if (has_unstated_supports) conditions.emplace_back("the supports are knife edges");
  if (has_undecided) conditions.emplace_back("the drops of those undecided are slips");
  constexpr double worth_saying = 0.005;
  const std::string shared =
      mu0.count > 1 && campaign.shared_error > worth_saying
          ? fmt::format("; errors of the rig, which its tests share, move it by ± {:.2f}", campaign.shared_error)
          : "";
  return fmt::format(" Friction {:.2f}{}{}{}{}{}{}.", mu0.mean,
                     mu0.count == 1 ? ""
                                    : fmt::format(" averaged over {} specimens, {:.2f} to {:.2f} between them",
                                                  mu0.count, mu0.min, mu0.max),
                     shared, conditions.empty() ? "" : ", if ", in_words(conditions, "and"),
                     limits.empty() ? "" : "; " + limits, work_in_words(campaign));
}

// "0.8 to 3.9, 0.6 to 2.7".
std::string friction_in_standard(const CampaignTest& test) {
  if (!test.standard || !test.standard->friction) return "";
  const auto of = [](const ShareRange& share) {
    return fmt::format("{} to {}", format_significant(100 * share.least, 2), format_significant(100 * share.most, 2));
  };
  return fmt::format("{}, {}", of(test.standard->friction->modulus), of(test.standard->friction->strength));
}

// ---- Tables

PrintedTable test_rows(const Campaign& campaign, WriteEstimate* written) {
  const CampaignUnits units = units_of(campaign);
  const double per_length = units.length.factor;
  PrintedTable table{
      .head = {"Test", "Verdict", "Sawtooth", "Friction", titled("Spacing", units.length), "σ",
               titled("ℓ", units.length), "A", titled("λ", units.length), titled("EI", units.bending_stiffness),
               titled("Residual", units.force), "Drops", titled("Work", units.energy), "Work (%)",
               titled("E_f", units.modulus), titled("σ_f", units.strength), "Friction in E_f, σ_f (%)", "Doubts"},
      .rows = {},
      .folding = Folding::never,
      .on_terminal = {"Test", "Verdict", "Friction", "Spacing", "Work (%", "Doubts"}};
  for (const auto& test : campaign.tests) {
    if (!test.summary) continue;
    const TestSummary& summary = *test.summary;
    const bool tells = std::isfinite(summary.mu0.value);
    const bool is_rough = summary.model == ProfileModel::roughness && tells;
    const auto of_wave = [&](const std::optional<Estimate>& estimate, double factor) {
      if (!estimate) return std::string();
      return summary.wave_claimed ? written(*estimate, factor) : fmt::format("[{}]", written(*estimate, factor));
    };
    std::vector<std::string> remarks = test.remarks;
    if (!test.reason.empty()) remarks.insert(remarks.begin(), test.reason);
    const double share = summary.friction_share;
    table.rows.push_back(
        {test.name, test.verdict, std::string(name_of(summary.category)),
         !tells                 ? ""
         : summary.mu0_is_bound ? fmt::format("at most {}", format_significant(summary.mu0.high, 2))
                                : written(summary.mu0, 1),
         format_significant(per_length * summary.spacing, 2), is_rough ? written(summary.roughness, 1) : "",
         is_rough ? written(summary.correlation_length, per_length) : "", of_wave(summary.amplitude, 1),
         of_wave(summary.wavelength, per_length), written(summary.bending_stiffness, units.bending_stiffness.factor),
         format_significant(units.force.factor * summary.residual_rms, 3), fmt::format("{}", summary.drops),
         format_significant(units.energy.factor * summary.work_of_fracture, 3),
         std::isnan(share) ? "" : fmt::format("{:.0f}", std::abs(share) < 0.005 ? 0.0 : 100 * share),
         test.standard ? written(test.standard->modulus, units.modulus.factor) : "",
         test.standard ? format_significant(units.strength.factor * test.standard->strength, 3) : "",
         friction_in_standard(test), fmt::format("{}", fmt::join(remarks, "; "))});
  }
  return table;
}

PrintedTable category_rows(const Campaign& campaign) {
  const TableUnit length = units_of(campaign).length;
  PrintedTable table{.head = {"Sawtooth", "Suspects", "Tests", "Friction", "A", titled("λ", length)},
                     .rows = {},
                     .on_terminal = {"Sawtooth", "Suspects", "Tests", "Friction", "λ"}};
  for (const auto& category : campaign.categories)
    for (const auto* spreads : {&category.without_suspects, &category.with_suspects}) {
      // Brackets if some of the waves are only indicative.
      const auto of_waves = [&](const Spread& spread, double factor, int decimals) {
        const std::string words = of_spread(spread, factor, decimals);
        return words.empty() || spreads->waves_claimed == spread.count ? words : fmt::format("[{}]", words);
      };
      table.rows.push_back({std::string(key_of(category)),
                            spreads == &category.without_suspects ? "left out" : "counted in",
                            fmt::format("{}", spreads->tests), of_friction(*spreads),
                            of_waves(spreads->amplitude, 1, 3), of_waves(spreads->wavelength, length.factor, 1)});
    }
  return table;
}

PrintedTable specimen_rows(const Campaign& campaign) {
  PrintedTable table{.head = {"Sawtooth", "Parameter", "Tests", "Typical", "Specimens differ by"}, .rows = {}};
  for (const auto& line : specimen_lines(campaign)) {
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
  for (const auto& test : campaign.tests)
    if (is_failure(test)) rows.push_back({printable(test.name), test.reason});
  return rows;
}

Rows rows_without_friction(const Campaign& campaign) {
  Rows rows;
  for (const auto& test : campaign.tests)
    if (!test.summary && is_answered(test)) rows.push_back({printable(test.name), test.reason});
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
  return {{"Sawtooth",
           "none: fewer than three drops of the force, or drops that add up to less than 3\u00a0% of the greatest "
           "force; clear: 15\u00a0% or more; nominal: between"},
          {"Friction",
           "μ₀, averaged over the length that slid; σ is its roughness, ℓ the correlation length; ± are standard "
           "errors, ranges in parentheses 95 % intervals"},
          {"A, λ", "of the likeliest wave of friction; brackets mark a wave that is only indicative"},
          {"Work (%)",
           "share of the work that went into friction; a test that tells no friction, or only a limit, has none"},
          {"E_f, σ_f",
           "modulus of the chord, or else of the straight part, and stress at the greatest force, as the bending "
           "standards have them; and by how much friction at the supports makes each greater, of 0.1 to 0.5 where the "
           "case states none"},
          {"Typical", specimen_rows(campaign).rows.empty()
                          ? ""
                          : "mean of μ₀ over specimens, and σ and ℓ of the middle specimen, with 95 % intervals; "
                            "specimens differ by the standard deviation of μ₀, and by a factor up or down in σ and ℓ; "
                            "the error of each record is taken off, and suspects are left out"}};
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

std::string campaign_in_short(const Campaign& campaign) {
  if (campaign.tests.empty()) return "No tests.";
  if (std::all_of(campaign.tests.begin(), campaign.tests.end(), is_failure))
    return fmt::format("No answer: {}.",
                       campaign.tests.size() == 1
                           ? "the test could not be evaluated"
                           : fmt::format("none of the {} tests could be evaluated", campaign.tests.size()));
  std::string answer = fmt::format("{}: {}.{}{}", format_count(campaign.tests.size(), "test", "tests"),
                                   verdicts_in_words(campaign), causes_in_words(campaign), friction_in_words(campaign));
  for (const std::string& words :
       {enumerated(campaign, is_excluded, "is suspect", "are suspect"),
        enumerated(campaign, is_failure, "could not be evaluated", "could not be evaluated")})
    if (!words.empty()) answer += fmt::format(" {}.", words);
  return answer;
}

std::vector<Chapter> document_of(const Campaign& campaign, WriteEstimate* written,
                                 const std::vector<std::string>& links) {
  PrintedTable tests = test_rows(campaign, written);
  tests.links = links;
  const bool has_answers = !tests.rows.empty();
  std::vector<Chapter> chapters;
  if (has_answers)
    chapters = {{"",
                 {Pictures{[&campaign] {
                    std::vector figures{distribution_figure(campaign)};
                    if (has_losses(campaign)) figures.push_back(losses_figure(campaign));
                    return figures;
                  }},
                  tests}},
                {"By category: mean (smallest to largest)",
                 {category_rows(campaign), Rows{{"literature", literature_in_words(campaign)}}}},
                {"Between specimens", {specimen_rows(campaign)}}};
  chapters.push_back({"Bent too little to tell friction", {rows_without_friction(campaign)}});
  chapters.push_back({"Not evaluated", {failure_rows(campaign)}});
  if (has_answers)
    for (const Chapter& chapter : {Chapter{"Force curves", {Pictures{[&campaign] { return atlas_pages(campaign); }}}},
                                   Chapter{"What the columns say", {column_rows(campaign)}}})
      chapters.push_back(chapter);
  return chapters;
}

std::string campaign_text(const Campaign& campaign) {
  std::vector<Chapter> chapters = document_of(campaign, with_error);
  chapters.insert(chapters.begin(), {"", {campaign_in_short(campaign)}});
  return in_text(chapters);
}

}  // namespace flexslip
