#include "inference/gap_sites.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fibre/elementary.h"

namespace flexslip {

std::vector<GapSite> sites_of(const Passages& passages, const Linearisation& at, double noise,
                              const std::vector<GapSite>& before) {
  const auto& S = at.S;
  std::vector<GapSite> sites;
  auto kept = before.begin();
  for (std::size_t i = 1; i < S.size(); ++i) {
    const double jump = S[i] - S[i - 1];
    const double blur = std::abs(at.S_force[i]) * noise;
    if (!(jump > 2.5 * passages.advance[i] + 3 * blur)) continue;
    const double spacing = passages.range / 40;  // [L] in S: a few nodes tell what a jump passed over
    const auto count = static_cast<std::size_t>(std::clamp(std::ceil(jump / spacing), 3.0, 8.0));
    for (std::size_t node = 1; node <= count; ++node) {
      if (jump * static_cast<double>(count + 1 - node) < 1.5 * blur * static_cast<double>(count + 1)) break;
      GapSite site{.reading = i, .node = node, .nodes = count};
      while (kept != before.end() && (kept->reading < i || (kept->reading == i && kept->node < node))) ++kept;
      if (kept != before.end() && kept->reading == i && kept->node == node && kept->nodes == count) site = *kept;
      sites.push_back(site);
    }
  }
  return sites;
}

double log_weight(const GapSite& site, double mean, double variance) {
  const double precision = 1 / std::max(variance, 1e-12) - site.precision;
  if (!(precision > 1e-10)) return 0;
  const double cavity_variance = 1 / precision;
  const double cavity = (mean / std::max(variance, 1e-12) - site.precision_mean) * cavity_variance;
  const double z = cavity / std::sqrt(cavity_variance + bound_softness * bound_softness);
  double weight = elementary::gaussian_below(z).log_probability;
  if (site.precision > 0) {
    const double spread = cavity_variance + 1 / site.precision;
    const double away = site.precision_mean / site.precision - cavity;
    weight += 0.5 * (elementary::log(2 * std::numbers::pi * spread) + away * away / spread);
  }
  return weight;
}

}  // namespace flexslip
