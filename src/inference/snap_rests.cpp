#include "inference/snap_rests.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t min_rise = 5;  // [readings] for three parameters and their misfit

// The readings from the end of one snap to the next.
struct Rise {
  std::size_t first, beyond;
};

std::vector<Rise> rises_after_snaps(const InvertedReadings& r, double jump_advances, double jump_noise) {
  std::vector<Rise> rises;
  for (std::size_t i = 1; i < r.S.size(); ++i) {
    const bool jumps = r.S[i] - r.S[i - 1] > jump_advances * r.advance[i] + jump_noise * r.noise[i];
    if (!jumps || !(r.force[i] < r.force[i - 1])) continue;
    if (!rises.empty()) rises.back().beyond = i;
    rises.push_back({i, r.S.size()});
  }
  return rises;
}

// [L] The noise of a length in a rise, with a minimum for exact records.
double noise_of(const InvertedReadings& r, const Rise& rise) {
  constexpr double least = 3e-5;
  double sum = 0;
  for (std::size_t i = rise.first; i < rise.beyond; ++i) sum += r.noise[i];
  return std::max(sum / static_cast<double>(rise.beyond - rise.first), least);
}

// The reading at which S has grown by half of its growth in the rise, before the fold.
Rise first_half(const InvertedReadings& r, const Rise& rise, double noise) {
  const double begin = r.S[rise.first];
  const double end = *std::max_element(r.S.begin() + static_cast<std::ptrdiff_t>(rise.first),
                                       r.S.begin() + static_cast<std::ptrdiff_t>(rise.beyond));
  constexpr double visible = 4;  // [noise]
  const double half = begin + std::max(0.5 * (end - begin), visible * noise);
  std::size_t beyond = rise.first;
  while (beyond < rise.beyond && r.S[beyond] <= half) ++beyond;
  return {rise.first, std::min(std::max(beyond, rise.first + min_rise), rise.beyond)};
}

struct Bend {
  double misfit;       // [L^2] sum of squares of S about the line
  std::size_t corner;  // the last reading before the kink
};

// Fits S against the stage by a line with an upward kink at a reading; before it, the slope is a
// share of the later, non-negative slope.
Bend best_bend(const InvertedReadings& r, const Rise& rise, double share) {
  const auto count = static_cast<double>(rise.beyond - rise.first);
  Bend best{infinity, rise.first};
  for (std::size_t corner = rise.first; corner + 1 < rise.beyond; ++corner) {
    const auto along = [&](std::size_t i) {
      return share * (r.stage[i] - r.stage[rise.first]) + (1 - share) * std::max(r.stage[i] - r.stage[corner], 0.0);
    };
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = rise.first; i < rise.beyond; ++i) {
      x += along(i) / count;
      y += (r.S[i] - r.S[rise.first]) / count;
    }
    for (std::size_t i = rise.first; i < rise.beyond; ++i) {
      const double dx = along(i) - x, dy = r.S[i] - r.S[rise.first] - y;
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
    }
    const double misfit = xx > 0 && xy > 0 ? std::max(yy - xy * xy / xx, 0.0) : yy;
    if (misfit < best.misfit) best = {misfit, corner};
  }
  return best;
}

double misfit_of_rest(const InvertedReadings& r, const Rise& rise) {
  double mean = 0, misfit = 0;
  for (std::size_t i = rise.first; i < rise.beyond; ++i) mean += r.S[i] / static_cast<double>(rise.beyond - rise.first);
  for (std::size_t i = rise.first; i < rise.beyond; ++i) misfit += (r.S[i] - mean) * (r.S[i] - mean);
  return misfit;
}

// The reading at which a snap ended always sticks; the last reading before the next snap slides.
StuckReadings stuck_in(const InvertedReadings& r, const Rise& rise, const Rise& half, const Bend& bend, double noise) {
  constexpr double surely = 9;  // [noise variances] three errors of the slope, otherwise it has not started to slide
  const bool slides = misfit_of_rest(r, half) - bend.misfit > surely * noise * noise;
  const std::size_t beyond = slides ? bend.corner + 1 : rise.beyond;
  const bool snaps_again = rise.beyond < r.S.size() && rise.beyond > rise.first + 1;
  return {rise.first, snaps_again ? std::min(beyond, rise.beyond - 1) : beyond};
}

}  // namespace

SnapRests rests_of_snaps(const InvertedReadings& readings, double jump_advances, double jump_noise) {
  SnapRests rests{};
  for (const Rise& rise : rises_after_snaps(readings, jump_advances, jump_noise)) {
    const double noise = noise_of(readings, rise);
    const Rise half = first_half(readings, rise, noise);
    const Bend sticks = best_bend(readings, half, 0);
    rests.stuck.push_back(stuck_in(readings, rise, half, sticks, noise));
    if (half.beyond - half.first < min_rise) continue;
    constexpr double at_once = 0.5;  // of its later rate; imaged specimens advance at least as fast
    constexpr double most = 30;      // [1] limit for one rise, because lines are only approximations
    const double gain = (best_bend(readings, half, at_once).misfit - sticks.misfit) / (2 * noise * noise);
    rests.log_evidence += std::clamp(gain, -most, most);
  }
  return rests;
}

}  // namespace flexslip
