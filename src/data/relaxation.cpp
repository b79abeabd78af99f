#include "data/relaxation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/no_readings.h"

namespace flexslip {
namespace {

std::size_t rows_at_end(const StageRest& rest) { return std::max<std::size_t>(1, (rest.last - rest.first) / 4); }

}  // namespace

std::vector<StageRest> find_rests(const std::vector<double>& displacement, std::span<const double> force) {
  std::vector<StageRest> rests;
  for (const std::size_t row : find_halts(displacement)) {
    if (rests.empty() || row > rests.back().last + 1) rests.push_back({row - 1, row, 0, 0});
    rests.back().last = row;
  }
  for (StageRest& rest : rests) {
    const auto end = force.subspan(rest.last + 1 - rows_at_end(rest), rows_at_end(rest));
    rest.force = force[rest.first];
    rest.fall = rest.force - std::accumulate(end.begin(), end.end(), 0.0) / static_cast<double>(end.size());
  }
  return rests;
}

std::optional<Relaxation> relaxation_at(const std::vector<StageRest>& rests, std::size_t rows_of_loading,
                                        double noise) {
  double rows = 0, fall = 0, variance = 0, impulse = 0;  // impulse of the last: [N rows]
  for (const StageRest& rest : rests) {
    const auto length = static_cast<double>(rest.last - rest.first);
    rows += length;
    fall += rest.fall;
    variance += noise * noise * (1 + 1 / static_cast<double>(rows_at_end(rest)));
    impulse += std::max(rest.force, 0.0) * length;
  }
  constexpr double beyond_errors = 3;
  if (!(impulse > 0) || !(fall > beyond_errors * std::sqrt(variance))) return std::nullopt;
  const double force = impulse / rows;
  return Relaxation{.rests = rests.size(),
                    .rows = static_cast<std::size_t>(rows),
                    .share = normal_estimate(fall / force, std::sqrt(variance) / force),
                    .over_loading = fall / impulse * static_cast<double>(rows_of_loading)};
}

}  // namespace flexslip
