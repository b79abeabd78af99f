#include "inference/pass_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double min_deflection = 1e-4;  // [L] smaller ones are indistinguishable from the straight specimen
constexpr double min_excess = 1e-7;      // [L] of the length beyond 1

void append(VectorXd& column, const std::vector<double>& values) {
  const Index before = column.size();
  column.conservativeResize(before + index_of(values.size()));
  column.tail(index_of(values.size())) = Eigen::Map<const VectorXd>(values.data(), index_of(values.size()));
}

// The first row that slides after a turn, or `last`. Rows [first, last) belong to the pass after
// the turn.
std::size_t slides_from(const PassRows& rows, const PassStates& read, std::size_t first, std::size_t last,
                        double compliance, double force_noise) {
  const Index turn = index_of(first - 1);
  const double w_by_q = -read.S_q[turn] / read.S_w[turn];  // at constant length
  const double rate = 1 / (w_by_q + compliance * (read.F_q[turn] + read.F_w[turn] * w_by_q));
  std::vector<double> steps;
  for (std::size_t i = first + 1; i < last; ++i)
    steps.push_back(std::abs(rows.stage[index_of(i)] - rows.stage[index_of(i - 1)]));
  const double step = steps.empty() ? 0 : median_of(std::move(steps));
  // Enough rows m to determine the slope to an eighth of the rate; its standard error is σ/step
  // √(12/m³).
  const double noise = force_noise * std::abs((1 + compliance * read.F_w[turn]) / read.F_q[turn]);
  const double ratio = 8 * noise / (rate * step);
  const double needed = std::ceil(std::cbrt(12 * ratio * ratio));
  if (needed < static_cast<double>(last - first)) {
    const auto window = std::max<std::size_t>(4, static_cast<std::size_t>(needed));
    for (std::size_t i = first; i + window < last; ++i) {
      const auto stage = [&](std::size_t k) { return rows.stage[index_of(i + k)] - rows.stage[index_of(i)]; };
      const auto q = [&](std::size_t k) { return read.q[index_of(i + k)]; };
      const Line line = line_through(window + 1, stage, q);
      // The specimen may still stick for a third of the window, where the slope falls to a quarter.
      if (line.sum_xx > 0 && line.slope < 0.25 * rate) return i + window / 3 + 1;
    }
  }
  // If noise hides the slope, use the length.
  const double S_turn = read.S[turn], reach = 0.003 + 0.04 * std::max(S_turn - 1, 0.0);
  std::size_t away = 0;
  for (std::size_t i = first; i < last; ++i) {
    away = std::abs(read.S[index_of(i)] - S_turn) > reach ? away + 1 : 0;
    if (away == 3) return i - 2;
  }
  return last;
}

}  // namespace

void PassRows::add(const ReducedRecord& record, const std::vector<Leg>& legs, std::size_t leg,
                   const std::vector<std::size_t>& chosen) {
  std::vector<double> positions, deflections, forces;
  for (const std::size_t i : chosen) {
    row.push_back(i);
    pass.push_back(leg);
    side.push_back(legs[leg].direction == Direction::loading ? 1 : -1);
    positions.push_back(record.stage[i]);
    deflections.push_back(record.deflection[i]);
    forces.push_back(record.force[i]);
  }
  append(stage, positions);
  append(w, deflections);
  append(F, forces);
}

PassRows rows_of(const PassesProblem& problem, const std::vector<Leg>& legs) {
  const ReducedRecord& record = problem.record;
  const PassesOptions& options = problem.options;
  constexpr std::size_t enough = 1200;
  constexpr double deepest = 0.8;  // [L]
  const std::size_t step = (record.force.size() + enough - 1) / enough;
  std::vector<char> within(record.force.size(), 0);
  for (const Drop& drop : problem.drops)
    for (std::size_t i = drop.before + 1; i < drop.after; ++i) within[i] = 1;
  const double least_force = options.min_force * *std::max_element(record.force.begin(), record.force.end());
  PassRows rows;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = legs[leg].first; i < legs[leg].last; i += step)
      if (!within[i] && record.deflection[i] > options.min_deflection && record.deflection[i] < deepest &&
          record.force[i] > least_force)
        chosen.push_back(i);
    rows.add(record, legs, leg, chosen);
  }
  return rows;
}

PassRows rows_evaluated(const PassesProblem& problem, const std::vector<Leg>& legs) {
  PassRows rows;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = std::max(legs[leg].first, problem.first); i < std::min(legs[leg].last, problem.last); ++i)
      chosen.push_back(i);
    rows.add(problem.record, legs, leg, chosen);
  }
  return rows;
}

PassStates states_read(const VectorXd& w, const VectorXd& F, const Fibre& fibre) {
  const auto n = static_cast<std::size_t>(w.size());
  constexpr double any_friction = 4;  // [1] larger values result from noise or a wrong stiffness
  std::vector<double> deflection(n), force(n);
  for (std::size_t i = 0; i < n; ++i) {
    deflection[i] = std::max(w[index_of(i)], min_deflection);
    force[i] = std::max(F[index_of(i)], 0.0);
  }
  auto [S, q] = fibre.tabulated_states_from_forces(deflection, force);
  PassStates read;
  read.q = Eigen::Map<const VectorXd>(q.data(), w.size());
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(q[i]) < any_friction && S[i] > std::max(fibre.least_length(), 1.0) + min_excess) continue;
    read.q[index_of(i)] = not_a_number;
    S[i] = 1 + 2.4 * deflection[i] * deflection[i] + 0.01;  // a start
    q[i] = 0;
  }
  const SlopeArrays at = fibre.tabulated_states_slopes({S, q});
  for (VectorXd* column : {&read.S, &read.F_q, &read.F_w, &read.S_q, &read.S_w}) column->resize(w.size());
  for (std::size_t i = 0; i < n; ++i) {
    const Index k = index_of(i);
    read.S[k] = S[i];
    read.S_w[k] = 1 / at.w_S[i];
    read.S_q[k] = -at.w_q[i] / at.w_S[i];
    read.F_w[k] = at.F_S[i] / at.w_S[i];
    read.F_q[k] = at.F_q[i] - at.F_S[i] * at.w_q[i] / at.w_S[i];
    if (!(at.w_S[i] > 1e-9 && std::isfinite(read.F_q[k]))) read.q[k] = not_a_number;
  }
  return read;
}

PassForces forces_modelled(const VectorXd& w, const VectorXd& q, const PassStates& near, const Fibre& fibre) {
  const auto n = static_cast<std::size_t>(w.size());
  const double least = std::max(fibre.least_length(), 1.0) + min_excess;
  const std::vector<double> friction(q.data(), q.data() + q.size());
  std::vector<double> S(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index k = index_of(i);
    const double beside = near.is_read(k) ? near.S_q[k] * (q[k] - near.q[k]) : 0;
    S[i] = std::max(near.S[k] + beside, least);
  }
  PassForces modelled;
  for (VectorXd* column : {&modelled.F, &modelled.F_q, &modelled.F_w, &modelled.S_q, &modelled.S_w})
    column->resize(w.size());
  constexpr int iterations = 4;      // of Newton's method, from a tangent on
  constexpr double farthest = 0.05;  // [L] a step
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const SlopeArrays at = fibre.tabulated_states_slopes({S, friction});
    for (std::size_t i = 0; i < n; ++i) {
      const Index k = index_of(i);
      const double step = (w[k] - at.w[i]) / at.w_S[i];
      modelled.F[k] = at.F[i] + at.F_S[i] * step;
      modelled.S_w[k] = 1 / at.w_S[i];
      modelled.S_q[k] = -at.w_q[i] / at.w_S[i];
      modelled.F_w[k] = at.F_S[i] / at.w_S[i];
      modelled.F_q[k] = at.F_q[i] - at.F_S[i] * at.w_q[i] / at.w_S[i];
      if (std::isfinite(step)) S[i] = std::max(S[i] + std::clamp(step, -farthest, farthest), least);
    }
  }
  return modelled;
}

std::vector<char> stuck_rows(const PassRows& rows, const PassStates& read, double compliance, double force_noise) {
  std::vector<char> stuck(rows.size(), 0);
  std::size_t last = 0;
  for (std::size_t first = 0; first < rows.size(); first = last) {
    last = first + 1;
    while (last < rows.size() && rows.pass[last] == rows.pass[first]) ++last;
    if (first == 0) continue;  // no turn before the first pass
    const std::size_t slides = slides_from(rows, read, first, last, compliance, force_noise);
    for (std::size_t i = first; i < slides; ++i) stuck[i] = 1;
  }
  return stuck;
}

}  // namespace flexslip
