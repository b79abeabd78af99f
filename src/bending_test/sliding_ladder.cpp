#include "bending_test/sliding_ladder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/state_table.h"

namespace flexslip {
SlidingLadder::SlidingLadder(double S_max, double S_step, const Fibre& fibre) : fibre_(fibre) {
  if (!(S_max > 1 && S_max <= longest_ladder))
    throw std::invalid_argument("S_max must lie in (1, 2.1], not " + std::to_string(S_max));
  if (!(S_step > 0)) throw std::invalid_argument("S_step must be positive, not " + std::to_string(S_step));
  const double sigma_max = fibre.way(S_max), from = fibre.way(1);  // bent as if that much were before it
  const auto n = static_cast<std::size_t>(std::ceil(2 * sigma_max * sigma_max / S_step)) + 2;
  const double sigma_step = (sigma_max + from) / static_cast<double>(n - 1);
  S_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double sigma = sigma_step * static_cast<double>(i) - from;
    S_[i] = sigma >= from ? fibre.length_at(sigma) : 1;
    if (sigma < from) shallow_.push_back(fibre.state(1, 0).w * (sigma + from) / (2 * from));
  }
}

StateArrays SlidingLadder::curve(std::span<const double> mu) const {
  std::vector<double> q(mu.begin(), mu.end());
  for (double& value : q) value = std::clamp(value, 0.0, table_q.greatest);
  StateArrays states = fibre_.tabulated_states({S_, q});
  // The surface slides out up to 1.2 half depths of deflection, holds, and slides in from 1.35 on: some hundredths of the friction between.
  for (std::size_t i = 0; i < shallow_.size(); ++i) {
    const double w = shallow_[i];
    const double held = mu[i] * std::clamp((w / fibre_.supports().half_depth - 1.27) / 0.08, -1.0, 1.0);
    states.w[i] = w;
    states.F[i] = fibre_.bent(w, held).state.F;
  }
  return states;
}

namespace {

// The cubic over one cell through two values with slopes from the values around (central differences).
struct Cubic {
  double value, d0, c2, c3;
  Cubic(std::span<const double> y, std::size_t i) {
    const auto last = y.size() - 1;
    const double rise = y[i + 1] - y[i];
    value = y[i];
    d0 = i > 0 ? 0.5 * (y[i + 1] - y[i - 1]) : rise;
    const double d1 = i + 1 < last ? 0.5 * (y[i + 2] - y[i]) : rise;
    c2 = 3 * rise - 2 * d0 - d1;
    c3 = d0 + d1 - 2 * rise;
  }
  double at(double x) const { return value + x * (d0 + x * (c2 + x * c3)); }
  double slope(double x) const { return d0 + x * (2 * c2 + x * 3 * c3); }
  // The greatest of its second derivative in [0, 1].
  double curvature() const { return std::max(std::abs(2 * c2), std::abs(2 * c2 + 6 * c3)); }
  // Where it is greatest in [0, 1].
  double peak() const {
    if (d0 <= 0) return 0;
    if (slope(1) >= 0) return 1;
    // the slope changes sign once from + to -
    const double root = std::sqrt(std::max(c2 * c2 - 3 * d0 * c3, 0.0));
    return std::clamp(d0 / (root - c2), 0.0, 1.0);
  }
};

}  // namespace

std::vector<double> measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                                   std::span<const double> stages) {
  const auto n = w.size();
  std::vector<double> G(n);
  for (std::size_t i = 0; i < n; ++i) G[i] = w[i] + compliance * F[i];
  std::vector<double> result;
  result.reserve(stages.size());
  std::size_t cell = 0;
  double passed = 0;  // fraction of the cell that the running maximum has passed
  for (const double stage : stages) {
    double x = 1;
    for (; cell + 1 < n; ++cell, passed = 0) {
      // Where both ends of a cell fall short of the stage position, G can reach it between them only if it turns over there.
      const bool short_of = G[cell + 1] < stage && G[cell] < stage;
      const bool turns_here = G[cell + 1] < G[cell] && (cell == 0 || G[cell - 1] < G[cell]);
      const bool turns_next = cell + 2 < n && G[cell] < G[cell + 1] && G[cell + 2] < G[cell + 1];
      if (short_of && !turns_here && !turns_next) continue;
      const Cubic cubic(G, cell);
      const double peak = cubic.peak();
      if (cubic.at(peak) < stage || peak < passed) continue;
      // G rises from `passed` to the peak: Newton's iteration within these bounds
      double low = passed;
      double high = peak;
      x = std::clamp((stage - cubic.value) / (cubic.at(peak) - cubic.value) * peak, low, high);
      for (int iteration = 0; iteration < 20; ++iteration) {
        const double miss = cubic.at(x) - stage;
        (miss < 0 ? low : high) = x;
        const double newton = x - miss / cubic.slope(x);
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        // Newton's error after a step d is d² G''/2G': below 1e-6 of a cell it is less than that of the interpolation.
        const double d = next - x;
        const bool done = std::abs(d) < 1e-6 || (next == newton && d * d * cubic.curvature() < 1e-6 * cubic.slope(x));
        x = next;
        if (done) break;
      }
      passed = x;
      break;
    }
    result.push_back(Cubic(F, std::min(cell, n - 2)).at(x));
  }
  return result;
}

}  // namespace flexslip
