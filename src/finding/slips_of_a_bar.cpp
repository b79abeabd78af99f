#include "finding/slips_of_a_bar.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "finding/printed.h"
#include "inference/slip_limit.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

std::size_t drops_of(T test) { return test.analysis.drops.drops.size(); }

const Drop& deepest_of(const std::vector<Drop>& drops) {
  return *std::max_element(drops.begin(), drops.end(),
                           [](const Drop& a, const Drop& b) { return a.force_fall < b.force_fall; });
}

double most_by_slips_of(T test) {
  return *std::max_element(test.analysis.most_by_slips.begin(), test.analysis.most_by_slips.end());
}

// "2 drops are"
std::string drops_are(T test) {
  return drops_of(test) == 1 ? "1 drop is" : fmt::format("{} drops are", drops_of(test));
}

// Drops that are deeper than any slip, of a test without friction.
std::size_t beyond_slips(T test) {
  const auto& analysis = test.analysis;
  constexpr double surely = 4;  // of the noise of a reading
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < analysis.most_by_slips.size(); ++i) {
    const double fall = analysis.scales.reduced_force(analysis.drops.drops[i].force_fall);
    beyond += fall > analysis.most_by_slips[i] + surely * analysis.force_noise ? 1 : 0;
  }
  return beyond;
}

// "at 3.1 mm a slip can make at most 80 mN"
std::string most_by_slip_in_words(T test) {
  const auto& most = test.analysis.most_by_slips;
  const auto greatest = std::max_element(most.begin(), most.end());
  const std::size_t before = test.analysis.drops.drops[static_cast<std::size_t>(greatest - most.begin())].before;
  const Print print(test);
  return fmt::format(
      "at {} a slip can make at most {}", print.length(test.analysis.reduced.deflection[before]),
      std::string(format_roughly(test.analysis.scales.physical_force(*greatest), print.as(kind::force))));
}

// "2 drops (650 mN and 1.25 N)"
std::string drops_with_sizes(T test) {
  constexpr std::size_t shown = 3;
  const auto& drops = test.analysis.drops.drops;
  const std::string all = format_count(drops.size(), "drop", "drops");
  if (drops.size() > shown)
    return fmt::format("{}, the largest {}", all, Print(test).own(deepest_of(drops).force_fall, kind::force));
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

bool seeks_drops(T test) { return std::isfinite(test.analysis.force_noise); }

bool is_slender(T test) { return 2 * test.analysis.rig.fibre.supports().half_depth <= least_height_of_a_bar; }

std::optional<Finding> gave_way(T test) {
  const std::size_t beyond = beyond_slips(test);
  if (is_fitted(test) || beyond == 0) return std::nullopt;
  const Drop& drop = deepest_of(test.analysis.drops.drops);
  return Finding{
      .severity = Severity::refusal,
      .sentence = fmt::format("{} of {} deeper than any slip: {}. The specimen gave way.", beyond, drops_are(test),
                              most_by_slip_in_words(test)),
      .short_form = "gave way",
      .remedy = fmt::format("Use flexslip modulus for stiffness and strength; until = {} under [record] ends the "
                            "record before the deepest drop.",
                            file_row(test, drop.before)),
      .numbers = {{"beyond_slips", static_cast<double>(beyond)},
                  {"most_by_slip", test.analysis.scales.physical_force(most_by_slips_of(test)), kind::force}}};
}

std::string slips_of_a_bar_in_words(T test) {
  return fmt::format("{}; {} of {} deeper", most_by_slip_in_words(test), beyond_slips(test), drops_are(test));
}

// Of a specimen that is bent too little to tell friction: what its drops are can still be told.
Verdict verdict_without_friction(T test, const Finding& shallow, const Finding* gave_way) {
  const std::string no_friction = "friction cannot be told at so small a deflection";
  if (drops_of(test) == 0) return {VerdictCode::no_drops, {no_friction}, shallow.code};
  const std::string most = most_by_slip_in_words(test);
  if (gave_way)
    return {
        VerdictCode::crack, {drops_with_sizes(test), most + ": the specimen gave way", no_friction}, gave_way->code};
  return {VerdictCode::undecided,
          {drops_with_sizes(test), most + ", so that they can be slips", no_friction},
          shallow.code};
}

}  // namespace flexslip
