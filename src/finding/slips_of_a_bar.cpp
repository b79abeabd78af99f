#include "finding/slips_of_a_bar.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

const Slip& least_like_a_slip(T test) { return test.analysis.slips[test.analysis.slips_of_bar->least_like_a_slip]; }

// "; it could be a slip from a thickness of 2.4 mm on": where half or twice the thickness would turn the verdict, by which.
std::string thickness_in_words(T test) {
  const SlipsOfABar& of_bar = *test.analysis.slips_of_bar;
  if (std::isnan(of_bar.turning_thickness)) return "";
  const double thickness = 2 * test.analysis.rig.fibre.supports().half_depth * of_bar.turning_thickness;
  const std::string from =
      format_roughly(test.analysis.scales.physical_length(thickness), Print(test).as(kind::length));
  const bool is_one = drops_of(test) == 1;
  return of_bar.beyond > 0
             ? fmt::format("; {} from a thickness of {} on", is_one ? "it could be a slip" : "all could be slips", from)
             : fmt::format("; below a thickness of {} {} be deeper", from, is_one ? "it would" : "one would");
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

double most_by_slip(T test) { return test.analysis.scales.physical_force(std::max(least_like_a_slip(test).most, 0.0)); }

std::string most_by_slip_in_words(T test) {
  const double deflection = test.analysis.reduced.deflection[least_like_a_slip(test).drop.before];
  const Print print(test);
  return fmt::format("at {} a slip can make at most {}", print.length(deflection),
                     format_roughly(most_by_slip(test), print.as(kind::force)));
}

std::string deeper_drops(T test) {
  const std::size_t beyond = test.analysis.slips_of_bar->beyond;
  if (drops_of(test) == 1) return beyond == 1 ? "the drop is deeper" : "the drop is shallower";
  const std::string some = beyond == 0 ? "none" : fmt::format("{}", beyond);
  return fmt::format("{} of {} drops {} deeper", some, drops_of(test), beyond <= 1 ? "is" : "are");
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

std::string slips_of_a_bar_in_words(T test) {
  return fmt::format("{}; {}{}", most_by_slip_in_words(test), deeper_drops(test), thickness_in_words(test));
}

Verdict verdict_of_a_bar(T test, const std::vector<Finding>& findings) {
  const std::string no_friction(no_friction_of_a_bar);
  const Finding& refusal = findings.front();
  if (drops_of(test) == 0) {
    Verdict none{VerdictCode::no_drops, {no_friction}, refusal.code};
    if (const Finding* slowly = finding_in(findings, "sinks"))
      none.parts.insert(none.parts.begin(), slowly->short_form + " all the same");
    return none;
  }
  const std::string most = most_by_slip_in_words(test);
  if (test.analysis.slips_of_bar->beyond > 0)
    return {VerdictCode::crack, {drops_with_sizes(test), most + ": the specimen gave way", no_friction}, refusal.code};
  return {VerdictCode::undecided,
          {drops_with_sizes(test),
           fmt::format("{}, so that {} can be {}", most, drops_of(test) == 1 ? "it" : "they",
                       drops_of(test) == 1 ? "a slip" : "slips"),
           no_friction},
          refusal.code};
}

}  // namespace flexslip
