#include "fibre/fibre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "fibre/state_table.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

using PairSlope = SupportedTables::PairSlope;
using PairSlopes = SupportedTables::PairSlopes;

FibreState nothing_at(double S, double q) {
  constexpr double n = not_a_number;
  return {.status = FibreStatus::beyond_branch, .S = S, .q = q, .w = n, .F = n, .theta0 = n, .Pn = n, .U = n, .u = n};
}

}  // namespace

Fibre::Fibre(const Supports& supports) {
  static_cast<void>(state_on_supports(0.01, 0, supports));  // refuses what leaves no span
  if (supports.radius > 0 || supports.half_depth > 0) tables_ = SupportedTables::of(supports);
  least_length_ = SupportedTables::least_length(supports);
  if (tables_) smooth_from_ = tables_->smooth_from;
}

const Supports& Fibre::supports() const {
  static constexpr Supports edges{0, 0};
  return tables_ ? tables_->supports : edges;
}

Fibre::DeflectionState Fibre::at_deflection(double w, double q) const {
  return add_contacts(at_deflection_without_contacts(w, q));
}

Fibre::DeflectionState Fibre::add_contacts(DeflectionState at) const {
  if (at.state.w == 0 || at.state.status != FibreStatus::ok) return at;
  const PairSlope turned = tables_->contacts(at.state.w, at.state.q);
  at.state.theta0 = turned[0], at.state.Pn = turned[1];
  at.theta0_w = turned[2], at.theta0_q = turned[3], at.Pn_w = turned[4], at.Pn_q = turned[5];
  return at;
}

Fibre::DeflectionState Fibre::at_deflection_without_contacts(double w, double q) const {
  DeflectionState at{};
  if (w == 0) {
    at.state = fibre_state(1, 0);
    at.S_w = -6 * supports().half_depth;
    at.F_w = beam_stiffness / (1 + 3 * q * supports().half_depth);
    at.theta0_w = 3;
    at.Pn_w = 0.5 * at.F_w;
    return at;
  }
  const PairSlope slid = tables_->sliding(w, q);
  if (!(slid[1] >= 0)) {
    at.state = nothing_at(not_a_number, q);
    return at;
  }
  constexpr double n = not_a_number;
  at.state = {
      .status = FibreStatus::ok, .S = 1 + slid[0], .q = q, .w = w, .F = slid[1], .theta0 = n, .Pn = n, .U = n, .u = 0};
  at.slid = slid[0];
  at.S_w = slid[2], at.S_q = slid[3], at.F_w = slid[4], at.F_q = slid[5];
  at.theta0_w = at.theta0_q = at.Pn_w = at.Pn_q = n;
  return at;
}

void Fibre::DeflectionState::move_by(double dq) {
  state.q += dq;
  slid += S_q * dq;
  state.S = 1 + slid;
  state.F += F_q * dq;
  state.theta0 += theta0_q * dq;
  state.Pn += Pn_q * dq;
}

FibreState Fibre::state_at_deflection(double w, double q) const {
  FibreState state = at_deflection(w, q).state;
  if (w > 0 && state.status == FibreStatus::ok) state.U = tables_->bending(w, q).U;
  return state;
}

std::vector<double> Fibre::forces_at_deflections(std::span<const double> w, std::span<const double> q) const {
  if (w.empty()) return {};
  std::vector<double> forces = tables_->forces(w, q);
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (w[i] == 0)
      forces[i] = 0;
    else if (!(forces[i] >= 0))
      forces[i] = not_a_number;
  }
  return forces;
}

std::vector<double> Fibre::length_friction_derivatives(std::span<const double> w, std::span<const double> q) const {
  const PairSlopes slid = tables_->sliding(w, q);
  std::vector<double> by_friction = slid.columns[3];
  const double rolled = 2 * supports().radius;
  if (rolled > 0) {
    const PairSlopes contacts = tables_->contacts(w, q);
    for (std::size_t i = 0; i < w.size(); ++i) by_friction[i] -= rolled * contacts.columns[3][i];
  }
  for (std::size_t i = 0; i < w.size(); ++i)
    if (!(slid.columns[1][i] >= 0)) by_friction[i] = not_a_number;
  return by_friction;
}

FibreState Fibre::state(double S, double q) const { return on_edges() ? fibre_state(S, q) : state_slopes(S, q).state; }

FibreStateSlopes Fibre::state_slopes(double S, double q) const {
  return state_slopes(S, q, on_edges() || is_straight(S) ? 0 : tables_->deflection(S, q));
}

FibreStateSlopes Fibre::state_slopes(double S, double q, double w) const {
  if (on_edges()) return fibre_state_slopes(S, q);
  FibreStateSlopes result{};
  if (is_straight(S)) {
    result.state = fibre_state(1, q);
    return result;
  }
  result.state = nothing_at(S, q);
  if (std::isnan(w)) return result;
  const DeflectionState at = at_deflection(w, q);
  if (at.state.status != FibreStatus::ok) return result;
  result.state = at.state;
  result.state.S = S;
  result.state.U = tables_->bending(w, q).U;
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
  const double r2 = 2 * supports().radius, lost = bending_energy_lost_at_contact(s);
  d.U_S = s.F * d.w_S - q * s.Pn - lost * (1 - r2 * d.theta0_S);
  d.U_q = s.F * d.w_q + lost * r2 * d.theta0_q;
  return result;
}

Fibre::Contact Fibre::contact(double S, double q) const {
  if (on_edges()) return {S, 1, 0};
  const double w = tables_->deflection(S, q);
  const PairSlope sliding = tables_->sliding(w, q), contacts = tables_->contacts(w, q);
  const double rolled = 2 * supports().radius, S_w = sliding[2], S_q = sliding[3];
  const double theta0 = contacts[0], theta0_w = contacts[2], theta0_q = contacts[3];
  return {S - rolled * theta0, 1 - rolled * theta0_w / S_w, -rolled * (theta0_q - theta0_w * S_q / S_w)};
}

Fibre::ContactArrays Fibre::contacts(const FibrePoints& points) const {
  const std::size_t n = points.size();
  ContactArrays found{std::vector<double>(points.lengths(), points.lengths() + n), std::vector<double>(n, 1.0),
                      std::vector<double>(n, 0.0)};
  if (on_edges()) return found;
  SlopeArrays at = tabulated_states_slopes(points);
  std::vector<double> w = at.w;
  for (double& value : w)
    if (std::isnan(value)) value = 0;  // which says NaN by its slopes
  const PairSlopes turned = tables_->contacts(w, {points.frictions(), n});
  const auto& [theta0, Pn, theta0_w, theta0_q, Pn_w, Pn_q] = turned.columns;
  const double rolled = 2 * supports().radius;
  for (std::size_t i = 0; i < n; ++i) {
    found.length[i] -= rolled * theta0[i];
    found.length_S[i] -= rolled * theta0_w[i] * at.w_S[i];
    found.length_q[i] -= rolled * (theta0_q[i] + theta0_w[i] * at.w_q[i]);
  }
  return found;
}

// Lengths as the table by length takes them: 1 for the least.
std::vector<double> Fibre::relative_to_least_length(const FibrePoints& points) const {
  std::vector<double> lengths(points.lengths(), points.lengths() + points.size());
  for (double& S : lengths) S = S - least_length_ + 1;
  return lengths;
}

// Adds the state of the least length to what the table by length gave, and fills in what it has not, down to a force.
template <std::size_t n_columns>
void Fibre::complete(const FibrePoints& points, const std::array<double*, n_columns>& columns,
                     NearBranchEnd end) const {
  const auto& [w, F] = std::array{columns[0], columns[1]};
  std::vector<std::size_t> others;
  std::vector<double> S, q, guesses;
  for (std::size_t i = 0; i < points.size(); ++i) {
    w[i] += tables_->least_w();
    F[i] += tables_->least_F();
    if (points.lengths()[i] >= smooth_from_ && (F[i] >= 0 || end == NearBranchEnd::left_out)) continue;
    others.push_back(i);
    guesses.push_back(w[i]);
    S.push_back(points.lengths()[i]);
    q.push_back(points.frictions()[i]);
  }
  if (others.empty()) return;
  SlopeArrays by_deflection = slopes_by_deflection(S, q, tables_->deflections(S, q, std::move(guesses)));
  const auto from = by_deflection.columns();
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t j = 0; j < others.size(); ++j) columns[k][others[j]] = from[k][j];
}

StateArrays Fibre::states_by_length(const FibrePoints& points) const {
  const std::vector<double> lengths = relative_to_least_length(points);
  StateArrays result(lengths.size());
  tables_->by_length().values(lengths.data(), points.frictions(), lengths.size(), result.w.data(), result.F.data());
  complete(points, std::array{result.w.data(), result.F.data()}, NearBranchEnd::computed);
  return result;
}

SlopeArrays Fibre::slopes_by_length(const FibrePoints& points, NearBranchEnd end) const {
  const std::vector<double> lengths = relative_to_least_length(points);
  SlopeArrays result(lengths.size());
  tables_->by_length().slopes(lengths.data(), points.frictions(), lengths.size(), result.columns());
  complete(points, result.columns(), end);
  return result;
}

SlopeArrays Fibre::slopes_by_deflection(std::span<const double> S, std::span<const double> q,
                                        std::span<const double> w) const {
  const std::size_t n = S.size();
  const PairSlopes at = tables_->sliding(w, q);
  SlopeArrays result(n);
  const bool has_straight = slides_inward_only();
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
  return on_edges() ? flexslip::tabulated_states_slopes(points) : slopes_by_length(points, NearBranchEnd::computed);
}

Fibre::TabulatedSlopes Fibre::tabulated_state_slopes(double S, double q) const {
  if (on_edges()) {
    const auto [state, d] = fibre_state_slopes(S, q);
    return {state.w, state.F, d.w_S, d.w_q, d.F_S, d.F_q};
  }
  const FibrePoints point({&S, 1}, {&q, 1});
  TabulatedSlopes at{};
  const std::array columns{&at.w, &at.F, &at.w_S, &at.w_q, &at.F_S, &at.F_q};
  const double length = S - least_length_ + 1;
  tables_->by_length().slopes(&length, &q, 1, columns);
  complete(point, columns, NearBranchEnd::computed);
  return at;
}

SlopeArrays Fibre::states_slopes_before_branch_end(const FibrePoints& points) const {
  return on_edges() ? flexslip::tabulated_states_slopes(points) : slopes_by_length(points, NearBranchEnd::left_out);
}

StateArrays Fibre::states(const FibrePoints& points) const {
  return on_edges() ? fibre_states(points) : without_slopes(states_slopes(points));
}

SlopeArrays Fibre::states_slopes(const FibrePoints& points) const {
  if (on_edges()) return fibre_states_slopes(points);
  const std::span S(points.lengths(), points.size()), q(points.frictions(), points.size());
  return slopes_by_deflection(S, q, tables_->deflections(S, q));
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
  // The force rises with friction, nearly in proportion. Less than the least friction looked for is none; more than the largest is told, as what makes
  // a point suspect, up to the end of the tables: each state beyond would cost as much as hundreds.
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
        constexpr double longest = 0.8, least_q = -largest_q_on_supports;
        const double next = q[i] + std::clamp(step, -longest, longest);
        const bool is_less = q[i] == least_q && next < least_q;
        q[i] = std::max(next, least_q);
        if (!is_less && q[i] < table_q.greatest) active[left++] = i;
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
  if (!std::isnan(found.q[0])) return state_at_deflection(w, found.q[0]);
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
  return state.w > 0 ? tables_->bending(state.w, state.q).curvature : 0;
}

std::vector<double> Fibre::curvatures_at_midspan(const FibrePoints& points, std::span<const double> w) const {
  if (!on_edges()) return tables_->curvatures(w, {points.frictions(), points.size()});
  std::vector<double> curvatures;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FibreState state = fibre_state(points.lengths()[i], points.frictions()[i]);
    curvatures.push_back(state.status == FibreStatus::ok ? flexslip::curvature_at_midspan(state) : not_a_number);
  }
  return curvatures;
}

ContactPath::ContactPath(const Fibre& fibre, double q, double S_least, double S_most) : fibre_(fibre) {
  if (fibre.supports().radius == 0) return;
  constexpr int pieces = 128;
  first_ = fibre.sliding_coordinate(S_least);
  step_ = (fibre.sliding_coordinate(S_most) - first_) / pieces;
  for (int i = 0; i <= pieces; ++i) {
    const double sigma = first_ + step_ * i;
    const auto [length, length_S, length_q] = fibre.contact(fibre.length_at(sigma), q);
    if (!std::isfinite(length_S)) break;
    knots_.push_back({length, 2 * sigma * length_S});
    last_ = sigma;
  }
  if (knots_.size() < 2) knots_.clear();  // no states to follow the contacts along
  const auto grows = std::find_if(knots_.begin(), knots_.end(), [](const Value& knot) { return knot.slope > 0; });
  if (grows == knots_.begin()) return;
  const double growing = std::min(first_ + step_ * static_cast<double>(grows - knots_.begin()), last_);
  turn_at_ = first_where(growing - step_, growing, [&](double sigma) { return value(sigma).slope > 0; });
  turn_ = value(turn_at_).length;
}

// A cubic between two knots.
ContactPath::Value ContactPath::value(double sigma) const {
  const double place = std::clamp((sigma - first_) / step_, 0.0, static_cast<double>(knots_.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(place), knots_.size() - 2);
  const Value &a = knots_[i], &b = knots_[i + 1];
  const Cubic cubic(a.length, b.length, step_ * a.slope, step_ * b.slope);
  const auto [length, rise] = cubic.at(place - static_cast<double>(i));
  const double slope = rise / step_, beyond = sigma - std::clamp(sigma, first_, last_);
  return {length + slope * beyond, slope};
}

double ContactPath::at(double S) const {
  if (knots_.empty()) return S;
  const double sigma = fibre_.sliding_coordinate(S), length = value(sigma).length;
  return sigma < turn_at_ ? 2 * turn_ - length : length;
}

double ContactPath::slope(double S) const {
  if (knots_.empty()) return 1;
  const double sigma = fibre_.sliding_coordinate(S);
  return std::abs(value(sigma).slope) / (2 * sigma);
}

double ContactPath::sliding_length_at(double travel) const {
  if (knots_.empty()) return travel;
  const bool rolls_back = travel < turn_;
  const double length = length_at(travel);
  for (const double end : {first_, last_}) {
    const Value there = value(end);
    const double beyond = (length - there.length) / there.slope;
    if ((end < turn_at_) == rolls_back && (end == first_ ? beyond <= 0 : beyond >= 0))
      return fibre_.length_at(std::max(end + beyond, 0.0));
  }
  const double low = rolls_back ? first_ : std::max(turn_at_, first_), high = rolls_back ? turn_at_ : last_;
  const auto beyond = [&](double sigma) {
    const Value here = value(sigma);
    return ValueAndSlope{here.length - length, here.slope};
  };
  constexpr double small = 1e-13;
  const double sigma =
      zero_between(beyond, rolls_back ? high : low, rolls_back ? low : high, 0.5 * (low + high), small);
  return fibre_.length_at(sigma);
}

}  // namespace flexslip
