#include "bending_test/sliding_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "bending_test/curve_samples.h"
#include "bending_test/interpolant.h"
#include "bending_test/polynomial.h"
#include "contact/over_rollers.h"

namespace flexslip {
SlidingTable::SlidingTable(const Friction& friction, const Rig& rig, Sliding sliding)
    : friction_(met(friction, rig.fibre, direction_of(sliding), longest_sliding)),
      rig_(rig),
      direction_(direction_of(sliding)) {}

SlidingTable::Sample SlidingTable::sample_at(double sigma) const {
  const Fibre& fibre = rig_.fibre;
  const double S = fibre.length_at(sigma);
  if (S == 1 && fibre.begins_straight()) return {0, {0, 0}, 0};
  const double rounded = fibre.way(S);  // what follows belongs to it; w, F and Pn start in proportion to it
  const double c = 1 / rig_.stiffness;
  const auto mu = friction_.at(S);
  const auto [state, slopes] = fibre.state_slopes(S, direction_ * mu.mu);
  if (state.status != FibreStatus::ok) return {0, {0, 0}, 0};
  const double G_S = slopes.w_S + c * slopes.F_S + direction_ * (slopes.w_q + c * slopes.F_q) * mu.slope;
  const double corrected = sigma / rounded;
  // The slopes err by their own accuracy, and friction and its slope by the rounding of the length where they vary fast.
  const double per_period = 0x1p-50 / friction_.smooth_scale() * std::abs(mu.slope);
  const double slope_error = 4e-14 * (state.w + c * state.F) * (std::abs(mu.slope) + 1 / (rounded * rounded)) +
                             per_period * (slopes.w_q + c * slopes.F_q);
  const double friction_error = 0x1p-50 * std::abs(mu.slope) * state.Pn;
  const double G = (state.w + c * state.F) * corrected;
  const double leaves = 1 - 2 * fibre.supports().radius * (slopes.theta0_S + direction_ * slopes.theta0_q * mu.slope);
  const double friction = direction_ * mu.mu * state.Pn + fibre.lost_bending(state) * leaves;
  const double table_error = fibre.on_edges() ? 0 : tabulated_error * state.F * std::abs(G_S);
  return {G,
          {state.F * G_S * 2 * sigma, friction * 2 * sigma * corrected},
          std::max({slope_error * state.F, friction_error, table_error}) * 2 * sigma};
}

void SlidingTable::fill(Cell& cell, double from, double to, double scale, int halvings) const {
  Series G{};
  Series stage{};
  Series friction{};
  double noise = 0;
  for (std::size_t j = 0; j <= degree; ++j) {
    const Sample sample = sample_at(0.5 * (from + to) + 0.5 * (to - from) * Interpolant<degree>::node(j));
    G[j] = sample.G;
    stage[j] = sample.power.stage;
    friction[j] = sample.power.friction;
    noise = std::max(noise, sample.noise);
  }
  const auto greatest = [](const Series& values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
  };
  scale = std::max({scale, greatest(stage), greatest(friction)});
  stage = Interpolant<degree>::chebyshev(stage);
  friction = Interpolant<degree>::chebyshev(friction);
  constexpr double accuracy = 1e-12;        // what the integral loses is a tenth of that, and less
  constexpr int most_halvings = 30;         // at a kink: a piece 1e-9 of the whole
  constexpr std::size_t most_pieces = 200;  // enough for a few kinks
  const auto is_resolved = [&](const Series& c) {
    return std::abs(c[degree]) + std::abs(c[degree - 1]) <= accuracy * scale + noise;
  };
  if (halvings < most_halvings && cell.size() < most_pieces && !(is_resolved(stage) && is_resolved(friction))) {
    const double middle = 0.5 * (from + to);
    fill(cell, from, middle, scale, halvings + 1);
    fill(cell, middle, to, scale, halvings + 1);
    return;
  }
  const SlidingWork before = cell.empty() ? SlidingWork{0, 0} : up_to(cell, cell.back().to);
  const double reach = 0.5 * (to - from);
  cell.push_back(
      {from, to, Interpolant<degree>::chebyshev(G), integrated(stage, reach), integrated(friction, reach), before});
}

const SlidingTable::Cell& SlidingTable::cell(std::size_t i) {
  Cell& found = cells_[i];
  if (found.empty()) fill(found, rig_.fibre.way(edges_[i]), rig_.fibre.way(edges_[i + 1]), 0, 0);
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
  const SlidingWork start = up_to(cell(first), rig_.fibre.way(S_from));
  SlidingWork sum{-start.stage, -start.friction};
  for (std::size_t i = first; i < last; ++i) sum += up_to(cell(i), rig_.fibre.way(edges_[i + 1]));
  sum += up_to(cell(last), rig_.fibre.way(S_to));
  return sum;
}

double SlidingTable::length_at_stage(double stage, double S_from, double S_to) {
  const auto place_on = [](const Piece& piece, double sigma) {
    return (2 * sigma - piece.from - piece.to) / (piece.to - piece.from);
  };
  const bool onwards = S_to > S_from;
  const std::size_t last = cell_of(S_to);
  std::size_t i = cell_of(S_from);
  const auto lies_beyond = [&](double edge) {
    const double sigma = rig_.fibre.way(edge);
    const Piece& piece = piece_at(cell(i), sigma);
    return (series_at(piece.G, place_on(piece, sigma)) < stage) == onwards;
  };
  while (i != last && lies_beyond(edges_[onwards ? i + 1 : i])) i = onwards ? i + 1 : i - 1;
  double low = rig_.fibre.way(std::max(edges_[i], std::min(S_from, S_to)));
  double high = rig_.fibre.way(std::min(edges_[i + 1], std::max(S_from, S_to)));
  const Cell& here = cell(i);
  const auto miss = [&](double sigma) {
    const Piece& piece = piece_at(here, sigma);
    const auto [G, slope] = series_slope_at(piece.G, place_on(piece, sigma));
    return ValueAndSlope{G - stage, 2 * slope / (piece.to - piece.from)};
  };
  const double close = 1e-11 * (high - low);
  const double sigma = zero_between(miss, low, high, 0.5 * (low + high), true, close);
  return rig_.fibre.length_at(sigma);
}

}  // namespace flexslip
