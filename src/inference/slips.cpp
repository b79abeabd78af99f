#include "inference/slips.h"

#include <algorithm>
#include <cmath>

#include "data/names.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {

std::string_view name_of(SlipVerdict verdict) {
  return name_in_order<SlipVerdict::too_short>(
      verdict, {"possible", "unexplained", "implausible", "negative", "moves_out", "too_short"});
}

std::vector<Slip> slips_of(const FrictionProfile& profile, std::span<const Drop> drops, const MeasurementErrors& errors,
                           double limit) {
  const auto find = [&](std::size_t index) -> const ProfilePoint* {
    const auto at = std::lower_bound(profile.points.begin(), profile.points.end(), index,
                                     [](const ProfilePoint& point, std::size_t i) { return point.index < i; });
    return at == profile.points.end() || at->index != index ? nullptr : &*at;
  };
  std::vector<Slip> slips;
  for (const auto& drop : drops) {
    const ProfilePoint* const before = find(drop.before);
    const ProfilePoint* const after = find(drop.after);
    if (!before || !after) {
      slips.push_back(
          {drop, SlipVerdict::unexplained, not_a_number, not_a_number, not_a_number, not_a_number, not_a_number});
      continue;
    }
    Slip slip{drop,
              SlipVerdict::possible,
              before->S,
              after->S,
              before->mu,
              after->mu,
              elementary::length(errors.force * before->S_force, errors.force * after->S_force)};
    const double advance = slip.S_after - slip.S_before;
    if (advance < -two_sided_95 * slip.advance_error)
      slip.verdict = SlipVerdict::moves_out;
    else if (slip.mu_before - two_sided_95 * standard_error(*before) > limit)
      slip.verdict = SlipVerdict::implausible;
    else if (slip.mu_after + two_sided_95 * standard_error(*after) < 0)
      slip.verdict = SlipVerdict::negative;
    else if (advance < slip.advance_error)
      slip.verdict = SlipVerdict::too_short;
    slips.push_back(slip);
  }
  return slips;
}

std::vector<Slip> told_by(const FrictionProfile& profile, std::span<const Slip> judged,
                          const MeasurementErrors& errors) {
  std::vector<Drop> drops;
  for (const Slip& slip : judged) drops.push_back(slip.drop);
  std::vector<Slip> told = slips_of(profile, drops, errors, infinity);
  for (std::size_t i = 0; i < told.size(); ++i) told[i].verdict = judged[i].verdict;
  return told;
}

SlipSummary summarise(std::span<const Slip> all) {
  std::vector<Slip> slips;  // those that are told
  for (const auto& slip : all)
    if (slip.verdict == SlipVerdict::possible && std::isfinite(slip.S_before)) slips.push_back(slip);
  std::vector<double> spacings;
  std::vector<double> falls;
  for (std::size_t i = 0; i < slips.size(); ++i) {
    falls.push_back(slips[i].mu_before - slips[i].mu_after);
    if (i > 0) spacings.push_back(0.5 * (slips[i].S_before - slips[i - 1].S_before));
  }
  const auto possible =
      std::count_if(all.begin(), all.end(), [](const Slip& slip) { return slip.verdict == SlipVerdict::possible; });
  return {.count = static_cast<std::size_t>(possible),
          .median_spacing = median_of(spacings),
          .mean_spacing = mean_of(spacings),
          .median_fall = median_of(falls)};
}

}  // namespace flexslip
