#include "fibre/state_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

#include "fibre/cell_table.h"
#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

const CellTable& table() {
  static const CellTable states(CellTable::Along::length, {table_sigma, 32, table_q.least, table_q.greatest, 48},
                                [](std::span<const double> sigma, std::span<const double> q) {
                                  std::vector<double> S;
                                  S.reserve(sigma.size());
                                  for (const double x : sigma) S.push_back(1 + x * x);
                                  StateArrays at = fibre_states({S, q});
                                  for (std::size_t i = 0; i < S.size(); ++i) {
                                    // the coordinate of the state
                                    const double rounded = std::sqrt(S[i] - 1);
                                    at.w[i] /= rounded;
                                    at.F[i] /= rounded;
                                  }
                                  return CellTable::Pair{std::move(at.w), std::move(at.F)};
                                });
  return states;
}

// Computes states that are not in the table.
struct AtRest {
  std::vector<std::size_t> index;
  std::vector<double> S, q;
  AtRest(const FibrePoints& points, const std::vector<double>& w) {
    for (std::size_t i = 0; i < w.size(); ++i) {
      if (!std::isnan(w[i])) continue;
      index.push_back(i);
      S.push_back(points.lengths()[i]);
      q.push_back(points.frictions()[i]);
    }
  }
};

}  // namespace

StateArrays tabulated_states(const FibrePoints& points) {
  StateArrays states(points.size());
  table().values(points.lengths(), points.frictions(), points.size(), states.w.data(), states.F.data());
  const AtRest rest(points, states.w);
  const StateArrays exact = fibre_states({rest.S, rest.q});
  for (std::size_t j = 0; j < rest.index.size(); ++j) {
    states.w[rest.index[j]] = exact.w[j];
    states.F[rest.index[j]] = exact.F[j];
  }
  return states;
}

SlopeArrays tabulated_states_slopes(const FibrePoints& points) {
  SlopeArrays states(points.size());
  const auto columns = states.columns();
  table().slopes(points.lengths(), points.frictions(), points.size(), columns);
  const AtRest rest(points, states.w);
  SlopeArrays exact = fibre_states_slopes({rest.S, rest.q});
  const auto from = exact.columns();
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t j = 0; j < rest.index.size(); ++j) columns[k][rest.index[j]] = from[k][j];
  return states;
}

namespace {

using PairSlope = SupportedTables::PairSlope;
using PairSlopes = SupportedTables::PairSlopes;

constexpr double max_sigma = 1.05;        // [√L] σ range of the table by length
constexpr std::size_t length_cells = 44;  // cells
constexpr int max_rounds = 40;            // of Newton's iteration

CellTable::Axes axes() { return {deepest_on_supports, 60, table_q.least, table_q.greatest, 48}; }

// At smaller lengths, the smallest length disturbs, because it depends on friction. It differs from
// the value at small deflection by δ of about 6 q τ³ (theory.md), so w contains a term 0.32 δ / σ.
// In a cell of half width h that ends at σ, polynomials of degree 7 have an error in 1/σ² of 18 (h
// / 2σ)^8 / σ².
double smooth_from_on(const Supports& supports) {
  if (supports.half_depth == 0) return 1;
  // h2: (h/2)^2
  constexpr double error = 1e-12, q = 2, h = 0.5 * max_sigma / length_cells, h2 = 0.25 * h * h;
  const double tau = supports.half_depth, least = 6 * q * tau * tau * tau;
  const double tenth_power = 18 * 0.32 * least * h2 * h2 * h2 * h2 / error;
  // start of the cell
  const double way = elementary::exp(0.1 * elementary::log(tenth_power)) + 2 * h;
  return SupportedTables::least_length(supports) + way * way;
}

}  // namespace

SupportedTables::PairSlopes::PairSlopes(std::size_t n) {
  for (auto& column : columns) column.resize(n);
}

std::array<double*, 6> SupportedTables::PairSlopes::data() {
  std::array<double*, 6> to{};
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = columns[k].data();
  return to;
}

SupportedTables::SupportedTables(const Supports& on)
    : supports(on),
      smooth_from(smooth_from_on(on)),
      sliding_(CellTable::Along::coordinate, axes(), source(&SupportedState::slid, &SupportedState::F)),
      contacts_(CellTable::Along::coordinate, axes(), source(&SupportedState::theta0, &SupportedState::Pn)),
      bent_(CellTable::Along::coordinate, axes(), source(&SupportedState::U, &SupportedState::curvature)),
      by_length_(CellTable::Along::length, {max_sigma, length_cells, table_q.least, table_q.greatest, 48},
                 [this](std::span<const double> x, std::span<const double> q) { return pair_by_length(x, q); }) {}

std::shared_ptr<const SupportedTables> SupportedTables::of(const Supports& supports) {
  static std::mutex looking;
  static std::deque<std::shared_ptr<const SupportedTables>> known;
  constexpr std::size_t max_tables = 16;
  const std::scoped_lock lock(looking);
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto& tables) {
    return tables->supports.radius == supports.radius && tables->supports.half_depth == supports.half_depth;
  });
  if (found != known.end()) {
    std::rotate(known.begin(), found, std::next(found));
  } else {
    known.push_front(std::make_shared<const SupportedTables>(supports));
    if (known.size() > max_tables) known.pop_back();
  }
  return known.front();
}

PairSlopes SupportedTables::sliding(std::span<const double> w, std::span<const double> q) const {
  return slopes(sliding_, &SupportedState::slid, &SupportedState::F, w, q);
}

PairSlopes SupportedTables::contacts(std::span<const double> w, std::span<const double> q) const {
  return slopes(contacts_, &SupportedState::theta0, &SupportedState::Pn, w, q);
}

PairSlope SupportedTables::sliding(double w, double q) const {
  return slopes(sliding_, &SupportedState::slid, &SupportedState::F, w, q);
}

PairSlope SupportedTables::contacts(double w, double q) const {
  return slopes(contacts_, &SupportedState::theta0, &SupportedState::Pn, w, q);
}

SupportedTables::Bending SupportedTables::bending(double w, double q) const {
  Bending at{};
  bent_.values(&w, &q, 1, &at.U, &at.curvature);
  if (!std::isnan(at.U)) return at;
  const SupportedState there = state(w, q);
  return {there.U, there.curvature};
}

std::vector<double> SupportedTables::curvatures(std::span<const double> w, std::span<const double> q) const {
  std::vector<double> U(w.size()), curvatures(w.size());
  bent_.values(w.data(), q.data(), w.size(), U.data(), curvatures.data());
  for (std::size_t i = 0; i < w.size(); ++i)
    if (std::isnan(curvatures[i])) curvatures[i] = state(w[i], q[i]).curvature;
  return curvatures;
}

std::vector<double> SupportedTables::forces(std::span<const double> w, std::span<const double> q) const {
  std::vector<double> slid(w.size()), F(w.size());
  sliding_.values(w.data(), q.data(), w.size(), slid.data(), F.data());
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (!std::isnan(F[i])) continue;
    const SupportedState at = state(w[i], q[i]);
    F[i] = at.status == FibreStatus::ok ? at.F : not_a_number;
  }
  return F;
}

std::vector<double> SupportedTables::deflections(std::span<const double> S, std::span<const double> q) const {
  std::vector<double> guesses;
  guesses.reserve(S.size());
  for (std::size_t i = 0; i < S.size(); ++i) guesses.push_back(guessed_deflection(S[i], q[i]));
  return deflections(S, q, std::move(guesses));
}

std::vector<double> SupportedTables::deflections(std::span<const double> S, std::span<const double> q,
                                                 std::vector<double> w) const {
  for (std::size_t i = 0; i < w.size(); ++i)
    if (!(w[i] > 0 && w[i] < deepest_on_supports)) w[i] = shallow_deflection(S[i]);
  std::vector<std::size_t> active(S.size());
  std::iota(active.begin(), active.end(), 0);
  for (int round = 0; round < max_rounds && !active.empty(); ++round) {
    std::vector<double> w_now, q_now;
    for (const std::size_t i : active) {
      w_now.push_back(w[i]);
      q_now.push_back(q[i]);
    }
    const PairSlopes at = sliding(w_now, q_now);
    std::size_t left = 0;
    for (std::size_t j = 0; j < active.size(); ++j) {
      const std::size_t i = active[j];
      const Step step = step_from(w[i], S[i], q[i], at.columns[0][j], at.columns[2][j]);
      w[i] = step.w;
      if (!step.is_last) active[left++] = i;
    }
    active.resize(left);
  }
  for (const std::size_t i : active) w[i] = beyond(S[i], q[i]);
  return w;
}

double SupportedTables::deflection(double S, double q) const {
  double w = guessed_deflection(S, q);
  for (int round = 0; round < max_rounds; ++round) {
    const PairSlope at = sliding(w, q);
    const Step step = step_from(w, S, q, at[0], at[2]);
    if (step.is_last) return step.w;
    w = step.w;
  }
  return beyond(S, q);
}

double SupportedTables::guessed_deflection(double S, double q) const {
  if (S >= smooth_from) {
    const double relative_to_least_length = S - least_length(supports) + 1;
    double w = 0, F = 0;
    by_length_.values(&relative_to_least_length, &q, 1, &w, &F);
    w += least_w();
    if (w > 0 && w < deepest_on_supports) return w;
  }
  return shallow_deflection(S);
}

double SupportedTables::shallow_deflection(double S) const {
  const double tau = supports.half_depth;
  return 1.25 * tau + std::sqrt(std::max((S - 1) / 2.4 + 1.5625 * tau * tau, 0.0));
}

// A step from a deflection whose length exceeds the span by `slid`, with this slope.
SupportedTables::Step SupportedTables::step_from(double w, double S, double q, double slid, double slid_w) const {
  const double step = (S - 1 - slid) / slid_w;
  constexpr double small = 1e-8;  // of the deflection; its square remains
  if (!std::isfinite(step) || !(slid_w > 0)) return {beyond(S, q), true};
  const double next = std::clamp(w + step, 0.5 * w, 2 * w);
  if (!(next < deepest_on_supports)) return {not_a_number, true};
  return {next, std::abs(step) <= small * next};
}

SupportedState SupportedTables::state(double w, double q) const {
  PhaseAndSpan from;
  return state(w, q, from);
}

SupportedState SupportedTables::state(double w, double q, PhaseAndSpan& from) const {
  // How far states are extrapolated beyond the end of the branch. The deflection at the end grows
  // by at most 5 L per unit of friction. A cell, an eighth wide in q, therefore has all its nodes.
  constexpr double led_beyond = 0.5;  // [L]
  if (!(w > 0 && w <= deepest_on_supports && std::abs(q) <= largest_q)) return no_state_on_supports(q);
  const double end = branch_end(q).w;
  if (w > end + led_beyond) return no_state_on_supports(q);
  const SupportedState led = extrapolated_state(w, q, supports, from);
  // Extrapolation may miss an existing state at large deflection.
  return led.status == FibreStatus::ok || w > end ? led : state_on_supports(w, q, supports);
}

CellTable::Source SupportedTables::source(Field first, Field second) const {
  return [this, first, second](std::span<const double> w, std::span<const double> q) {
    CellTable::Pair pair;
    const CellStates& states = cell_states(w, q);
    for (std::size_t i = 0; i < w.size(); ++i) {
      const SupportedState& at = states[i];
      const bool exists = at.status == FibreStatus::ok;
      pair.first.push_back(exists ? at.*first / w[i] : not_a_number);
      pair.second.push_back(exists ? at.*second / w[i] : not_a_number);
    }
    return pair;
  };
}

const SupportedTables::CellStates& SupportedTables::cell_states(std::span<const double> w,
                                                                std::span<const double> q) const {
  const std::scoped_lock lock(solving_);
  const std::pair corner{w[0], q[0]};
  if (const auto known = solved_.find(corner); known != solved_.end()) return known->second;
  CellStates states;  // stored once complete, because work may be interrupted (effort.h)
  // Each iteration starts from its neighbours' results, extrapolated linearly after division by √w.
  constexpr std::size_t row = CellTable::nodes_across;
  std::vector<PhaseAndSpan> ended(w.size());
  const auto expected = [&](std::size_t i) {
    const auto linear = [&](double PhaseAndSpan::*of) {
      const auto at = [&](std::size_t k) { return ended[k].*of / std::sqrt(w[k]); };
      const bool has_row = i >= row, has_column = i % row > 0;
      const double next = has_row && has_column ? at(i - row) + at(i - 1) - at(i - row - 1)
                          : has_row             ? at(i - row)
                          : has_column          ? at(i - 1)
                                                : 0;
      return std::sqrt(w[i]) * next;
    };
    return PhaseAndSpan{linear(&PhaseAndSpan::phase), linear(&PhaseAndSpan::half_span)};
  };
  for (std::size_t i = 0; i < w.size(); ++i) {
    ended[i] = expected(i);
    states.push_back(state(w[i], q[i], ended[i]));
  }
  return solved_.emplace(corner, std::move(states)).first->second;
}

PairSlopes SupportedTables::slopes(const CellTable& table, Field first, Field second, std::span<const double> w,
                                   std::span<const double> q) const {
  PairSlopes at(w.size());
  fill_slopes(table, first, second, w, q, at.data());
  return at;
}

PairSlope SupportedTables::slopes(const CellTable& table, Field first, Field second, double w, double q) const {
  PairSlope at{};
  fill_slopes(table, first, second, {&w, 1}, {&q, 1}, {&at[0], &at[1], &at[2], &at[3], &at[4], &at[5]});
  return at;
}

// Computes what is missing in a table, each from a nearby state.
void SupportedTables::fill_slopes(const CellTable& table, Field first, Field second, std::span<const double> w,
                                  std::span<const double> q, const std::array<double*, 6>& columns) const {
  table.slopes(w.data(), q.data(), w.size(), columns);
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (!std::isnan(columns[0][i])) continue;
    const SupportedState here = state(w[i], q[i]);
    if (here.status != FibreStatus::ok) continue;
    constexpr double near = 1e-5;
    const double dw = near * w[i], dq = near;
    const auto slope = [&](Field field, double along_w, double along_q) {
      const SupportedState ahead = state(w[i] + along_w, q[i] + along_q);
      const SupportedState behind = state(w[i] - along_w, q[i] - along_q);
      const bool has_ahead = ahead.status == FibreStatus::ok, has_behind = behind.status == FibreStatus::ok;
      const double h = along_w + along_q;
      if (has_ahead && has_behind) return (ahead.*field - behind.*field) / (2 * h);
      return has_ahead ? (ahead.*field - here.*field) / h : (here.*field - behind.*field) / h;
    };
    const std::array values{here.*first,         here.*second,         slope(first, dw, 0),
                            slope(first, 0, dq), slope(second, dw, 0), slope(second, 0, dq)};
    for (std::size_t k = 0; k < values.size(); ++k) columns[k][i] = values[k];
  }
}

// More friction makes the branch longer (tests/fibre/supported_tables_test.cpp). The known end at
// the next larger friction is therefore an upper bound, which saves searches for states that do not
// exist.
SupportedTables::BranchEnd SupportedTables::branch_end(double q) const {
  constexpr BranchEnd unknown{infinity, infinity};
  if (!(q < table_q.greatest)) return unknown;
  const double place = (q - table_q.least) / (table_q.greatest - table_q.least) * static_cast<double>(ends - 1);
  const auto index = static_cast<std::size_t>(std::max(std::ceil(place), 0.0));
  std::call_once(end_known_[index], [&] { ends_[index] = end_at(index); });
  return ends_[index];
}

SupportedTables::BranchEnd SupportedTables::end_at(std::size_t index) const {
  const double q =
      table_q.least + (table_q.greatest - table_q.least) * static_cast<double>(index) / static_cast<double>(ends - 1);
  const auto there = [&](double w) { return state_on_supports(w, q, supports); };
  if (there(deepest_on_supports).status == FibreStatus::ok) return {infinity, infinity};
  constexpr double close = 1e-6;  // [L] margin
  const auto [low, high] = halved_until([](const Bracket& w) { return !(w.width() > close); },
                                        {1.25 * supports.half_depth + 1e-3, deepest_on_supports},
                                        [&](double w) { return there(w).status != FibreStatus::ok; });
  // Near the end the length may grow without limit; this bounds its growth.
  const SupportedState last = there(low), before = there(low - close);
  return {high, last.slid + 4 * std::abs(last.slid - before.slid) + close};
}

// The deflection near the end of the branch if Newton's iteration fails: within a bracket whose
// upper end may have no state.
double SupportedTables::beyond(double S, double q) const {
  if (S - 1 > branch_end(q).slid) return not_a_number;
  constexpr double close = 1e-10, rounding = 1e-15;  // relative to the length
  const auto miss = [&](double w) {
    const SupportedState at = state(w, q);
    return at.status == FibreStatus::ok ? at.slid - (S - 1) : infinity;
  };
  const double least = supports.half_depth == 0 ? 1 - S : miss(least_w());
  Tried low{least_w(), std::isfinite(least) ? least : least_length(supports) - S};
  if (!(low.value < 0)) return std::abs(low.value) <= close ? low.x : not_a_number;
  Tried high{low.x + 1.1 * std::sqrt(std::max(S - 1, 0.0) / 2.4) + 1e-9, 0};
  Tried before = low;
  for (high.value = miss(high.x); high.value < 0; high.value = miss(high.x)) {
    before = std::exchange(low, high);
    high.x *= 1.1;
  }
  // Bisect to a state beyond the length. Near the end the length grows at most as a square root; if
  // four times this growth is too small, there is no state.
  while (std::isinf(high.value)) {
    const double middle = 0.5 * (low.x + high.x), left = std::sqrt(high.x - low.x);
    if (middle == low.x || middle == high.x) break;
    const double rise = low.value - before.value, whole = std::sqrt(high.x - before.x);
    if (rise > 0 && 4 * rise * left / (whole - left) + close < -low.value) return not_a_number;
    const Tried there{middle, miss(middle)};
    if (there.value < 0)
      before = std::exchange(low, there);
    else
      high = there;
  }
  const double w = zero_by_secant(miss, low, high, rounding * S);
  return std::abs(miss(w)) <= close ? w : not_a_number;
}

CellTable::Pair SupportedTables::pair_by_length(std::span<const double> x, std::span<const double> q) const {
  std::vector<double> S;
  for (const double way : x) S.push_back(least_length(supports) + way * way);
  const std::vector<double> unknown(S.size(), not_a_number);
  // Near the end of the branch states are expensive, so the farthest nodes of a cell come first. If
  // one is missing, the cell is empty.
  constexpr std::size_t row = CellTable::nodes_across;
  if (x.size() > row) {
    const std::vector<double> farthest =
        deflections(std::span(S).first(row), q.first(row), std::vector<double>(row, not_a_number));
    if (std::any_of(farthest.begin(), farthest.end(), [](double w) { return std::isnan(w); }))
      return {unknown, unknown};
  }
  CellTable::Pair pair{deflections(S, q, unknown), {}};
  const PairSlopes at = sliding(pair.first, q);
  for (std::size_t i = 0; i < x.size(); ++i) {
    pair.first[i] = (pair.first[i] - least_w()) / x[i];
    pair.second.push_back((at.columns[1][i] - least_F()) / x[i]);
  }
  return pair;
}

}  // namespace flexslip
