#include "fibre/fibre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <mutex>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "fibre/cell_table.h"
#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "fibre/state_table.h"

namespace flexslip {
namespace {

FibreState nothing_at(double S, double q) {
  constexpr double n = not_a_number;
  return {.status = FibreStatus::beyond_branch, .S = S, .q = q, .w = n, .F = n, .theta0 = n, .Pn = n, .U = n, .u = n};
}

// The least length that a friction of zero lets slide back to, to first order.
double least_length_on(const Supports& supports) { return 1 - 3.75 * supports.half_depth * supports.half_depth; }

// A pair of quantities with their slopes along w and in q: first, second, first_w, first_q, second_w, second_q; of one state (no memory of the heap), of many.
using PairSlope = std::array<double, 6>;
struct PairSlopes {
  std::array<std::vector<double>, 6> columns;
  explicit PairSlopes(std::size_t n) {
    for (auto& column : columns) column.resize(n);
  }
  std::array<double*, 6> data() {
    std::array<double*, 6> to{};
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = columns[k].data();
    return to;
  }
};

}  // namespace

// S - 1 with F, θ0 with Pn, and U with the curvature, over deflection and friction; and w with F over length and friction, where the two lengths of
// a friction that are alike are far enough away for polynomials.
class Fibre::Tables {
 public:
  explicit Tables(const Supports& on)
      : supports(on),
        sliding_(CellTable::Along::coordinate, axes(), source(&SupportedState::slid, &SupportedState::F)),
        contacts_(CellTable::Along::coordinate, axes(), source(&SupportedState::theta0, &SupportedState::Pn)),
        bent_(CellTable::Along::coordinate, axes(), source(&SupportedState::U, &SupportedState::curvature)),
        by_length_(CellTable::Along::length, {1.05, 44, table_q.least, table_q.greatest, 48},
                   [this](std::span<const double> x, std::span<const double> q) { return pair_by_length(x, q); }) {}

  // [√L] From which way on (Fibre::way) by_length has states, where it has them at all: nearer, the least length of each friction disturbs.
  double smooth_from() const { return supports.half_depth > 0 ? 0.12 + supports.half_depth : 0; }
  // What it has is the state less that of the least length, to first order.
  double least_w() const { return 1.25 * supports.half_depth; }
  double least_F() const { return 48 * least_w(); }
  const CellTable& by_length() const { return by_length_; }

  // Those of supports met not long ago are shared.
  static std::shared_ptr<const Tables> of(const Supports& supports) {
    static std::mutex looking;
    static std::deque<std::shared_ptr<const Tables>> known;
    constexpr std::size_t most = 16;
    const std::scoped_lock lock(looking);
    for (const auto& tables : known)
      if (tables->supports.radius == supports.radius && tables->supports.half_depth == supports.half_depth)
        return tables;
    known.push_front(std::make_shared<const Tables>(supports));
    if (known.size() > most) known.pop_back();
    return known.front();
  }

  PairSlopes sliding(std::span<const double> w, std::span<const double> q) const {
    return slopes(sliding_, &SupportedState::slid, &SupportedState::F, w, q);
  }
  PairSlopes contacts(std::span<const double> w, std::span<const double> q) const {
    return slopes(contacts_, &SupportedState::theta0, &SupportedState::Pn, w, q);
  }
  PairSlope sliding(double w, double q) const {
    return slopes(sliding_, &SupportedState::slid, &SupportedState::F, w, q);
  }
  PairSlope contacts(double w, double q) const {
    return slopes(contacts_, &SupportedState::theta0, &SupportedState::Pn, w, q);
  }

  double energy(double w, double q) const {
    double U = 0, curvature = 0;
    bent_.values(&w, &q, 1, &U, &curvature);
    return std::isnan(U) ? state(w, q).U : U;
  }

  // Deflections of lengths: by Newton's iteration; the length is convex in the deflection.
  std::vector<double> deflections(std::span<const double> S, std::span<const double> q) const {
    std::vector<double> w(S.size());
    std::transform(S.begin(), S.end(), w.begin(), [&](double length) { return shallow_deflection(length); });
    std::vector<std::size_t> active(S.size());
    std::iota(active.begin(), active.end(), 0);
    for (int round = 0; round < most_rounds && !active.empty(); ++round) {
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
  double deflection(double S, double q) const {
    double w = shallow_deflection(S);
    for (int round = 0; round < most_rounds; ++round) {
      const PairSlope at = sliding(w, q);
      const Step step = step_from(w, S, q, at[0], at[2]);
      if (step.is_last) return step.w;
      w = step.w;
    }
    return beyond(S, q);
  }

  const Supports supports;

 private:
  using Field = double SupportedState::*;
  static constexpr int most_rounds = 40;  // of Newton's iteration

  double shallow_deflection(double S) const {
    const double tau = supports.half_depth;
    return 1.25 * tau + std::sqrt(std::max((S - 1) / 2.4 + 1.5625 * tau * tau, 0.0));
  }

  struct Step {
    double w;
    bool is_last;
  };
  // From a deflection whose length has this much beyond the span, and this slope.
  Step step_from(double w, double S, double q, double slid, double slid_w) const {
    const double step = (S - 1 - slid) / slid_w;
    constexpr double small = 1e-8;  // of the deflection: what is left is its square
    if (!std::isfinite(step) || !(slid_w > 0)) return {beyond(S, q), true};
    const double next = std::clamp(w + step, 0.5 * w, 2 * w);
    if (!(next < deepest_on_supports)) return {not_a_number, true};
    return {next, std::abs(step) <= small * next};
  }

  static CellTable::Axes axes() { return {deepest_on_supports, 60, table_q.least, table_q.greatest, 48}; }

  SupportedState state(double w, double q) const {
    if (w > 0 && w <= deepest_on_supports && std::abs(q) <= largest_q) {
      const SupportedState led = state_led_on(w, q, supports);
      // Leading on may lose a state that is there, of a fibre much bent.
      return led.status == FibreStatus::ok ? led : state_on_supports(w, q, supports);
    }
    SupportedState none{};
    none.status = FibreStatus::beyond_branch;
    return none;
  }

  CellTable::Source source(Field first, Field second) const {
    return [this, first, second](std::span<const double> w, std::span<const double> q) {
      CellTable::Pair pair;
      for (std::size_t i = 0; i < w.size(); ++i) {
        const SupportedState at = state(w[i], q[i]);
        const bool exists = at.status == FibreStatus::ok;
        pair.first.push_back(exists ? at.*first / w[i] : not_a_number);
        pair.second.push_back(exists ? at.*second / w[i] : not_a_number);
      }
      return pair;
    };
  }

  PairSlopes slopes(const CellTable& table, Field first, Field second, std::span<const double> w,
                    std::span<const double> q) const {
    PairSlopes at(w.size());
    fill_slopes(table, first, second, w, q, at.data());
    return at;
  }
  PairSlope slopes(const CellTable& table, Field first, Field second, double w, double q) const {
    PairSlope at{};
    fill_slopes(table, first, second, {&w, 1}, {&q, 1}, {&at[0], &at[1], &at[2], &at[3], &at[4], &at[5]});
    return at;
  }
  // Where a table has nothing, from states nearby.
  void fill_slopes(const CellTable& table, Field first, Field second, std::span<const double> w,
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

  // By bisection, where Newton's iteration leads nowhere: close to the end of the branch.
  double beyond(double S, double q) const {
    double low = 1.25 * supports.half_depth, high = low + 1.1 * std::sqrt(std::max(S - 1, 0.0) / 2.4) + 1e-9;
    const auto slid = [&](double w) {
      const SupportedState at = state(w, q);
      return at.status == FibreStatus::ok ? at.slid : not_a_number;
    };
    while (slid(high) < S - 1 && high < deepest_on_supports) high *= 1.1;
    for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
      (slid(middle) < S - 1 ? low : high) = middle;
    const double reached = slid(low);
    constexpr double close = 1e-10;  // of the length
    return std::abs(reached - (S - 1)) <= close ? low : not_a_number;
  }

  CellTable::Pair pair_by_length(std::span<const double> x, std::span<const double> q) const {
    std::vector<double> S;
    for (const double way : x) S.push_back(least_length_on(supports) + way * way);
    CellTable::Pair pair{deflections(S, q), {}};
    const PairSlopes at = sliding(pair.first, q);
    for (std::size_t i = 0; i < x.size(); ++i) {
      pair.first[i] = (pair.first[i] - least_w()) / x[i];
      pair.second.push_back((at.columns[1][i] - least_F()) / x[i]);
    }
    return pair;
  }

  CellTable sliding_, contacts_, bent_, by_length_;
};

Fibre::Fibre(const Supports& supports) {
  static_cast<void>(state_on_supports(0.01, 0, supports));  // refuses what leaves no span
  if (supports.radius > 0 || supports.half_depth > 0) tables_ = Tables::of(supports);
  least_length_ = least_length_on(supports);
}

const Supports& Fibre::supports() const {
  static constexpr Supports edges{0, 0};
  return tables_ ? tables_->supports : edges;
}

Fibre::BentState Fibre::bent(double w, double q) const {
  const PairSlope slid = tables_->sliding(w, q), turned = tables_->contacts(w, q);
  BentState at{};
  if (w == 0) {
    at.state = fibre_state(1, 0);
    at.S_w = -6 * supports().half_depth;
    at.F_w = 48 / (1 + 3 * q * supports().half_depth);
    at.theta0_w = 3;
    at.Pn_w = 0.5 * at.F_w;
    return at;
  }
  if (!(slid[1] >= 0)) {
    at.state = nothing_at(not_a_number, q);
    return at;
  }
  at.state = {.status = FibreStatus::ok,
              .S = 1 + slid[0],
              .q = q,
              .w = w,
              .F = slid[1],
              .theta0 = turned[0],
              .Pn = turned[1],
              .U = tables_->energy(w, q),
              .u = 0};
  at.S_w = slid[2], at.S_q = slid[3], at.F_w = slid[4], at.F_q = slid[5];
  at.theta0_w = turned[2], at.theta0_q = turned[3], at.Pn_w = turned[4], at.Pn_q = turned[5];
  return at;
}

FibreState Fibre::state(double S, double q) const { return on_edges() ? fibre_state(S, q) : state_slopes(S, q).state; }

FibreStateSlopes Fibre::state_slopes(double S, double q) const {
  if (on_edges()) return fibre_state_slopes(S, q);
  FibreStateSlopes result{};
  if (S == 1 && supports().half_depth == 0) {
    result.state = fibre_state(1, q);
    return result;
  }
  const double w = tables_->deflection(S, q);
  result.state = nothing_at(S, q);
  if (std::isnan(w)) return result;
  const BentState at = bent(w, q);
  if (at.state.status != FibreStatus::ok) return result;
  result.state = at.state;
  result.state.S = S;
  auto& d = result.slopes;
  d.w_S = 1 / at.S_w;
  d.w_q = -at.S_q / at.S_w;
  d.F_S = at.F_w * d.w_S;
  d.F_q = at.F_q + at.F_w * d.w_q;
  d.theta0_S = at.theta0_w * d.w_S;
  d.theta0_q = at.theta0_q + at.theta0_w * d.w_q;
  const FibreState& s = at.state;
  d.Pn_S = at.Pn_w * d.w_S;
  d.Pn_q = at.Pn_q + at.Pn_w * d.w_q;
  // dU = F dw - (q Pn dS + what is lost of the axis that leaves)
  const double r2 = 2 * supports().radius, lost = lost_bending(s);
  d.U_S = s.F * d.w_S - q * s.Pn - lost * (1 - r2 * d.theta0_S);
  d.U_q = s.F * d.w_q + lost * r2 * d.theta0_q;
  return result;
}

Fibre::Contact Fibre::contact(double S, double q) const {
  if (on_edges()) return {S, 1, 0};
  const double w = tables_->deflection(S, q);
  const PairSlopes sliding = tables_->sliding({&w, 1}, {&q, 1}), contacts = tables_->contacts({&w, 1}, {&q, 1});
  const double rolled = 2 * supports().radius, S_w = sliding.columns[2][0], S_q = sliding.columns[3][0];
  const double theta0 = contacts.columns[0][0], theta0_w = contacts.columns[2][0], theta0_q = contacts.columns[3][0];
  return {S - rolled * theta0, 1 - rolled * theta0_w / S_w, -rolled * (theta0_q - theta0_w * S_q / S_w)};
}

// Lengths as the table by length takes them: 1 for the least.
std::vector<double> Fibre::from_the_least(const FibrePoints& points) const {
  std::vector<double> lengths(points.lengths(), points.lengths() + points.size());
  for (double& S : lengths) S = S - least_length_ + 1;
  return lengths;
}

// Adds the state of the least length to what the table by length gave, and fills in what it has not.
template <std::size_t n_columns>
void Fibre::complete(const FibrePoints& points, const std::array<double*, n_columns>& columns) const {
  const auto& [w, F] = std::array{columns[0], columns[1]};
  std::vector<std::size_t> others;
  std::vector<double> S, q;
  const double smooth_from = least_length_ + tables_->smooth_from() * tables_->smooth_from();
  for (std::size_t i = 0; i < points.size(); ++i) {
    w[i] += tables_->least_w();
    F[i] += tables_->least_F();
    if (points.lengths()[i] >= smooth_from && F[i] >= 0) continue;
    others.push_back(i);
    S.push_back(points.lengths()[i]);
    q.push_back(points.frictions()[i]);
  }
  if (others.empty()) return;
  SlopeArrays by_deflection = slopes_by_deflection(S, q);
  const auto from = by_deflection.columns();
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t j = 0; j < others.size(); ++j) columns[k][others[j]] = from[k][j];
}

StateArrays Fibre::states_by_length(const FibrePoints& points) const {
  const std::vector<double> lengths = from_the_least(points);
  StateArrays result(lengths.size());
  tables_->by_length().values(lengths.data(), points.frictions(), lengths.size(), result.w.data(), result.F.data());
  complete(points, std::array{result.w.data(), result.F.data()});
  return result;
}

SlopeArrays Fibre::slopes_by_length(const FibrePoints& points) const {
  const std::vector<double> lengths = from_the_least(points);
  SlopeArrays result(lengths.size());
  tables_->by_length().slopes(lengths.data(), points.frictions(), lengths.size(), result.columns());
  complete(points, result.columns());
  return result;
}

SlopeArrays Fibre::slopes_by_deflection(std::span<const double> S, std::span<const double> q) const {
  const std::size_t n = S.size();
  const std::vector<double> w = tables_->deflections(S, q);
  const PairSlopes at = tables_->sliding(w, q);
  SlopeArrays result(n);
  const bool has_straight = supports().half_depth == 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (has_straight && S[i] == 1) {
      result.w[i] = result.F[i] = 0;
      result.w_S[i] = result.w_q[i] = result.F_S[i] = result.F_q[i] = not_a_number;
      continue;
    }
    const double S_w = at.columns[2][i];
    const bool exists = !std::isnan(w[i]) && at.columns[1][i] >= 0;
    if (!exists) {
      for (double* column : result.columns()) column[i] = not_a_number;
      continue;
    }
    result.w[i] = w[i];
    result.F[i] = at.columns[1][i];
    result.w_S[i] = 1 / S_w;
    result.w_q[i] = -at.columns[3][i] / S_w;
    result.F_S[i] = at.columns[4][i] / S_w;
    result.F_q[i] = at.columns[5][i] + at.columns[4][i] * result.w_q[i];
  }
  return result;
}

namespace {

StateArrays without_slopes(SlopeArrays at) {
  StateArrays states(0);
  states.w = std::move(at.w);
  states.F = std::move(at.F);
  return states;
}

}  // namespace

StateArrays Fibre::tabulated_states(const FibrePoints& points) const {
  return on_edges() ? flexslip::tabulated_states(points) : states_by_length(points);
}

SlopeArrays Fibre::tabulated_states_slopes(const FibrePoints& points) const {
  return on_edges() ? flexslip::tabulated_states_slopes(points) : slopes_by_length(points);
}

StateArrays Fibre::states(const FibrePoints& points) const {
  return on_edges() ? fibre_states(points) : without_slopes(states_slopes(points));
}

SlopeArrays Fibre::states_slopes(const FibrePoints& points) const {
  if (on_edges()) return fibre_states_slopes(points);
  const std::size_t n = points.size();
  return slopes_by_deflection({points.lengths(), n}, {points.frictions(), n});
}

InverseArrays Fibre::tabulated_states_from_forces(std::span<const double> w, std::span<const double> F) const {
  return on_edges() ? flexslip::tabulated_states_from_forces(w, F) : states_from_forces(w, F);
}

InverseArrays Fibre::states_from_forces(std::span<const double> w, std::span<const double> F) const {
  if (on_edges()) return fibre_states_from_forces(w, F);
  const std::size_t n = w.size();
  InverseArrays found{std::vector<double>(n, not_a_number), std::vector<double>(n, not_a_number)};
  std::vector<double> q(n, 0.0);
  std::vector<std::size_t> active;
  const double least = least_half_depths * supports().half_depth;
  for (std::size_t i = 0; i < n; ++i)
    if (w[i] > 0 && w[i] >= least && w[i] <= deepest_on_supports) active.push_back(i);
  // The force rises with friction, nearly in proportion.
  for (int round = 0; round < 12 && !active.empty(); ++round) {
    std::vector<double> w_now, q_now;
    for (const std::size_t i : active) {
      w_now.push_back(w[i]);
      q_now.push_back(q[i]);
    }
    const PairSlopes at = tables_->sliding(w_now, q_now);
    std::size_t left = 0;
    for (std::size_t j = 0; j < active.size(); ++j) {
      const std::size_t i = active[j];
      const double step = (F[i] - at.columns[1][j]) / at.columns[5][j];
      constexpr double small = 1e-8;
      if (std::isfinite(step) && std::abs(step) <= small) {
        found.q[i] = q[i] + step;
        found.S[i] = 1 + at.columns[0][j] + at.columns[3][j] * step;
      } else if (std::isfinite(step)) {
        q[i] = std::clamp(q[i] + step, q[i] - 0.8, q[i] + 0.8);
        if (std::abs(q[i]) < largest_q) active[left++] = i;
      } else if (q[i] < largest_q_on_supports) {
        q[i] += 0.25;  // where the branch has ended more friction makes a force
        active[left++] = i;
      }
    }
    active.resize(left);
  }
  return found;
}

FibreState Fibre::state_from_force(double w, double F) const {
  if (on_edges()) return fibre_state_from_force(w, F);
  const InverseArrays found = states_from_forces({&w, 1}, {&F, 1});
  if (!std::isnan(found.q[0])) return bent(w, found.q[0]).state;
  FibreState none = nothing_at(1, 0);
  none.status = FibreStatus::no_friction;
  none.w = w;
  none.F = F;
  return none;
}

double Fibre::imaged_length(const FibreState& state) const {
  const double R = supports().radius + supports().half_depth;
  if (R == 0) return state.S;
  if (!(state.theta0 < 0.5 * std::numbers::pi)) return not_a_number;
  const auto [sine, cosine] = elementary::sine_and_cosine(state.theta0);
  return length_between_contacts(state) + 2 * R * sine / cosine;
}

double Fibre::curvature_at_midspan(const FibreState& state) const {
  if (on_edges()) return flexslip::curvature_at_midspan(state);
  return state.w > 0 ? state_on_supports(state.w, state.q, supports()).curvature : 0;
}

}  // namespace flexslip
