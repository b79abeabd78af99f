#include "finding/slips_of_a_bar.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "finding/clauses.h"
#include "finding/printed.h"
#include "inference/slip_limit.h"
#include "io/text.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

const Drop& deepest_of(const std::vector<Drop>& drops) {
  return *std::max_element(drops.begin(), drops.end(),
                           [](const Drop& a, const Drop& b) { return a.force_fall < b.force_fall; });
}

// Drops that are deeper than any slip, of a bar without friction.
std::size_t beyond_slips(T test) {
  const auto& slips = test.analysis.slips;
  return static_cast<std::size_t>(std::count_if(
      slips.begin(), slips.end(), [](const Slip& slip) { return slip.verdict == SlipVerdict::too_deep; }));
}

// The drop that is deepest beside what a slip can do there.
const Slip& least_like_a_slip(T test) {
  const auto beyond = [&](const Slip& slip) {
    return test.analysis.scales.reduced_force(slip.drop.force_fall) - slip.most;
  };
  const std::vector<Slip>& slips = test.analysis.slips;
  return *std::max_element(slips.begin(), slips.end(),
                           [&](const Slip& a, const Slip& b) { return beyond(a) < beyond(b); });
}

double most_by_slip(T test, const Slip& slip) { return test.analysis.scales.physical_force(std::max(slip.most, 0.0)); }

// "at 3.1 mm a slip can make at most 80 mN"
std::string most_by_slip_in_words(T test) {
  const Slip& slip = least_like_a_slip(test);
  const double deflection = test.analysis.reduced.deflection[slip.drop.before];
  const double most = most_by_slip(test, slip);
  const Print print(test);
  return fmt::format("at {} a slip can make at most {}", print.length(deflection),
                     std::string(format_roughly(most, print.as(kind::force))));
}

// "1 of 10 drops is deeper"
std::string deeper_drops(T test) {
  const std::size_t beyond = beyond_slips(test);
  if (drops_of(test) == 1) return beyond == 1 ? "the drop is deeper" : "the drop is shallower";
  const std::string some = beyond == 0 ? "none" : fmt::format("{}", beyond);
  return fmt::format("{} of {} drops {} deeper", some, drops_of(test), beyond <= 1 ? "is" : "are");
}

// Would a drop be deeper than any slip if the specimen were so many times as thick?
bool is_one_beyond(T test, double times) {
  const TestAnalysis& analysis = test.analysis;
  Supports supports = analysis.rig.fibre.supports();
  supports.half_depth *= times;
  const std::vector<Drop>& drops = analysis.drops.drops;
  const std::vector<double> most = most_by_slips(analysis.reduced, drops, supports);
  for (std::size_t i = 0; i < most.size(); ++i)
    if (is_beyond_slips(analysis.scales.reduced_force(drops[i].force_fall), most[i], analysis.force_noise)) return true;
  return false;
}

// "; it could be a slip from a thickness of 2.4 mm on": where half or twice the thickness would turn the verdict, by which.
std::string thickness_in_words(T test) {
  const double half_depth = test.analysis.rig.fibre.supports().half_depth;
  if (drops_of(test) == 0 || !(half_depth > 0)) return "";
  constexpr double far = 2;
  constexpr int halvings = 12;  // to a thousandth
  const bool is_beyond = is_one_beyond(test, 1);
  // The thicker it is, the more a slip can do.
  double same = 1, other = is_beyond ? far : 1 / far;
  if (is_one_beyond(test, other) == is_beyond) return "";
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(same, other);
    (is_one_beyond(test, middle) == is_beyond ? same : other) = middle;
  }
  const std::string thickness =
      format_roughly(test.analysis.scales.physical_length(2 * half_depth * other), Print(test).as(kind::length));
  const bool is_one = drops_of(test) == 1;
  return is_beyond
             ? fmt::format("; {} from a thickness of {} on", is_one ? "it could be a slip" : "all could be slips",
                           thickness)
             : fmt::format("; below a thickness of {} {} be deeper", thickness, is_one ? "it would" : "one would");
}

// "2 drops (650 mN and 1.25 N)"
std::string drops_with_sizes(T test) {
  constexpr std::size_t shown = 3;
  const auto& drops = test.analysis.drops.drops;
  const std::string all = format_count(drops.size(), "drop", "drops");
  if (drops.size() > shown) return fmt::format("{}, {}", all, sizes_in_words(test));
  std::string sizes;
  for (std::size_t i = 0; i < drops.size(); ++i)
    sizes += fmt::format("{}{}",
                         i == 0                  ? ""
                         : i + 1 == drops.size() ? " and "
                                                 : ", ",
                         Print(test).own(drops[i].force_fall, kind::force));
  return fmt::format("{} ({})", all, sizes);
}

}  // namespace

bool tells_slips_of_a_bar(T test) {
  const std::vector<Slip>& slips = test.analysis.slips;
  return test.analysis.status == AnalysisStatus::bent_too_little && !slips.empty() && std::isfinite(slips.front().most);
}

std::string sizes_in_words(T test) {
  const auto& drops = test.analysis.drops.drops;
  const double largest = deepest_of(drops).force_fall;
  constexpr double small = 0.1;
  const auto small_ones = static_cast<std::size_t>(
      std::count_if(drops.begin(), drops.end(), [&](const Drop& drop) { return drop.force_fall < small * largest; }));
  return fmt::format(
      "the largest {}{}", Print(test).own(largest, kind::force),
      2 * small_ones > drops.size() ? fmt::format(", {} of them below a tenth of that", small_ones) : "");
}

bool is_slender(T test) { return 2 * test.analysis.rig.fibre.supports().half_depth <= least_height_of_a_bar; }

std::optional<Finding> gave_way(T test) {
  const std::size_t beyond = beyond_slips(test);
  const auto& deflection = test.analysis.reduced.deflection;
  const bool is_bent = std::any_of(deflection.begin(), deflection.end(), [](double w) { return w > 0; });
  if (is_fitted(test) || beyond == 0 || !is_bent) return std::nullopt;
  const Slip& slip = least_like_a_slip(test);
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("{} than any slip: {}. The specimen gave way.", capitalised(deeper_drops(test)),
                              most_by_slip_in_words(test)),
      .short_form = "gave way",
      .remedy = fmt::format(
          "Use flexslip modulus for stiffness and strength; to end the record before that drop, {}.",
          to_say(test.measurement.test, {{"record", "until", fmt::format("{}", file_row(test, slip.drop.before))}})),
      .numbers = {{"beyond_slips", static_cast<double>(beyond)},
                  {"most_by_slip", most_by_slip(test, slip), kind::force}}};
}

std::optional<Finding> sinks(T test) {
  const std::vector<double>& force = test.analysis.record.force;
  constexpr std::size_t enough = 20, at_the_end = 5;
  if (is_fitted(test) || test.analysis.status != AnalysisStatus::bent_too_little || force.size() < enough)
    return std::nullopt;
  const auto greatest = std::max_element(force.begin(), force.end());
  const double end = median_of(std::vector<double>(force.end() - at_the_end, force.end()));
  double by_drops = 0;
  for (const Drop& drop : test.analysis.drops.drops)
    if (drop.before >= static_cast<std::size_t>(greatest - force.begin())) by_drops += drop.force_fall;
  const double sunk = 1 - (end + by_drops) / *greatest;
  constexpr double worth_saying = 0.1;
  if (!(*greatest > 0 && sunk > worth_saying)) return std::nullopt;
  const std::size_t row = file_row(test, static_cast<std::size_t>(greatest - force.begin()));
  return Finding{.severity = Severity::doubt,
                 .sentence = fmt::format("From row {} on the force sinks by {} without a drop, as no elastic specimen "
                                         "does at so small a deflection: it yielded or gave way slowly.",
                                         row, format_percent(sunk)),
                 .short_form = fmt::format("the force sinks by {}", format_percent(sunk)),
                 .remedy = "Use flexslip modulus for stiffness and strength.",
                 .numbers = {{"sunk", sunk}, {"row", static_cast<double>(row)}}};
}

std::string slips_of_a_bar_in_words(T test) {
  return fmt::format("{}; {}{}", most_by_slip_in_words(test), deeper_drops(test), thickness_in_words(test));
}

// Of a specimen that is bent too little to tell friction: what its drops are can still be told.
Verdict verdict_without_friction(T test, const Finding& shallow, const Finding* gave_way) {
  const std::string no_friction(no_friction_of_a_bar);
  if (drops_of(test) == 0) {
    Verdict none{VerdictCode::no_drops, {no_friction}, shallow.code};
    if (const auto slowly = sinks(test)) none.parts.insert(none.parts.begin(), slowly->short_form + " all the same");
    return none;
  }
  const std::string most = most_by_slip_in_words(test);
  if (gave_way)
    return {
        VerdictCode::crack, {drops_with_sizes(test), most + ": the specimen gave way", no_friction}, gave_way->code};
  return {VerdictCode::undecided,
          {drops_with_sizes(test),
           fmt::format("{}, so that {} can be {}", most, drops_of(test) == 1 ? "it" : "they",
                       drops_of(test) == 1 ? "a slip" : "slips"),
           no_friction},
          shallow.code};
}

}  // namespace flexslip
