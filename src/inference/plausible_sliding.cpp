#include "inference/plausible_sliding.h"

#include <algorithm>
#include <vector>

#include "bending_test/equilibrium.h"
#include "data/order.h"
#include "fibre/elementary.h"
#include "inference/profile.h"

namespace flexslip {

bool may_slide(const Record& record, const Scales& scales, const Rig& rig, double bending_stiffness_error) {
  const auto slides = [&](double stiffening) {
    const ReducedRecord reduced = to_reduced(record, {scales.span(), stiffening * scales.bending_stiffness()});
    const FrictionProfile profile = measure_friction(reduced, rig.in_units_of(stiffening), {}, judged_from);
    const auto negative = static_cast<std::size_t>(std::count_if(
        profile.points.begin(), profile.points.end(), [](const auto& point) { return point.mu < least_friction; }));
    const std::size_t impossible = negative + profile.unexplained.size();
    return 5 * impossible <= profile.points.size() + profile.unexplained.size();
  };
  const double within = elementary::exp(2 * bending_stiffness_error);
  return slides(1) || slides(within) || slides(1 / within);
}

OverFrictionless over_frictionless(const ReducedRecord& record, const Fibre& fibre) {
  const double deepest = *std::max_element(record.deflection.begin(), record.deflection.end());
  if (!(deepest > judged_from)) return {};
  constexpr int enough = 200;  // for the ratio to 1e-4
  const auto frictionless = sliding_up_to(deepest, 0, enough, fibre);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    if (!(record.deflection[i] > judged_from)) continue;
    const double ratio = record.force[i] / force_at(frictionless, record.deflection[i]);
    if (std::isfinite(ratio)) ratios.push_back(ratio);
  }
  if (ratios.empty()) return {};
  return {.median = median_of(ratios), .least = *std::min_element(ratios.begin(), ratios.end())};
}

}  // namespace flexslip
