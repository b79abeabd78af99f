#include "bending_test/sliding_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "contact/over_rollers.h"
#include "fibre/batch.h"
#include "fibre/state_table.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/interpolant.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// The straight specimen, with infinite derivatives in S but finite ones in x.
CurveSample straight(double direction, double compliance, double q) {
  const double slope = std::sqrt(15.0) / 6 * (1 + beam_stiffness * compliance);
  return {true, {1, q, 0, 0, 0, infinity}, direction * slope, slope};
}

// NaN beyond the end of the branch.
CurveSample sample_of(double direction, const Rig& rig, double S, const FrictionPoint& mu,
                      const Fibre::TabulatedSlopes& fibre) {
  const double q = direction * mu.mu, compliance = 1 / rig.stiffness;
  if (S == 1 && rig.fibre.slides_inward_only()) return straight(direction, compliance, q);
  // of the rounded S, which all functions use
  const double sigma = rig.fibre.sliding_coordinate(S);
  const double smooth = fibre.w_S + compliance * fibre.F_S;
  const double rough = direction * (fibre.w_q + compliance * fibre.F_q) * mu.slope;
  return {.exists = !std::isnan(fibre.w),
          .point = {S, q, fibre.w, fibre.F, fibre.w + compliance * fibre.F, smooth + rough},
          .slope = direction * 2 * sigma * (smooth + rough),
          .scale = 2 * sigma * (fibre.w_S + compliance * std::abs(fibre.F_S) + std::abs(rough))};
}

}  // namespace

double coordinate_at(const Fibre& fibre, Sliding sliding, double S) {
  return direction_of(sliding) * fibre.sliding_coordinate(S);
}

CurveSample sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x) {
  const double S = rig.fibre.length_at(x);
  const double direction = direction_of(sliding);
  const FrictionPoint mu = friction.at(S);
  const auto [state, slopes] = rig.fibre.state_slopes(S, direction * mu.mu);
  return sample_of(direction, rig, S, mu, {state.w, state.F, slopes.w_S, slopes.w_q, slopes.F_S, slopes.F_q});
}

std::vector<CurveSample> samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                    std::span<const double> x) {
  const Fibre& fibre = rig.fibre;
  const double direction = direction_of(sliding);
  std::vector<double> S(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) S[i] = fibre.length_at(x[i]);
  const FrictionArrays mu = friction.at(S);
  std::vector<double> q(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) q[i] = direction * mu.mu[i];
  const FibrePoints points(S, q);
  const SlopeArrays at = fibre.on_edges() ? fibre.states_slopes(points) : fibre.tabulated_states_slopes(points);
  std::vector<CurveSample> result;
  result.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    result.push_back(sample_of(direction, rig, S[i], {mu.mu[i], mu.slope[i]},
                               {at.w[i], at.F[i], at.w_S[i], at.w_q[i], at.F_S[i], at.F_q[i]}));
  return result;
}

CurveSample tabulated_sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x) {
  const double S = rig.fibre.length_at(x), direction = direction_of(sliding);
  const FrictionPoint mu = friction.at(S);
  return sample_of(direction, rig, S, mu, rig.fibre.tabulated_state_slopes(S, direction * mu.mu));
}

SlidingTable::SlidingTable(const Friction& friction, const Rig& rig, Sliding sliding)
    : friction_(met(friction, rig.fibre, direction_of(sliding), longest_sliding)),
      rig_(rig),
      direction_(direction_of(sliding)) {}

SlidingTable::Sample SlidingTable::sample_at(double sigma) const {
  constexpr double supported_error = 1e-11;  // of a state from tables of supports
  const Fibre& fibre = rig_.fibre;
  const double S = fibre.length_at(sigma);
  if (S == 1 && fibre.slides_inward_only()) return {.exists = true};
  const auto mu = friction_.at(S);
  const double q = direction_ * mu.mu;
  const auto [state, slopes] = fibre.on_edges() ? FibreStateSlopes{fibre.state(S, q), {}} : fibre.state_slopes(S, q);
  if (state.status != FibreStatus::ok) return {};
  const double corrected =
      // refers all to the rounded length; proportional to σ at first
      sigma / fibre.sliding_coordinate(S);
  const double leaves = 1 - 2 * fibre.supports().radius * (slopes.theta0_S + direction_ * slopes.theta0_q * mu.slope);
  const double power = 2 * sigma * corrected;
  return {.exists = true,
          .stage = (state.w + state.F / rig_.stiffness) * corrected,
          .F = state.F * corrected,
          .friction = (q * state.Pn + fibre.bending_energy_lost_at_contact(state) * leaves) * power,
          .max_friction = state.Pn * power,
          .error = 0x1p-50 * std::abs(mu.slope) + (fibre.on_edges() ? 0 : supported_error)};
}

void SlidingTable::fill(Cell& cell, double from, double to, Sample greatest, int halvings) const {
  // of the last coefficients; the integral is at least ten times better
  constexpr double accuracy = 1e-12;
  constexpr int max_halvings = 30;         // at a kink: to 1e-9 of the cell
  constexpr std::size_t max_pieces = 200;  // enough for a few kinks
  Series stage{}, F{}, friction{};
  std::size_t missing = 0;
  for (std::size_t j = 0; j <= degree; ++j) {
    const Sample sample = sample_at(0.5 * (from + to) + 0.5 * (to - from) * Interpolant<degree>::node(j));
    stage[j] = sample.stage;
    F[j] = sample.F;
    friction[j] = sample.friction;
    missing += sample.exists ? 0 : 1;
    for (const auto field : {&Sample::stage, &Sample::F, &Sample::max_friction, &Sample::error})
      greatest.*field = std::max(greatest.*field, sample.*field);
  }
  const auto is_resolved = [&](const Series& c, double scale) {
    return std::abs(c[degree]) + std::abs(c[degree - 1]) <= (accuracy + greatest.error) * scale;
  };
  const bool ends = missing > 0 && missing <= degree;  // the branch ends within
  // the last piece, halved no further, has no force left
  if (ends) F = {};
  stage = Interpolant<degree>::chebyshev(stage);
  F = Interpolant<degree>::chebyshev(F);
  friction = Interpolant<degree>::chebyshev(friction);
  const bool resolved = !ends && is_resolved(stage, greatest.stage) && is_resolved(F, greatest.F) &&
                        is_resolved(friction, greatest.max_friction);
  if (!resolved && halvings < max_halvings && cell.size() < max_pieces) {
    const double middle = 0.5 * (from + to);
    fill(cell, from, middle, greatest, halvings + 1);
    fill(cell, middle, to, greatest, halvings + 1);
    return;
  }
  const SlidingWork before = cell.empty() ? SlidingWork{0, 0} : up_to(cell, cell.back().to);
  cell.push_back({from, to, integrated(product<degree + 1>(F, derivative(stage)), 1),
                  integrated(friction, 0.5 * (to - from)), before});
}

const SlidingTable::Cell& SlidingTable::cell(std::size_t i) {
  Cell& found = cells_[i];
  if (found.empty())
    fill(found, rig_.fibre.sliding_coordinate(edges_[i]), rig_.fibre.sliding_coordinate(edges_[i + 1]), {}, 0);
  return found;
}

// The cell with edges_[i] <= S < edges_[i + 1].
std::size_t SlidingTable::cell_of(double S) {
  while (edges_.back() <= S)
    edges_.push_back(end_of_stretch(friction_, rig_.fibre, edges_.back(), 2 * longest_sliding, 1));
  return static_cast<std::size_t>(std::upper_bound(edges_.begin(), edges_.end(), S) - edges_.begin()) - 1;
}

const SlidingTable::Piece& SlidingTable::piece_at(const Cell& cell, double sigma) {
  return *std::find_if(cell.begin(), std::prev(cell.end()), [&](const Piece& piece) { return sigma <= piece.to; });
}

SlidingWork SlidingTable::up_to(const Cell& cell, double sigma) {
  const Piece& piece = piece_at(cell, sigma);
  const double t = std::clamp((2 * sigma - piece.from - piece.to) / (piece.to - piece.from), -1.0, 1.0);
  return {piece.before.stage + series_at(piece.stage, t), piece.before.friction + series_at(piece.friction, t)};
}

SlidingWork SlidingTable::work(double S_from, double S_to) {
  if (!(S_from >= 1 && S_to >= 1 && S_from <= longest_sliding && S_to <= longest_sliding))
    throw std::invalid_argument("no fibre slides from S = " + std::to_string(S_from) + " to " + std::to_string(S_to));
  if (S_to < S_from) {
    const SlidingWork back = work(S_to, S_from);
    return {-back.stage, -back.friction};
  }
  const std::size_t last = cell_of(S_to);
  const std::size_t first = cell_of(S_from);
  const SlidingWork start = up_to(cell(first), rig_.fibre.sliding_coordinate(S_from));
  SlidingWork sum{-start.stage, -start.friction};
  for (std::size_t i = first; i < last; ++i) sum += up_to(cell(i), rig_.fibre.sliding_coordinate(edges_[i + 1]));
  sum += up_to(cell(last), rig_.fibre.sliding_coordinate(S_to));
  return sum;
}

SlidingLadder::SlidingLadder(double S_max, double S_step, const Fibre& fibre) : fibre_(fibre) {
  if (!(S_max > 1 && S_max <= longest_ladder))
    throw std::invalid_argument("S_max must lie in (1, 2.1], not " + std::to_string(S_max));
  if (!(S_step > 0)) throw std::invalid_argument("S_step must be positive, not " + std::to_string(S_step));
  const double sigma_max = fibre.sliding_coordinate(S_max),
               // treats the specimen as slid by this much before
      from = fibre.sliding_coordinate(1);
  const auto n = static_cast<std::size_t>(std::ceil(2 * sigma_max * sigma_max / S_step)) + 2;
  const double sigma_step = (sigma_max + from) / static_cast<double>(n - 1);
  const double straight = fibre.slides_inward_only() ? 0 : fibre.state(1, 0).w;
  S_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double sigma = sigma_step * static_cast<double>(i) - from;
    S_[i] = sigma >= from ? fibre.length_at(sigma) : 1;
    if (sigma < from) shallow_.push_back(straight * (sigma + from) / (2 * from));
  }
}

StateArrays SlidingLadder::curve(std::span<const double> mu) const {
  std::vector<double> q(mu.begin(), mu.end());
  for (double& value : q) value = std::clamp(value, 0.0, table_q.greatest);
  StateArrays states = fibre_.tabulated_states({S_, q});
  // The surface slides out up to 1.2 half depths of deflection, sticks, and slides in from 1.35.
  // q/μ varies linearly in between, with an error of some hundredths.
  std::vector<double> held;
  for (std::size_t i = 0; i < shallow_.size(); ++i)
    held.push_back(mu[i] * std::clamp((shallow_[i] / fibre_.supports().half_depth - 1.27) / 0.08, -1.0, 1.0));
  const std::vector<double> forces = fibre_.forces_at_deflections(shallow_, held);
  std::copy(shallow_.begin(), shallow_.end(), states.w.begin());
  std::copy(forces.begin(), forces.end(), states.F.begin());
  return states;
}

namespace {

// The cubic over one cell, with slopes from central differences.
Cubic cubic_over(std::span<const double> y, std::size_t i) {
  const double rise = y[i + 1] - y[i];
  return {y[i], y[i + 1], i > 0 ? 0.5 * (y[i + 1] - y[i - 1]) : rise,
          i + 2 < y.size() ? 0.5 * (y[i + 2] - y[i]) : rise};
}

// The maximum in [0, 1].
double peak_of(const Cubic& cubic) {
  if (cubic.slope <= 0) return 0;
  if (cubic.at(1).slope >= 0) return 1;
  // the slope changes sign once from + to -
  const double root = std::sqrt(std::max(cubic.c2 * cubic.c2 - 3 * cubic.slope * cubic.c3, 0.0));
  return std::clamp(cubic.slope / (root - cubic.c2), 0.0, 1.0);
}

}  // namespace

std::vector<double> measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                                   std::span<const double> stages) {
  const auto n = w.size();
  std::vector<double> G(n);
  for (std::size_t i = 0; i < n; ++i) G[i] = w[i] + compliance * F[i];
  std::vector<double> result;
  result.reserve(stages.size());
  std::size_t cell = 0;
  double passed = 0;  // fraction of the cell below the running maximum
  for (const double stage : stages) {
    double x = 1;
    for (; cell + 1 < n; ++cell, passed = 0) {
      // If both ends of a cell are below the stage position, G reaches it only at a maximum between
      // them.
      const bool short_of = G[cell + 1] < stage && G[cell] < stage;
      const bool turns_here = G[cell + 1] < G[cell] && (cell == 0 || G[cell - 1] < G[cell]);
      const bool turns_next = cell + 2 < n && G[cell] < G[cell + 1] && G[cell + 2] < G[cell + 1];
      if (short_of && !turns_here && !turns_next) continue;
      const Cubic cubic = cubic_over(G, cell);
      const double peak = peak_of(cubic), maximum = cubic.at(peak).value;
      if (maximum < stage || peak < passed) continue;
      // G rises from `passed` to the peak.
      constexpr double step = 1e-6;  // of a cell: below the error of interpolation
      const auto miss = [&](double at) {
        const auto [value, slope] = cubic.at(at);
        return ValueAndSlope{value - stage, slope};
      };
      const double chord = (stage - cubic.value) / (maximum - cubic.value) * peak;
      x = zero_between(miss, passed, peak, std::clamp(chord, passed, peak), step);
      passed = x;
      break;
    }
    result.push_back(cubic_over(F, std::min(cell, n - 2)).at(x).value);
  }
  return result;
}

}  // namespace flexslip
