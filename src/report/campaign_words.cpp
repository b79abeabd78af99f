#include "report/campaign_words.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "answers/campaign_fields.h"
#include "finding/digits.h"
#include "finding/finding.h"
#include "io/text.h"
#include "report/campaign_units.h"
#include "report/fit_words.h"

namespace flexslip {
namespace {

constexpr std::size_t most_names = 8;  // in a sentence

std::string titled(std::string_view symbol, const TableUnit& unit) {
  return fmt::format("{} ({})", symbol, typeset(unit.name));
}

// Nothing of a test that is not trusted.
std::string share_in_words(double share) {
  return std::isnan(share) ? "" : fmt::format("{:.0f}", std::abs(share) < 0.005 ? 0.0 : 100 * share);
}

std::string of_spread(const Spread& spread, double factor, int decimals) {
  if (spread.count == 0) return "";
  if (spread.count == 1) return fmt::format("{:.{}f}", factor * spread.mean, decimals);
  return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", factor * spread.mean, decimals, factor * spread.min, decimals,
                     factor * spread.max, decimals);
}

// Brackets where some of the waves are only indicative.
std::string of_waves(const CategorySpread& category, Spread CategorySpread::*spread, double factor, int decimals) {
  const std::string words = of_spread(category.*spread, factor, decimals);
  return words.empty() || category.waves_claimed == (category.*spread).count ? words : fmt::format("[{}]", words);
}

// "at most 0.09", "at most 0.03 to 0.09".
std::string at_most(const Spread& limits) {
  return limits.count == 1 ? fmt::format("at most {}", significant(limits.max, 2))
                           : fmt::format("at most {} to {}", significant(limits.min, 2), significant(limits.max, 2));
}

std::string of_friction(const CategorySpread& category) {
  const std::string told = of_spread(category.mu0, 1, 3);
  if (category.mu0_limit.count == 0) return told;
  const std::string limits = fmt::format("{} {}", category.mu0_limit.count, at_most(category.mu0_limit));
  return told.empty() ? limits : fmt::format("{} of {}; {}", told, category.mu0.count, limits);
}

std::string enumerated(const std::vector<std::string>& names) {
  std::string out;
  const std::size_t shown = names.size() > most_names ? most_names : names.size();
  for (std::size_t i = 0; i < shown; ++i) out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return shown == names.size() ? out : fmt::format("{} and {} more", out, names.size() - shown);
}

template <class Predicate>
std::vector<std::string> names_of(const Campaign& campaign, Predicate belongs) {
  std::vector<std::string> names;
  for (const auto& test : campaign.tests)
    if (belongs(test)) names.push_back(printable(test.name));
  return names;
}

bool is_untrusted(const CampaignTest& test) { return test.summary && !is_trusted(test.summary->standing); }
bool is_suspect(const CampaignTest& test) { return test.summary && test.summary->suspect && !is_untrusted(test); }
bool is_failure(const CampaignTest& test) { return !test.summary; }

const CategorySummary* summary_of_all(const Campaign& campaign) {
  const auto all = std::find_if(campaign.categories.begin(), campaign.categories.end(),
                                [](const CategorySummary& category) { return !category.category; });
  return all == campaign.categories.end() ? nullptr : &*all;
}

// "21 slip, 9 undecided, 0 crack, 8 without drops"; the others where there are some.
std::string verdicts_in_words(const Campaign& campaign) {
  const auto count = [&](VerdictCode code) {
    return std::count_if(campaign.tests.begin(), campaign.tests.end(),
                         [&](const CampaignTest& test) { return test.verdict == word_of(code); });
  };
  std::string words =
      fmt::format("{} slip, {} undecided, {} crack, {} without drops", count(VerdictCode::slip),
                  count(VerdictCode::undecided), count(VerdictCode::crack), count(VerdictCode::no_drops));
  if (const auto wrong = count(VerdictCode::check_input); wrong > 0)
    words += fmt::format(", {} to check the input of", wrong);
  if (const auto none = count(VerdictCode::no_answer); none > 0) words += fmt::format(", {} without an answer", none);
  return words;
}

// Of the work under the curves, what went into friction.
std::string work_in_words(const Campaign& campaign) {
  std::vector<double> shares;
  for (const CampaignTest& test : campaign.tests)
    if (test.summary && !test.summary->suspect && std::isfinite(test.summary->friction_share))
      shares.push_back(test.summary->friction_share);
  if (shares.empty()) return "";
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  if (shares.size() == 1) return fmt::format(" {} of the work was friction.", percent(shares.front()));
  return fmt::format(" {} of the work was friction ({} to {}).",
                     percent(std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size())),
                     percent(*least), percent(*most));
}

// Friction over the tests that are not suspect, or over all if all are.
std::string friction_in_words(const Campaign& campaign, const CategorySummary& all) {
  const bool leaves_out = all.without_suspects.tests > 0;
  const CategorySpread& over = leaves_out ? all.without_suspects : all.with_suspects;
  const std::size_t suspects = all.with_suspects.tests - all.without_suspects.tests;
  const Spread& mu0 = over.mu0;
  const std::string limits =
      over.mu0_limit.count == 0
          ? ""
          : fmt::format("{} only that it is {}", counted(over.mu0_limit.count, "test tells", "tests tell"),
                        at_most(over.mu0_limit));
  const std::string left_out = leaves_out && suspects > 0
                                   ? fmt::format(", without the {}", suspects == 1 ? "suspect test" : "suspect tests")
                                   : "";
  if (mu0.count == 0)
    return limits.empty() ? "No test tells friction."
                          : fmt::format("No test tells friction at the supports from zero; {}{}.", limits, left_out);
  const std::string value =
      (mu0.count == 1 ? fmt::format("Friction at the supports is {:.2f}", mu0.mean)
                      : fmt::format("Friction at the supports is {:.2f} on average of {} tests, from {:.2f} to {:.2f}",
                                    mu0.mean, mu0.count, mu0.min, mu0.max)) +
      (limits.empty() ? "" : "; " + limits);
  const auto literature = literature_of(campaign);
  if (!literature) return fmt::format("{}{}.", value, left_out);
  const double low = literature->low, high = literature->high;
  const auto within = std::count_if(campaign.tests.begin(), campaign.tests.end(), [&](const CampaignTest& test) {
    return test.summary && !(leaves_out && test.summary->suspect) && !test.summary->mu0_is_bound &&
           test.summary->mu0.low <= high && test.summary->mu0.high >= low;
  });
  const bool agrees = mu0.count == 1 && within == 1;
  return fmt::format("{}{}. {} {} the range {:g} to {:g} that the literature gives for {} on {}{}.", value, left_out,
                     mu0.count == 1 ? "It lies" : "The mean lies",
                     agrees            ? "within, or no farther than its error from,"
                     : mu0.mean < low  ? "below"
                     : mu0.mean > high ? "above"
                                       : "within",
                     low, high, literature->specimen, literature->support,
                     mu0.count == 1 ? ""
                                    : fmt::format(", and {} of the {} tests {} with it", within, mu0.count,
                                                  within == 1 ? "agrees" : "agree"));
}

}  // namespace

std::string suspects_in_words(const Campaign& campaign) {
  std::string words;
  const auto say = [&](const std::vector<std::string>& names, std::string_view what) {
    if (names.empty()) return;
    words +=
        fmt::format("{}{} {} {}", words.empty() ? "" : "; ", enumerated(names), names.size() == 1 ? "is" : "are", what);
  };
  say(names_of(campaign, is_suspect), "suspect");
  say(names_of(campaign, is_untrusted), "not to be trusted");
  return words.empty() ? "" : words + "; the doubts say why.";
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

std::string answer_of(const Campaign& campaign) {
  if (campaign.tests.empty()) return "No tests.";
  const auto failures = names_of(campaign, is_failure);
  const std::size_t count = campaign.tests.size() - failures.size();
  if (count == 0)
    return fmt::format("No answer: {}.",
                       campaign.tests.size() == 1
                           ? "the test could not be evaluated"
                           : fmt::format("none of the {} tests could be evaluated", campaign.tests.size()));
  std::string answer =
      fmt::format("{}: {}.", counted(campaign.tests.size(), "test", "tests"), verdicts_in_words(campaign));
  if (const CategorySummary* all = summary_of_all(campaign))
    answer += fmt::format(" {}{}", friction_in_words(campaign, *all), work_in_words(campaign));
  const std::string suspects = suspects_in_words(campaign);
  answer += fmt::format(" {}", suspects.empty() ? "No test is suspect." : suspects);
  const auto doubtful =
      static_cast<std::size_t>(std::count_if(campaign.tests.begin(), campaign.tests.end(), [](const auto& test) {
        return test.summary && test.summary->standing == Standing::doubtful;
      }));
  if (doubtful > 0)
    answer += suspects.empty() ? fmt::format(" {} open to doubt; the doubts say why.", counted(doubtful, "is", "are"))
                               : fmt::format(" {} open to doubt.", counted(doubtful, "other is", "others are"));
  if (!failures.empty()) answer += fmt::format(" {} could not be evaluated.", enumerated(failures));
  return answer;
}

PrintedTable category_rows(const Campaign& campaign) {
  const TableUnit length = units_of(campaign).wavelength;
  PrintedTable table{
      {"Sawtooth", "Suspects", "Tests", "μ₀", "A", titled("λ", length), titled("Height", length), "Slope"}, {}};
  for (const auto& category : campaign.categories)
    for (const auto* spreads : {&category.without_suspects, &category.with_suspects})
      table.rows.push_back({std::string(key_of(category)),
                            spreads == &category.without_suspects ? "left out" : "counted in",
                            fmt::format("{}", spreads->tests), of_friction(*spreads),
                            of_waves(*spreads, &CategorySpread::amplitude, 1, 3),
                            of_waves(*spreads, &CategorySpread::wavelength, length.factor, 1),
                            of_waves(*spreads, &CategorySpread::surface_height, length.factor, 3),
                            of_spread(spreads->surface_slope, 1, 3)});
  return table;
}

std::string with_interval(const Estimate& estimate, double factor) {
  const MatchedDigits digits = matched_digits(estimate, factor);
  return digits.low.empty() ? digits.value : fmt::format("{} ({} to {})", digits.value, digits.low, digits.high);
}

std::string with_error(const Estimate& estimate, double factor) {
  const MatchedDigits digits = matched_digits(estimate, factor);
  return digits.error.empty() ? digits.value : fmt::format("{} ± {}", digits.value, digits.error);
}

PrintedTable test_rows(const Campaign& campaign, WriteEstimate* written) {
  const CampaignUnits units = units_of(campaign);
  PrintedTable table{
      {"Test", "Verdict", "Sawtooth", "Standing", "μ₀", titled("Spacing", units.wavelength), "σ",
       titled("ℓ", units.wavelength), "A", titled("λ", units.wavelength), titled("Height", units.wavelength), "Slope",
       titled("EI", units.bending_stiffness), titled("Residual", units.residual), "Drops", titled("Work", units.work),
       "Friction (%)", "Doubts"},
      {}};
  for (const auto& test : campaign.tests) {
    if (!test.summary) continue;
    const TestSummary& summary = *test.summary;
    const bool tells = std::isfinite(summary.mu0.value);
    const auto of_wave = [&](const std::optional<Estimate>& estimate, double factor) {
      if (!estimate) return std::string();
      const std::string wave = written(*estimate, factor);
      return summary.wave_claimed ? wave : fmt::format("[{}]", wave);
    };
    const bool is_rough = summary.model == ProfileModel::roughness && tells;
    std::vector<std::string> remarks = test.remarks;
    if (!test.reason.empty()) remarks.insert(remarks.begin(), test.reason);
    table.rows.push_back(
        {printable(test.name), test.verdict, std::string(name_of(summary.category)),
         std::string(name_of(summary.standing)),
         !tells                 ? ""
         : summary.mu0_is_bound ? fmt::format("at most {}", significant(summary.mu0.high, 2))
                                : written(summary.mu0, 1),
         significant(units.wavelength.factor * summary.spacing, 2), is_rough ? written(summary.roughness, 1) : "",
         is_rough ? written(summary.correlation_length, units.wavelength.factor) : "", of_wave(summary.amplitude, 1),
         of_wave(summary.wavelength, units.wavelength.factor), of_wave(summary.surface_height, units.wavelength.factor),
         summary.surface_slope ? written(*summary.surface_slope, 1) : "",
         written(summary.bending_stiffness, units.bending_stiffness.factor),
         significant(units.residual.factor * summary.residual_rms, 3), fmt::format("{}", summary.drops),
         significant(units.work.factor * summary.work_of_fracture, 3), share_in_words(summary.friction_share),
         printable(fmt::format("{}", fmt::join(remarks, "; ")))});
  }
  return table;
}

PrintedTable picked(const PrintedTable& table, const std::vector<std::string_view>& columns) {
  PrintedTable some;
  some.rows.resize(table.rows.size());
  for (const std::string_view column : columns) {
    const auto found = std::find_if(table.head.begin(), table.head.end(),
                                    [&](const std::string& heading) { return heading.starts_with(column); });
    if (found == table.head.end()) throw std::invalid_argument(fmt::format("no column '{}'", column));
    some.head.push_back(*found);
    const auto index = static_cast<std::size_t>(found - table.head.begin());
    for (std::size_t i = 0; i < table.rows.size(); ++i) some.rows[i].push_back(table.rows[i][index]);
  }
  return some;
}

PrintedTable failure_rows(const Campaign& campaign) {
  PrintedTable table{{"Test", "Reason", "File"}, {}};
  for (const auto& test : campaign.tests)
    if (!test.summary) table.rows.push_back({printable(test.name), printable(test.reason), printable(test.file)});
  return table;
}

PrintedTable shared_rows(const Campaign& campaign) {
  PrintedTable table{{"Parameter", "Value", "95 % interval", "Unit", "Tests", "Agreement"}, {}};
  for (const auto& shared : campaign.shared) {
    if (!std::isfinite(shared.estimate.value)) {
      table.rows.push_back({shared.name, "not told", "", "", fmt::format("{}", shared.tests), ""});
      continue;
    }
    const auto [unit, factor] = print_unit(shared.estimate.value, shared.unit);
    const MatchedDigits digits = matched_digits(shared.estimate, factor);
    table.rows.push_back({shared.name,
                          digits.error.empty() ? digits.value : fmt::format("{} ± {}", digits.value, digits.error),
                          digits.low.empty() ? "" : fmt::format("{} to {}", digits.low, digits.high), typeset(unit),
                          fmt::format("{}", shared.tests),
                          shared.agreement < 1e-4 ? "none" : fmt::format("p = {}", significant(shared.agreement, 2))});
  }
  return table;
}

PrintedTable specimen_rows(const Campaign& campaign) {
  PrintedTable table{{"Sawtooth", "Parameter", "Tests", "Typical", "Specimens differ by"}, {}};
  for (const auto& line : specimen_lines(campaign)) {
    const auto [unit, factor] = print_unit(line.typical.value, line.unit);
    const std::string sign = line.by_factors ? "a factor " : "± ";
    const std::string typical = with_interval(line.typical, factor);
    table.rows.push_back({line.category,
                          line.parameter == "mu0"         ? "μ₀"
                          : line.parameter == "roughness" ? "σ"
                                                          : "ℓ",
                          fmt::format("{}", line.between->tests.size()),
                          unit.empty() ? typical : fmt::format("{} {}", typical, typeset(unit)),
                          line.between->population.spread_is_bound
                              ? fmt::format("{}{} at most", sign, significant(line.spread.high, 2))
                              : sign + with_interval(line.spread, 1)});
  }
  return table;
}

std::string sharing_rule() {
  return "Agreement is the probability that tests which share one value would differ as much as these. Below 0.01 the "
         "tests hardly share it: the value is then a mean of different ones, and its error says nothing.";
}

std::string specimen_rule() {
  return "Typical is the mean of μ₀ over specimens, and σ and ℓ of the middle specimen, with their 95 % intervals. "
         "Specimens differ by the standard deviation of μ₀, and by a factor up or down in σ and ℓ; the error of each "
         "record is taken off. Suspects are left out.";
}

std::string category_rule() {
  return "None: fewer than three drops of the force, or drops that add up to less than 3\u00a0% of the greatest force. "
         "Clear: 15\u00a0% or more. Nominal: between. μ₀ is the friction averaged over the length that slid, σ the "
         "roughness of "
         "friction and ℓ its correlation length. A and λ are those of the likeliest wave of friction; brackets mark a "
         "wave that is only indicative. Height is half of crest to trough of the wave of the surface that would show "
         "it, "
         "Slope the rms of the slopes that would show how friction varies.";
}

}  // namespace flexslip
