#include "fibre/batch_inverse.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>

#include "fibre/batch.h"
#include "fibre/elastica.h"
#include "fibre/state_table.h"

namespace flexslip {
namespace {

// A step of Newton's iteration in q and σ = √(S - 1), in which w is nearly linear.
struct Step {
  double sigma, q;
};

Step newton_step(double S, double dw, double dF, const SlopeArrays& at, std::size_t i) {
  const double S_sigma = 2 * std::sqrt(S - 1);
  const double w_sigma = S_sigma * at.w_S[i];
  const double F_sigma = S_sigma * at.F_S[i];
  const double determinant = w_sigma * at.F_q[i] - F_sigma * at.w_q[i];
  return {(dw * at.F_q[i] - dF * at.w_q[i]) / determinant, (w_sigma * dF - F_sigma * dw) / determinant};
}

void require_forces(std::span<const double> w, std::span<const double> F) {
  if (w.size() != F.size())
    throw std::invalid_argument("there are " + std::to_string(w.size()) + " deflections, but " +
                                std::to_string(F.size()) + " forces");
}

// The results from the table, and which points need the scalar inverse.
struct TableInverse {
  InverseArrays states;
  std::vector<bool> exact;
};

TableInverse solve_on_table(std::span<const double> w, std::span<const double> F) {
  require_forces(w, F);
  const std::size_t n = w.size();
  TableInverse result{{std::vector<double>(n), std::vector<double>(n)}, std::vector<bool>(n)};
  const auto solve_alone = [&](std::size_t i) {
    try {
      const FibreState state = fibre_state_from_force(w[i], F[i]);
      result.states.S[i] = state.S;
      result.states.q[i] = state.q;
      result.exact[i] = true;
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("state " + std::to_string(i) + ": " + error.what());
    }
  };
  std::vector<std::size_t> active(n);
  std::iota(active.begin(), active.end(), 0);
  std::vector<double> S(n);
  std::vector<double> q(n);
  for (std::size_t i = 0; i < n; ++i) {
    // S - 1 = 2.4 w^2 and F = 48 w (1 + 2.1 q w - 7 w^2), a fit up to w = 0.3
    S[i] = 1 + 2.4 * w[i] * w[i];
    q[i] = std::clamp((F[i] / (48 * w[i]) - 1 + 7 * w[i] * w[i]) / (2.1 * w[i]), -1.0, 2.0);
  }
  // A step below `small` leaves an error of the order of its square. States within the table need
  // at most 6 steps; 12 is the limit.
  constexpr double small = 1e-7;
  constexpr double min_S = 1 + 1e-12;  // below, S has too few digits for the iteration
  constexpr double max_S = 1 + table_sigma * table_sigma;
  for (int iteration = 0; iteration < 12 && !active.empty(); ++iteration) {
    std::erase_if(active, [&](std::size_t i) {
      const bool inside = S[i] > min_S && S[i] < max_S && q[i] > table_q.least && q[i] < table_q.greatest;
      if (!inside) solve_alone(i);
      return !inside;
    });
    std::vector<double> S_now, q_now;
    S_now.reserve(active.size());
    q_now.reserve(active.size());
    for (const std::size_t i : active) {
      S_now.push_back(S[i]);
      q_now.push_back(q[i]);
    }
    const SlopeArrays at = tabulated_states_slopes({S_now, q_now});
    std::size_t left = 0;
    for (std::size_t j = 0; j < active.size(); ++j) {
      const std::size_t i = active[j];
      const Step step = newton_step(S[i], w[i] - at.w[j], F[i] - at.F[j], at, j);
      const double sigma = std::sqrt(S[i] - 1);
      S[i] = 1 + (sigma + step.sigma) * (sigma + step.sigma);
      q[i] += step.q;
      if (std::abs(step.sigma) < small * sigma && std::abs(step.q) < small) {
        result.states.S[i] = S[i];
        result.states.q[i] = q[i];
      } else {
        active[left++] = i;
      }
    }
    active.resize(left);
  }
  for (const std::size_t i : active) solve_alone(i);
  return result;
}

}  // namespace

InverseArrays tabulated_states_from_forces(std::span<const double> w, std::span<const double> F) {
  return solve_on_table(w, F).states;
}

InverseArrays fibre_states_from_forces(std::span<const double> w, std::span<const double> F) {
  auto [inverse, exact] = solve_on_table(w, F);
  std::vector<std::size_t> rest;
  std::vector<double> S, q;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (exact[i]) continue;
    rest.push_back(i);
    S.push_back(inverse.S[i]);
    q.push_back(inverse.q[i]);
  }
  const SlopeArrays at = fibre_states_slopes({S, q});
  for (std::size_t j = 0; j < rest.size(); ++j) {
    const std::size_t i = rest[j];
    const Step step = newton_step(S[j], w[i] - at.w[j], F[i] - at.F[j], at, j);
    inverse.S[i] += step.sigma * (2 * std::sqrt(S[j] - 1) + step.sigma);
    inverse.q[i] += step.q;
  }
  return inverse;
}

}  // namespace flexslip
